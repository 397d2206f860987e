# SPDX-License-Identifier: GPL-3.0-or-later
"""What the user reads: messages in the user's language, lengths, areas and volumes, which are in mm elsewhere, in the units chosen in FreeCAD, and numbers
with its decimal sign."""

import re

import FreeCAD

from . import messages

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
# FreeCAD's numbers of the unit schemes with mm; in them a message stays as it is.
_IN_MM = (0, 6, 8)
_NUMBER = r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?"
# "2.5 mm", "40 x 10 x 10 mm", "80 -> 90 mm^3" and "(1, 2, 3) mm"; not the 2 of "Edge2 mm" nor of "1.2.3".
_QUANTITY = re.compile(r"(?<![\w.])(?P<numbers>(?:{0}(?: x | -> | → ))*{0}|\({0}(?:, {0})*\)) (?P<unit>mm(?:\^[23])?)(?![\w^])".format(_NUMBER))
_DECIMAL = re.compile(r"(\d)\.(\d)")
_ALSO_SAID = (QT_TRANSLATE_NOOP("FeatureMesh", "%s and %d more"), QT_TRANSLATE_NOOP("FeatureMesh", "the inside"))   # by messages.py


def in_words(message):
    """A message, or a text of our own, in the user's language and units."""
    return _WORDS.put(message)


def in_users_units(text):
    """The same text with its lengths, areas and volumes (mm, mm^2, mm^3) in the user's units."""
    return text if FreeCAD.Units.getSchema() in _IN_MM else _QUANTITY.sub(_converted, text)


def as_shown(numbers):
    """A text of numbers, such as "0.25", with the decimal sign that FreeCAD shows."""
    return _DECIMAL.sub(r"\1,\2", numbers) if "," in FreeCAD.Units.Quantity("0.5 mm").UserString else numbers


def _converted(found):
    def shown(number):
        return FreeCAD.Units.Quantity("%s %s" % (number.group(), found.group("unit"))).UserString
    return re.sub(_NUMBER, shown, found.group("numbers"))


_WORDS = messages.Words(lambda words: FreeCAD.Qt.translate("FeatureMesh", words), in_users_units, as_shown)

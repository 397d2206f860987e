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
_READABLE = {'"': "in", "'": "ft"}   # beside the quotes of names and the signs of points
_DECIMAL = re.compile(r"(\d)\.(\d)")
_ALSO_SAID = (QT_TRANSLATE_NOOP("FeatureMesh", "%s and %d more"), QT_TRANSLATE_NOOP("FeatureMesh", "the inside"))   # by messages.py


def in_words(message):
    """A message, or a text of our own, in the user's language and units."""
    return _WORDS.put(message)


def as_sentence(message):
    """The same where it stands by itself, beginning with a capital."""
    return _WORDS.sentence(message)


def in_users_units(text):
    """The same text with its lengths, areas and volumes (mm, mm^2, mm^3) in the user's units."""
    return text if are_lengths_in_mm() else _QUANTITY.sub(_converted, text)


def are_lengths_in_mm():
    """Does the user see lengths in mm?"""
    return FreeCAD.Units.getSchema() in _IN_MM


def as_shown(numbers):
    """A text of numbers, such as "0.25", with the decimal sign that FreeCAD shows."""
    return _DECIMAL.sub(r"\1,\2", numbers) if "," in FreeCAD.Units.Quantity("0.5 mm").UserString else numbers


def figure(value, digits):
    """The same as messages.figure, with the decimal sign that FreeCAD shows."""
    return as_shown(messages.figure(value, digits))


def unit_of(unit):
    """(how many of `unit` is one of the user's, what that is called)."""
    one = FreeCAD.Units.Quantity("1 " + unit)
    _, factor, name = one.getUserPreferred()
    if are_lengths_in_mm() or "*" in name:   # a unit that nobody reads, such as kg/(mm*s^2)
        return 1.0, unit
    return factor / one.Value, name


def _converted(found):
    """Numbers that belong together, such as a point's, get one unit: that of the largest, where FreeCAD would take inches for one and feet for another."""
    def quantity(number):
        return FreeCAD.Units.Quantity("%s %s" % (number, found.group("unit")))
    _, factor, name = max(map(quantity, re.findall(_NUMBER, found.group("numbers"))), key=lambda each: abs(each.Value)).getUserPreferred()
    # FreeCAD itself would show 0.04 mm as 0.00 in.
    return re.sub(_NUMBER, lambda number: "%.5g %s" % (quantity(number.group()).Value / factor, _READABLE.get(name, name)), found.group("numbers"))


_WORDS = messages.Words(lambda words: FreeCAD.Qt.translate("FeatureMesh", words), in_users_units, as_shown)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Lengths, areas and volumes as the user reads them: messages say mm, and where another unit scheme is chosen in FreeCAD they are put into its units."""

import re

import FreeCAD

# FreeCAD's numbers of the unit schemes with mm; in them a message stays as it is.
_IN_MM = (0, 6, 8)
_NUMBER = r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?"
# "2.5 mm", "40 x 10 x 10 mm", "80 -> 90 mm^3" and "(1, 2, 3) mm"; not the 2 of "Edge2 mm" nor of "1.2.3".
_QUANTITY = re.compile(r"(?<![\w.])(?P<numbers>(?:{0}(?: x | -> | → ))*{0}|\({0}(?:, {0})*\)) (?P<unit>mm(?:\^[23])?)(?![\w^])".format(_NUMBER))


def in_users_units(text):
    """The same text with its lengths, areas and volumes (mm, mm^2, mm^3) in the user's units."""
    return text if FreeCAD.Units.getSchema() in _IN_MM else _QUANTITY.sub(_converted, text)


def _converted(found):
    def shown(number):
        return FreeCAD.Units.Quantity("%s %s" % (number.group(), found.group("unit"))).UserString
    return re.sub(_NUMBER, shown, found.group("numbers"))

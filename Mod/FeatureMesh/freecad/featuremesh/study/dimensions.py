# SPDX-License-Identifier: GPL-3.0-or-later
"""The dimensions of a part that a study can vary: of its sketches, of its features, of spreadsheets that drive them."""

from dataclasses import dataclass

from .. import edits, reading
from ..errors import UserError
from ..properties import DIMENSIONS

_KINDS = ("App::PropertyLength", "App::PropertyDistance", "App::PropertyAngle", "App::PropertyQuantityConstraint", "App::PropertyIntegerConstraint")
_SHARE = 0.1   # of a dimension, by which it is varied where the user says nothing
_ALL_ROUND = 360.0   # degrees


@dataclass
class Dimension:
    """One number that the user gave the part."""
    owner: object    # the sketch, feature or sheet
    name: str        # its own name there
    value: float     # mm or degrees, as the part is
    unit: str        # mm, deg or nothing

    @property
    def target(self):
        """As `--set` and `--vary` take it."""
        return "%s.%s" % (self.owner.Name, self.name)

    def usual_range(self):
        """(lowest, highest) that are proposed: a tenth up and down, of a number of things one, and of an angle no more than all round."""
        if isinstance(self.value, int):
            return max(1, self.value - 1), self.value + 1
        low, high = sorted(float("%.3g" % (self.value * factor)) for factor in (1 - _SHARE, 1 + _SHARE))
        return low, min(high, _ALL_ROUND) if self.unit == "deg" and low < _ALL_ROUND else high


def of_part(part):
    """Every Dimension of the part that is in its document, in the order in which it is built."""
    found, seen = [], set()
    for obj in reading.dependencies(part):
        for owner in (obj, *_sketches_and_sheets(obj)):
            if owner.Document is part.Document and owner.Name not in seen:
                seen.add(owner.Name)
                found += of_object(owner)
    return found


def of_object(obj):
    """Those of one sketch, feature or sheet: what can be set, and is no nought."""
    if obj.TypeId == "Spreadsheet::Sheet":
        names, unit = edits.aliases_of(obj), _unit_of_cell
    elif obj.isDerivedFrom("Sketcher::SketchObject"):
        names, unit = _constraints(obj), _unit_of_constraint
    else:
        names, unit = _properties(obj), _unit_of_property
    made = []
    for name in names:
        try:
            value = edits.value_to_vary(obj.Document, "%s.%s" % (obj.Name, name))
        except UserError:
            continue   # an expression drives it, or it is no number
        if type(value) is int and not edits.is_whole_number(obj.Document, "%s.%s" % (obj.Name, name)):
            value = float(value)   # FreeCAD takes "5" in a cell for one
        if isinstance(value, (int, float)) and not isinstance(value, bool) and value:
            made.append(Dimension(obj, name, value, unit(obj, name)))
    return made


def _sketches_and_sheets(obj):
    return [other for other in obj.OutList if other.TypeId == "Spreadsheet::Sheet" or other.isDerivedFrom("Sketcher::SketchObject")]


def _constraints(sketch):
    return [constraint.Name or "Constraint%d" % number for number, constraint in enumerate(sketch.Constraints, 1)
            if constraint.Type in DIMENSIONS and constraint.Driving]


def _properties(obj):
    """Those that the property view shows and that may be changed there."""
    return [name for name in obj.PropertiesList if obj.getTypeIdOfProperty(name) in _KINDS and not obj.getEditorMode(name)
            and not {"Hidden", "ReadOnly"} & set(obj.getPropertyStatus(name)) and name != "Refine"]


def _unit_of_cell(sheet, name):
    return _unit_of(sheet.get(name))


def _unit_of_constraint(sketch, name):
    constraint = next(entry for number, entry in enumerate(sketch.Constraints, 1) if name in (entry.Name, "Constraint%d" % number))
    return "deg" if constraint.Type == "Angle" else "mm"


def _unit_of_property(obj, name):
    return _unit_of(getattr(obj, name))


def _unit_of(value):
    unit = getattr(value, "Unit", None)
    return {"Length": "mm", "Angle": "deg"}.get(unit.Type, "") if unit is not None else ""

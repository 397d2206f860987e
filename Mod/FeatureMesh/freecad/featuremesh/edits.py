# SPDX-License-Identifier: GPL-3.0-or-later
"""Sets parameters of a document as a user writes them: OBJECT.PROPERTY=VALUE."""

import math
import re
import string
from typing import Callable, NamedTuple

import FreeCAD

from .errors import UserError
from .messages import close_names, of_error, said
from .properties import DIMENSIONS
from .reading import describe, find_object

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
_NO_PROPERTY = QT_TRANSLATE_NOOP("FeatureMesh", "{object:text} has no property {name:text}{near:messages}")
_NO_CONSTRAINT = QT_TRANSLATE_NOOP("FeatureMesh", "{object:text} has no constraint or property {name:text}{near:messages}")
_NO_CELL = QT_TRANSLATE_NOOP("FeatureMesh", "{object:text} has no alias or cell {name:text}{near:messages}")   # of a spreadsheet
_WOULD_TAKE = QT_TRANSLATE_NOOP("FeatureMesh", "FreeCAD refuses {value:text} for {object:text}.{name:text} (it would take {taken:text})")
_WHOLE = ("App::PropertyInteger", "App::PropertyIntegerConstraint")
_CAPITALS, _DIGITS = string.ascii_uppercase, string.digits
_CONSTRAINTS = "Constraints"   # of a sketch, as expressions name them
_TRUE, _FALSE = ("true", "yes", "on", "1"), ("false", "no", "off", "0")


def set_parameter(document, assignment):
    """Applies one edit; does not recompute. Throws UserError: unknown object or property, a value FreeCAD refuses.

    Besides properties (with parts, `Box.Placement.Base.x`): `Sketch.CONSTRAINTNAME` (or `Sketch.Constraint3`) and
    `Spreadsheet.ALIAS`. Lengths are mm and angles degrees unless the value has a unit.
    """
    target, value = _read(document, assignment)
    kind, obj, path = _found(document, target)
    was_touched = "Touched" in obj.State
    try:
        kind.set(obj, path, value)
    except UserError:
        if not was_touched:
            obj.purgeTouched()   # for FreeCAD it is edited, and a sketch of an older one may not be computed any more
        raise


def value_before(document, assignment):
    """The assignment that brings back what this one is going to change. Throws UserError as set_parameter does."""
    target, _ = _read(document, assignment)
    return "%s=%s" % (target, parameter_value(document, target))


def parameter_value(document, target, unit=""):
    """What a parameter is now: a switch, a word, or a number in that unit, without one in mm or degrees where it is a length or an angle.
    Throws UserError as set_parameter does.
    """
    kind, obj, path = _found(document, target)
    value = kind.value(obj, path)
    if not unit or isinstance(value, (bool, str)):
        return value
    return value / _quantity_of_one(unit, target)


def value_to_vary(document, target, unit=""):
    """The same as parameter_value. Throws UserError for what an expression drives, too."""
    value = parameter_value(document, target, unit)
    kind, obj, path = _found(document, target)
    kind.refuse_fixed(obj, path)
    return value


def is_whole_number(document, target):
    """Has the parameter to be a whole number? That is known of a property; a cell of a spreadsheet is one where it drives such a property."""
    kind, sheet, path = _found(document, target)
    if kind is not _CELL:
        return type(kind.value(sheet, path)) is int
    cell = re.compile(r"(?<!\w)%s(?!\w)" % re.escape(path))
    return any(cell.search(expression) and obj.getTypeIdOfProperty(re.split(r"[.\[]", bound.lstrip("."))[0]) in _WHOLE
               for obj in sheet.InList for bound, expression in obj.ExpressionEngine)


def _quantity_of_one(unit, where):
    """One of a unit in FreeCAD's own: 10 of a cm."""
    if not _is_quantity("1 " + unit):
        raise UserError(said("{value:text} is no unit for {target:text}", value=unit, target=where))
    return FreeCAD.Units.Quantity("1 " + unit).Value


def _read(document, assignment):
    """(target, value) of OBJECT.PROPERTY=VALUE. Throws UserError."""
    owner, rest = _parted(document, assignment.strip())
    path, _, value = (text.strip() for text in rest.partition("="))
    if not (owner and path and value):
        raise UserError(said("cannot read the edit '{edit:text}', it has to be OBJECT.PROPERTY=VALUE", edit=assignment))
    return "%s.%s" % (owner, path), value


def _parted(document, text):
    """(OBJECT, the rest) of OBJECT.PROPERTY and what follows; a label may have points and equals signs of its own."""
    ends = [at for at, letter in enumerate(text) if letter == "."]
    known = [end for end in ends if document.getObject(text[:end]) or document.getObjectsByLabel(text[:end])]
    owner = text[:max(known)] if known else text.partition(".")[0]
    return owner, text[len(owner) + 1:]


def _found(document, target):
    """(the _Kind, the object, the rest) of a target such as HoleSketch.Radius. Throws UserError."""
    name, path = _parted(document, target)
    obj, first = find_object(document, name), path.partition(".")[0]
    if obj.TypeId == "Spreadsheet::Sheet":
        return _CELL, obj, path
    if obj.isDerivedFrom("Sketcher::SketchObject") and (first == _CONSTRAINTS or first not in obj.PropertiesList):
        return _CONSTRAINT, obj, path
    if first not in obj.PropertiesList:
        raise _unknown(obj, first, obj.PropertiesList)
    return _PROPERTY, obj, path


def _property(obj, path):
    """(name, rest) of a path; what a placement is turned by is below its Rotation."""
    name, _, rest = path.partition(".")
    if isinstance(getattr(obj, name), FreeCAD.Placement) and rest.startswith(("Angle", "Axis")):
        rest = "Rotation." + rest
    return name, rest


def _value_of_property(obj, path):
    name, rest = _property(obj, path)
    value = getattr(obj, name)
    for step in rest.split(".") if rest else ():
        if not hasattr(value, step):
            raise _unknown(obj, "%s.%s" % (name, rest), obj.PropertiesList)
        value = getattr(value, step)
    if rest.endswith("Angle"):
        return math.degrees(value)
    value = getattr(value, "Value", value)
    if not isinstance(value, (bool, int, float, str)):
        raise UserError(said("{object:text}.{name:text} is no number, switch or choice", object=describe(obj), name=name))
    return value


def _set_property(obj, path, text):
    name, rest = _property(obj, path)
    _refuse_expression(obj, path)
    if obj.getEditorMode(name) and "ReadOnly" in obj.getEditorMode(name):
        raise UserError(said("{object:text}.{name:text} is read-only", object=describe(obj), name=name))
    old = getattr(obj, name)
    if rest:
        new = _with_part(obj, name, old, rest, text)
    else:
        new = _parse_like(obj, name, old, text)
    try:
        setattr(obj, name, new)
    except Exception as error:
        raise UserError(said("FreeCAD refuses {value:text} for {object:text}.{name:text}: {why:messages}",
                             value=text, object=describe(obj), name=name, why=of_error(error))) from error
    if not rest and not _same(getattr(obj, name), new):
        got = getattr(obj, name)
        setattr(obj, name, old)
        raise UserError(said(_WOULD_TAKE, value=text, object=describe(obj), name=name, taken=str(got)))
    if name == "Placement" and obj.isDerivedFrom("PartDesign::Feature"):
        obj.touch()  # by its placement alone FreeCAD 0.20 moves the whole body's shape and does not compute the feature


def _with_part(obj, name, old, path, text):
    """A copy of a placement or vector with one number changed: Base.x, Rotation.Angle (degrees), Axis.z, x."""
    where = "%s.%s.%s" % (describe(obj), name, path)
    if isinstance(old, FreeCAD.Vector) and path in ("x", "y", "z"):
        new = FreeCAD.Vector(old)
        setattr(new, path, _number(text, "mm", where))
        return new
    if isinstance(old, FreeCAD.Placement):
        new = FreeCAD.Placement(old)
        parts = path.split(".")
        if parts[0] == "Base" and len(parts) == 2 and parts[1] in ("x", "y", "z"):
            base = FreeCAD.Vector(new.Base)
            setattr(base, parts[1], _number(text, "mm", where))
            new.Base = base
            return new
        if parts == ["Rotation", "Angle"]:
            new.Rotation = FreeCAD.Rotation(new.Rotation.Axis, _number(text, "deg", where))
            return new
        if parts[:2] == ["Rotation", "Axis"] and parts[2:] in (["x"], ["y"], ["z"]):
            axis = FreeCAD.Vector(new.Rotation.Axis)
            setattr(axis, parts[-1], _number(text, "", where))
            if not axis.Length:   # of no length; FreeCAD would take another one, and no angle
                raise UserError(said(_WOULD_TAKE, value=text, object=describe(obj), name="%s.%s" % (name, path), taken=str(getattr(new.Rotation.Axis, parts[-1]))))
            angle = FreeCAD.Units.Quantity(new.Rotation.Angle, "rad").getValueAs("deg")
            new.Rotation = FreeCAD.Rotation(axis, float(angle))
            return new
    raise UserError(said("cannot set {target:text}; of placements it can be Base.x, Base.y, Base.z, Rotation.Angle, Rotation.Axis.x and so on, of vectors "
                         "x, y and z",
                         target=where))


def _parse_like(obj, name, old, text):
    """The value that `text` means for a property that holds `old`."""
    where = "%s.%s" % (describe(obj), name)
    kind = obj.getTypeIdOfProperty(name)
    if isinstance(old, bool):
        return _bool(text, where)
    if kind == "App::PropertyEnumeration":
        known = obj.getEnumerationsOfProperty(name)
        if text not in known:
            raise UserError(said("{target:text} cannot be {value:text}, only one of: {known:text}", target=where, value=text, known=", ".join(known)))
        return text
    if isinstance(old, int):
        number = _number(text, "", where)
        if number != int(number):
            raise UserError(said("{target:text} has to be a whole number, not {value:text}", target=where, value=text))
        return int(number)
    if isinstance(old, float):
        return _number(text, "", where)
    if isinstance(old, FreeCAD.Units.Quantity):
        return _quantity(text, old.Unit, where)
    raise UserError(said("{target:text} is no number, switch or choice ({kind:text}), it cannot be set this way", target=where, kind=kind))


def _set_constraint(sketch, name, text):
    index = _constraint_index(sketch, name)
    constraint = sketch.Constraints[index]
    where = "%s.%s" % (describe(sketch), name)
    if not constraint.Driving:
        raise UserError(said("{target:text} is a reference dimension, it only measures", target=where))
    _refuse_driven(sketch, name)
    unit = "deg" if constraint.Type == "Angle" else "mm"
    quantity = FreeCAD.Units.Quantity("%.17g %s" % (_number(text, unit, where), unit))
    try:
        sketch.setDatum(index, quantity)
    except Exception as error:
        raise UserError(said("FreeCAD refuses {value:text} for {target:text}: {why:messages}", value=text, target=where, why=of_error(error))) from error


def _value_of_constraint(sketch, name):
    constraint = sketch.Constraints[_constraint_index(sketch, name)]
    return math.degrees(constraint.Value) if constraint.Type == "Angle" else constraint.Value


def _refuse_driven(sketch, name):
    index = _constraint_index(sketch, name)
    for path, expression in sketch.ExpressionEngine:
        if path.lstrip(".") in ("Constraints.%s" % sketch.Constraints[index].Name, "Constraints[%d]" % index):
            raise _driven(sketch, name, expression)


def _constraint_index(sketch, name):
    dimensions = {}
    for index, constraint in enumerate(sketch.Constraints):
        if constraint.Type in DIMENSIONS:
            dimensions[constraint.Name or "Constraint%d" % (index + 1)] = index
            dimensions["Constraint%d" % (index + 1)] = index
    name = name.removeprefix(_CONSTRAINTS + ".")
    if name not in dimensions:
        raise _unknown(sketch, name, dimensions, _NO_CONSTRAINT)
    return dimensions[name]


def _value_of_cell(sheet, name):
    cell = _cell_of(sheet, name)
    value = sheet.get(cell) if sheet.getContents(cell) else 0.0
    return getattr(value, "Value", value)


def _set_cell(sheet, name, text):
    cell = _cell_of(sheet, name)
    _refuse_computed(sheet, name)
    sheet.set(cell, _content_like(sheet, cell, text.lstrip("="), "%s.%s" % (describe(sheet), name)))


def _content_like(sheet, cell, text, where):
    """What to write into a cell so that it has this value, and its unit as before: else what is computed of it, such as `width + 5 mm`, is wrong."""
    content = sheet.getContents(cell)
    had = sheet.get(cell) if content else 0.0
    value = _quantity(text, getattr(had, "Unit", None) or FreeCAD.Units.Unit(), where, or_any=not hasattr(had, "Unit"))
    amount, unit = value.Value, str(value).partition(" ")[2]
    if not unit:
        return text if _is_plain(text) else repr(amount)
    if not unit.isalpha():   # a cell cannot read mm*kg/s^2
        _, factor, unit = value.getUserPreferred()
        amount /= factor
    return "=%r %s" % (amount, unit)


def aliases_of(sheet):
    """The names that a spreadsheet's cells have, row by row."""
    cells = [name for name in sheet.PropertiesList if _is_cell(name) and sheet.getAlias(name)]
    return [sheet.getAlias(cell) for cell in sorted(cells, key=lambda cell: (int(cell.lstrip(_CAPITALS)), len(cell.rstrip(_DIGITS)), cell))]


def _cell_of(sheet, name):
    """The cell of that alias or address. Throws UserError."""
    cell = sheet.getCellFromAlias(name) or (name if name in sheet.PropertiesList and _is_cell(name) else None)
    if cell is None:
        raise _unknown(sheet, name, aliases_of(sheet), _NO_CELL)
    return cell


def _is_cell(name):
    return name[:1] in _CAPITALS and name.lstrip(_CAPITALS).isdigit()


def _refuse_computed(sheet, name):
    content = sheet.getContents(_cell_of(sheet, name))
    if content.startswith("=") and any(letter.isalpha() for letter in content[1:]) and not _is_quantity(content[1:]):
        raise UserError(said("{object:text}.{name:text} is computed ({content:text}), change what it depends on",
                             object=describe(sheet), name=name, content=content))


def _refuse_expression(obj, path):
    path = ".".join(filter(None, _property(obj, path)))
    for bound, expression in obj.ExpressionEngine:
        bound = bound.lstrip(".")
        if bound == path or path.startswith(bound + ".") or bound.startswith(path + ".") and bound != path + ".Enum":   # that: the list of a configuration table
            raise _driven(obj, path, expression)


def _unknown(obj, name, known, words=_NO_PROPERTY):
    return UserError(said(words, object=describe(obj), name=name, near=close_names(name, list(known))))


def _no_number(text, where):
    return UserError(said("{value:text} is no number for {target:text}", value=text, target=where))


def _driven(obj, name, expression):
    return UserError(said("{object:text}.{name:text} is driven by the expression {expression:text}, change that instead",
                          object=describe(obj), name=name, expression=expression))


def _bool(text, where):
    if text.lower() in _TRUE:
        return True
    if text.lower() in _FALSE:
        return False
    raise UserError(said("{target:text} is a switch, it can be true or false, not {value:text}", target=where, value=text))


def _number(text, unit, where):
    """A plain number, or a quantity with a unit turned into mm or degrees."""
    try:
        number = float(text)
    except ValueError:
        number = None
    if number is not None and math.isfinite(number):
        return number
    wanted = {"mm": FreeCAD.Units.Length, "deg": FreeCAD.Units.Angle}.get(unit)
    if wanted is not None and number is None and _is_quantity(text):
        return float(_quantity(text, wanted, where).Value)
    raise _no_number(text, where)


def _is_plain(text):
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


def _quantity(text, unit, where, or_any=False):
    """Of that unit, without one or, where that may be, of any unit."""
    if not _is_quantity(text):
        raise _no_number(text, where)
    quantity = FreeCAD.Units.Quantity(text)
    if quantity.Unit == FreeCAD.Units.Unit():
        return FreeCAD.Units.Quantity(quantity.Value, unit)
    if quantity.Unit != unit and not or_any:
        raise UserError(said("{value:text} has the wrong unit for {target:text}", value=text, target=where))
    return quantity


def _is_quantity(text):
    try:
        return math.isfinite(FreeCAD.Units.Quantity(text).Value)
    except (ValueError, ArithmeticError):
        return False


def _same(got, wanted):
    got, wanted = getattr(got, "Value", got), getattr(wanted, "Value", wanted)
    if isinstance(wanted, float):
        return abs(got - wanted) <= 1e-9 * max(1.0, abs(wanted))
    return got == wanted


class _Kind(NamedTuple):
    """What can be done with a parameter of one kind."""
    set: Callable            # (object, path, text)
    value: Callable          # (object, path)
    refuse_fixed: Callable   # the same; throws UserError for what an expression drives


_CELL = _Kind(_set_cell, _value_of_cell, _refuse_computed)
_CONSTRAINT = _Kind(_set_constraint, _value_of_constraint, _refuse_driven)
_PROPERTY = _Kind(_set_property, _value_of_property, _refuse_expression)

# SPDX-License-Identifier: GPL-3.0-or-later
"""What the properties of an object say: its links, numbers and texts.

FreeCAD looks for an attribute of an object in a dozen places, which takes ten times as long as the property does. A
reading asks for some twenty of every object, so here properties, and what classes tell, are asked for at once.
"""

import functools
import math

import FreeCAD

property_of = FreeCAD.DocumentObject.getPropertyByName  # (object, name)
name_of = FreeCAD.DocumentObject.Name.__get__
type_of = FreeCAD.DocumentObject.TypeId.__get__
state_of = FreeCAD.DocumentObject.State.__get__
document_of = FreeCAD.DocumentObject.Document.__get__
objects_out_of = FreeCAD.DocumentObject.OutList.__get__
_names_of_properties = FreeCAD.DocumentObject.PropertiesList.__get__
_matrix_of = FreeCAD.Placement.toMatrix
_entries_of = FreeCAD.Matrix.A.__get__
_base_of = FreeCAD.Placement.Base.__get__
_rotation_of = FreeCAD.Placement.Rotation.__get__
_axis_of = FreeCAD.Rotation.Axis.__get__
_angle_of = FreeCAD.Rotation.Angle.__get__

_IDENTITY = _entries_of(_matrix_of(FreeCAD.Placement()))

# Types of sketch constraints that have a value.
DIMENSIONS = ("Distance", "DistanceX", "DistanceY", "Radius", "Diameter", "Angle", "Weight", "SnellsLaw")
_WITHOUT_UNIT = ("Weight", "SnellsLaw")
_SKIPPED_LINKS = ("_Body", "Origin", "ExpressionEngine", "Proxy", "_ChildCache", "_CopyOnChangeControl")
_SKIPPED_PARAMETERS = ("Visibility", "Label2", "Placement")
# Status of a property that one object has and others of its type may not.
_DYNAMIC = frozenset((21, "PropDynamic"))
_VECTOR_TYPES = ("App::PropertyVector", "App::PropertyDirection")
_POSITION_TYPES = ("App::PropertyVectorDistance", "App::PropertyPosition")
_NUMBER_TYPES = ("App::PropertyFloat", "App::PropertyInteger", "App::PropertyQuantity", "App::PropertyLength",
                 "App::PropertyDistance", "App::PropertyAngle", "App::PropertyArea", "App::PropertyVolume",
                 "App::PropertyPrecision", "App::PropertyPercent", "App::PropertyBool", "App::PropertySpeed",
                 "Spreadsheet::PropertySpreadsheetQuantity")
_NUMBERS = (float, int, FreeCAD.Units.Quantity)
_MEASURES = {"Length": "length", "Angle": "angle"}   # by what FreeCAD calls a unit


class Properties:
    """What the properties are read for that objects of one type with one list of them have."""

    def __init__(self, kind, uses):
        """`kind` is the type of the objects, `uses` the use by name of every property that says something, in the order of the list."""
        self.kind = kind
        # A link also has the properties of what it shows, and an object written in Python whatever it likes.
        self._may_have_others = kind.startswith("App::Link") or kind.endswith("Python")
        self._names = frozenset(uses)
        self._links = [name for name, use in uses.items() if use == "link" and name not in _SKIPPED_LINKS]
        said = {name: use for name, use in uses.items() if name not in _SKIPPED_PARAMETERS and not name.startswith("_")}
        self._numbers = [name for name, use in said.items() if use == "number"]
        self._texts = [name for name, use in said.items() if use == "text"]
        self._others = [(name, _ADD[use]) for name, use in said.items() if use in _ADD]

    def value(self, obj, name):
        """The property, None without it: to look for what is not there costs as much as to read it."""
        if name in self._names:
            return property_of(obj, name)
        return getattr(obj, name, None) if self._may_have_others else None

    def proxy_name(self, obj):
        """Name of the class of an object that is written in Python, else ""."""
        proxy = self.value(obj, "Proxy")
        return "" if proxy is None or isinstance(proxy, (str, int)) else type(proxy).__name__

    def links(self, obj):
        """(property, object, sub-element) of every visible link, in the order of the list."""
        return [(name, target, sub) for name in self._links for target, sub in _link_targets(property_of(obj, name))]

    def parameters(self, obj):
        """Numeric and boolean parameters (mm, degrees), enumerations, and which of the numbers are a "length" or an "angle", three dicts."""
        numbers, texts, measures = {}, {}, {}
        is_sheet = self.kind == "Spreadsheet::Sheet"
        for name in self._numbers:
            value = property_of(obj, name)
            if isinstance(value, _NUMBERS):
                key = (obj.getAlias(name) or name) if is_sheet else name
                numbers[key] = float(value)
                if isinstance(value, FreeCAD.Units.Quantity) and (measure := _MEASURES.get(value.Unit.Type)):
                    measures[key] = measure
        for name in self._texts:
            texts[name] = str(property_of(obj, name))
        for name, add in self._others:
            add(numbers, measures, name, property_of(obj, name))
        return numbers, texts, measures


# What properties are read for, by type of object and name: those that all objects of the type have. Those of a single
# object cannot have the name of one of them.
_USES = {}
# By type of object and names of its properties, when all objects of the type have these.
_PROPERTIES = {}


def properties_of(obj, kind):
    """What the properties of `obj`, of the type `kind`, are read for."""
    key = (kind, *_names_of_properties(obj))
    properties = _PROPERTIES.get(key)
    if properties is None:
        known = _USES.setdefault(kind, {})
        uses = {name: known.get(name) or _find_use(obj, name, known) for name in key[1:]}
        properties = Properties(kind, {name: use for name, use in uses.items() if use != "nothing"})
        if all(name in known for name in uses):
            _PROPERTIES[key] = properties
    return properties


def _find_use(obj, name, known):
    use = _use_of(obj.getTypeIdOfProperty(name))
    if not _DYNAMIC.intersection(obj.getPropertyStatus(name)):
        known[name] = use
    return use


@functools.lru_cache(maxsize=None)
def _use_of(kind):
    """What a property of that type is read for."""
    if "Link" in kind:
        return "nothing" if "Hidden" in kind else "link"
    if kind in ("App::PropertyPythonObject", "Part::PropertyPartShape"):
        return "elsewhere"
    if kind == "App::PropertyEnumeration":
        return "text"
    if kind.endswith("List"):
        return {"Sketcher::PropertyConstraintList": "constraints", "App::PropertyFloatList": "spacings"}.get(kind, "nothing")
    if kind.startswith(_NUMBER_TYPES):
        return "number"
    if kind in _VECTOR_TYPES:
        return "vector"
    if kind in _POSITION_TYPES:
        return "position"
    return {"App::PropertyPlacement": "placement", "Part::PropertyFilletEdges": "fillets"}.get(kind, "nothing")


def property_if_any(obj, name):
    try:
        return property_of(obj, name)
    except AttributeError:
        return None


def matrix_entries(placement):
    """The sixteen numbers of its matrix, row by row."""
    return list(_IDENTITY if placement.isIdentity() else _entries_of(_matrix_of(placement)))


def _link_targets(value):
    """Flattens what a link property holds: an object, (object, subs), or a list of either."""
    if value is None:
        return
    if isinstance(value, FreeCAD.DocumentObject):
        yield value, ""
    elif isinstance(value, tuple) and value and isinstance(value[0], FreeCAD.DocumentObject):
        subs = [value[1]] if isinstance(value[1], str) else list(value[1] or [""])
        for sub in subs or [""]:
            yield value[0], sub if isinstance(sub, str) else ""
    elif isinstance(value, (list, tuple)):
        for entry in value:
            yield from _link_targets(entry)


def _add_vector(numbers, _, name, vector):
    numbers[name + ".x"], numbers[name + ".y"], numbers[name + ".z"] = vector


def _add_position(numbers, measures, name, position):
    for axis, value in zip("xyz", position):
        _add(numbers, measures, "%s.%s" % (name, axis), value, "length")


def _add_placement(numbers, measures, name, placement):
    rotation = _rotation_of(placement)
    _add_position(numbers, measures, name + ".Base", _base_of(placement))
    _add_vector(numbers, measures, name + ".Axis", _axis_of(rotation))
    _add(numbers, measures, name + ".Angle", math.degrees(_angle_of(rotation)), "angle")


def _add_fillets(numbers, measures, name, edges):
    for index, first, second in edges:
        _add(numbers, measures, "%s.Edge%d.first" % (name, index), float(first), "length")
        _add(numbers, measures, "%s.Edge%d.second" % (name, index), float(second), "length")


def _add_constraints(numbers, measures, _, constraints):
    for index, constraint in enumerate(constraints):
        if constraint.Type not in DIMENSIONS:
            continue
        name, value = constraint.Name or "Constraint%d" % (index + 1), float(constraint.Value)
        if constraint.Type == "Angle":
            _add(numbers, measures, name, math.degrees(value), "angle")
        elif constraint.Type in _WITHOUT_UNIT:
            numbers[name] = value
        else:
            _add(numbers, measures, name, value, "length")


def _add_spacings(numbers, _, name, values):
    """Of a pattern (FreeCAD 1.1); -1 is a spacing that is not given by itself. Other lists may be long, and say nothing."""
    if name.startswith("Spacing"):
        numbers.update(("%s[%d]" % (name, i), value) for i, value in enumerate(values) if value != -1)


def _add(numbers, measures, name, value, measure):
    numbers[name], measures[name] = value, measure


_ADD = {"constraints": _add_constraints, "spacings": _add_spacings, "vector": _add_vector, "position": _add_position, "placement": _add_placement, "fillets": _add_fillets}

# SPDX-License-Identifier: GPL-3.0-or-later
"""What a reference of any FEM object means on the meshed part.

A click into the 3D view names the tip of a body (`Fillet:Face19`), not the body; a script names whatever it likes: the part, a feature
before the tip, a path through links and containers (`Body.Fillet.Face19`). The tip has its body's faces, with the same numbers. Of any
other feature of the part, those faces of the final shape are meant that lie on the feature's face: what was trimmed, or split, since.

FEM's panels keep `Fillet:Face19` of a click on a link, too, which does not say of which copy; so what was clicked there is kept beside it, in a
property of the object that refers to it (CLICKED).
"""

import re
import typing

import Part

from . import engine, reading, versions
from .errors import UserError

LOST = "?"   # in front of a sub-element that FreeCAD has lost, since 1.0
CLICKED = "ClickedThrough"   # a property: "Link.Fillet.Face19" for each reference that was clicked through a link
_MAPPED = ";"   # in front of an element's longer name, which selections have beside the plain one, since 1.0
_ELEMENT = re.compile(r"(Face|Edge|Vertex|Solid)(\d+)$")
_ANALYTIC = {"Face": ("Part::GeomPlane", "Part::GeomCylinder", "Part::GeomCone", "Part::GeomSphere", "Part::GeomToroid"), "Edge": ("Part::GeomLine", "Part::GeomCircle")}
_STEPS = 6   # between the points at which a free form is looked at
_INWARDS = 1e-4   # of a solid's size, from its faces to points inside
_MEMBERS = {"Face": "Faces", "Edge": "Edges", "Vertex": "Vertexes", "Solid": "Solids"}


class _Member(typing.NamedTuple):
    """A face or an edge of the part."""
    name: str
    shape: object
    box: object
    is_free: bool   # no plane, cylinder, cone, sphere, torus, line or circle
    is_between_solids: bool


class Resolver:
    """Gives the sub-elements of one part that references mean."""

    def __init__(self, part, raw=None):
        """`raw` is the part as it was read; it is read when needed and not given."""
        self.part = part
        self._raw = raw
        self._alike = same_numbers(part)
        # What references to the part are written to: FreeCAD (0.20 to 1.1) crashes when a constraint refers to a link. None where there is nothing.
        self.bearer = next((obj for obj in self._alike if obj.isDerivedFrom("Part::Feature")), None)
        self._traced = {}   # name of a feature's record -> {sub-element of it: sub-elements of the part}
        self._found = {}    # (feature, sub-element of it) -> sub-elements of the part
        self._placed = {}   # feature -> its shape in the part's space
        self._members = {}   # kind -> _Member of the part's shape

    def names(self, obj, sub):
        """Names of the part's faces, edges, vertices and solids that (obj, sub) means, empty when it has none any more; None when that is
        not on the part at all."""
        path, element = path_of(obj, sub)
        target = path[-1]
        if self._shows_another(path):
            return None
        if element.startswith(LOST):
            return self._only_solid(target, element)
        if self.is_alike(target):
            return [element] if element else self._all_solids()
        if not _ELEMENT.match(element):
            return None
        copy = self._copy_on(path)
        if copy is not None and target in same_numbers(copy):
            target = copy
        elif copy is not None and not (copy is self.part and self._alike[-1].isDerivedFrom("Part::Feature")):
            return self._of_copy(copy, _below(copy, obj, sub))
        shown = self.of_shown(target, element)
        if shown is not None:
            return shown
        return self._of_feature(target, element) if self._has_record(target) else None

    def of_shown(self, target, element):
        """Of one of the parts of a container, whose shape is a piece of this one as it is, though another part may lie in its place; "" means all its
        solids. None for anything else, and where parts are joined."""
        index = next((i for i, shown in enumerate(getattr(self.part, "Parts", ())) if target in same_numbers(shown)), None)
        if index is None or getattr(self.part, "Join", True) or (element and not _ELEMENT.match(element)):
            return None
        kind, number = _ELEMENT.match(element).groups() if element else ("Solid", 0)
        pieces = self.part.Shape.SubShapes
        own = getattr(pieces[index], _MEMBERS[kind]) if index < len(pieces) else []
        if len(own) != target.Shape.countElement(kind):
            return None   # it is another one by now
        meant = own[int(number) - 1:int(number)] if element else own
        return ["%s%d" % (kind, i + 1) for i, member in enumerate(getattr(self.part.Shape, _MEMBERS[kind])) if any(member.isSame(one) for one in meant)]

    def of_object(self, member):
        """What the References of an FEM object mean: (names, the (object, sub-element) pairs that are not on the part)."""
        names, foreign = [], []
        for obj, sub in pairs_of(member):
            found = self.names(obj, sub)
            if found is None:
                foreign.append((obj, sub))
            names += [name for name in found or [] if name not in names]
        return names, foreign

    def without_trace(self, member):
        """The (object, sub-element) pairs of its References that are on something that the part is made of, and of which the part has nothing."""
        return [(obj, sub) for obj, sub in pairs_of(member) if self.names(obj, sub) == []]

    def is_alike(self, obj):
        """Has the object the part's shape, number by number?"""
        return obj in self._alike or self.part in same_numbers(obj)

    def _shows_another(self, path):
        """Does the path go through another copy of the meshed thing than the meshed one?"""
        return self.part not in path and any(step.isDerivedFrom("App::Link") and not self._has_record(step) for step in path) and self._shows_copies()

    def _shows_copies(self):
        """Is the part a link, or does it show what links show?"""
        return self.part.isDerivedFrom("App::Link") or any(copy.isDerivedFrom("App::Link") for copy in getattr(self.part, "Parts", ()))

    def _copy_on(self, path):
        """The first link of a path that the part is or shows, and that shows the last object in a place of its own; or None."""
        return next((step for step in path if step.isDerivedFrom("App::Link") and (step is self.part or self._has_record(step))), None)

    def _only_solid(self, target, element):
        """FreeCAD 1.0 loses solids when it recomputes, even the only one of a body."""
        if not element.startswith(LOST + "Solid") or not (self.is_alike(target) or self._has_record(target)):
            return []
        solids = self._all_solids()
        return solids if len(solids) == 1 else []

    def _all_solids(self):
        return ["Solid%d" % (i + 1) for i in range(self.part.Shape.countElement("Solid"))]

    def _has_record(self, obj):
        return obj is not self.part and self._record_name(obj) is not None

    def _record_name(self, obj):
        if self._raw is None:
            try:
                self._raw = reading.read_document(self.part)
            except UserError:
                return None   # without a shape there is nothing to refer to
        key = reading.key_of(obj, self.part.Document)
        return next((key for record in self._raw["records"] if record["name"] == key and record["shape"] >= 0), None)

    def _of_feature(self, feature, element):
        traced = self._trace(feature)
        if not element.startswith("Solid"):
            if (feature, element) not in self._found:
                found = traced.get(element, [])
                self._found[feature, element] = found + self._more_on(feature, element, found)
            return self._found[feature, element]
        shape = self._where_it_is(feature)
        if not is_element_of(shape, element):
            return []
        solid = shape.Solids[int(element[len("Solid"):]) - 1]
        numbers = [number for number, face in enumerate(shape.Faces, 1) if any(face.isSame(own) for own in solid.Faces)]
        faces = [name for number in numbers for name in traced.get("Face%d" % number, [])]
        return _solids_within(self.part.Shape, solid) or solids_around(self.part.Shape, faces)

    def _more_on(self, feature, element, found):
        """Names of more faces (edges) of the part that lie wholly on that one of the feature, which the engine does not tell: those between two solids, and
        where one of both is of free form, which it knows only where it is the same one. Where it `found` nothing, all that lie there."""
        kind, shape = _ELEMENT.match(element).group(1), self._where_it_is(feature)
        if kind not in _ANALYTIC or not is_element_of(shape, element):
            return []
        target, box, tolerance = shape.getElement(element), shape.getElement(element).BoundBox, 1e-6 * (1 + shape.BoundBox.DiagonalLength)
        box.enlarge(tolerance)
        members = self._members_of(kind)
        known, is_sought = [member.shape for member in members if member.name in found], not found or _is_free(target)
        return [member.name for member in members
                if member.name not in found and (is_sought or member.is_free or member.is_between_solids) and box.intersect(member.box)
                and all(_lies_on(point, target, tolerance) for point in _points_of(member.shape)) and not any(_same_place(member.shape, other) for other in known)]

    def _where_it_is(self, feature):
        """The feature's shape in the part's space."""
        if feature not in self._placed:
            shape = Part.Shape(feature.Shape)
            shape.Placement = versions.frame_around(self.part).inverse().multiply(versions.frame_around(feature)).multiply(shape.Placement)
            self._placed[feature] = shape
        return self._placed[feature]

    def _members_of(self, kind):
        if kind not in self._members:
            shape = self.part.Shape
            between = _faces_between(shape.Solids) if kind == "Face" else {}
            self._members[kind] = [_Member(kind + str(number), own, own.BoundBox, _is_free(own), _is_among(own, between))
                                   for number, own in enumerate(getattr(shape, _MEMBERS[kind]), 1) if kind == "Face" or not own.Degenerated]
        return self._members[kind]

    def _trace(self, feature):
        name = self._record_name(feature)
        if name not in self._traced:
            self._traced[name] = engine.load().trace_sub_elements(self._raw, name)
        return self._traced[name]

    def _of_copy(self, copy, sub):
        """Of something that a link to a container, or one of several copies, shows in its own place."""
        place = copy.getSubObject(sub)
        if place is None:
            return []
        if copy is not self.part:
            place.Placement = versions.frame_around(copy).multiply(place.Placement)
        kind = place.ShapeType
        return ["%s%d" % (kind, i + 1) for i, own in enumerate(getattr(self.part.Shape, _MEMBERS[kind])) if _same_place(own, place)][:1]


def is_element_of(shape, name):
    """Has the shape a face, edge, vertex or solid of that name?"""
    found = _ELEMENT.match(name)
    return found is not None and 1 <= int(found.group(2)) <= shape.countElement(found.group(1))


def path_of(obj, sub):
    """The objects that a reference leads through, the last of which has the element; and the element's plain name."""
    *names, element = plain(sub).split(".")
    path = [obj]
    for depth in range(len(names)):
        step = obj.getSubObject(".".join(names[:depth + 1]) + ".", retType=1)
        if step is not None and step is not path[-1]:
            path.append(step)
    return path, element


def plain(sub):
    """A path without the longer names of elements."""
    return ".".join(name for name in sub.split(".") if not name.startswith(_MAPPED))


def pairs_of(member, name="References"):
    """(object, sub-element) for everything that a property of an FEM object refers to, as it was clicked where that is known; the sub-element of a
    whole object is ""."""
    clicked = {(path[-1], element): through for through, path, element in _clicked_through(member)}
    return [clicked.get(pair, pair) for pair in plain_pairs_of(member, name)]


def plain_pairs_of(member, name="References"):
    """The same as the property has it, without the paths of clicks."""
    value = getattr(member, name, None) or []
    several = value if isinstance(value, list) else [value]   # of a link to one object FreeCAD gives that pair alone
    return [(obj, sub) for obj, subs in several for sub in ((subs,) if isinstance(subs, str) else subs or ("",))]


def _clicked_through(member):
    """((object, sub-element), path, element) for each line of CLICKED whose objects are still there."""
    for line in getattr(member, CLICKED, None) or ():
        name, _, sub = line.partition(".")
        root = member.Document.getObject(name)
        if root is not None:
            yield ((root, sub), *path_of(root, sub))


def same_numbers(part):
    """The part and the objects whose shape is the part's, number by number: the tip of a body, what a link shows."""
    alike = [part]
    while True:
        obj = alike[-1]
        following = getattr(obj, "Tip", None) if obj.TypeId == "PartDesign::Body" else \
            obj.getLinkedObject() if obj.isDerivedFrom("App::Link") else None
        if following is None or following in alike or not _same_counts(part, following):
            return alike
        alike.append(following)


def solids_around(shape, faces):
    """Names of the solids of `shape` that have most of the named faces."""
    wanted = [shape.getElement(name) for name in faces]
    shared = [sum(any(face.isSame(own) for own in solid.Faces) for face in wanted) for solid in shape.Solids]
    return ["Solid%d" % (i + 1) for i, count in enumerate(shared) if count and count == max(shared)]


def _solids_within(shape, whole):
    """Names of the solids of `shape` that are pieces of the solid `whole`, as boolean fragments make them."""
    found = []
    for number, solid in enumerate(shape.Solids, 1):
        points, tolerance = list(_points_inside(solid)), 1e-3 * _INWARDS * solid.BoundBox.DiagonalLength
        if points and all(whole.isInside(point, tolerance, False) for point in points):
            found.append("Solid%d" % number)
    return found


def is_between_solids(shape, name):
    """Is that a face of two of the shape's solids?"""
    return name.startswith("Face") and _is_among(shape.getElement(name), _faces_between(shape.Solids))


def describe(obj, sub):
    """A reference as FEM's panels show it."""
    return "%s:%s" % (obj.Name, sub) if sub else obj.Name


def _is_free(element):
    try:
        form = element.Surface if element.ShapeType == "Face" else element.Curve
    except TypeError:   # one of which FreeCAD has no kind
        return True
    return form.TypeId not in _ANALYTIC[element.ShapeType]


def _faces_between(solids):
    """{hash: faces that two of the solids have}"""
    once, twice = {}, {}
    for solid in solids if len(solids) > 1 else ():
        for face in solid.Faces:
            kept = twice if _is_among(face, once) else once
            kept.setdefault(face.hashCode(), []).append(face)
    return twice


def _is_among(element, by_hash):
    return any(element.isSame(other) for other in by_hash.get(element.hashCode(), ()))


def _points_of(element):
    """Points of a face or an edge: of its border, then inside."""
    if element.ShapeType == "Edge":
        low, high = element.ParameterRange
        yield from (element.valueAt(low + (high - low) * i / _STEPS) for i in range(_STEPS + 1))
        return
    for edge in element.Edges:
        if not edge.Degenerated:
            yield from _points_of(edge)
    low_u, high_u, low_v, high_v = element.ParameterRange
    inside = ((low_u + (high_u - low_u) * i / _STEPS, low_v + (high_v - low_v) * j / _STEPS) for i in range(1, _STEPS) for j in range(1, _STEPS))
    yield from (element.valueAt(u, v) for u, v in inside if element.isPartOfDomain(u, v))


def _points_inside(solid):
    """A point of the solid below each of its faces."""
    for face in solid.Faces:
        low_u, high_u, low_v, high_v = face.ParameterRange
        spots = [(low_u + (high_u - low_u) * i / _STEPS, low_v + (high_v - low_v) * j / _STEPS) for i in range(1, _STEPS) for j in range(1, _STEPS)]
        spot = next((spot for spot in spots if face.isPartOfDomain(*spot)), None)
        if spot is not None:
            yield face.valueAt(*spot) - face.normalAt(*spot) * _INWARDS * solid.BoundBox.DiagonalLength


def _lies_on(point, element, tolerance):
    return element.distToShape(Part.Vertex(point))[0] <= tolerance


def _same_counts(part, other):
    mine, others = (getattr(obj, "Shape", None) for obj in (part, other))
    return mine is not None and others is not None and \
        all(mine.countElement(kind) == others.countElement(kind) for kind in _MEMBERS)


def _below(step, obj, sub):
    """The rest of the path (obj, sub) behind one of its objects."""
    names = plain(sub).split(".")
    depth = next(depth for depth in range(len(names)) if (obj.getSubObject(".".join(names[:depth]) + ".", retType=1) if depth else obj) is step)
    return ".".join(names[depth:])


def _same_place(one, other):
    tolerance = 1e-6 * (1 + one.BoundBox.DiagonalLength)
    boxes = [shape.BoundBox for shape in (one, other)]
    return (boxes[0].Center - boxes[1].Center).Length < tolerance and abs(boxes[0].DiagonalLength - boxes[1].DiagonalLength) < tolerance \
        and abs(one.Length - other.Length) < tolerance and abs(one.Area - other.Area) < tolerance * (1 + one.Length)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the feature tree of a part from the live document into raw records (see featuremesh_engine.pyi).

Nothing is interpreted here: what a record means is decided by the engine. Two things only FreeCAD knows are settled
here: which objects the part depends on, and in which frame each of them lies.
"""

from collections import deque

import FreeCAD
import numpy
import Part
import Sketcher

from . import shape_bytes, versions
from .errors import NotSelected, UserError
from .messages import close_names, said
from .properties import (
    document_of, matrix_entries, name_of, objects_out_of, properties_of, property_if_any, property_of, state_of, type_of,
)

_A_PART = said("a body, or a Part object with a solid")
# A pattern's direction, a sketch's plane: needed for the dependencies, but without any volume of their own. The engine's `is_reference`
# (feature_types.cpp) means the same types; here they also spare the reading of shapes.
_REFERENCE_TYPES = ("Sketcher::", "Spreadsheet::", "App::Line", "App::Plane", "App::Point", "App::Origin",
                    "PartDesign::Plane", "PartDesign::Point", "PartDesign::CoordinateSystem", "Part::Datum", "App::TextDocument")
# The class of what shows the parts of a container, each where it is (assembled.py).
ASSEMBLED = "AssembledParts"
# A base for the engine: a binder's shape is all that comes from the parts behind it, which lie in frames of their own. Nothing that uses one
# takes its volume over.
BINDERS = ("PartDesign::ShapeBinder", "PartDesign::SubShapeBinder")


def read_document(part):
    """Everything the engine needs to know of the object `part` and what it depends on, as a dict.

    Shapes and frames are given in the frame in which FEM sees `part.Shape`. Throws UserError when it has no shape.
    """
    if not has_shape(part):
        raise UserError(no_shape(part))
    walk = _Walk(part)
    shapes = _ShapeList(_lowest_meshed_in(_shape_of(part)))
    home = part.Document
    keys = {obj: key_of(obj, home) for obj in walk.frames}
    records = [_record(obj, walk, shapes, keys, home) for obj in _in_dependency_order(part, walk.children)]
    return {"final_object": keys[part], "records": records, "shapes": shapes.to_bytes()}


def shape_in_place(part):
    """The object's shape where it is in the document."""
    shape = Part.Shape(_shape_of(part))
    shape.Placement = versions.frame_around(part).multiply(shape.Placement)
    return shape


def outline_of(part):
    """Triangles by face and polylines by edge of the object's shape, mm, for pictures."""
    shape = _shape_of(part)
    fine = shape.BoundBox.DiagonalLength / 1000
    faces = []
    for face in shape.Faces:
        points, triangles = face.tessellate(fine)
        corners = [[tuple(points[i]) for i in triangle] for triangle in triangles]
        faces.append(numpy.array(corners).reshape(-1, 3, 3))
    edges = [numpy.array([tuple(p) for p in edge.discretize(Deflection=fine)])
             for edge in shape.Edges if not edge.Degenerated]
    return {"faces": faces, "edges": edges}


def shape_of_record(raw):
    """The final object's shape as read_document recorded it."""
    index = next(record["shape"] for record in raw["records"] if record["name"] == raw["final_object"])
    return shape_bytes.shapes_in(raw["shapes"])[index]


def find_meshable(document, name=None):
    """The object to mesh: the one called `name` (or so labelled), else the only solid that no other one uses, or the only object with faces.

    Throws UserError: unknown name, an object with nothing to mesh, none, or several (which it lists).
    """
    if name:
        return _checked_part(find_object(document, name))
    final = final_parts(document)
    if not final:
        raise UserError(said("the document {document:text} has no part to mesh", document=document.Label))
    if len(final) > 1:
        raise NotSelected(said("the document has several parts, select one, or the container of those to mesh: {parts:text}",
                               parts=", ".join(map(describe, final))), NotSelected.OBJECT)
    return final[0]


def final_parts(document):
    """The objects with a solid that no other one uses; where there is no solid, those with a face, or else with an edge, or else what is only drawn."""
    return next((found for found in (_final_objects(document.Objects, kind) for kind in _KINDS) if found), list(filter(_is_drawn_alone, document.Objects)))


def final_solids_of(objects):
    """Those of the objects with a solid that no other one of them uses."""
    return _final_objects(objects, _KINDS[0])


def _final_objects(objects, kind):
    candidates = [obj for obj in objects if _is_candidate(obj, kind)]
    users = candidates + [obj for obj in objects if obj.TypeId == "PartDesign::Body" or _is_feature_of_body(obj)]
    used = {one for user in users for one in _used_by(user)}
    return [obj for obj in candidates if obj not in used]


def no_shape(part):
    """That the part has no shape, with the first feature that has none though one before it had; since 1.0 that is no error."""
    if part.isDerivedFrom("App::LinkGroup"):
        return said("{part:text} is a group of links, which has no shape; make a compound of it (Part: Compound) and mesh that", part=describe(part))
    if part.isDerivedFrom("Mesh::Feature"):
        return said("{part:text} consists of triangles; make a solid of it (Part: Create shape from mesh, Convert to solid) and mesh that", part=describe(part))
    before = False
    for obj in dependencies(part):
        if obj is part or not obj.isDerivedFrom("PartDesign::Feature"):
            continue
        if before and not has_shape(obj):
            return said("{part:text} has no shape to mesh: {feature:text} leaves nothing of it", part=describe(part), feature=describe(obj))
        before = before or has_shape(obj)
    return said("{part:text} has no shape to mesh", part=describe(part))


def find_object(document, name, meant=()):
    """The object of that name, else the only one with that label. Throws UserError with names that come close, or else those of what may be meant."""
    found = called(document.Objects, name)
    if len(found) == 1:
        return found[0]
    if found:
        raise UserError(said("{count:count} objects have the label {label:text}, use a name: {names:text}",
                             count=len(found), label=name, names=", ".join(obj.Name for obj in found)))
    near = close_names(name, [o.Name for o in document.Objects]) or (said("; its parts are {names:text}", names=", ".join(map(describe, meant))) if meant else "")
    raise UserError(said("the document has no object {name:text}{near:messages}", name=name, near=near))


def called(objects, name):
    """Those of the objects with that name, else those with that label: a label may be another one's name."""
    return [obj for obj in objects if obj.Name == name] or [obj for obj in objects if obj.Label == name]


def describe(obj):
    """Name and, where it differs, label of an object, as messages show it."""
    return obj.Name if obj.Label == obj.Name else "%s (%s)" % (obj.Name, obj.Label)


def has_shape(obj):
    """Is there a shape with at least one face or edge?"""
    return _highest_in(_shape_of(obj)) is not None


def filled_with(part, dimension):
    """"Solids", "Faces" or "Edges": what is meshed of the part, where `dimension` may leave that to the shape."""
    if dimension in (kind + "s" for kind in _KINDS):
        return dimension
    highest = None if part is None else _highest_in(_shape_of(part))
    return (highest or "Solid") + "s"


def key_of(obj, home):
    """Name under which records know an object: its own, with the document's in front when it lives in another one."""
    document = document_of(obj)
    return name_of(obj) if document is home else "%s#%s" % (document.Name, name_of(obj))


def error_of(obj):
    """FreeCAD's own message when the object is in error, without line breaks, else ""."""
    return (" ".join(obj.getStatusString().split()) or "Invalid") if "Invalid" in state_of(obj) else ""


def refuse_errors(part):
    """Throws UserError when the part itself is in error, with FreeCAD's message."""
    if error_of(part):
        raise UserError(said("FreeCAD could not compute {part:text}: {error:text}", part=describe(part), error=error_of(part)))


def refuse_gone(obj, wanted=_A_PART):
    """Throws UserError for what is no object of an open document; `wanted` is a message that says what to give."""
    if not isinstance(obj, FreeCAD.DocumentObject):
        raise UserError(said("{object:text} is no object of a document; give {wanted:messages}", object=str(obj), wanted=wanted))
    try:
        obj.Name
    except ReferenceError:
        raise UserError(said("the object is gone: it was deleted, or its document was closed")) from None


def refuse_unmeshable(part):
    """Throws UserError for what cannot be meshed as it is: gone, in error, without a shape (yet)."""
    refuse_gone(part)
    refuse_errors(part)
    if has_shape(part):
        return
    if _shape_of(part) is None and "Touched" in part.State:
        raise UserError(said("{part:text} has no shape yet; recompute the document first", part=describe(part)))
    raise UserError(no_shape(part))


def dependencies(part):
    """The objects the part's shape comes from, in dependency order, itself last."""
    return _in_dependency_order(part, _Walk(part).children)


# Which objects, in which order and frame


def _children(obj, own, links, properties, kinds):
    """What `obj`, placed at `own`, depends on directly: (object, frame of the child's parent relative to obj's, carries volume)."""
    kind = properties.kind
    if kind in BINDERS:
        return []
    if kind == "PartDesign::Body":
        return [(member, own, not _gives_no_volume(member, kinds[member])) for name, member, _ in links if name == "Group"]
    linked = _linked_objects(links, kinds)
    if properties.proxy_name(obj) == ASSEMBLED:
        return [(part, versions.frame_around(part), True) for part in linked]
    result = []
    gives_no_volume, undoes = _gives_no_volume(obj, kind), _undoes_placements(obj, properties)
    is_step = _derives(obj, "PartDesign::Feature", kind)
    for child in linked:
        if gives_no_volume or _gives_no_volume(child, kinds[child]):
            result.append((child, FreeCAD.Placement(), False))
        else:
            result.append((child, _frame_of_child(own, child, undoes, is_step and _derives(child, "PartDesign::Feature", kinds[child])), True))
    known = set(linked)
    result += [(child, FreeCAD.Placement(), False) for child in objects_out_of(obj)
               if child not in known and kinds[child] != "PartDesign::Body" and not _derives(child, "App::Origin", kinds[child])]
    return result


def _undoes_placements(obj, properties):
    """Does what `obj` shows lie at its own placement, wherever the original lies?"""
    if properties.kind == "App::Link":
        return not getattr(obj, "LinkTransform", False)
    return properties.kind == "PartDesign::FeatureBase" or properties.proxy_name(obj) in ("_Clone", "Clone")


def _frame_of_child(own, child, undoes, are_steps):
    """Frame in which `child.Shape` enters the shape of an object placed at `own`, relative to the frame of that one's parent."""
    if undoes:
        return own.multiply(getattr(child, "Placement", FreeCAD.Placement()).inverse())
    return FreeCAD.Placement() if are_steps else own


class _Kinds(dict):
    """Types of objects, each asked for once."""

    def __missing__(self, obj):
        kind = self[obj] = type_of(obj)
        return kind


class _Walk:
    """What `part` depends on. By object: `frames`, the placement from its parent's frame into the final one (volume-carrying links decide first);
    `parents`, the object whose link decided that; `placements`, its own; `children`, what it depends on; `properties`, what they are read for;
    `links`, as _links gives them."""

    def __init__(self, part):
        self.frames = {part: versions.parent_frame(part)}
        self.parents, self.placements, self.children, self.properties, self.links = {}, {}, {}, {}, {}
        self._kinds = _Kinds()
        strong, weak = deque([part]), deque()
        while strong or weak:
            if strong:
                obj = strong.popleft()
            else:
                obj, frame = weak.popleft()
                if obj in self.frames:
                    continue
                self.frames[obj] = frame
            self._visit(obj, strong, weak)

    def _visit(self, obj, strong, weak):
        properties = self.properties[obj] = properties_of(obj, self._kinds[obj])
        links = self.links[obj] = _links(obj, properties)
        own = self.placements[obj] = properties.value(obj, "Placement") or FreeCAD.Placement()
        found = _children(obj, own, links, properties, self._kinds)
        self.children[obj] = [child for child, _, _ in found]
        for child, relative, carries_volume in found:
            if child in self.frames:
                continue
            frame = self.frames[obj].multiply(relative)
            if carries_volume:
                self.frames[child], self.parents[child] = frame, obj
                strong.append(child)
            else:
                weak.append((child, frame))


def _in_dependency_order(part, children):
    """The part and what it depends on, each object after all that it does. Without recursion: boolean chains can be deep."""
    ordered, opened, done = [], set(), set()
    stack = [part]
    while stack:
        obj = stack[-1]
        if obj in done:
            stack.pop()
        elif obj in opened:
            stack.pop()
            done.add(obj)
            ordered.append(obj)
        else:
            opened.add(obj)
            stack.extend(child for child in reversed(children[obj]) if child not in opened)
    return ordered


def _members_up_to_tip(body):
    members, tip = list(property_of(body, "Group")), property_of(body, "Tip")
    return members[:members.index(tip) + 1] if tip in members else members


def _linked_objects(links, kinds):
    """Objects that the links name, each once, in order."""
    return [child for child in dict.fromkeys(child for _, child, _ in links)
            if kinds[child] != "App::Part" and not _derives(child, "App::Origin", kinds[child])]


def _links(obj, properties):
    """As Properties.links gives them; none behind a binder, and of a body's members only those up to its tip."""
    if properties.kind in BINDERS:
        return []
    links = properties.links(obj)
    if properties.kind != "PartDesign::Body":
        return links
    members = _members_up_to_tip(obj)
    return [link for link in links if link[0] != "Group" or link[1] in members]


# One record


def _record(obj, walk, shapes, keys, home):
    own, frame, properties = walk.placements[obj], walk.frames[obj], walk.properties[obj]
    kind = properties.kind
    volume = None if _gives_no_volume(obj, kind) else properties.value(obj, "AddSubShape")
    is_hidden = _is_reference(obj, kind) and obj in walk.parents   # what is meshed itself is shown
    shown = None if is_hidden else walk.parents[obj] if _is_shown_by_body(obj, volume, walk) else obj
    numbers, texts, measures = properties.parameters(obj)
    whole = own if frame.isIdentity() else frame.multiply(own)
    place = matrix_entries(own)
    record = {
        "name": keys[obj],
        "label": property_of(obj, "Label"),
        "type": kind,
        "proxy": properties.proxy_name(obj),
        "links": [(name, keys.get(target) or key_of(target, home), sub) for name, target, sub in walk.links[obj]],
        "placement": place,
        "global_placement": list(place) if whole is own else matrix_entries(whole),
        "numbers": numbers,
        "texts": texts,
        "measures": measures,
        "shape": shapes.add_of(shown, walk.frames),
        "own_volume": shapes.add(volume, whole),
        "suppressed": bool(properties.value(obj, "Suppressed")),
        "error": error_of(obj),
    }
    if kind.startswith("Sketcher::"):
        record["elements"] = elements_of(obj)
    return record


def elements_of(sketch):
    """(id, numbers) of the lines and curves that a sketch is swept along, in its own frame: three points each, and a centre if it has one."""
    elements = []
    for geometry in sketch.Geometry:
        facade = Sketcher.GeometryFacade(geometry)
        if facade.Construction or isinstance(geometry, Part.Point):
            continue
        first, last = geometry.FirstParameter, geometry.LastParameter
        points = [geometry.value(first + share * (last - first)) for share in (0.25, 0.5, 0.75)]
        if isinstance(geometry, (Part.Circle, Part.ArcOfCircle)):
            points.append(geometry.Center)
        elements.append((facade.Id, [coordinate for point in points for coordinate in point]))
    return elements


def elements_of_today(raw, document):
    """{name of each sketch of a saved part: its elements}, with the ids that they have now: FreeCAD 0.20 gives new ones whenever it opens a document.
    What is not where it was saved is left out."""
    found = {}
    for record in raw["records"]:
        sketch = document.getObject(record["name"]) if "elements" in record else None
        if sketch is not None:
            today = {_rounded(numbers): number for number, numbers in elements_of(sketch)}
            found[record["name"]] = [(today[_rounded(numbers)], numbers) for _, numbers in record["elements"] if _rounded(numbers) in today]
    return found


def with_elements(raw, elements):
    """The part as it was read, with other sketch elements."""
    return {**raw, "records": [{**record, "elements": elements.get(record["name"], [])} if "elements" in record else record
                               for record in raw["records"]]}


def _rounded(numbers):
    return tuple(round(number, 6) for number in numbers)


def _is_shown_by_body(obj, volume, walk):
    """Is `obj` a tip with a volume of its own, so that the shape of the body, which is a copy of its shape, can stand for that? A copy shares no
    faces with the shapes before, but only what has no such volume is told from the shapes before and after it."""
    body = walk.parents.get(obj)
    return (body is not None and walk.properties[body].kind == "PartDesign::Body" and ("Tip", obj, "") in walk.links[body]
            and not _derives(obj, "PartDesign::DressUp", walk.properties[obj].kind) and _has_solid(volume)
            and "Up-to-date" in state_of(obj) and "Up-to-date" in state_of(body) and _has_solid(_shape_of(body)))


def _has_solid(shape):
    return shape is not None and not shape.isNull() and (shape.ShapeType == "Solid" or bool(shape.Solids))


_KINDS = ("Solid", "Face", "Edge")   # of what is meshed, the highest first


def _highest_in(shape):
    """"Solid", "Face" or "Edge": the highest that the shape has; None for nothing."""
    if shape is None or shape.isNull():
        return None
    return "Solid" if _has_solid(shape) else next((kind for kind in _KINDS[1:] if shape.countElement(kind) > 0), None)


def _lowest_meshed_in(shape):
    """The highest kind in the shape, or the lowest that it has beside that: faces of no solid, edges of no face."""
    highest = _highest_in(shape)
    if highest is None or shape.ShapeType != "Compound":
        return highest
    for kind, above in (("Edge", "Face"), ("Face", "Solid")):
        of_above = Part.Compound(getattr(shape, above + "s"))
        if _has(shape, above) and shape.countElement(kind) > of_above.countElement(kind):
            return kind
    return highest


def _has(shape, kind):
    """Has the shape something of that kind, or of a higher one?"""
    highest = _highest_in(shape)
    return highest is not None and _KINDS.index(highest) <= _KINDS.index(kind)


class _ShapeList:
    """Collects shapes that travel together, so that shared faces stay shared; those that have what the part has: solids, else faces, else edges."""

    def __init__(self, kind):
        self._kind = kind
        self._shapes = []
        self._places = {}   # hash of a shape -> indices of the shapes with that
        self._numbers = {}

    def add_of(self, obj, frames):
        """Index of the object's shape, as add gives it; -1 for None."""
        if obj not in self._numbers:
            self._numbers[obj] = -1 if obj is None else self.add(_shape_of(obj), frames[obj])
        return self._numbers[obj]

    def add(self, shape, frame):
        """Index of the shape, moved by `frame`; -1 for a null shape or one with nothing of the kind."""
        if not _has(shape, self._kind):
            return -1
        if not frame.isIdentity():
            shape = Part.Shape(shape)
            shape.Placement = frame.multiply(shape.Placement)
        known = self._places.setdefault(shape.hashCode(), [])
        at = next((at for at in known if self._shapes[at].isEqual(shape)), None)   # as of a suppressed feature and the one before it
        if at is None:
            at = len(self._shapes)
            known.append(at)
            self._shapes.append(shape)
        return at

    def to_bytes(self):
        return shape_bytes.of_shapes(self._shapes)


# By type of object, and by base.
_REFERENCES, _BASES = {}, {}


def _derives(obj, base, kind):
    key = (kind, base)
    if key not in _BASES:
        _BASES[key] = obj.isDerivedFrom(base)
    return _BASES[key]


def _gives_no_volume(obj, kind):
    """Has what uses the object none of its volume?"""
    return kind in BINDERS or _is_reference(obj, kind)


def _is_reference(obj, kind):
    if kind not in _REFERENCES:
        _REFERENCES[kind] = is_reference_type(kind) or _derives(obj, "Part::Part2DObject", kind)
    return _REFERENCES[kind]


def is_reference_type(kind):
    """Does the type's name alone say that it is a reference?"""
    return kind == "PartDesign::Line" or kind.startswith(_REFERENCE_TYPES)   # not PartDesign::LinearPattern


def _shape_of(obj):
    shape = property_if_any(obj, "Shape")
    if isinstance(shape, Part.Shape):
        return None if shape.isNull() else shape
    if obj.isDerivedFrom("App::Link"):
        shape = Part.getShape(obj)
        return None if shape.isNull() else shape
    return None


# Which object is the part


def _checked_part(obj):
    if obj.isDerivedFrom("App::Part") or obj.isDerivedFrom("App::DocumentObjectGroup"):
        raise UserError(said("{object:text} is a group, name one of its objects: {members:text}", object=describe(obj), members=", ".join(member.Name for member in obj.Group)))
    if obj.isDerivedFrom("App::LinkGroup") or obj.isDerivedFrom("Mesh::Feature"):
        raise UserError(no_shape(obj))
    if not (_is_drawn_alone(obj) or _has(_shape_of(obj), "Face" if is_drawn(obj) else "Edge")):
        raise UserError(said("{object:text} has no solid{error:text}", object=describe(obj), error=": " + error_of(obj) if error_of(obj) else ""))
    return obj


def is_drawn(obj):
    """Is it a sketch, or a wire of Draft?"""
    return obj.isDerivedFrom("Part::Part2DObject")


def _is_drawn_alone(obj):
    """Is nothing made of what was drawn, so that its lines may be beams?"""
    return is_drawn(obj) and has_shape(obj) and not any(user.isDerivedFrom("Part::Feature") for user in obj.InList)


def _is_candidate(obj, kind):
    if not (obj.isDerivedFrom("Part::Feature") or obj.isDerivedFrom("App::Link")):
        return False
    if _gives_no_volume(obj, obj.TypeId) or _is_feature_of_body(obj):
        return False
    return _has(_shape_of(obj), kind)


def _is_feature_of_body(obj):
    if not obj.isDerivedFrom("PartDesign::Feature"):
        return False
    parent = obj.getParentGeoFeatureGroup()
    return parent is not None and parent.TypeId == "PartDesign::Body"


def _used_by(obj):
    """The objects whose volume is part of `obj` (a sketch's support is one for features without a body)."""
    if obj.isDerivedFrom("App::Link") or obj.TypeId in BINDERS:
        return
    kinds = _Kinds()
    for child in _linked_objects(_links(obj, properties_of(obj, kinds[obj])), kinds):
        if not _gives_no_volume(child, kinds[child]):
            yield child
        elif obj.isDerivedFrom("PartDesign::Feature") and child.TypeId not in BINDERS:
            supports = _linked_objects(_links(child, properties_of(child, kinds[child])), kinds)
            yield from (support for support in supports if not _gives_no_volume(support, kinds[support]))

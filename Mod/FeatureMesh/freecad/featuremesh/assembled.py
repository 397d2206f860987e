# SPDX-License-Identifier: GPL-3.0-or-later
"""Several parts as one shape that a mesh can be made of: the solids of a container (App::Part, group, assembly), each where it is; or what a link shows.

A container has no shape of its own that a mesh or a load could refer to. This document object has one: a compound of its parts in their order,
whatever is hidden. Unless they are to be joined each part gets a mesh of its own, and an edit of one leaves those of the others.

A link has a shape, but FreeCAD (0.20 to 1.1) crashes when a constraint refers to a link, and FEM looks for a load's face where the original is. So
it is shown by such an object, too, to which loads and supports refer.
"""

import itertools

import FreeCAD
import Part

from . import reading, versions
from .errors import FailedUpdate, UserError
from .messages import of_error, said
from .proxies import HIDDEN, GetsReady, add_missing
from .user_words import in_words

translate = FreeCAD.Qt.translate
_CONTAINERS = ("App::Part", "App::DocumentObjectGroup")   # FreeCAD 1.x's assemblies are App::Parts, too
# (type, name, group, default, read-only, tooltip)
PROPERTIES = [
    ("App::PropertyLinkGlobal", "Container", "Parts", None, False, "The container whose parts these are, or the link that is shown"),
    ("App::PropertyLinkListGlobal", "Parts", "Parts", None, True, "The parts, in the order of the solids of the shape"),
    ("App::PropertyBool", "Join", "Parts", False, False, "Parts that lie on one another share faces, and the mesh its nodes there"),
    ("App::PropertyStringList", "Joints", "Parts", None, True, "The faces that joined parts share"),
    ("App::PropertyPlacementList", "Places", "Parts", None, True, "Where the solids of the parts were when they were put together"),
]
_LOST = 1e-4   # share of a solid's volume by which its pieces may differ from it
_ENDLESS = 1e99   # mm, of what has no end
# Called with every object that was made or opened; the window's side adds its view there.
on_ready = []


class AssembledParts(GetsReady):
    """Proxy of the object. Its class path is stored in documents and never changes; reading.py and the engine know the class by its name."""

    Type = "Part::FeatureMeshAssembledParts"

    def execute(self, obj):
        """Called by recompute."""
        try:
            self.assemble(obj)
        except UserError as error:
            raise FailedUpdate(obj.Label, in_words(of_error(error))) from None

    def assemble(self, obj):
        """Puts the parts of the container together as they are now. Throws UserError."""
        if obj.Container is None:
            raise UserError(said("{object:text} has no container, set its property Container", object=reading.describe(obj)))
        parts = parts_in(obj.Container)
        if not parts:
            raise UserError(said("{container:text} has no part with a solid", container=reading.describe(obj.Container)))
        if parts != obj.Parts:
            obj.Parts = parts
        shapes = [_with_an_end(reading.shape_in_place(part)) for part in parts]
        obj.Places = _places_of(shapes)
        if obj.Join:
            shapes = joined(parts, shapes)
        if not obj.Placement.isIdentity():
            obj.Placement = FreeCAD.Placement()   # somebody moved it
        obj.Shape = Part.makeCompound(shapes)
        obj.Joints = joints_in(parts, obj.Shape) if obj.Join else []

    def _get_ready(self, obj):
        add_missing(obj, PROPERTIES, hidden=("Places",))
        obj.setEditorMode("Placement", HIDDEN)   # the parts are where they are
        for hook in on_ready:
            hook(obj)


def part_of_solids(obj):
    """The labels of the parts that the solids of this object's shape are of, by the names of the solids; empty for any other object, and where it has one part."""
    if not is_assembled(obj) or len(obj.Parts) < 2:
        return {}
    labels = [part.Label for part, shape in zip(obj.Parts, obj.Shape.SubShapes) for _ in shape.Solids]
    return {"Solid%d" % (index + 1): label for index, label in enumerate(labels)}


def touch_if_moved(objects):
    """Touches those of our objects among these whose parts were moved: FreeCAD's Assembly takes back its mark that it moved a part."""
    for obj in objects:
        if "Touched" not in obj.State and was_moved(obj):
            obj.touch()


def was_moved(obj):
    """Is this one of our objects with a part that is not where it was when they were put together?"""
    if not is_assembled(obj):
        return False
    now = _places_of(map(reading.shape_in_place, obj.Parts)) if all(map(reading.has_shape, obj.Parts)) else []
    return len(now) != len(obj.Places) or not all(map(versions.are_same_place, now, obj.Places))


def _with_an_end(shape):
    """Without the datum planes and coordinate systems that a link to a container shows, too."""
    if _has_an_end(shape) or shape.ShapeType != "Compound":
        return shape
    return Part.makeCompound([_with_an_end(own) for own in shape.SubShapes if own.ShapeType == "Compound" or _has_an_end(own)])


def _has_an_end(shape):
    return shape.BoundBox.DiagonalLength < _ENDLESS


def refuse_endless(part):
    """Throws UserError for what holds a datum plane or a coordinate system: no size fits it."""
    if not _has_an_end(part.Shape):
        raise UserError(said("{part:text} has a face without an end, that of a datum plane or a coordinate system; leave it out", part=reading.describe(part)))


def _places_of(shapes):
    return [solid.Placement for shape in shapes for solid in shape.Solids]


def joined(parts, shapes):
    """The solids of the shapes with faces in common where they lie on one another, by part in their order. Throws UserError for parts that overlap."""
    solids = [solid for shape in shapes for solid in map(_right_side_out, shape.Solids)]   # General Fuse tells no pieces of compounds
    if len(solids) < 2:
        return shapes
    _, pieces_of = solids[0].generalFuse(solids[1:])
    listed = zip(solids, pieces_of)
    of_parts = []
    for part, shape in zip(parts, shapes):
        own = []
        for solid, pieces in itertools.islice(listed, len(shape.Solids)):
            own += [piece for piece in _pieces_of(solid, pieces, part) if not _is_among(piece, own)]
        for other, known in zip(parts, of_parts):
            if any(_is_among(piece, known) for piece in own):
                raise UserError(said("{one:text} and {other:text} overlap; parts that are joined may only touch",
                                     one=reading.describe(other), other=reading.describe(part)))
        of_parts.append(own)
    return [own[0] if len(own) == 1 else Part.makeCompound(own) for own in of_parts]


def _pieces_of(solid, pieces, part):
    """What General Fuse made of a solid. It lists nothing for one that no other touches. Throws UserError where it is not the whole solid."""
    found = [_right_side_out(piece) for listed in pieces for piece in listed.Solids] or [solid]
    if abs(sum(piece.Volume for piece in found) - solid.Volume) > _LOST * solid.Volume:
        raise UserError(said("FreeCAD's General Fuse makes another shape of {part:text}, so it cannot be joined to the parts that it touches; check it "
                             "(Part: Check geometry)", part=reading.describe(part)))
    return found


def _right_side_out(solid):
    return solid.reversed() if solid.Volume < 0 else solid


def _is_among(shape, others):
    return any(shape.isSame(other) for other in others)


def joints_in(parts, shape):
    """A line for each face of the shape that two of its parts share."""
    owners = {}
    for part, own in zip(parts, shape.SubShapes):
        for face in own.Faces:
            owners.setdefault(face.hashCode(), []).append((face, part))
    lines = []
    for number, face in enumerate(shape.Faces, 1):
        sharing = [part for known, part in owners.get(face.hashCode(), ()) if known.isSame(face)]
        if len(sharing) == 2:
            lines.append(translate("FeatureMesh", "Face%d: %s and %s, %.6g mm^2") % (number, *(part.Label for part in sharing), face.Area))
    return lines


def is_container(obj):
    """Is this something that holds parts and has no shape itself?"""
    return any(obj.isDerivedFrom(kind) for kind in _CONTAINERS)


def is_to_be_shown(obj):
    """Is this something that loads cannot refer to, a container or a link?"""
    return is_container(obj) or obj.isDerivedFrom("App::Link")


def is_assembled(obj):
    """Is this one of our objects?"""
    return isinstance(getattr(obj, "Proxy", None), AssembledParts)


def shows(obj, container):
    """Does the object show the parts of that container?"""
    return is_assembled(obj) and obj.Container is container


def seen_as(obj):
    """What a user clicks to mean the object: the container or the link that it shows, or itself."""
    return obj.Container or obj if is_assembled(obj) else obj


def is_refused_by_fem(obj):
    """Do FEM's panels refuse a face of one of its parts that is clicked? They take those of a link to a body, which has features, and of no other link."""
    return is_assembled(obj) and any(part.isDerivedFrom("App::Link") and not hasattr(part.LinkedObject, "Group") for part in obj.Parts)


def parts_in(container):
    """The objects with a solid in a container and in the containers in it that none of the others is made of, in order; a link itself."""
    if not is_container(container):
        return [container]
    members = dict.fromkeys(_members_of(container))   # an App::Part may have itself what is in a group in it
    return reading.final_solids_of([member for member in members if not is_assembled(member)])


def of(container):
    """The object with the shape of the container's parts, or of the link, made where there is none yet. Throws UserError: no part with a solid."""
    known = [obj for obj in container.Document.Objects if shows(obj, container)]
    if known:
        return known[0]
    if not parts_in(container):
        raise UserError(said("{container:text} has no part with a solid", container=reading.describe(container)))
    obj = container.Document.addObject("Part::FeaturePython", "AssembledParts")
    AssembledParts(obj)
    obj.Label = (translate("FeatureMesh", "Parts of %s") if is_container(container) else translate("FeatureMesh", "%s in its place")) % container.Label
    obj.Container = container
    obj.Proxy.assemble(obj)
    return obj


def _members_of(container):
    for member in container.Group:
        if is_container(member):
            yield from _members_of(member)
        else:
            yield member

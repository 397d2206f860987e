# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a load belongs after an edit, told without the engine: points of its face before, each carried by what the edit did to the feature it is on.

A point on the side or cap of a sweep goes with the sketch's geometry that is nearest to it, and with the sweep's height; one on a primitive keeps its
place relative to the primitive's box. What is on no such feature (a fillet, a pattern, an import) is not judged.
"""
import collections
import functools

import FreeCAD
import Part

NEAR = 2e-4
ACROSS = 7
_PRIMITIVES = ("Part::Box", "Part::Cylinder", "Part::Sphere", "Part::Torus")
_SWEEPS = ("PartDesign::Pad", "PartDesign::Pocket")


def points_of(face):
    """Points spread over a face, none at its border; a narrow face is looked at more closely."""
    for across in (ACROSS, 4 * ACROSS, 16 * ACROSS):
        found = _grid_of(face, across)
        if found:
            break
    return found


def _grid_of(face, across):
    first_u, last_u, first_v, last_v = face.ParameterRange
    found = []
    for i in range(across):
        for j in range(across):
            u, v = first_u + (last_u - first_u) * (i + 0.5) / across, first_v + (last_v - first_v) * (j + 0.5) / across
            if face.isPartOfDomain(u, v):
                found.append(face.valueAt(u, v))
    return found


class BoxedFace:
    """A face and its box, which tells of most points at once that they are not on it."""

    def __init__(self, face):
        self.face, self.box = face, FreeCAD.BoundBox(face.BoundBox)
        self.box.enlarge(NEAR)

    def holds(self, point):
        return self.box.isInside(point) and self.face.distToShape(Part.Vertex(point))[0] < NEAR


class Feature:
    """One feature as it is in the document now, in the part's frame."""

    def __init__(self, obj, part):
        self.name = obj.Name
        in_body = obj.isDerivedFrom("PartDesign::Feature")
        outer = part.Placement if obj is not part else FreeCAD.Placement()
        self.frame = outer.multiply(obj.Placement)
        shape = obj.AddSubShape.copy() if in_body else obj.Shape.copy()
        if not in_body:
            shape.Placement = FreeCAD.Placement()
        self.faces, self.box = shape.Faces, shape.BoundBox
        self.curves = None
        if obj.TypeId in _SWEEPS:
            sketch = obj.Profile[0] if isinstance(obj.Profile, tuple) else obj.Profile
            self.frame = outer.multiply(sketch.Placement)
            to_sketch = sketch.Placement.inverse().multiply(obj.Placement)
            moved = shape.copy()
            moved.Placement = to_sketch.multiply(moved.Placement)
            self.faces, self.box = moved.Faces, moved.BoundBox
            self.curves = [curve.toShape() for curve in sketch.Geometry if not _is_construction(curve)]
        self.faces = [BoxedFace(face) for face in self.faces]

    def sides_at(self, point):
        """Which faces of the feature's own volume the point is on."""
        local = self.frame.inverse().multVec(point)
        return {(self.name, number) for number, face in enumerate(self.faces) if face.holds(local)}

    def carry(self, point, after):
        """To the same place of the feature as it is `after`."""
        local = self.frame.inverse().multVec(point)
        if self.curves is None or after.curves is None or len(self.curves) != len(after.curves):
            return after.frame.multVec(_relative(local, self.box, after.box))
        height = _share(local.z, self.box.ZMin, self.box.ZMax)
        z = after.box.ZMin + height * (after.box.ZMax - after.box.ZMin)
        flat = FreeCAD.Vector(local.x, local.y, 0)
        distances = [curve.distToShape(Part.Vertex(flat)) for curve in self.curves]
        nearest = min(range(len(distances)), key=lambda i: distances[i][0])
        if distances[nearest][0] < NEAR:
            was, now = self.curves[nearest].Edges[0], after.curves[nearest].Edges[0]
            share = _share(was.Curve.parameter(flat), was.FirstParameter, was.LastParameter)
            to = now.valueAt(now.FirstParameter + share * (now.LastParameter - now.FirstParameter))
        else:   # inside a cap: between the curves around it
            was, now = (Part.Compound(f.curves).BoundBox for f in (self, after))
            to = _relative(flat, was, now)
        return after.frame.multVec(FreeCAD.Vector(to.x, to.y, z))


def features_of(part):
    """{name: Feature} of what the oracle knows about."""
    known = part.Group if part.TypeId == "PartDesign::Body" else part.Document.Objects
    found = {}
    for obj in known:
        if obj.TypeId in _PRIMITIVES or obj.TypeId in _SWEEPS or obj.TypeId.startswith(("PartDesign::Additive", "PartDesign::Subtractive")) \
                and obj.TypeId.endswith(("Box", "Cylinder")):
            shape = getattr(obj, "AddSubShape", None) or getattr(obj, "Shape", None)
            if shape is not None and not shape.isNull() and not _is_placed_by_another(obj, part):
                found[obj.Name] = Feature(obj, part)
    return found


def _is_placed_by_another(obj, part):
    """Has a boolean operation between the feature and the part a placement of its own? Those in a body do not place each other."""
    if part.TypeId == "PartDesign::Body":
        return False
    above = [user for user in obj.InList if user.isDerivedFrom("Part::Feature") and user is not part and part in user.InListRecursive]
    return any(not user.Placement.isIdentity() or _is_placed_by_another(user, part) for user in above)


class Oracle:
    """Made before an edit, judges what it did to loads."""

    def __init__(self, part):
        self.part = part
        self.before = features_of(part)
        self.shape = part.Shape.copy()

    @functools.cached_property
    def after(self):
        return features_of(self.part)

    @functools.cached_property
    def faces_after(self):
        return {"Face%d" % number: BoxedFace(face) for number, face in enumerate(self.part.Shape.Faces, 1)}

    def judge(self, old_names, new_names):
        """Of a load that was on faces of the part before and is on others now: "right", "stranger", "not all of it", "lost", "lost, but there" or
        "not judged"."""
        expected, sides, known, total = collections.Counter(), set(), 0, 0
        for name in old_names:
            for point in points_of(self.shape.getElement(name)):
                total += 1
                at = set().union(*(feature.sides_at(point) for feature in self.before.values()))
                carried = self._carried(point, {owner for owner, _ in at})
                sides |= at
                known += bool(carried)
                for place in carried:
                    expected.update(name for name, face in self.faces_after.items() if face.holds(place))
        if known < total or not total:
            return "not judged"
        strangers = [name for name in new_names if not expected[name] and not self._is_on(sides, self.faces_after[name].face)]
        if strangers:
            return "stranger"
        wanted = [name for name, count in expected.items() if count > 0.3 * total]
        if not new_names:
            return "lost, but there" if wanted else "lost"
        return "right" if all(name in new_names for name in wanted) else "not all of it"

    def _carried(self, point, owners):
        """Where the point is now, by each of the features that it was on; empty when one of them is not known any more."""
        if not owners or not owners <= self.after.keys():
            return []
        return [self.before[owner].carry(point, self.after[owner]) for owner in sorted(owners)]

    def _is_on(self, sides, face):
        """Is most of a face of today on those sides of features? So a piece is known that no point of the old face lies on."""
        points = points_of(face)
        owners = sorted({owner for owner, _ in sides} & self.after.keys())
        found = sum(any(sides & self.before[owner].sides_at(self.after[owner].carry(point, self.before[owner])) for owner in owners) for point in points)
        return found > len(points) / 2


def _is_construction(curve):
    import Sketcher
    return Sketcher.GeometryFacade(curve).Construction or isinstance(curve, Part.Point)


def _share(value, low, high):
    return (value - low) / (high - low) if high - low > 1e-9 else 0.5


def _relative(point, was, now):
    return FreeCAD.Vector(*(low + _share(value, first, last) * (high - low) for value, first, last, low, high in (
        (point.x, was.XMin, was.XMax, now.XMin, now.XMax), (point.y, was.YMin, was.YMax, now.YMin, now.YMax),
        (point.z, was.ZMin, was.ZMax, now.ZMin, now.ZMax))))

# SPDX-License-Identifier: GPL-3.0-or-later
"""What the faces, edges, vertices and solids of a part are called after an edit.

Faces are followed by the engine. An edge is known by the faces that meet in it, a vertex likewise (of beams by its edges), a solid by the faces around
it; where these leave a choice, the one that has not moved is meant, or what lies on the line or circle of an edge (which may be split, and longer), or else of those
that have moved the one of the same rank where they moved as one, or that lies among them as it did (of a sheet's free edges, which have the same one face).
"""

import re
from collections import defaultdict

import numpy as np
import Part

_MEMBERS = {"Edge": "Edges", "Vertex": "Vertexes", "Solid": "Solids"}
_SAME_PLACE = 1e-6  # of the part's diagonal
_LINE = "Part::GeomLine"
_GOING_ON = (_LINE, "Part::GeomCircle")   # curves that go on beyond the ends of an edge
_PARALLEL = 1e-6
_NEAR = 0.2         # of a sub-element's own diagonal: how far one may have gone that nothing but FreeCAD knows


class Numbering:
    """Names before the edit and after it; `faces` is what engine.followed_faces gives."""

    def __init__(self, faces, old_shape, new_shape, is_return=False):
        """`old_shape` is a function: it costs time, and is called only for a name that is not a face's. Does it `is_return` to a part of before, of which others may be gone?"""
        self._became, self._was = defaultdict(set), defaultdict(list)
        self._old_shape, self._new_shape, self._is_return = old_shape, new_shape, is_return
        self._within = {face["old_face"]: face["within"] for face in faces}
        self._around = {}  # kind -> (members before, their faces, members after, their faces)
        for face in faces:
            for name in face["new_faces"]:
                self._became[face["old_face"]].add(name)
                self._was[name].append(face["old_face"])

    def now(self, name):
        """Sorted names of what the sub-element became; empty when it is gone or cannot be told."""
        kind, number = re.match(r"([A-Za-z]+)(\d+)$", name).groups()
        if kind == "Face":
            return sorted(self._became.get(name, ()), key=lambda face: int(face[len("Face"):]))
        olds, old_faces, news, new_faces = self._both(kind)
        index = int(number) - 1
        if index >= len(olds):
            return []
        if kind == "Solid":
            return ["Solid%d" % (i + 1) for i in self._solids_now(index)]
        images = [set(self.now(face)) for face in old_faces[index]]
        found = [i for i, around in enumerate(new_faces) if len(around) == len(images) and all(image & around for image in images)]
        alike = [i for i, around in enumerate(old_faces) if around == old_faces[index]]
        tolerance = _SAME_PLACE * self._new_shape.BoundBox.DiagonalLength
        others = [olds[i] for i in alike if i != index]
        is_sure = len(found) == 1 and (len(images) > 1 or not others) and not any(_same_place(other, news[found[0]], tolerance) for other in others)
        if not is_sure:
            within = found if self._new_shape.Faces and found else range(len(news))   # another beam may begin at a corner
            staying = [i for i in within if _same_place(olds[index], news[i], tolerance)]
            if kind == "Edge" and not staying:
                pieces = _pieces(index, alike, found, olds, news, tolerance)
                if pieces:
                    return ["%s%d" % (kind, i + 1) for i in pieces]
                alike, found = _left(index, alike, found, olds, news, tolerance) if len(alike) != len(found) else (alike, found)
            is_choice = len(staying) != 1 and 0 < len(alike) == len(found)
            found = self._lying_alike(index, alike, found, olds, news) if is_choice else staying
        return ["%s%d" % (kind, found[0] + 1)] if len(found) == 1 else []

    def _solids_now(self, index):
        """Indices of the solid after that has most faces of the one before, unless it has more of another before, which is around this one; and of its other pieces, which
        have faces of no other."""
        olds, old_faces, news, new_faces = self._both("Solid")
        images = [set().union(*(self._became.get(face, set()) for face in around)) for around in old_faces]
        others, followed = images[:index] + images[index + 1:], set().union(*images)
        shared = [len(images[index] & around) for around in new_faces]
        best = [i for i, count in enumerate(shared) if count and count == max(shared) and all(len(other & new_faces[i]) <= count for other in others)]
        tolerance = _SAME_PLACE * self._new_shape.BoundBox.DiagonalLength
        staying = [i for i in best or range(len(news)) if _same_place(olds[index], news[i], tolerance)]
        pieces = [i for i, count in enumerate(shared) if count and followed & new_faces[i] <= images[index]
                  and all(len(other & new_faces[i]) < count or images[index] < other for other in others)]   # of a core the solid around it has all faces, too
        alone = images[index].difference(*others)
        pieces = [i for i in pieces if not any(alone & new_faces[i] & around for k, around in enumerate(new_faces) if k not in pieces)]   # another solid came to be around it
        if len(staying) == 1:
            return staying
        return sorted({*pieces, *best}) if len(best) == 1 else pieces

    def _lying_alike(self, index, alike, found, olds, news):
        """Of as many members after as before, all with the same faces, the one of the same rank where those that are not where they were moved as one, else the one that lies
        among them as `index` did; none where that leaves a choice."""
        before, after = _measures([olds[i] for i in alike]), _measures([news[i] for i in found])
        is_same_place = _distances(before, after) <= _SAME_PLACE * self._new_shape.BoundBox.DiagonalLength
        moved, to = np.flatnonzero(~is_same_place.any(axis=1)), np.flatnonzero(~is_same_place.any(axis=0))
        if alike.index(index) not in moved or len(moved) != len(to):
            return []
        rank = list(moved).index(alike.index(index))
        if not _are_moved_as_one(before[moved], after[to]):
            if self._is_return and not self._new_shape.Faces:
                return []
            chosen = np.argmin(_distances(_places_among(before[moved]), _places_among(after[to])), axis=1)
            if len(set(chosen)) != len(to):
                return []
            rank = chosen[rank]
        return [found[to[rank]]]

    def was(self, name):
        """Names of the faces before that are in the face `name` now; empty for anything but a face."""
        return self._was.get(name, [])

    def within(self, name):
        """Names of the pieces of the face `name` before that came to lie between two solids; nothing for anything but a face."""
        return self._within.get(name, [])

    def may_be(self, old, new):
        """Can the sub-element before be the one now, as far as place and size tell? Faces must be of one kind, too."""
        was, now = self._shape_before().getElement(old), self._new_shape.getElement(new)
        size = was.BoundBox.DiagonalLength
        return (was.ShapeType == now.ShapeType and (was.ShapeType != "Face" or was.Surface.TypeId == now.Surface.TypeId)
                and (was.BoundBox.Center - now.BoundBox.Center).Length <= _NEAR * size and abs(now.BoundBox.DiagonalLength - size) <= _NEAR * size)

    def _shape_before(self):
        if callable(self._old_shape):
            self._old_shape = self._old_shape()
        return self._old_shape

    def _both(self, kind):
        if kind not in self._around:
            self._around[kind] = _around(self._shape_before(), _MEMBERS[kind]) + _around(self._new_shape, _MEMBERS[kind])
        return self._around[kind]


def _around(shape, members):
    """The edges, vertices or solids of a shape, and for each the names of the faces that it belongs to or that belong to it."""
    all_of_kind = getattr(shape, members)
    around = [set() for _ in all_of_kind]
    names = defaultdict(list)
    for number, face in enumerate(shape.Faces, 1):
        names[face.hashCode()].append((face, "Face%d" % number))
    if members == "Solids":
        for index, solid in enumerate(all_of_kind):
            around[index] = {_name(face, names) for face in solid.Faces}
        return all_of_kind, around
    known = defaultdict(list)
    for index, member in enumerate(all_of_kind):
        known[member.hashCode()].append((member, index))
    above = [("Face%d", shape.Faces)] + ([("Edge%d", shape.Edges)] if members == "Vertexes" and not shape.Faces else [])   # the corners of beams are known by their edges
    for name, entities in above:
        for number, entity in enumerate(entities, 1):
            for member in getattr(entity, members):
                around[_name(member, known)].add(name % number)
    return all_of_kind, around


def _measures(members):
    """Of edges or vertices: place and length, (n,4) mm."""
    return np.array([(*member.Point, 0) if member.ShapeType == "Vertex" else (*member.CenterOfMass, member.Length) for member in members])


def _distances(before, after):
    return np.linalg.norm(before[:, None] - after, axis=2)


def _are_moved_as_one(before, after):
    """Are the distances from one another, and the lengths, what they were?"""
    was, now = (np.column_stack([_distances(measures, measures), measures[:, 3]]) for measures in (before, after))
    return np.allclose(was, now, rtol=0, atol=_SAME_PLACE * np.max(was))


def _name(member, known):
    return next(name for other, name in known[member.hashCode()] if other.isSame(member))


def _places_among(measures):
    """Where each lies among all of them, in shares of how far they reach."""
    places = measures[:, :3] - measures[:, :3].mean(axis=0)
    return places / (np.max(np.linalg.norm(places, axis=1)) or 1)


def _pieces(index, alike, found, olds, news, tolerance):
    """Which of `found` lie on the curve of an edge, as far as that goes, or within the edge where others of its kind are on that curve, too."""
    edge = olds[index]
    is_alone = not any(_lies_on_curve(olds[i], edge, tolerance) for i in alike if i != index)
    lies_on = _lies_on_curve if is_alone else _lies_on
    return [i for i in found if lies_on(news[i], edge, tolerance) and not any(_same_place(old, news[i], tolerance) for old in olds)]


def _left(index, alike, found, olds, news, tolerance):
    """The members before and after that lie on no curve of the other side, and whose curves are as that of `index`."""
    before = [i for i in alike if not any(_lies_on_curve(news[j], olds[i], tolerance) for j in found)]
    after = [j for j in found if not any(_lies_on_curve(news[j], olds[i], tolerance) for i in alike)]
    return [i for i in before if _has_like_curve(olds[i], olds[index])], [j for j in after if _has_like_curve(news[j], olds[index])]


def _lies_on(piece, edge, tolerance):
    return all(edge.distToShape(Part.Vertex(point))[0] <= tolerance for point in _points_of(piece))


def _lies_on_curve(piece, edge, tolerance):
    """Likewise, but beyond the edge's ends, too, where its curve goes on."""
    if edge.Degenerated or edge.Curve.TypeId not in _GOING_ON:
        return _lies_on(piece, edge, tolerance)
    curve = edge.Curve
    return all((curve.value(curve.parameter(point)) - point).Length <= tolerance for point in _points_of(piece))


def _points_of(edge):
    first, last = edge.ParameterRange
    return [edge.valueAt(at) for at in (first, (first + last) / 2, last)]


def _has_like_curve(edge, other):
    """Are both straight and parallel, or arcs of one radius?"""
    if edge.Degenerated or other.Degenerated or edge.Curve.TypeId != other.Curve.TypeId:
        return False
    one, two = edge.Curve, other.Curve
    return one.TypeId in _GOING_ON and (one.Direction.cross(two.Direction).Length <= _PARALLEL if one.TypeId == _LINE else abs(one.Radius - two.Radius) <= _PARALLEL * two.Radius)


def _same_place(old, new, tolerance):
    if old.ShapeType == "Vertex":
        return (old.Point - new.Point).Length <= tolerance
    return (old.CenterOfMass - new.CenterOfMass).Length <= tolerance and abs(old.Length - new.Length) <= tolerance

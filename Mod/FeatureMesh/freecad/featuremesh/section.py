# SPDX-License-Identifier: GPL-3.0-or-later
"""What is seen of a mesh: its surface, or what a plane cuts it open to. Needs neither FreeCAD nor the engine."""

from dataclasses import dataclass

import numpy as np

# The corners of each side of a tet, seen from outside in the order of the clock's opposite, and of each edge, in the order of
# the mid-side nodes.
SIDES = np.array(((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)))
EDGES = np.array(((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3)))
AXES = {"x": 0, "y": 1, "z": 2}


@dataclass(frozen=True)
class Plane:
    """Through `origin`; what lies on the side that `normal` points to is cut away."""
    origin: tuple
    normal: tuple

    def heights(self, points):
        """(n,) of points above the plane, mm."""
        return (np.asarray(points) - np.asarray(self.origin)) @ np.asarray(self.normal)


def plane_across(axis, place, keeps_above=False):
    """The plane across an axis "x", "y" or "z" at `place` mm; what lies below it stays, or what lies above."""
    origin, normal = [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]
    origin[AXES[axis]], normal[AXES[axis]] = float(place), -1.0 if keeps_above else 1.0
    return Plane(tuple(origin), tuple(normal))


def plane_from_text(text):
    """The plane that "z=5" or "z<5" says (what is below stays) and "z>5" (what is above). Throws ValueError."""
    for sign in "=<>":
        axis, found, place = text.replace(" ", "").partition(sign)
        if found and axis in AXES and np.isfinite(float(place)):
            return plane_across(axis, float(place), keeps_above=sign == ">")
    raise ValueError("a plane is x=, y= or z= a number, not %r" % text)


class SeenMesh:
    """The triangles to draw of a mesh; `tets` are (m,4). What a plane needs is found when it is first asked for."""

    def __init__(self, points, tets):
        self.points, self.tets = points, tets
        self._sides = self._surface = None

    def surface(self, on_surface=None):
        """(k,3) triangles of the outside, and (k,) the tets they are of; with (n,) bool of the nodes on it where known, which is faster."""
        if on_surface is None:
            return outer_triangles(self.tets)
        rows = np.flatnonzero(on_surface[self.tets].sum(axis=1) >= 3)
        triangles = self.tets[rows][:, SIDES].reshape(-1, 3)
        there = np.flatnonzero(on_surface[triangles].all(axis=1))
        single = np.flatnonzero(_once(triangles[there]))
        return triangles[there[single]], rows[there[single] // 4]

    def cut_open(self, on_surface=None, plane=None, is_filled=False):
        """All that is seen: (k,3,3) corners of triangles, mm, and (k,) the tets they are of; whole elements, or with the cut filled."""
        if self._surface is None:
            self._surface = self.surface(on_surface)
        if plane is None:
            return self.points[self._surface[0]], self._surface[1]
        if not is_filled:
            triangles, owners = self.whole(plane)
            return self.points[triangles], owners
        rest, cut = self.clipped_surface(plane, *self._surface), self.filled(plane)
        return tuple(np.concatenate(parts) for parts in zip(rest, cut))

    def whole(self, plane):
        """The outside of the tets whose middle the plane leaves, as for `surface`."""
        stays = plane.heights(self.points[self.tets].mean(axis=1)) <= 0
        triangles, first, second = self._all_sides()
        one, other = stays[first], (second >= 0) & stays[second]
        ahead, behind = one & ~other, other & ~one
        return (np.concatenate([triangles[ahead], triangles[behind][:, ::-1]]), np.concatenate([first[ahead], second[behind]]))

    def filled(self, plane):
        """(k,3,3) triangles of the cut itself, mm, facing where the normal points, and (k,) the tets they are of."""
        heights = plane.heights(self.points)
        above = heights[self.tets] > 0
        count = above.sum(axis=1)
        corners, owners = [], []
        for number_above in (1, 2, 3):
            rows = np.flatnonzero(count == number_above)
            if len(rows):
                polygons = self._cut_edges(rows, above[rows], heights)
                for triangle in ((0, 1, 2), (0, 2, 3))[:polygons.shape[1] - 2]:
                    corners.append(polygons[:, triangle])
                    owners.append(rows)
        if not corners:
            return np.zeros((0, 3, 3)), np.zeros(0, dtype=np.int64)
        return _facing(np.concatenate(corners), plane.normal), np.concatenate(owners)

    def clipped_surface(self, plane, triangles, owners):
        """Of (k,3) triangles the part that the plane leaves: (j,3,3) mm, and (j,) owners."""
        heights = plane.heights(self.points)[triangles]
        stays = (heights <= 0).all(axis=1)
        corners, kept = [self.points[triangles[stays]]], [owners[stays]]
        for below in (1, 2):
            rows = np.flatnonzero((heights <= 0).sum(axis=1) == below)
            if not len(rows):
                continue
            # the one corner on its side first, the others in their order
            is_lone = (heights[rows] <= 0) if below == 1 else (heights[rows] > 0)
            order = (np.argmax(is_lone, axis=1)[:, None] + np.arange(3)) % 3
            nodes, h = np.take_along_axis(triangles[rows], order, axis=1), np.take_along_axis(heights[rows], order, axis=1)
            lone, second, third = (self.points[nodes[:, i]] for i in range(3))
            at_second, at_third = _between(lone, second, h[:, 0], h[:, 1]), _between(lone, third, h[:, 0], h[:, 2])
            if below == 1:
                corners.append(np.stack([lone, at_second, at_third], axis=1))
                kept.append(owners[rows])
            else:
                corners += [np.stack([at_second, second, third], axis=1), np.stack([at_second, third, at_third], axis=1)]
                kept += [owners[rows], owners[rows]]
        return np.concatenate(corners), np.concatenate(kept)

    def _cut_edges(self, rows, above, heights):
        """(k,3,3) or (k,4,3): where the plane meets the edges of tets that it divides alike, around the cut."""
        crossed = above[:, EDGES[:, 0]] != above[:, EDGES[:, 1]]
        count = int(crossed[0].sum())
        edges = np.argsort(~crossed, axis=1, kind="stable")[:, :count]
        if count == 4:   # around the cut: opposite edges of the tet (01 23, 12 03, 02 13) are not neighbours
            order = np.where(edges[:, :1] == 1, [[0, 1, 2, 3]], [[0, 1, 3, 2]])
            edges = np.take_along_axis(edges, order, axis=1)
        ends = self.tets[rows][np.arange(len(rows))[:, None, None], EDGES[edges]]
        first, second = ends[:, :, 0], ends[:, :, 1]
        return _between(self.points[first], self.points[second], heights[first], heights[second])

    def _all_sides(self):
        """(s,3) triangles of all sides, seen from outside their first tet, with that and their second tet or -1."""
        if self._sides is None:
            sides = self.tets[:, SIDES].reshape(-1, 3)
            key = _keys(sides)
            order = np.argsort(key, kind="stable")
            is_first = np.ones(len(order), dtype=bool)
            is_first[1:] = key[order[1:]] != key[order[:-1]]
            first = order[is_first]
            second = np.full(len(first), -1, dtype=np.int64)
            twins = np.flatnonzero(~is_first)
            second[np.cumsum(is_first)[twins] - 1] = order[twins] // 4
            self._sides = sides[first], first // 4, second
        return self._sides


class SeenSheet(SeenMesh):
    """The same of a mesh of triangles (m,3), which are their own outside."""

    def surface(self, on_surface=None):
        return self.tets, np.arange(len(self.tets))

    def whole(self, plane):
        rows = np.flatnonzero(plane.heights(self.points[self.tets].mean(axis=1)) <= 0)
        return self.tets[rows], rows

    def filled(self, plane):
        """A sheet has no inside."""
        return np.zeros((0, 3, 3)), np.zeros(0, dtype=np.int64)


def seen_of(points, elements):
    """What is seen of tets (m,4) or triangles (m,3)."""
    return (SeenSheet if elements.shape[1] == 3 else SeenMesh)(points, elements)


def outer_triangles(tets):
    """(k,3) triangles that belong to one tet only, seen from outside, and (k,) their tets."""
    sides = tets[:, SIDES].reshape(-1, 3)
    chosen = np.flatnonzero(_once(sides))
    return sides[chosen], chosen // 4


def _once(sides):
    """(k,) bool: whose three nodes no other one has."""
    key = _keys(sides)
    order = np.argsort(key, kind="stable")
    key = key[order]
    once = np.ones(len(key), dtype=bool)
    once[1:] &= key[1:] != key[:-1]
    once[:-1] &= key[:-1] != key[1:]
    result = np.empty(len(key), dtype=bool)
    result[order] = once
    return result


def _keys(sides):
    """One number for each set of three nodes."""
    ordered = np.sort(sides, axis=1).astype(np.int64)
    count = int(ordered.max()) + 1 if len(ordered) else 1
    return (ordered[:, 0] * count + ordered[:, 1]) * count + ordered[:, 2]


def _between(p, q, height_p, height_q):
    """Where lines from p to q meet the plane, given the heights of their ends."""
    share = height_p / (height_p - height_q)
    return p + share[..., None] * (q - p)


def _facing(corners, normal):
    """The triangles, each seen from where the normal points."""
    turned = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) @ np.asarray(normal) < 0
    corners[turned] = corners[turned][:, ::-1]
    return corners

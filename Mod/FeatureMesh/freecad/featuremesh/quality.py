# SPDX-License-Identifier: GPL-3.0-or-later
"""How good tets and triangles are, by the measures of the field. Needs neither FreeCAD nor the engine.

A measure gets points (n,3) mm and tets (m,4), or (m,10) with mid-side nodes 01, 12, 02, 03, 13, 23, or triangles (m,3), or (m,6) with mid-side
nodes 01, 12, 20, and gives (m,) values. All are of the corners alone, but for the Jacobian of curved elements.
"""

from dataclasses import dataclass
from typing import Callable

import numpy as np

_EDGES = ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))   # in the order of their mid-side nodes
# From bad to good.
COLOURS = ((0.75, 0.10, 0.10), (0.88, 0.35, 0.13), (0.97, 0.65, 0.20), (0.95, 0.85, 0.35), (0.60, 0.80, 0.40), (0.25, 0.62, 0.30))
# From too small to too large, what is right in the middle.
SIZE_COLOURS = ((0.20, 0.25, 0.70), (0.40, 0.65, 0.90), (0.25, 0.62, 0.30), (0.25, 0.62, 0.30), (0.97, 0.65, 0.20), (0.75, 0.10, 0.10))


def dihedral_angle(points, elements):
    """Smallest angle between two sides, degrees; 70.5 for a regular tet, 60 for a regular triangle."""
    return _corners_of(points, elements).extreme_angles()[0]


def radius_ratio(points, elements):
    """Three times (for a triangle, twice) the inscribed over the circumscribed radius; 1 for a regular element, 0 for a flat one."""
    corner = _corners_of(points, elements)
    return corner.dimension * corner.in_radius() / corner.circum_radius()


def aspect_ratio(points, elements):
    """The longest edge over the inscribed radius, divided by what a regular element has (2 sqrt 6, for a triangle 2 sqrt 3); 1 at best."""
    corner = _corners_of(points, elements)
    return corner.edge_lengths().max(axis=1) / (corner.regular_aspect * _positive(corner.in_radius()))


def scaled_jacobian(points, elements):
    """The least, over the corners, of the Jacobian over the product of the edge lengths there, divided by what a regular element has (1 / sqrt 2,
    for a triangle sqrt 3 / 2); negative for one inside out, and for a triangle folded against its corners' plane. In elements with mid-side nodes the
    edges at a corner are the tangents of the curved sides."""
    return _scaled_jacobian_of_triangles(points, elements) if _are_triangles(elements) else _scaled_jacobian_of_tets(points, elements)


def _scaled_jacobian_of_tets(points, tets):
    tangents = _tangents_at_corners(points, tets)
    worst = np.full(len(tets), np.inf)
    for a, b, c in tangents:
        lengths = np.sqrt(np.prod([np.einsum("ij,ij->i", edge, edge) for edge in (a, b, c)], axis=0))
        worst = np.minimum(worst, np.einsum("ij,ij->i", a, _cross(b, c)) / _positive(lengths))
    return np.sqrt(2) * worst


def skewness(points, elements):
    """1 minus the volume (area) over that of the regular element with the same circumscribed ball (circle); 0 at best, 1 for a flat element."""
    corner = _corners_of(points, elements)
    return 1 - corner.content() / _positive(corner.regular_content * corner.circum_radius() ** corner.dimension)


def mean_edge_length(points, elements):
    """Mean length of the edges, mm; of segments (m,2) their own."""
    if elements.shape[1] == 2:
        return np.linalg.norm(points[elements[:, 1]] - points[elements[:, 0]], axis=1)
    return _corners_of(points, elements).edge_lengths().mean(axis=1)


def contents(points, elements):
    """(m,) volumes of tets (m,4), mm^3, negative inside out; areas of triangles (m,3), mm^2; lengths of segments (m,2), mm."""
    a, *rest = (points[elements[:, i]] - points[elements[:, 0]] for i in range(1, elements.shape[1]))
    if not rest:
        return np.linalg.norm(a, axis=1)
    across = _cross(a, rest[0])
    return np.linalg.norm(across, axis=1) / 2 if len(rest) == 1 else np.einsum("ij,ij->i", across, rest[1]) / 6


def tet_quality(points, tets):
    """(m,) smallest and (m,) largest dihedral angle, degrees, and (m,) radius ratio 3 r / R of each tet."""
    corner = _Corners(points, tets)
    return (*corner.extreme_angles(), 3 * corner.in_radius() / corner.circum_radius())


def _are_triangles(elements):
    return elements.shape[1] in (3, 6)


def _corners_of(points, elements):
    return (_TriangleCorners if _are_triangles(elements) else _Corners)(points, elements)


def _degrees(cosines):
    return np.degrees(np.arccos(np.clip(cosines, -1, 1)))


@dataclass(frozen=True)
class Measure:
    """One measure of quality, and how it is shown."""
    title: str
    values: Callable        # None for what is measured against the wanted size, see overlays.values_of
    limits: tuple           # what is bad, what is good; both ends are too small and too large where `is_centred`
    digits: int
    unit: str = ""
    is_centred: bool = False

    def shares(self, values, limits=None):
        """(m,) 0 for bad to 1 for good."""
        bad, good = limits or self.limits
        return np.clip((values - bad) / (good - bad), 0, 1)

    def colours(self, values, limits=None):
        """(m,3) one of six colours each."""
        table = np.array(SIZE_COLOURS if self.is_centred else COLOURS)
        return table[np.minimum((self.shares(values, limits) * len(table)).astype(int), len(table) - 1)]

    def in_words(self, value):
        """A value with its digits and unit."""
        return "%.*f%s" % (self.digits, value, self.unit)

    def worst(self, values, count):
        """The rows of the worst, worst first."""
        badness = -np.abs(np.log(np.maximum(values, 1e-12))) if self.is_centred else values if self.limits[1] > self.limits[0] else -values
        return np.argsort(badness, kind="stable")[:count]

    def count_bad(self, values, limits=None):
        """How many are beyond the limit of what is bad."""
        bad, good = limits or self.limits
        if self.is_centred:
            return int(((values < min(bad, good)) | (values > max(bad, good))).sum())
        return int((values < bad).sum() if good > bad else (values > bad).sum())


MEASURES = {
    "dihedral_angle": Measure("smallest dihedral angle", dihedral_angle, (0.0, 60.0), 2, " deg"),
    "radius_ratio": Measure("radius ratio", radius_ratio, (0.0, 0.9), 3),
    "aspect_ratio": Measure("aspect ratio", aspect_ratio, (7.0, 1.0), 2),
    "scaled_jacobian": Measure("scaled Jacobian", scaled_jacobian, (0.0, 0.9), 3),
    "skewness": Measure("skewness", skewness, (0.95, 0.05), 3),
    "size_ratio": Measure("edge length over wanted length", None, (0.4, 1.6), 3, is_centred=True),
}


class _Corners:
    """What the measures need of the corners of tets."""

    dimension, regular_aspect, regular_content = 3, 2 * np.sqrt(6), 8 * np.sqrt(3) / 27

    def __init__(self, points, tets):
        self.p = points[tets[:, :4]]
        a, b, c = (self.p[:, i] - self.p[:, 0] for i in (1, 2, 3))
        self.bc, self.ca, self.ab = _cross(b, c), _cross(c, a), _cross(a, b)
        self.six_volumes = np.einsum("ij,ij->i", a, self.bc)
        self.squares = [np.einsum("ij,ij->i", edge, edge)[:, None] for edge in (a, b, c)]
        # of the sides 1 2 3, 0 3 2, 0 1 3, 0 2 1, outwards; the four add up to nothing
        self.normals = [self.bc + self.ca + self.ab, -self.bc, -self.ca, -self.ab]
        self.double_areas = [np.sqrt(np.einsum("ij,ij->i", normal, normal)) for normal in self.normals]

    def content(self):
        """Volumes, mm^3."""
        return self.six_volumes / 6

    def extreme_angles(self):
        """(m,) smallest and (m,) largest dihedral angle, degrees."""
        cosines = [-np.einsum("ij,ij->i", self.normals[i], self.normals[j]) / _positive(self.double_areas[i] * self.double_areas[j])
                   for i in range(4) for j in range(i + 1, 4)]
        return _degrees(np.max(cosines, axis=0)), _degrees(np.min(cosines, axis=0))

    def edge_lengths(self):
        edges = [self.p[:, i] - self.p[:, j] for i, j in _EDGES]
        return np.sqrt(np.stack([np.einsum("ij,ij->i", edge, edge) for edge in edges], axis=1))

    def in_radius(self):
        return self.six_volumes / _positive(sum(self.double_areas))

    def circum_radius(self):
        """Infinite for a flat tet."""
        sum_ = self.squares[0] * self.bc + self.squares[1] * self.ca + self.squares[2] * self.ab
        with np.errstate(divide="ignore"):
            return np.linalg.norm(sum_, axis=1) / np.abs(2 * self.six_volumes)


class _TriangleCorners:
    """What the measures need of the corners of triangles."""

    dimension, regular_aspect, regular_content = 2, 2 * np.sqrt(3), 3 * np.sqrt(3) / 4

    def __init__(self, points, triangles):
        p = points[triangles[:, :3]]
        self._edges = [p[:, (i + 1) % 3] - p[:, i] for i in range(3)]
        self._lengths = np.stack([np.linalg.norm(edge, axis=1) for edge in self._edges], axis=1)
        self._double_areas = np.linalg.norm(_cross(self._edges[0], self._edges[1]), axis=1)

    def content(self):
        """Areas, mm^2."""
        return self._double_areas / 2

    def extreme_angles(self):
        """(m,) smallest and (m,) largest angle at a corner, degrees."""
        cosines = [-np.einsum("ij,ij->i", self._edges[i], self._edges[i - 1]) / _positive(self._lengths[:, i] * self._lengths[:, i - 1])
                   for i in range(3)]
        return _degrees(np.max(cosines, axis=0)), _degrees(np.min(cosines, axis=0))

    def edge_lengths(self):
        return self._lengths

    def in_radius(self):
        return self._double_areas / _positive(self._lengths.sum(axis=1))

    def circum_radius(self):
        """Infinite for a flat triangle."""
        with np.errstate(divide="ignore"):
            return self._lengths.prod(axis=1) / (2 * self._double_areas)


def _scaled_jacobian_of_triangles(points, triangles):
    p = [points[triangles[:, i]] for i in range(triangles.shape[1])]
    straight = _cross(p[1] - p[0], p[2] - p[0])
    straight /= _positive(np.linalg.norm(straight, axis=1))[:, None]
    worst = np.full(len(triangles), np.inf)
    for corner in range(3):
        first, second = (corner + 1) % 3, (corner + 2) % 3
        if len(p) == 3:
            a, b = p[first] - p[corner], p[second] - p[corner]
        else:   # of the quadratic curves through the middles
            a, b = (4 * p[3 + mid] - 3 * p[corner] - p[other] for other, mid in ((first, corner), (second, second)))
        lengths = np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1)
        worst = np.minimum(worst, np.einsum("ij,ij->i", _cross(a, b), straight) / _positive(lengths))
    return 2 / np.sqrt(3) * worst


def _cross(a, b):
    """As numpy's, several times as fast on rows."""
    return np.stack([a[:, 1] * b[:, 2] - a[:, 2] * b[:, 1], a[:, 2] * b[:, 0] - a[:, 0] * b[:, 2],
                     a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]], axis=1)


def _positive(values):
    return np.maximum(values, np.finfo(float).tiny)


def _tangents_at_corners(points, tets):
    """At each corner the derivatives of the tet's mapping along its three edges, (m,3) each, so ordered that a sound tet has positive determinants."""
    others = ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))
    p = [points[tets[:, i]] for i in range(tets.shape[1])]
    if len(p) == 4:
        return [[p[other] - p[corner] for other in others[corner]] for corner in range(4)]
    middle = {frozenset(edge): p[4 + index] for index, edge in enumerate(_EDGES)}
    # of the quadratic curve through the middle
    return [[4 * middle[frozenset((corner, other))] - 3 * p[corner] - p[other] for other in others[corner]] for corner in range(4)]

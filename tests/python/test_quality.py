# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures of quality against values known from geometry, and cuts through a mesh against its volume. Runs in plain Python."""
import itertools
import sys
import unittest
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).resolve().parents[2] / "Mod" / "FeatureMesh" / "freecad" / "featuremesh"))

from quality import MEASURES, scaled_jacobian  # noqa: E402
from section import SeenMesh, plane_across, plane_from_text, Plane, seen_of  # noqa: E402

BEST = {"dihedral_angle": np.degrees(np.arccos(1 / 3)), "radius_ratio": 1, "aspect_ratio": 1, "scaled_jacobian": 1, "skewness": 0}
REGULAR = np.array(((1, 1, 1), (1, -1, -1), (-1, -1, 1), (-1, 1, -1)), dtype=float)
CORNER = np.array(((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)), dtype=float)
ONE = np.array([[0, 1, 2, 3]])
TRIANGLE = np.array(((0, 0, 0), (1, 0, 0), (0.5, np.sqrt(0.75), 0)))
THREE_FOUR_FIVE = np.array(((0, 0, 0), (3, 0, 0), (0, 4, 0)), dtype=float)
PAIRS = ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))
N = 6


def volumes(points, tets):
    p = points[tets[:, :4]]
    return np.linalg.det(p[:, 1:] - p[:, :1]) / 6


def oriented(points, tets):
    return np.where((volumes(points, tets) < 0)[:, None], tets[:, [1, 0, 2, 3]], tets)


def grid():
    """A cube of N^3 cubes of six tets, its inner nodes shaken a little, the same each time."""
    random = np.random.default_rng(7)
    points = np.stack(np.meshgrid(*[np.arange(N + 1.0)] * 3, indexing="ij"), -1).reshape(-1, 3)
    inner = ((points > 0) & (points < N)).all(axis=1)
    points[inner] += random.uniform(-0.15, 0.15, (inner.sum(), 3))
    cubes = np.stack(np.meshgrid(*[np.arange(N)] * 3, indexing="ij"), -1).reshape(-1, 3)
    tets = []
    for order in itertools.permutations(range(3)):
        steps = np.zeros((4, 3), dtype=int)
        for row, axis in enumerate(order):
            steps[row + 1:, axis] = 1
        places = cubes[:, None] + steps
        tets.append((places[..., 0] * (N + 1) + places[..., 1]) * (N + 1) + places[..., 2])
    return points, oriented(points, np.concatenate(tets))


def with_middles(points, tets):
    middles = np.array([[points[tet[i]] / 2 + points[tet[j]] / 2 for i, j in PAIRS] for tet in tets])
    numbers = len(points) + np.arange(6 * len(tets)).reshape(-1, 6)
    return np.vstack([points, middles.reshape(-1, 3)]), np.hstack([tets, numbers])


def enclosed(corners):
    """Volume within (k,3,3) triangles seen from outside."""
    return np.linalg.det(corners).sum() / 6


class Measures(unittest.TestCase):
    def test_a_regular_tet_is_the_best_of_all(self):
        regular, (points, tets) = oriented(REGULAR, ONE), grid()
        for name, best in BEST.items():
            self.assertAlmostEqual(MEASURES[name].values(REGULAR, regular)[0], best, 9, name)
            values, sign = MEASURES[name].values(points, tets), np.sign(MEASURES[name].limits[1] - MEASURES[name].limits[0])
            self.assertTrue((sign * values < sign * best).all(), name)

    def test_the_corner_of_a_cube(self):
        found = {name: MEASURES[name].values(CORNER, ONE)[0] for name in BEST}
        inscribed, circumscribed = 1 / (3 + np.sqrt(3)), np.sqrt(3) / 2
        self.assertAlmostEqual(found["dihedral_angle"], np.degrees(np.arctan(np.sqrt(2))))
        self.assertAlmostEqual(found["radius_ratio"], 3 * inscribed / circumscribed)
        self.assertAlmostEqual(found["aspect_ratio"], np.sqrt(2) / (2 * np.sqrt(6) * inscribed))
        self.assertAlmostEqual(found["scaled_jacobian"], np.sqrt(2) / 2)
        self.assertAlmostEqual(found["skewness"], 1 - (1 / 6) / (8 * np.sqrt(3) / 27 * circumscribed ** 3))

    def test_neither_place_nor_scale_nor_turn_counts(self):
        points, tets = grid()
        turn, _ = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))
        turn *= np.sign(np.linalg.det(turn))
        for name in BEST:
            values = MEASURES[name].values
            np.testing.assert_allclose(values(points, tets), values(1e-3 * points @ turn + 5, tets), rtol=1e-6, atol=1e-7, err_msg=name)

    def test_flat_and_inside_out(self):
        flat = np.array(((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 1e-9)), dtype=float)
        for name in BEST:
            value = MEASURES[name].values(flat, oriented(flat, ONE))[0]
            self.assertTrue(np.isfinite(value) and MEASURES[name].shares(np.array([value]))[0] < 1e-3, (name, value))
        self.assertLess(scaled_jacobian(CORNER, ONE[:, [1, 0, 2, 3]])[0], 0)

    def test_a_curved_tet_is_judged_by_its_tangents(self):
        points, tets = with_middles(CORNER, ONE)
        self.assertAlmostEqual(scaled_jacobian(points, tets)[0], np.sqrt(2) / 2)
        points[4] = (0.1, 0.4, 0)   # the side 01 bends until it runs back at its end
        self.assertLess(scaled_jacobian(points, tets)[0], 0)

    def test_limits_colours_and_the_worst(self):
        for name, measure in MEASURES.items():
            bad, good = measure.limits
            values = np.linspace(min(measure.limits), max(measure.limits), 25)
            colours = measure.colours(np.array([bad, good]))
            self.assertFalse(np.array_equal(*colours), name)
            worst = measure.worst(values, 25)
            self.assertEqual(sorted(worst), list(range(25)))
            if not measure.is_centred:
                self.assertEqual(values[worst[0]], bad)
                self.assertEqual(measure.count_bad(values, (values[12], good)), 12)
        ratios = np.array([0.9, 1.0, 0.5, 1.2, 3.0])
        self.assertEqual(MEASURES["size_ratio"].worst(ratios, 3).tolist(), [4, 2, 3])
        self.assertEqual(MEASURES["size_ratio"].count_bad(ratios), 1)


class Cuts(unittest.TestCase):
    def setUp(self):
        self.points, self.tets = grid()
        self.seen = SeenMesh(self.points, self.tets)
        on_surface = ((self.points == 0) | (self.points == N)).any(axis=1)
        self.triangles, self.owners = self.seen.surface(on_surface)

    def test_the_surface_is_the_same_either_way(self):
        triangles, owners = self.seen.surface()
        self.assertEqual(sorted(map(tuple, np.column_stack([triangles, owners]).tolist())),
                         sorted(map(tuple, np.column_stack([self.triangles, self.owners]).tolist())))
        self.assertEqual(len(triangles), 6 * 2 * N * N)
        self.assertAlmostEqual(enclosed(self.points[triangles]), N ** 3)

    def test_whole_elements_enclose_their_volume(self):
        for plane in self.planes():
            triangles, owners = self.seen.whole(plane)
            stays = plane.heights(self.points[self.tets].mean(axis=1)) <= 0
            self.assertAlmostEqual(enclosed(self.points[triangles]), volumes(self.points, self.tets)[stays].sum())
            self.assertTrue(stays[owners].all())
            self.assertTrue(all(set(triangle) < set(self.tets[owner]) for triangle, owner in zip(triangles.tolist(), owners.tolist())))

    def test_a_filled_cut_and_the_rest_enclose_what_is_left(self):
        for plane, left in zip(self.planes(), (N * N * 2.3, N * N * (N - 4.25), N ** 3 / 2, N * N * 3, 0, N ** 3)):
            cut, owners = self.seen.filled(plane)
            rest, _ = self.seen.clipped_surface(plane, self.triangles, self.owners)
            self.assertAlmostEqual(enclosed(np.concatenate([cut, rest])), left, 6)
            self.assertLess(np.abs(plane.heights(cut.reshape(-1, 3))).max(initial=0), 1e-12)
            self.assertEqual(len(cut), len(owners))

    def test_planes_in_words(self):
        self.assertEqual(plane_from_text("z = 5"), plane_across("z", 5))
        self.assertEqual(plane_from_text("x<-2.5"), plane_across("x", -2.5))
        self.assertEqual(plane_from_text("y>1e1"), plane_across("y", 10, keeps_above=True))
        for wrong in ("z", "w=3", "z=", "5", "z=a", ""):
            self.assertRaises(ValueError, plane_from_text, wrong)

    @staticmethod
    def planes():
        """Across axes, one oblique through the middle, one through a layer of nodes, all away, nothing away."""
        return (plane_across("z", 2.3), plane_across("x", 4.25, keeps_above=True), Plane((N / 2,) * 3, (0.6, 0.0, 0.8)),
                plane_across("y", 3.0), plane_across("z", -1.0), plane_across("z", N + 1.0))


class Triangles(unittest.TestCase):
    def of(self, name, points, elements=ONE[:, :3]):
        return float(MEASURES[name].values(points, elements)[0])

    def test_the_regular_one_is_best(self):
        for name, best in {**BEST, "dihedral_angle": 60}.items():
            self.assertAlmostEqual(self.of(name, TRIANGLE), best, places=12, msg=name)

    def test_with_sides_3_4_and_5(self):
        self.assertAlmostEqual(self.of("dihedral_angle", THREE_FOUR_FIVE), np.degrees(np.arctan(3 / 4)))
        self.assertAlmostEqual(self.of("radius_ratio", THREE_FOUR_FIVE), 2 * 1 / 2.5)
        self.assertAlmostEqual(self.of("aspect_ratio", THREE_FOUR_FIVE), 5 / 1 / (2 * np.sqrt(3)))
        self.assertAlmostEqual(self.of("scaled_jacobian", THREE_FOUR_FIVE), 2 / np.sqrt(3) * 3 / 5)
        self.assertAlmostEqual(self.of("skewness", THREE_FOUR_FIVE), 1 - 6 / (3 * np.sqrt(3) / 4 * 2.5 ** 2))

    def test_mid_side_nodes_count_for_the_jacobian(self):
        mids = [(THREE_FOUR_FIVE[i] + THREE_FOUR_FIVE[(i + 1) % 3]) / 2 for i in range(3)]
        six = np.arange(6)[None]
        self.assertAlmostEqual(self.of("scaled_jacobian", np.vstack([THREE_FOUR_FIVE, mids]), six), 2 / np.sqrt(3) * 3 / 5)
        mids[0] = np.array((1.5, 2.5, 0))
        self.assertLess(self.of("scaled_jacobian", np.vstack([THREE_FOUR_FIVE, mids]), six), 0)

    def test_a_plane_leaves_those_behind_it_or_cuts_them(self):
        points = np.array(((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)), dtype=float)
        sheet = seen_of(points, np.array(((0, 1, 2), (0, 2, 3))))
        self.assertEqual(len(sheet.cut_open()[0]), 2)
        self.assertEqual(sheet.cut_open(plane=plane_across("x", 0.5))[1].tolist(), [1])
        corners, _ = sheet.cut_open(plane=plane_across("x", 0.5), is_filled=True)
        self.assertAlmostEqual(np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum() / 2, 0.5)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures and the page of a report, on meshes small enough to be counted. Runs in plain Python."""
import re
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path += [str(ROOT / "Mod" / "FeatureMesh" / "freecad" / "featuremesh"), str(ROOT / "resources" / "demo")]

import difference_picture  # noqa: E402
import pictures  # noqa: E402
import quality  # noqa: E402
import section  # noqa: E402
from report_page import Page  # noqa: E402

REGULAR = np.array(((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)), dtype=float)
CORNERS = np.array([(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)], dtype=float)
# A cube as six tets around its diagonal from corner 0 to corner 7.
CUBE = np.array([(0, a, a + b, 7) for a, b in ((1, 2), (1, 4), (2, 1), (2, 4), (4, 1), (4, 2))])


def oriented(points, tets):
    p = points[tets]
    negative = np.einsum("ij,ij->i", p[:, 1] - p[:, 0], np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 0])) < 0
    tets = tets.copy()
    tets[negative, 2:] = tets[negative, 3:1:-1]
    return tets


class Differences(unittest.TestCase):
    """A square whose upper side is seen from above, and a second one that looks down."""
    UP = np.array((((0, 0, 0), (1, 0, 0), (1, 1, 0)), ((0, 0, 0), (1, 1, 0), (0, 1, 0))), dtype=float)
    SIDE = {"faces": [UP, UP[:, ::-1]], "edges": [UP[0]]}

    def test_a_face_that_any_change_names_is_changed(self):
        changes = [{"verdict": "kept", "old_face": "Face1", "new_face": "Face1"},
                   {"verdict": "vanished", "old_face": "Face2", "new_face": None},
                   {"verdict": "appeared", "old_face": None, "new_face": "Face1"}]
        self.assertEqual(difference_picture.verdicts_by_face(self.SIDE, changes, "old_face"), ["kept", "vanished"])
        self.assertEqual(difference_picture.verdicts_by_face(self.SIDE, changes, "new_face"), ["appeared", "kept"])

    def test_the_legend_names_what_is_drawn_and_the_glass(self):
        labels = dict((label, colour) for colour, label in difference_picture.legend_of((["kept", "vanished"], ["kept", "kept"])))
        self.assertEqual(list(labels), ["kept, drawn as glass", "vanished"])
        self.assertEqual(labels["vanished"], difference_picture.COLOURS["vanished"])

    def test_the_view_shows_the_changed_faces(self):
        from_above = difference_picture.best_direction([(self.SIDE, ["vanished", "kept"])])
        from_below = difference_picture.best_direction([(self.SIDE, ["kept", "vanished"])])
        self.assertLess(from_above[2], 0)
        self.assertGreater(from_below[2], 0)
        self.assertLess(difference_picture.best_direction([(self.SIDE, ["vanished", "appeared"])])[2], 0)


class Geometry(unittest.TestCase):
    def setUp(self):
        self.cube = oriented(CORNERS, CUBE)

    def test_outer_triangles_of_a_cube_are_its_sides_seen_from_outside(self):
        triangles, owner = section.outer_triangles(self.cube)
        self.assertEqual(len(triangles), 12)
        p = CORNERS[triangles]
        normals = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]) / 2
        self.assertAlmostEqual(np.linalg.norm(normals, axis=1).sum(), 6)
        self.assertTrue((np.einsum("ij,ij->i", normals, p.mean(axis=1) - 0.5) > 0).all())
        for triangle, tet in zip(triangles, owner):
            self.assertLess(set(triangle), set(self.cube[tet]))

    def test_an_inner_side_becomes_outer_where_the_mesh_is_cut(self):
        whole, _ = section.outer_triangles(self.cube)
        half, _ = section.outer_triangles(self.cube[:3])
        self.assertEqual(len(half), 3 * 4 - 2 * 2)
        self.assertLess(len(half), len(whole))

    def test_the_plane_divides_the_tets(self):
        behind = pictures.behind_plane(CORNERS, self.cube, (0.5, 0, 0), (1, 0, 0))
        before = pictures.behind_plane(CORNERS, self.cube, (0.5, 0, 0), (-1, 0, 0))
        self.assertFalse((behind & before).any())
        self.assertEqual(pictures.behind_plane(CORNERS, self.cube, (2, 0, 0), (1, 0, 0)).sum(), 6)

    def test_a_point_is_inside_a_tet_or_not(self):
        probes = np.array(((0.5, 0.4, 0.3), (0.9, 0.1, 0.2), (1.1, 0.5, 0.5), (0.5, 0.5, -0.01)))
        self.assertEqual(pictures.inside_any(CORNERS, self.cube, probes).tolist(), [True, True, False, False])
        self.assertEqual(sum(pictures.inside_any(CORNERS, self.cube[i:i + 1], probes)[0] for i in range(6)), 1)

    def test_quality_of_a_regular_tet(self):
        smallest, largest, ratios = quality.tet_quality(REGULAR, oriented(REGULAR, np.array([[0, 1, 2, 3]])))
        self.assertAlmostEqual(smallest[0], np.degrees(np.arccos(1 / 3)))
        self.assertAlmostEqual(largest[0], np.degrees(np.arccos(1 / 3)))
        self.assertAlmostEqual(ratios[0], 1)

    def test_quality_of_a_corner_of_a_cube(self):
        corner = CORNERS[[0, 1, 2, 4]]
        smallest, largest, ratios = quality.tet_quality(corner, np.array([[0, 1, 2, 3]]))
        self.assertAlmostEqual(smallest[0], np.degrees(np.arccos(1 / np.sqrt(3))))
        self.assertAlmostEqual(largest[0], 90)
        in_radius, circum_radius = 1 / (3 + np.sqrt(3)), np.sqrt(3) / 2
        self.assertAlmostEqual(ratios[0], 3 * in_radius / circum_radius)

    def test_trim_leaves_what_is_drawn(self):
        picture = np.full((100, 120, 3), 255, dtype=np.uint8)
        picture[40:60, 30:50] = 0
        first, second = pictures.trim([picture, np.full_like(picture, 255)], border=5)
        self.assertEqual(first.shape, second.shape)
        self.assertEqual((first == 0).all(axis=2).sum(), 400)
        self.assertLess(first.shape[0], 32)

    def test_a_title_with_dollars_is_no_formula(self):
        with tempfile.TemporaryDirectory() as folder:
            pictures.write_panels(Path(folder, "mesh.png"), [("a $\\frac$ b", np.zeros((20, 20, 3), dtype=np.uint8))])


class Drawing(unittest.TestCase):
    def check_fit(self, direction):
        """Everything is in the picture, and fills it."""
        stretched = CORNERS * [1, 12, 0.2] + 40
        drawn = pictures.draw_elements(stretched, oriented(CORNERS, CUBE), np.zeros(6, dtype=int), {"direction": direction}, size=(320, 240))
        rows, columns = np.nonzero((drawn != 255).any(axis=2))
        self.assertTrue(rows.min() > 0 and rows.max() < 239 and columns.min() > 0 and columns.max() < 319, direction)
        self.assertTrue(np.ptp(rows) > 200 or np.ptp(columns) > 270, direction)

    def test_elements_show_their_colours_and_stress_its_range(self):
        cube = oriented(CORNERS, CUBE)
        classes = np.where(np.arange(6) < 3, pictures.KEPT, pictures.NEW)
        with pictures.off_screen():
            for direction in ((1, 1, -1), (-0.45, -1, -0.75), (1, -0.1, 0.2), (0, 0, -1)):
                self.check_fit(direction)
            drawn = pictures.draw_elements(CORNERS, cube, classes, {"direction": (-1, -2, -1)}, active=CORNERS[:1], size=(320, 240))
            stress = pictures.draw_stress(CORNERS, cube, CORNERS[:, 2], 0 * CORNERS, 1.0, (0, 1), {"direction": (-1, -2, -1)}, size=(320, 240))
        for picture in (drawn, stress):
            self.assertEqual(picture.shape, (240, 320, 3))
            share = (picture != 255).any(axis=2).mean()
            self.assertTrue(0.15 < share < 0.95, share)
        warm = (drawn[..., 0].astype(int) > drawn[..., 2].astype(int) + 60).mean()
        cool = (drawn[..., 2].astype(int) > drawn[..., 0].astype(int) + 15).mean()
        self.assertGreater(warm, 0.03)
        self.assertGreater(cool, 0.03)
        self.assertGreater(len(np.unique(stress.reshape(-1, 3), axis=0)), 50)

    def test_the_page_holds_everything_it_shows(self):
        with tempfile.TemporaryDirectory() as folder:
            picture = Path(folder) / "quality.png"
            pictures.write_quality(picture, [("mesh", np.linspace(20, 60, 50), np.linspace(0.5, 1, 50))])
            page = Page("A <title>", "A & B")
            page.add_tiles([("95 %", "kept", True)])
            page.add_table(("a", "b"), [("<x>", 1)], words=(1,))
            page.add_figure(picture, "caption")
            page.write(Path(folder) / "page.html", "end")
            html = (Path(folder) / "page.html").read_text(encoding="utf-8")
        self.assertIn("A &lt;title&gt;", html)
        self.assertIn("&lt;x&gt;", html)
        self.assertEqual(re.findall(r'(?:src|href)="(?!data:)', html), [])
        self.assertEqual(html.count("data:image/png;base64,"), 1)


if __name__ == "__main__":
    unittest.main()

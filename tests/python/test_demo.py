# SPDX-License-Identifier: GPL-3.0-or-later
"""The demo from end to end: the whole road on the bracket, both solutions, the pictures and the page. Runs in plain Python."""
import io
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "resources" / "launcher"))

from freecad_task import freecad_environment, run_script  # noqa: E402

DEMO = ROOT / "resources" / "demo"


class Demo(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.out = Path(cls.folder.name)
        cls.lines = io.StringIO()
        cls.result = run_script(DEMO / "run_demo.py", {"FEATUREMESH_DEMO_OUT": str(cls.out)}, lines_to=cls.lines)
        if cls.result["exit_code"]:
            raise AssertionError(cls.result["message"] + "\n" + cls.lines.getvalue())
        cls.numbers = json.loads((cls.out / "numbers.json").read_text(encoding="utf-8"))
        subprocess.run([sys.executable, str(DEMO / "draw_report.py"), str(cls.out)], env=freecad_environment(), check=True)

    def test_it_tells_every_step(self):
        for step in ("Read", "First mesh", "CalculiX", "Edit", "Difference", "Updated mesh", "Full mesh", "Kept"):
            self.assertIn("\n" + step, "\n" + self.lines.getvalue())

    def test_the_update_is_local(self):
        update = self.numbers["update"]
        self.assertIsNone(update["fallback"])
        self.assertGreater(update["kept"]["nodes_share"], 0.9)
        changed = {feature["label"] for feature in update["difference"]["features"] if feature["verdict"] != "same"}
        self.assertIn("Holes", changed)
        self.assertEqual(changed & {"Boss", "Rib", "Bore", "Fillet"}, set())

    def test_the_updated_mesh_is_as_good_as_a_full_one(self):
        update, full = self.numbers["update"]["quality"], self.numbers["full"]["quality"]
        self.assertAlmostEqual(update["mean_radius_ratio"], full["mean_radius_ratio"], delta=0.01)
        self.assertGreater(update["min_dihedral"], full["min_dihedral"] - 3)

    def test_both_solutions_are_those_of_a_plate_that_bends(self):
        first, second = self.numbers["first_solution"], self.numbers["second_solution"]
        for solution in (first, second):
            self.assertTrue(0.05 < solution["displacement"] < 0.5, solution)
            self.assertTrue(10 < solution["stress"] < 500, solution)
        self.assertNotEqual(first["displacement"], second["displacement"])
        self.assertAlmostEqual(first["displacement"], second["displacement"], delta=0.1 * first["displacement"])

    def test_the_live_solver_finds_the_same(self):
        self.assertIn("\nLive ", "\n" + self.lines.getvalue())
        for which in ("first", "second"):
            live, theirs = self.numbers[which + "_live"], self.numbers[which + "_solution"]
            if live is not None:   # where PETSc is installed
                for name in ("displacement", "stress"):
                    self.assertAlmostEqual(live[name] / theirs[name], 1, delta=1e-3)
        if self.numbers["second_live"] is not None:
            self.assertGreater(self.numbers["second_live"]["reused"]["start_share"], 0.9)

    def test_it_leaves_what_a_user_looks_at(self):
        self.assertEqual(sorted(path.name for path in self.out.iterdir()), ["bracket.FCStd", "bracket_edited.FCStd", "numbers.json", "pictures", "report.html"])

    def test_the_page_has_its_pictures(self):
        html = (self.out / "report.html").read_text(encoding="utf-8")
        self.assertEqual(html.count("data:image/png;base64,"), 4)
        for name in ("kept", "kept_close", "stress", "quality"):
            self.assertGreater((self.out / "pictures" / (name + ".png")).stat().st_size, 20000)


if __name__ == "__main__":
    unittest.main()

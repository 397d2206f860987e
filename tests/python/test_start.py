# SPDX-License-Identifier: GPL-3.0-or-later
"""`./featuremesh gui` opens FreeCAD's window with the workbench of the clone, on a virtual screen; skipped where there can be no window."""
import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from test_window import HERE, LAUNCHER, addons, environment_of

EXAMPLE = LAUNCHER.parent / "resources" / "examples" / "bracket.FCStd"
CLONE = str(LAUNCHER.parent / "Mod" / "FeatureMesh")


class Start(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        (self.folder / "home").mkdir()
        self.environment = environment_of(self.folder / "home")
        del self.environment["QTWEBENGINE_DISABLE_SANDBOX"]   # what FreeCAD's start page needs of it, the launcher knows
        installed = addons(self.environment)   # what is installed does not take the clone's place
        shutil.copytree(HERE / "driver", installed / "Driver")

    def seen_after(self, *words):
        """What was in the window that the launcher opened with these words."""
        result = self.folder / "result"
        environment = {**self.environment, "FEATUREMESH_DRIVER": str(HERE / "drive_start.py"), "FEATUREMESH_RESULT": str(result)}
        done = subprocess.run(["xvfb-run", "-a", "-s", "-screen 0 1280x800x24", LAUNCHER, "gui", *words], env=environment, cwd=self.folder,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("FreeCAD was closed", done.stdout)
        self.assertNotIn("unknown option", done.stdout)
        seen = json.loads(result.read_text(encoding="utf-8"))
        self.assertEqual(Path(seen["workbench"]).parents[2], Path(CLONE).resolve(), seen)
        self.assertGreater(len(seen["commands"]), 8)
        return seen

    def test_without_a_part(self):
        self.assertEqual(self.seen_after()["documents"], [])

    def test_with_a_part_whose_path_has_spaces_and_umlauts(self):
        part = self.folder / "Türen und Tore" / "Träger Nr. 1.FCStd"
        part.parent.mkdir()
        shutil.copy(EXAMPLE, part)
        for word in (str(part), str(part.relative_to(self.folder))):
            with self.subTest(word=word):
                seen = self.seen_after(word)
                self.assertEqual(seen["documents"], [str(part)])
                self.assertIn("Body", seen["shown"])

    def test_without_a_screen_it_says_so(self):
        environment = {name: value for name, value in self.environment.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
        done = subprocess.run([LAUNCHER, "gui"], env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (2, 1), done.stderr)
        self.assertIn("there is no screen", done.stderr)


if __name__ == "__main__":
    if not shutil.which("xvfb-run") or not (shutil.which("freecad") or shutil.which("FreeCAD")):
        print("skipped: needs freecad and xvfb-run")
        sys.exit(77)
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""`./featuremesh install` gives FreeCAD a workbench that meshes without anything else being set, and `uninstall` takes it away."""
import os
import re
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = """
import os
import FreeCAD
try:
    from freecad.featuremesh import api
    document = FreeCAD.newDocument()
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    mesh = api.add_mesh(box, 3)
    document.recompute()
    said = "%s, %s" % (mesh.Status, os.path.realpath(api.__file__))
except ImportError as error:
    said = str(error)
print("\\nsaid: " + said)
"""


class Install(unittest.TestCase):
    def setUp(self):
        self.home = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.home)
        self.environment = {name: value for name, value in os.environ.items()
                            if not name.startswith(("FEATUREMESH_ENGINE", "XDG_", "PYTHONPATH", "FREECAD_USER"))}
        self.environment.update(HOME=self.home, LC_ALL="C.UTF-8")

    def launch(self, command):
        subprocess.run([str(ROOT / "featuremesh"), command], env=self.environment, check=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def said_by_freecad(self):
        script = Path(self.home, "say.py")
        script.write_text(SCRIPT, encoding="utf-8")
        program = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
        done = subprocess.run([program, str(script)], env=self.environment, cwd=self.home, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, errors="replace")
        return next((line for line in done.stdout.splitlines() if line.startswith("said: ")), done.stdout)

    def test_installed_it_meshes_and_uninstalled_it_is_gone(self):
        self.launch("install")
        self.assertIn("said: up to date, " + os.path.realpath(self.home), self.said_by_freecad())
        self.launch("uninstall")
        self.assertRegex(self.said_by_freecad(), "said: .*(No module|cannot import)")

    def test_the_addon_manager_finds_what_it_reads(self):
        package = ElementTree.parse(ROOT / "Mod" / "FeatureMesh" / "package.xml").getroot()
        names = {node.tag.split("}")[-1]: node for node in package.iter()}
        for tag in ("name", "description", "version", "license", "workbench", "classname", "subdirectory", "icon", "freecadmin"):
            self.assertIn(tag, names)
        place = ROOT / "Mod" / "FeatureMesh" / names["subdirectory"].text
        self.assertTrue((place / "freecad" / "featuremesh" / "init_gui.py").is_file())
        for icon in (node.text for node in package.iter() if node.tag.split("}")[-1] == "icon"):
            self.assertTrue((place / icon).is_file(), icon)

    def test_the_version_is_the_same_everywhere(self):
        versions = {re.search(pattern, (ROOT / path).read_text(encoding="utf-8")).group(1) for path, pattern in (
            ("CMakeLists.txt", r"project\(FeatureMesh VERSION ([\d.]+)"), ("Mod/FeatureMesh/package.xml", r"<version>([\d.]+)<"),
            ("Mod/FeatureMesh/freecad/featuremesh/__init__.py", r'__version__ = "([\d.]+)"'))}
        self.assertEqual(len(versions), 1, versions)


if __name__ == "__main__":
    unittest.main()

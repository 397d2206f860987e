# SPDX-License-Identifier: GPL-3.0-or-later
"""What is in dist, installed as a user does it, in a FreeCAD without anything to build with. Run by `./featuremesh test --packages`.

EXPECTED names a JSON file with the hashes of the example's nodes as the engine built from source gives them.
"""
import json
import os
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from installed import DIST, FREECADCMD, IS_DEBIAN_12, ROOT, Home, one_of  # noqa: E402

NOBODY = 65534
MODULES = ("state_file", "mesh_object", "mesh_in_document", "worker")
SECONDS_AT_MOST = 60


def expected():
    return json.loads(Path(os.environ["EXPECTED"]).read_text(encoding="utf-8"))


class Machine(unittest.TestCase):
    def test_there_is_nothing_to_build_with(self):
        for program in ("cmake", "ninja", *(() if IS_DEBIAN_12 else ("g++", "gcc", "cc"))):   # there FreeCAD brings scipy, which brings g++
            self.assertIsNone(shutil.which(program), program)
        self.assertFalse(Path("/usr/include/opencascade").exists())


class WheelAndAddon(Home):
    def test_meshes_as_the_build_from_source(self):
        packages, addon = self.install_wheel(), self.install_addon()
        said = self.meshed()
        self.assertNotIn("error", said)
        self.assertTrue(said["addon"].startswith(str(addon.resolve())), said["addon"])
        self.assertEqual(said["engine"], str(packages))
        self.assertTrue(said["in_worker"])
        self.assertEqual(said["mesh"], expected()["mesh"])
        self.assertGreater(said["kept"], 0.9)
        self.assertIn("from a wheel", said["about"])
        if IS_DEBIAN_12:
            self.assertEqual(said["update"], expected()["update"])
        print("the update's nodes are those of the build from source: %s" % (said["update"] == expected()["update"]))

    def test_two_versions(self):
        packages, addon = self.install_wheel(), self.install_addon()
        older = addon / "engines"
        shutil.copytree(packages, older)
        info = next(older.glob("featuremesh_engine-*.dist-info"))
        info.rename(older / "featuremesh_engine-0.0.1.dist-info")
        said = self.meshed()
        self.assertEqual(said["engine"], str(packages))
        self.assertRegex(said["printed"], r"several engines and uses the newest, [\d.]+ in .*0\.0\.1 in")

    def test_a_broken_one(self):
        packages = self.install_wheel()
        self.install_addon()
        library = sorted((packages / "featuremesh_engine.libs").iterdir())[0]
        library.write_bytes(library.read_bytes()[:5000])
        self.assertRegex(self.meshed()["error"], r"(?s)^EngineMissing: .*could not be loaded.*pip install")

    def test_one_of_another_python(self):
        packages = self.install_wheel()
        self.install_addon()
        module = next(packages.glob("featuremesh_engine.*.so"))
        module.rename(packages / re.sub(r"cpython-3\d+", "cpython-38", module.name))
        self.assertRegex(self.meshed()["error"], r"^EngineMissing: .*not installed for Python 3\.\d+.*is for Python 3\.8.*pip install")

    def test_none(self):
        self.install_addon()
        self.assertRegex(self.meshed()["error"], "^EngineMissing: .*not installed.*Addon Manager.*pip install.*portable zip")

    def test_without_numpy(self):
        packages = self.install_wheel()
        self.install_addon()
        (packages / "numpy.py").write_text("raise ImportError(\"No module named 'numpy'\")\n", encoding="utf-8")
        said = self.meshed()
        self.assertIn("No module named 'numpy'", said["error"])

    def test_a_home_that_cannot_be_written(self):
        self.install_wheel()
        self.install_addon()
        os.chmod(self.above, 0o777)
        for folder, _, _ in os.walk(self.home):
            os.chmod(folder, 0o777 if ".cache" in folder else 0o555)   # without its cache, FreeCAD cannot keep any document's files
        result = self.above / "as-nobody.json"
        done = subprocess.run([FREECADCMD, str(ROOT / "tests" / "packages" / "mesh_example.py")], cwd=self.above, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", user=NOBODY, group=NOBODY,
                              env={**self.environment, "FEATUREMESH_RESULT": str(result),
                                   "FEATUREMESH_EXAMPLE": str(ROOT / "resources" / "examples" / "bracket.FCStd")})
        self.assertTrue(result.is_file(), done.stdout)
        said = json.loads(result.read_text(encoding="utf-8"))
        self.assertNotIn("error", said, done.stdout)
        self.assertEqual(said["mesh"], expected()["mesh"])
        self.assertIn("cannot be written", said["about"])

    def test_the_tests_that_run_in_freecad(self):
        self.install_wheel()
        addon = self.install_addon()
        for module in MODULES:
            done = subprocess.run([FREECADCMD, str(ROOT / "tests" / "python" / "run_tests.py")], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, errors="replace", cwd=self.above,
                                  env={**self.environment, "FEATUREMESH_TESTS": "test_" + module, "FEATUREMESH_TESTED": str(addon)})
            self.assertIn("every test of the module passed", done.stdout, f"{module}:\n{done.stdout[-6000:]}")


class Portable(Home):
    def test_meshes_within_a_minute(self):
        addon = self.install_portable()
        said = self.meshed()
        self.assertNotIn("error", said)
        self.assertEqual(Path(said["engine"]), addon / "engines")
        self.assertTrue(said["in_worker"])
        self.assertEqual(said["mesh"], expected()["mesh"])
        self.assertIn("from the portable zip", said["about"])
        self.assertLess(said["seconds_until_first_mesh"], SECONDS_AT_MOST)
        print("seconds from the unpacked zip to the first mesh: %.1f" % said["seconds_until_first_mesh"])
        outside = {path for path in self.home.rglob("*") if path.is_file() and "featuremesh" in str(path).lower()
                   and not path.is_relative_to(addon) and not path.is_relative_to(self.home / ".cache")}   # FreeCAD's own, of open documents
        self.assertLessEqual(outside, {addon.parents[1] / "FeatureMesh" / "featuremesh.log"})


@unittest.skipUnless(os.environ.get("WITH_DEB"), "this is another Debian than the package is for")
class Deb(Home):
    def test_installs_meshes_and_goes(self):
        package = one_of("featuremesh_*.deb")
        apt = ["apt-get", "-q", "-y", "--no-install-recommends"]
        subprocess.run([*apt, "install", str(package)], check=True, stdout=subprocess.DEVNULL, env={**os.environ, "DEBIAN_FRONTEND": "noninteractive"})
        try:
            said = self.meshed()
            self.assertNotIn("error", said)
            self.assertTrue(said["addon"].startswith("/usr/share/freecad/Mod/FeatureMesh/"), said["addon"])
            self.assertFalse(said["in_worker"])
            self.assertEqual((said["mesh"], said["update"]), (expected()["mesh"], expected()["update"]))
        finally:
            subprocess.run([*apt, "purge", "featuremesh"], check=True, stdout=subprocess.DEVNULL)
        self.assertFalse(Path("/usr/share/freecad/Mod/FeatureMesh").exists())
        self.assertEqual(list(Path("/usr/lib/python3/dist-packages").glob("featuremesh_engine*")), [])


@unittest.skipUnless(Path("/usr/share/freecad/Mod/AddonManager/addonmanager_dependency_installer.py").is_file(), "FreeCAD 0.20's has no such parts")
class AddonManager(Home):
    def test_installs_updates_and_removes(self):
        self.environment.update(PIP_NO_INDEX="1", PIP_FIND_LINKS=str(DIST), ADDON_ZIP=str(one_of("featuremesh-addon-*.zip")))
        said = self.freecad(ROOT / "tests" / "packages" / "addon_manager.py", DO="install")
        self.assertNotIn("error", said, said["printed"])
        self.assertEqual(said["dependencies"], ["featuremesh-engine"])
        self.assertTrue(Path(said["packages"]).samefile(self.packages()))
        meshed = self.meshed()
        self.assertNotIn("error", meshed)
        self.assertEqual(meshed["mesh"], expected()["mesh"])
        said = self.freecad(ROOT / "tests" / "packages" / "addon_manager.py", DO="install")   # over what is there, as an update does
        self.assertNotIn("error", said, said["printed"])
        self.assertEqual(self.meshed()["mesh"], expected()["mesh"])
        said = self.freecad(ROOT / "tests" / "packages" / "addon_manager.py", DO="remove")
        self.assertNotIn("error", said, said["printed"])
        user = self.user_folder()
        self.assertFalse((user / "Mod" / "FeatureMesh").exists())
        self.assertFalse((user / "FeatureMesh").exists())
        command = re.search(r'To remove it, type: PYTHONPATH="([^"]+)" python[\d.]+ -m pip (uninstall .*featuremesh-engine)', said["printed"])
        self.assertIsNotNone(command, said["printed"])
        self.environment["PYTHONPATH"] = command.group(1)
        self.pip(*command.group(2).split(), "-y")
        self.assertEqual(list(self.packages().glob("*featuremesh*")), [])


if __name__ == "__main__":
    unittest.main(verbosity=2)

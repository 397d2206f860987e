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
import zipfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from installed import DIST, FREECADCMD, IS_DEBIAN_12, ROOT, Home, one_of, unpack  # noqa: E402

NOBODY = 65534
OLDER_VERSION = "0.0.1"
WORKBENCH_CLASS = "FeatureMeshWorkbench"


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
        said = self.meshed(FEATUREMESH_ASKED=os.environ["ASKED"])   # of which replay.py asks the engine that was built from source
        self.assertNotIn("error", said)
        self.assertTrue(said["addon"].startswith(str(addon.resolve())), said["addon"])
        self.assertEqual(said["engine"], str(packages))
        self.assertTrue(said["in_worker"])
        self.assertEqual(said["mesh"], expected()["mesh"])
        self.assertGreater(said["kept"], 0.9)
        self.assertIn("from a wheel", said["about"])
        if IS_DEBIAN_12:   # with the FreeCAD that made the edited shape for what is expected
            self.assertEqual(said["update"], expected()["update"])

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
        self.install_addon()
        wheel = next(wheel for wheel in sorted(DIST.glob("*.whl")) if "cp%d%d-" % sys.version_info[:2] not in wheel.name)
        unpack(wheel, self.packages())
        minor = re.search(r"-cp3(\d+)-", wheel.name).group(1)
        error = self.meshed()["error"]
        self.assertRegex(error, rf"^EngineMissing: .*not installed for Python 3\.{sys.version_info[1]};.*is for Python 3\.{minor}\..*pip install")
        self.type_the_command_of(error)   # which puts the right one beside it
        self.assertEqual(self.meshed()["mesh"], expected()["mesh"])

    def test_none(self):
        self.install_addon()
        said = self.meshed()
        error = said["error"]
        self.assertRegex(error, "^EngineMissing: .*not installed.*Addon Manager.*pip install.*portable zip")
        self.assertIn(error.partition("EngineMissing: ")[2], said["about"])
        self.type_the_command_of(error)
        self.assertEqual(self.meshed()["mesh"], expected()["mesh"])

    def type_the_command_of(self, error):
        """As the message says, in the folder of the wheels with the words that the readme adds for that."""
        here = re.search(r"`(--no-index --find-links [^`]+)`", (ROOT / "README.md").read_text(encoding="utf-8")).group(1)
        self.run_as_typed(f"{re.search(r'type `([^`]+)`', error).group(1)} {here}", shell=True, cwd=DIST)

    def test_one_that_is_too_old_or_too_new(self):
        self.install_wheel()
        engine = self.install_addon() / "freecad/featuremesh/engine.py"
        text = engine.read_text(encoding="utf-8")
        for protocols, answer in (("98, 99", "is too old for FeatureMesh .*Addon Manager.*pip install --upgrade.*portable zip"),
                                  ("0, 0", "is too new for FeatureMesh .*update FeatureMesh with Tools, Addon manager")):
            other, count = re.subn("(?m)^(OLDEST_PROTOCOL, NEWEST_PROTOCOL) = .*$", rf"\1 = {protocols}", text)
            self.assertEqual(count, 1)
            engine.write_text(other, encoding="utf-8")
            said = self.meshed()
            self.assertRegex(said["error"], r"^EngineMissing: FeatureMesh's engine [\d.]+ in .*" + answer)
            self.assertNotIn("Traceback", said["printed"])
            if "too old" in answer:
                self.type_the_command_of(said["error"])   # there is no newer one, but pip takes it

    def test_without_numpy(self):
        self.install_wheel()
        self.install_addon()
        script = ROOT / "tests" / "packages" / "started.py"
        self.assertIn(WORKBENCH_CLASS, self.window(script)["workbenches"])
        self.hide_numpy()
        said = self.meshed()
        self.assertRegex(said["error"], "^ImportError: FeatureMesh needs numpy, .*python3-numpy")
        self.assertNotIn("Traceback", said["printed"])
        said = self.window(script)
        self.assertNotIn(WORKBENCH_CLASS, said["workbenches"])
        self.assertIn("FeatureMesh needs numpy", said["printed"])
        self.assertNotIn("featuremesh/init_gui.py", said["printed"])   # as in the lines of a traceback

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
        self.check_tests_in_freecad(self.install_addon())


class Portable(Home):
    def test_meshes_at_once(self):
        addon, mark = self.install_portable(), self.mark()
        said = self.meshed()
        self.assertNotIn("error", said)
        self.assertEqual(Path(said["engine"]), addon / "engines")
        self.assertTrue(said["in_worker"])
        self.assertEqual(said["mesh"], expected()["mesh"])
        self.assertIn("from the portable zip", said["about"])
        print("seconds from the unpacked zip to the first mesh: %.1f" % said["seconds_until_first_mesh"])
        log = self.user_folder() / "FeatureMesh" / "featuremesh.log"
        self.assertRegex(said["about"], "Log: +" + re.escape(str(log)))
        written = self.newer_files(mark)
        self.assertIn(log, written)
        ours = {path for path in written if "featuremesh" in str(path.relative_to(self.above) if path.is_relative_to(self.above) else path).lower()
                and not path.is_relative_to(self.home / ".cache") and not path.is_relative_to(addon)}   # FreeCAD's copies of open documents
        self.assertEqual(ours, {log})
        self.assertEqual({path for path in written if not path.is_relative_to(self.above)}, set())

    def test_the_tests_that_run_in_freecad(self):
        self.check_tests_in_freecad(self.install_portable())


@unittest.skipUnless(os.environ.get("WITH_DEB"), "this is another Debian than the package is for")
class Deb(Home):
    def test_installs_meshes_and_goes(self):
        apt = ["apt-get", "-q", "-y", "--no-install-recommends"]
        self.run_as_typed([*apt, "install", str(one_of("featuremesh_*.deb"))])
        workbench, packages = Path("/usr/share/freecad/Mod/FeatureMesh"), Path("/usr/lib/python3/dist-packages")
        try:
            said = self.meshed()
            self.assertNotIn("error", said)
            self.assertTrue(said["addon"].startswith(f"{workbench}/"), said["addon"])
            self.assertEqual(said["engine"], str(packages))
            self.assertFalse(said["in_worker"])
            self.assertEqual((said["mesh"], said["update"]), (expected()["mesh"], expected()["update"]))
            self.assertIn("installed by the system's packages", said["about"])
            self.check_tests_in_freecad(workbench)
        finally:
            self.run_as_typed([*apt, "purge", "featuremesh"])
        self.assertFalse(workbench.exists())
        self.assertEqual(list(packages.glob("featuremesh_engine*")), [])


@unittest.skipUnless(Path("/usr/share/freecad/Mod/AddonManager/addonmanager_dependency_installer.py").is_file(), "FreeCAD 0.20's has no such parts")
class AddonManager(Home):
    def test_installs_updates_and_removes(self):
        self.environment.update(PIP_NO_INDEX="1", PIP_FIND_LINKS=str(DIST))
        said = self.let_it("install", self.older_addon())
        self.assertEqual(said["dependencies"], ["featuremesh-engine"])
        self.assertTrue(Path(said["packages"]).samefile(self.packages()))
        addon = self.user_folder() / "Mod" / "FeatureMesh"
        self.assertIn(f"<version>{OLDER_VERSION}</version>", (addon / "package.xml").read_text(encoding="utf-8"))
        self.check_it_meshes()
        self.let_it("update", one_of("featuremesh-addon-*.zip"))
        self.assertNotIn(f"<version>{OLDER_VERSION}</version>", (addon / "package.xml").read_text(encoding="utf-8"))
        self.assertFalse((addon / "of_older_version.py").exists())
        self.check_it_meshes()
        said = self.let_it("remove", one_of("featuremesh-addon-*.zip"))
        self.assertFalse(addon.exists())
        self.assertFalse((self.user_folder() / "FeatureMesh").exists())
        self.remove_engine_as_told(said["printed"])

    def let_it(self, what, addon):
        said = self.freecad(ROOT / "tests" / "packages" / "addon_manager.py", DO=what, ADDON_ZIP=str(addon))
        self.assertNotIn("error", said, said["printed"])
        return said

    def older_addon(self):
        """The addon as if of an older version, with a file that today's has not."""
        older = self.above / "older.zip"
        with zipfile.ZipFile(one_of("featuremesh-addon-*.zip")) as today, zipfile.ZipFile(older, "w") as archive:
            for name in today.namelist():
                data = today.read(name)
                if name == "package.xml":
                    data = re.sub(rb"<version>[^<]+", b"<version>" + OLDER_VERSION.encode(), data)
                archive.writestr(name, data)
            archive.writestr("of_older_version.py", "")
        return older

    def check_it_meshes(self):
        said = self.meshed()
        self.assertNotIn("error", said)
        self.assertEqual(said["mesh"], expected()["mesh"])

    def remove_engine_as_told(self, printed):
        """The command that uninstall.py shows removes all of the engine."""
        command = re.search(r"To remove it, type: (.*featuremesh-engine)", printed)
        self.assertIsNotNone(command, printed)
        self.run_as_typed(command.group(1) + " -y", shell=True)
        self.assertEqual(list(self.packages().glob("*featuremesh*")), [])


if __name__ == "__main__":
    unittest.main(verbosity=2)

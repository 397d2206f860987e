# SPDX-License-Identifier: GPL-3.0-or-later
"""A fresh home of a user with FreeCAD, into which the tests install what is in dist. The roots in which they run have no network."""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DIST = ROOT / "dist"
EXAMPLE = ROOT / "resources" / "examples" / "bracket.FCStd"
PYTHON = "python%d.%d" % sys.version_info[:2]
IS_DEBIAN_12 = "bookworm" in Path("/etc/os-release").read_text(encoding="utf-8")   # with FreeCAD 0.20.2
# Of the tests that run in FreeCAD, those that need nothing but FreeCAD and the engine.
TESTS_IN_FREECAD = ("state_file", "mesh_object", "mesh_in_document", "worker", "refusals", "document_reading", "document_edits",
                    "document_files", "examples")
SECONDS = 1200   # a machine that has much else to do takes minutes; what never ends is told of
NOT_OF_THE_ROOT = ("/proc", "/sys", "/dev", "/run", "/featuremesh", "/var/cache/ccache")
FREECADCMD = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
FREECAD = shutil.which("freecad") or shutil.which("FreeCAD")
ON_A_SCREEN = ("xvfb-run", "-a", "-s", "-screen 0 1280x800x24")
# Runs a command where the folder of Debian's Python packages has all but numpy; $1 is a folder for what that takes. Ends with the command.
WITHOUT_NUMPY = """
set -e
folder=$(mktemp -d -p "$1") packages=/usr/lib/python3/dist-packages; shift
mkdir "$folder/all" "$folder/but-numpy"
mount --bind "$packages" "$folder/all"
ln -s "$folder"/all/* "$folder/but-numpy"
rm "$folder"/but-numpy/numpy*
mount --bind "$folder/but-numpy" "$packages"
exec "$@"
"""


def one_of(pattern):
    """The only file of dist that fits."""
    files = sorted(DIST.glob(pattern))
    assert len(files) == 1, (pattern, files)
    return files[0]


class Home(unittest.TestCase):
    """A home whose path has a space and umlauts."""

    def setUp(self):
        self.above = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.above, ignore_errors=True)
        self.home = self.above / "Jürgen Größer"
        self.home.mkdir()
        self.started_by = ()   # words before those that start FreeCAD
        self.environment = {"HOME": str(self.home), "PATH": os.environ["PATH"], "LC_ALL": "C.UTF-8", "PYTHONDONTWRITEBYTECODE": "1"}

    def freecad(self, script, **variables):
        """Runs a script in FreeCAD; gives what it wrote as JSON, with all that was printed as `printed`."""
        return self.result_of([FREECADCMD, str(script)], variables)

    def window(self, script):
        """The same in FreeCAD's window, on a virtual screen, once it waits for its user."""
        driver = self.user_folder() / "Mod" / "Driver"
        if not driver.exists():
            shutil.copytree(ROOT / "tests" / "python" / "driver", driver)
        return self.result_of([*ON_A_SCREEN, FREECAD], {"FEATUREMESH_DRIVER": str(script), "QTWEBENGINE_DISABLE_SANDBOX": "1"})

    def result_of(self, command, variables):
        result = self.above / "result.json"
        result.unlink(missing_ok=True)
        done = subprocess.run([*self.started_by, *command], cwd=self.above, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, errors="replace", timeout=SECONDS,
                              env={**self.environment, "FEATUREMESH_RESULT": str(result), "FEATUREMESH_EXAMPLE": str(EXAMPLE), **variables})
        self.assertTrue(result.is_file(), done.stdout)
        return {**json.loads(result.read_text(encoding="utf-8")), "printed": done.stdout}

    def hide_numpy(self):
        """From now on FreeCAD is started where there is none."""
        self.started_by = ("unshare", "--mount", "--propagation", "unchanged", "sh", "-c", WITHOUT_NUMPY, "sh", str(self.above))

    def check_tests_in_freecad(self, workbench):
        """Those tests pass with the workbench that FreeCAD found in this folder, whose files are not those of the checkout."""
        for module in TESTS_IN_FREECAD:
            done = subprocess.run([FREECADCMD, str(ROOT / "tests" / "python" / "run_tests.py")], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, errors="replace", cwd=self.above,
                                  env={**self.environment, "FEATUREMESH_TESTS": "test_" + module, "FEATUREMESH_TESTED": str(workbench)})
            self.assertIn("every test of the module passed", done.stdout, f"{module}:\n{done.stdout[-6000:]}")

    def mark(self):
        """A file; what is written after it is newer."""
        mark = self.above / "mark"
        mark.write_text("", encoding="utf-8")   # with the file system's own clock
        return mark

    def newer_files(self, mark):
        """All files of the machine that were written after the mark."""
        skipped = [word for folder in NOT_OF_THE_ROOT for word in ("-path", folder, "-prune", "-o")]
        shown = subprocess.run(["find", "/", *skipped, "-type", "f", "-newer", str(mark), "-print0"], stdout=subprocess.PIPE, check=True).stdout
        return {Path(os.fsdecode(name)) for name in shown.split(b"\0") if name}

    def meshed(self, **variables):
        return self.freecad(ROOT / "tests" / "packages" / "mesh_example.py", FEATUREMESH_STARTED=str(time.time()), **variables)

    def user_folder(self):
        """FreeCAD's folder of this user, which only FreeCAD knows."""
        return Path(self.freecad(ROOT / "resources" / "launcher" / "find_user_folder.py")["user_folder"])

    def packages(self):
        """Where the Addon Manager of this FreeCAD lets pip install."""
        folder = self.user_folder() / "AdditionalPythonPackages"
        return folder if IS_DEBIAN_12 else folder / ("py%d%d" % sys.version_info[:2])

    def pip(self, *words):
        return self.run_as_typed([PYTHON, "-m", "pip", *words])

    def run_as_typed(self, command, **options):
        """What a user types, which must succeed; gives what it printed."""
        done = subprocess.run(command, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout

    def install_wheel(self):
        target = self.packages()
        self.pip("install", "--no-index", "--find-links", str(DIST), "--target", str(target), "featuremesh-engine")
        return target

    def install_addon(self):
        return self.unzip_as_told("featuremesh-addon")

    def install_portable(self):
        return self.unzip_as_told("featuremesh-portable")

    def unzip_as_told(self, archive):
        """Types the commands of the readme, for the folder that it names for this FreeCAD; gives the addon's folder."""
        readme = (ROOT / "README.md").read_text(encoding="utf-8")
        addons = self.user_folder() / "Mod"
        told = f"~/{addons.relative_to(self.home)}"
        self.assertIn(f"`{told}`", readme)
        for start in ("mkdir -p", f"unzip {archive}"):
            command = re.search(f"`({start}[^`]*)`", readme).group(1)
            self.run_as_typed(command.replace("~/.local/share/FreeCAD/Mod", told), shell=True, cwd=DIST)
        self.assertTrue((addons / "FeatureMesh" / "package.xml").is_file())
        return addons / "FeatureMesh"


def unpack(archive, target):
    target.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(archive) as opened:
        opened.extractall(target)

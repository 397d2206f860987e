# SPDX-License-Identifier: GPL-3.0-or-later
"""FreeCAD's real window on a virtual screen; skipped (exit code 77) where there is no FreeCAD window or no Xvfb.

FeatureMesh is installed in a fresh home, and FreeCAD is started there without anything else being set. Runs drive_window.py, or the
script of this folder that is named, on a screen of that size, and with a copy of that document.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
LAUNCHER = HERE.parents[1] / "featuremesh"
SKIPPED = 77
SECONDS = 1200   # a machine that has much else to do takes minutes; what never ends is told of


def main(script="drive_window.py", screen_size="1280x800", document=None):
    freecad, screen = shutil.which("freecad") or shutil.which("FreeCAD"), shutil.which("xvfb-run")
    if not freecad or not screen:
        print("skipped: needs freecad and xvfb-run")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        home, result = Path(folder, "home"), Path(folder, "result")
        home.mkdir()
        environment = environment_of(home)
        shutil.copytree(HERE / "driver", addons(environment) / "Driver")
        environment.update(FEATUREMESH_DRIVER=str(HERE / script), FEATUREMESH_RESULT=str(result), FEATUREMESH_SECONDS=str(SECONDS))
        words = [shutil.copy(document, home)] if document else []
        done = subprocess.run([screen, "-a", "-s", f"-screen 0 {screen_size}x24 -dpi 96", freecad, *words], env=environment, cwd=home, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        if not result.exists():
            print(done.stdout.decode(errors="replace")[-4000:])
            print("FreeCAD ended without a result" + where_it_was(Path(str(result) + ".stuck")))
            return 1
        text = result.read_text(encoding="utf-8")
        print(text)
        return 0 if text.startswith("ok") else SKIPPED if text.startswith("skipped") else 1


def environment_of(home):
    """That of a user with this home who has set nothing for FreeCAD or FeatureMesh."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("FEATUREMESH_ENGINE", "XDG_", "PYTHONPATH", "FREECAD_USER"))}
    return {**kept, "HOME": str(home), "LC_ALL": "C.UTF-8", "QTWEBENGINE_DISABLE_SANDBOX": "1"}


def addons(environment):
    """The folder of the user's addons, after FeatureMesh was installed there."""
    said = subprocess.run([LAUNCHER, "install"], env=environment, stdout=subprocess.PIPE, text=True, check=True).stdout
    return Path(re.search(r"^FeatureMesh is installed in (.*); start FreeCAD anew$", said, re.MULTILINE).group(1)).parent


def where_it_was(stuck):
    """Where the script was when its time was over."""
    text = stuck.read_text(encoding="utf-8") if stuck.exists() else ""
    return " after %d s, at:\n%s" % (SECONDS, text) if text else ""


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

# SPDX-License-Identifier: GPL-3.0-or-later
"""FreeCAD's real window on a virtual screen; skipped (exit code 77) where there is no FreeCAD window or no Xvfb.

Runs drive_window.py, or the script of this folder that is named.
"""
import os
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
WORKBENCH = os.path.join(HERE, "..", "..", "Mod", "FeatureMesh")


def main(script="drive_window.py"):
    freecad, screen = shutil.which("freecad") or shutil.which("FreeCAD"), shutil.which("xvfb-run")
    if not freecad or not screen:
        print("skipped: needs freecad and xvfb-run")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        result = os.path.join(folder, "result")
        environment = dict(os.environ, LC_ALL="C.UTF-8", FEATUREMESH_RESULT=result, FREECAD_USER_HOME=folder,
                           QTWEBENGINE_DISABLE_SANDBOX="1")
        done = subprocess.run([screen, "-a", "-s", "-screen 0 1280x800x24", freecad, os.path.join(HERE, script),
                               "--module-path=" + os.path.abspath(WORKBENCH)],
                              env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              timeout=280, check=False)
        if not os.path.exists(result):
            print(done.stdout.decode(errors="replace")[-4000:])
            print("FreeCAD ended without a result")
            return 1
        with open(result, encoding="utf-8") as stream:
            text = stream.read()
        print(text)
        return 0 if text.startswith("ok") else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

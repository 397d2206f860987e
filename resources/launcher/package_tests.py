# SPDX-License-Identifier: GPL-3.0-or-later
"""`./featuremesh test --packages`: what is in dist, looked into, and installed in roots that have FreeCAD but nothing to build with."""
import json
import subprocess
from pathlib import Path

import freecad_roots
from freecad_task import freecad_environment, run_script
from layout import BUILD, ROOT, Failure
from setup_log import say
from wheels import PYTHON

FOLDER = ROOT / "tests" / "packages"
EXPECTED = BUILD / "expected-nodes.json"
ASKED = BUILD / "asked.pickle"   # what an installed engine was asked, see replay.py
DEBS_FREECAD = "0.20"   # the Debian for which the .deb is made has this FreeCAD

NO_TESTS = 5   # unittest's exit code since Python 3.12 when the pattern fits none


def run(versions, only):
    """Throws Failure when a test fails, Unavailable where there can be no root."""
    pattern = ["-k", only] if only else []
    say("looking into the packages")
    if subprocess.run([PYTHON, "-B", str(FOLDER / "check_contents.py"), *pattern]).returncode not in (0, NO_TESTS):
        raise Failure("the packages are not as they should be")
    write_expected()
    for version in versions:
        say(f"installing the packages beside FreeCAD {version}")
        ASKED.unlink(missing_ok=True)
        if freecad_roots.run_in_users_root(version, install_command(version, pattern)) not in (0, NO_TESTS):
            raise Failure(f"the packages fail beside FreeCAD {version}")
        if ASKED.exists() and subprocess.run([PYTHON, "-B", str(FOLDER / "replay.py"), str(ASKED)], env=freecad_environment()).returncode:
            raise Failure(f"the engine built from source makes other nodes of what FreeCAD {version} asked")
    print(f"the packages pass beside FreeCAD {', '.join(versions)}")
    return 0


def install_command(version, pattern):
    """The tests, as they are typed in a root that has the checkout at CHECKOUT."""
    inside = Path(freecad_roots.CHECKOUT)
    return ["env", f"EXPECTED={inside / EXPECTED.relative_to(ROOT)}", f"ASKED={inside / ASKED.relative_to(ROOT)}",
            *(["WITH_DEB=1"] if version == DEBS_FREECAD else []),
            "/usr/bin/python3", "-B", str(inside / "tests" / "packages" / "check_install.py"), *pattern]


def write_expected():
    """What the engine that was built from source makes of the example."""
    said = run_script(FOLDER / "mesh_example.py", {"FEATUREMESH_EXAMPLE": str(ROOT / "resources" / "examples" / "bracket.FCStd")})
    if "error" in said:
        raise Failure(f"the engine built from source fails: {said['error']}")
    EXPECTED.write_text(json.dumps({name: said[name] for name in ("mesh", "update")}), encoding="utf-8")

# SPDX-License-Identifier: GPL-3.0-or-later
"""Where things are in the checkout, and the launcher's ways to fail."""
import os
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build"
# Another build, such as one with sanitizers, is tested by naming its folder.
RELEASE = Path(os.environ.get("FEATUREMESH_BUILD", BUILD / "release"))
CGAL = BUILD / "deps" / "cgal"
SETUP_LOG = BUILD / "setup.log"
FREECAD_LOG = BUILD / "freecad.log"
WORKBENCH = ROOT / "Mod" / "FeatureMesh"
EXAMPLES = ROOT / "resources" / "examples"


class UserError(Exception):
    """The user asked for something that cannot be: exit code 2."""


class Failure(Exception):
    """Something of ours, or of the machine, went wrong: exit code 1."""


class Unavailable(Exception):
    """What was asked for cannot be had on this machine or now, such as another Debian release: exit code 3."""

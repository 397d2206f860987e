# SPDX-License-Identifier: GPL-3.0-or-later
"""What this package needs of FreeCAD's Python, told in one sentence where it is not there."""

import importlib.util

import FreeCAD

translate = FreeCAD.Qt.translate


def what_is_missing():
    """Why this package cannot run in this FreeCAD, in one sentence; "" where it can."""
    found = importlib.util.find_spec("numpy")
    if found is not None and found.origin:   # a folder that another package left has no file to start from
        return ""
    return translate("FeatureMesh", "FeatureMesh needs numpy, which this FreeCAD has not; install it (Debian: python3-numpy) and start FreeCAD anew.")


def check():
    """Throws ImportError with that sentence."""
    reason = what_is_missing()
    if reason:
        raise ImportError(reason)

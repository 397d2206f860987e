# SPDX-License-Identifier: GPL-3.0-or-later
"""What a bug report needs to know: versions, where things are and how they were installed."""

import os
import platform

import Part

from . import __version__, engine, log, versions
from .errors import EngineMissing

_PACKAGE = os.path.dirname(os.path.abspath(__file__))
_WORKBENCH = os.path.dirname(os.path.dirname(_PACKAGE))


def facts():
    """[(name, value)] in the order to be shown. An engine that cannot be used is told as such."""
    return [("FeatureMesh", "%s, %s, in %s" % (__version__, _how_the_addon_came(), _WORKBENCH)), *_of_engine(),
            ("FreeCAD", "%s with OCCT %s" % (versions.text(), Part.OCC_VERSION)),
            ("Python", "%s, numpy %s" % (platform.python_version(), _numpy())),
            ("System", platform.platform()),
            ("Log", log.path() if log.is_written() else "none, %s cannot be written" % log.path())]


def text():
    """The facts as lines."""
    return "\n".join("%-15s %s" % (name + ":", value) for name, value in facts())


def _of_engine():
    try:
        place = engine.chosen()
        said = engine.about()
    except EngineMissing as error:
        return [("Engine", str(error))]
    where = "in a process of its own" if engine.runs_in_worker() else "in FreeCAD's process"
    return [("Engine", "%s, protocol %d, %s, in %s, runs %s" % (said["version"], said["protocol"], _how_the_engine_came(place), place.folder, where)),
            ("Its libraries", "OCCT %s, CGAL %s, %s" % (said["occt"], said["cgal"], "oneTBB " + said["tbb"]))]


def _how_the_addon_came():
    if os.path.isfile(os.path.join(_WORKBENCH, "..", "..", "CMakeLists.txt")):
        return "from a clone"
    if _WORKBENCH.startswith("/usr/"):
        return "installed by the system's packages"
    if os.path.isdir(os.path.join(_WORKBENCH, "engines")):
        return "unpacked from the portable zip"
    return "installed as an addon"


def _how_the_engine_came(place):
    if place.folder == os.path.join(_WORKBENCH, "engines"):
        return "from the portable zip"
    if place.brings_its_libraries():
        return "from a wheel"
    if place.folder.startswith("/usr/"):
        return "installed by the system's packages"
    return "built from source"


def _numpy():
    try:
        import numpy
        return numpy.__version__
    except ImportError:
        return "is missing"

# SPDX-License-Identifier: GPL-3.0-or-later
"""What a bug report needs to know: versions, where things are and how they were installed."""

import os
import platform

import Part

from . import __version__, engine, log, versions
from .errors import EngineMissing
from .messages import english, of_error, said

_PACKAGE = os.path.dirname(os.path.abspath(__file__))
_WORKBENCH = os.path.dirname(os.path.dirname(_PACKAGE))


def facts(say=english):
    """[(name, value)] in the order to be shown, as `say` puts messages into words. An engine that cannot be used is told as such."""
    return [tuple(map(say, fact)) for fact in _facts()]


def text(say=english):
    """The facts as lines."""
    return "\n".join("%-17s %s" % (name + ":", value) for name, value in facts(say))


def _facts():
    addon = said("{version:text}, {came:messages}, in {folder:text}", version=__version__, came=_how_the_addon_came(), folder=_WORKBENCH)
    return [("FeatureMesh", addon), *_of_engine(),
            ("FreeCAD", said("{version:text} with OCCT {occt:text}", version=versions.text(), occt=Part.OCC_VERSION)),
            ("Python", said("{version:text}, numpy {numpy:messages}", version=platform.python_version(), numpy=_numpy())),
            (said("System"), platform.platform()),
            (said("Log"), log.path() if log.is_written() else said("none, {path:text} cannot be written", path=log.path()))]


def _of_engine():
    try:
        place = engine.chosen()
        known = engine.about()
    except EngineMissing as error:
        return [(said("Engine"), of_error(error))]
    where = said("in a process of its own") if engine.runs_in_worker() else said("in FreeCAD's process")
    return [(said("Engine"), said("{version:text}, protocol {protocol:count}, {came:messages}, in {folder:text}, runs {where:messages}",
                                  version=known["version"], protocol=known["protocol"], came=_how_the_engine_came(place), folder=place.folder, where=where)),
            (said("Its libraries"), "OCCT %s, CGAL %s, oneTBB %s" % (known["occt"], known["cgal"], known["tbb"]))]


def _how_the_addon_came():
    if os.path.isfile(os.path.join(_WORKBENCH, "..", "..", "CMakeLists.txt")):
        return said("from a clone")
    if _WORKBENCH.startswith("/usr/"):
        return said("installed by the system's packages")
    if os.path.isdir(os.path.join(_WORKBENCH, "engines")):
        return said("unpacked from the portable zip")
    return said("installed as an addon")


def _how_the_engine_came(place):
    if place.folder == os.path.join(_WORKBENCH, "engines"):
        return said("from the portable zip")
    if place.brings_its_libraries():
        return said("from a wheel")
    if place.folder.startswith("/usr/"):
        return said("installed by the system's packages")
    return said("built from source")


def _numpy():
    try:
        import numpy
        return numpy.__version__
    except ImportError:
        return said("is missing")

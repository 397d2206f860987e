# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the compiled engine, and loads it here or runs it in a process of its own.

Scripts and freecadcmd run it here. FreeCAD's window calls `run_in_worker`, so that a crash of the geometry kernel cannot take FreeCAD
along. Either way `load()` gives the same functions with the same results.
"""

import importlib
import importlib.util
import os
import sys

import FreeCAD

from . import worker
from .errors import EngineMissing

translate = FreeCAD.Qt.translate
_NAME = "featuremesh_engine"
_PACKAGE = os.path.dirname(os.path.abspath(__file__))
_WORKBENCH = os.path.dirname(os.path.dirname(_PACKAGE))
# FreeCAD with a window, and since 1.0 every FreeCAD, ignores PYTHONPATH. Installed, the engine lies beside this package or in the workbench's folder; in a
# clone, where the launcher builds it.
_PLACES = (os.environ.get("FEATUREMESH_ENGINE", ""), _PACKAGE, _WORKBENCH,
           os.path.join(_WORKBENCH, "..", "..", "build", "release", "bindings"))
_worker = None   # the WorkerEngine, where the engine runs in a process of its own


def run_in_worker():
    """From now on the engine runs in a process of its own."""
    global _worker
    if _worker is None:
        _worker = worker.WorkerEngine()


def run_here():
    """From now on the engine runs in FreeCAD's own process."""
    global _worker
    if _worker is not None:
        _worker.stop()
    _worker = None


def runs_in_worker():
    """Does the engine run in a process of its own?"""
    return _worker is not None


def load():
    """The engine: the module `featuremesh_engine`, or its functions in a worker process. Throws EngineMissing."""
    if _worker is None:
        return _load_here()
    _worker.folder = folder()
    try:
        _worker.start()
    except worker.CannotStart as error:
        FreeCAD.Console.PrintWarning(translate(
            "FeatureMesh", "FeatureMesh cannot start its worker process and runs inside FreeCAD: %s") % error + "\n")
        run_here()
        return _load_here()
    return _worker


def folder():
    """The folder with the compiled engine: on the Python path, or beside this package. Throws EngineMissing."""
    spec = importlib.util.find_spec(_NAME)
    if spec is not None and spec.origin:
        return os.path.dirname(os.path.abspath(spec.origin))
    for place in filter(os.path.isdir, _PLACES):
        if any(name.startswith(_NAME + ".") and name.endswith((".so", ".pyd", ".py")) for name in os.listdir(place)):
            return os.path.abspath(place)
    raise EngineMissing(translate("FeatureMesh", "FeatureMesh's compiled engine (featuremesh_engine) is not installed; "
                        "the mesh is shown as it was saved. Any command of `./featuremesh` in a clone builds it."))


def _load_here():
    place = folder()
    if place not in map(os.path.abspath, sys.path):
        sys.path.append(place)
        importlib.invalidate_caches()
    try:
        return importlib.import_module(_NAME)
    except ImportError as error:
        raise EngineMissing(translate("FeatureMesh", "FeatureMesh's engine could not be loaded: %s") % error) from error

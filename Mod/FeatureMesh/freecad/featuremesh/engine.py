# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds and loads the compiled engine, once, when it is first needed."""

import importlib
import os
import sys

from .errors import EngineMissing

_PACKAGE = os.path.dirname(os.path.abspath(__file__))
_WORKBENCH = os.path.dirname(os.path.dirname(_PACKAGE))
# FreeCAD with a window ignores PYTHONPATH. Installed, the engine lies beside this package or in the workbench's folder; in a
# clone, where the launcher builds it.
_PLACES = (os.environ.get("FEATUREMESH_ENGINE", ""), _PACKAGE, _WORKBENCH,
           os.path.join(_WORKBENCH, "..", "..", "build", "release", "bindings"))


def load():
    """The module `featuremesh_engine`: from the Python path, or beside this package. Throws EngineMissing."""
    try:
        return importlib.import_module("featuremesh_engine")
    except ModuleNotFoundError as error:
        if error.name != "featuremesh_engine":
            raise EngineMissing("FeatureMesh's engine could not be loaded: %s" % error) from error
    except ImportError as error:
        raise EngineMissing("FeatureMesh's engine could not be loaded: %s" % error) from error
    for place in filter(os.path.isdir, _PLACES):
        if any(name.startswith("featuremesh_engine.") and name.endswith((".so", ".pyd", ".py"))
               for name in os.listdir(place)):
            sys.path.append(place)
            importlib.invalidate_caches()
            return importlib.import_module("featuremesh_engine")
    raise EngineMissing("FeatureMesh's compiled engine (featuremesh_engine) is not installed; "
                        "the mesh is shown as it was saved. Any command of `./featuremesh` in a clone builds it.")

# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds and loads the compiled engine, once, when it is first needed."""

import importlib
import os
import sys

from .errors import EngineMissing

_PACKAGE = os.path.dirname(os.path.abspath(__file__))
_PLACES = (_PACKAGE, os.path.dirname(os.path.dirname(_PACKAGE)))


def load():
    """The module `featuremesh_engine`: from the Python path, or beside this package. Throws EngineMissing."""
    try:
        return importlib.import_module("featuremesh_engine")
    except ModuleNotFoundError as error:
        if error.name != "featuremesh_engine":
            raise EngineMissing("FeatureMesh's engine could not be loaded: %s" % error) from error
    except ImportError as error:
        raise EngineMissing("FeatureMesh's engine could not be loaded: %s" % error) from error
    for place in _PLACES:
        if any(name.startswith("featuremesh_engine.") and name.endswith((".so", ".pyd", ".py"))
               for name in os.listdir(place)):
            sys.path.append(place)
            importlib.invalidate_caches()
            return importlib.import_module("featuremesh_engine")
    raise EngineMissing("FeatureMesh's compiled engine (featuremesh_engine) is not installed; "
                        "the mesh is shown as it was saved. Build and install it with `./featuremesh install`.")

# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the example documents; runs in FreeCAD, the folder is named by FEATUREMESH_EXAMPLES (default: this one).

    freecadcmd resources/examples/make_examples.py
"""
import os
import sys

FOLDER = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, FOLDER)

import freecad  # noqa: E402

freecad.__path__.append(os.path.join(FOLDER, "..", "..", "Mod", "FeatureMesh", "freecad"))
import FreeCAD as App  # noqa: E402
from all_examples import MAKERS  # noqa: E402
from freecad.featuremesh.documents import add_view  # noqa: E402

for name, make in MAKERS.items():
    document = make()
    path = os.path.join(os.environ.get("FEATUREMESH_EXAMPLES", FOLDER), name + ".FCStd")
    document.saveAs(path)
    add_view(document, path)
    App.closeDocument(document.Name)

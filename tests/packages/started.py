# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs in FreeCAD's window, once that waits for its user: writes which workbenches and commands there are to FEATUREMESH_RESULT, and closes it."""
import json
import os

import FreeCADGui as Gui

with open(os.environ["FEATUREMESH_RESULT"], "w", encoding="utf-8") as result:
    json.dump({"workbenches": list(Gui.listWorkbenches()), "commands": [name for name in Gui.listCommands() if name.startswith("FeatureMesh_")]}, result)
Gui.getMainWindow().close()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs in FreeCAD: writes the folder that holds the user's settings and add-ons."""
import json
import os

import FreeCAD

with open(os.environ["FEATUREMESH_RESULT"], "w", encoding="utf-8") as result:
    json.dump({"user_folder": FreeCAD.getUserAppDataDir()}, result)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Looks at the window that a user just started, writes what is there to the file FEATUREMESH_RESULT, and closes it. Run by test_start.py."""
import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import window  # noqa: E402
from freecad.featuremesh import api  # noqa: E402

main = Gui.getMainWindow()
window.wait_for(main.isVisible)
window.spin(1)
seen = {"documents": [document.FileName for document in FreeCAD.listDocuments().values()],
        "shown": [obj.Name for document in FreeCAD.listDocuments().values() for obj in document.Objects if obj.ViewObject.isVisible()],
        "commands": [name for name in Gui.listCommands() if name.startswith("FeatureMesh_")],
        "workbench": os.path.realpath(api.__file__),
        "engine": api.about()}
with open(os.environ["FEATUREMESH_RESULT"], "w", encoding="utf-8") as stream:
    json.dump(seen, stream)
timer = window.answer_with("Discard", [])   # FreeCAD 1.x brings the properties of a file of 0.20 up to date, and asks
main.close()

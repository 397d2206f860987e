# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the workbench known when FreeCAD's window starts, or says what it lacks."""

import os

import FreeCAD
import FreeCADGui as Gui

from freecad.featuremesh import requirements

Gui.addLanguagePath(os.path.join(os.path.dirname(__file__), "translations"))
Gui.updateLocale()

if requirements.what_is_missing():
    FreeCAD.Console.PrintError(requirements.what_is_missing() + "\n")
else:
    from freecad.featuremesh.gui import start
    start.start()

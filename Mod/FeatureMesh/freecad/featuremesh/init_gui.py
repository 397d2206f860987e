# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the workbench known when FreeCAD's window starts."""

import FreeCADGui as Gui

from freecad.featuremesh import mesh_object, view_provider
from freecad.featuremesh.commands import COMMANDS, register
from freecad.featuremesh.gui import fem_toolbar
from freecad.featuremesh.gui.running import run_with_indicator


class FeatureMeshWorkbench(Gui.Workbench):
    """Meshes that stay alive."""

    MenuText = "FeatureMesh"
    ToolTip = "FEM meshes that are updated, not thrown away, when the part is edited"
    Icon = view_provider.icon("FeatureMesh")

    def Initialize(self):
        self.appendToolbar("FeatureMesh", list(COMMANDS))
        self.appendMenu("FeatureMesh", list(COMMANDS))

    def GetClassName(self):
        return "Gui::PythonWorkbench"


mesh_object.on_ready.append(view_provider.attach)
mesh_object.run_job = run_with_indicator
Gui.addIconPath(view_provider.ICONS)
register()
Gui.addWorkbench(FeatureMeshWorkbench())
fem_toolbar.install(["FeatureMesh_MeshPart", "FeatureMesh_UpdateNow"])

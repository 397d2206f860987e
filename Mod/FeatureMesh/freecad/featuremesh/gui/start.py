# SPDX-License-Identifier: GPL-3.0-or-later
"""The workbench, and all that it connects with FreeCAD's window when that starts."""

import FreeCAD
import FreeCADGui as Gui

from .. import assembled, assembled_view, error_sizes, live_result, live_view, mesh_object, orphans, size_zone, study_view, view_provider, waiting, zone_view
from ..commands import COMMANDS, IN_FEM, OF_A_MESH
from ..commands.freecad import register
from ..study import study_object, window_run
from . import clicks, fem_toolbar, live_runner, open_panels, preferences_page, recording, running, showing, study_runs, theme


class FeatureMeshWorkbench(Gui.Workbench):
    """Meshes that stay alive."""

    MenuText = "FeatureMesh"
    ToolTip = FreeCAD.Qt.translate("FeatureMesh", "FEM meshes that are updated, not thrown away, when the part is edited")
    Icon = view_provider.icon("FeatureMesh")

    def Initialize(self):
        self.appendToolbar("FeatureMesh", list(COMMANDS))
        self.appendMenu("FeatureMesh", list(COMMANDS))

    def Activated(self):
        from . import welcome
        welcome.show_once()

    def ContextMenu(self, recipient):
        """What the right button opens in the 3D view over a mesh, or a part that has one; in the tree the mesh itself adds these."""
        if recipient == "View" and fem_toolbar.is_mesh_selected():
            self.appendContextMenu("", list(OF_A_MESH))

    def GetClassName(self):
        return "Gui::PythonWorkbench"


def start():
    """Makes the workbench known."""
    mesh_object.on_ready.append(view_provider.ViewFeatureMesh.attach_to)
    live_result.on_ready += [live_view.ViewLiveResult.attach_to, showing.uncover]
    live_result.on_solution.append(live_view.show_solution)
    study_object.on_ready.append(study_view.ViewStudy.attach_to)
    size_zone.on_ready.append(zone_view.ViewSizeZone.attach_to)
    error_sizes.on_ready.append(zone_view.ViewErrorSizes.attach_to)
    assembled.on_ready.append(assembled_view.attach)
    orphans.install()
    live_runner.install()
    study_runs.install()
    mesh_object.run_job = window_run.run_job = running.run_with_escape
    waiting.repaint = running.repaint
    preferences_page.choose_place()
    Gui.addIconPath(view_provider.ICONS)
    Gui.addPreferencePage(preferences_page.PreferencesPage, "FeatureMesh")
    register()
    Gui.addWorkbench(FeatureMeshWorkbench())
    fem_toolbar.install(IN_FEM)
    open_panels.install()
    clicks.install()
    showing.install()
    recording.install()
    theme.install()

# SPDX-License-Identifier: GPL-3.0-or-later
import FreeCADGui as Gui

from .base import MeshCommand, selected_mesh


class Command(MeshCommand):
    name = "FeatureMesh_ShowKept"
    text = "Show what was kept"
    tooltip = "Colours the elements: blue ones were kept by the last update, orange ones are new"
    edits = False

    def run(self, document):
        from ..gui.kept_panel import KeptPanel
        Gui.Control.showDialog(KeptPanel(selected_mesh(document)))

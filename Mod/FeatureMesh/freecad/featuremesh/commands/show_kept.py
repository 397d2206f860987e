# SPDX-License-Identifier: GPL-3.0-or-later
import FreeCADGui as Gui

from .base import MeshCommand, selected_mesh


class Command(MeshCommand):
    name = "FeatureMesh_ShowKept"
    text = "Show what was kept"
    tooltip = "Colours the elements: those the last update kept, and new ones"
    edits = False

    def run(self, document):
        from ..gui.kept_panel import KeptPanel
        Gui.Control.showDialog(KeptPanel(selected_mesh(document)))

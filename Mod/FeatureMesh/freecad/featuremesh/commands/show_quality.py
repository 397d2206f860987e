# SPDX-License-Identifier: GPL-3.0-or-later
import FreeCADGui as Gui

from .base import MeshCommand, selected_mesh


class Command(MeshCommand):
    name = "FeatureMesh_ShowQuality"
    text = "Show the quality"
    tooltip = "Colours the elements by their smallest angle, with a histogram and the worst elements"
    edits = False

    def run(self, document):
        from ..gui.quality_panel import QualityPanel
        Gui.Control.showDialog(QualityPanel(selected_mesh(document)))

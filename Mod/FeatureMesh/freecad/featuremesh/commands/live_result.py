# SPDX-License-Identifier: GPL-3.0-or-later
import FreeCADGui as Gui

from .. import api, statics
from .base import MeshCommand


class Command(MeshCommand):
    name = "FeatureMesh_LiveResult"
    text = "Live result"
    tooltip = "Solves the analysis after each recompute and shows stresses and displacements in colours"

    def is_possible(self, document):
        return any(obj.isDerivedFrom("Fem::FemAnalysis") for obj in document.Objects)

    def run(self, document):
        from ..gui.live_panel import LivePanel
        from ..gui.showing import what_covers
        chosen = [obj.Name for obj in Gui.Selection.getSelection(document.Name) if obj.isDerivedFrom("Fem::FemAnalysis")]
        live = api.live_result(api.find_analysis(document, *chosen[:1]))
        mesh = statics.mesh_of(live.Proxy.analysis(live))
        for obj in (mesh, *what_covers(mesh)):
            obj.ViewObject.Visibility = obj is live   # all others would hide the deformed part
        Gui.Control.showDialog(LivePanel(live))

# SPDX-License-Identifier: GPL-3.0-or-later
import contextlib

import FemGui
import FreeCADGui as Gui

from .. import analyses, api, live_result, statics
from ..gui import recording
from ..gui.undo import undo_step
from .base import MeshCommand


class Command(MeshCommand):
    name = "FeatureMesh_LiveResult"
    text = "Live result"
    tooltip = "Solves the analysis after each recompute and shows stresses and displacements in colours"
    edits = False   # only where it adds one

    def is_possible(self, document):
        return bool(analyses.analyses_of(document))

    def run(self, document):
        from ..gui.live_panel import LivePanel
        analysis = _chosen_analysis(document) or api.find_analysis(document)
        statics.mesh_of(analysis)   # throws where there is none, before anything is changed
        is_new = live_result.of_analysis(analysis) is None
        with undo_step(document, self.title) if is_new else contextlib.nullcontext():
            Gui.Control.showDialog(LivePanel(api.live_result(analysis)))
        if is_new:
            recording.tell(api.live_result, analysis)


def _chosen_analysis(document):
    """The selected analysis, else FEM's active one; None where there is neither."""
    chosen = list(filter(analyses.is_analysis, Gui.Selection.getSelection(document.Name)))
    active = FemGui.getActiveAnalysis()
    return chosen[0] if chosen else active if active is not None and active.Document is document else None

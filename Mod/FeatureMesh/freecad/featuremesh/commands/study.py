# SPDX-License-Identifier: GPL-3.0-or-later
import FreeCADGui as Gui

from .. import api, reading
from ..gui import recording
from ..gui.undo import undo_step
from ..study import study_object
from .base import MeshCommand, selected_part


class Command(MeshCommand):
    name = "FeatureMesh_Study"
    text = "Parameter study"
    tooltip = "Varies dimensions of the part, meshes and solves each variant, and shows what matters"
    edits = False   # only where it adds one

    def is_possible(self, document):
        return bool(reading.final_parts(document))

    def run(self, document):
        from ..gui.study_panel import StudyPanel
        known = _chosen_study(document)
        if known is not None:
            recording.watch(known)
            Gui.Control.showDialog(StudyPanel(known))
            return
        part = selected_part(document)
        with undo_step(document, self.title):
            study = api.add_study(part)
            Gui.Control.showDialog(StudyPanel(study, is_new=True))   # within: else FreeCAD ends the step with the panel, and what is edited meanwhile is in it
        recording.made(study, api.add_study, part)


def _chosen_study(document):
    """The selected study, else that of the selected part, or with nothing selected the first; None where there is none yet."""
    selected = Gui.Selection.getSelection(document.Name)
    known = [obj for obj in document.Objects if study_object.is_study(obj)]
    chosen = [study for study in known if study in selected or not selected]
    if known and not chosen:
        part = selected_part(document)
        chosen = [study for study in known if study.Part is part]
    return chosen[0] if chosen else None

# SPDX-License-Identifier: GPL-3.0-or-later
import FreeCADGui as Gui

from .. import api, reading
from ..study import study_object
from .base import MeshCommand, selected_part


class Command(MeshCommand):
    name = "FeatureMesh_Study"
    text = "Parameter study"
    tooltip = "Varies dimensions of the part, meshes and solves each variant, and shows what matters"

    def is_possible(self, document):
        return bool(reading.final_parts(document))

    def run(self, document):
        from ..gui.study_panel import StudyPanel
        chosen = [obj for obj in Gui.Selection.getSelection(document.Name) if study_object.is_study(obj)]
        known = chosen or [obj for obj in document.Objects if study_object.is_study(obj)]
        study = known[0] if known else api.add_study(selected_part(document))
        Gui.Control.showDialog(StudyPanel(study))

# SPDX-License-Identifier: GPL-3.0-or-later
import FemGui
import FreeCAD
import FreeCADGui as Gui

from .. import analyses, api, preferences
from ..errors import UserError
from ..gui import message_box, recording
from ..messages import said
from .base import MeshCommand, only_shown_part, selected_container, selected_part

translate = FreeCAD.Qt.translate


class Command(MeshCommand):
    name = "FeatureMesh_MeshPart"
    text = "Mesh a part"
    tooltip = "Adds a mesh that follows the selected part (or the only one), or all parts of the selected container, and opens its settings"
    edits = False   # its panel ends the transaction

    def is_possible(self, document):
        return bool(document.Objects)

    def run(self, document):
        part = selected_container(document) or only_shown_part(document) or selected_part(document)
        existing = [mesh for mesh in api.meshes_of(document) if api.is_mesh_of(mesh, part)]
        if not existing:
            self.add_first(document, part)
            return
        selection = Gui.Selection.getSelection(document.Name)
        mesh = next((mesh for mesh in existing if mesh in selection), existing[0])
        chosen = self.ask(part, mesh)
        if chosen == "open":
            _open(mesh)
        elif chosen == "add":
            self.add(document, part)

    def add_first(self, document, part):
        """Adds a mesh; where its analysis has the mesh of another maker it is asked which of them is solved."""
        found = analyses.other_makers_mesh(document, FemGui.getActiveAnalysis())
        chosen = self.ask_whose_place(*found) if found else "keep"
        if chosen is not None:
            self.add(document, part, found[1] if chosen == "take" else None)

    def add(self, document, part, in_place_of=None):
        """Adds a mesh; the panel's OK and Apply end the transaction, Cancel takes it back."""
        document.openTransaction(self.title)
        try:
            mesh = recording.make(api.add_mesh, part, active_analysis=FemGui.getActiveAnalysis(), **preferences.for_new_mesh(in_place_of))
            if in_place_of is not None:
                in_place_of.ViewObject.Visibility = False
            _open(mesh)
        except Exception:
            FreeCAD.closeActiveTransaction(True)
            raise

    def ask(self, part, mesh):
        """The part has a mesh: "open" that, "add" another one, or None."""
        return message_box.answer(self.title, translate("FeatureMesh", "%s has the mesh %s already.") % (part.Label, mesh.Label), "",
                      {"open": translate("FeatureMesh", "Open it"), "add": translate("FeatureMesh", "Add another mesh")})

    def ask_whose_place(self, analysis, mesh):
        """The analysis has a mesh that is not ours: "take" its place, "keep" it there, or None."""
        return message_box.answer(self.title, translate("FeatureMesh", "%s has the mesh %s, and an analysis is solved with one mesh.") % (analysis.Label, mesh.Label),
                      translate("FeatureMesh", "The new mesh can take its place, with its refinements, groups, size and order; %s stays in the document.") % mesh.Label,
                      {"take": translate("FeatureMesh", "Take its place"), "keep": translate("FeatureMesh", "Leave it there")})


def _open(mesh):
    if not Gui.getDocument(mesh.Document).setEdit(mesh.Name):
        raise UserError(said("{object:text} cannot be opened while a panel is open; close that first", object=mesh.Label))

# SPDX-License-Identifier: GPL-3.0-or-later
import FemGui
import FreeCAD
import FreeCADGui as Gui
from PySide import QtGui

from .. import api, preferences
from ..errors import UserError
from ..messages import said
from .base import MeshCommand, is_mesh_of, only_shown_part, selected_container, selected_part

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
        existing = [mesh for mesh in api.meshes_of(document) if is_mesh_of(mesh, part)]
        if not existing:
            self.add(document, part)
            return
        selection = Gui.Selection.getSelection(document.Name)
        mesh = next((mesh for mesh in existing if mesh in selection), existing[0])
        answer = self.ask(part, mesh)
        if answer == "open":
            _open(mesh)
        elif answer == "add":
            self.add(document, part)

    def add(self, document, part):
        """Adds a mesh; the panel's OK and Apply end the transaction, Cancel takes it back."""
        document.openTransaction(self.title)
        try:
            _open(api.add_mesh(part, active_analysis=FemGui.getActiveAnalysis(), **preferences.for_new_mesh()))
        except Exception:
            FreeCAD.closeActiveTransaction(True)
            raise

    def ask(self, part, mesh):
        """The part has a mesh: "open" that, "add" another one, or None."""
        box = QtGui.QMessageBox(Gui.getMainWindow())
        box.setWindowTitle(self.title)
        box.setText(translate("FeatureMesh", "%s has the mesh %s already.") % (part.Label, mesh.Label))
        open_it = box.addButton(translate("FeatureMesh", "Open it"), QtGui.QMessageBox.AcceptRole)
        add = box.addButton(translate("FeatureMesh", "Add another mesh"), QtGui.QMessageBox.ActionRole)
        box.addButton(QtGui.QMessageBox.Cancel)
        box.setDefaultButton(open_it)
        box.exec_()
        return "open" if box.clickedButton() is open_it else "add" if box.clickedButton() is add else None


def _open(mesh):
    if not Gui.getDocument(mesh.Document).setEdit(mesh.Name):
        raise UserError(said("the settings of {mesh:text} cannot be opened; close the open panel first", mesh=mesh.Label))

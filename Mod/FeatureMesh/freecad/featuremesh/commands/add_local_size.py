# SPDX-License-Identifier: GPL-3.0-or-later
import FreeCADGui as Gui

from .. import api
from .base import MeshCommand, selected_mesh


class Command(MeshCommand):
    name = "FeatureMesh_AddLocalSize"
    text = "Add a local size"
    tooltip = "Gives the selected faces, edges or vertices half the mesh size, to be changed in FEM's refinement panel"

    def run(self, document):
        mesh = selected_mesh(document)
        references = [(entry.Object, name) for entry in Gui.Selection.getSelectionEx(document.Name)
                      for name in entry.SubElementNames]
        region = api.add_local_size(mesh, references)
        Gui.getDocument(document).setEdit(region.Name)

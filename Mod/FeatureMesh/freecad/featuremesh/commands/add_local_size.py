# SPDX-License-Identifier: GPL-3.0-or-later
from .. import api
from .base import MeshCommand, chosen, edit_in_fem, selected_mesh


class Command(MeshCommand):
    name = "FeatureMesh_AddLocalSize"
    text = "Add a local size"
    tooltip = "Gives the selected faces, edges or vertices half the mesh size, to be changed in FEM's refinement panel"

    def run(self, document):
        mesh = selected_mesh(document)
        edit_in_fem(api.add_local_size(mesh, chosen(document, mesh)))

# SPDX-License-Identifier: GPL-3.0-or-later
from .. import api
from .base import MeshCommand, chosen, edit_in_fem, selected_mesh


class Command(MeshCommand):
    name = "FeatureMesh_AddGroup"
    text = "Add a mesh group"
    tooltip = "Makes a named set of nodes and elements of the selected solids, faces, edges or vertices, to be changed in FEM's panel of mesh groups"

    def run(self, document):
        mesh = selected_mesh(document)
        edit_in_fem(api.add_group(mesh, chosen(document, mesh)))

# SPDX-License-Identifier: GPL-3.0-or-later
from .. import api
from ..gui import recording
from .base import MeshCommand, add_and_open, chosen, selected_mesh


class Command(MeshCommand):
    name = "FeatureMesh_AddGroup"
    text = "Add a mesh group"
    tooltip = "Makes a named set of nodes and elements of the selected solids, faces, edges or vertices, to be changed in FEM's panel of mesh groups"
    edits = False   # its panel ends the transaction

    def run(self, document):
        mesh = selected_mesh(document)
        add_and_open(document, self.title, lambda: recording.make(api.add_group, mesh, chosen(document, mesh)))

# SPDX-License-Identifier: GPL-3.0-or-later
from .. import api
from ..gui import recording
from .base import MeshCommand, add_and_open, chosen, selected_mesh


class Command(MeshCommand):
    name = "FeatureMesh_AddLocalSize"
    text = "Add a local size"
    tooltip = "Gives the selected faces, edges or vertices half the mesh size, to be changed in FEM's refinement panel"
    edits = False   # its panel ends the transaction

    def run(self, document):
        mesh = selected_mesh(document)
        add_and_open(document, self.title, lambda: recording.make(api.add_local_size, mesh, chosen(document, mesh)))

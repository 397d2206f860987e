# SPDX-License-Identifier: GPL-3.0-or-later
from .. import api, size_zone
from ..gui import recording
from .base import MeshCommand, add_and_open, chosen, selected_mesh


class Command(MeshCommand):
    name = "FeatureMesh_AddSizeZone"
    text = "Add a refinement zone"
    tooltip = "Makes elements smaller in a box, a sphere or a cylinder, or near the selected faces, edges or vertices"
    edits = False   # its panel ends the transaction

    def run(self, document):
        mesh = selected_mesh(document)
        references = [(obj, name) for obj, name in chosen(document, mesh) or () if name]
        add_and_open(document, self.title, lambda: recording.make(api.add_size_zone, mesh, size_zone.DISTANCE if references else size_zone.BOX, references))

# SPDX-License-Identifier: GPL-3.0-or-later
from .. import api
from .base import MeshCommand, selected_mesh


class Command(MeshCommand):
    name = "FeatureMesh_UpdateNow"
    text = "Update the mesh"
    tooltip = "Brings the mesh up to date with its part, only where the part changed"

    def run(self, document):
        api.update_mesh(selected_mesh(document))

    def failed(self, document, error):
        mesh = selected_mesh(document)
        mesh.Proxy.fail(mesh, error)   # putting the document back took this away, too
        super().failed(document, error)

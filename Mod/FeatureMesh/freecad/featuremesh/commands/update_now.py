# SPDX-License-Identifier: GPL-3.0-or-later
from .. import api
from ..gui import recording
from .base import MeshCommand, selected_mesh


class Command(MeshCommand):
    name = "FeatureMesh_UpdateNow"
    text = "Update the mesh"
    tooltip = "Brings the mesh up to date with its part, only where the part changed"

    def run(self, document):
        self._mesh = None
        self._mesh = selected_mesh(document)
        recording.run(api.update_mesh, self._mesh)

    def failed(self, document, error):
        if self._mesh is not None:
            self._mesh.Proxy.fail(self._mesh, error)   # putting the document back took this away, too
        super().failed(document, error)

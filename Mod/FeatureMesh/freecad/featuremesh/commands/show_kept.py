# SPDX-License-Identifier: GPL-3.0-or-later
from .. import overlays
from .base import MeshCommand, selected_mesh


class Command(MeshCommand):
    name = "FeatureMesh_ShowKept"
    text = "Show what was kept"
    tooltip = "Colours the elements: blue ones were kept by the last update, orange ones are new; once more: off"
    edits = False

    def run(self, document):
        mesh = selected_mesh(document)
        view = mesh.ViewObject.Proxy
        view.colour(mesh, {} if view.is_coloured else overlays.kept_colours(mesh))

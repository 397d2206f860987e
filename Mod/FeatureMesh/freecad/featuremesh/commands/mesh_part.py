# SPDX-License-Identifier: GPL-3.0-or-later
import FreeCADGui as Gui

from .. import api, preferences
from .base import MeshCommand, selected_part


class Command(MeshCommand):
    name = "FeatureMesh_MeshPart"
    text = "Mesh a part"
    tooltip = "Adds a mesh that follows the selected part (or the only one) and opens its settings"

    def is_possible(self, document):
        return bool(document.Objects)

    def run(self, document):
        mesh = api.add_mesh(selected_part(document), **preferences.for_new_mesh())
        Gui.getDocument(document).setEdit(mesh.Name)

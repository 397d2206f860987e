# SPDX-License-Identifier: GPL-3.0-or-later
from .. import api
from .base import MeshCommand, selected_part


class Command(MeshCommand):
    name = "FeatureMesh_ShowTree"
    text = "Show the feature tree"
    tooltip = "Lists the features of the selected part as the mesher understands them"
    edits = False

    def is_possible(self, document):
        return bool(document.Objects)

    def run(self, document):
        from ..gui.tables import show_tree
        part = selected_part(document)
        show_tree(part, api.tree(part))

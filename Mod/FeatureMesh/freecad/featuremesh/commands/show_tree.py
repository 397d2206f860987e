# SPDX-License-Identifier: GPL-3.0-or-later
from .. import api, tables
from .base import MeshCommand, selected_part


class Command(MeshCommand):
    name = "FeatureMesh_ShowTree"
    text = "Show the feature tree"
    tooltip = "Lists the features of the selected part as the mesher understands them"
    edits = False

    def is_possible(self, document):
        return bool(document.Objects)

    def run(self, document):
        from ..gui.tables import show_table
        part = selected_part(document)
        found = api.tree(part)
        header, rows = tables.rows_of_tree(found)
        show_table("%s: %s" % (self.text, part.Label), header, [(row, None, None) for row in rows], tables.tree_note(found))

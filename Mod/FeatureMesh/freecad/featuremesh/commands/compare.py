# SPDX-License-Identifier: GPL-3.0-or-later
import FreeCADGui as Gui
from PySide import QtGui

from .. import api, tables
from .base import MeshCommand, selected_part


class Command(MeshCommand):
    name = "FeatureMesh_Compare"
    text = "Compare with a document"
    tooltip = "Tells feature by feature what changed between a saved document and the selected part"
    edits = False

    def is_possible(self, document):
        return bool(document.Objects)

    def run(self, document):
        part = selected_part(document)
        path, _ = QtGui.QFileDialog.getOpenFileName(Gui.getMainWindow(), self.text, "", "FreeCAD (*.FCStd)")
        if path:
            self.show(part, path)

    def show(self, part, path):
        """Compares `part` with the part of the document in `path` and shows the table."""
        from ..gui.tables import show_table
        found = api.difference_to_file(part, path)
        header, rows = tables.rows_of_difference(found)
        entries = [(row, feature["verdict"], tables.face_names(feature["new_faces"]))
                   for row, feature in zip(rows, found["features"])]
        return show_table("%s: %s" % (self.text, part.Label), header, entries, tables.difference_note(found), part)

# SPDX-License-Identifier: GPL-3.0-or-later
import os

import FreeCADGui as Gui
from PySide import QtGui

from .. import api
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
        path, _ = QtGui.QFileDialog.getOpenFileName(Gui.getMainWindow(), self.title, os.path.dirname(document.FileName), "FreeCAD (*.FCStd)")
        if path:
            self.show(part, path)

    def show(self, part, path):
        """Compares `part` with the part of the document in `path` and shows the table."""
        from ..gui.tables import show_difference
        return show_difference(part, api.difference_to_file(part, path))

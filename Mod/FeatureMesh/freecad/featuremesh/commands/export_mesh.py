# SPDX-License-Identifier: GPL-3.0-or-later
import FreeCADGui as Gui
from PySide import QtGui

from .. import api
from .base import MeshCommand, selected_mesh

_FILTERS = "VTK (*.vtu);;Abaqus, CalculiX (*.inp);;UNV (*.unv);;MED (*.med)"


class Command(MeshCommand):
    name = "FeatureMesh_Export"
    text = "Export the mesh"
    tooltip = "Writes the mesh with its groups as VTK, Abaqus, UNV or MED"
    edits = False

    def run(self, document):
        mesh = selected_mesh(document)
        path, kind = QtGui.QFileDialog.getSaveFileName(Gui.getMainWindow(), self.title, mesh.Label + ".vtu", _FILTERS)
        if path:
            api.export_mesh(mesh, path)

# SPDX-License-Identifier: GPL-3.0-or-later
import os

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore

from .. import api
from ..export import FORMATS
from ..gui import recording
from .base import MeshCommand, selected_mesh

translate = FreeCAD.Qt.translate
_STAYS = 10000   # ms
_FILTERS = ";;".join(("VTK (*.vtu)", "VTK, legacy (*.vtk)", "Abaqus, CalculiX (*.inp)", "NASTRAN (*.bdf)", "Gmsh (*.msh)", "Surface (*.stl)",
                      "UNV (*.unv)", "MED (*.med)", "Z88 (*.z88)"))


class Command(MeshCommand):
    name = "FeatureMesh_Export"
    text = "Export the mesh"
    tooltip = "Writes the mesh with its groups as VTK, Abaqus, NASTRAN, Gmsh, UNV, MED or Z88, or its surface as STL"
    edits = False

    def run(self, document):
        mesh = selected_mesh(document)
        from ..gui.save_dialog import ask_for_file
        proposed = os.path.join(os.path.dirname(document.FileName), mesh.Label.replace("/", "-") + ".vtu")
        path = ask_for_file(Gui.getMainWindow(), self.title, proposed, _FILTERS, FORMATS)
        if path is not None:
            recording.run(api.export_mesh, mesh, path)
            tell(translate("FeatureMesh", "%s was written to %s (%s)") % (mesh.Label, path, _size_of(path)))


def tell(sentence):
    """In the report view and the status bar, where nobody has to answer."""
    FreeCAD.Console.PrintMessage("FeatureMesh: %s\n" % sentence)
    Gui.getMainWindow().statusBar().showMessage(sentence, _STAYS)


def _size_of(path):
    return QtCore.QLocale().formattedDataSize(os.path.getsize(path), 1, QtCore.QLocale.DataSizeSIFormat)

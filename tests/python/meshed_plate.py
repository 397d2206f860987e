# SPDX-License-Identifier: GPL-3.0-or-later
"""A plate with a hole and its mesh in a document, for tests that edit, save and reopen it."""
import os
import shutil
import tempfile
import unittest

import FreeCAD
from freecad.featuremesh import api, mesh_object
from parts import new_document, plate_with_hole

SIZE = 3.0


def points_of(mesh):
    """{number: (x, y, z)} of all nodes."""
    return {number: tuple(point) for number, point in mesh.FemMesh.Nodes.items()}


class MeshedPlate(unittest.TestCase):

    def setUp(self):
        self.document = new_document()
        self.body = plate_with_hole(self.document)
        self.mesh = api.add_mesh(self.body, SIZE, order=1)
        self.document.recompute()
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)

    def edit(self, x=22):
        """Moves the hole."""
        self.document.getObject("HoleSketch").setDatum("X", FreeCAD.Units.Quantity("%g mm" % x))
        self.document.recompute()

    def save_and_reopen(self):
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        path = os.path.join(folder, "part.FCStd")
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        self.mesh = self.document.getObject("FeatureMesh")
        self.body = self.document.getObject("Body")

# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh that an object of FreeCAD is given is the one that was made, not a copy, and the one before is freed."""
import contextlib
import unittest
from unittest import mock

import Fem
import FreeCAD
from freecad.featuremesh import given_mesh
from test_hand_over import contents
from test_soak import megabytes


def row_of_tets(count):
    mesh = given_mesh.empty()
    for i in range(count + 3):
        mesh.addNode(float(i), float(i * i % 97), float(i * i * i % 89), 2 * i + 1)
    for i in range(count):
        mesh.addVolume([2 * i + 1, 2 * i + 3, 2 * i + 5, 2 * i + 7], 3 * i + 2)
    mesh.addGroupElements(mesh.addGroup("Some", "Volume"), [2, 5])
    return mesh


def copying():
    """FreeCAD copies, as where its functions are not found."""
    return mock.patch.object(given_mesh, "_functions", return_value=None)


class GivenMesh(unittest.TestCase):

    def setUp(self):
        self.document = FreeCAD.newDocument("Given")
        self.document.UndoMode = 1
        self.object = self.document.addObject("Fem::FemMeshObject", "Mesh")
        self.addCleanup(FreeCAD.closeDocument, self.document.Name)

    def test_is_the_one_that_was_made(self):
        before, after = row_of_tets(20), row_of_tets(30)
        wanted = contents(after)
        self.object.FemMesh = before
        given_mesh.give(self.object, after)
        self.assertEqual(contents(self.object.FemMesh), wanted)
        self.assertEqual(contents(after), contents(before))   # what the object had

    def test_everybody_is_told(self):
        told = []

        class Observer:
            def slotChangedObject(self, obj, name):
                told.append((obj.Name, name, obj.FemMesh.VolumeCount if name == "FemMesh" else 0))

        observer = Observer()
        FreeCAD.addDocumentObserver(observer)
        self.addCleanup(FreeCAD.removeDocumentObserver, observer)
        given_mesh.give(self.object, row_of_tets(30))
        self.assertIn(("Mesh", "FemMesh", 30), told)

    def test_undo_and_redo_do_no_harm(self):
        for count in (10, 20, 30):
            self.document.openTransaction("%d" % count)
            given_mesh.give(self.object, row_of_tets(count))
            self.document.commitTransaction()
        for step in (self.document.undo, self.document.undo, self.document.redo):
            step()
            given_mesh.give(self.object, row_of_tets(5))
            self.assertEqual(contents(self.object.FemMesh), contents(row_of_tets(5)))

    def test_copies_where_it_has_to(self):
        moved = FreeCAD.Placement(FreeCAD.Vector(1, 2, 3), FreeCAD.Rotation())
        for name, placement, patch in (("not found", FreeCAD.Placement(), copying()), ("moved", moved, contextlib.nullcontext()),
                                       ("elsewhere", FreeCAD.Placement(), mock.patch.object(given_mesh, "_MOST_WORDS", 1))):
            with self.subTest(name), patch:
                self.object.Placement = placement
                given = row_of_tets(30)
                given_mesh.give(self.object, given)
                self.assertEqual(contents(self.object.FemMesh), contents(given))
                self.assertEqual(given.VolumeCount, 30)

    def test_an_empty_one_keeps_no_commands(self):
        """Each node and element of the other takes a command more, of some hundred bytes."""
        def filled(mesh):
            before = megabytes()
            for i in range(100000):
                mesh.addNode(float(i), 0.0, 0.0)
            return megabytes() - before
        kept = [mesh for mesh in (given_mesh.empty(), Fem.FemMesh())]
        self.assertLess(filled(kept[0]) + 5, filled(kept[1]))

    def growth(self):
        given_mesh.give(self.object, row_of_tets(20000))
        before = megabytes()
        for _ in range(8):
            given_mesh.give(self.object, row_of_tets(20000))
        return megabytes() - before

    def test_the_one_before_is_freed(self):
        with copying():
            copied = self.growth()
        self.assertLess(self.growth(), 0.75 * copied)   # FreeCAD keeps some of each mesh, freed or not


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""What is chosen on a part that was edited after its last mesh stays there, whatever comes between."""
import unittest

import FreeCAD
import ObjectsFem
from freecad.featuremesh import api, mesh_object, references
from freecad.featuremesh.messages import english
from meshed_plate import MeshedPlate
from parts import new_document, plate_with_hole


class ChosenAfterTheLastMesh(MeshedPlate):
    """The mesh is updated by hand, and the body's tip moved up, where its faces have other numbers."""

    def setUp(self):
        super().setUp()
        self.analysis = ObjectsFem.makeAnalysis(self.document, "Analysis")
        self.analysis.addObject(self.mesh)
        self.add("Early", 10)
        self.mesh.Automatic = False
        self.body.Tip = self.document.Plate
        self.document.recompute()
        self.add("Late", 0)
        self.assertEqual(self.mesh.Status, mesh_object.OUT_OF_DATE)

    def add(self, name, height):
        load = ObjectsFem.makeConstraintPressure(self.document, name)
        load.References = [(self.body, name) for name, _ in self.faces_at(height)]
        self.analysis.addObject(load)
        self.document.recompute()

    def faces_at(self, height):
        faces = [("Face%d" % number, face) for number, face in enumerate(self.body.Shape.Faces, 1)]
        return [(name, face) for name, face in faces if abs(face.BoundBox.ZMin - height) + abs(face.BoundBox.ZMax - height) < 1e-6]

    def check(self):
        api.update_mesh(self.mesh)
        for name, height in (("Early", 10), ("Late", 0)):
            load = self.document.getObject(name)
            self.assertEqual([sub for _, subs in load.References for sub in subs], [face for face, _ in self.faces_at(height)], name)

    def test_saved_and_opened(self):
        self.save_and_reopen()
        self.check()

    def test_edited_saved_and_opened(self):
        self.document.PlateSketch.setDatum("Width", FreeCAD.Units.Quantity("70 mm"))
        self.body.Tip = self.document.Hole
        self.document.recompute()
        self.save_and_reopen()
        self.check()
        self.save_and_reopen()
        self.check()

    def test_an_update_is_undone(self):
        self.document.UndoMode = 1
        self.document.openTransaction("Update")
        api.update_mesh(self.mesh)
        self.document.commitTransaction()
        self.document.undo()
        self.assertEqual(self.mesh.Status, mesh_object.OUT_OF_DATE)
        self.check()

    def test_what_cannot_be_followed_is_said(self):
        self.mesh.Proxy._noted._parts.clear()   # as in a document of another FreeCAD
        report = api.update_mesh(self.mesh)
        self.assertIn("Late could not be followed", "\n".join(map(english, report["warnings"])))


class AShapeThatAScriptSets(unittest.TestCase):
    """Since 1.0 FreeCAD lets references follow it, which nobody chose."""

    def test_what_is_lost_is_said_and_comes_back(self):
        document = new_document()
        body = plate_with_hole(document)
        part = document.addObject("Part::Feature", "Copy")
        part.Shape = body.Shape
        analysis, load = ObjectsFem.makeAnalysis(document, "Analysis"), ObjectsFem.makeConstraintPressure(document, "Load")
        wall, = (name for name in map("Face{}".format, range(1, 8)) if "Cylinder" in part.Shape.getElement(name).Surface.TypeId)
        load.References = [(part, wall)]
        mesh = api.add_mesh(part, 6.0, order=1)
        for member in {load, mesh} - set(analysis.Group):
            analysis.addObject(member)
        document.recompute()
        for tip, left in ((document.Plate, []), (document.Hole, [(part, (wall,))])):
            body.Tip = tip
            document.recompute()
            part.Shape = body.Shape
            document.recompute()
            self.assertEqual((mesh.Status, load.References, len(references.unmended(analysis))), (mesh_object.UP_TO_DATE, left, not left))

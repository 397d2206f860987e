# SPDX-License-Identifier: GPL-3.0-or-later
"""What loads act along stays as it was chosen, as what they act on does; and what they have lost comes back with its feature."""
import json
import os
import shutil
import tempfile

import FreeCAD
import ObjectsFem
from blocks import NEAR, BlockParts, warnings_of
from freecad.featuremesh import references, state
from parts import placement
from test_references import names_of


class ForcesAlong(BlockParts):
    """What tests of directions share."""

    def force_along(self, part, axis, target, face=None):
        """A force on the face at x = 100, or another one, along the longest edge with that axis, as clicked on `target`."""
        load = ObjectsFem.makeConstraintForce(self.document, "Force")
        load.References = [(target, face or self.face_at(part, "X", 100))]
        load.Direction = (target, [self.edge_along(part, axis)])
        self.analysis.addObject(load)
        return load

    def edge_along(self, part, axis):
        along = [(edge.Length, "Edge%d" % n) for n, edge in enumerate(part.Shape.Edges, 1) if abs(abs(getattr(edge.tangentAt(0), axis)) - 1) < NEAR]
        return max(along)[1]

    def direction_of(self, load):
        """The axis along which it acts, and what it refers to for that."""
        vector = load.DirectionVector
        axis, = [axis for axis in "xyz" if abs(abs(getattr(vector, axis)) - 1) < NEAR]
        return axis, getattr(vector, axis), load.Direction and (load.Direction[0].Name, load.Direction[1])


class Directions(ForcesAlong):
    """A force along an edge goes on along it, whatever becomes of the feature that was clicked and of the numbers of the edges."""

    def chamfered(self):
        body = self.block()
        chamfer = body.newObject("PartDesign::Chamfer", "Chamfer")
        chamfer.Base, chamfer.Size = (self.document.Block, ["Edge1"]), 3
        self.document.recompute()
        return body, chamfer

    def test_the_clicked_feature_is_deleted(self):
        """FreeCAD lets the force act along the normal of its face then."""
        body, chamfer = self.chamfered()
        load = self.force_along(body, "y", chamfer)
        self.mesh_of(body)
        before = self.direction_of(load)
        self.assertEqual((before[0], before[2][0]), ("y", "Body"))
        body.Tip = self.document.Block
        self.document.removeObject("Chamfer")
        self.document.recompute()
        self.assertEqual(self.direction_of(load)[:2], before[:2])
        self.assertEqual(abs(body.Shape.getElement(load.Direction[1][0]).tangentAt(0).y), 1)
        self.assertEqual(references.unmended(self.analysis), [])

    def test_the_edges_get_other_numbers(self):
        body = self.block()
        load = self.force_along(body, "y", body)
        load.Reversed = True
        self.mesh_of(body)
        before = self.direction_of(load)
        self.groove(body)
        self.assertEqual(self.direction_of(load)[:2], before[:2])
        self.assertEqual(abs(body.Shape.getElement(load.Direction[1][0]).tangentAt(0).y), 1)
        load.Direction = load.Direction   # as FEM's panel does with OK
        self.assertEqual(self.direction_of(load)[:2], before[:2])

    def test_the_body_is_turned(self):
        """FreeCAD 0.20 takes the direction of a clicked edge within its body, and looks at it no more."""
        body = self.block()
        body.Placement = placement(angle=90)
        self.document.recompute()
        load = self.force_along(body, "y", body.Tip, "Face1")
        self.mesh_of(body)
        within = body.Placement.Rotation.inverted().multVec(load.DirectionVector)
        self.assertGreater(abs(within.x), 1 - NEAR)
        for angle in (30, 270):
            body.Placement = placement(angle=angle)
            self.document.recompute()
            self.assertGreater(load.DirectionVector.dot(body.Placement.Rotation.multVec(within)), 1 - NEAR, angle)
            self.assertNotIn("Touched", load.State)

    def test_a_document_from_before_directions_were_followed(self):
        """Its record says nothing of them; the first edit comes after it was opened."""
        body = self.block()
        load = self.force_along(body, "y", body)
        self.mesh_of(body)
        before = self.direction_of(load)
        record = json.loads(self.mesh.ReferredTo)
        del record["Force"]["along"]
        self.mesh.ReferredTo = json.dumps(record)
        self.mesh.StateName = ""
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        self.document.saveAs(os.path.join(folder, "old.FCStd"))
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(os.path.join(folder, "old.FCStd"))
        self.mesh = self.document.FeatureMesh
        self.assertEqual(self.mesh.StateName, state.checksum_of(self.mesh.SavedState))
        self.assertNotIn("Touched", self.mesh.State)
        self.groove(self.document.Body)
        self.assertNotEqual(self.document.Force.Direction[1], before[2][1])
        self.assertEqual(self.direction_of(self.document.Force)[:2], before[:2])

    def test_an_edge_is_split_and_made_one_again(self):
        """A load on it is on all pieces, as on a face that is split."""
        body = self.block()
        load = self.force_along(body, "y", body)
        edge = self.edge_along(body, "x")
        place = body.Shape.getElement(edge).CenterOfMass
        if place.z < 20:
            edge = "Edge%d" % next(n for n, other in enumerate(body.Shape.Edges, 1) if abs(other.Length - 100) < NEAR and other.CenterOfMass.z > 20 - NEAR)
        load.References, load.Direction = [(body, edge)], (body, [edge])
        self.mesh_of(body)
        groove = self.groove(body)
        self.assertEqual(sorted(round(body.Shape.getElement(name).Length, 6) for _, name in names_of(load)), [40, 50])
        self.assertEqual(self.direction_of(load)[0], "x")
        self.document.GrooveSketch.setDatum("X", 50)
        self.document.recompute()
        self.assertEqual(sorted(round(body.Shape.getElement(name).Length, 6) for _, name in names_of(load)), [40, 50])
        self.document.removeObject(groove.Name)
        body.Tip = self.document.Block
        self.document.recompute()
        self.assertEqual([body.Shape.getElement(name).Length for _, name in names_of(load)], [100])
        self.assertEqual(self.direction_of(load)[0], "x")

    def test_an_edge_gets_longer_as_it_is_split(self):
        """Of a box, and of a sheet, all of whose free edges have the same one face."""
        for kind in ("Part::Box", "Part::Plane"):
            with self.subTest(kind):
                self.setUp()
                base, drill, cut = (self.document.addObject(name) for name in (kind, "Part::Cylinder", "Part::Cut"))
                base.Length, base.Width, drill.Radius, drill.Height, drill.Placement.Base = 60, 20, 3, 40, FreeCAD.Vector(40, -8, -5)
                cut.Base, cut.Tool = base, drill
                self.document.recompute()
                places = {"Near": ("YMax", 0), "End": ("XMin", 60)}
                loads = {place: ObjectsFem.makeConstraintForce(self.document, place) for place in places}
                for place, load in loads.items():
                    load.References = [(cut, self.edges_at(cut, *places[place]))]
                    self.analysis.addObject(load)
                self.mesh_of(cut)
                base.Length, drill.Placement.Base.y = 64, 0
                self.document.recompute()
                places["End"] = ("XMin", 64)
                for place, load in loads.items():
                    self.assertEqual({name for _, name in names_of(load)}, set(self.edges_at(cut, *places[place])), place)

    def edges_at(self, part, side, value):
        """The edges of a sheet, or of a box's bottom, there."""
        return ["Edge%d" % number for number, edge in enumerate(part.Shape.Edges, 1) if abs(getattr(edge.BoundBox, side) - value) < NEAR and edge.BoundBox.ZMax < NEAR]

    def test_the_edge_is_gone(self):
        """Nothing is solved until somebody says along what the force is to act; undo brings the edge back."""
        self.document.UndoMode = 1
        body, chamfer = self.chamfered()
        load = self.force_along(body, "y", body)
        edge, = [name for name, edge in ((n, body.Shape.getElement("Edge%d" % n)) for n in range(1, 1 + len(body.Shape.Edges)))
                 if abs(edge.CenterOfMass.x - 3) < NEAR and abs(edge.CenterOfMass.y) < NEAR][:1]
        load.Direction = (body, ["Edge%d" % edge])
        self.mesh_of(body)
        before = self.direction_of(load)
        self.document.openTransaction("Delete the chamfer")
        body.Tip = self.document.Block
        self.document.removeObject("Chamfer")
        self.document.recompute()
        self.document.commitTransaction()
        (lost, sentence), = references.unmended(self.analysis)
        self.assertEqual((lost, sentence), (load, "Force acts along Edge%d, which is gone; open it and choose its direction again" % edge))
        self.assertTrue(any("choose its direction again" in line for line in warnings_of(self.mesh)), warnings_of(self.mesh))
        self.document.undo()
        self.assertEqual(references.unmended(self.analysis), [])
        self.assertEqual(self.direction_of(load), before)
        self.document.redo()
        self.assertEqual(len(references.unmended(self.analysis)), 1)
        load.Direction = (body, [self.edge_along(body, "x")])
        self.assertEqual(references.unmended(self.analysis), [])
        self.assertEqual(self.direction_of(load)[0], "x")


class ComesBack(ForcesAlong):
    """A body's tip is moved up, a feature is put in between, and the tip moved down again: what the features below have is there again."""

    def setUp(self):
        super().setUp()
        self.body = self.block()
        self.pocket = self.groove(self.body)
        self.pressed, self.support = (self.load(self.body, self.face_at(self.body, "X", x)) for x in (40, 0))
        self.force = self.force_along(self.body, "y", self.body)
        edge, = [n for n, edge in enumerate(self.body.Shape.Edges, 1) if (edge.CenterOfMass - FreeCAD.Vector(50, 10, 15)).Length < NEAR]
        self.force.Direction = (self.body, ["Edge%d" % edge])
        self.mesh_of(self.body)
        self.before = self.direction_of(self.force)[:2]

    def put_in_between(self):
        self.body.Tip = self.document.Block
        self.document.recompute()
        self.assertEqual({obj for obj, _ in references.unmended(self.analysis)}, {self.pressed, self.force})
        chamfer = self.body.newObject("PartDesign::Chamfer", "Between")
        chamfer.Base, chamfer.Size = (self.document.Block, ["Edge1"]), 3
        self.pocket.BaseFeature = chamfer
        self.document.recompute()

    def move_down(self):
        self.body.Tip = self.pocket
        self.document.recompute()
        self.assertEqual(self.mesh.Status, "up to date")

    def test_what_a_feature_had_is_there_again(self):
        self.put_in_between()
        self.move_down()
        self.assertEqual(references.unmended(self.analysis), [])
        for obj, axis, value in ((self.pressed, "X", 40), (self.support, "X", 0)):
            self.assertEqual(names_of(obj), [("Body", self.face_at(self.body, axis, value))], obj.Name)
        self.assertEqual(self.direction_of(self.force)[:2], self.before)
        self.assertEqual(sum("there again" in line for line in warnings_of(self.mesh)), 2, warnings_of(self.mesh))
        self.document.GrooveSketch.setDatum("X", FreeCAD.Units.Quantity("45 mm"))
        self.document.recompute()
        self.assertEqual(names_of(self.pressed), [("Body", self.face_at(self.body, "X", 45))])
        self.assertEqual([line for line in warnings_of(self.mesh) if "again" in line], [])

    def test_nothing_is_there_again_with_another_feature_of_that_name(self):
        for name in ("Groove", "GrooveSketch"):
            self.body.Tip = self.document.Block
            self.document.removeObject(name)
        self.document.recompute()
        self.assertIn(self.pressed, {obj for obj, _ in references.unmended(self.analysis)})
        self.groove(self.body, 60)
        self.assertEqual(names_of(self.pressed), [])
        self.assertIn(self.pressed, {obj for obj, _ in references.unmended(self.analysis)})

    def test_what_was_chosen_meanwhile_stays(self):
        self.put_in_between()
        self.pressed.References = [(self.body, self.face_at(self.body, "Z", 0))]
        self.force.Direction = (self.body, [self.edge_along(self.body, "x")])
        self.move_down()
        self.assertEqual(names_of(self.pressed), [("Body", self.face_at(self.body, "Z", 0))])
        self.assertEqual(self.direction_of(self.force)[0], "x")

    def test_what_was_chosen_meanwhile_is_cancelled(self):
        self.document.UndoMode = 1
        self.put_in_between()
        below = [("Body", self.face_at(self.body, "Z", 0))]
        for is_undone in (False, True):
            self.document.openTransaction("Choose")
            self.pressed.References = [(self.body, below[0][1])]
            self.force.Direction = (self.body, [self.edge_along(self.body, "x")])
            if is_undone:
                self.document.commitTransaction()
                self.document.undo()
            else:
                self.document.abortTransaction()
        self.document.recompute()
        self.document.redo()
        self.assertEqual((names_of(self.pressed), self.direction_of(self.force)[0]), (below, "x"))
        self.document.recompute()
        self.document.undo()
        self.move_down()
        self.assertEqual((references.unmended(self.analysis), names_of(self.pressed)), ([], [("Body", self.face_at(self.body, "X", 40))]))
        self.assertEqual(self.direction_of(self.force)[:2], self.before)

    def test_it_comes_back_once_more_after_undo(self):
        """The tip moved down, undone, and moved down again."""
        self.document.UndoMode = 1
        self.document.openTransaction("Up")
        self.put_in_between()
        self.document.commitTransaction()
        for _ in range(2):
            self.document.openTransaction("Down")
            self.move_down()
            self.document.commitTransaction()
            self.assertEqual((references.unmended(self.analysis), names_of(self.pressed)), ([], [("Body", self.face_at(self.body, "X", 40))]))
            self.document.undo()
            self.assertEqual({obj for obj, _ in references.unmended(self.analysis)}, {self.pressed, self.force})

    def test_a_refinement_has_its_face_again(self):
        region = ObjectsFem.makeMeshRegion(self.document, self.mesh, 2.0, "Fine")
        region.References = [(self.body, self.face_at(self.body, "Z", 15))]
        self.document.recompute()
        self.put_in_between()
        self.assertEqual(region.References, [])
        self.move_down()
        self.assertEqual(names_of(region), [("Body", self.face_at(self.body, "Z", 15))])

# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads on links, mirrored parts, instances of patterns and sides of a box go to no other feature's face, no other instance and no other side."""
import math
import unittest
from unittest import mock

import Draft
import FreeCAD
import ObjectsFem
import Part
import Sketcher
from BOPTools import SplitFeatures
from CompoundTools import CompoundFilter
from blocks import warnings_of
from freecad.featuremesh import api, references, versions
from parts import Vector, circle, new_document, placement, plate_with_hole, rectangle
from test_references import names_of

AWAY = 100   # mm, from the body to the link


class OnAFace(unittest.TestCase):

    def setUp(self):
        self.document = new_document()

    def meshed_with_a_load(self, part, is_chosen):
        """The mesh and a pressure on the faces of its part that `is_chosen` says."""
        ObjectsFem.makeAnalysis(self.document, "Analysis")
        self.mesh = api.add_mesh(part, 10, order=1)
        self.part = versions.part_of(self.mesh)
        self.load = ObjectsFem.makeConstraintPressure(self.document, "Pressure")
        self.load.References = [(self.part, ["Face%d" % number for number, face in enumerate(self.part.Shape.Faces, 1) if is_chosen(face)])]
        self.document.Analysis.addObject(self.load)
        self.document.recompute()

    def loaded(self):
        self.document.recompute()
        return [self.part.Shape.getElement(name) for _, name in names_of(self.load)]


class OnALink(OnAFace):
    """A plate with a hole at (20, 20) and a link to it."""

    def setUp(self):
        super().setUp()
        self.body = plate_with_hole(self.document)
        assembly = self.document.addObject("App::Part", "Assembly")
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject, link.Placement = self.body, placement(AWAY)
        assembly.Group = [self.body, link]
        self.document.recompute()
        self.assembly = assembly

    def wall_at(self, x):
        """Is that a round face about a hole of the link there?"""
        return lambda face: isinstance(face.Surface, Part.Cylinder) and abs(face.Surface.Center.x - AWAY - x) < 1e-6

    def check(self, x):
        walls = self.loaded()
        self.assertTrue(walls)
        self.assertTrue(all(map(self.wall_at(x), walls)))

    def test_a_feature_is_put_in_between(self):
        """The hole of the link was the second feature there, and its load went to what is the second one now."""
        self.meshed_with_a_load(self.assembly, self.wall_at(20))
        self.body.Tip = self.document.Plate
        sketch = self.body.newObject("Sketcher::SketchObject", "OtherSketch")
        circle(sketch, 45, 20, 7)
        pocket = self.body.newObject("PartDesign::Pocket", "Other")
        pocket.Profile, pocket.Type, pocket.Reversed = sketch, "ThroughAll", True
        self.body.Tip = self.document.Hole
        self.check(20)

    def test_two_holes_of_one_sketch_move_and_grow(self):
        """Only the lines and circles of the sketch tell which is which."""
        sketch = self.document.HoleSketch
        other = sketch.addGeometry(Part.Circle(Vector(45, 20), Vector(0, 0, 1), 5))
        at = sketch.addConstraint(Sketcher.Constraint("DistanceX", -1, 1, other, 3, 45))
        self.document.recompute()
        self.meshed_with_a_load(self.assembly, self.wall_at(45))
        sketch.setDatum(at, FreeCAD.Units.Quantity("35 mm"))
        api.set_parameters(self.document, ["HoleSketch.X=12", "HoleSketch.Radius=8"])
        self.check(35)


class OnABox(OnAFace):

    def test_the_other_side_of_what_is_cut_out(self):
        """The ceiling of a slot from below is gone, and there is the floor of one from above, between the same walls."""
        body = self.document.addObject("PartDesign::Body", "Body")
        sketch = body.newObject("Sketcher::SketchObject", "PlateSketch")
        rectangle(sketch, 0, 0, 60, 40)
        plate, slot = body.newObject("PartDesign::Pad", "Plate"), body.newObject("PartDesign::SubtractiveBox", "Slot")
        plate.Profile, plate.Length = sketch, 10
        slot.Length, slot.Width, slot.Height, slot.Placement = 15, 12, 11, placement(20, -5, -3)
        self.document.recompute()
        self.meshed_with_a_load(body, lambda face: abs(face.CenterOfMass.z - 8) < 1e-6)
        self.assertEqual(len(self.loaded()), 1)
        sketch.Placement.Base.z = -5
        self.assertEqual(self.loaded(), [])
        self.assertEqual([obj for obj, _ in references.unmended(self.document.Analysis)], [self.load])


class AnUndo(OnAFace):

    def test_a_step_that_is_undone_after_a_recompute_outside_of_it(self):
        """Which gave the load's face another number: that stayed, the part did not."""
        body = plate_with_hole(self.document)
        self.document.UndoMode = 1
        self.meshed_with_a_load(body, self.is_hole)
        self.document.openTransaction("Edit")
        other = ObjectsFem.makeConstraintPressure(self.document, "Other")
        other.References = [(body, ["Face1"])]
        self.document.Analysis.addObject(other)
        api.edit(self.document, ["PlateSketch.Width=65"])
        self.document.commitTransaction()
        before = names_of(self.load)
        chamfer = body.newObject("PartDesign::Chamfer", "Chamfer")
        chamfer.Base, chamfer.Size = (self.document.Hole, ["Edge1", "Edge2"]), 1
        body.Tip = chamfer
        self.document.recompute()
        self.assertNotEqual(names_of(self.load), before)
        self.document.undo()
        self.assertTrue(all(map(self.is_hole, self.loaded())))
        self.assertEqual(len(self.loaded()), 1)

    def test_a_load_that_a_redo_brings_back(self):
        """It was chosen in a step while the mesh waited, and the recompute that gave its face another number was outside of that."""
        body = plate_with_hole(self.document)
        self.document.UndoMode = 1
        self.meshed_with_a_load(body, self.is_hole)
        self.document.openTransaction("Edit")
        self.mesh.Automatic = False
        self.load = ObjectsFem.makeConstraintPressure(self.document, "Other")
        self.load.References = [(body, ["Face%d" % number for number, face in enumerate(body.Shape.Faces, 1) if self.is_hole(face)])]
        self.document.Analysis.addObject(self.load)
        chamfer = body.newObject("PartDesign::Chamfer", "Chamfer")
        chamfer.Base, chamfer.Size = (self.document.Hole, ["Edge1", "Edge2"]), 1
        body.Tip, self.mesh.Automatic = chamfer, True
        self.document.commitTransaction()
        before = names_of(self.load)
        self.document.recompute()
        self.assertNotEqual(names_of(self.load), before)
        self.document.undo()
        self.document.recompute()
        self.document.redo()
        self.load = self.document.Other
        self.assertEqual(list(map(self.is_hole, self.loaded())), [True])

    def test_an_edit_that_gave_no_face_another_number(self):
        """The record says the same of both meshes, and what is undone with the mesh is followed by nobody."""
        self.document.UndoMode = 1
        self.meshed_with_a_load(plate_with_hole(self.document), self.is_hole)
        self.document.openTransaction("Edit")
        api.edit(self.document, ["HoleSketch.Radius=8"])
        self.document.commitTransaction()
        with mock.patch.object(type(self.mesh.Proxy), "_follow") as follow:
            self.document.undo()
        follow.assert_not_called()

    @staticmethod
    def is_hole(face):
        return isinstance(face.Surface, Part.Cylinder)


class OnAPattern(OnAFace):

    def test_a_pattern_gets_one_more(self):
        """The pins are turned, so that a load on the last of four was lost, or went to the last of five."""
        body = self.document.addObject("PartDesign::Body", "Body")
        plate, pin = (body.newObject("PartDesign::AdditiveBox", name) for name in ("Plate", "Pin"))
        plate.Length, plate.Width, plate.Height, plate.Placement = 100, 100, 10, placement(-50, -50)
        pin.Length, pin.Width, pin.Height, pin.Placement = 5, 4, 30, placement(28, 1)
        pins = body.newObject("PartDesign::PolarPattern", "Pins")
        axis = next(obj for obj in body.Origin.OriginFeatures if obj.Role == "Z_Axis")
        pins.Originals, pins.Axis, pins.Angle, pins.Occurrences = [pin], (axis, [""]), 360, 4
        body.Tip = pins
        self.document.recompute()
        self.meshed_with_a_load(body, lambda face: self.turned_back(face, 270).x > 32.99)
        for count in (4, 5, 3):
            pins.Occurrences = count
            faces = self.loaded()
            self.assertEqual(len(faces), 1 if count > 3 else 0)
            for face in faces:
                self.assertLess((self.turned_back(face, 3 * 360 / count) - Vector(33, 3, 20)).Length, 1e-6)

    @staticmethod
    def turned_back(face, angle):
        """Where the middle of a face would be on the first pin."""
        return placement(angle=-angle).multVec(face.CenterOfMass) if face.BoundBox.ZMin > 9.99 and face.BoundBox.ZMax > 29.99 else Vector()


class OnATurnedBox(OnAFace):
    """A quarter of a turn puts another side where the chosen one was; the load goes along."""

    def setUp(self):
        super().setUp()
        self.box = self.document.addObject("Part::Box", "Box")
        self.box.Length, self.box.Width, self.box.Height, self.box.Placement = 20, 20, 10, placement(-10, -10)
        self.document.recompute()

    def check(self, part, chosen, there):
        self.document.recompute()
        self.meshed_with_a_load(part, lambda face: (face.CenterOfMass - chosen).Length < 1e-6)
        self.box.Placement = placement(angle=90).multiply(self.box.Placement)
        face, = self.loaded()
        self.assertLess((face.CenterOfMass - there).Length, 1e-6)

    def test_mirrored(self):
        mirror = self.document.addObject("Part::Mirroring", "Mirror")
        mirror.Source, mirror.Base, mirror.Normal = self.box, Vector(0, 40, 0), Vector(0, 1, 0)
        self.check(mirror, Vector(10, 80, 5), Vector(0, 70, 5))

    def test_in_an_array(self):
        array = Draft.make_ortho_array(self.box, Vector(40, 0, 0), Vector(0, 40, 0), Vector(0, 0, 40), 2, 1, 1, use_link=False)
        self.check(array, Vector(50, 0, 5), Vector(40, 10, 5))

    def slice_of(self, part):
        knife = self.document.addObject("Part::Plane", "Knife")
        knife.Length, knife.Width, knife.Placement = 100, 100, placement(-50, -50, 6)
        pieces = SplitFeatures.makeSlice("Slice")
        pieces.Base, pieces.Tools, pieces.Mode = part, [knife], "Split"
        self.document.recompute()
        return pieces

    def test_sliced_apart(self):
        piece = CompoundFilter.makeCompoundFilter("Piece")
        piece.Base, piece.FilterType, piece.items = self.slice_of(self.box), "specific items", "0"
        self.check(piece, Vector(10, 0, 3), Vector(0, 10, 3))

    def test_where_a_slice_cuts_no_more(self):
        """Between the same sides there is the top of the box then, which had been cut off."""
        beside, lid = (self.document.addObject("Part::Box", name) for name in ("Beside", "Lid"))
        lid.Length, lid.Width, lid.Placement, beside.Placement = 30, 30, placement(-15, -15, 8), placement(20)
        cut, both = self.document.addObject("Part::Cut", "Cut"), self.document.addObject("Part::Compound", "Both")
        cut.Base, cut.Tool, both.Links = self.box, lid, [cut, beside]
        self.document.recompute()
        self.meshed_with_a_load(self.slice_of(both), lambda face: abs(face.CenterOfMass.z - 6) + abs(face.CenterOfMass.x) < 1e-6)
        self.assertTrue(self.loaded())
        self.box.Placement.Base.z = -5
        self.assertEqual(self.loaded(), [])
        self.assertEqual([obj for obj, _ in references.unmended(self.document.Analysis)], [self.load])


class OnAnArray(OnAFace):

    def test_rows_get_longer_and_shorter(self):
        """All copies of the rows behind had other numbers then, and their loads went to other copies."""
        pin = self.document.addObject("Part::Cylinder", "Pin")
        pin.Radius, pin.Height = 5, 10
        self.document.recompute()
        array = Draft.make_ortho_array(pin, Vector(40, 0, 0), Vector(0, 40, 0), Vector(0, 0, 40), 2, 2, 1, use_link=False)
        self.document.recompute()
        self.meshed_with_a_load(array, lambda face: (face.CenterOfMass - Vector(40, 0, 5)).Length < 1e-6)
        for rows in (3, 1):
            array.NumberY = rows
            self.assertEqual([(face.CenterOfMass - Vector(40, 0, 5)).Length < 1e-6 for face in self.loaded()], [True])


class OnFragments(OnAFace):

    def test_materials_of_two_balls_that_overlap(self):
        """Each of the three solids has pieces of the faces of one or both."""
        balls = [self.document.addObject("Part::Sphere", name) for name in ("Held", "Moved")]
        for ball in balls:
            ball.Radius = 10
        balls[1].Placement = placement(9, 1, 2)
        fragments = SplitFeatures.makeBooleanFragments("Fragments")
        fragments.Objects = balls
        self.document.recompute()

        def balls_around(name):
            solid = fragments.Shape.Solids[int(name[len("Solid"):]) - 1]
            return {ball.Name for ball in balls if solid.common(ball.Shape).Volume > 0.5 * solid.Volume}

        self.meshed_with_a_load(fragments, lambda face: False)
        self.document.Analysis.removeObject(self.load)
        materials = {}
        for name in ("Solid1", "Solid2", "Solid3"):
            material = ObjectsFem.makeMaterialSolid(self.document, "Material")
            material.References = [(fragments, name)]
            self.document.Analysis.addObject(material)
            materials[material] = balls_around(name)
        self.document.recompute()
        for place in ((6, 5, 4), (0, 4, 2), (-9, 2, 2), (9, 7, 2)):
            balls[1].Placement = placement(*place)
            self.document.recompute()
            self.assertEqual([[balls_around(name) for _, name in names_of(material)] for material in materials], [[around] for around in materials.values()])


    def test_a_face_of_which_a_piece_comes_to_lie_within_another_solid(self):
        boxes = [self.document.addObject("Part::Box", name) for name in ("Loaded", "Moved")]
        for box in boxes:
            box.Length, box.Width, box.Height = 20, 20, 20
        boxes[1].Placement = placement(30, 5, 5)
        fragments = SplitFeatures.makeBooleanFragments("Fragments")
        fragments.Objects = boxes
        self.document.recompute()
        self.meshed_with_a_load(fragments, lambda face: abs(face.CenterOfMass.x - 20) < 1e-6)
        boxes[1].Placement = placement(12, 5, 5)
        outside, = self.loaded()
        self.assertAlmostEqual(outside.Area, 20 * 20 - 15 * 15)
        said, = [text for text in warnings_of(self.mesh) if "Pressure" in text and "between" in text]
        self.assertRegex(said, r"Pressure: of Face\d+ it is not on Face\d+, which lies between two solids now")


class OnAPipe(OnAFace):
    """Swept along a line and an arc of radius 13 about the vertical line through (18, 13)."""

    def behind_the_bend(self, start, end):
        """Is that the face swept from the line between these points of the profile?"""
        y, z = (start[0] + end[0]) / 2, (start[1] + end[1]) / 2
        way = (13 - y) / math.sqrt(2)
        place = Part.Vertex(18 + way, 13 - way, z)
        return lambda face: face.distToShape(place)[0] < 1e-6

    def test_a_face_behind_the_bend(self):
        """It has no line of the sketch; by their heights it and those beside it were taken for one another."""
        body = self.document.addObject("PartDesign::Body", "Body")
        profile, spine = (body.newObject("Sketcher::SketchObject", name) for name in ("Profile", "Spine"))
        profile.Placement = FreeCAD.Placement(Vector(), FreeCAD.Rotation(Vector(0, 1, 0), Vector(0, 0, 1), Vector(1, 0, 0), "XYZ"))
        corners = [(-6.4, 8.7), (2.5, 8.6), (2.5, 12), (-2, 12)]
        for number, (start, end) in enumerate(zip(corners, corners[1:] + corners[:1])):
            profile.addGeometry(Part.LineSegment(Vector(*start), Vector(*end)))
            profile.addConstraint(Sketcher.Constraint("DistanceY", -1, 1, number, 1, start[1]))
        for number in range(4):
            profile.addConstraint(Sketcher.Constraint("Coincident", number, 2, (number + 1) % 4, 1))
        spine.addGeometry(Part.LineSegment(Vector(0, 0), Vector(18, 0)))
        spine.addGeometry(Part.ArcOfCircle(Part.Circle(Vector(18, 13), Vector(0, 0, 1), 13), -math.pi / 2, 0))
        pipe = body.newObject("PartDesign::AdditivePipe", "Pipe")
        pipe.Profile, pipe.Spine = profile, (spine, ["Edge1", "Edge2"])
        self.document.recompute()
        self.meshed_with_a_load(body, self.behind_the_bend(corners[1], corners[2]))
        self.assertEqual(len(self.loaded()), 1)
        for height in (4.7, 10.5, 8.7):
            profile.setDatum(0, FreeCAD.Units.Quantity("%g mm" % height))
            self.assertEqual([self.behind_the_bend(corners[1], corners[2])(face) for face in self.loaded()], [True])


class OnAMirroredPart(OnAFace):

    def test_a_face_that_another_operand_took_the_place_of(self):
        """Of the mirrored parts it was taken for the same one."""
        high, low = (self.document.addObject("Part::Box", name) for name in ("High", "Low"))
        high.Length, high.Width, high.Height = 20, 20, 40
        low.Length, low.Width, low.Height, low.Placement = 40, 40, 25, placement(-10, -10)
        common = self.document.addObject("Part::Common", "Common")
        common.Base, common.Tool = high, low
        mirror = self.document.addObject("Part::Mirroring", "Mirror")
        mirror.Source, mirror.Base, mirror.Normal = common, Vector(-30, 0, 0), Vector(1, 0, 0)
        self.document.recompute()
        self.meshed_with_a_load(mirror, lambda face: abs(face.CenterOfMass.z - 25) < 1e-6)
        self.assertEqual(len(self.loaded()), 1)
        high.Height = 22
        self.assertEqual(self.loaded(), [])
        self.assertEqual([obj for obj, _ in references.unmended(self.document.Analysis)], [self.load])

    def test_what_is_mirrored_is_turned(self):
        boxes = [self.document.addObject("Part::Box", "Box") for _ in range(2)]
        boxes[0].Length, boxes[0].Width, boxes[0].Height = 30, 20, 10
        boxes[1].Length, boxes[1].Width, boxes[1].Height, boxes[1].Placement = 8, 7, 18, placement(3, 2)
        fusion = self.document.addObject("Part::MultiFuse", "Fusion")
        fusion.Shapes = boxes
        mirror = self.document.addObject("Part::Mirroring", "Mirror")
        mirror.Source, mirror.Base, mirror.Normal = fusion, Vector(-60, 0, 0), Vector(1, 0, 0)
        self.document.recompute()
        chosen = Vector(30, 10, 5)   # on the box, in the middle of a side
        self.meshed_with_a_load(mirror, lambda face: (face.CenterOfMass - Vector(-120 - chosen.x, chosen.y, chosen.z)).Length < 1e-6)
        self.assertEqual(len(self.loaded()), 1)
        fusion.Placement = placement(4, 5, 6, 120, (0, 1, 1))
        there = fusion.Placement.multVec(chosen)
        face, = self.loaded()
        self.assertLess((face.CenterOfMass - Vector(-120 - there.x, there.y, there.z)).Length, 1e-6)


if __name__ == "__main__":
    unittest.main()

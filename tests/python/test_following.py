# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads stay on the faces that were chosen, through every kind of edit; what is lost is taken away and said, and nothing else is said."""
import math
import os
import unittest
from unittest import mock

import FreeCAD
import ObjectsFem
import Part
from blocks import NEAR, BlockParts, warnings_of
from freecad.featuremesh import api, history, mesh_object, references, state, versions
from freecad.featuremesh.errors import UserError
from freecad.featuremesh.study import study_object
from parts import groups_of, placement
from test_references import names_of, open_example


class Bracket:
    """Says which face of the bracket is which, from the dimensions in its sketches alone."""

    def __init__(self, document):
        self.document, self.body = document, document.Body

    def dimension(self, sketch, name):
        return self.document.getObject(sketch).getDatum(name).Value

    def label(self, name):
        """What the face of that number is: ("Hole", 3), ("Plate", "top") ..."""
        face = self.body.Shape.getElement(name).copy()
        face.Placement = self.body.Placement.inverse().multiply(face.Placement)
        surface = face.Surface
        if surface.TypeId == "Part::GeomToroid":
            at_boss = all(abs(getattr(surface.Center, axis.lower()) - self.dimension("BossSketch", "Boss" + axis)) < NEAR for axis in "XY")
            return ("Fillet", "of the boss" if at_boss else "elsewhere")
        if surface.TypeId == "Part::GeomCylinder":
            return self._round(surface.Center, surface.Radius)
        return self._flat(face, face.normalAt(0, 0))

    def _round(self, centre, radius):
        for number in range(1, 7):
            try:
                x, y = (self.dimension("HoleSketch", "Hole%d%s" % (number, axis)) for axis in "XY")
            except (NameError, IndexError, ValueError):
                continue
            if abs(centre.x - x) < NEAR and abs(centre.y - y) < NEAR:
                return ("Hole", number)
        return ("Bore", "side") if abs(radius - self.dimension("BoreSketch", "BoreRadius")) < NEAR else ("Boss", "side")

    def _flat(self, face, normal):
        plate, top = self.document.Plate.Length.Value, face.BoundBox.ZMax
        if abs(normal.z) > 0.9:
            heights = {0: "Plate bottom", plate: "Plate top", 15 + self.document.Boss.Length.Value: "Boss top",
                       15 + self.document.Rib.Length.Value: "Rib top"}
            return next(tuple(words.split()) for height, words in heights.items() if abs(height - top) < NEAR)
        side = "%+d%+d" % (round(normal.x), round(normal.y))
        return ("Plate" if face.BoundBox.ZMin < NEAR else "Rib", side)


class OnTheBracket(unittest.TestCase):
    """A support on each of the 21 faces."""
    CLICKED = False

    def setUp(self):
        self.document = open_example(self, "bracket")
        self.body, self.analysis = self.document.Body, self.document.Analysis
        self.bracket = Bracket(self.document)
        target = self.body.Tip if self.CLICKED else self.body
        self.supports, self.said = [], set()
        for number in range(1, len(self.body.Shape.Faces) + 1):
            support = ObjectsFem.makeConstraintFixed(self.document, "On%d" % number)
            support.References = [(target, "Face%d" % number)]
            self.analysis.addObject(support)
            self.supports.append(support)
        self.mesh = api.add_mesh(self.body, 12, order=1)
        self.mesh.Automatic = False
        self.update()
        self.before = self.labels()
        self.assertEqual(len(set(self.before.values())), 21)

    def update(self):
        self.document.recompute()
        api.update_mesh(self.mesh)

    def labels(self):
        """By support: what its face is; None where it has none."""
        return {support.Name: frozenset(self.bracket.label(name) for _, name in names_of(support)) for support in self.supports}

    def all_labels(self):
        return [self.bracket.label("Face%d" % n) for n in range(1, len(self.body.Shape.Faces) + 1)]

    def set(self, *assignments):
        api.set_parameters(self.document, assignments)
        self.update()

    def assert_stayed(self, lost=()):
        """Every support is on the face that it was on, but those on `lost`, which have none and say so. FreeCAD 0.20 makes fillets at other edges
        when those get other numbers; where the fillet is there again, so is its support."""
        now = self.labels()
        lost = {*lost, *({("Fillet", "of the boss")} - set(self.all_labels()))}
        for name, label in self.before.items():
            with self.subTest(support=name, face=label):
                wanted = frozenset() if label & lost else label
                self.assertEqual(now[name], wanted)
        gone = {name for name, label in self.before.items() if label & lost}
        self.said |= {line.split()[0] for line in warnings_of(self.mesh) if "is gone" in line}
        self.said -= {line.split(":")[0] for line in warnings_of(self.mesh) if "there again" in line}
        self.assertEqual(self.said, gone, warnings_of(self.mesh))
        self.assertEqual({obj.Name for obj, _ in references.unmended(self.analysis)}, gone)

    def test_a_longer_boss(self):
        self.set("Boss.Length=35")
        self.assert_stayed()

    def test_a_hole_that_moves(self):
        self.set("HoleSketch.Hole6X=108")
        self.assert_stayed()

    def test_holes_that_change_one_after_the_other(self):
        self.set("HoleSketch.Hole6Radius=5")
        self.assert_stayed()
        self.set("HoleSketch.Hole4Radius=5")
        self.assert_stayed()

    def test_a_mesh_that_could_not_be_stored_between_two_edits(self):
        """Then the references have moved with the part, and the mesh is that of before."""
        with mock.patch.object(state, "save", side_effect=OSError("no space left on device")):
            with self.assertRaisesRegex(UserError, "is the disk full"):
                self.set("HoleSketch.Hole6Radius=5")
        self.said |= {obj.Name for obj, _ in references.unmended(self.analysis)}
        self.set("HoleSketch.Hole4Radius=5")
        self.assert_stayed()

    def test_a_part_that_is_placed_and_turned(self):
        self.body.Placement = placement(10, 20, 30)
        self.update()
        self.assert_stayed()
        self.body.Placement = placement(-5, 1, 2, 40, (1, 2, 3))
        self.update()
        self.assert_stayed()
        self.body.Placement = placement(10, 20, 30, 90)
        self.set("Boss.Length=35", "HoleSketch.Hole2X=12")
        self.assert_stayed()

    def test_the_tip_is_deleted(self):
        self.body.removeObject(self.body.Tip)
        self.document.removeObject("Fillet")
        self.update()
        self.assert_stayed()

    def test_a_hole_is_deleted(self):
        sketch = self.document.HoleSketch
        sketch.delGeometry(5)
        self.update()
        self.assert_stayed(lost=[("Hole", 6)])

    def test_everything_moves_and_changes_at_once(self):
        # Since 1.0 FreeCAD loses the fillet's edge when the plate grows past the foot of the boss, and the part stays as it was.
        thicker = [] if versions.follows_faces() else ["Plate.Length=17"]
        self.set("HoleSketch.Hole1X=14", "HoleSketch.Hole1Radius=3", "HoleSketch.Hole3Y=60", "BossSketch.BossX=45", "BoreSketch.BoreX=45",
                 "PlateSketch.PlateLength=130", *thicker, "RibSketch.RibX=85", "BossSketch.BossRadius=20")
        self.assert_stayed()

    def test_a_reopened_document(self):
        path = os.path.join(os.path.dirname(self.document.FileName), "saved.FCStd")
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        self.body, self.analysis, self.mesh = self.document.Body, self.document.Analysis, self.document.FeatureMesh
        self.bracket = Bracket(self.document)
        self.supports = [self.document.getObject(name) for name in self.before]
        self.set("HoleSketch.Hole6Radius=5", "HoleSketch.Hole6X=100", "HoleSketch.Hole5Radius=5")
        self.assert_stayed()

    def test_a_lost_support_is_mended(self):
        self.document.HoleSketch.delGeometry(5)
        self.update()
        on_hole, = [support for support in self.supports if self.before[support.Name] == {("Hole", 6)}]
        self.assertIn((on_hole, "%s refers to %s, which is gone; choose another face, edge or solid for it" % (on_hole.Label, on_hole.LostReferences[0])),
                      references.unmended(self.analysis))
        on_hole.References = [(self.body, "Face1")]
        self.assertNotIn(on_hole, [obj for obj, _ in references.unmended(self.analysis)])


class AsClickedOnTheBracket(OnTheBracket):
    """The same, with what a click gives: the faces of the tip."""
    CLICKED = True


class AgainstFreeCAD(OnTheBracket):
    """The same where FreeCAD is said to follow by itself, as since 1.0, and its verdict is wrong, as 0.20's is, which follows nothing."""

    def setUp(self):
        patch = mock.patch.object(versions, "follows_faces", return_value=True)
        patch.start()
        self.addCleanup(patch.stop)
        super().setUp()

    test_a_longer_boss = test_everything_moves_and_changes_at_once = test_a_reopened_document = test_a_part_that_is_placed_and_turned = None


class AfterTheMesh(unittest.TestCase):
    """Loads that are made when the mesh is there, and when it is out of date."""

    def setUp(self):
        self.document = open_example(self, "bracket")
        self.bracket = Bracket(self.document)
        self.body = self.document.Body
        self.mesh = api.add_mesh(self.body, 12, order=1)
        self.mesh.Automatic = False
        self.update()

    def update(self):
        self.document.recompute()
        api.update_mesh(self.mesh)

    def support_on_hole(self, number):
        name, = ["Face%d" % n for n in range(1, len(self.body.Shape.Faces) + 1) if self.bracket.label("Face%d" % n) == ("Hole", number)]
        support = ObjectsFem.makeConstraintFixed(self.document, "Late")
        support.References = [(self.body.Tip, name)]
        self.document.Analysis.addObject(support)
        return support

    def check(self, support, number):
        self.assertEqual([self.bracket.label(name) for _, name in names_of(support)], [("Hole", number)])

    def test_a_load_made_after_the_mesh(self):
        support = self.support_on_hole(4)
        api.set_parameters(self.document, ["HoleSketch.Hole6Radius=5", "HoleSketch.Hole4Radius=6"])
        self.update()
        self.check(support, 4)

    def test_a_load_made_between_two_edits(self):
        api.set_parameters(self.document, ["HoleSketch.Hole6Radius=5"])
        self.document.recompute()
        support = self.support_on_hole(4)
        api.set_parameters(self.document, ["HoleSketch.Hole4Radius=6", "HoleSketch.Hole2Radius=7"])
        self.document.recompute()
        self.update()
        self.check(support, 4)

    def test_a_part_that_is_a_link(self):
        """FreeCAD crashes when a constraint refers to a link, so that is never done; an object that shows the link stands for it."""
        self.document.removeObject(self.mesh.Name)
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = self.body
        link.Placement = placement(300, 0, 0, 30)
        self.mesh = api.add_mesh(link, 12, order=1)
        self.mesh.Automatic = False
        support = self.support_on_hole(4)
        self.update()
        self.assertEqual(names_of(support)[0][0], "AssembledParts")
        api.set_parameters(self.document, ["HoleSketch.Hole6Radius=5", "HoleSketch.Hole4Radius=6"])
        self.update()
        self.check(support, 4)
        self.assertTrue(groups_of(self.mesh)["Late_Nodes"])

    def test_a_load_made_in_a_task_panel(self):
        """Which stays as it was clicked while the panel is open."""
        references.is_in_edit = lambda obj: obj.Name == "Late"
        self.addCleanup(setattr, references, "is_in_edit", None)
        support = self.support_on_hole(4)
        self.assertEqual(names_of(support)[0][0], "Fillet")
        references.is_in_edit = None
        self.document.recompute()
        history.settle(support)
        self.assertEqual((names_of(support)[0][0], "Touched" in support.State), ("Body", False))
        self.body.removeObject(self.document.Fillet)
        self.document.removeObject("Fillet")
        api.set_parameters(self.document, ["HoleSketch.Hole6Radius=5"])
        self.update()
        self.check(support, 4)

    def test_undo_gives_the_load_back(self):
        self.document.UndoMode = 1
        support = self.support_on_hole(6)
        self.update()
        before = names_of(support)
        self.document.openTransaction("Delete a hole")
        self.document.HoleSketch.delGeometry(5)
        self.update()
        self.document.commitTransaction()
        self.assertEqual(names_of(support), [])
        self.document.undo()
        self.assertEqual(names_of(support), before)
        self.assertEqual(references.unmended(self.document.Analysis), [])
        api.set_parameters(self.document, ["HoleSketch.Hole4Radius=6"])
        self.update()
        self.check(support, 6)

    def test_a_part_that_has_no_shape_for_a_while(self):
        """A load's panel that is closed then, and undo, say nothing: there is nothing to refer to. The load is on its face when the shape is back."""
        self.document.UndoMode = 1
        support = self.support_on_hole(4)
        self.update()
        self.document.openTransaction("Delete all features")
        for name in ("Fillet", "Holes", "Bore", "Rib", "Boss", "Plate"):
            self.document.removeObject(name)
        self.document.recompute()
        self.document.commitTransaction()
        self.assertTrue(self.body.Shape.isNull())
        history.settle(support)
        self.mesh.Proxy.members_changed(self.mesh, after_undo=True)
        with self.assertRaisesRegex(UserError, "has no shape"):
            api.add_size_zone(self.mesh)
        self.document.undo()
        self.check(support, 4)
        api.set_parameters(self.document, ["HoleSketch.Hole6Radius=5", "HoleSketch.Hole4Radius=6"])
        self.update()
        self.check(support, 4)

    def test_what_a_study_asks_for_at_faces_goes_with_them(self):
        self.document.UndoMode = 1
        faces = {self.bracket.label("Face%d" % number): "Face%d" % number for number in range(1, len(self.body.Shape.Faces) + 1)}
        study = study_object.add(self.body, self.document.Analysis)
        one, other = faces[("Hole", 4)], faces[("Hole", 6)]
        before = ["mass", "max_mises@" + one, "top = max_displacement@%s:p95" % one, "max_mises@" + other, "max_mises@Fillet"]
        study.Responses = before
        names = [self.bracket.label(name) for _, name in names_of(study)]
        self.assertEqual(names, [("Hole", 4), ("Hole", 6)] if one < other else [("Hole", 6), ("Hole", 4)])
        self.update()
        self.document.openTransaction("Delete a hole, and give the faces of others other numbers")
        self.document.HoleSketch.delGeometry(5)
        self.document.HoleSketch.delGeometry(0)
        self.update()
        self.document.commitTransaction()
        now = study.Responses[1].partition("@")[2]
        self.assertEqual(self.bracket.label(now), ("Hole", 4))
        self.assertNotEqual(now, one)
        self.assertEqual(study.Responses, ["mass", "max_mises@" + now, "top = max_displacement@%s:p95" % now, "max_mises@Fillet"])
        self.document.undo()
        self.assertEqual(study.Responses, before)

    def test_a_case_of_a_study_without_a_mesh(self):
        """Shown in the document, the part as it is is meshed first: a load stays on its face, and one that is lost comes back with the part as it was."""
        self.document.removeObject(self.mesh.Name)
        self.document.recompute()
        study = study_object.add(self.body, self.document.Analysis)
        force, = names_of(self.document.Force)
        self.assertEqual(self.bracket.label(force[1]), ("Boss", "top"))
        for assignment, labels in (("HoleSketch.Hole1X=-20", [("Boss", "top")]), ("BossSketch.BossRadius=9", []), ("BossSketch.BossRadius=18", [("Boss", "top")])):
            with self.subTest(assignment):
                if not labels and versions.version() >= (1, 0):   # the fillet does not do without the boss's edge there
                    with self.assertRaisesRegex(UserError, "cannot recompute Fillet"):
                        study_object.show_values(study, [assignment])
                    continue
                study_object.show_values(study, [assignment])
                self.assertEqual([self.bracket.label(name) for _, name in names_of(self.document.Force)], labels)
                mesh, = api.meshes_of(self.document)
                self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
                mesh.Automatic = False   # what shows a case updates it all the same
        self.assertEqual(references.unmended(self.document.Analysis), [])


class Blocks(BlockParts):
    """Part's primitives, faces that are split and that become one."""

    def test_a_longer_box(self):
        box = self.document.addObject("Part::Box", "Box")
        box.Length, box.Width, box.Height = 50, 20, 10
        self.document.recompute()
        load = self.load(box, self.face_at(box, "X", 50))
        self.mesh_of(box)
        box.Length = 60
        self.document.recompute()
        self.assertEqual(names_of(load), [("Box", self.face_at(box, "X", 60))])
        self.assertEqual(warnings_of(self.mesh), [])

    def test_a_face_that_is_split_and_made_one_again(self):
        for clicked in (False, True):
            with self.subTest(clicked=clicked):
                self.setUp()
                body = self.block()
                load = self.load(body.Tip if clicked else body, self.face_at(body, "Z", 20))
                self.mesh_of(body)
                pocket = self.groove(body)
                self.assertAlmostEqual(self.area_of(body, load), 1800)
                self.assertEqual(len(names_of(load)), 2)
                self.assertTrue(any("split into" in line for line in warnings_of(self.mesh)), warnings_of(self.mesh))
                halves = names_of(load)
                sketch = self.document.GrooveSketch
                sketch.setDatum("X", FreeCAD.Units.Quantity("45 mm"))
                self.document.recompute()
                self.assertEqual(self.area_of(body, load), 1800)
                self.assertEqual(len(halves), len(names_of(load)))
                body.Tip = self.document.Block
                self.document.removeObject(pocket.Name)
                self.document.recompute()
                self.assertAlmostEqual(self.area_of(body, load), 2000)
                self.assertEqual([line for line in warnings_of(self.mesh) if "gone" in line], [])

    def test_one_of_two_faces_that_become_one(self):
        """A load on one half is on the whole face when the groove between them goes, and says so."""
        body = self.block()
        pocket = self.groove(body)
        half = next("Face%d" % n for n, face in enumerate(body.Shape.Faces, 1) if abs(face.BoundBox.ZMin - 20) < NEAR and face.BoundBox.XMax < 50)
        load = self.load(body, half)
        self.mesh_of(body)
        self.document.GrooveSketch.setDatum("X", FreeCAD.Units.Quantity("45 mm"))
        self.document.recompute()
        self.assertAlmostEqual(self.area_of(body, load), 900)
        body.Tip = self.document.Block
        self.document.removeObject(pocket.Name)
        self.document.recompute()
        self.assertAlmostEqual(self.area_of(body, load), 2000)
        self.assertTrue(any("become one" in line for line in warnings_of(self.mesh)), warnings_of(self.mesh))

    def overlapping(self):
        """Two boxes whose tops lie in one plane, on one another."""
        left, right = (self.document.addObject("Part::Box", name) for name in ("Left", "Right"))
        right.Placement.Base = FreeCAD.Vector(7, 0, 0)
        both = self.document.addObject("Part::Compound", "Both")
        both.Links = [left, right]
        self.document.recompute()
        return left, right, both

    def test_two_solids_that_overlap(self):
        """One gets higher; the other one stays what it was."""
        _, right, both = self.overlapping()
        load = self.load(both, "Face12")
        self.mesh_of(both)
        right.Height = 13
        self.document.recompute()
        self.assertEqual(names_of(load), [("Both", self.face_at(both, "Z", 13))])

    def test_two_solids_that_overlap_and_both_get_higher(self):
        left, right, both = self.overlapping()
        loads = [self.load(both, face) for face in ("Face6", "Face12")]
        self.mesh_of(both)
        left.Height, right.Height = 12, 13
        self.document.recompute()
        self.assertEqual([names_of(load) for load in loads], [[("Both", self.face_at(both, "Z", height))] for height in (12, 13)])

    def test_two_parts_of_one_feature_of_which_one_moves(self):
        """What the feature tells of the one that moved is not true of the other one."""
        block, parts = self.document.addObject("Part::Box", "Block"), []
        block.Length, block.Width = 30, 20
        for number, x in enumerate((8, 20)):
            hole = self.document.addObject("Part::Cylinder", "Hole%d" % number)
            hole.Placement.Base = FreeCAD.Vector(x, 10, 0)
            parts.append(self.document.addObject("Part::Cut", "Part%d" % number))
            parts[-1].Base, parts[-1].Tool = block, hole
        both = self.document.addObject("Part::Compound", "Both")
        both.Links = parts
        self.document.recompute()
        loads = [self.load(both, "Face%d" % n) for n in range(1, len(both.Shape.Faces) + 1)]
        places = [face.CenterOfMass for face in both.Shape.Faces]
        self.mesh_of(both)
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)
        for part, own, shift in ((parts[0], range(7), FreeCAD.Vector(3, 40, 5)), (parts[1], range(7, 14), FreeCAD.Vector(0, -50, 1))):
            part.Placement.Base += shift
            self.document.recompute()
            for index in own:
                places[index] += shift
            for load, place in zip(loads, places):
                (name,) = [name for _, name in names_of(load)]
                self.assertLess((both.Shape.getElement(name).CenterOfMass - place).Length, NEAR, (part.Name, load.Name, name))

    def imported(self, shape, name="Imported"):
        solid = self.document.addObject("Part::Feature", name)
        solid.Shape = shape
        return solid

    def block_with_rib(self):
        block, rib = Part.makeBox(100, 60, 20), Part.makeBox(30, 20, 20, FreeCAD.Vector(60, 20, 20))
        return block.fuse(rib).removeSplitter()

    def test_an_imported_solid_that_is_cut(self):
        """What knows no features goes by places: faces that stayed are nobody else's, though they lie beside one that was cut."""
        solid = self.imported(self.block_with_rib())
        loads = [self.load(solid, "Face%d" % n) for n in range(1, len(solid.Shape.Faces) + 1)]
        places = [solid.Shape.getElement(names_of(load)[0][1]).BoundBox for load in loads]
        self.mesh_of(solid)
        solid.Shape = solid.Shape.cut(Part.makeBox(30, 60, 20))
        self.document.recompute()
        for load, was in zip(loads, places):
            now, = [solid.Shape.getElement(name).BoundBox for _, name in names_of(load)]
            self.assertEqual([getattr(now, side) for side in ("YMin", "YMax", "ZMin", "ZMax")], [getattr(was, side) for side in ("YMin", "YMax", "ZMin", "ZMax")])
            self.assertEqual((now.XMin, now.XMax), (max(was.XMin, 30), max(was.XMax, 30)))

    def test_an_import_that_is_replaced_by_a_newer_one(self):
        """Two holes are where one was, both between the same faces: neither is a piece of it. One that is as wide is it, or one that is where it was."""
        plate = Part.makeBox(60, 40, 10)

        def with_holes(*holes):
            return plate.cut(Part.makeCompound([Part.makeCylinder(radius, 10, FreeCAD.Vector(x, y)) for x, y, radius in holes]))
        solid = self.document.addObject("Part::Feature", "Import")
        solid.Shape = with_holes((20, 20, 6))
        hole = self.load(solid, "Face%d" % next(n for n, face in enumerate(solid.Shape.Faces, 1) if hasattr(face.Surface, "Radius")))
        top = self.load(solid, self.face_at(solid, "Z", 10))
        self.mesh_of(solid)
        for holes, radii in ([(22, 20, 6), (50, 10, 3)], [6]), ([(22, 20, 6)], [6]), ([(45, 20, 4)], []), ([(40, 20, 4), (50, 10, 3)], []):
            if not radii and versions.follows_faces():
                break   # FreeCAD chooses by itself as soon as the shape is set
            solid.Shape = with_holes(*holes)
            self.document.recompute()
            self.assertEqual([solid.Shape.getElement(name).Surface.Radius for _, name in names_of(hole)], radii)
            self.assertEqual(len(names_of(top)), 1)
            self.assertEqual(len(references.unmended(self.analysis)), not radii)

    def test_a_mesh_that_is_given_another_part(self):
        """The next version of a file, imported beside the first one."""
        solid = self.imported(self.block_with_rib())
        loads = [self.load(solid, "Face%d" % n) for n in range(1, len(solid.Shape.Faces) + 1)]
        areas = [self.area_of(solid, load) for load in loads]
        self.mesh_of(solid)
        other = self.imported(solid.Shape.fuse(Part.makeBox(5, 5, 5, FreeCAD.Vector(10, 10, 20))).removeSplitter(), "Next")
        setattr(self.mesh, versions.part_property(self.mesh), other)
        self.document.recompute()
        self.assertEqual({name for load in loads for name, _ in names_of(load)}, {"Next"})
        self.assertEqual([line for line in warnings_of(self.mesh) if "not on the meshed part" in line], [])
        for load, area in zip(loads, areas):
            self.assertIn(round(area - self.area_of(other, load), 6), (0, 25))

    def test_a_number_that_is_gone_leaves_no_error(self):
        """FreeCAD 0.20 looks at the load before the mesh has said what its face is called now."""
        body = self.block()
        groove = self.groove(body)
        load = self.load(body, "Face%d" % len(body.Shape.Faces))
        area = self.area_of(body, load)
        self.mesh_of(body)
        self.document.removeObject(groove.Name)
        body.Tip = self.document.Block
        self.document.recompute()
        self.assertLess(len(body.Shape.Faces), 10)
        self.assertGreaterEqual(self.area_of(body, load), area)
        self.assertEqual([state for state in load.State if state in ("Invalid", "Touched")], [])

    def test_a_group_and_a_refinement_follow(self):
        body = self.block()
        self.mesh_of(body)
        top = self.face_at(body, "Z", 20)
        region = ObjectsFem.makeMeshRegion(self.document, self.mesh, 2.0, "Fine")
        group = ObjectsFem.makeMeshGroup(self.document, self.mesh, False, "Clamp")
        region.References = group.References = [(body.Tip, top)]
        self.document.recompute()
        self.groove(body)
        for obj in (region, group):
            self.assertAlmostEqual(self.area_of(body, obj), 1800)
        self.assertLess(self.mesh.KeptNodes, 100)   # it is not made once more for what was moved with it
        groups = groups_of(self.mesh)
        self.assertEqual(groups["Clamp_Nodes"], set().union(*(groups[name + "_Nodes"] for _, name in names_of(group))))

    def test_drilled_holes_whose_circles_are_by_chance_as_large(self):
        body = self.block()
        sketch = body.newObject("Sketcher::SketchObject", "Centres")
        sketch.Placement.Base.z = 20
        for x in (30, 60):
            sketch.addGeometry(Part.Circle(FreeCAD.Vector(x, 10), FreeCAD.Vector(0, 0, 1), 4))
        self.document.recompute()
        holes = body.newObject("PartDesign::Hole", "Holes")
        holes.Profile, holes.DepthType, holes.Diameter = sketch, "ThroughAll", 8
        body.Tip = holes
        self.document.recompute()
        bores = {round(face.Surface.Center.x): "Face%d" % n for n, face in enumerate(body.Shape.Faces, 1) if hasattr(face.Surface, "Radius")}
        loads = {x: self.load(body, name) for x, name in bores.items()}
        self.assertEqual(sorted(loads), [30, 60])
        self.mesh_of(body)
        for diameter in (10, 8, 6):
            holes.Diameter = diameter
            self.document.recompute()
            for x, load in loads.items():
                (_, name), = names_of(load)
                bore = body.Shape.getElement(name).Surface
                self.assertEqual((round(bore.Center.x), bore.Radius), (x, diameter / 2))
        self.assertEqual(warnings_of(self.mesh), [])

    def test_a_thicker_wall(self):
        """The load on a face that the thickness made goes with it, inwards and outwards."""
        for is_inward, before, after in ((True, 2, 3), (False, -2, -3)):
            with self.subTest(is_inward=is_inward):
                body = self.block()
                block, top = body.Tip, self.face_at(body, "Z", 20)
                thickness = body.newObject("PartDesign::Thickness", "Wall")
                thickness.Base, thickness.Value, thickness.Reversed = (block, [top]), 2, is_inward
                body.Tip = thickness
                self.document.recompute()
                loads = {axis: self.load(body, self.face_at(body, axis, before)) for axis in "YZ"}
                self.mesh_of(body)
                thickness.Value = 3
                self.document.recompute()
                for axis, load in loads.items():
                    self.assertEqual(names_of(load), [(body.Name, self.face_at(body, axis, after))])
                self.assertEqual(warnings_of(self.mesh), [])

    def test_a_steeper_draft(self):
        body = self.block()
        block, side, bottom = body.Tip, self.face_at(body, "X", 0), self.face_at(body, "Z", 0)
        draft = body.newObject("PartDesign::Draft", "Slope")
        draft.Base, draft.NeutralPlane, draft.Angle = (block, [side]), (block, [bottom]), 5
        body.Tip = draft
        self.document.recompute()
        sloping, = ["Face%d" % n for n, face in enumerate(body.Shape.Faces, 1) if 0.01 < abs(face.normalAt(0, 0).z) < 0.5]
        load = self.load(body, sloping)
        self.mesh_of(body)
        draft.Angle = 8
        self.document.recompute()
        (_, name), = names_of(load)
        self.assertAlmostEqual(abs(body.Shape.getElement(name).normalAt(0, 0).z), math.sin(math.radians(8)), places=6)
        self.assertEqual(warnings_of(self.mesh), [])

# SPDX-License-Identifier: GPL-3.0-or-later
"""The mesh object in a document: it follows the part, survives saving and undo, and never shows a wrong mesh."""
import json
import sys
import unittest
from unittest import mock

import FreeCAD
import numpy as np
import ObjectsFem
from freecad.featuremesh import analyses, api, engine, mesh_object, mesh_properties, overlays, reading, state, versions
from freecad.featuremesh.errors import FailedUpdate, UserError
from freecad.featuremesh.messages import english, in_english
from freecad.featuremesh.quality import MEASURES
from meshed_plate import SIZE, MeshedPlate, points_of
from parts import groups_in_freecad, groups_of, new_document, placement, plate_with_hole, rectangle


def interrupt(now):
    if now:
        raise KeyboardInterrupt
    return True


class MeshObject(MeshedPlate):
    def assert_on_the_part(self, mesh=None):
        """Every node of the hole's face is at the hole's radius around its axis, as FreeCAD itself finds them."""
        mesh = mesh or self.mesh
        axis_x = self.document.getObject("HoleSketch").getDatum("X").Value
        for number, face in enumerate(self.body.Shape.Faces, 1):
            if face.Surface.TypeId != "Part::GeomCylinder":
                continue
            found = mesh.FemMesh.getNodesByFace(face)
            self.assertGreater(len(found), 8)
            self.assertEqual(set(found), groups_of(mesh)["Face%d_Nodes" % number])
            for node in found:
                point = mesh.FemMesh.Nodes[node]
                self.assertAlmostEqual(((point.x - axis_x) ** 2 + (point.y - 20) ** 2) ** 0.5, 6.0, 6)

    def test_first_mesh(self):
        self.assertEqual(self.mesh.NodeCount, self.mesh.FemMesh.NodeCount)
        self.assertEqual(self.mesh.TetCount, self.mesh.FemMesh.VolumeCount)
        self.assert_on_the_part()
        report = json.loads(self.mesh.Report)
        self.assertIsNone(report["fallback"])
        for step in ("document", "hand_over", "state", "total", "engine_total"):
            self.assertIn(step, report["seconds"])

    def test_an_edit_is_followed_and_most_nodes_stay(self):
        before = points_of(self.mesh)
        self.edit()
        after = points_of(self.mesh)
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)
        self.assert_on_the_part()
        kept = sum(1 for number, point in after.items() if before.get(number) == point)
        self.assertGreater(kept, 0.3 * len(after))
        self.assertIsNone(json.loads(self.mesh.Report)["fallback"])
        self.assertAlmostEqual(self.mesh.KeptNodes, 100 * kept / len(after), delta=1)

    def test_a_number_is_never_given_to_another_point(self):
        before = points_of(self.mesh)
        self.edit()
        moved = [number for number, point in points_of(self.mesh).items() if number in before and before[number] != point]
        self.assertEqual(moved, [])

    def test_recompute_without_an_edit_changes_nothing(self):
        before = points_of(self.mesh)
        self.mesh.touch()
        self.document.recompute()
        self.assertEqual(points_of(self.mesh), before)

    def test_saved_and_reopened_it_updates_just_as_locally(self):
        before = points_of(self.mesh)
        self.save_and_reopen()
        self.assertEqual(points_of(self.mesh), before)
        self.edit()
        self.assert_on_the_part()
        reopened = points_of(self.mesh)
        self.assertGreater(self.mesh.KeptNodes, 30)
        self.setUp()
        self.assertEqual(points_of(self.mesh), before)
        self.edit()
        self.assertEqual(points_of(self.mesh), reopened)

    def test_lengths_that_a_document_does_not_keep_to_the_last_digit_are_no_others(self):
        self.mesh.IgnoreBelow = 0.1 / 3
        self.document.recompute()
        self.save_and_reopen()
        self.assertNotEqual(self.mesh.IgnoreBelow.Value, 0.1 / 3)
        self.mesh.Order, self.mesh.Order = "2nd", "1st"
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)
        self.edit()
        self.assertGreater(self.mesh.KeptNodes, 30)

    def test_damaged_state_gives_a_full_mesh_and_says_so(self):
        self.save_and_reopen()
        with open(self.mesh.SavedState, "r+b") as stream:
            stream.seek(5000)
            stream.write(b"\x00\xff" * 50)
        self.edit()
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)
        self.assertIn("damaged", english(json.loads(self.mesh.Report)["fallback"]))
        self.assert_on_the_part()

    def test_state_of_another_part_gives_a_full_mesh_and_says_so(self):
        box = self.document.addObject("Part::Box", "Box")
        setattr(self.mesh, versions.part_property(self.mesh), box)
        self.mesh.Proxy.onDocumentRestored(self.mesh)
        self.document.recompute()
        self.assertIn("belongs to Body", english(json.loads(self.mesh.Report)["fallback"]))

    def test_failure_leaves_the_old_mesh_and_says_why(self):
        before = points_of(self.mesh)
        self.mesh.Size = 0
        self.document.recompute()
        self.assertTrue(self.mesh.Status.startswith("failed: "), self.mesh.Status)
        self.assertIn("Invalid", self.mesh.State)
        self.assertFalse(hasattr(sys, "tracebacklimit"))   # the lines of code are left out for FreeCAD's print of this error alone
        self.assertEqual(points_of(self.mesh), before)
        self.mesh.Size = SIZE
        self.document.recompute()
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)
        self.assertEqual(points_of(self.mesh), before)

    def test_two_failures_at_once_leave_python_as_it_was(self):
        one, other = FailedUpdate("One", "it failed"), FailedUpdate("Other", "it failed, too")
        del one
        self.assertEqual(sys.tracebacklimit, 0)   # the other one is still to be printed
        del other
        self.assertFalse(hasattr(sys, "tracebacklimit"))

    def test_cancel_leaves_everything_as_it_was(self):
        before = points_of(self.mesh)
        self.mesh.Automatic = False
        self.edit()
        with self.assertRaises(engine.load().Cancelled):
            api.update_mesh(self.mesh, progress=lambda step, share: False)
        self.assertEqual(points_of(self.mesh), before)
        api.update_mesh(self.mesh)
        self.assert_on_the_part()

    def test_what_the_progress_function_raises_ends_an_update(self):
        before = points_of(self.mesh)
        self.mesh.Automatic = False
        self.edit()
        for wanted in ("keep", "volume", "validate"):
            with self.subTest(step=wanted), self.assertRaises(KeyboardInterrupt):
                api.update_mesh(self.mesh, progress=lambda step, share, wanted=wanted: interrupt(step == wanted))
            self.assertEqual(points_of(self.mesh), before)
            self.assertEqual(self.mesh.Status, mesh_properties.CANCELLED)
        api.update_mesh(self.mesh)
        self.assert_on_the_part()

    def test_cancel_while_the_saved_mesh_is_read(self):
        self.mesh.Automatic = False
        self.save_and_reopen()
        before = points_of(self.mesh)
        self.edit()
        with mock.patch.object(engine.load(), "update_part", side_effect=AssertionError("it was read to its end")):
            with self.assertRaises(engine.load().Cancelled):
                api.update_mesh(self.mesh, progress=lambda step, share: False)
        self.assertEqual((points_of(self.mesh), self.mesh.Status), (before, mesh_object.CANCELLED))
        self.assertIsNone(api.update_mesh(self.mesh)["fallback"])
        self.assertGreater(self.mesh.KeptNodes, 30)

    def test_manual_mode_says_that_it_is_out_of_date(self):
        self.mesh.Automatic = False
        before = points_of(self.mesh)
        self.edit()
        self.assertEqual(self.mesh.Status, mesh_object.OUT_OF_DATE)
        self.assertEqual(points_of(self.mesh), before)
        api.update_mesh(self.mesh)
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)
        self.assert_on_the_part()

    def test_manual_mode_and_threads_alter_no_mesh(self):
        self.document.UndoMode = 1
        self.document.openTransaction("By hand")
        self.mesh.Automatic, self.mesh.Threads = False, 1
        self.document.commitTransaction()
        for step in ("set", "undone", "redone"):
            with self.subTest(step):
                self.document.recompute()
                self.assertEqual((self.mesh.Status, self.mesh.Automatic), (mesh_object.UP_TO_DATE, step == "undone"))
            self.document.undo() if step == "set" else self.document.redo()
        self.edit()
        self.assertEqual(self.mesh.Status, mesh_object.OUT_OF_DATE)
        self.mesh.Automatic = True
        self.document.recompute()
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)
        self.assert_on_the_part()

    def test_undo_and_redo_bring_the_mesh_back(self):
        self.document.UndoMode = 1
        before = points_of(self.mesh)
        self.document.openTransaction("Move the hole")
        self.edit()
        self.document.commitTransaction()
        after = points_of(self.mesh)
        self.assertNotEqual(before, after)
        self.document.undo()
        self.assertEqual(points_of(self.mesh), before)
        self.document.redo()
        self.assertEqual(points_of(self.mesh), after)
        self.assert_on_the_part()

    def test_colours_of_what_was_kept_and_of_quality(self):
        with self.assertRaisesRegex(UserError, "meshed from scratch, or brought back"):
            api.show_kept(self.mesh)
        self.edit()
        overlay = api.show_kept(self.mesh)
        self.assertEqual(set(overlay.numbers.tolist()), set(self.mesh.FemMesh.Volumes))
        kept = (overlay.colours == overlays.kept_legend()[0]).all(axis=1)
        self.assertEqual(kept.tolist(), overlay.kept.tolist())
        self.assertAlmostEqual(100 * kept.mean(), self.mesh.KeptTets, delta=1)
        for name, measure in MEASURES.items():
            overlay = api.show_quality(self.mesh, name, cut="z=5")
            self.assertEqual(set(overlay.numbers.tolist()), set(self.mesh.FemMesh.Volumes))
            self.assertTrue(np.isfinite(overlay.values).all() and measure.shares(overlay.values).mean() > 0.3, name)
        self.assertAlmostEqual(api.show_quality(self.mesh).values.min(), self.mesh.MinDihedral.Value, 6)
        self.assertAlmostEqual(api.show_quality(self.mesh, "radius_ratio").values.mean(), self.mesh.MeanRadiusRatio, 6)
        self.assertAlmostEqual(api.show_quality(self.mesh, "size_ratio").values.mean(), 1, delta=0.25)
        for wrong in ({"measure": "beauty"}, {"limits": (1, 1)}, {"cut": "w=3"}):
            with self.assertRaises(UserError):
                api.show_quality(self.mesh, **wrong)

    def test_quality_target(self):
        reached = {}
        for target in (5, 30):
            self.mesh.QualityTarget = target
            api.update_mesh(self.mesh, full=True)
            reached[target] = self.mesh.MinDihedral.Value
        self.assertGreater(reached[30], reached[5])
        self.assertGreater(reached[30], 25)
        self.mesh.QualityTarget = 80
        self.document.recompute()
        self.assertIn("QualityTarget", self.mesh.Status)
        with self.assertRaisesRegex(UserError, "its last update failed: .*QualityTarget"):
            api.recompute(self.document)

    def test_second_order(self):
        self.mesh.Order = "2nd"
        self.document.recompute()
        self.assertEqual(len(self.mesh.FemMesh.getElementNodes(self.mesh.FemMesh.Volumes[0])), 10)
        self.assert_on_the_part()

    def test_parts_that_are_missing_or_in_error(self):
        setattr(self.mesh, versions.part_property(self.mesh), None)
        for work in (lambda: api.update_mesh(self.mesh), lambda: api.add_local_size(self.mesh, [(self.body, "Face1")]), lambda: api.add_group(self.mesh, [(self.body, "Face1")]),
                     lambda: api.add_size_zone(self.mesh), lambda: api.estimate_tets(self.mesh)):
            with self.assertRaisesRegex(UserError, "has no part to mesh, set its property"):
                work()
        setattr(self.mesh, versions.part_property(self.mesh), self.body)
        api.update_mesh(self.mesh)
        self.document.getObject("Plate").Length = 0
        self.document.recompute()   # FreeCAD finds the error, and leaves the mesh as it was
        for _ in range(2):
            with self.assertRaisesRegex(UserError, "Plate"):
                api.recompute(self.document)

    def test_volume_of_the_mesh(self):
        self.mesh.Order = "2nd"
        self.document.recompute()
        self.assertAlmostEqual(self.mesh.FemMesh.Volume.Value, self.body.Shape.Volume, delta=0.003 * self.body.Shape.Volume)


class Groups(unittest.TestCase):

    def setUp(self):
        self.document = new_document()
        self.body = plate_with_hole(self.document)
        self.analysis = ObjectsFem.makeAnalysis(self.document, "Analysis")
        self.fixed = ObjectsFem.makeConstraintFixed(self.document, "Fixed")
        self.fixed.References = [(self.body, "Face1")]
        self.analysis.addObject(self.fixed)
        self.mesh = api.add_mesh(self.body, SIZE, order=1)
        self.document.recompute()

    def test_mesh_joins_the_only_analysis(self):
        self.assertIn(self.mesh, self.analysis.Group)

    def test_mesh_joins_the_active_analysis_or_the_one_that_it_is_for(self):
        empty = ObjectsFem.makeAnalysis(self.document, "Empty")
        self.assertEqual(analyses.for_new_mesh(self.body, empty), (empty, ""))
        self.assertEqual(analyses.for_new_mesh(self.body, self.analysis)[0], None)
        self.assertRegex(analyses.for_new_mesh(self.body, self.analysis)[1], "Analysis has FeatureMesh already")
        self.assertEqual(analyses.for_new_mesh(self.body)[0], None)
        self.assertRegex(analyses.for_new_mesh(self.body)[1], "none of Analysis, Empty is active")
        self.document.removeObject(self.mesh.Name)
        self.assertEqual(analyses.for_new_mesh(self.body)[0], self.analysis)
        self.assertRegex(analyses.for_new_mesh(self.body)[1], "in Analysis, which refers to Body")
        self.assertIn(api.add_mesh(self.body, SIZE, active_analysis=empty), empty.Group)

    def test_faces_edges_solids_and_features(self):
        self.assertEqual(set(groups_in_freecad(self.mesh)), {"Fixed_Nodes", "Face1_Nodes"})
        wanted = groups_of(self.mesh)
        self.mesh.AllGroups = True
        self.document.recompute()
        self.assertEqual((self.mesh.Status, self.mesh.KeptNodes), (mesh_object.UP_TO_DATE, 100))
        groups, fem_mesh = groups_in_freecad(self.mesh), self.mesh.FemMesh
        self.assertEqual(groups, wanted)
        kinds = {fem_mesh.getGroupName(group): fem_mesh.getGroupElementType(group) for group in fem_mesh.Groups}
        self.assertEqual([kinds[name] for name in ("Face1_Nodes", "Face1", "Edge1_Nodes", "Edge1", "Feature_Plate")], ["Node", "Face", "Node", "Edge", "Volume"])
        for number, face in enumerate(self.body.Shape.Faces, 1):
            self.assertEqual(groups["Face%d_Nodes" % number], set(fem_mesh.getNodesByFace(face)))
            self.assertEqual(groups["Face%d" % number], set(fem_mesh.getFacesByFace(face)))
        for number, edge in enumerate(self.body.Shape.Edges, 1):
            self.assertEqual(groups["Edge%d_Nodes" % number], set(fem_mesh.getNodesByEdge(edge)))
        self.assertNotIn("Solid1", groups)   # the only solid is the mesh itself
        self.assertEqual(groups["Feature_Plate"], set(fem_mesh.Volumes))

    def test_constraint_finds_its_nodes_and_follows_its_references(self):
        self.assertEqual(groups_of(self.mesh)["Fixed_Nodes"], groups_of(self.mesh)["Face1_Nodes"])
        self.fixed.References = [(self.body, "Face2"), (self.body, "Edge1")]
        groups = groups_of(self.mesh)
        self.assertEqual(groups["Fixed_Nodes"], groups["Face2_Nodes"] | groups["Edge1_Nodes"])
        self.fixed.References = []
        self.assertNotIn("Fixed_Nodes", groups_of(self.mesh))

    def test_mesh_group_objects(self):
        group = ObjectsFem.makeMeshGroup(self.document, self.mesh, False, "Clamp")
        group.References = [(self.body, "Face1"), (self.body, "Face2")]
        self.document.recompute()
        groups = groups_of(self.mesh)
        self.assertEqual(groups["Clamp"], groups["Face1"] | groups["Face2"])
        self.assertEqual(groups["Clamp_Nodes"], groups["Face1_Nodes"] | groups["Face2_Nodes"])

    def test_refinement_makes_more_nodes_where_it_is(self):
        before = groups_of(self.mesh)
        region = ObjectsFem.makeMeshRegion(self.document, self.mesh, 0.0, "Fine")
        region.References, region.CharacteristicLength = [(self.body, "Face1")], SIZE / 3
        self.document.recompute()
        after = groups_of(self.mesh)
        self.assertGreater(len(after["Face1_Nodes"]), 4 * len(before["Face1_Nodes"]))

    def test_refinement_of_another_object_is_refused(self):
        other = self.document.addObject("Part::Box", "Other")
        region = ObjectsFem.makeMeshRegion(self.document, self.mesh, 1.0, "Fine")
        region.References = [(other, "Face1")]
        self.document.recompute()
        self.assertIn("Fine", self.mesh.Status)
        self.assertIn("Body", self.mesh.Status)


class CoarseHole(unittest.TestCase):

    def test_an_update_turns_none_of_its_triangles(self):
        """Some of them stand across it."""
        document = new_document()
        box, hole, cut = (document.addObject("Part::" + kind, kind) for kind in ("Box", "Cylinder", "Cut"))
        box.Length, box.Width, box.Height, hole.Radius, hole.Height = 60, 20, 20, 1.4, 60
        hole.Placement = placement(18, 10, 7, 45, (1, 0, 0))
        cut.Base, cut.Tool = box, hole
        document.recompute()
        mesh = api.add_mesh(cut, 6, order=1)
        mesh.ElementsPerCircle = 0
        document.recompute()
        box.Length = 63
        document.recompute()
        self.assertGreater(mesh.KeptNodes, 50)
        saved = state.load(mesh.SavedState)
        engine.load().restore_part(saved.raw, saved.options, saved.arrays)


class SmallAngles(unittest.TestCase):
    def setUp(self):
        self.document = new_document("Small")
        self.box = self.document.addObject("Part::Box", "Box")
        self.box.Length, self.box.Width = 60, 40
        self.addCleanup(FreeCAD.closeDocument, self.document.Name)

    def remarks(self, part, size):
        self.document.recompute()
        report = api.update_mesh(api.add_mesh(part, size, order=1))
        return report["quality"], [english(line) for line in report["warnings"] if "below 10 degrees" in line["template"] or "does not force" in line["template"]]

    def cut(self, tool):
        part = self.document.addObject("Part::Cut", "Cut")
        part.Base, part.Tool = self.box, tool
        return part

    def test_those_that_the_part_does_not_force_are_told_with_their_place(self):
        hole = self.document.addObject("Part::Cylinder", "Hole")
        hole.Radius, hole.Placement.Base = 6, FreeCAD.Vector(20, 6.02, 0)   # its wall to the side is 0.02 mm thick
        quality, (line,) = self.remarks(self.cut(hole), 4)
        self.assertTrue(2 < quality["min_dihedral_unforced"] < 10, quality)
        self.assertRegex(line, r"^%d elements have angles below 10 degrees, the smallest is [\d.]+ degrees, at (Face|Edge)\d.*: stresses are poor there" % quality["below_10"])

    def test_those_of_thin_walls_are_told_with_what_to_set(self):
        self.box.Height = 0.6
        quality, (line,) = self.remarks(self.box, 8)
        self.assertGreater(quality["below_10"], 0)
        self.assertRegex(line, r"^[\d.]+ % of the elements have angles below 10 degrees, .* across them \(Across walls\)")

    def test_of_those_that_it_forces_nothing_is_said(self):
        tool = self.document.addObject("Part::Box", "Tool")
        tool.Length = tool.Width = tool.Height = 200
        tool.Placement = FreeCAD.Placement(FreeCAD.Vector(), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 6))
        quality, lines = self.remarks(self.cut(tool), 4)
        self.assertLess(quality["min_dihedral"], 10)
        self.assertEqual(lines, [])


class FacesThatGetOtherNumbers(unittest.TestCase):
    """The plate without its hole has six faces; the hole comes in between and shifts their numbers."""

    def setUp(self):
        self.document = new_document()
        self.body = plate_with_hole(self.document)
        self.body.Tip = self.document.getObject("Plate")
        self.document.recompute()
        self.analysis = ObjectsFem.makeAnalysis(self.document, "Analysis")
        self.constraints = []
        for number in range(1, len(self.body.Shape.Faces) + 1):
            fixed = ObjectsFem.makeConstraintFixed(self.document, "Fixed%d" % number)
            fixed.References = [(self.body, "Face%d" % number)]
            self.analysis.addObject(fixed)
            self.constraints.append(fixed)
        self.mesh = api.add_mesh(self.body, SIZE, order=1)
        self.document.recompute()

    def planes(self):
        """Where each constraint's face lies."""
        found = {}
        for fixed in self.constraints:
            faces = [self.body.Shape.getElement(name) for _, names in fixed.References for name in names]
            normals = {tuple(round(c, 6) for c in face.normalAt(0, 0)) for face in faces}
            self.assertEqual(len(normals), 1)
            found[fixed.Name] = normals.pop()
        return found

    def test_constraints_stay_on_their_faces(self):
        before = self.planes()
        self.body.Tip = self.document.getObject("Hole")
        self.document.recompute()
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)
        self.assertEqual(self.planes(), before)
        shifted = [fixed.Name for number, fixed in enumerate(self.constraints, 1)
                   if fixed.References != [(self.body, ("Face%d" % number,))]]
        self.assertTrue(shifted, "this edit was meant to shift face numbers")
        groups = groups_of(self.mesh)
        for fixed in self.constraints:
            name = fixed.References[0][1][0]
            self.assertEqual(groups[fixed.Name + "_Nodes"], groups[name + "_Nodes"])

    def test_refinement_stays_on_its_face(self):
        number = max(range(1, 7), key=lambda n: self.body.Shape.getElement("Face%d" % n).CenterOfMass.z)
        region = ObjectsFem.makeMeshRegion(self.document, self.mesh, SIZE / 2, "Fine")
        region.References = [(self.body, "Face%d" % number)]
        self.document.recompute()
        self.body.Tip = self.document.getObject("Hole")
        self.document.recompute()
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)
        face = self.body.Shape.getElement(region.References[0][1][0])
        self.assertAlmostEqual(face.CenterOfMass.z, 10)
        self.assertGreater(len(groups_of(self.mesh)[region.References[0][1][0] + "_Nodes"]), 400)

    def test_edges_and_vertices_stay_where_they_are(self):
        """Numbers of edges shift even where those of faces do not."""
        held = []
        for kind, members in (("Edge", self.body.Shape.Edges), ("Vertex", self.body.Shape.Vertexes)):
            for number, member in enumerate(members, 1):
                fixed = ObjectsFem.makeConstraintFixed(self.document, "%s%d" % (kind, number))
                fixed.References = [(self.body, "%s%d" % (kind, number))]
                self.analysis.addObject(fixed)
                held.append((fixed, member.BoundBox.Center))
        self.mesh.touch()
        self.document.recompute()
        self.body.Tip = self.document.getObject("Hole")
        self.document.recompute()
        shifted = 0
        for fixed, place in held:
            (_, (name,)), = fixed.References
            self.assertLess((self.body.Shape.getElement(name).BoundBox.Center - place).Length, 1e-6, fixed.Name)
            shifted += name != fixed.Name
        self.assertGreater(shifted, 0, "this edit was meant to shift the numbers of edges")

    def test_an_edge_that_is_gone_is_reported(self):
        self.body.Tip = self.document.getObject("Hole")
        self.document.recompute()
        number = next(n for n, edge in enumerate(self.body.Shape.Edges, 1) if edge.Closed)
        self.constraints[0].References = [(self.body, "Edge%d" % number)]
        self.mesh.touch()
        self.document.recompute()
        self.body.Tip = self.document.getObject("Plate")
        self.document.recompute()
        warnings = in_english(json.loads(self.mesh.Report))["warnings"]
        self.assertTrue(any("Fixed1 refers to Edge%d" % number in line for line in warnings), warnings)

    def fix_the_hole(self):
        """The first constraint holds the hole's face, whose number is returned."""
        self.body.Tip = self.document.getObject("Hole")
        self.document.recompute()
        number, = [n for n, face in enumerate(self.body.Shape.Faces, 1) if face.Surface.TypeId == "Part::GeomCylinder"]
        self.constraints[0].References = [(self.body, "Face%d" % number)]
        self.mesh.touch()
        self.document.recompute()
        return number

    def test_a_number_that_means_a_new_face_is_reported(self):
        """The hole's face goes, and a slot's face gets its number."""
        number = self.fix_the_hole()
        sketch = self.body.newObject("Sketcher::SketchObject", "SlotSketch")
        rectangle(sketch, 40, 10, 5, 20)
        hole = self.document.getObject("Hole")
        hole.Profile = sketch
        self.document.recompute()
        self.assertGreaterEqual(len(self.body.Shape.Faces), number)
        warnings = in_english(json.loads(self.mesh.Report))["warnings"]
        self.assertTrue(any("Fixed1 refers to Face%d, which is gone" % number in line for line in warnings), warnings)

    def test_lines_of_two_sketches_with_the_same_ids_are_told_apart(self):
        """Since FreeCAD 1.0 each sketch counts for itself."""
        elements_of = reading.elements_of

        def counted(sketch):
            return [(number, points) for number, (_, points) in enumerate(elements_of(sketch), 1)]
        with mock.patch.object(reading, "elements_of", counted):
            self.test_a_number_that_means_a_new_face_is_reported()

    def test_a_reference_given_after_the_mesh_stays_on_its_face(self):
        self.constraints[0].References = [(self.body, "Face6")]
        plane = self.planes()["Fixed1"]
        self.body.Tip = self.document.getObject("Hole")
        self.document.recompute()
        self.assertEqual(self.planes()["Fixed1"], plane)

    def test_a_face_that_is_gone_is_reported(self):
        number = self.fix_the_hole()
        self.body.Tip = self.document.getObject("Plate")
        self.document.recompute()
        warnings = in_english(json.loads(self.mesh.Report))["warnings"]
        self.assertTrue(any("Fixed1 refers to Face%d" % number in line for line in warnings), warnings)

# SPDX-License-Identifier: GPL-3.0-or-later
"""What happens around a mesh object: no engine, copies, renamed and deleted parts."""
import importlib
import json
import os
import shutil
import sys
import tempfile
import time
import unittest
import zipfile
from types import SimpleNamespace
from unittest import mock

import FreeCAD
import numpy as np
import ObjectsFem
from freecad.featuremesh import api, engine, engine_places, mesh_object, mesh_properties, orphans, size_zone, state, state_property, versions
from freecad.featuremesh.assembled import AssembledParts
from freecad.featuremesh.errors import EngineMissing, UserError
from freecad.featuremesh.formats import is_single_entity
from freecad.featuremesh.gui.undo import undo_step
from freecad.featuremesh.live_result import LiveResult
from freecad.featuremesh.messages import english
from freecad.featuremesh.study.study_object import StudyObject
from meshed_plate import MeshedPlate, points_of
from parts import groups_in_freecad, new_document, placement


class WithoutEngine(MeshedPlate):
    def take_engine_away(self):
        def missing():
            raise EngineMissing("the engine is not installed")
        for name in ("load", "folder"):
            self.addCleanup(setattr, engine, name, getattr(engine, name))
            setattr(engine, name, missing)

    def test_the_mesh_is_shown_and_nothing_is_lost(self):
        self.edit()   # an updated mesh has gaps between its numbers
        before, checksum, report = points_of(self.mesh), state.checksum_of(self.mesh.SavedState), self.mesh.Report
        load, folder = engine.load, engine.folder
        self.take_engine_away()
        self.save_and_reopen()
        self.assertEqual(points_of(self.mesh), before)
        self.edit(24)
        self.assertEqual(self.mesh.Status, "failed: the engine is not installed")
        self.assertEqual(points_of(self.mesh), before)
        self.save_and_reopen()
        self.assertEqual((points_of(self.mesh), self.mesh.Report), (before, report))
        self.assertEqual(state.checksum_of(self.mesh.SavedState), checksum)
        engine.load, engine.folder = load, folder
        self.mesh.touch()
        self.document.recompute()
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)
        self.assertGreater(self.mesh.KeptNodes, 30)

    def test_the_mesh_is_shown_without_freecads_form_too(self):
        self.edit()
        self.mesh.SavedForFreeCAD, self.mesh.AllGroups = "Never", True
        before = points_of(self.mesh), self.mesh.FemMesh.Volumes
        self.take_engine_away()
        self.save_and_reopen()
        self.assertEqual((points_of(self.mesh), self.mesh.FemMesh.Volumes), before)
        self.assertIn("Face1_Nodes", groups_in_freecad(self.mesh))

    def test_the_message_says_what_is_missing(self):
        with mock.patch.object(engine, "_place", None), mock.patch.object(engine_places, "usable", list), \
                self.assertRaisesRegex(EngineMissing, "not installed.*shown as it was saved.*Addon Manager.*pip install.*portable zip"):
            engine.load()


class LargeMesh(MeshedPlate):

    def forms_in_file(self):
        with zipfile.ZipFile(self.document.FileName) as saved:
            return [name for name in saved.namelist() if name.endswith(".unv")]

    def test_is_saved_in_freecads_form_only_where_that_is_asked_for(self):
        """The report says so; the choice holds from the first save, however the mesh became large, and ends where it becomes small again."""
        with mock.patch.object(mesh_properties, "LARGE", self.mesh.TetCount + 1):
            self.save_and_reopen()
            self.assertEqual(len(self.forms_in_file()), 1)
            self.mesh.Size = self.mesh.Size / 2
            self.document.recompute()
            self.assertIn("SavedForFreeCAD to Always", self.mesh.Report)
            before = points_of(self.mesh)
            self.save_and_reopen()
            self.assertEqual((self.forms_in_file(), points_of(self.mesh)), ([], before))
            self.mesh.SavedForFreeCAD = mesh_properties.ALWAYS
            self.assertNotIn("Touched", self.mesh.State)
            self.save_and_reopen()
            self.assertEqual(len(self.forms_in_file()), 1)
            self.mesh.SavedForFreeCAD = mesh_properties.UNLESS_LARGE
            self.mesh.Size = self.mesh.Size * 4
            self.document.recompute()
            self.assertNotIn("SavedForFreeCAD", self.mesh.Report)
            self.save_and_reopen()
            self.assertEqual(len(self.forms_in_file()), 1)


class LargeState(MeshedPlate):

    def is_compressed(self):
        with zipfile.ZipFile(self.mesh.SavedState) as members:
            return all(member.compress_type == zipfile.ZIP_DEFLATED for member in members.infolist())

    def test_is_compressed_in_the_window_while_nobody_waits(self):
        with mock.patch.object(state_property, "FreeCAD", SimpleNamespace(GuiUp=True)), mock.patch.multiple(state_property, _LARGE=0, _WHEN_NOBODY_WAITS=0.0):
            self.edit()
            until = time.monotonic() + 30
            while not self.is_compressed() and time.monotonic() < until:
                time.sleep(0.01)
        self.assertTrue(self.is_compressed())
        self.edit(24)
        self.assertGreater(self.mesh.KeptNodes, 30)
        self.assertFalse(self.is_compressed())
        self.save_and_reopen()
        self.edit(22)
        self.assertEqual((self.mesh.Status, json.loads(self.mesh.Report)["fallback"]), (mesh_object.UP_TO_DATE, None))


class WithoutTheAddon(MeshedPlate):

    def test_a_mesh_that_another_freecad_saved_is_ours_again(self):
        """It stays with the part as that is edited there, and follows the first recompute here."""
        self.mesh.Proxy = None   # as FreeCAD saves it then
        self.edit()
        orphans.install()
        self.save_and_reopen()
        self.assertEqual((api.meshes_of(self.document), self.mesh.Status), ([self.mesh], mesh_object.OUT_OF_DATE))
        self.document.recompute()
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)
        self.assertGreater(self.mesh.KeptNodes, 30)

    def test_so_are_all_other_objects_of_ours(self):
        zone = size_zone.add(self.mesh, size_zone.BOX, 1.0)
        analysis = ObjectsFem.makeAnalysis(self.document)
        others = {AssembledParts: self.document.addObject("Part::FeaturePython", "Parts"), LiveResult: self.document.addObject("App::FeaturePython", "Live")}
        for proxy_class, obj in others.items():
            proxy_class(obj)
        others.update({size_zone.SizeZone: zone, StudyObject: api.add_study(self.body, analysis)})
        names = {}
        for proxy_class, obj in others.items():
            obj.Proxy, names[proxy_class] = None, obj.Name
        orphans.install()
        self.save_and_reopen()
        for proxy_class, name in names.items():
            self.assertIsInstance(self.document.getObject(name).Proxy, proxy_class)

    def test_any_of_our_objects_may_be_the_first_in_a_document(self):
        """FreeCAD then imports its module before all others; where that failed the object would be nobody's."""
        package = sys.modules["freecad.featuremesh"]
        self.addCleanup(setattr, sys.modules["freecad"], "featuremesh", package)
        for name in ("assembled", "live_result", "mesh_object", "size_zone", "study.study_object"):
            with self.subTest(name), mock.patch.dict(sys.modules):
                for loaded in [loaded for loaded in sys.modules if loaded.startswith("freecad.featuremesh")]:
                    del sys.modules[loaded]
                importlib.import_module("freecad.featuremesh." + name)


class Copies(MeshedPlate):

    def test_a_copy_of_the_mesh_lives_on_its_own(self):
        before = points_of(self.mesh)
        copy = self.document.copyObject(self.mesh, False)
        self.document.recompute()
        self.assertTrue(mesh_object.is_feature_mesh(copy))
        self.assertIs(versions.part_of(copy), self.body)
        self.assertEqual(points_of(copy), before)
        copy.Automatic = False
        self.edit()
        self.assertEqual(copy.Status, mesh_object.OUT_OF_DATE)
        self.assertEqual(points_of(copy), before)
        self.assertNotEqual(points_of(self.mesh), before)
        api.update_mesh(copy)
        self.assertGreater(copy.KeptNodes, 30)
        self.assertEqual(points_of(copy), points_of(self.mesh))
        self.document.removeObject(self.mesh.Name)
        self.assertEqual(copy.TetCount, copy.FemMesh.VolumeCount)

    def test_undo_brings_both_back_and_loads_stay(self):
        """Copy and paste of a mesh, an edit that both follow, undo: each is the mesh of its own state again."""
        analysis = ObjectsFem.makeAnalysis(self.document)
        fixed = ObjectsFem.makeConstraintFixed(self.document)
        analysis.addObject(fixed)
        analysis.addObject(self.mesh)
        fixed.References = [(self.body, "Face1")]
        self.document.recompute()
        self.document.UndoMode = 1
        self.document.openTransaction("Copy")
        copy = self.document.copyObject(self.mesh, False)
        self.document.recompute()
        self.document.commitTransaction()
        self.assertNotEqual(copy.SavedState, self.mesh.SavedState)
        before, states, face = points_of(self.mesh), self.states(copy), fixed.References[0][1]
        self.assertEqual(points_of(copy), before)
        self.document.openTransaction("Edit")
        self.edit()
        self.document.commitTransaction()
        for step in (self.document.undo, self.document.redo, self.document.undo):
            step()
        self.assertEqual(self.states(copy), states)
        self.assertEqual((points_of(self.mesh), points_of(copy)), (before, before))
        self.document.recompute()
        self.assertEqual((fixed.References[0][1], self.mesh.Status, copy.Status), (face, mesh_object.UP_TO_DATE, mesh_object.UP_TO_DATE))

    def states(self, copy):
        return [state.checksum_of(mesh.SavedState) for mesh in (self.mesh, copy)]

    def test_a_copy_with_its_part_in_another_document(self):
        other = FreeCAD.newDocument("Other")
        self.addCleanup(FreeCAD.closeDocument, other.Name)
        copy = other.copyObject(self.mesh, True)
        self.assertTrue(mesh_object.is_feature_mesh(copy))
        self.assertIs(versions.part_of(copy).Document, other)
        self.assertEqual(points_of(copy), points_of(self.mesh))
        other.getObject("HoleSketch").setDatum("X", FreeCAD.Units.Quantity("22 mm"))
        other.recompute()
        self.assertEqual(copy.Status, mesh_object.UP_TO_DATE)
        self.assertGreater(copy.KeptNodes, 30)
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)


class CopiesWithLoads(MeshedPlate):
    """What is pasted or merged has other names, and is followed all the same."""

    def setUp(self):
        super().setUp()
        self.analysis = ObjectsFem.makeAnalysis(self.document)
        self.fixed = ObjectsFem.makeConstraintFixed(self.document)
        self.fixed.References = [(self.body, self.face_at(self.body, 20, 20))]
        for obj in (self.fixed, self.mesh):
            self.analysis.addObject(obj)
        self.document.recompute()

    def face_at(self, body, x, y):
        name, = ["Face%d" % n for n, face in enumerate(body.Shape.Faces, 1) if (face.CenterOfMass - FreeCAD.Vector(x, y, 5)).Length < 1e-6]
        return name

    def check_copy(self, suffix):
        """A chamfer gives the faces of the copy other numbers; its support stays on the hole, its mesh is kept, the original is as it was."""
        body, mesh, fixed = (self.document.getObject(name + suffix) for name in ("Body", "FeatureMesh", "ConstraintFixed"))
        before = fixed.References[0][1][0]
        chamfer = body.newObject("PartDesign::Chamfer", "Edge")
        chamfer.Base, chamfer.Size = (self.document.getObject("Hole" + suffix), ["Edge1"]), 2
        self.document.recompute()
        self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
        self.assertNotEqual(self.face_at(body, 20, 20), before)
        self.assertEqual(fixed.References, [(body, (self.face_at(body, 20, 20),))])
        self.assertGreater(mesh.KeptNodes, 30)
        self.assertIsNone(json.loads(mesh.Report)["fallback"])
        self.assertEqual(self.fixed.References, [(self.body, (self.face_at(self.body, 20, 20),))])

    def test_an_analysis_copied_with_its_part(self):
        self.document.copyObject([self.analysis], True)
        self.check_copy("001")

    def test_a_document_merged_into_itself(self):
        """The objects of the file have other names twice: those of the load and of what it was."""
        self.save_and_reopen()
        self.fixed = self.document.ConstraintFixed
        self.document.mergeProject(self.document.FileName)
        self.document.recompute()
        self.check_copy("001")

    def test_a_sheet_that_drives_the_part_is_the_same_sheet(self):
        sheet = self.document.addObject("Spreadsheet::Sheet", "Sheet")
        sheet.set("A1", "6")
        sheet.setAlias("A1", "hole")
        self.document.HoleSketch.setExpression("Constraints.Radius", "Sheet.hole")
        self.document.recompute()
        api.update_mesh(self.mesh)
        self.document.copyObject([self.analysis], True)
        copy = self.document.FeatureMesh001
        self.document.getObject("Sheet001").set("A1", "7")
        self.document.recompute()
        self.assertEqual((copy.Status, self.mesh.Status), (mesh_object.UP_TO_DATE, mesh_object.UP_TO_DATE))
        self.assertGreater(copy.KeptNodes, 30)
        verdicts = {row["name"]: row["verdict"] for row in json.loads(copy.Report)["difference"]["features"]}
        self.assertEqual(set(verdicts.values()) & {"added", "removed"}, set(), verdicts)


class SavedAs(MeshedPlate):

    def test_undo_after_save_as(self):
        """FreeCAD looks for a file that undo is to bring back where the document's files were before it got another name."""
        self.document.UndoMode = 1
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        self.document.saveAs(os.path.join(folder, "one.FCStd"))
        before, checksum = points_of(self.mesh), state.checksum_of(self.mesh.SavedState)
        self.document.openTransaction("Edit")
        self.edit()
        self.document.commitTransaction()
        after = points_of(self.mesh)
        self.document.saveAs(os.path.join(folder, "another.FCStd"))
        self.document.undo()
        self.assertEqual((points_of(self.mesh), state.checksum_of(self.mesh.SavedState)), (before, checksum))
        self.document.redo()
        self.assertEqual(points_of(self.mesh), after)
        self.document.undo()
        self.document.recompute()
        self.assertEqual((points_of(self.mesh), self.mesh.Status), (before, mesh_object.UP_TO_DATE))

    def test_a_state_that_is_lost_is_said(self):
        self.document.UndoMode = 1
        for x, is_folder_lost in ((22, False), (24, True)):
            with undo_step(self.document, "Edit"):
                self.edit(x)
            folder = self.document.TransientDir
            for name in os.listdir(folder):
                if name != os.path.basename(self.mesh.SavedState):
                    os.unlink(os.path.join(folder, name))
            if is_folder_lost:
                shutil.rmtree(folder)
            self.document.undo()
            self.assertEqual(self.mesh.Status, "failed: the document holds no mesh state")
            self.document.recompute()
            api.update_mesh(self.mesh)
            self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)


class Members(MeshedPlate):

    def test_no_group_stays_of_a_load_that_is_gone(self):
        analysis, other = (ObjectsFem.makeAnalysis(self.document, name) for name in ("First", "Second"))
        loads = [ObjectsFem.makeConstraintFixed(self.document, name) for name in ("One", "Two")]
        group = ObjectsFem.makeMeshGroup(self.document, self.mesh, False, "Clamp")
        for obj in (*loads, group):
            obj.References = [(self.body, "Face1")]
        for obj in (*loads, self.mesh):
            analysis.addObject(obj)
        self.document.recompute()
        self.assertEqual(self.groups(), {"One_Nodes", "Two_Nodes", "Clamp", "Clamp_Nodes"})
        self.document.removeObject("One")
        self.assertEqual(self.groups(), {"Two_Nodes", "Clamp", "Clamp_Nodes"})
        analysis.removeObject(self.mesh)
        other.addObject(self.mesh)
        self.assertEqual(self.groups(), {"Clamp", "Clamp_Nodes"})

    def groups(self):
        """Those that are of no face, edge, solid or feature."""
        return {name for name in map(self.mesh.FemMesh.getGroupName, self.mesh.FemMesh.Groups)
                if not name.startswith("Feature_") and not is_single_entity(name)}


class Parts(MeshedPlate):

    def test_another_label_changes_nothing(self):
        self.body.Label, self.mesh.Label = "Träger", "Netz"
        self.document.getObject("Hole").Label = "Bohrung"
        self.edit()
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)
        self.assertGreater(self.mesh.KeptNodes, 30)
        self.save_and_reopen()
        self.edit(24)
        self.assertGreater(self.mesh.KeptNodes, 30)

    def test_deletion_of_the_part_leaves_the_mesh(self):
        before = points_of(self.mesh)
        self.body.removeObjectsFromDocument()
        self.document.removeObject(self.body.Name)
        self.document.recompute()
        self.assertEqual(points_of(self.mesh), before)
        with self.assertRaisesRegex(UserError, "no part to mesh"):
            api.update_mesh(self.mesh)
        self.assertEqual(points_of(self.mesh), before)
        self.save_and_reopen()
        self.assertEqual(points_of(self.mesh), before)
        shared = api.share_mesh(self.mesh, self.document.addObject("Fem::FemAnalysis", "Analysis"))
        self.assertEqual(points_of(shared), before)
        api.renumber_mesh(self.mesh)
        self.assertEqual(set(points_of(shared)), set(range(1, len(before) + 1)))

    def test_undo_of_an_edit_without_the_part(self):
        self.document.UndoMode = 1
        before = points_of(self.mesh)
        with undo_step(self.document, "Edit"):
            self.edit()
        setattr(self.mesh, versions.part_property(self.mesh), None)
        self.document.undo()
        self.assertEqual(points_of(self.mesh), before)

    def test_undo_of_the_deletion(self):
        self.document.UndoMode = 1
        before = points_of(self.mesh)
        self.document.openTransaction("Delete")
        self.document.removeObject(self.mesh.Name)
        self.document.commitTransaction()
        self.document.undo()
        self.mesh = self.document.getObject("FeatureMesh")
        self.assertEqual(points_of(self.mesh), before)
        self.edit()
        self.assertGreater(self.mesh.KeptNodes, 30)


class NarrowFace(unittest.TestCase):
    LEDGE = [[30, 30, 8]]

    def setUp(self):
        """A block with a ledge 0.3 mm wide and a hole far from it."""
        self.document = new_document()
        for name, width, height, z in (("Plate", 30, 8, 0), ("Top", 29.7, 6, 8)):
            box = self.document.addObject("Part::Box", name)
            box.Length, box.Width, box.Height, box.Placement = 60, width, height, placement(z=z)
        stepped = self.document.addObject("Part::Fuse", "Stepped")
        stepped.Base, stepped.Tool = self.document.Plate, self.document.Top
        hole = self.document.addObject("Part::Cylinder", "Hole")
        hole.Radius, hole.Height, hole.Placement = 4, 20, placement(15, 12, -1)
        part = self.document.addObject("Part::Cut", "Part")
        part.Base, part.Tool = stepped, hole
        self.document.recompute()
        self.mesh = api.add_mesh(part, 3, order=1)
        self.document.recompute()

    def save(self):
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        self.document.saveAs(os.path.join(folder, "part.FCStd"))

    def reopen(self):
        path = self.document.FileName
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        self.mesh = self.document.FeatureMesh

    def move_hole(self):
        self.document.Hole.Placement = placement(17, 12, -1)
        self.document.recompute()
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)
        self.assertGreater(self.mesh.KeptNodes, 50)
        self.assertLess(self.mesh.KeptNodes, 100)
        return points_of(self.mesh)

    def restored(self):
        saved = state.load(self.mesh.SavedState)
        return engine.load().restore_part(saved.raw, saved.options, saved.arrays)

    def save_as_schema_1(self, left_out):
        """The document's state as versions saved it that knew no arrays of these names, which a reopened document then has."""
        saved = state.load(self.mesh.SavedState)
        for name in left_out:
            del saved.arrays[name]
        path = os.path.join(self.document.TransientDir, "schema_1.npz")
        with mock.patch.object(state, "SCHEMA", 1):
            state.save(path, saved)
        self.mesh.SavedState = path

    def test_shorter_edges_along_it_stay_in_a_reopened_document(self):
        self.save()
        live = self.move_hole()
        self.reopen()
        self.assertAlmostEqual(self.restored().wanted_sizes(self.LEDGE)[0], 1.2, 3)
        self.assertEqual(self.move_hole(), live)

    def test_a_state_from_before_there_were_any_goes_on_without(self):
        before = points_of(self.mesh)
        self.save_as_schema_1(("refined_narrow_faces", "ignored_below", "made_for_nodes", "made_for_sizes", "adopted_sizes"))
        self.save()
        self.reopen()
        self.assertEqual(points_of(self.mesh), before)
        self.assertAlmostEqual(self.restored().wanted_sizes(self.LEDGE)[0], 3, 3)
        self.move_hole()
        self.assertAlmostEqual(self.restored().wanted_sizes(self.LEDGE)[0], 3, 3)

    def test_the_engine_asks_for_every_array(self):
        saved = state.load(self.mesh.SavedState)
        for name in set(saved.arrays) - {"shared_nodes"}:   # which follow from the others
            arrays = {other: values for other, values in saved.arrays.items() if other != name}
            with self.subTest(without=name), self.assertRaisesRegex(engine.load().StateError, "The saved mesh has no array '%s'" % name):
                engine.load().restore_part(saved.raw, saved.options, arrays)

    def test_the_engine_refuses_arrays_with_impossible_numbers(self):
        saved = state.load(self.mesh.SavedState)
        few_corners = {**saved.arrays, "counters": saved.arrays["counters"] * [1, 0, 1, 1]}
        for call in (lambda: engine.load().transfer_field(few_corners, saved.arrays, np.zeros(len(saved.arrays["points"]))),
                     lambda: engine.load().adopt_part(saved.raw, saved.options, few_corners)):
            with self.assertRaisesRegex(engine.load().StateError, "nodes that it does not have"):
                call()
        for name, damage in (("counters", 3), ("points", np.nan), ("entities", (9, 0)), ("entities", (3, 77)), ("tets", -7),
                             ("parameters", np.nan), ("segment_edges", 10 ** 6), ("ignored_below", np.nan)):
            damaged = np.array(saved.arrays[name])
            damaged[0] = damage
            with self.subTest(name=name, damage=damage), self.assertRaises(engine.load().StateError):
                engine.load().restore_part(saved.raw, saved.options, {**saved.arrays, name: damaged})
        for node, size in ((10 ** 6, 1.0), (-1, 1.0), (0, np.nan), (0, -1.0)):
            made_for = {"made_for_nodes": np.array([node], np.int32), "made_for_sizes": np.array([size])}
            with self.subTest(node=node, size=size), self.assertRaises(engine.load().StateError):
                engine.load().restore_part(saved.raw, saved.options, {**saved.arrays, **made_for})
        with self.assertRaises(engine.load().StateError):
            engine.load().restore_part(saved.raw, saved.options, {**saved.arrays, "adopted_sizes": np.array([[0.0, 0.0, np.inf, 1.0]])})

    def test_the_engine_cuts_no_numbers(self):
        saved = state.load(self.mesh.SavedState)
        wide = {name: np.array(values, dtype=np.int64 if values.dtype.kind == "i" else values.dtype) for name, values in saved.arrays.items()}
        self.assertEqual(engine.load().restore_part(saved.raw, saved.options, wide).arrays()["tets"].tolist(), saved.arrays["tets"].tolist())
        for name, damage in (("tets", lambda values: values + 2 ** 32), ("entities", lambda values: values + 2 ** 32), ("triangles", lambda values: values + 0.25),
                             ("node_numbers", lambda values: np.full(len(values), np.nan))):
            with self.subTest(name=name), self.assertRaisesRegex(engine.load().StateError, "'%s' has numbers that are not whole, or too large" % name):
                engine.load().restore_part(saved.raw, saved.options, {**wide, name: damage(wide[name])})


class IgnoredDetails(unittest.TestCase):
    def setUp(self):
        """A block with a step as low as 0.004 mm and a hole far from it."""
        self.document = new_document()
        for name, length, height, z in (("Block", 60, 8, 0), ("Top", 30, 0.004, 8)):
            box = self.document.addObject("Part::Box", name)
            box.Length, box.Width, box.Height, box.Placement = length, 30, height, placement(z=z)
        stepped = self.document.addObject("Part::Fuse", "Stepped")
        stepped.Base, stepped.Tool = self.document.Block, self.document.Top
        hole = self.document.addObject("Part::Cylinder", "Hole")
        hole.Radius, hole.Height, hole.Placement = 4, 20, placement(45, 15, -1)
        part = self.document.addObject("Part::Cut", "Part")
        part.Base, part.Tool = stepped, hole
        self.document.recompute()
        self.mesh = api.add_mesh(part, 4, order=1)

    def move_hole(self, x):
        self.document.Hole.Placement = placement(x, 15, -1)
        self.document.recompute()
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)
        return points_of(self.mesh)

    def test_have_no_elements_where_they_are_below_the_length(self):
        self.document.recompute()
        self.assertGreater(self.mesh.MinDihedral.Value, 20)   # automatically what is below a two-hundredth of the size is ignored
        self.mesh.IgnoreBelow = -1
        self.document.recompute()
        self.assertLess(self.mesh.MinDihedral.Value, 5)
        details = next(english(line) for line in json.loads(self.mesh.Report)["warnings"] if line["code"] == "details_force_angles")
        self.assertRegex(details, r"Edge\d+ \((Block, )?Top(, Block)?\) \(0.004 mm long\)")
        self.mesh.IgnoreBelow = 0.01
        report = api.update_mesh(self.mesh)
        self.assertGreater(self.mesh.MinDihedral.Value, 20)
        self.assertEqual(self.mesh.KeptNodes, 0)   # with other details than before, nothing of the old mesh is of use
        line, = [english(line) for line in report["warnings"]]
        self.assertRegex(line, r"^Details smaller than 0.01 mm have no elements of their own: Face\d+ \((Block, )?Top(, Block)?\),.* Edge\d+ .*[.]$")

    def test_a_group_of_nothing_else_says_that_it_has_no_elements(self):
        self.mesh.IgnoreBelow = 0.01
        part = versions.part_of(self.mesh)
        by_area = sorted(range(1, len(part.Shape.Faces) + 1), key=lambda number: part.Shape.Faces[number - 1].Area)
        for number in (by_area[0], by_area[-1]):
            api.add_group(self.mesh, [(part, "Face%d" % number)])
        lines = [english(line) for line in api.update_mesh(self.mesh)["warnings"]]
        self.assertEqual([line.partition(" is too small")[0] for line in lines if line.startswith("MeshGroup")],
                         ["MeshGroup has nodes and no elements: Face%d" % by_area[0]])
        self.assertEqual(sorted(groups_in_freecad(self.mesh)), ["MeshGroup001", "MeshGroup001_Nodes", "MeshGroup_Nodes"])

    def test_are_ignored_from_the_first_mesh_on_by_a_script(self):
        self.mesh.IgnoreBelow = 0.01
        api.update_mesh(self.mesh)
        other = api.add_mesh(versions.part_of(self.mesh), 4, order=1, ignore_below="0.01 mm")
        api.update_mesh(other)
        self.assertEqual(points_of(other), points_of(self.mesh))
        self.assertEqual(api.add_mesh(versions.part_of(self.mesh), 4, ignore_below=-1).IgnoreBelow.Value, -1)
        with self.assertRaisesRegex(UserError, "little is no length"):
            api.add_mesh(versions.part_of(self.mesh), 4, ignore_below="little")

    def test_stay_without_elements_in_a_reopened_document(self):
        self.mesh.IgnoreBelow = 0.01
        self.document.recompute()
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        path = os.path.join(folder, "part.FCStd")
        self.document.saveAs(path)
        live = self.move_hole(47)
        self.assertGreater(self.mesh.KeptNodes, 50)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        self.mesh = self.document.FeatureMesh
        self.assertEqual(self.move_hole(47), live)

    def test_a_mesh_from_before_the_property_is_updated_locally(self):
        self.document.recompute()
        report = json.loads(self.mesh.Report)
        del report["settings"]["IgnoreBelow"]
        self.mesh.Report = json.dumps(report)
        self.assertFalse(mesh_properties.differ_from_mesh(self.mesh, mesh_properties.settings_of(self.mesh)))
        saved = state.load(self.mesh.SavedState)
        options = {name: value for name, value in saved.options.items() if name != "ignore_below"}
        old = engine.load().restore_part(saved.raw, options, saved.arrays)
        _, update = engine.load().update_part(old, saved.raw, saved.options)
        self.assertEqual(update["kept"]["nodes_share"], 1)


class BesideGmshAndNetgen(unittest.TestCase):
    def test_the_page_names_every_property_of_their_mesh_objects(self):
        with open(os.path.join(os.path.dirname(__file__), "..", "..", "docs", "beside-gmsh-and-netgen.md"), encoding="utf-8") as stream:
            page = stream.read()
        document = new_document()
        known = set()
        for make in (ObjectsFem.makeMeshGmsh, ObjectsFem.makeMeshNetgen):
            mesh = make(document)
            known |= {name for name in mesh.PropertiesList if mesh.getGroupOfProperty(name) in ("Mesh Parameters", "FEM Gmsh Mesh Params")}
        self.assertGreater(len(known), 15)
        self.assertEqual([name for name in sorted(known) if "`%s`" % name not in page], [])

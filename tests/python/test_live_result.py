# SPDX-License-Identifier: GPL-3.0-or-later
"""The live result as a script sees it: what of the analysis it follows, when it is out of date, and what of it FreeCAD takes."""
import ast
import json
import os
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path
from unittest import mock

import Fem
import FreeCAD
import numpy as np
import ObjectsFem
from analyses import quantity
from freecad.featuremesh import api, engine, live_result, mesh_object, mesh_properties, messages, results, solve_guard, statics, user_words, versions
from freecad.featuremesh.errors import UserError
from parts import plate_with_hole, rectangle
from statics_cases import HAS_SOLVER, STEEL, Case, edges_along, faces_at
from test_hand_over import contents

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "resources" / "translations"))
sys.dont_write_bytecode = True
import update_translations  # noqa: E402

_ERRORS = ("UserError", "NotUnderstood", "CanMove")


def cut_meshes_short(path):
    with zipfile.ZipFile(path) as whole:
        members = {name: whole.read(name) for name in whole.namelist()}
    with zipfile.ZipFile(path, "w") as cut:
        for name, content in members.items():
            cut.writestr(name, content[:len(content) * 2 // 3] if name.endswith(".unv") else content)


def in_german():
    """Qt's translate as in a German window."""
    known = update_translations.read(update_translations.FOLDER / "FeatureMesh_de.ts")
    return mock.patch.object(FreeCAD.Qt, "translate", side_effect=lambda *words: known.get(words, words[1]))


def errors_raised_in(name):
    """The arguments of the errors that a module of the workbench raises, as syntax."""
    tree = ast.parse((update_translations.WORKBENCH / name).read_text(encoding="utf-8"))
    return [node.exc.args[0] for node in ast.walk(tree)
            if isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call) and getattr(node.exc.func, "id", "") in _ERRORS]


class ErrorsInTheUsersLanguage(unittest.TestCase):
    def test_all_that_the_live_solver_and_calculix_refuse_is_a_message_with_parameters(self):
        for name in ("statics.py", "statics_model.py", "calculix.py"):
            raised = errors_raised_in(name)
            self.assertGreater(len(raised), 3)
            for argument in raised:
                self.assertTrue(isinstance(argument, ast.Call) and argument.func.id in ("said", "with_parts"), "%s, line %d" % (name, argument.lineno))

    def test_a_text_and_a_message(self):
        self.assertEqual(messages.of_error(UserError("add %s")), "add %s")
        said = messages.said("{load:text} loads nothing", load="Force")
        self.assertIs(messages.of_error(UserError(said)), said)
        self.assertEqual(str(UserError(said)), "Force loads nothing")


@unittest.skipUnless(HAS_SOLVER, "PETSc is not installed")
class Live(Case):
    def cantilever(self, size=4.0):
        part, analysis = self.held_box(size)
        return part, analysis, api.live_result(analysis)

    def touched(self):
        return [obj.Name for obj in self.document.Objects if "Touched" in obj.State]

    def check_is_fresh(self, analysis, live):
        fields, report = statics.solve(analysis)
        self.assertEqual(live.Status, live_result.UP_TO_DATE)
        self.assertEqual(len(live.Result.NodeNumbers), len(fields["von_mises"]))
        self.assertEqual(live.Result.Mesh.FemMesh.NodeCount, len(fields["von_mises"]))
        self.assertAlmostEqual(live.MaxMises / report["responses"]["max_mises_mpa"], 1, delta=1e-6)
        self.assertAlmostEqual(max(live.Result.vonMises) / live.MaxMises, 1, delta=1e-12)
        self.assertAlmostEqual(max(live.Result.DisplacementLengths) / report["responses"]["max_displacement_mm"], 1, delta=1e-6)

    def test_follows_each_recompute_and_nothing_else(self):
        part, analysis, live = self.cantilever(size=2.5)
        self.check_is_fresh(analysis, live)
        self.assertIs(api.live_result(analysis), live)
        self.assertEqual([obj.Name for obj in self.document.Objects if "Touched" in obj.State and obj is not analysis], [])
        before = live.Report
        self.document.recompute()
        self.assertEqual(live.Report, before)   # nothing changed, nothing was solved
        part.Length = 44
        self.document.recompute()
        self.assertNotEqual(live.Report, before)
        self.check_is_fresh(analysis, live)
        self.assertTrue(json.loads(live.Report)["reused"]["start_share"] > 0)
        self.document.recompute()
        self.assertEqual(sum(obj.isDerivedFrom("Fem::FemResultObject") for obj in self.document.Objects), 1)

    def test_freecads_vtk_writer_takes_the_result(self):
        """As its pipeline does, by the same code."""
        part, analysis, live = self.cantilever()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "result.vtk")
            Fem.writeResult(path, live.Result)
            back = ObjectsFem.makeResultMechanical(self.document, "Back")
            Fem.readResult(path, back.Name)
            read = next(obj for obj in self.document.Objects if obj.isDerivedFrom("Fem::FemResultObject") and obj is not live.Result and len(obj.vonMises))
            np.testing.assert_allclose(sorted(read.vonMises), 1e6 * np.sort(live.Result.vonMises), rtol=1e-5)   # it writes Pa

    def test_what_changed_but_was_not_solved_yet_is_out_of_date(self):
        part, analysis, live = self.cantilever()
        for change in (lambda: setattr(self.document.Force, "Force", quantity(2000, "N")),
                       lambda: setattr(self.document.Steel, "Material", dict(STEEL, YoungsModulus="70000 MPa")),
                       lambda: self.add(analysis, ObjectsFem.makeConstraintPressure, "Pressure", [(part, faces_at(part, 2, 10))], Pressure=quantity(2.0, "MPa"))):
            change()
            self.assertEqual(live.Status, live_result.OUT_OF_DATE)
            self.assertTrue(results.is_old(live.Result), live.Result.Label)
            self.document.recompute()
            self.check_is_fresh(analysis, live)
            self.assertFalse(results.is_old(live.Result), live.Result.Label)

    def test_what_freecad_cannot_recompute_leaves_nothing_up_to_date(self):
        """FreeCAD recomputes nothing of what depends on it, and says nothing to that."""
        body = plate_with_hole(self.document)
        analysis = self.analysis()
        self.fix(analysis, body, faces_at(body, 0, 0))
        self.force(analysis, body, faces_at(body, 0, 60))
        mesh = self.mesh(body, 8)
        live = api.live_result(analysis)
        self.document.Plate.Length = 0
        self.document.recompute()
        self.assertIn("FreeCAD cannot recompute Plate: ", mesh.Status)
        self.assertEqual(live.Status, live_result.OUT_OF_DATE)
        self.assertFalse(live.Proxy.is_fresh)
        with self.assertRaisesRegex(UserError, "cannot recompute Plate"):
            solve_guard.refuse(analysis)
        self.document.Plate.Length = 10
        self.document.recompute()
        self.assertEqual(mesh.Status, mesh_properties.UP_TO_DATE)
        self.check_is_fresh(analysis, live)
        self.document.Force.setExpression("Force", "Nothing.Length")
        self.document.recompute()
        self.assertEqual(mesh.Status, mesh_properties.UP_TO_DATE)
        self.assertIn("FreeCAD cannot recompute Force: ", live.Status)
        self.document.recompute()
        self.assertIn("FreeCAD cannot recompute Force: ", live.Status)
        self.document.Force.setExpression("Force", None)
        self.document.recompute()
        self.check_is_fresh(analysis, live)

    def test_a_load_whose_face_is_gone_says_so(self):
        """FreeCAD cannot recompute it either, "Index out of bound"."""
        body = plate_with_hole(self.document)
        analysis = self.analysis()
        self.fix(analysis, body, faces_at(body, 0, 0))
        round_face = next("Face%d" % number for number, face in enumerate(body.Shape.Faces, 1) if type(face.Surface).__name__ == "Cylinder")
        self.force(analysis, body, [round_face])
        self.mesh(body, 8)
        live = api.live_result(analysis)
        body.Tip = self.document.Plate
        self.document.recompute()
        self.assertIn("refers to %s, which is gone" % round_face, live.Status)

    def test_a_load_whose_face_has_another_number(self):
        """FreeCAD cannot recompute it at first, and leaves out what depends on it."""
        body = plate_with_hole(self.document)
        analysis = self.analysis()
        self.fix(analysis, body, faces_at(body, 0, 0))
        sketch = body.newObject("Sketcher::SketchObject", "GrooveSketch")
        rectangle(sketch, 40, -5, 10, 60)
        groove = body.newObject("PartDesign::Pocket", "Groove")
        groove.Profile, groove.Reversed, groove.Length = sketch, True, 3
        body.Tip = groove
        self.document.recompute()
        self.force(analysis, body, ["Face%d" % len(body.Shape.Faces)])
        self.document.Force.Direction = None
        self.mesh(body, 8)
        live = api.live_result(analysis)
        self.document.recompute()
        self.assertEqual(live.Status, "up to date")
        self.document.removeObject("Groove")
        body.Tip = self.document.Hole
        self.document.recompute()
        self.assertEqual((live.Status, [obj.Name for obj in self.document.Objects if {"Invalid", "Touched"} & set(obj.State)]), ("up to date", []))

    def test_an_error_fails_the_mesh_when_it_is_new(self):
        """One that stays is no reason to fail what was meshed anew since; one that comes again after undo is."""
        body = plate_with_hole(self.document)
        mesh = self.mesh(body, 8)
        self.document.UndoMode = 1
        for _ in range(2):
            self.document.openTransaction("Edit")
            self.document.Plate.Length = 0
            self.document.commitTransaction()
            self.document.recompute()
            self.assertIn("FreeCAD cannot recompute Plate: ", mesh.Status)
            self.document.undo()
        self.document.recompute()
        self.assertEqual(mesh.Status, mesh_properties.UP_TO_DATE)
        self.document.Plate.Length = 0
        self.document.recompute()
        api.update_mesh(mesh)
        self.assertEqual(mesh.Status, mesh_properties.UP_TO_DATE)
        self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        self.assertEqual(mesh.Status, mesh_properties.UP_TO_DATE)

    def test_mesh_that_failed_leaves_its_result_out_of_date(self):
        part, analysis, live = self.cantilever()
        with mock.patch.object(mesh_object.FeatureMesh, "_store", side_effect=UserError("the disk is full")):
            part.Length = 44
            self.document.recompute()
        self.assertEqual(live.Status, live_result.OUT_OF_DATE)
        self.document.recompute()
        self.check_is_fresh(analysis, live)

    def test_by_hand(self):
        part, analysis, live = self.cantilever()
        live.Automatic = False
        self.document.recompute()
        self.assertEqual(live.Status, live_result.OUT_OF_DATE)
        api.solve_live(live)
        self.check_is_fresh(analysis, live)
        part.Length = 42
        self.document.recompute()
        self.assertEqual(live.Status, live_result.OUT_OF_DATE)
        api.solve_live(live)
        self.check_is_fresh(analysis, live)

    def test_what_cannot_be_solved_says_why_and_comes_back(self):
        part, analysis, live = self.cantilever()
        analysis.removeObject(self.document.Fixed)
        self.document.recompute()
        self.assertRegex(live.Status, "failed: the part can still move along x, y and z and turn about x, y and z: add a support")
        motion = live.Proxy.motion
        self.assertEqual(motion.shape, (self.document.FeatureMesh.NodeCount, 3))
        lengths = np.linalg.norm(motion, axis=1)
        self.assertTrue(0.1 < lengths.max() < 40, lengths.max())
        self.assertTrue(results.is_old(live.Result), live.Result.Label)
        analysis.addObject(self.document.Fixed)
        self.document.recompute()
        self.check_is_fresh(analysis, live)

    def test_what_cannot_be_solved_at_first_leaves_nothing_behind(self):
        part = self.box()
        analysis = self.analysis()
        self.force(analysis, part, faces_at(part, 0, 40))
        self.mesh(part, 4.0)
        before = {obj.Name for obj in self.document.Objects}
        with self.assertRaisesRegex(UserError, "add a support"):
            api.live_result(analysis)
        self.assertEqual({obj.Name for obj in self.document.Objects}, before)
        self.fix(analysis, part, faces_at(part, 0, 0))
        live = api.live_result(analysis)
        self.check_is_fresh(analysis, live)
        analysis.removeObject(self.document.Fixed)
        with self.assertRaisesRegex(UserError, "add a support"):
            api.live_result(analysis)
        self.assertIn(live, self.document.Objects)   # it was there before

    def test_without_a_result_nothing_is_called_out_of_date(self):
        _, analysis = self.held_box()
        live = live_result.add(analysis)
        self.assertEqual(live.Status, live_result.NOT_SOLVED)
        live.Proxy.prepare(live)
        self.assertEqual(live.Status, live_result.FIRST_SOLVING)
        live.Proxy.fail(live, KeyboardInterrupt())
        self.assertEqual(live.Status, live_result.FIRST_CANCELLED)
        api.solve_live(live)
        self.check_is_fresh(analysis, live)
        live.Proxy.prepare(live)
        self.assertEqual(live.Status, live_result.SOLVING)

    def test_an_analysis_that_is_gone_while_it_is_solved(self):
        part, analysis, live = self.cantilever()
        job = live.Proxy.prepare(live)
        job.run(None)
        analysis.removeObject(live)
        with self.assertRaisesRegex(UserError, "belongs to no analysis"):
            live.Proxy.finish(live, job)

    def test_without_an_analysis_it_says_so_and_is_solved_in_the_next_one(self):
        _, analysis, live = self.cantilever()
        copy = self.document.copyObject(live, True)
        copy = next(obj for obj in copy if live_result.is_live_result(obj)) if isinstance(copy, (list, tuple)) else copy
        self.assertIn("belongs to no analysis; drag it into one", copy.Status)
        analysis.removeObject(live)
        self.assertIn("belongs to no analysis", live.Status)
        self.document.recompute()
        self.assertIn("belongs to no analysis", live.Status)
        analysis.addObject(live)
        self.document.recompute()
        self.check_is_fresh(analysis, live)

    def test_of_a_mesh_that_could_not_be_read_it_is_out_of_date(self):
        _, _, live = self.cantilever()
        live.Members = [member for member in live.Members if not mesh_object.is_feature_mesh(member)]
        live.Status = live_result.UP_TO_DATE
        live.Proxy.onDocumentRestored(live)
        self.assertEqual(live.Status, live_result.OUT_OF_DATE)

    def test_why_it_failed_is_in_the_users_language(self):
        part, analysis, live = self.cantilever()
        for refer, english, german in (
                (edges_along(part, 1)[:1], "the part can still turn about y: add a support", "das Bauteil kann sich noch um y drehen: ein Lager hinzufügen"),
                ([], "Fixed refers to nothing: choose faces, edges or vertices for it", "Fixed bezieht sich auf nichts: Flächen, Kanten oder Eckpunkte dafür wählen")):
            self.document.Fixed.References = [(part, refer)] if refer else []
            with in_german():
                self.document.recompute()
                self.assertEqual(mesh_properties.status_in_words(live), "fehlgeschlagen: " + german)
            self.assertEqual(live.Status, "failed: " + english)
        analysis.removeObject(self.document.Fixed)
        with self.assertRaises(UserError) as caught, in_german():
            statics.solve(analysis)
        with in_german():
            self.assertEqual(user_words.in_words(messages.of_error(caught.exception)),
                             "das Bauteil kann sich noch entlang x, y und z verschieben und um x, y und z drehen: ein Lager hinzufügen")

    def test_why_it_failed_is_said_once_until_there_is_a_result(self):
        part, analysis, live = self.cantilever()
        fixed, faces = self.document.Fixed, self.document.Fixed.References
        told = []
        with mock.patch.object(live_result.FreeCAD, "Console", mock.Mock(wraps=FreeCAD.Console, PrintWarning=told.append)):
            for references in ([], [], [(part, edges_along(part, 1)[:1])], faces, []):
                fixed.References = references
                fixed.touch()
                self.document.recompute()
        nothing = "%s: Fixed refers to nothing: choose faces, edges or vertices for it\n" % live.Label
        self.assertEqual([line for line in told if live.Label in line],
                         [nothing, "%s: the part can still turn about y: add a support\n" % live.Label, nothing])

    def test_a_part_without_a_load_says_so_once(self):
        part, analysis, live = self.cantilever()
        told = []
        with mock.patch.object(live_result.FreeCAD, "Console", mock.Mock(wraps=FreeCAD.Console, PrintWarning=told.append)):
            analysis.removeObject(self.document.Force)
            for length in (41, 42):
                part.Length = length
                self.document.recompute()
        self.assertEqual(live.Status, live_result.UP_TO_DATE)
        self.assertEqual([line for line in told if live.Label in line],
                         ["%s: nothing loads the part: add a force, a pressure or another load to the analysis\n" % live.Label])

    def test_mesh_that_is_out_of_date_is_not_solved(self):
        part, analysis, live = self.cantilever()
        self.document.FeatureMesh.Automatic = False
        part.Length = 44
        self.document.recompute()
        self.assertIn("update it before solving", live.Status)
        api.update_mesh(self.document.FeatureMesh)
        self.document.recompute()
        self.assertTrue(results.is_old(live.Result), live.Result.Label)   # by hand the mesh asks for no recompute
        api.solve_live(live)
        self.check_is_fresh(analysis, live)

    def test_is_there_again_when_the_document_is_opened(self):
        part, analysis, live = self.cantilever()
        largest = live.MaxMises
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "part.FCStd")
            self.document.saveAs(path)
            found = contents(live.Result.Mesh.FemMesh)
            FreeCAD.closeDocument(self.document.Name)
            cut_meshes_short(path)   # as FreeCAD reads them where temporary files have too little room
            self.document = FreeCAD.openDocument(path)
            live = self.document.Live
            self.assertEqual((live.Status, live.MaxMises, contents(live.Result.Mesh.FemMesh)), (live_result.UP_TO_DATE, largest, found))
            self.assertAlmostEqual(live.Proxy.shown(live).von_mises.max(), largest, places=9)
            self.document.UndoMode = 1
            self.document.openTransaction("A panel that changes nothing of it")
            self.document.Box.Label = "Beam"
            self.document.abortTransaction()
            self.assertEqual(live.Status, live_result.UP_TO_DATE)
            self.document.Box.Length = 44
            self.document.recompute()
            self.check_is_fresh(self.document.Analysis, live)

    def test_nothing_is_kept_of_a_closed_document(self):
        """What the engine keeps of a solution are hundreds of megabytes for a large part; and what was made there is not what has the same name in another document."""
        _, analysis, live = self.cantilever()
        key, freed = live.Proxy.key(live), []
        api.solve_analysis(analysis, keep="a script's")
        with mock.patch.object(engine.load(), "forget_statics", side_effect=freed.append):
            FreeCAD.closeDocument(self.document.Name)
        self.assertCountEqual(freed, [key, "a script's"])
        self.document = FreeCAD.newDocument("Test")
        analysis, result = self.analysis(), ObjectsFem.makeResultMechanical(self.document, "LiveResult")
        self.document.openTransaction("A step that is cancelled")
        self.document.abortTransaction()
        self.assertNotIn(result, analysis.Group)

    def test_a_suppressed_mesh_beside_the_one_that_is_solved(self):
        part, analysis, live = self.cantilever()
        coarse, fine = self.document.FeatureMesh, api.add_mesh(part, 3, order=1, join_analysis=False)
        analysis.addObject(fine)
        for mesh in (coarse, fine):
            if "Suppressed" not in mesh.PropertiesList:   # before FreeCAD 1.1
                mesh.addProperty("App::PropertyBool", "Suppressed")
        coarse.Suppressed = True
        self.document.recompute()
        self.check_is_fresh(analysis, live)
        self.assertEqual([live.Proxy.mesh(live), live.Result.Mesh.FemMesh.NodeCount], [fine, fine.NodeCount])
        coarse.Suppressed, fine.Suppressed = False, True
        self.assertEqual([live.Proxy.mesh(live), live.Status], [coarse, live_result.OUT_OF_DATE])

    def test_its_mesh_is_made_of_the_mesh_where_freecads_form_is_not_saved(self):
        _, _, live = self.cantilever()
        self.document.FeatureMesh.SavedForFreeCAD = "Never"
        found, touched = contents(live.Result.Mesh.FemMesh), self.touched()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "part.FCStd")
            self.document.saveAs(path)
            with zipfile.ZipFile(path) as saved:
                self.assertEqual([name for name in saved.namelist() if name.endswith(".unv")], [])
            self.assertNotIn("Transient", live.Result.Mesh.getPropertyStatus("FemMesh"))   # a recovery has it
            FreeCAD.closeDocument(self.document.Name)
            self.document = FreeCAD.openDocument(path)
            live = self.document.Live
            self.assertNotIn("Transient", live.Result.Mesh.getPropertyStatus("FemMesh"))
            self.assertEqual((live.Status, contents(live.Result.Mesh.FemMesh)), (live_result.UP_TO_DATE, found))
            self.assertEqual(self.touched(), touched)
            live.Automatic = False   # the result stays that of the mesh before, of which the document knows no more
            self.document.Box.Length = 44
            self.document.recompute()
            self.assertEqual(live.Status, live_result.OUT_OF_DATE)
            self.document.save()
            FreeCAD.closeDocument(self.document.Name)
            self.document = FreeCAD.openDocument(path)
            self.assertEqual(contents(self.document.Live.Result.Mesh.FemMesh), found)

    def test_an_edit_of_a_linked_document_makes_it_out_of_date(self):
        with tempfile.TemporaryDirectory() as folder:
            other = FreeCAD.newDocument("Other")
            self.addCleanup(FreeCAD.closeDocument, other.Name)
            box, link = other.addObject("Part::Box", "Box"), self.document.addObject("App::Link", "Link")
            for document in (other, self.document):
                document.recompute()
                document.saveAs(os.path.join(folder, document.Name + ".FCStd"))
            link.LinkedObject, analysis = box, self.analysis()
            mesh = api.add_mesh(link, 4.0, order=1)
            self.document.recompute()
            part = versions.part_of(mesh)
            self.fix(analysis, part, faces_at(part, 0, 0))
            self.force(analysis, part, faces_at(part, 0, 10))
            live = api.live_result(analysis)
            self.check_is_fresh(analysis, live)
            other.UndoMode = 1
            other.openTransaction("Longer")
            box.Length = 14
            other.recompute()
            other.commitTransaction()
            self.assertEqual((mesh.Status, live.Status), (mesh_properties.EDITED_ELSEWHERE, live_result.OUT_OF_DATE))
            self.document.recompute()
            self.assertEqual((mesh.Status, mesh.FemMesh.BoundBox.XMax), (mesh_properties.UP_TO_DATE, 14))
            self.check_is_fresh(analysis, live)
            other.recompute()   # nothing changed
            self.assertEqual((mesh.Status, live.Status), (mesh_properties.UP_TO_DATE, live_result.UP_TO_DATE))
            other.undo()
            self.assertEqual((mesh.Status, live.Status), (mesh_properties.EDITED_ELSEWHERE, live_result.OUT_OF_DATE))
            self.document.recompute()
            self.assertEqual((mesh.Status, mesh.FemMesh.BoundBox.XMax), (mesh_properties.UP_TO_DATE, 10))
            self.check_is_fresh(analysis, live)

    def test_an_edit_that_was_recomputed_from_here_is_undone_in_a_linked_document(self):
        with tempfile.TemporaryDirectory() as folder:
            other = FreeCAD.newDocument("Other")
            self.addCleanup(FreeCAD.closeDocument, other.Name)
            other.UndoMode = 1
            box, link = other.addObject("Part::Box", "Box"), self.document.addObject("App::Link", "Link")
            for document in (other, self.document):
                document.recompute()
                document.saveAs(os.path.join(folder, document.Name + ".FCStd"))
            link.LinkedObject = box
            mesh = api.add_mesh(link, 4.0, order=1)
            other.openTransaction("Longer")
            box.Length = 14
            other.commitTransaction()
            self.document.recompute()
            self.assertEqual((mesh.Status, mesh.FemMesh.BoundBox.XMax), (mesh_properties.UP_TO_DATE, 14))
            other.undo()
            self.assertEqual(mesh.Status, mesh_properties.EDITED_ELSEWHERE)

    def test_undo_is_out_of_date_until_it_is_solved(self):
        self.document.UndoMode = 1
        part, analysis, live = self.cantilever()
        largest = live.MaxMises
        self.document.openTransaction("Longer")
        part.Length = 60
        self.document.recompute()
        self.document.commitTransaction()
        self.assertGreater(live.MaxMises, largest)
        self.document.undo()
        self.assertEqual(self.document.FeatureMesh.Proxy.arrays(self.document.FeatureMesh)["points"].max(), 40)
        self.assertEqual(live.Status, live_result.OUT_OF_DATE)
        api.solve_live(live)
        self.check_is_fresh(analysis, live)

    def test_an_edit_that_is_cancelled_is_out_of_date_until_it_is_solved(self):
        """FreeCAD takes back what it had said of the result, not the mesh that it was solved on."""
        self.document.UndoMode = 1
        part, analysis, live = self.cantilever()
        self.document.openTransaction("Longer")
        part.Length = 60
        self.document.recompute()
        self.document.abortTransaction()
        self.assertEqual((self.document.FeatureMesh.Status, live.Status), (mesh_properties.UP_TO_DATE, live_result.OUT_OF_DATE))
        api.solve_live(live)
        self.check_is_fresh(analysis, live)
        self.assertEqual(live.Result.Mesh.FemMesh.BoundBox.XMax, 40)

    def test_undo_beyond_a_result_leaves_what_redo_needs(self):
        """The window solves outside of any step of undo."""
        self.document.UndoMode = 1
        part, analysis = self.held_box(4.0)
        self.document.openTransaction("Note")
        analysis.addObject(self.document.addObject("App::TextDocument", "Note"))
        self.document.commitTransaction()
        self.document.openTransaction("Live result")
        live = live_result.add(analysis)
        self.document.commitTransaction()
        live.Proxy.solve(live)
        members = [member.Name for member in analysis.Group]
        result = live.Result
        for step in range(2):
            self.document.undo()
        self.assertEqual([member.Name for member in analysis.Group if member.Name in ("Note", "Live", result.Name)], [result.Name])
        for step in range(2):
            self.document.redo()
        self.assertEqual(sorted(member.Name for member in analysis.Group), sorted(members))
        api.solve_live(self.document.Live)
        self.assertEqual([obj for obj in self.document.Objects if obj.isDerivedFrom("Fem::FemResultObject")], [result])
        self.check_is_fresh(analysis, self.document.Live)

    def test_a_result_that_undo_brings_back_stays_for_redo(self):
        """Another one was made meanwhile, outside of any step of undo, as the window does."""
        self.document.UndoMode = 1
        part, analysis, live = self.cantilever()
        first = live.Result.Name
        self.step("Delete", lambda: self.document.removeObject(first))
        api.solve_live(live)
        second = live.Result.Name
        self.assertNotEqual(first, second)
        for again in range(2):
            self.document.undo()
            self.assertEqual((self.document.RedoNames, self.document.HasPendingTransaction), (["Delete"], False))
            self.check_results(analysis, live, first, [first, second])
            self.document.redo()
            self.check_results(analysis, live, second, [second])
        self.document.undo()
        api.solve_live(live)
        self.check_results(analysis, live, first, [first, second])
        self.step("Delete", lambda: self.document.removeObject(first))
        api.solve_live(live)
        self.check_results(analysis, live, second, [second])   # what was left over is used again
        self.check_is_fresh(analysis, live)

    def check_results(self, analysis, live, name, there):
        self.assertEqual(sorted(obj.Name for obj in self.document.Objects if obj.isDerivedFrom("Fem::FemResultObject")), there)
        self.assertEqual([member.Name for member in analysis.Group if member.isDerivedFrom("Fem::FemResultObject")], [name])
        self.assertEqual(live.Result.Name, name)

    def test_a_step_that_is_cancelled_takes_no_mesh_of_a_deleted_result_away(self):
        self.document.UndoMode = 1
        part, analysis, live = self.cantilever()
        first, mesh = live.Result.Name, live.Result.Mesh.Name
        self.step("Delete", lambda: self.document.removeObject(first))
        self.document.openTransaction("Label")
        part.Label = "Other"
        self.document.abortTransaction()
        self.assertIsNotNone(self.document.getObject(mesh))
        self.document.undo()
        self.assertIs(self.document.getObject(first).Mesh, self.document.getObject(mesh))
        self.check_is_fresh(analysis, live)

    def step(self, name, work):
        self.document.openTransaction(name)
        work()
        self.document.commitTransaction()


if __name__ == "__main__":
    unittest.main()

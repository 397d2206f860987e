# SPDX-License-Identifier: GPL-3.0-or-later
"""What does not fit the part is not solved, by none of FreeCAD's ways, and a result says when it is from before the last edit."""
import importlib
import os
import shutil
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor
from types import SimpleNamespace
from unittest import mock

import FreeCAD
import ObjectsFem
from femtools import ccxtools
from freecad.featuremesh import api, mesh_properties, references, results, solve_guard, versions
from freecad.featuremesh.errors import UserError
from freecad.featuremesh.study import base as study_base
from freecad.featuremesh.study import case_run
from freecad.featuremesh.study.design import Study
from freecad.featuremesh.study.response_words import parse_response
from parts import new_document
from test_document_solving import FORCE, STEEL, analysis_of, face_at


class SolveGuard(unittest.TestCase):

    def setUp(self):
        self.document = new_document()
        self.document.UndoMode = 1
        self.part = self.document.addObject("Part::Box", "Beam")
        self.part.Length, self.part.Width, self.part.Height = 40, 10, 10
        self.document.recompute()
        self.analysis = analysis_of(self.document, self.part, [("Steel", STEEL, [])])
        self.mesh = api.add_mesh(self.part, 5)
        self.document.recompute()
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)

    def solver(self):
        return self.document.getObject("Solver")

    def problem(self):
        """What FreeCAD's panel of CalculiX asks before it writes the input, and shows."""
        tools = ccxtools.FemToolsCcx(self.analysis, self.solver(), test_mode=True)
        tools.setup_working_dir(self.folder)
        tools.update_objects()
        return tools.check_prerequisites()

    def edit(self, length):
        self.document.openTransaction("Edit")
        self.part.Length = length
        self.document.recompute()
        self.document.commitTransaction()

    def add_result(self):
        """As FreeCAD's reader of CalculiX results does."""
        result = ObjectsFem.makeResultMechanical(self.document, "CCX_Results")
        self.analysis.addObject(result)
        return result

    def test_an_up_to_date_mesh_may_be_solved(self):
        self.assertEqual((solve_guard.reason(self.analysis), self.problem()), ("", ""))

    def test_a_study_solves_nothing_with_a_load_that_has_lost_its_face(self):
        """Neither in a case nor where the document has lost it before."""
        self.document = new_document()
        part = self.document.addObject("Part::Cut", "Drilled")
        part.Base, part.Tool = self.document.addObject("Part::Box", "Block"), self.document.addObject("Part::Cylinder", "Drill")
        part.Tool.Placement.Base = FreeCAD.Vector(5, 5, 0)
        self.document.recompute()
        self.analysis = analysis_of(self.document, part, [("Steel", STEEL, [])])
        load = ObjectsFem.makeConstraintPressure(self.document, "Load")
        load.References = [(part, name) for name in ("Face%d" % n for n in range(1, 8)) if part.Shape.getElement(name).Surface.TypeId == "Part::GeomCylinder"]
        self.analysis.addObject(load)
        api.add_mesh(part, 5, order=1)
        self.document.recompute()
        asked = Study(os.path.join(self.folder, "part.FCStd"), [], [parse_response("max_mises")], solver="ccx").to_plain()
        self.document.saveAs(asked["document"])
        base = os.path.join(self.folder, "base.FCStd")
        study_base.make(asked, base)
        found = case_run.run(case_run.Base(base, asked, "ccx"), {"id": 1, "parameters": {}, "set": ["Drill.Placement.Base.x=100"], "folder": self.folder})
        self.assertEqual(found["state"], "failed", found)
        self.assertIn("Load refers to Face7, which is gone", str(found["message"]))
        self.document.Drill.Placement.Base.x = 100
        self.document.recompute()
        self.document.save()
        with self.assertRaisesRegex(UserError, "Load refers to Face7, which is gone"):
            study_base.make(asked, base)

    def test_an_old_mesh_is_solved_by_no_way(self):
        self.mesh.Automatic = False
        self.edit(50)
        self.refuses("out of date")
        api.update_mesh(self.mesh)
        self.assertEqual(self.problem(), "")

    def test_a_failed_mesh_is_solved_by_no_way(self):
        """Nor one whose part FreeCAD cannot recompute: shape and mesh are still those from before the edit."""
        for obj, name, good, why in ((self.mesh, "Size", 5, "the size has to be greater than 0"), (self.part, "Length", 40, "FreeCAD cannot recompute Beam: ")):
            setattr(obj, name, 0)
            self.document.recompute()
            self.refuses("last update failed: " + why)
            setattr(obj, name, good)
            self.document.recompute()
            self.assertEqual(self.problem(), "")

    def test_a_part_that_fails_again_after_that_was_cancelled(self):
        for _ in range(2):
            self.document.openTransaction("Edit")
            self.part.Length = 0
            self.document.recompute()
            self.assertRegex(self.mesh.Status, "^failed: FreeCAD cannot recompute Beam")
            self.document.abortTransaction()
            self.assertEqual(self.mesh.Status, mesh_properties.UP_TO_DATE)

    def reopen(self):
        path = self.folder + "/reopened.FCStd"
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        self.analysis, self.mesh = self.document.Analysis, self.document.FeatureMesh

    def test_an_edit_that_was_not_recomputed_is_solved_by_no_way(self):
        """FreeCAD's "Skip recomputes" leaves shape and mesh as they were, also in a document that is saved so."""
        self.document.RecomputesFrozen = True
        self.edit(50)
        self.refuses("Beam was edited and not recomputed")
        self.reopen()
        self.refuses("Beam was edited and not recomputed")
        self.document.recompute()
        self.assertEqual((self.problem(), self.document.FeatureMesh.FemMesh.BoundBox.XMax), ("", 50))

    def test_a_part_that_is_recomputed_alone(self):
        """As by *Recompute object* in the tree: FreeCAD tells the mesh nothing, or has it wait for the next recompute."""
        for length, recompute in ((50, self.part.recompute), (60, lambda: self.document.recompute([self.part]))):
            self.part.Length = length
            recompute()
            self.refuses("edited and not recomputed|is out of date")
            self.document.recompute()
            self.assertEqual((self.problem(), self.mesh.FemMesh.BoundBox.XMax), ("", length))
        sheet = self.document.addObject("Spreadsheet::Sheet", "Sheet")
        sheet.set("A1", "=60 mm")
        self.part.setExpression("Length", "Sheet.A1")
        self.document.recompute()
        sheet.set("A1", "=70 mm")
        sheet.recompute()
        self.refuses("Sheet was edited and not recomputed")

    def test_a_part_that_was_recomputed_alone_before_it_was_saved(self):
        self.part.Length = 50
        self.document.recompute([self.part])
        self.reopen()
        self.refuses("is out of date")
        self.document.recompute()
        self.assertEqual((self.problem(), self.mesh.FemMesh.BoundBox.XMax), ("", 50))

    def test_what_a_panel_left_touched_is_recomputed_in_the_window(self):
        """By no thread of a solver, and not where FreeCAD skips recomputes."""
        def in_a_thread():
            with ThreadPoolExecutor() as pool:
                return pool.submit(self.problem).result()

        with mock.patch.object(solve_guard, "tell", print):
            for length in (40, 50):
                self.part.Length = length
                self.part.touch()
                self.assertIn("Beam was edited and not recomputed", in_a_thread())
                self.assertEqual((self.problem(), self.mesh.FemMesh.BoundBox.XMax), ("", length))
            self.document.RecomputesFrozen = True
            self.part.touch()
            self.assertIn("Beam was edited and not recomputed", self.problem())

    def test_a_mesh_whose_part_was_deleted(self):
        self.document.removeObject(self.part.Name)
        for asked in (self.problem(), solve_guard.reason(self.analysis)):
            self.assertRegex(asked, "^FeatureMesh has no part to mesh")

    def test_what_is_too_small_for_elements(self):
        """A load on it is refused; a support has the nodes in its place."""
        step = self.document.addObject("Part::Box", "Step")
        step.Length, step.Width, step.Height, step.Placement.Base.z = 20, 10, 0.003, 10
        stepped = self.document.addObject("Part::Fuse", "Stepped")
        stepped.Base, stepped.Tool = self.part, step
        self.document.recompute()
        low, = ["Face%d" % (n + 1) for n, face in enumerate(stepped.Shape.Faces) if abs(face.CenterOfMass.x - 20) < 0.1 and face.Area < 0.1]
        self.document.removeObject(self.mesh.Name)
        fixed, force = self.document.Fixed, self.document.Force
        ends = {x: [(stepped, face_at(stepped, x))] for x in (0, 40)}
        fixed.References, force.References, force.Direction = ends[0], [(stepped, low)], (stepped, ["Edge1"])
        mesh = api.add_mesh(stepped, 5, order=1)
        self.document.recompute()
        refusal = "Force acts on %s, where the mesh has no elements" % low
        self.refuses(refusal)
        with self.assertRaisesRegex(UserError, refusal):
            api.solve_live(api.live_result(self.analysis))
        fixed.References, force.References = [(stepped, low)], ends[40]
        self.document.recompute()
        self.assertEqual(self.problem(), "")
        groups = {mesh.FemMesh.getGroupName(group): mesh.FemMesh.getGroupElements(group) for group in mesh.FemMesh.Groups}
        held = [mesh.FemMesh.Nodes[node] for node in groups["Fixed_Nodes"]]
        self.assertGreater(len(held), 2)
        self.assertTrue(all(abs(place.x - 20) < 1e-6 and abs(place.z - 10) < 0.005 for place in held), held)

    def test_a_mesh_that_a_script_gives_another_part(self):
        other = self.document.addObject("Part::Box", "Other")
        self.document.recompute()
        for part, length in ((other, 10), (self.part, 40)):
            setattr(self.mesh, versions.part_property(self.mesh), part)
            self.assertIn("is out of date", solve_guard.reason(self.analysis))
            self.document.recompute()
            self.assertEqual((self.mesh.Status, self.mesh.FemMesh.BoundBox.XMax), (mesh_properties.UP_TO_DATE, length))

    def test_a_cell_that_drives_the_part(self):
        sheet = self.document.addObject("Spreadsheet::Sheet", "Sheet")
        sheet.set("A1", "=40 mm")
        self.part.setExpression("Length", "Sheet.A1")
        self.document.recompute()
        self.assertEqual(self.problem(), "")
        self.document.RecomputesFrozen = True
        sheet.set("A1", "=50 mm")
        self.document.recompute()
        self.refuses("Sheet was edited and not recomputed")
        self.document.RecomputesFrozen = False
        self.document.recompute()
        self.assertEqual((self.problem(), self.mesh.FemMesh.BoundBox.XMax), ("", 50))

    def edit_frozen(self, length):
        """As FreeCAD leaves a frozen box whose length a script sets: with another shape, and nothing to recompute. Only its window can freeze."""
        self.part.Length = length
        self.document.purgeTouched()

    def test_a_frozen_part_that_a_script_edits(self):
        with mock.patch.object(versions, "is_frozen", lambda obj: obj is self.part):
            self.document.recompute()
            self.assertEqual((self.problem(), self.mesh.Status), ("", "up to date"))
            result = self.add_result()
            self.edit_frozen(50)
            self.refuses("is out of date")
            self.document.recompute()
            self.assertEqual((self.problem(), self.mesh.FemMesh.BoundBox.XMax), ("", 50))
            self.assertTrue(results.is_old(result))
            self.mesh.Automatic = False
            self.edit_frozen(60)
            self.document.recompute()
            self.assertEqual((self.mesh.Status, self.mesh.FemMesh.BoundBox.XMax), (mesh_properties.OUT_OF_DATE, 50))

    def test_a_frozen_mesh_does_not_follow_an_edit_and_is_not_solved(self):
        with mock.patch.object(versions, "is_frozen", lambda obj: obj is self.mesh):
            self.document.recompute()
            before = self.mesh.FemMesh.BoundBox.XMax
            result = self.add_result()
            self.assertEqual(self.problem(), "")
            self.edit_frozen(50)
            self.document.recompute()
            self.refuses("is out of date")
            self.assertEqual((self.mesh.Status, self.mesh.FemMesh.BoundBox.XMax), (mesh_properties.OUT_OF_DATE, before))
            self.assertTrue(results.is_old(result))

    def test_a_frozen_part_that_is_saved_after_a_script_edited_it(self):
        """FreeCAD does not save what is frozen."""
        with mock.patch.object(versions, "is_frozen", lambda obj: obj is self.part):
            self.edit_frozen(50)
            path = self.folder + "/frozen.FCStd"
            self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        self.analysis, self.mesh = self.document.Analysis, self.document.FeatureMesh
        self.refuses("is out of date")

    def test_what_a_recompute_leaves_touched_is_no_edit(self):
        """Until somebody edits it."""
        drives, touches = (self.document.addObject("App::FeaturePython", name) for name in ("Drives", "Touches"))
        drives.addProperty("App::PropertyLength", "Length")
        drives.Length = 40
        self.part.setExpression("Length", "Drives.Length")
        touches.addProperty("App::PropertyLink", "After")
        touches.After, touches.Proxy = self.part, SimpleNamespace(execute=lambda _: drives.touch())
        self.refuses("was edited and not recomputed")
        for length in (50, 60):
            self.document.recompute()
            self.assertIn("Touched", drives.State)
            self.assertEqual(self.problem(), "")
            drives.Length = length
            self.refuses("Drives was edited and not recomputed")
        self.document.recompute([self.document.addObject("Part::Box", "Other")])
        self.refuses("Drives was edited and not recomputed")
        self.document.recompute()
        self.assertEqual(self.problem(), "")

    def test_an_assembly_whose_joints_refer_to_it(self):
        """Since 1.1 such joints stay touched for ever."""
        if versions.version() < (1, 1):
            self.skipTest("this FreeCAD has no such joints")
        import JointObject
        assembly = self.document.addObject("Assembly::AssemblyObject", "Assembly")
        joints, parts = assembly.newObject("Assembly::JointGroup", "Joints"), [assembly.newObject("Part::Box", "Box") for _ in range(2)]
        self.document.recompute()
        JointObject.GroundedJoint(joints.newObject("App::FeaturePython", "Ground"), parts[0])
        joint = joints.newObject("App::FeaturePython", "Joint")
        JointObject.Joint(joint, 0)
        joint.Proxy.setJointConnectors(joint, [[assembly, [part.Name + "." + face] * 2] for part, face in zip(parts, ("Face2", "Face1"))])
        self.analysis = self.analysis_of_container(assembly)
        self.assertIn("Touched", joint.State)
        self.assertEqual(solve_guard.reason(self.analysis), "")
        joint.Label2 = "edited"
        self.assertIn("Joint was edited and not recomputed", solve_guard.reason(self.analysis))

    def test_what_is_beside_the_parts_of_a_container_does_not_matter(self):
        container = self.document.addObject("App::Part", "Machine")
        box, note = container.newObject("Part::Box", "Box"), container.newObject("App::TextDocument", "Note")
        analysis = self.analysis_of_container(container)
        note.Text = "to be made of steel"
        self.assertIn("Touched", note.State)
        self.assertEqual(solve_guard.reason(analysis), "")
        box.Length = 20
        self.assertIn("Box was edited and not recomputed", solve_guard.reason(analysis))

    def analysis_of_container(self, container):
        self.document.recompute()
        analysis, mesh = ObjectsFem.makeAnalysis(self.document, "Other"), api.add_mesh(container, 5, join_analysis=False)
        analysis.addObject(mesh)
        self.document.recompute()
        return analysis

    def test_what_an_undo_brought_back_is_solved(self):
        """With its shape and its mesh, though FreeCAD wants to recompute it."""
        self.edit(50)
        self.document.undo()
        self.assertIn("Touched", self.part.State)
        self.assertEqual((self.problem(), self.mesh.FemMesh.BoundBox.XMax), ("", 40))

    def test_what_another_freecad_saved_is_solved(self):
        """This one may want to recompute every object of it; once it did, an edit is one."""
        path = self.folder + "/other.FCStd"
        self.part.touch()
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        self.assertIn("Touched", self.document.Beam.State)
        self.analysis = self.document.Analysis
        with mock.patch.object(versions, "version", return_value=(99, 9)):
            self.assertEqual(solve_guard.reason(self.analysis), "")
            self.document.recompute()
            self.document.Beam.Length = 50
            self.assertIn("Beam was edited and not recomputed", solve_guard.reason(self.analysis))

    def test_settings_that_are_not_meshed_yet(self):
        self.mesh.Size = 6
        self.refuses("settings changed, not meshed yet")
        self.mesh.Size = 5
        self.assertEqual(self.problem(), "")

    def test_a_load_that_lost_its_face_is_solved_by_no_way(self):
        force = self.document.getObject("Force")
        force.addProperty("App::PropertyStringList", references.MARK)
        setattr(force, references.MARK, ["Face2"])
        force.References = []
        self.refuses("Force refers to Face2, which is gone")
        force.References = [(self.part, "Face2")]
        self.assertEqual(self.problem(), "")

    def test_a_load_on_a_face_that_is_not_there(self):
        """As of an analysis that had no mesh while the part was edited; FreeCAD's panel fails there by itself, with "Index out of bound"."""
        self.document.getObject("Force").References = [(self.part, "Face9")]
        with self.assertRaisesRegex(UserError, "Force refers to Face9, which is gone"):
            api.solve_analysis(self.analysis)

    def refuses(self, pattern):
        """CalculiX's panel, the command that runs a solver, the newer solvers' tools, our own functions; an old result stays."""
        result = self.document.getObject("CCX_Results") or self.add_result()
        self.assertRegex(self.problem(), pattern)
        from femsolver.run import run_fem_solver   # as the command does
        run_fem_solver(self.solver())
        self.assertIn(result, self.analysis.Group)
        for solve in (api.solve, api.solve_analysis):
            with self.assertRaisesRegex(UserError, pattern):
                solve(self.analysis)
        for module, name, make in (("femsolver.calculix.calculixtools", "CalculiXTools", "makeSolverCalculiX"),
                                   ("femsolver.elmer.elmertools", "ElmerTools", "makeSolverElmer")):
            if versions.version() < (1, 1):
                continue
            solver = getattr(ObjectsFem, make)(self.document, name)
            self.analysis.addObject(solver)
            with self.assertRaisesRegex(UserError, pattern):
                getattr(importlib.import_module(module), name)(solver).prepare()
            self.document.removeObject(solver.Name)

    def test_what_input_lacks_is_said_whoever_writes_it(self):
        """FreeCAD's panel and commands say nothing of it; our own commands have it in their reports."""
        self.analysis.addObject(self.document.addObject("Fem::ConstraintBearing", "Bearing"))
        told = []
        with mock.patch.object(FreeCAD, "Console", mock.Mock(wraps=FreeCAD.Console, PrintWarning=told.append)):
            self.assertEqual(self.problem(), "")
            tools = ccxtools.FemToolsCcx(self.analysis, self.solver(), test_mode=True)
            tools.setup_working_dir(self.folder)
            tools.update_objects()
            tools.write_inp_file()
            if versions.version() >= (1, 1):
                newer = ObjectsFem.makeSolverCalculiX(self.document)
                self.analysis.addObject(newer)
                newer.WorkingDirectory = self.folder
                importlib.import_module("femsolver.calculix.calculixtools").CalculiXTools(newer).prepare()
                self.document.removeObject(newer.Name)
            said = [text for text in told if "Bearing" in text]
            self.assertEqual(len(said), 1 + (versions.version() >= (1, 1)), told)
            self.assertRegex(said[-1], "^Analysis: CalculiX got nothing of Bearing, which FreeCAD does not write for the type of analysis static")
            if shutil.which("ccx"):
                api.solve_analysis(self.analysis, "ccx")
                self.assertEqual([text for text in told if "Bearing" in text], said)

    def test_other_solvers_of_the_task_chain_ask_too(self):
        make = getattr(ObjectsFem, "makeSolverZ88", None)
        solver = make(self.document, "Other")
        self.analysis.addObject(solver)
        if not hasattr(solver.Proxy, "createMachine"):
            self.skipTest("this FreeCAD has no solver of that kind")
        self.mesh.Size = 6
        from femsolver.report import Report
        check = solver.Proxy.createMachine(solver, self.folder, True).check
        check.solver, check.report = solver, Report()
        self.assertFalse(check.check_mesh_exists())
        self.assertIn("settings changed", " ".join(str(entry) for entry in check.report.errors))

    def test_results_say_when_they_are_from_before_the_last_edit(self):
        result = self.add_result()
        label = result.Label
        self.assertFalse(results.is_old(result))
        self.document.recompute()
        self.assertEqual(result.Label, label)
        self.edit(50)
        self.assertEqual(result.Label, label + " (before the last edit)")
        newer = self.add_result()
        self.assertEqual([results.is_old(one) for one in (result, newer)], [True, False])
        self.edit(60)
        self.assertEqual([results.is_old(one) for one in (result, newer)], [True, True])
        self.document.undo()
        self.assertEqual([results.is_old(one) for one in (result, newer)], [True, False])
        self.document.undo()
        self.assertEqual([results.is_old(one) for one in (result, newer)], [False, True])

    def test_a_copied_result_is_marked_once(self):
        result = self.add_result()
        label = result.Label
        self.edit(50)
        result.Label += "001"   # as FreeCAD names a copy
        self.edit(60)
        self.assertEqual(result.Label, label + "001 (before the last edit)")

    def test_a_mark_in_another_language(self):
        """A document goes from one user to another."""
        result = self.add_result()
        label = result.Label
        with mock.patch.object(results, "translate", side_effect=lambda _, text: " (vor der letzten Änderung)"):
            self.edit(50)
        self.assertEqual((result.Label, results.is_old(result)), (label + " (vor der letzten Änderung)", True))
        self.edit(60)
        self.assertEqual(result.Label, label + " (before the last edit)")

    def test_results_are_not_marked_where_nodes_and_elements_stay(self):
        result = self.add_result()
        self.document.openTransaction("Group")
        group = ObjectsFem.makeMeshGroup(self.document, self.mesh)
        group.References = [(self.part, "Face3")]
        self.document.recompute()
        self.document.commitTransaction()
        self.assertFalse(results.is_old(result))
        self.mesh.touch()
        self.document.recompute()
        self.assertFalse(results.is_old(result))
        self.edit(50)
        self.assertTrue(results.is_old(result))
        self.document.undo()
        self.assertFalse(results.is_old(result))
        self.document.undo()
        self.assertFalse(results.is_old(result))

    def test_results_say_when_a_load_a_material_or_a_support_was_changed_since(self):
        result = self.add_result()
        force, material = self.document.getObject("Force"), self.document.getObject("Steel")
        steel, references = material.Material, force.References
        changes = ((force, "Force", force.Force, force.Force * 2), (force, "Reversed", force.Reversed, not force.Reversed),
                   (force, "References", references, [(self.part, "Face3")]), (material, "Material", steel, dict(steel, YoungsModulus="100 GPa")))
        for obj, name, before, after in changes:
            with self.subTest(changed=obj.Name, property=name):
                setattr(obj, name, after)
                self.assertTrue(results.is_old(result))
                self.document.recompute()
                self.assertTrue(results.is_old(result))
                setattr(obj, name, before)
                self.document.recompute()
                self.assertFalse(results.is_old(result))
        self.document.openTransaction("Edit")
        force.Force = force.Force * 2
        self.document.commitTransaction()
        self.assertTrue(results.is_old(result))
        self.document.undo()
        self.assertFalse(results.is_old(result))
        force.Label, force.Visibility = "Weight of the crane", not force.Visibility
        self.assertFalse(results.is_old(result))

    def test_what_the_panel_of_a_transform_lists_is_no_edit(self):
        transform = ObjectsFem.makeConstraintTransform(self.document)
        transform.References = [(self.part, "Face1")]
        self.analysis.addObject(transform)
        self.document.recompute()
        result = self.add_result()
        transform.RefDispl = [(self.part, "Face2")]   # as its OK does
        self.assertFalse(results.is_old(result))

    def test_results_say_when_a_load_came_went_or_follows_another_value(self):
        result, force = self.add_result(), self.document.getObject("Force")
        pressure = ObjectsFem.makeConstraintPressure(self.document)
        self.analysis.addObject(pressure)
        self.assertTrue(results.is_old(result))
        self.document.removeObject(pressure.Name)
        self.assertFalse(results.is_old(result))
        sheet = self.document.addObject("Spreadsheet::Sheet", "Values")
        unit = "" if isinstance(force.Force, float) else " N"
        sheet.set("A1", "=%g%s" % (FORCE, unit))
        force.setExpression("Force", "Values.A1")
        self.document.recompute()
        self.assertFalse(results.is_old(result))
        sheet.set("A1", "=7" + unit)
        self.document.recompute()
        self.assertTrue(results.is_old(result))

    def test_a_result_of_an_older_version_knows_the_mesh_alone(self):
        result = self.add_result()
        setattr(result, results.SOLVED_ON, self.mesh.Proxy.state_of_mesh(self.mesh))
        self.document.getObject("Force").Force = self.document.getObject("Force").Force * 2
        self.assertFalse(results.is_old(result))
        self.edit(50)
        self.assertTrue(results.is_old(result))

    def test_a_result_that_arrives_while_the_mesh_is_not_that_of_its_part_is_old(self):
        """As when a solver that asks nobody was started, or a file of results is opened by hand."""
        self.mesh.Automatic = False
        self.edit(50)
        late = self.add_result()
        self.assertTrue(results.is_old(late))
        self.mesh.Automatic = True
        self.edit(60)
        self.assertTrue(results.is_old(late))
        self.mesh.Size = 0
        self.document.recompute()
        self.assertTrue(self.mesh.Status.startswith("failed"), self.mesh.Status)
        failed = self.add_result()
        self.assertTrue(results.is_old(failed))
        self.mesh.Size = 5
        self.document.recompute()
        self.assertEqual([results.is_old(one) for one in (late, failed, self.add_result())], [True, False, False])

    def test_a_refused_solution_writes_no_input(self):
        self.assertEqual(self.problem(), "")   # writes the input of the mesh as it is
        self.mesh.Automatic = False
        self.edit(50)
        self.refuses("out of date")
        self.document.undo()
        self.assertFalse(results.is_old(self.add_result()))
        self.document.redo()
        self.assertEqual([results.is_old(one) for one in self.analysis.Group if results.is_result(one)], [True, True])

    def test_an_old_result_is_told_after_saving(self):
        result = self.add_result()
        path = self.folder + "/solved.FCStd"
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        document = FreeCAD.openDocument(path)
        result = document.getObject("CCX_Results")
        self.assertFalse(results.is_old(result))
        document.getObject("FeatureMesh").Automatic = False
        document.getObject("Beam").Length = 50
        document.recompute()
        self.assertTrue(results.is_old(result))
        FreeCAD.closeDocument(document.Name)

    def test_a_result_belongs_to_the_mesh_that_its_input_was_written_from(self):
        self.assertEqual(self.problem(), "")   # the panel asks this and writes the input
        self.edit(50)
        self.assertTrue(results.is_old(self.add_result()))
        self.assertEqual(self.problem(), "")
        self.assertFalse(results.is_old(self.add_result()))

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_solved_anew_the_result_is_no_longer_old(self):
        first = api.solve(self.analysis).result
        self.assertFalse(results.is_old(first))
        self.edit(50)
        self.assertTrue(results.is_old(first))
        self.assertFalse(results.is_old(api.solve(self.analysis).result))


if __name__ == "__main__":
    unittest.main()

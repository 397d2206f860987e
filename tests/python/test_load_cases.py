# SPDX-License-Identifier: GPL-3.0-or-later
"""One mesh in several analyses, and copies of analyses with and without their mesh."""
import shutil
import unittest
import zipfile

import ObjectsFem
from analyses import add_material, add_solver, quantity, solve
from freecad.featuremesh import analyses, api, engine, live_result, mesh_object, results, solve_guard, statics
from freecad.featuremesh.errors import UserError
from meshed_plate import MeshedPlate, points_of
from parts import groups_in_freecad, rectangle
from statics_cases import HAS_SOLVER
from test_hand_over import contents

STEEL = {"Name": "Steel", "YoungsModulus": "210000 MPa", "PoissonRatio": "0.3", "Density": "7900 kg/m^3"}


def face_across(body, axis, place):
    """Name of the face that lies across an axis 0, 1 or 2 at that place."""
    for number, face in enumerate(body.Shape.Faces, 1):
        box = face.BoundBox
        low, high = (box.XMin, box.YMin, box.ZMin)[axis], (box.XMax, box.YMax, box.ZMax)[axis]
        if abs(low - place) < 1e-6 and abs(high - place) < 1e-6:
            return "Face%d" % number
    raise AssertionError("no such face")


class LoadCases(MeshedPlate):

    def setUp(self):
        super().setUp()
        self.analysis = self.document.addObject("Fem::FemAnalysis", "Pull")
        self.analysis.addObject(self.mesh)
        add_solver(self.document, self.analysis)
        add_material(self.document, self.analysis, "Steel", STEEL)
        self.fixed = ObjectsFem.makeConstraintFixed(self.document, "Fixed")
        self.fixed.References = [(self.body, face_across(self.body, 0, 0))]
        self.force = ObjectsFem.makeConstraintForce(self.document, "Force")
        self.force.References = [(self.body, face_across(self.body, 0, 60))]
        self.force.Force = quantity(1000, "N")
        for member in (self.fixed, self.force):
            self.analysis.addObject(member)
        self.document.recompute()

    def twin(self, **more):
        """A copy of the analysis with twice the force."""
        copy = api.copy_analysis(self.analysis, "Push", **more)
        force, = [member for member in copy.Group if member.isDerivedFrom("Fem::ConstraintForce")]
        force.Force = quantity(2000, "N")
        self.document.recompute()
        return copy

    def test_an_analysis_is_found_by_its_name_though_another_one_has_that_label(self):
        copy = self.twin()
        copy.Label, self.analysis.Label = self.analysis.Name, "First"
        self.assertIs(api.find_analysis(self.document, self.analysis.Name), self.analysis)
        self.assertIs(api.find_analysis(self.document, "First"), self.analysis)

    @unittest.skipUnless(HAS_SOLVER, "PETSc is not installed")
    def test_each_analysis_has_a_live_result_of_its_own(self):
        copy = self.twin()
        first, second = (api.live_result(one) for one in (self.analysis, copy))
        self.assertIsNot(first, second)

        def check(times):
            for live in (first, second):
                self.assertEqual(live.Status, live_result.UP_TO_DATE)
                self.assertEqual(len(live.Result.NodeNumbers), self.mesh.FemMesh.NodeCount)
            self.assertAlmostEqual(second.MaxMises / first.MaxMises, times, delta=1e-6)
        check(2)
        self.edit(25)
        check(2)
        before = second.Report
        self.force.Force = quantity(4000, "N")
        self.assertEqual((first.Status, second.Status), (live_result.OUT_OF_DATE, live_result.UP_TO_DATE))
        self.document.recompute()
        check(0.5)
        self.assertEqual(second.Report, before)   # nothing of it changed, it was not solved
        self.assertEqual([results.is_old(live.Result) for live in (first, second)], [False, False])

    def test_what_joins_an_analysis_leaves_no_mark_on_it(self):
        """FreeCAD's window shows it until a recompute, which makes nothing of an analysis."""
        other = ObjectsFem.makeAnalysis(self.document, "Other")
        self.document.recompute()
        for join in (lambda: api.update_mesh(api.add_mesh(self.body, 20, order=1, active_analysis=other)), lambda: api.live_result(self.analysis),
                     lambda: api.share_mesh(self.mesh, ObjectsFem.makeAnalysis(self.document, "Third"))):
            self.document.recompute()
            join()
            self.assertNotIn("Touched", other.State + self.analysis.State)
        other.touch()
        analyses.take_in(other, ObjectsFem.makeConstraintFixed(self.document, "More"))
        self.assertIn("Touched", other.State)

    def test_a_copy_shares_the_mesh_and_has_groups_of_its_own(self):
        copy = self.twin()
        self.assertIn(self.mesh, self.analysis.Group)
        shared, = analyses.meshes_of(copy)
        self.assertIs(shared.Mesh, self.mesh)
        self.assertEqual(points_of(shared), points_of(self.mesh))
        self.assertEqual(shared.FemMesh.Volumes, self.mesh.FemMesh.Volumes)
        force = next(member for member in copy.Group if member.isDerivedFrom("Fem::ConstraintForce"))
        self.assertIn("Force_Nodes", groups_in_freecad(self.mesh))
        self.assertNotIn("Force_Nodes", groups_in_freecad(shared))
        self.assertIn(force.Name + "_Nodes", groups_in_freecad(shared))
        self.assertNotIn(force.Name + "_Nodes", groups_in_freecad(self.mesh))

    def test_what_was_pasted_into_the_analysis_is_not_copied(self):
        """FreeCAD pastes parts, and since 1.1 another analysis, into the analysis that is selected."""
        inner = ObjectsFem.makeAnalysis(self.document, "Inner")
        inner.addObject(ObjectsFem.makeConstraintFixed(self.document, "Held"))
        for pasted in (inner, self.document.addObject("Part::Box", "Pasted")):
            self.analysis.addObject(pasted)
        found = [member.Name for member in self.twin().Group]
        self.assertEqual([name for name in found if name.startswith(("Inner", "Pasted"))], [])
        self.assertEqual(self.document.Held.InList, [inner])

    def test_the_shared_mesh_follows_an_edit_and_its_loads_keep_their_faces(self):
        copy = self.twin()
        shared, = analyses.meshes_of(copy)
        before = points_of(shared)
        self.edit(24)
        self.assertEqual(points_of(shared), points_of(self.mesh))
        self.assertNotEqual(points_of(shared), before)
        for member in copy.Group:
            if member.isDerivedFrom("Fem::ConstraintForce"):
                self.assertEqual([sub for _, subs in member.References for sub in subs], [face_across(self.body, 0, 60)])
        self.assertEqual(solve_guard.reason(copy), "")
        self.mesh.Automatic = False
        self.edit(26)
        self.assertIn("out of date", solve_guard.reason(copy))

    def test_undo_brings_the_mesh_back_in_all_analyses(self):
        copy = self.twin()
        shared, = analyses.meshes_of(copy)
        before = points_of(shared)
        self.document.UndoMode = 1
        self.document.openTransaction("Edit")
        self.edit(24)
        self.document.commitTransaction()
        self.assertNotEqual(points_of(shared), before)
        self.document.undo()
        self.assertEqual(points_of(shared), before)
        self.assertEqual(points_of(self.mesh), before)

    def test_it_survives_saving(self):
        self.twin()
        self.edit(24)   # numbers with gaps
        before = points_of(self.mesh)
        self.save_and_reopen()
        shared, = analyses.meshes_of(self.document.Push)
        self.assertEqual(points_of(shared), before)
        self.edit(22)
        self.assertEqual(points_of(shared), points_of(self.mesh))
        self.assertGreater(self.mesh.KeptNodes, 30)
        api.renumber_mesh(self.mesh)
        self.assertEqual(points_of(shared), points_of(self.mesh))

    def test_it_survives_saving_without_freecads_form(self):
        """Nodes, elements, numbers and groups of both are as they were, and an edit goes on from there."""
        copy = self.twin()
        self.mesh.AllGroups = True
        self.edit(24)   # which leaves gaps between numbers
        self.mesh.SavedForFreeCAD = "Never"
        self.assertNotIn("Touched", self.mesh.State)
        names = [self.mesh.Name, analyses.meshes_of(copy)[0].Name]
        before = [contents(self.document.getObject(name).FemMesh) for name in names]
        self.save_and_reopen()
        with zipfile.ZipFile(self.document.FileName) as saved:
            self.assertEqual([name for name in saved.namelist() if name.endswith(".unv")], [])
        self.assertEqual([contents(self.document.getObject(name).FemMesh) for name in names], before)
        self.assertIn("Feature_Plate", before[0][2])
        self.assertEqual([obj.Name for obj in self.document.Objects if "Touched" in obj.State], [])
        self.edit(22)
        self.assertGreater(self.mesh.KeptNodes, 30)
        self.mesh.SavedForFreeCAD = "Always"
        self.save_and_reopen()
        with zipfile.ZipFile(self.document.FileName) as saved:
            self.assertEqual(len([name for name in saved.namelist() if name.endswith(".unv")]), 2)

    def test_other_copies(self):
        bare = api.copy_analysis(self.analysis, "Bare", mesh="none")
        self.assertEqual(analyses.meshes_of(bare), [])
        self.assertIn("has no mesh", solve_guard.reason(bare))
        shared = api.share_mesh(self.mesh, bare)
        self.assertEqual(solve_guard.reason(bare), "")
        if "Suppressed" not in shared.PropertiesList:   # before FreeCAD 1.1
            shared.addProperty("App::PropertyBool", "Suppressed")
        shared.Suppressed = True
        self.assertIn("is suppressed, and Bare has no other mesh", solve_guard.reason(bare))
        shared.Suppressed = False
        with self.assertRaisesRegex(UserError, "already"):
            api.share_mesh(self.mesh, bare)
        own = api.copy_analysis(self.analysis, "Own", mesh="own")
        mesh, = analyses.meshes_of(own)
        self.assertTrue(mesh_object.is_feature_mesh(mesh))
        self.assertIsNot(mesh, self.mesh)
        with self.assertRaisesRegex(UserError, "one of shared, own, none"):
            api.copy_analysis(self.analysis, mesh="some")
        self.document.removeObject(own.Name)
        self.document.removeObject(self.mesh.Name)
        self.assertIn("was deleted", shared.Proxy.why_not_to_solve(shared))

    def test_what_calculix_printed_is_not_copied(self):
        self.analysis.addObject(self.document.addObject("App::TextDocument", "ccx_dat_file"))
        self.assertEqual([member.Name for member in self.twin(mesh="none").Group if member.isDerivedFrom("App::TextDocument")], [])

    def test_a_copy_that_cannot_be_made_leaves_nothing(self):
        before = self.document.Objects
        with open(self.mesh.SavedState, "r+b") as stream:
            stream.seek(200)
            stream.write(b"damage")
        self.mesh.Proxy.loads(None)   # nothing is in memory
        with self.assertRaisesRegex(UserError, "is damaged"):
            api.copy_analysis(self.analysis, "Push")
        self.assertEqual(self.document.Objects, before)

    def test_loads_without_a_mesh_stay_where_they_are(self):
        """It is dragged from one analysis to another in the tree; meanwhile the faces get other numbers."""
        bare = api.copy_analysis(self.analysis, "Bare", mesh="none")
        late = ObjectsFem.makeConstraintPressure(self.document, "Late")
        late.References = [(self.body, face_across(self.body, 0, 60))]
        bare.addObject(late)
        early = ObjectsFem.makeConstraintPressure(self.document, "Early")
        early.References = [(self.document.Plate, "Face6")]   # for a mesh of that one, perhaps
        bare.addObject(early)
        loads = [member for member in [*self.analysis.Group, *bare.Group] if member.isDerivedFrom("Fem::Constraint")]

        def ends():
            return [round(self.body.Shape.getElement(name).CenterOfMass.x, 6) for load in loads if load is not early for _, names in load.References for name in names]
        before = ends()
        self.analysis.removeObject(self.mesh)
        sketch = self.body.newObject("Sketcher::SketchObject", "GrooveSketch")
        rectangle(sketch, 40, -5, 10, 60)
        groove = self.body.newObject("PartDesign::Pocket", "Groove")
        groove.Profile, groove.Reversed, groove.Length = sketch, True, 3
        self.body.Tip = groove
        self.document.recompute()
        self.assertEqual((ends(), early.References), (before, [(self.document.Plate, ("Face6",))]))
        bare.addObject(self.mesh)
        self.edit(24)
        self.document.removeObject("Groove")
        self.body.Tip = self.document.Hole
        self.document.recompute()
        self.assertEqual(ends(), before)

    def test_loads_of_a_mesh_that_waits_go_with_another_one_of_the_part(self):
        """The mesh that is updated by hand is dragged out for the one that followed the edit, or is updated after it."""
        other = api.add_mesh(self.body, 5.0, order=1, join_analysis=False)
        self.document.recompute()
        self.mesh.Automatic = False
        for size, automatic in ((2, True), (3, True), (4, False)):
            other.Automatic = automatic
            if size == 2:
                chamfer = self.body.newObject("PartDesign::Chamfer", "Chamfer")
                chamfer.Base, self.body.Tip = (self.document.Hole, ["Edge1"]), chamfer
            self.document.Chamfer.Size = size
            self.document.recompute()
            ends = [("Body", face_across(self.body, 0, place)) for place in (0, 60)]
            self.assertEqual([(load.References[0][0].Name, *load.References[0][1]) for load in (self.fixed, self.force)], ends)
        api.update_mesh(self.mesh)
        self.assertEqual([(load.References[0][0].Name, *load.References[0][1]) for load in (self.fixed, self.force)], ends)
        nodes, groups = self.mesh.FemMesh.Nodes, groups_in_freecad(self.mesh)
        self.assertEqual({round(nodes[number].x, 6) for number in groups["Fixed_Nodes"]}, {0})

    def test_loads_of_a_mesh_that_waits_go_with_a_new_one(self):
        """The one that is updated by hand is dragged out after an edit, and the part meshed anew."""
        self.mesh.Automatic = False
        chamfer = self.body.newObject("PartDesign::Chamfer", "Chamfer")
        chamfer.Base, self.body.Tip = (self.document.Hole, ["Edge1"]), chamfer
        self.document.recompute()
        self.analysis.removeObject(self.mesh)
        new = api.add_mesh(self.body, 5.0, order=1, join_analysis=False)
        self.analysis.addObject(new)
        self.document.recompute()
        ends = [("Body", face_across(self.body, 0, place)) for place in (0, 60)]
        self.assertEqual([(load.References[0][0].Name, *load.References[0][1]) for load in (self.fixed, self.force)], ends)
        api.update_mesh(self.mesh)
        self.assertEqual([(load.References[0][0].Name, *load.References[0][1]) for load in (self.fixed, self.force)], ends)

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_both_are_solved_with_one_mesh(self):
        copy = self.twin()
        once = solve(self.analysis)["displacement"]
        twice = solve(copy)["displacement"]
        self.assertAlmostEqual(twice / once, 2, delta=1e-4)
        if not engine.load().statics_missing():
            live = statics.solve(copy)[1]["responses"]["max_displacement_mm"]
            self.assertAlmostEqual(live / twice, 1, delta=1e-3)
        self.edit(24)
        again = solve(copy)["displacement"]
        self.assertAlmostEqual(again / twice, 1, delta=0.05)
        self.assertNotEqual(again, twice)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""An analysis with several solver objects: which is taken, that it is said, and when nobody can know."""
import shutil
import tempfile
import unittest
from types import SimpleNamespace
from unittest import mock

import numpy as np
import ObjectsFem
from analyses import add_solver, quantity
from freecad.featuremesh import api, calculix, frd, live_result, mass, solvers, statics, statics_model, tasks
from freecad.featuremesh.errors import UserError
from freecad.featuremesh.messages import english
from freecad.featuremesh.study import case_solver
from statics_cases import HAS_SOLVER, STEEL, Case, edges_along, faces_at


@unittest.skipUnless(HAS_SOLVER, "PETSc is not installed")
class LoadsAndDensities(Case):
    """What loads nothing that can move, and densities that are none."""

    def setUp(self):
        super().setUp()
        self.part, self.of_the_box = self.held_box(8.0)

    def test_a_load_on_what_is_held_is_said(self):
        self.document.removeObject("Force")
        self.force(self.of_the_box, self.part, faces_at(self.part, 0, 0))
        report = statics.solve(self.of_the_box)[1]
        self.assertIn("all loads act on what the supports hold", " ".join(map(english, report["warnings"])))
        self.assertAlmostEqual(abs(report["responses"]["reactions_n"]["Fixed"][2]), 1000, delta=1e-3)

    @unittest.skipUnless(hasattr(ObjectsFem, "makePostHistogram"), "FreeCAD before 1.1")
    def test_plots_of_results_are_nothing_to_solve(self):
        plots = [make(self.document) for make in (ObjectsFem.makePostHistogram, ObjectsFem.makePostLineplot, ObjectsFem.makePostTable)]
        self.of_the_box.addObjects(plots)
        for _ in range(2):
            self.assertGreater(statics.solve(self.of_the_box)[1]["responses"]["max_displacement_mm"], 0)
            for plot in plots:
                vars(plot.Proxy).pop("Type", None)   # as in a document that was opened

    def test_a_density_without_its_unit_is_none(self):
        for density in ("7850", "", "heavy", "7850 MPa"):
            self.document.Steel.Material = dict(STEEL, Density=density)
            report = statics.solve(self.of_the_box)[1]
            self.assertGreater(report["responses"]["max_displacement_mm"], 0)
            self.assertIsNone(report["responses"]["mass_kg"])
            with self.assertRaisesRegex(UserError, "Steel has no density; give it one, with its unit$"):
                mass.of_part(self.part, self.of_the_box, statics.arrays_of(self.of_the_box))
        self.add(self.of_the_box, ObjectsFem.makeConstraintSelfWeight, "Weight", None)
        with self.assertRaisesRegex(UserError, "Weight needs the density of every material; give each of them one, with its unit$"):
            statics.solve(self.of_the_box)


@unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
class WhatCalculixGot(Case):
    """FreeCAD writes some loads for no analysis, others for some kinds, and says nothing of it."""

    def setUp(self):
        super().setUp()
        self.part, self.of_the_box = self.held_box(8.0)

    def solved(self):
        """The report, and what it warns of in one text."""
        report = api.solve_analysis(self.of_the_box)
        return report, " ".join(map(english, report["warnings"]))

    def test_loads_that_are_not_written_are_named(self):
        self.of_the_box.addObject(self.document.addObject("Fem::ConstraintBearing", "Bearing"))
        self.add(self.of_the_box, ObjectsFem.makeConstraintTemperature, "Warm", [(self.part, faces_at(self.part, 0, 0))])
        self.assertRegex(self.solved()[1], "CalculiX got nothing of Bearing, Warm, which FreeCAD does not write for the type of analysis static")

    def test_modes_have_no_reactions(self):
        self.document.Solver.AnalysisType = "frequency"
        report, warned = self.solved()
        self.assertEqual(report["responses"]["reactions_n"], {})
        self.assertRegex(warned, "got nothing of Force, which .* frequency")

    def test_every_kind_of_analysis_has_a_mass(self):
        """CalculiX prints it in statics with a weight alone."""
        solver = self.document.Solver
        for kind, nonlinearity in (("frequency", "linear"), ("static", "nonlinear"), ("thermomech", "linear")):
            with self.subTest(kind):
                solver.AnalysisType, solver.GeometricalNonlinearity = kind, nonlinearity
                if kind == "thermomech":
                    self.document.Steel.Material = dict(STEEL, ThermalConductivity="50 W/m/K", ThermalExpansionCoefficient="12 um/m/K", SpecificHeat="500 J/kg/K")
                    self.add(self.of_the_box, ObjectsFem.makeConstraintInitialTemperature, "Cold", None)
                    self.add(self.of_the_box, ObjectsFem.makeConstraintTemperature, "Warm", [(self.part, faces_at(self.part, 0, 0))])
                self.assertAlmostEqual(self.solved()[0]["responses"]["mass_kg"] or 0, 7850e-9 * 8000, places=9)
        self.document.Steel.Material = dict(STEEL, Density="")
        solver.AnalysisType = "static"
        self.assertIsNone(self.solved()[0]["responses"]["mass_kg"])


@unittest.skipUnless(HAS_SOLVER and shutil.which("ccx"), "PETSc or CalculiX is not installed")
class NoNumbers(Case):
    def test_what_is_no_number_is_told(self):
        _, analysis = self.held_box(8.0)
        read = frd.read

        def without_a_number(path, names):
            blocks = read(path, names)
            blocks["STRESS"][1][0] = np.nan
            return blocks
        with mock.patch.object(frd, "read", side_effect=without_a_number), self.assertRaisesRegex(UserError, "^CalculiX gave what is no number for Analysis: look at"):
            api.solve_analysis(analysis, "ccx")


class LongExponents(unittest.TestCase):
    def test_a_value_below_1e_99_is_read(self):
        lines = "\n    2C\n -1         1 1.00000E+00-2.50000-100 0.00000E+00\n -1         2 1.00000+101 3.00000E-05-4.00000E+00\n -3\n    3C\n -3\n"
        with tempfile.NamedTemporaryFile() as file:
            file.write(lines.encode())
            file.flush()
            numbers, points, _ = frd.read_mesh(file.name)
        self.assertEqual((numbers.tolist(), points.tolist()), ([1, 2], [[1.0, -2.5e-100, 0.0], [1e101, 3e-5, -4.0]]))


class HeatAlone(unittest.TestCase):
    """As FreeCAD 1.0 and later can ask for."""

    def test_it_has_a_temperature_and_no_stress(self):
        result = SimpleNamespace(DisplacementVectors=[], vonMises=[], Temperature=[300.0, 400.0])
        found = calculix._responses(None, result, False, "", "thermomech")
        self.assertEqual((found["max_temperature_k"], found["max_mises_mpa"]), (400, None))
        self.assertEqual(tasks._responses_in_words(found), "highest temperature 400 K")

    def test_in_a_study(self):
        numbers = np.array([3, 5])
        fields = case_solver._fields({"NDTEMP": (numbers, np.array([[300.0], [400.0]]))}, None, "", SimpleNamespace(Group=[]), {"node_numbers": numbers}, None)
        self.assertEqual((fields.displacements, fields.temperatures.tolist()), (None, [300, 400]))


class PrintedReactions(unittest.TestCase):

    def test_of_a_rigid_body_what_holds_it_counts(self):
        modes = dict.fromkeys(("TranslationalModeX", "TranslationalModeY", "TranslationalModeZ"), "Load")
        members = [SimpleNamespace(Name="Fixed"), SimpleNamespace(Name="Loaded", **modes), SimpleNamespace(Name="Held", **{**modes, "TranslationalModeY": "Constraint"})]
        printed = "".join(" total force (fx,fy,fz) for set %s and time  0.1000000E+01\n\n        1.0  2.0  3.0\n\n" % name
                          for name in ("FIXED", "LOADED_REFNODE", "LOADED_ROTNODE", "HELD_REFNODE", "HELD_ROTNODE"))
        self.assertEqual(calculix.printed_reactions(printed, SimpleNamespace(Group=members)), {"Fixed": [1, 2, 3], "Held": [0, 2, 0]})


class Masses(Case):

    def test_curved_elements_weigh_what_the_part_does(self):
        part, analysis = self.drilled_box(), self.analysis()
        self.fix(analysis, part, faces_at(part, 0, 0))
        mesh = self.mesh(part, 5, 2)
        self.assertAlmostEqual(statics.mass(statics_model.read(analysis, mesh)) / (7850e-9 * part.Shape.Volume), 1, delta=1e-4)


class DirectOrIterative(Case):
    """CalculiX's iterative solver ends too soon where points hold a part, or supports move it."""

    def test_a_part_held_at_points_or_moved_by_supports_is_solved_directly(self):
        part, analysis = self.held_box(8.0)
        fixed = self.document.Fixed
        with mock.patch.object(calculix, "_MANY", 100):
            for held, is_iterative in ((faces_at(part, 0, 0), True), (["Vertex1", "Vertex2", "Vertex5"], False), (edges_along(part, 1)[::3], False)):
                fixed.References = [(part, held)]
                self.assertEqual(calculix.solves_iteratively(self.document.Solver, calculix.as_arrays(analysis)), is_iterative, held)
            if shutil.which("ccx"):
                self.assertRegex(api.solve_analysis(analysis, "ccx")["matrix_solver"]["why"], "points or edges hold the part")
                self.document.Solver.MatrixSolverType = "iterativecholesky"
                for held, is_unfit in ((edges_along(part, 1)[::3], True), (faces_at(part, 0, 0), False)):
                    fixed.References = [(part, held)]
                    said = " ".join(map(english, api.solve_analysis(analysis, "ccx")["warnings"]))
                    self.assertEqual("Solver asks for an iterative solver, which ends too soon" in said, is_unfit, said)
                self.document.Solver.MatrixSolverType = "default"
            fixed.References = [(part, faces_at(part, 0, 0))]
            moved = self.add(analysis, ObjectsFem.makeConstraintDisplacement, "Moved", [(part, faces_at(part, 0, 40))], xFree=False)
            for far, is_iterative in ((0, True), (0.5, False)):
                moved.xDisplacement = far
                self.assertEqual(calculix.solves_iteratively(self.document.Solver, calculix.as_arrays(analysis)), is_iterative, far)


@unittest.skipUnless(HAS_SOLVER and shutil.which("ccx"), "PETSc or CalculiX is not installed")
class PressureOnBothSides(Case):
    def test_of_a_plate_that_is_one_element_thick(self):
        """FreeCAD loaded the narrow sides between them, too, whose nodes are all on one or the other."""
        part, analysis = self.box(40, 40, 4), self.analysis()
        self.fix(analysis, part, faces_at(part, 0, 0))
        self.add(analysis, ObjectsFem.makeConstraintPressure, "Pressure", [(part, faces_at(part, 2, 0) + faces_at(part, 2, 4))], Pressure=quantity(1.0, "MPa"))
        mesh = self.mesh(part, 6)
        for order in ("1st", "2nd"):
            mesh.Order = order
            self.document.recompute()
            live, ccx = (api.solve_analysis(analysis, which)["responses"]["max_mises_mpa"] for which in ("live", "ccx"))
            self.assertAlmostEqual(ccx / live, 1, delta=1e-3)


@unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
class DoubtsAboutCalculiX(Case):
    def test_a_load_on_another_object_and_a_part_that_flew_away_are_said(self):
        """The live solver knows no such load, so that nothing finds out beforehand that one point does not hold the part."""
        _, analysis = self.held_box(8.0)
        other = self.document.addObject("Part::Box", "Other")
        other.Length, other.Width, other.Height = 40, 20, 10
        self.document.recompute()
        self.document.Force.References = [(other, faces_at(other, 0, 40))]
        said = " ".join(map(english, api.solve_analysis(analysis, "ccx")["warnings"]))
        self.assertRegex(said, "Force refers to Other:Face2, which is not on the meshed part Box: CalculiX got what FreeCAD found in the same place.*4-node")
        self.assertNotIn("its own size", said)
        self.document.Fixed.References = [(self.document.Box, ["Vertex1"])]
        self.assertRegex(" ".join(map(english, api.solve_analysis(analysis, "ccx")["warnings"])), "the part moved by .* times its own size")


class SeveralSolvers(Case):
    def setUp(self):
        super().setUp()
        self.part, self.of_the_box = self.held_box(8.0)
        self.first = solvers.for_calculix(self.of_the_box)

    def add_one(self, kind="static", first=False):
        solver = add_solver(self.document, self.of_the_box, kind)
        if first:
            self.of_the_box.Group = [solver] + [member for member in self.of_the_box.Group if member is not solver]
        return solver

    def test_the_one_for_statics_is_taken_wherever_it_is(self):
        self.add_one("frequency", first=True)
        self.add_one("buckling")
        self.assertEqual(calculix.solver_of(self.of_the_box), self.first)

    def test_other_programs_solvers_are_none_of_calculix(self):
        for make in (ObjectsFem.makeSolverElmer, ObjectsFem.makeSolverZ88):
            self.of_the_box.addObject(make(self.document))
        self.assertEqual(calculix.solver_of(self.of_the_box), self.first)

    def test_the_only_one_is_taken_whatever_it_asks_for(self):
        self.first.AnalysisType = "frequency"
        self.assertEqual(calculix.solver_of(self.of_the_box), self.first)

    def test_where_two_may_be_meant_both_are_named(self):
        self.add_one().Label = "Other one"
        with self.assertRaisesRegex(UserError, "has several CalculiX solvers that may be meant, leave one of them in it: .*Solver.*, .*Other one"):
            calculix.solver_of(self.of_the_box)

    @unittest.skipUnless(hasattr(ObjectsFem, "makeSolverCalculiX"), "this FreeCAD has no other solver object of CalculiX")
    def test_freecads_tools_take_their_own_kind(self):
        self.of_the_box.addObject(ObjectsFem.makeSolverCalculiX(self.document))
        self.assertEqual(calculix.solver_of(self.of_the_box), self.first)

    @unittest.skipUnless(HAS_SOLVER, "PETSc is not installed")
    def test_the_live_result_is_that_of_linear_statics(self):
        alone = statics.solve(self.of_the_box)[1]
        other = self.add_one("frequency", first=True)
        live = api.live_result(self.of_the_box)
        self.assertEqual(live.Status, live_result.UP_TO_DATE)
        report = statics.solve(self.of_the_box)[1]
        self.assertEqual(english(report["warnings"][0]), "solved as %s asks, not %s" % (self.first.Name, other.Name))
        self.assertEqual(report["warnings"][1:], alone["warnings"])
        self.add_one()   # for the live solver it is the same
        self.assertEqual(statics.solve(self.of_the_box)[1]["responses"], alone["responses"])
        self.first.AnalysisType = "buckling"
        self.of_the_box.removeObject(self.document.Objects[-1])
        for solver in solvers.of_calculix(self.of_the_box):
            solver.AnalysisType = "frequency"
        with self.assertRaisesRegex(statics.NotUnderstood, "the live solver knows linear statics only, and .* asks for AnalysisType = frequency"):
            statics.solve(self.of_the_box)

    @unittest.skipUnless(HAS_SOLVER, "PETSc is not installed")
    def test_an_analysis_within_it_is_another_one(self):
        """FreeCAD 1.1 pastes the copy of an analysis into the one that is selected."""
        alone = statics.solve(self.of_the_box)[1]["responses"]
        inner = ObjectsFem.makeAnalysis(self.document, "Copied")
        self.of_the_box.addObject(inner)
        add_solver(self.document, inner)
        self.assertEqual(statics.solve(self.of_the_box)[1]["responses"], alone)
        self.assertEqual(calculix.solver_of(self.of_the_box), self.first)

    @unittest.skipUnless(HAS_SOLVER, "PETSc is not installed")
    def test_a_part_within_it_is_none_of_its_loads(self):
        """FreeCAD pastes the part of a copied analysis into the one that is selected."""
        alone = statics.solve(self.of_the_box)[1]["responses"]
        for kind in ("Part::Box", "PartDesign::Body", "App::Part", "App::Link"):
            self.of_the_box.addObject(self.document.addObject(kind, "Copied"))
        self.assertEqual(statics.solve(self.of_the_box)[1]["responses"], alone)

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_calculix_says_which_it_took(self):
        other = self.add_one("frequency", first=True)
        report = api.solve_analysis(self.of_the_box, "ccx")
        self.assertIn("solved as %s asks, not %s" % (self.first.Name, other.Name), list(map(english, report["warnings"])))
        self.assertGreater(api.solve(self.of_the_box).figures["stress"], 0)

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_freecads_other_solver_object_is_enough(self):
        make = getattr(ObjectsFem, "makeSolverCalculiX", None) or ObjectsFem.makeSolverCalculix
        self.document.removeObject(self.first.Name)
        self.of_the_box.addObject(make(self.document))
        for solve in (api.solve, lambda analysis: api.solve_analysis(analysis, "ccx")):
            solve(self.of_the_box)
            self.assertEqual(len(solvers.of_calculix(self.of_the_box)), 1)

    def test_what_calculix_says_when_it_fails(self):
        for words, shown in ((" reading\n *ERROR in e_c3d: no\n   section\n of 7\n end", "ERROR in e_c3d: no section of 7"), ("one\ntwo\nthree\nfour", "two three four"),
                             ("", "it says nothing of why")):
            with self.assertRaisesRegex(UserError, "^CalculiX failed .exit code 201.: .?%s$" % shown):
                calculix.refuse_failure(201, words)

    @unittest.skipUnless(HAS_SOLVER and shutil.which("ccx"), "PETSc or CalculiX is not installed")
    def test_beside_a_live_result_calculix_gives_its_own(self):
        live = api.live_result(self.of_the_box)
        for _ in range(2):
            solution = api.solve(self.of_the_box)
            self.assertIn("CCX", solution.result.Name)
            self.assertNotEqual(solution.result, live.Result)
            self.assertEqual(live.Status, live_result.UP_TO_DATE)
            self.assertNotEqual(solution.figures["displacement"], live.MaxDisplacement)   # of six digits in CalculiX's file
            self.assertAlmostEqual(solution.figures["displacement"] / live.MaxDisplacement, 1, delta=1e-4)
        before = live.Result
        api.solve_analysis(self.of_the_box, "ccx")
        self.assertEqual((live.Status, live.Result), (live_result.UP_TO_DATE, before))

    @unittest.skipUnless(HAS_SOLVER and shutil.which("ccx"), "PETSc or CalculiX is not installed")
    def test_a_part_that_can_move_is_refused_but_for_its_modes(self):
        self.document.removeObject("Fixed")
        for solve in (api.solve, lambda analysis: api.solve_analysis(analysis, "ccx")):
            with self.assertRaisesRegex(UserError, "can still move along x, y and z and turn about"):
                solve(self.of_the_box)
        self.assertFalse([member for member in self.of_the_box.Group if member.isDerivedFrom("Fem::FemResultObject")])
        self.first.AnalysisType = "frequency"
        calculix.refuse_free_motions(calculix.as_arrays(self.of_the_box))

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_modes_are_told_by_their_frequencies(self):
        self.first.AnalysisType = "frequency"
        self.first.EigenmodesCount = 2
        report = api.solve_analysis(self.of_the_box)
        found = report["responses"]
        self.assertEqual((len(found["frequencies_hz"]), found["max_mises_mpa"], found["max_displacement_mm"]), (2, None, None))
        self.assertRegex(tasks.solution_in_words(report), r"^CalculiX: frequencies [\d.e+]+, [\d.e+]+ Hz, in ")

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_a_check_of_the_mesh_gives_no_result(self):
        self.first.AnalysisType = "check"
        for solve in (api.solve_analysis, api.solve):
            with self.assertRaisesRegex(UserError, "only checks the mesh"):
                solve(self.of_the_box)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""What a solution starts from: the result that a document was saved with, and the base of a study."""

import json
import os
import tempfile
import unittest
from unittest import mock

import FreeCAD
from freecad.featuremesh import api, cli, engine, statics
from freecad.featuremesh.study import case_solver
from statics_cases import HAS_SOLVER, Case, faces_at


def tearDownModule():
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)


@unittest.skipUnless(HAS_SOLVER, "PETSc is not installed")
class Starts(Case):

    def cantilever(self, size):
        part, analysis = self.box(), self.analysis()
        self.fix(analysis, part, faces_at(part, 0, 0))
        self.force(analysis, part, faces_at(part, 0, 40))
        self.mesh(part, size)
        return analysis

    def test_a_new_process_starts_from_the_saved_result(self):
        self.cantilever(4.0)
        force = "Force.Force=%s" % (200.0 if isinstance(self.document.Force.Force, float) else "200 N")
        with tempfile.TemporaryDirectory() as folder:
            path, json_path = os.path.join(folder, "part.FCStd"), os.path.join(folder, "report.json")
            self.document.saveAs(path)
            FreeCAD.closeDocument(self.document.Name)

            def told(command, **options):
                done = cli.run({"command": command, "part": path, "json": json_path, **options})
                self.assertEqual(done["exit_code"], 0, done["message"])
                with open(json_path, encoding="utf-8") as stream:
                    report = json.load(stream)
                return report.get("solution", report)
            first, again = told("solve", live=True), told("solve", live=True)
            loaded, edited = told("update", set=[force], solve=True), told("update", set=["Box.Length=40.5"], solve=True)
            os.remove(json_path)
            fresh = self.solved_anew(path)
        self.assertEqual(first["reused"], {"preconditioner": False, "start_share": 0.0})
        for report in (again, loaded):   # other loads only scale the start
            self.assertEqual(report["reused"], {"preconditioner": False, "start_share": 1.0})
            self.assertLessEqual(report["iterations"], 1)
        self.assertAlmostEqual(again["responses"]["max_mises_mpa"] / first["responses"]["max_mises_mpa"], 1, delta=1e-5)
        self.assertAlmostEqual(loaded["responses"]["strain_energy_mj"] / first["responses"]["strain_energy_mj"], 0.04, places=8)
        self.assertGreater(edited["reused"]["start_share"], 0.5)
        self.assertLess(edited["iterations"], fresh["iterations"])
        for name in ("max_mises_mpa", "max_displacement_mm", "strain_energy_mj"):
            self.assertAlmostEqual(edited["responses"][name] / fresh["responses"][name], 1, delta=1e-5)

    def solved_anew(self, path):
        """The report of a solution that starts from nothing."""
        document = FreeCAD.openDocument(path)
        try:
            return statics.solve(api.find_analysis(document))[1]
        finally:
            FreeCAD.closeDocument(document.Name)

    def test_cases_of_a_study_start_from_the_solution_of_its_base(self):
        analysis = self.cantilever(8.0)
        _, fresh = statics.solve(analysis)
        for is_here in (True, False):
            with self.subTest(is_here), mock.patch.object(engine, "is_here", return_value=is_here):
                base = case_solver.solve_live_base(analysis)
                self.document.Force.Force = self.document.Force.Force * 2
                _, report = statics.solve(analysis, base.keep, 1, start=base.start)
                self.assertEqual(report["reused"], {"preconditioner": is_here, "start_share": 1.0})
                self.assertLess(report["iterations"], fresh["iterations"] / 2)
                if is_here:
                    engine.load().forget_statics(base.keep)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Scripts of a user's own: what `./featuremesh run` prints, how it tells of errors, and api.solve."""
import os
import shutil
import tempfile
import unittest
from unittest import mock

import FreeCAD
import ObjectsFem
from analyses import quantity
from femtools import ccxtools
from freecad.featuremesh import api, cli, mesh_object, solve_guard, versions
from freecad.featuremesh.errors import UserError
from parts import new_document, plate_with_hole

FIXED, PULLED = "Face1", "Face3"


def analysis_of(document, body):
    """The plate held at one side and pulled at the other, with a mesh."""
    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    mesh = api.add_mesh(body, 6, order=1)
    held, pulled = ObjectsFem.makeConstraintFixed(document, "Held"), ObjectsFem.makeConstraintForce(document, "Pulled")
    steel = ObjectsFem.makeMaterialSolid(document, "Steel")
    steel.Material = {"Name": "Steel", "YoungsModulus": "210000 MPa", "PoissonRatio": "0.30", "Density": "7900 kg/m^3"}
    held.References, pulled.References = [(body, FIXED)], [(body, PULLED)]
    pulled.Force = quantity(1000.0, "N")
    for member in (held, pulled, steel):
        analysis.addObject(member)
    document.recompute()
    return analysis, mesh


class Run(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.script = os.path.join(self.folder, "script.py")

    def run_script(self, text, part=None):
        """The answer, and what the script printed."""
        with open(self.script, "w", encoding="utf-8") as stream:
            stream.write(text)
        printed = os.path.join(self.folder, "printed")
        task = {"command": "run", "script": self.script, "part": part, "output": os.open(printed, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)}
        answer = cli.run(task)
        with open(printed, encoding="utf-8") as stream:
            return answer, stream.read()

    def test_only_what_the_script_prints(self):
        document = new_document()
        plate_with_hole(document)
        path = os.path.join(self.folder, "part.FCStd")
        document.saveAs(path)
        new_document()
        answer, printed = self.run_script("mesh = api.add_mesh(document.Body, 8)\nreport = api.update_mesh(mesh)\nprint(report['tets'] > 0, __name__)\n", path)
        self.assertEqual((answer["exit_code"], answer["message"], printed), (0, "", "True __main__\n"))

    def test_without_a_document(self):
        answer, printed = self.run_script("import sys\nprint(document, len(sys.argv))\n")
        self.assertEqual((answer["exit_code"], printed), (0, "None 1\n"))

    def test_errors_name_the_line(self):
        for text, words in (("print(1)\n1 / 0\n", "script.py, line 2: ZeroDivisionError: division by zero"), ("x = (\n", "script.py, line 1: SyntaxError"),
                            ("api.add_mesh(None)\n", "no object of a document"), ("import sys\nsys.exit(3)\n", "script.py ended with 3")):
            answer, _ = self.run_script(text)
            self.assertEqual(answer["exit_code"], 2, answer)
            self.assertIn(words, answer["message"])

    def test_a_script_that_is_cancelled_runs_once(self):
        answer, printed = self.run_script("print(1)\nraise KeyboardInterrupt\n")
        self.assertEqual((answer["exit_code"], answer["message"], printed), (1, "cancelled", "1\n"))

    def test_the_end_asked_for_is_no_error(self):
        self.assertEqual(self.run_script("import sys\nprint(1)\nsys.exit()\n")[0]["exit_code"], 0)


@unittest.skipUnless(shutil.which("ccx"), "needs CalculiX")
class Solve(unittest.TestCase):
    def setUp(self):
        self.document = new_document()
        self.body = plate_with_hole(self.document)
        self.analysis, self.mesh = analysis_of(self.document, self.body)

    def test_an_edit_of_a_new_document_that_was_never_recomputed_beside_a_mesh(self):
        """As where a script makes part, analysis and mesh, and updates that by itself."""
        part = new_document("New").addObject("Part::Box", "Beam")
        part.recompute()
        part.purgeTouched()
        mesh = api.add_mesh(part, 5, order=1)
        api.update_mesh(mesh)
        self.assertEqual(solve_guard.not_recomputed(mesh), "")
        part.Length = 50
        self.assertRegex(solve_guard.not_recomputed(mesh), "Beam was edited and not recomputed")

    def test_an_edit_is_not_forgotten_when_something_else_is_undone(self):
        self.document.UndoMode = 1
        self.document.Plate.Length = 12   # as a script leaves it
        self.document.openTransaction("Label")
        self.analysis.Label = "Other"
        self.document.commitTransaction()
        self.document.undo()
        self.assertRegex(solve_guard.reason(self.analysis), "Plate was edited and not recomputed")

    def test_solves_with_a_solver_of_its_own_and_again_after_an_edit(self):
        first = api.solve(self.analysis)
        displacement = first.figures["displacement"]
        self.assertEqual(set(first.figures) - {"temperature"}, {"displacement", "stress"})
        self.assertEqual(first.figures["displacement"], max(vector.Length for vector in first.result.DisplacementVectors))
        solvers = [member for member in self.analysis.Group if "olver" in member.Name or member.Name.startswith("CalculiX")]
        self.document.HoleSketch.setDatum("Radius", 9)
        self.document.recompute()
        second = api.solve(self.analysis)
        self.assertGreater(second.figures["displacement"], 1.02 * displacement)   # less material
        self.assertEqual([member for member in self.analysis.Group if "olver" in member.Name or member.Name.startswith("CalculiX")], solvers)

    @unittest.skipUnless(hasattr(ObjectsFem, "makeSolverCalculiX"), "FreeCAD has one kind of CalculiX solver")
    def test_the_solver_object_of_freecad_1_1_is_taken(self):
        solver = ObjectsFem.makeSolverCalculiX(self.document, "SolverCalculiX")
        self.analysis.addObject(solver)
        self.assertGreater(api.solve(self.analysis).figures["displacement"], 0)
        self.assertEqual([member for member in self.analysis.Group if hasattr(member, "AnalysisType")], [solver])

    def test_the_program_that_the_user_chose_is_enough(self):
        settings, program = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/Fem/Ccx"), shutil.which("ccx")
        settings.SetBool("UseStandardCcxLocation", False)
        settings.SetString("ccxBinaryPath", program)
        self.addCleanup(settings.SetBool, "UseStandardCcxLocation", True)
        self.addCleanup(settings.SetString, "ccxBinaryPath", "")
        with tempfile.TemporaryDirectory() as folder, mock.patch.dict(os.environ, {"PATH": folder}):
            self.assertGreater(api.solve(self.analysis).figures["displacement"], 0)
            if versions.can_leave_chosen_calculix():
                settings.SetBool("UseStandardCcxLocation", True)
                with self.assertRaisesRegex(UserError, "CalculiX .ccx. is not installed"):
                    api.solve(self.analysis)

    def test_a_chosen_program_that_is_not_calculix_is_named(self):
        settings, program = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/Fem/Ccx"), shutil.which("true")
        settings.SetBool("UseStandardCcxLocation", False)
        self.addCleanup(settings.SetBool, "UseStandardCcxLocation", True)
        self.addCleanup(settings.SetString, "ccxBinaryPath", "")
        for path, what in (("/no/ccx", "cannot be run"), ("/usr", "cannot be run"), (program, "is not CalculiX")):
            settings.SetString("ccxBinaryPath", path)
            for solve in (api.solve, lambda analysis: api.solve_analysis(analysis, "ccx")):
                with self.subTest(path=path), self.assertRaisesRegex(UserError, "^CalculiX's program is set to %s, which %s; .*preferences, FEM > CalculiX$" % (path, what)):
                    solve(self.analysis)

    def test_a_mesh_out_of_date_is_not_solved(self):
        self.mesh.Automatic = False
        self.document.HoleSketch.setDatum("X", 24)
        self.document.recompute()
        self.assertNotEqual(self.mesh.Status, mesh_object.UP_TO_DATE)
        with self.assertRaisesRegex(UserError, "out of date.*before solving"):
            api.solve(self.analysis)

    def test_what_is_missing_is_said_and_the_last_result_stays(self):
        result = api.solve(self.analysis).result
        self.document.removeObject("Steel")
        with self.assertRaisesRegex(UserError, "cannot solve Analysis: .*material"):
            api.solve(self.analysis)
        self.assertIn(result, self.analysis.Group)
        with self.assertRaisesRegex(UserError, "Body is no analysis"):
            api.solve(self.body)

    def test_what_freecads_writer_fails_at_is_said_and_the_last_result_stays(self):
        result = api.solve(self.analysis).result
        with mock.patch.object(ccxtools.FemToolsCcx, "write_inp_file", side_effect=ZeroDivisionError("float division by zero")):
            for solve in (api.solve, lambda analysis: api.solve_analysis(analysis, "ccx")):
                with self.assertRaisesRegex(UserError, "could not write CalculiX's input for Analysis: float division by zero; is there a load of 0"):
                    solve(self.analysis)
        self.assertIn(result, self.analysis.Group)

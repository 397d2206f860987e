# SPDX-License-Identifier: GPL-3.0-or-later
"""Analyses with our mesh: CalculiX solves them, the figures are right, and an edit needs no hand on the constraints."""
import os
import shutil
import signal
import tempfile
import unittest
from unittest import mock

import ObjectsFem
from femtools import ccxtools
from freecad.featuremesh import api, calculix, engine, mesh_object, solve_guard, versions
from freecad.featuremesh.errors import UserError
from freecad.featuremesh.messages import english
from freecad.featuremesh.study import study_object
from parts import groups_in_freecad, groups_of, new_document

STEEL = {"Name": "Steel", "YoungsModulus": "210000 MPa", "PoissonRatio": "0.30", "Density": "7850 kg/m^3"}
ALUMINIUM = {"Name": "Aluminium", "YoungsModulus": "70000 MPa", "PoissonRatio": "0.33", "Density": "2700 kg/m^3"}
LENGTH, WIDTH, HEIGHT, FORCE = 80.0, 10.0, 10.0, 1000.0


def newton(value):
    return value if versions.version() < (1, 0) else "%g N" % value


def face_at(part, x):
    """Name of the plane face of `part` normal to the x axis at x."""
    for number, face in enumerate(part.Shape.Faces, 1):
        box = face.BoundBox
        if abs(box.XMin - x) < 1e-6 and abs(box.XMax - x) < 1e-6:
            return "Face%d" % number
    raise ValueError("no face at x = %g" % x)


def analysis_of(document, part, materials):
    """A cantilever: fixed at x = 0, pulled down at the far end."""
    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    make = getattr(ObjectsFem, "makeSolverCalculiXCcxTools", None) or ObjectsFem.makeSolverCalculixCcxTools
    solver = make(document, "Solver")
    solver.AnalysisType, solver.GeometricalNonlinearity = "static", "linear"
    solver.ThermoMechSteadyState = solver.IterationsControlParameterTimeUse = False
    fixed = ObjectsFem.makeConstraintFixed(document, "Fixed")
    fixed.References = [(part, face_at(part, 0))]
    force = ObjectsFem.makeConstraintForce(document, "Force")
    force.References = [(part, face_at(part, part.Shape.BoundBox.XMax))]
    force.Force = newton(FORCE)
    force.Direction = (part, ["Edge1"])
    analysis.addObject(solver)
    for name, values, references in materials:
        material = ObjectsFem.makeMaterialSolid(document, name)
        material.Material = values
        if references:
            material.References = references
        analysis.addObject(material)
    analysis.addObject(fixed)
    analysis.addObject(force)
    document.recompute()
    return analysis


@unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
class Solving(unittest.TestCase):

    def setUp(self):
        self.document = new_document()
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)

    def solve(self, analysis):
        """(largest displacement mm, the input file's text)."""
        for obj in [o for o in self.document.Objects if o.isDerivedFrom("Fem::FemResultObject") or o.Name.startswith("ResultMesh")]:
            self.document.removeObject(obj.Name)
        tools = ccxtools.FemToolsCcx(analysis, analysis.Group[0], test_mode=False)
        tools.setup_working_dir(self.folder)
        tools.update_objects()
        tools.setup_ccx(ccx_binary=shutil.which("ccx"))
        self.assertEqual(tools.check_prerequisites(), "")
        tools.write_inp_file()
        self.assertEqual(tools.ccx_run(), 0)
        tools.load_results()
        result, = [o for o in analysis.Group if o.isDerivedFrom("Fem::FemResultObject")]
        with open(tools.inp_file_name, encoding="utf-8") as stream:
            return max(vector.Length for vector in result.DisplacementVectors), stream.read()

    def beam(self):
        box = self.document.addObject("Part::Box", "Beam")
        box.Length, box.Width, box.Height = LENGTH, WIDTH, HEIGHT
        self.document.recompute()
        return box

    def bending(self, length):
        """Of a cantilever, with shear (Timoshenko), mm."""
        second_moment, shear_modulus = WIDTH * HEIGHT ** 3 / 12, 210000 / 2.6
        return FORCE * length ** 3 / (3 * 210000 * second_moment) + FORCE * length / (5 / 6 * shear_modulus * WIDTH * HEIGHT)

    def test_cantilever_before_and_after_an_edit(self):
        beam = self.beam()
        analysis = analysis_of(self.document, beam, [("Steel", STEEL, [])])
        force = self.document.getObject("Force")
        side = [e for e, edge in enumerate(beam.Shape.Edges, 1) if abs(edge.tangentAt(edge.FirstParameter).z) > 0.99][0]
        force.Direction = (beam, ["Edge%d" % side])
        mesh = api.add_mesh(beam, 3.0, order=2)
        self.document.recompute()
        self.assertIn(mesh, analysis.Group)
        first, _ = self.solve(analysis)
        self.assertAlmostEqual(first / self.bending(LENGTH), 1, delta=0.01)
        references = [obj.References for obj in (self.document.getObject("Fixed"), force)]
        beam.Length = 90
        self.document.recompute()
        self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
        self.assertGreater(mesh.KeptNodes, 50)
        second, _ = self.solve(analysis)
        self.assertAlmostEqual(second / self.bending(90), 1, delta=0.01)
        self.assertEqual([obj.References for obj in (self.document.getObject("Fixed"), force)], references)

    def test_groups_give_the_nodes_that_freecad_would_find(self):
        """The input file with our groups and the one that FreeCAD makes by searching name the same nodes."""
        beam = self.beam()
        analysis = analysis_of(self.document, beam, [("Steel", STEEL, [])])
        mesh = api.add_mesh(beam, 4.0, order=1)
        self.document.recompute()
        with_groups, _ = self.solve(analysis)
        for group in mesh.FemMesh.Groups:
            mesh.FemMesh.removeGroup(group)
        without, _ = self.solve(analysis)
        self.assertAlmostEqual(with_groups, without, delta=1e-9 * without)

    def two_boxes(self):
        """Two boxes side by side, their boolean fragments, and the names of its solids from left to right."""
        from BOPTools import SplitFeatures
        left, right = (self.document.addObject("Part::Box", name) for name in ("Left", "Right"))
        left.Length = right.Length = 20
        right.Placement.Base.x = 20
        fragments = SplitFeatures.makeBooleanFragments("Fragments")
        fragments.Objects, fragments.Mode = [left, right], "CompSolid"
        self.document.recompute()
        names = sorted(("Solid1", "Solid2"), key=lambda n: fragments.Shape.Solids[int(n[5:]) - 1].CenterOfMass.x)
        return left, right, fragments, names

    def test_without_petsc_calculix_solves(self):
        part = self.document.addObject("Part::Box", "Beam")
        part.Length, part.Width, part.Height = LENGTH, WIDTH, HEIGHT
        self.document.recompute()
        analysis = analysis_of(self.document, part, [("Steel", STEEL, [])])
        api.add_mesh(part, 5.0)
        self.document.recompute()
        with mock.patch.object(engine.load(), "statics_missing", return_value="it is not there"):
            self.assertFalse(study_object.is_for_live(analysis))
            report = api.solve_analysis(analysis)
            with self.assertRaisesRegex(UserError, "needs PETSc"):
                api.solve_analysis(analysis, "live")
        self.assertEqual(report["solver"], "CalculiX")
        self.assertIn("needs PETSc", " ".join(map(english, report["warnings"])))

    def test_calculix_ends_with_the_process_that_started_it(self):
        """The one that Ctrl-C ends, or a lack of memory; CalculiX would go on for hours."""
        reading, writing = os.pipe()
        child = os.fork()
        if not child:
            command = ["sh", "-c", "echo started; for i in $(seq 200); do sleep 0.1; done; echo not ended"]
            calculix.run(mock.Mock(ccx_run=lambda: ccxtools.subprocess.Popen(command, stdout=writing).wait()))
            os._exit(0)
        os.close(writing)
        with open(reading, encoding="utf-8") as stream:
            self.assertEqual(stream.readline(), "started\n")
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
            self.assertEqual(stream.read(), "")

    def test_an_analysis_without_a_solver_gets_one(self):
        part = self.document.addObject("Part::Box", "Beam")
        self.document.recompute()
        analysis = analysis_of(self.document, part, [("Steel", STEEL, [])])
        for member in [member for member in analysis.Group if hasattr(member, "AnalysisType")]:
            self.document.removeObject(member.Name)
        api.add_mesh(part, 5.0)
        self.document.recompute()
        for _ in range(2):
            self.assertEqual(api.solve_analysis(analysis, "ccx")["solver"], "CalculiX")
        self.assertEqual(len([member for member in analysis.Group if hasattr(member, "AnalysisType")]), 1)

    def test_reinforced_concrete(self):
        """CalculiX solves it, and FreeCAD tells from its stresses how much of it is to be steel."""
        part = self.document.addObject("Part::Box", "Beam")
        self.document.recompute()
        analysis = analysis_of(self.document, part, [])
        concrete = ObjectsFem.makeMaterialReinforced(self.document, "Concrete")
        concrete.Material = {"Name": "Concrete", "YoungsModulus": "32000 MPa", "PoissonRatio": "0.17", "Density": "2400 kg/m^3",
                             "CompressiveStrength": "30 MPa", "AngleOfFriction": "30 deg"}
        concrete.Reinforcement = {"Name": "Steel", "YieldStrength": "500 MPa"}
        analysis.addObject(concrete)
        api.add_mesh(part, 5.0)
        self.document.recompute()
        report = api.solve_analysis(analysis)
        self.assertAlmostEqual(report["responses"]["mass_kg"], 2.4e-3, places=9)
        self.assertEqual([english(line) for line in report["warnings"]], ["solved with CalculiX: only CalculiX knows Concrete (MaterialReinforced), not the live solver"])
        self.assertGreater(max(self.document.getObject(report["result"]).ReinforcementRatio_x), 0)

    def test_two_materials_in_one_part(self):
        _, _, fragments, names = self.two_boxes()
        self.assertEqual(len(fragments.Shape.Solids), 2)
        analysis = analysis_of(self.document, fragments, [("Steel", STEEL, [(fragments, names[0])]),
                                                          ("Aluminium", ALUMINIUM, [(fragments, names[1])])])
        mesh = api.add_mesh(fragments, 4.0, order=1)
        self.document.recompute()
        self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
        groups = groups_of(mesh)
        self.assertEqual(groups["Steel_Volumes"], groups[names[0]])
        self.assertEqual(groups["Aluminium_Volumes"], groups[names[1]])
        self.assertEqual(groups["Steel_Volumes"] | groups["Aluminium_Volumes"], set(mesh.FemMesh.Volumes))
        _, text = self.solve(analysis)
        self.assertEqual(text.upper().count("*SOLID SECTION"), 2)

    def test_each_solid_needs_one_material(self):
        """Solids become one, or there is another one, after materials were chosen for them."""
        left, right, fragments, names = self.two_boxes()
        analysis = analysis_of(self.document, fragments, [("Steel", STEEL, [(fragments, names[0])]), ("Aluminium", ALUMINIUM, [(fragments, names[1])])])
        api.add_mesh(fragments, 6.0, order=1)
        self.document.recompute()
        aluminium = self.document.getObject("Aluminium")
        for references, message in (([(fragments, names[1])], "^$"), ([(fragments, names[0])], names[0] + " has several materials: Steel, Aluminium; "), ([], "^$")):
            aluminium.References = references
            self.assertRegex(solve_guard.reason(analysis), message)
        aluminium.References = [(fragments, names[1])]
        third = self.document.addObject("Part::Box", "Third")
        third.Placement.Base.x = -10
        fragments.Objects = [left, right, third]
        self.document.recompute()
        self.assertRegex(solve_guard.reason(analysis), "^Solid. has no material; ")
        self.document.removeObject("Aluminium")
        self.assertEqual(solve_guard.reason(analysis), "")   # one material is that of all

    def test_what_is_suppressed_stands_in_nobodys_way(self):
        """As FreeCAD 1.1 can: a material that another one takes the place of, a load that has lost its face."""
        _, _, fragments, names = self.two_boxes()
        analysis = analysis_of(self.document, fragments, [("Steel", STEEL, [(fragments, names[0])])] + [
            (name, ALUMINIUM, [(fragments, names[1])]) for name in ("Aluminium", "Magnesium")])
        mesh = api.add_mesh(fragments, 6.0, order=1)
        self.document.recompute()
        lost = ObjectsFem.makeConstraintFixed(self.document, "Lost")
        lost.addProperty("App::PropertyStringList", "LostReferences")
        lost.LostReferences = ["Face9"]
        analysis.addObject(lost)
        self.assertRegex(solve_guard.reason(analysis), "has several materials: Aluminium, Magnesium")
        for obj in (self.document.getObject("Magnesium"), lost):
            if "Suppressed" not in obj.PropertiesList:   # before FreeCAD 1.1
                obj.addProperty("App::PropertyBool", "Suppressed")
            obj.Suppressed = True
        self.assertEqual(solve_guard.reason(analysis), "")
        self.assertEqual(groups_in_freecad(mesh)["Aluminium_Volumes"], groups_of(mesh)[names[1]])

    def test_materials_of_the_objects_that_the_part_is_made_of(self):
        """As users of boolean fragments refer to them; only solids that lie wholly in one of theirs count."""
        left, right, fragments, names = self.two_boxes()
        analysis = analysis_of(self.document, fragments, [("Steel", STEEL, [(left, "Solid1")]), ("Aluminium", ALUMINIUM, [(right, "")])])
        mesh = api.add_mesh(fragments, 4.0, order=1)
        self.document.recompute()
        groups = groups_of(mesh)
        self.assertEqual(groups["Steel_Volumes"], groups[names[0]])
        self.assertEqual(groups["Aluminium_Volumes"], groups[names[1]])
        self.document.getObject("Aluminium").References = [(left, "Solid1")]
        mesh.Proxy.renew_groups(mesh)
        self.assertNotIn("Steel_Volumes", groups_of(mesh))
        self.assertIn(analysis, mesh.InList)

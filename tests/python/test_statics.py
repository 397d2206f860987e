# SPDX-License-Identifier: GPL-3.0-or-later
"""The live solver: what it reads of an analysis is what FreeCAD writes for CalculiX, and what it finds is what CalculiX finds."""
import concurrent.futures
import json
import os
import random
import shutil
import tempfile
import unittest

import FreeCAD
import numpy as np
import ObjectsFem
from analyses import quantity, solve
from freecad.featuremesh import api, calculix, cli, engine, statics, statics_model, statics_supports
from freecad.featuremesh.errors import UserError
from freecad.featuremesh.messages import english
from parts import new_document
from statics_cases import HAS_SOLVER, SOFT, STEEL, Case, edges_along, faces_at

SEED = int(os.environ.get("FEATUREMESH_SEED", "29"))
SCALARS = ["NodeStress" + title for title in ("XX", "YY", "ZZ", "XY", "XZ", "YZ")] + ["NodeStrain" + title for title in ("XX", "YY", "ZZ", "XY", "XZ", "YZ")] \
    + ["vonMises", "DisplacementLengths", "PrincipalMax", "PrincipalMed", "PrincipalMin", "MaxShear"]


def keys_of(report):
    """The names in a report and in what is in it; supports are named by the user."""
    return {name: keys_of(value) if isinstance(value, dict) and name != "reactions_n" else None for name, value in report.items()}


def loads_of(text, arrays):
    """(n,3) the *CLOAD lines of an input file, rows as in the arrays."""
    row = {number: i for i, number in enumerate(arrays["node_numbers"].tolist())}
    loads, inside = np.zeros((len(row), 3)), False
    for line in text.splitlines():
        if line.startswith("*"):
            inside = line.startswith("*CLOAD") or (inside and line.startswith("**"))
        elif inside and line.strip():
            node, axis, value = line.split(",")
            loads[row[int(node)], int(axis) - 1] += float(value)
    return loads


def pressed_faces_of(text):
    """{(sorted tet number, side): MPa} of the *DLOAD lines."""
    found = {}
    for line in text.splitlines():
        words = line.split(",")
        if len(words) == 3 and words[1].startswith("P") and words[0].isdigit():
            found[int(words[0]), int(words[1][1:])] = float(words[2])
    return found


def nodes_of_set(text, name):
    lines = text.splitlines()
    start = lines.index("*NSET,NSET=" + name) + 1
    numbers = []
    for line in lines[start:]:
        if not line.strip().rstrip(",").isdigit():
            break
        numbers.append(int(line.strip().rstrip(",")))
    return sorted(numbers)


@unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
class ReadAsFreeCADWrites(Case):
    """Load vectors and supports against the .inp that FreeCAD writes for the same mesh."""

    def written(self, analysis):
        """(our reading, FreeCAD's text)"""
        mesh = statics.mesh_of(analysis)
        return statics_model.read(analysis, mesh), solve(analysis)["input"]

    def check_loads(self, analysis):
        read, text = self.written(analysis)
        expected = loads_of(text, read.arrays)
        self.assertGreater(np.abs(expected).max(), 0)
        np.testing.assert_allclose(read.loads, expected, rtol=0, atol=1e-9 * np.abs(expected).max())

    def test_force_on_faces_edges_and_vertices(self):
        for order in (1, 2):
            for kind in ("plane faces that share an edge", "a curved face", "edges", "vertices"):
                with self.subTest(order=order, kind=kind):
                    self.document = new_document()
                    part = self.drilled_box() if kind == "a curved face" else self.box()
                    analysis = self.analysis()
                    self.fix(analysis, part, faces_at(part, 0, 0))
                    round_faces = ["Face%d" % i for i, face in enumerate(part.Shape.Faces, 1) if face.Surface.TypeId == "Part::GeomCylinder"]
                    subs = {"plane faces that share an edge": faces_at(part, 0, 40) + faces_at(part, 2, 10), "a curved face": round_faces,
                            "edges": edges_along(part, 1)[:2], "vertices": ["Vertex1", "Vertex3", "Vertex8"]}[kind]
                    self.force(analysis, part, subs)
                    self.mesh(part, order=order)
                    self.check_loads(analysis)

    def test_two_forces_on_the_same_nodes_add_up(self):
        part = self.box()
        analysis = self.analysis()
        self.fix(analysis, part, faces_at(part, 0, 0))
        self.force(analysis, part, faces_at(part, 0, 40))
        self.force(analysis, part, faces_at(part, 2, 10), 300.0, "Second", along=1)
        self.mesh(part)
        self.check_loads(analysis)

    def test_what_is_the_same_to_solve(self):
        part = self.box()
        analysis = self.analysis()
        fixed = self.fix(analysis, part, faces_at(part, 0, 0))
        force = self.force(analysis, part, faces_at(part, 0, 40))
        pressure = self.add(analysis, ObjectsFem.makeConstraintPressure, "Pressure", [(part, faces_at(part, 2, 10))], Pressure=quantity(3, "MPa"))
        mesh = self.mesh(part)
        first = statics_model.prepared(analysis, mesh)
        self.assertTrue(first.is_same(statics_model.prepared(analysis, mesh)))
        self.assertTrue(first.is_same(statics_model.read(analysis, mesh)))
        material = next(member for member in analysis.Group if hasattr(member, "Material"))
        changes = [
            lambda: setattr(force, "Force", quantity(1234, "N")),
            lambda: setattr(pressure, "Reversed", True),
            lambda: setattr(fixed, "References", [(part, faces_at(part, 0, 0) + faces_at(part, 1, 0))]),
            lambda: setattr(material, "Material", {**material.Material, "Density": "2700 kg/m^3"}),
            lambda: (setattr(part, "Height", 11), self.document.recompute(), api.update_mesh(mesh))]
        last = first
        for change in changes:
            change()
            now = statics_model.prepared(analysis, mesh)
            self.assertFalse(first.is_same(now) or last.is_same(now))
            last = now

    def test_supports(self):
        part = self.box()
        analysis = self.analysis()
        self.fix(analysis, part, faces_at(part, 0, 0))
        moved = self.add(analysis, ObjectsFem.makeConstraintDisplacement, "Moved", [(part, faces_at(part, 0, 40))], xFree=False, zFree=False)
        moved.xDisplacement = quantity(0.25, "mm")
        self.mesh(part)
        read, text = self.written(analysis)
        numbers = read.arrays["node_numbers"]
        for member, axes in (("Fixed", (0, 1, 2)), ("Moved", (0, 2))):
            for axis in range(3):
                held = sorted(numbers[read.supports[member][:, axis]].tolist())
                self.assertEqual(held, nodes_of_set(text, member) if axis in axes else [])
        rows = np.flatnonzero(read.supports["Moved"][:, 0])
        self.assertEqual(set(read.given[rows, 0]), {0.25})
        self.assertEqual(np.abs(read.given[:, 1:]).max(), 0)

    def test_pressure(self):
        for order in (1, 2):
            self.document = new_document()
            part = self.box()
            analysis = self.analysis()
            self.fix(analysis, part, faces_at(part, 0, 0))
            self.add(analysis, ObjectsFem.makeConstraintPressure, "Pressure", [(part, faces_at(part, 2, 10))],
                     Pressure=quantity(3.0, "MPa"), Reversed=True)
            self.mesh(part, order=order)
            read, text = self.written(analysis)
            faces = pressed_faces_of(text)
            top = int((read.arrays["triangle_faces"] == int(faces_at(part, 2, 10)[0][4:]) - 1).sum())
            self.assertEqual(len(faces), top)
            self.assertEqual(set(faces.values()), {-3.0})
            np.testing.assert_allclose(read.loads.sum(axis=0), [0, 0, 3.0 * 800], atol=1e-6)

    def test_self_weight(self):
        part = self.box()
        analysis = self.analysis()
        self.fix(analysis, part, faces_at(part, 0, 0))
        weight = self.add(analysis, ObjectsFem.makeConstraintSelfWeight, "Weight", None)
        self.mesh(part)
        read, text = self.written(analysis)
        words = next(line for line in text.splitlines() if ",GRAV," in line).split(",")
        expected = float(words[2]) * np.array([float(word) for word in words[3:6]])
        np.testing.assert_allclose(statics_model.gravity(weight), expected, rtol=1e-12)
        np.testing.assert_allclose(read.loads.sum(axis=0), expected * 7.85e-9 * 8000, atol=1e-12)


@unittest.skipUnless(HAS_SOLVER and shutil.which("ccx"), "PETSc or CalculiX is not installed")
class AsCalculixFinds(Case):

    def compare(self, analysis):
        """Solves both ways and compares node by node. Returns our report."""
        fields, report = statics.solve(analysis)
        arrays = statics.arrays_of(analysis)
        result = solve(analysis)["result"]
        rows = np.argsort(arrays["node_numbers"])[np.argsort(np.argsort(result.NodeNumbers))]
        displacements = np.array([tuple(vector) for vector in result.DisplacementVectors])
        size = np.abs(displacements).max()
        np.testing.assert_allclose(fields["displacements"][rows], displacements, rtol=0, atol=1e-3 * size)
        self.assertLess(np.abs(fields["displacements"][rows] - displacements).max() / size, 1e-4)
        for title, column in (("XX", 0), ("YY", 1), ("ZZ", 2), ("XY", 3), ("YZ", 4), ("XZ", 5)):
            theirs = np.array(getattr(result, "NodeStress" + title))
            np.testing.assert_allclose(fields["stresses"][rows, column], theirs, rtol=0, atol=1e-3 * fields["von_mises"].max())
        np.testing.assert_allclose(fields["von_mises"][rows], result.vonMises, rtol=0, atol=1e-3 * fields["von_mises"].max())
        self.assertLess(report["energy_error"], 1e-6)
        return report

    def check_balance(self, analysis, report):
        read = statics_model.read(analysis, statics.mesh_of(analysis))
        pushed, held = read.loads.sum(axis=0), np.sum(list(report["responses"]["reactions_n"].values()), axis=0)
        self.assertLess(np.abs(pushed + held).max(), 1e-6 * np.abs(read.loads).sum())

    def test_drilled_box_of_both_orders(self):
        for order in (1, 2):
            with self.subTest(order=order):
                self.document = new_document()
                part = self.drilled_box()
                analysis = self.analysis()
                self.fix(analysis, part, faces_at(part, 0, 0))
                self.force(analysis, part, faces_at(part, 0, 40))
                self.add(analysis, ObjectsFem.makeConstraintPressure, "Pressure", [(part, faces_at(part, 2, 10))], Pressure=quantity(2.0, "MPa"))
                self.add(analysis, ObjectsFem.makeConstraintSelfWeight, "Weight", None)
                self.mesh(part, 4.0, order)
                report = self.compare(analysis)
                self.check_balance(analysis, report)
                self.assertEqual(len(report["warnings"]), 1 if order == 1 else 0)

    def test_random_boxes_with_random_loads(self):
        dice = random.Random(SEED)
        for turn in range(4):
            with self.subTest(seed=SEED, turn=turn):
                self.document = new_document()
                part = self.box(*(dice.uniform(5, 40) for _ in range(3)))
                analysis = self.analysis()
                ends = [part.Shape.BoundBox.XMax, part.Shape.BoundBox.YMax, part.Shape.BoundBox.ZMax]
                self.fix(analysis, part, faces_at(part, turn % 3, 0))
                self.force(analysis, part, faces_at(part, (turn + 1) % 3, ends[(turn + 1) % 3]), dice.uniform(10, 5000), along=dice.randrange(3))
                self.force(analysis, part, [edges_along(part, turn % 3)[1]], dice.uniform(10, 500), "Line", along=dice.randrange(3))
                self.add(analysis, ObjectsFem.makeConstraintPressure, "Pressure", [(part, faces_at(part, (turn + 2) % 3, 0))],
                         Pressure=quantity(round(dice.uniform(0.1, 20), 3), "MPa"))
                self.mesh(part, max(ends) / 6, 1 + turn % 2)
                self.check_balance(analysis, self.compare(analysis))

    def test_prescribed_displacement_and_two_materials(self):
        from BOPTools import SplitFeatures
        left, right = (self.document.addObject("Part::Box", name) for name in ("Left", "Right"))
        right.Placement.Base.x = 10
        part = SplitFeatures.makeBooleanFragments("Fragments")
        part.Objects, part.Mode = [left, right], "CompSolid"
        self.document.recompute()
        names = sorted(("Solid1", "Solid2"), key=lambda n: part.Shape.Solids[int(n[5:]) - 1].CenterOfMass.x)
        analysis = self.analysis([("Steel", STEEL, [(part, names[0])]), ("Soft", SOFT, [(part, names[1])])])
        self.fix(analysis, part, faces_at(part, 0, 0))
        moved = self.add(analysis, ObjectsFem.makeConstraintDisplacement, "Moved", [(part, faces_at(part, 0, 20))], xFree=False)
        moved.xDisplacement = quantity(0.1, "mm")
        self.mesh(part, 2.5, 2)
        report = self.compare(analysis)
        self.assertAlmostEqual(report["responses"]["mass_kg"], (7850 + 2700) * 1e-6, places=9)


@unittest.skipUnless(HAS_SOLVER, "PETSc is not installed")
class InTheDocument(Case):

    def test_result_is_freecads_own_and_has_its_figures(self):
        part, analysis = self.held_box()
        report = api.solve_analysis(analysis)
        result = self.document.getObject(report["result"])
        self.assertTrue(result.isDerivedFrom("Fem::FemResultObject"))
        self.assertEqual(len(result.NodeNumbers), result.Mesh.FemMesh.NodeCount)
        self.assertEqual(max(result.NodeNumbers), result.Mesh.FemMesh.NodeCount)
        found = report["responses"]
        self.assertAlmostEqual(max(result.vonMises), found["max_mises_mpa"], places=9)
        self.assertAlmostEqual(max(result.DisplacementLengths), found["max_displacement_mm"], places=12)
        self.assertAlmostEqual(max(result.PrincipalMax), result.Stats[11], places=9)
        self.assertAlmostEqual(found["mass_kg"], 7850e-9 * 8000, places=9)
        number = result.NodeNumbers[int(np.argmax(result.vonMises))]
        self.assertLess((result.Mesh.FemMesh.Nodes[number] - FreeCAD.Vector(*found["max_mises_at"]["mm"])).Length, 1e-12)
        again = api.solve_analysis(analysis)   # in the same object
        self.assertEqual(again["result"], report["result"])
        self.assertEqual(sum(obj.isDerivedFrom("Fem::FemResultObject") for obj in self.document.Objects), 1)

    def test_solutions_after_an_edit_reuse_the_last(self):
        part, analysis = self.held_box(2.0)
        first = api.solve_analysis(analysis, keep="test")
        self.assertFalse(first["reused"]["preconditioner"])
        part.Length = 40.5
        self.document.recompute()
        second, (_, anew) = api.solve_analysis(analysis, keep="test"), statics.solve(analysis)
        engine.load().forget_statics("test")
        self.assertGreater(second["reused"]["start_share"], 0.5)
        self.assertFalse(anew["reused"]["start_share"])
        for name in ("max_mises_mpa", "max_displacement_mm", "strain_energy_mj"):
            self.assertAlmostEqual(second["responses"][name] / anew["responses"][name], 1, delta=1e-5)

    def test_what_is_free_is_said(self):
        part = self.box()
        analysis = self.analysis()
        self.force(analysis, part, faces_at(part, 0, 40))
        self.mesh(part)
        with self.assertRaisesRegex(UserError, "move along x, y and z and turn about x, y and z: add a support"):
            statics.solve(analysis)
        bottom = self.add(analysis, ObjectsFem.makeConstraintDisplacement, "Bottom", [(part, faces_at(part, 2, 0))], zFree=False)
        with self.assertRaisesRegex(UserError, "the part can still move along x and y and turn about z: add a support"):
            statics.solve(analysis)
        self.document.removeObject(bottom.Name)
        self.add(analysis, ObjectsFem.makeConstraintFixed, "Hinge", [(part, [edges_along(part, 1)[0]])])
        with self.assertRaisesRegex(UserError, "the part can still turn about y: add a support"):
            statics.solve(analysis)

    def test_what_is_not_known_is_named_and_left_to_calculix(self):
        part, analysis = self.held_box(8.0)
        plane = ObjectsFem.makeConstraintPlaneRotation(self.document, "Plane")
        plane.References = [(part, faces_at(part, 1, 0))]
        analysis.addObject(plane)
        with self.assertRaisesRegex(statics.NotUnderstood, "only CalculiX knows Plane"):
            api.solve_analysis(analysis, "live")
        if shutil.which("ccx"):
            report = api.solve_analysis(analysis)
            self.assertEqual(report["solver"], "CalculiX")
            self.assertIn("only CalculiX knows Plane", " ".join(map(english, report["warnings"])))

    def foil(self, height):
        """The analysis of a square foil that is held at one side and pressed down."""
        part = self.document.addObject("Part::Box", "Foil")
        part.Length, part.Width, part.Height = 100, 100, height
        self.document.recompute()
        analysis = self.analysis()
        self.fix(analysis, part, faces_at(part, 0, 0))
        self.add(analysis, ObjectsFem.makeConstraintPressure, "Pressure", [(part, faces_at(part, 2, height))], Pressure=quantity(1e-6, "MPa"))
        self.mesh(part, 20, 2)
        return analysis

    def test_very_flat_elements_are_solved_by_a_factor(self):
        analysis = self.foil(0.1)
        report = api.solve_analysis(analysis, "live")
        self.assertEqual(report["matrix_solver"]["preconditioner"], "factor")
        self.assertAlmostEqual(report["responses"]["reactions_n"]["Fixed"][2], 0.01, places=8)
        if shutil.which("ccx"):
            theirs = api.solve_analysis(analysis, "ccx")
            for key in ("max_displacement_mm", "max_mises_mpa"):
                self.assertAlmostEqual(report["responses"][key] / theirs["responses"][key], 1, places=3)

    def test_a_foil_that_rounding_leaves_no_digits_of_is_left_to_calculix(self):
        analysis = self.foil(0.005)
        with self.assertRaisesRegex(engine.load().KernelError, "does not converge on this mesh; solve with CalculiX"):
            api.solve_analysis(analysis, "live")
        if shutil.which("ccx"):
            report = api.solve_analysis(analysis)
            self.assertEqual(report["solver"], "CalculiX")
            self.assertIn("does not converge", " ".join(map(english, report["warnings"])))

    def test_wrong_units_and_nothing_loaded(self):
        part, analysis = self.held_box(8.0)
        material = self.document.getObject("Steel")
        material.Material = dict(STEEL, YoungsModulus="210000 Pa")
        with self.assertRaisesRegex(UserError, "check its unit"):
            statics.solve(analysis)
        for values in ({}, {"Name": "None", "YoungsModulus": "210000 MPa"}, dict(STEEL, YoungsModulus="much")):   # OK in FEM's panel without a card gives the first
            material.Material = values
            with self.assertRaisesRegex(UserError, "Steel has no Young's modulus or no Poisson's ratio that is a number: choose a card that has both, or type them, in its panel$"):
                statics.solve(analysis)
        material.Material = dict(STEEL, PoissonRatio="0.499")
        with self.assertRaisesRegex(statics.NotUnderstood, "nearly incompressible"):
            statics.solve(analysis)
        material.Material = STEEL
        self.document.getObject("Force").Force = quantity(0, "N")
        fields, report = statics.solve(analysis)
        self.assertEqual(np.abs(fields["displacements"]).max(), 0)
        self.assertIn("loads nothing", " ".join(map(english, report["warnings"])))
        self.document.removeObject("Force")
        self.assertEqual([english(line) for line in statics.solve(analysis)[1]["warnings"]], ["nothing loads the part: add a force, a pressure or another load to the analysis"])

    def test_supports_and_loads_on_nothing(self):
        part, analysis = self.held_box(8.0)
        for make, name in ((ObjectsFem.makeConstraintFixed, "Empty"), (ObjectsFem.makeConstraintForce, "Idle"), (ObjectsFem.makeConstraintPressure, "Calm")):
            member = self.add(analysis, make, name, None)
            with self.assertRaisesRegex(UserError, "%s refers to nothing: choose faces, edges or vertices for it" % name):
                statics.solve(analysis)
            analysis.removeObject(member)
        analysis.removeObject(self.document.Steel)
        with self.assertRaisesRegex(UserError, "the analysis has no material: add one"):
            statics.solve(analysis)

    def test_slender_and_thin_parts_converge(self):
        rod, hollow = self.box(200, 1, 1), self.document.addObject("Part::Cut", "Hollow")
        hollow.Base, hollow.Tool = (self.document.addObject("Part::Box", name) for name in ("Outer", "Inner"))
        for box, sides, base in ((hollow.Base, (50, 40, 30), 0), (hollow.Tool, (48, 38, 29), 1)):
            box.Length, box.Width, box.Height = sides
            box.Placement.Base = FreeCAD.Vector(base, base, base)
        self.document.recompute()
        for part, end, size, order, most in ((rod, 200, 0.5, 2, 200), (hollow, 50, 3.0, 1, 200), (hollow, 50, 3.0, 2, 200)):
            analysis = self.analysis()
            self.fix(analysis, part, faces_at(part, 0, 0))
            self.force(analysis, part, faces_at(part, 0, end), 1.0)
            mesh = self.mesh(part, size, order)
            _, report = statics.solve(analysis)
            self.assertLess(report["iterations"], most, part.Name)
            self.assertLess(report["energy_error"], 1e-6)
            for name in [member.Name for member in analysis.Group] + [analysis.Name, mesh.Name]:
                if self.document.getObject(name):
                    self.document.removeObject(name)

    def test_command_gives_the_same_figures_either_way(self):
        part, analysis = self.held_box(8.0)
        self.add(analysis, ObjectsFem.makeConstraintDisplacement, "Moved", [(part, faces_at(part, 1, 0))], yFree=False)
        self.document.recompute()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "part.FCStd")
            self.document.saveAs(path)
            FreeCAD.closeDocument(self.document.Name)
            reports = {}
            for which in ("live", "ccx") if shutil.which("ccx") else ("live",):
                report = os.path.join(folder, which + ".json")
                done = cli.run({"command": "solve", "part": path, which: True, "json": report, "out": os.path.join(folder, which + ".FCStd")})
                self.assertEqual(done["exit_code"], 0, done["message"])
                with open(report, encoding="utf-8") as stream:
                    reports[which] = json.load(stream)
            live = reports["live"]
            self.assertEqual(set(live["seconds"]), {"read", "assemble", "setup", "solve", "stresses", "result", "total"})
            self.assertLess({"mass_kg", "max_mises_mpa", "max_mises_at", "max_displacement_mm", "max_displacement_at", "reactions_n", "strain_energy_mj"},
                            {*live["responses"], ""})
            self.assertLess({"iterations", "residual", "reused", "seconds"}, set(live))
            if "ccx" in reports:
                theirs = reports["ccx"]
                self.assertEqual(keys_of(live), keys_of(theirs))
                for name in ("max_mises_mpa", "max_displacement_mm", "strain_energy_mj", "mass_kg"):
                    self.assertAlmostEqual(live["responses"][name] / theirs["responses"][name], 1, delta=1e-3)
                self.assertEqual(live["responses"]["max_mises_at"], theirs["responses"]["max_mises_at"])
                for name in ("Fixed", "Moved"):
                    np.testing.assert_allclose(live["responses"]["reactions_n"][name], theirs["responses"]["reactions_n"][name], atol=0.1)
                self.assertEqual(theirs["matrix_solver"]["name"], "default")

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_calculix_gets_the_solver_for_the_size_unless_the_user_chose_one(self):
        _, analysis = self.held_box(8.0)
        before, calculix._MANY, calculix._BALANCED = (calculix._MANY, calculix._BALANCED), 100, 1e-5
        try:
            reports = {}
            for setting in ("default", "spooles", "iterativescaling"):
                self.document.Solver.MatrixSolverType = setting
                self.assertEqual(calculix.solves_iteratively(self.document.Solver, calculix.as_arrays(analysis)), setting != "spooles")
                reports[setting] = api.solve_analysis(analysis, "ccx")
                self.assertEqual(self.document.Solver.MatrixSolverType, setting)
        finally:
            calculix._MANY, calculix._BALANCED = before
        self.document.Solver.MatrixSolverType = "default"
        self.assertFalse(calculix.solves_iteratively(self.document.Solver, calculix.as_arrays(analysis)))   # few unknowns
        self.assertEqual([report["matrix_solver"]["name"] for report in reports.values()], ["iterativecholesky", "spooles", "iterativescaling"])
        for setting, report in reports.items():
            self.assertEqual(any("reactions are off by" in line["template"] for line in report["warnings"]), setting != "spooles")
            for name in ("max_mises_mpa", "strain_energy_mj"):
                self.assertAlmostEqual(report["responses"][name] / reports["spooles"]["responses"][name], 1, delta=1e-3)

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_results_read_as_arrays_are_those_that_freecad_reads(self):
        _, analysis = self.held_box(8.0)
        mesh = self.document.FeatureMesh
        self.document.Box.Length = 41   # so that numbers have gaps
        self.document.recompute()
        report = api.solve_analysis(analysis, "ccx")
        ours = self.document.getObject(report["result"])
        values = {name: getattr(ours, name) for name in SCALARS}
        points = ours.Mesh.FemMesh.Nodes
        theirs = solve(analysis)["result"]
        order = np.argsort(mesh.Proxy.arrays(mesh)["node_numbers"])
        for name in SCALARS:
            there = np.array(getattr(theirs, name))
            np.testing.assert_allclose(np.array(values[name])[order], there, atol=2e-5 * max(np.abs(there).max(), 1e-12), err_msg=name)
        mine, others = (np.array([tuple(nodes[number]) for number in sorted(nodes)]) for nodes in (points, theirs.Mesh.FemMesh.Nodes))
        np.testing.assert_allclose(mine[order], others, atol=1e-4)


@unittest.skipUnless(HAS_SOLVER, "PETSc is not installed")
class OnTheArrays(Case):
    """What the elements and the solver promise, on a mesh with a curved face and tets of all shapes."""

    def arrays(self, order, size=4.0):
        part = self.drilled_box()
        return self.mesh(part, size, order).Proxy.arrays(self.document.FeatureMesh)

    def model(self, arrays, held, displacement):
        count = len(arrays["points"])
        return {"materials": np.array([[210000.0, 0.3, 7.85e-9]]), "tet_materials": np.zeros(len(arrays["tets"]), dtype=np.int32),
                "loads": np.zeros((count, 3)), "held": np.repeat(held[:, None], 3, axis=1),
                "given": np.where(held[:, None], displacement(arrays["points"]), 0.0)}

    def test_patch_test(self):
        """A linear displacement of the boundary: the inside follows it, and the stress is the same everywhere."""
        gradient = np.array([[1e-3, 2e-4, 0], [0, -3e-4, 1e-4], [4e-4, 0, 5e-4]])
        strain, shear = (gradient + gradient.T) / 2, 210000 / 2.6
        stress = 210000 * 0.3 / (1.3 * 0.4) * np.trace(strain) * np.eye(3) + 2 * shear * strain
        expected = [stress[0, 0], stress[1, 1], stress[2, 2], stress[0, 1], stress[1, 2], stress[2, 0]]
        for order in (1, 2):
            with self.subTest(order=order):
                self.document = new_document()
                arrays = self.arrays(order)
                boundary = arrays["entities"][:, 0] < 3
                self.assertGreater((~boundary).sum(), 20)
                found = engine.load().solve_statics(arrays, self.model(arrays, boundary, lambda points: points @ gradient.T))
                np.testing.assert_allclose(found["displacements"], arrays["points"] @ gradient.T, atol=1e-6)
                np.testing.assert_allclose(found["stresses"], np.tile(expected, (len(found["stresses"]), 1)), atol=1e-4 * 400)
                self.assertLess(found["discretisation_error"], 1e-4)   # the mesh has it exactly

    def test_rigid_motions_give_no_stress(self):
        turn = np.array([0.3, -0.2, 0.5])
        for order in (1, 2):
            with self.subTest(order=order):
                self.document = new_document()
                arrays = self.arrays(order)
                everywhere = np.ones(len(arrays["points"]), dtype=bool)
                found = engine.load().solve_statics(arrays, self.model(arrays, everywhere, lambda points: [1.0, 2.0, -3.0] + np.cross(turn, points)))
                self.assertLess(np.abs(found["stresses"]).max(), 1e-8 * 210000)
                self.assertLess(np.abs(found["reactions"]).max(), 1e-8 * 210000)

    def test_same_bytes_for_any_number_of_threads(self):
        arrays = self.arrays(1, 1.5)
        model = self.model(arrays, arrays["points"][:, 0] == 0, np.zeros_like)
        model["loads"][:, 2] = -1.0
        self.assertGreater(len(arrays["points"]), 2000)   # of which several threads get a part
        first, *others = (engine.load().solve_statics(arrays, model, threads=threads) for threads in (1, 2, 4, 1, 1, 2, 2, 4, 4))   # and anywhere in memory
        for other in others:
            for name in ("displacements", "stresses", "reactions"):
                self.assertEqual(other[name].tobytes(), first[name].tobytes(), name)

    def test_solutions_asked_for_at_the_same_time_are_made_one_after_another(self):
        """PETSc itself can neither start nor solve on two threads at a time."""
        arrays = self.arrays(1, 4.0)
        model = self.model(arrays, arrays["points"][:, 0] == 0, np.zeros_like)
        model["loads"][:, 2] = -1.0

        def solve(key):
            found = [engine.load().solve_statics(arrays, model, keep=key)["displacements"].tobytes() for _ in range(3)]
            engine.load().forget_statics(key)
            return found[0]
        with concurrent.futures.ThreadPoolExecutor(4) as threads:
            self.assertEqual(len(set(threads.map(solve, ("", "one", "two", "three")))), 1)

    def test_cantilever_comes_to_the_beam_with_shear(self):
        length, side, force = 100.0, 10.0, 1000.0
        truth = force * length ** 3 / (3 * 210000 * side ** 4 / 12) + force * length / (5 / 6 * 105000 * side ** 2)
        part = self.box(length, side, side)
        analysis = self.analysis([("Steel", dict(STEEL, PoissonRatio="0"), ())])
        self.fix(analysis, part, faces_at(part, 0, 0))
        self.force(analysis, part, faces_at(part, 0, length), force)
        mesh, errors, estimates = self.mesh(part, 10.0, 2), [], []
        for size in (10.0, 5.0):
            mesh.Size = size
            self.document.recompute()
            fields, report = statics.solve(analysis)
            errors.append(abs(np.abs(fields["displacements"][:, 2]).max() / truth - 1))
            estimates.append(report["mesh_error"])
        self.assertLess(errors[1], errors[0])
        self.assertLess(errors[1], 1e-3)
        self.assertLess(estimates[1], estimates[0])
        mesh.Order = "1st"
        self.document.recompute()
        fields, report = statics.solve(analysis)
        missing = 1 - np.abs(fields["displacements"][:, 2]).max() / truth   # of the energy, which the estimate's square is of
        self.assertTrue(0.5 < report["mesh_error"] / np.sqrt(missing) < 1.5, (report["mesh_error"], missing))
        self.assertIn("too stiff in bending", " ".join(map(english, report["warnings"])))
        self.assertIn("%.0f %%" % (100 * report["mesh_error"]), " ".join(map(english, report["warnings"])))

    def test_impossible_models_are_refused(self):
        arrays = self.arrays(1, 10.0)
        for change in ({"materials": np.array([[210000.0, 0.5, 0]])}, {"materials": np.array([[-1.0, 0.3, 0]])},
                       {"loads": np.full((len(arrays["points"]), 3), np.nan)}, {"loads": np.zeros((3, 3))}):
            model = {**self.model(arrays, arrays["points"][:, 0] == 0, np.zeros_like), **change}
            with self.assertRaises(engine.load().InputError):
                engine.load().solve_statics(arrays, model)

    def test_indices_are_not_cut(self):
        arrays, ours = self.arrays(1, 10.0), engine.load()
        faces, steel = np.arange(3), np.array([[210000.0, 0.3, 7.85e-9]])
        pressure = ours.statics_pressure(arrays, faces, 2.0)
        self.assertGreater(np.abs(pressure).max(), 0)
        self.assertTrue((ours.statics_pressure(arrays, faces.tolist(), 2.0) == pressure).all())
        tets = np.zeros(len(arrays["tets"]))
        model = self.model(arrays, arrays["points"][:, 0] == 0, np.zeros_like)
        for added in (2 ** 32, 0.5):
            for call in (lambda: ours.statics_pressure(arrays, faces + added, 2.0), lambda: ours.statics_area_shares(arrays, faces + added),
                         lambda: ours.statics_length_shares(arrays, faces + added), lambda: ours.statics_weight(arrays, steel, tets + added, [0, 0, -9810]),
                         lambda: ours.solve_statics(arrays, {**model, "tet_materials": tets + added})):
                with self.assertRaisesRegex(ours.InputError, "whole numbers below 2"):
                    call()


class FreeMotions(Case):
    """Of arrays alone: which rigid motions some held components leave."""

    def free(self, held_rows):
        part = self.box()
        arrays = self.mesh(part, 10.0).Proxy.arrays(self.document.FeatureMesh)
        held = np.zeros((len(arrays["points"]), 3), dtype=bool)
        for rows, axis in held_rows(arrays["points"]):
            held[rows, axis] = True
        motions, _, _ = statics_supports.free_motions(arrays, held)
        return motions

    def test_three_points_in_one_plane_hold_half(self):
        def rows(points):
            return [(np.flatnonzero(points[:, 2] == 0)[:3], 2)]
        self.assertEqual(self.free(rows).shape[2], 3)

    def test_six_well_chosen_components_hold_all(self):
        def rows(points):
            at = {tuple(point): i for i, point in enumerate(points.round(9).tolist())}
            a, b, c = at[0, 0, 0], at[40, 0, 0], at[0, 20, 0]
            return [([a], 0), ([a, b], 1), ([a, b, c], 2)]
        self.assertEqual(self.free(rows).shape[2], 0)
        self.assertIsNone(statics_supports.in_words(self.free(lambda points: [(np.arange(len(points)), axis) for axis in range(3)])))


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of faces: in the document, in every format, and solved by CalculiX as shells, as FreeCAD's own examples are."""
import json
import os
import shutil
import tempfile
import unittest

import Fem
import FreeCAD
import numpy as np
import ObjectsFem
import Part
from analyses import add_material, add_solver, quantity, solve, solver_of
from freecad.featuremesh import api, export, mesh_object, overlays, solve_guard, statics, versions
from freecad.featuremesh.errors import UserError
from freecad.featuremesh.messages import english
from parts import groups_in_freecad, groups_of, new_document, placement, plate_with_hole, rectangle
from remeshed_examples import STEEL, WITHIN, RemeshedExamples


def square_pipe(document, height=100.0):
    """A Part::Extrusion of a square of 40 mm, open at both ends; "Pipe"."""
    sketch = document.addObject("Sketcher::SketchObject", "Square")
    rectangle(sketch, 0, 0, 40, 40)
    pipe = document.addObject("Part::Extrusion", "Pipe")
    pipe.Base, pipe.DirMode, pipe.LengthFwd, pipe.Solid = sketch, "Normal", height, False
    document.recompute()
    return pipe


def triangles_of(mesh):
    """{number: (nodes per triangle, 3) points}."""
    arrays = mesh.Proxy.arrays(mesh)
    return {int(number): arrays["points"][nodes] for number, nodes in zip(arrays["triangle_numbers"], arrays["triangles"])}


def count_kept(before, after):
    return sum(number in before and np.array_equal(before[number], points) for number, points in after.items())


def edge_at(shape, z):
    """Names of the edges all of whose points are at that height."""
    return ["Edge%d" % (i + 1) for i, edge in enumerate(shape.Edges) if abs(edge.BoundBox.ZMin - z) < 1e-6 and abs(edge.BoundBox.ZMax - z) < 1e-6]


class ShellMeshes(unittest.TestCase):

    def test_an_extruded_wire_is_meshed_with_triangles(self):
        for order, corners in ((1, 3), (2, 6)):
            pipe = square_pipe(new_document())
            mesh = api.add_mesh(pipe, 10, order)
            pipe.Document.recompute()
            self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
            self.assertEqual((mesh.FemMesh.VolumeCount, mesh.FemMesh.FaceCount), (0, mesh.TetCount))
            self.assertGreater(mesh.TetCount, 300)
            self.assertEqual(len(mesh.FemMesh.getElementNodes(mesh.FemMesh.Faces[0])), corners)
            self.assertGreater(mesh.MinDihedral.Value, 30)
            self.assertGreater(mesh.MeanRadiusRatio, 0.9)
            names = set(groups_of(mesh))
            self.assertTrue({"Face1", "Face4", "Edge1", "Face1_Nodes"} <= names)
            off = max(pipe.Shape.distToShape(Part.Vertex(point))[0] for point in list(mesh.FemMesh.Nodes.values())[::7])
            self.assertLess(off, 1e-7)

    def test_an_edit_keeps_the_rest_and_loads_follow(self):
        document = new_document()
        pipe = square_pipe(document)
        analysis = ObjectsFem.makeAnalysis(document, "Analysis")
        fixed, load = ObjectsFem.makeConstraintFixed(document, "Fixed"), ObjectsFem.makeConstraintForce(document, "Load")
        low, high = edge_at(pipe.Shape, 0), edge_at(pipe.Shape, 100)
        fixed.References, load.References = [(pipe, name) for name in low], [(pipe, name) for name in high]
        analysis.addObject(fixed), analysis.addObject(load)
        mesh = api.add_mesh(pipe, 8, active_analysis=analysis)
        document.recompute()
        before = triangles_of(mesh)
        pipe.LengthFwd = 120
        document.recompute()
        self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
        after = triangles_of(mesh)
        self.assertGreater(count_kept(before, after), 0.6 * len(before))
        self.assertGreaterEqual(mesh.KeptTets, 50)
        for member, names in ((fixed, edge_at(pipe.Shape, 0)), (load, edge_at(pipe.Shape, 120))):
            self.assertEqual(sorted(sub for _, subs in member.References for sub in subs), sorted(names))
        nodes = groups_in_freecad(mesh)["Load_Nodes"]
        self.assertGreater(len(nodes), 20)
        self.assertTrue(all(abs(mesh.FemMesh.Nodes[node].z - 120) < 1e-9 for node in nodes))

    def test_a_solid_that_an_edit_opens_is_said_to_be_a_shell(self):
        pipe = square_pipe(new_document(), 20)
        pipe.Solid = True
        pipe.Document.recompute()
        mesh = api.add_mesh(pipe, 10, order=1)

        def warned():
            pipe.Document.recompute()
            return [text for text in map(english, json.loads(mesh.Report)["warnings"]) if "any more" in text]
        self.assertEqual(warned(), [])
        pipe.Solid = False
        self.assertEqual(warned(), ["Pipe has no solid any more: its faces are meshed, and loads and results are those of a shell. Mend the part if it is to be a solid."])
        for solid, dimension in ((False, "Faces"), (True, "Solids"), (True, "Faces"), (True, "From shape")):   # the user's choice, and what is more than before
            pipe.Solid, mesh.Dimension = solid, dimension
            self.assertEqual(warned(), [])

    def test_a_sheet_that_moved_carries_its_mesh(self):
        document = new_document()
        pipe = square_pipe(document)
        plane = document.addObject("Part::Plane", "Plane")
        plane.Length = plane.Width = 60
        plane.Placement = placement(0, 0, -30)
        both = document.addObject("Part::Compound", "Both")
        both.Links = [pipe, plane]
        document.recompute()
        mesh = api.add_mesh(both, 6)
        document.recompute()
        numbers = set(triangles_of(mesh))
        plane.Placement = placement(25, 0, -30)
        document.recompute()
        self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
        self.assertEqual(set(triangles_of(mesh)), numbers)
        self.assertEqual(mesh.KeptTets, 100)

    def test_the_faces_of_a_body_as_asked(self):
        document = new_document()
        body = plate_with_hole(document)
        mesh = api.add_mesh(body, 3, dimension="Faces")
        document.recompute()
        self.assertEqual((mesh.FemMesh.VolumeCount, mesh.FemMesh.FaceCount), (0, mesh.TetCount))
        before = triangles_of(mesh)
        document.HoleSketch.setDatum("X", 24)
        document.recompute()
        self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
        self.assertGreater(count_kept(before, triangles_of(mesh)), 0.4 * len(before))
        mesh.Dimension = "Solids"
        self.assertEqual(mesh.Status, mesh_object.SETTINGS_CHANGED)
        document.recompute()
        self.assertGreater(mesh.FemMesh.VolumeCount, 0)

    def test_a_document_that_was_saved_updates_as_locally(self):
        document = new_document()
        pipe = square_pipe(document)
        mesh = api.add_mesh(pipe, 8)
        document.recompute()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "pipe.FCStd")
            document.saveAs(path)
            FreeCAD.closeDocument(document.Name)
            document = FreeCAD.openDocument(path)
            mesh = api.find_mesh(document)
            before = triangles_of(mesh)
            document.Pipe.LengthFwd = 110
            document.recompute()
            self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
            self.assertGreater(count_kept(before, triangles_of(mesh)), 0.6 * len(before))
            self.assertIsNone(json.loads(mesh.Report)["fallback"])
            FreeCAD.closeDocument(document.Name)

    def test_quality_and_what_the_update_kept(self):
        document = new_document()
        pipe = square_pipe(document)
        mesh = api.add_mesh(pipe, 8)
        document.recompute()
        for measure in ("dihedral_angle", "radius_ratio", "aspect_ratio", "scaled_jacobian", "skewness", "size_ratio"):
            overlay = overlays.quality(mesh, measure)
            self.assertEqual(len(overlay.values), mesh.TetCount)
            corners, colours = overlay.drawn()
            self.assertEqual(corners.shape, (mesh.TetCount, 3, 3))
        self.assertAlmostEqual(overlays.quality(mesh, "dihedral_angle").values.min(), mesh.MinDihedral.Value, places=3)
        self.assertAlmostEqual(overlays.quality(mesh, "radius_ratio").values.mean(), mesh.MeanRadiusRatio, places=6)
        pipe.LengthFwd = 120
        document.recompute()
        self.assertEqual(int(100 * overlays.kept(mesh).kept.mean()), mesh.KeptTets)

    def test_the_live_solver_and_wrong_dimensions_say_so(self):
        document = new_document()
        pipe = square_pipe(document)
        with self.assertRaisesRegex(UserError, "dimension"):
            api.add_mesh(pipe, 8, dimension="Shells")
        mesh = api.add_mesh(pipe, 8, dimension="Solids")
        with self.assertRaisesRegex(Exception, "no solid"):
            api.update_mesh(mesh)
        mesh.Dimension = "From shape"
        analysis = ObjectsFem.makeAnalysis(document, "Analysis")
        analysis.addObject(mesh)
        add_material(document, analysis, "Steel", STEEL)
        api.update_mesh(mesh)
        with self.assertRaisesRegex(statics.NotUnderstood, "solids only"):
            statics.solve(analysis)


class ShellFiles(unittest.TestCase):

    def test_every_format_holds_the_triangles(self):
        for order in (1, 2):
            document = new_document()
            mesh = api.add_mesh(square_pipe(document), 10, order)
            document.recompute()
            with tempfile.TemporaryDirectory() as folder:
                for file_format in export.FORMATS:
                    if (file_format, order) == ("z88", 1):
                        with self.assertRaisesRegex(UserError, "6-node"):
                            api.export_mesh(mesh, os.path.join(folder, "pipe.z88"))
                        continue
                    path = os.path.join(folder, "pipe." + file_format)
                    api.export_mesh(mesh, path, file_format)
                    with self.subTest(file_format=file_format, order=order):
                        self.assertEqual(self.triangles_in(path, file_format, order), mesh.TetCount)

    def triangles_in(self, path, file_format, order):
        if file_format == "stl":
            with open(path, "rb") as stream:
                stream.seek(80)
                return int(np.frombuffer(stream.read(4), dtype="<u4")[0]) // (4 if order == 2 else 1)
        if file_format in ("inp", "unv", "med", "vtk", "vtu", "z88") or (file_format, order) == ("bdf", 1):
            return Fem.read(path).FaceCount
        if file_format == "bdf":   # FreeCAD reads no CTRIA6
            with open(path, encoding="ascii") as stream:
                return sum(line.startswith("CTRIA6  ") for line in stream)
        with open(path, encoding="utf-8") as stream:
            lines = stream.read().split("$Elements\n")[1].split("\n")
        kinds = {1: "2", 2: "9"}
        return sum(int(line.split()[3]) for line in lines if len(line.split()) == 4 and line.split()[0] == "2" and line.split()[2] == kinds[order])


# (example, in each run)
EXAMPLES = [("ccx_cantilever_ele_tria6", True), ("square_pipe_end_twisted_edgeforces", True)]


@unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
class ShellsSolved(RemeshedExamples, unittest.TestCase):

    def test_our_shells_give_the_figures_of_the_examples(self):
        self.check_examples("shell", "triangles", EXAMPLES)

    def meshing_of(self, part, fem_mesh):
        return fem_mesh.FaceCount, (part.Shape.Area / fem_mesh.FaceCount * 2.3) ** 0.5, 2

    def cantilever(self):
        """Sheet metal 8 mm thick, 200 mm long and 50 mm wide, 100 N at its end; the sheet, the analysis and the mesh."""
        document = new_document()
        sheet = document.addObject("Part::Plane", "Sheet")
        sheet.Length, sheet.Width = 200, 50
        document.recompute()
        analysis = ObjectsFem.makeAnalysis(document, "Analysis")
        add_solver(document, analysis)
        add_material(document, analysis, "Steel", {**STEEL, "PoissonRatio": "0.0"})
        analysis.addObject(ObjectsFem.makeElementGeometry2D(document, 8.0, "Thickness"))
        fixed, load = ObjectsFem.makeConstraintFixed(document, "Fixed"), ObjectsFem.makeConstraintForce(document, "Load")
        at = {x: next("Edge%d" % (i + 1) for i, edge in enumerate(sheet.Shape.Edges) if abs(edge.CenterOfMass.x - x) < 1e-6) for x in (0, 200)}
        fixed.References, load.References = [(sheet, at[0])], [(sheet, at[200])]
        load.Force = quantity(100.0, "N")
        load.DirectionVector = FreeCAD.Vector(0, 0, -1)
        analysis.addObject(fixed), analysis.addObject(load)
        mesh = api.add_mesh(sheet, 10, active_analysis=analysis)
        document.recompute()
        return sheet, analysis, mesh

    def test_stresses_are_those_in_the_middle_unless_asked_for_outside(self):
        _, analysis, _ = self.cantilever()
        solver_of(analysis).BeamShellResultOutput3D = False   # as FreeCAD 0.20 has it unless asked
        report = api.solve_analysis(analysis)
        said = " ".join(map(english, report["warnings"]))
        self.assertRegex(said, "solids only")
        self.assertRegex(said, "middle of the thickness")
        self.assertLess(report["responses"]["max_mises_mpa"], 10)
        solver_of(analysis).BeamShellResultOutput3D = True
        report = api.solve_analysis(analysis)
        self.assertNotRegex(" ".join(map(english, report["warnings"])), "middle of the thickness")
        self.assertAlmostEqual(report["responses"]["max_mises_mpa"] / (100 * 200 / (50 * 8 ** 2 / 6)), 1, delta=0.15)

    def test_an_edit_and_a_second_solution(self):
        """The sheet becomes a quarter longer: F L^3 / 3 E I."""
        sheet, analysis, mesh = self.cantilever()
        document = sheet.Document
        force = self.force_in(analysis)
        for length in (200, 250):
            sheet.Length = length
            document.recompute()
            self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
            expected = force * length ** 3 / (3 * 210000 * 50 * 8 ** 3 / 12)
            self.assertLess(abs(solve(analysis)["displacement"] / expected - 1), WITHIN)
        self.assertGreater(mesh.KeptTets, 70)

    def test_a_pressure_pushes_against_the_face_before_and_after_an_edit(self):
        sheet, analysis, mesh = self.cantilever()
        document = sheet.Document
        document.Load.Force = quantity(1e-6, "N")
        pressure = ObjectsFem.makeConstraintPressure(document, "Pressure")
        pressure.References, pressure.Pressure = [(sheet, "Face1")], quantity(0.01, "MPa")
        analysis.addObject(pressure)
        for length in (200, 250):
            sheet.Length = length
            document.recompute()
            self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
            found = api.solve_analysis(analysis)
            expected = 0.01 * 50 * length ** 4 / (8 * 210000 * 50 * 8 ** 3 / 12)
            self.assertLess(abs(found["responses"]["max_displacement_mm"] / expected - 1), WITHIN)
            self.assertLess(min(vector.z for vector in document.getObject(found["result"]).DisplacementVectors), -0.9 * expected)   # its normal is z

    def test_heat_that_flows_into_shells(self):
        """It leaves at the edge that is kept at 300 K, so that the other end gets warmer by flux * length^2 / (2 conductivity * thickness). What of it is not written is
        named."""
        sheet, analysis, mesh = self.cantilever()
        document, solver = sheet.Document, solver_of(analysis)
        solver.AnalysisType, solver.ThermoMechSteadyState = "thermomech", True
        document.Steel.Material = {**STEEL, "ThermalConductivity": "50 W/m/K", "SpecificHeat": "590 J/kg/K", "ThermalExpansionCoefficient": "0.000012 m/m/K"}
        flux, warm = ObjectsFem.makeConstraintHeatflux(document, "Flux"), ObjectsFem.makeConstraintTemperature(document, "Warm")
        flux.References, warm.References = [(sheet, "Face1")], document.Fixed.References
        flux.ConstraintType, flux.DFlux = "DFlux", 1000 if versions.version() < (1, 1) else "1000 W/m^2"
        for member in (flux, warm, ObjectsFem.makeConstraintInitialTemperature(document, "Before")):
            analysis.addObject(member)
        for order, length in (("2nd", 200), ("1st", 250)):
            mesh.Order, sheet.Length = order, length
            document.recompute()
            found = api.solve_analysis(analysis)["responses"]["max_temperature_k"]
            self.assertAlmostEqual((found - 300) / (1000 * (length / 1000) ** 2 / (2 * 50 * 0.008)), 1, delta=WITHIN)
        if versions.version() < (1, 1):
            flux.References = document.Load.References   # an edge
            self.assertRegex(" ".join(map(english, api.solve_analysis(analysis)["warnings"])), "CalculiX got nothing of Flux, for which FreeCAD found no elements")

    def test_a_new_face_without_a_thickness_is_named(self):
        """One thickness is for all faces, several are for those that they name; CalculiX ends where an element has none."""
        pipe = square_pipe(new_document())
        document = pipe.Document
        analysis, mesh = ObjectsFem.makeAnalysis(document, "Analysis"), api.add_mesh(pipe, 10)
        thicknesses = [ObjectsFem.makeElementGeometry2D(document, value, "Thickness") for value in (2, 3)]
        for member in (mesh, *thicknesses):
            analysis.addObject(member)
        thicknesses[0].References, thicknesses[1].References = [(pipe, ("Face1", "Face2"))], [(pipe, ("Face3", "Face4"))]
        document.recompute()
        self.assertEqual(solve_guard.reason(analysis), "")
        pipe.Base.addGeometry(Part.LineSegment(FreeCAD.Vector(), FreeCAD.Vector(-20, -20, 0)))
        document.recompute()
        self.assertIn("has no shell thickness", solve_guard.reason(analysis))
        thicknesses[1].References = []
        self.assertEqual(solve_guard.reason(analysis), "")

    def force_in(self, analysis):
        """N, the sum of what the input file has."""
        lines = solve(analysis)["input"].split("*CLOAD")[1].split("***")[0].splitlines()
        return float(np.linalg.norm(np.sum([np.eye(3)[int(words[1]) - 1] * float(words[2]) for words in (line.split(",") for line in lines[1:])
                                            if len(words) == 3], axis=0)))

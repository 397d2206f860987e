# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of edges: in the document, in the formats that hold them, and solved by CalculiX as beams, as FreeCAD's own examples are."""
import os
import shutil
import tempfile
import unittest

import Fem
import FreeCAD
import numpy as np
import ObjectsFem
import Part
from analyses import add_material, add_solver, quantity, solve
from femmesh.meshsetsgetter import MeshSetsGetter
from femtools.membertools import AnalysisMember
from freecad.featuremesh import api, export, mesh_object, overlays
from freecad.featuremesh.errors import UserError
from parts import groups_of, new_document, plate_with_hole
from remeshed_examples import STEEL, WITHIN, RemeshedExamples
from test_references import names_of


def line(document, length=200.0):
    obj = document.addObject("Part::Line", "Axis")
    obj.X2, obj.Y2, obj.Z2 = length, 0, 0
    document.recompute()
    return obj


def segments_of(mesh):
    """{number: (2, 3) points}."""
    arrays = mesh.Proxy.arrays(mesh)
    return {int(number): arrays["points"][nodes] for number, nodes in zip(arrays["segment_numbers"], arrays["segments"])}


class BeamMeshes(unittest.TestCase):

    def test_a_line_is_meshed_with_segments_and_an_edit_keeps_the_others(self):
        for order, nodes in ((1, 2), (2, 3)):
            document = new_document()
            frame = document.addObject("Part::Feature", "Frame")
            frame.Shape = Part.makePolygon([(0, 0, 0), (0, 0, 30), (80, 0, 30), (80, 0, 0)])
            mesh = api.add_mesh(frame, 5, order)
            document.recompute()
            self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
            self.assertEqual((mesh.FemMesh.VolumeCount, mesh.FemMesh.FaceCount, mesh.FemMesh.EdgeCount), (0, 0, 28))
            self.assertEqual(mesh.TetCount, 28)
            self.assertEqual(len(mesh.FemMesh.getElementNodes(mesh.FemMesh.Edges[0])), nodes)
            names = set(groups_of(mesh))
            self.assertTrue({"Edge1", "Edge2_Nodes", "Edge3"} <= names)
            before = segments_of(mesh)
            frame.Shape = Part.makePolygon([(0, 0, 0), (0, 0, 30), (90, 0, 30), (90, 0, 0)])
            document.recompute()
            kept = [number for number, points in segments_of(mesh).items() if number in before and np.array_equal(before[number], points)]
            self.assertGreater(len(kept), 18)

    def test_a_load_on_an_edge_on_which_another_one_lies(self):
        """Where the edge grows the other one, which stays, is no piece of it."""
        document = new_document()
        frame = document.addObject("Part::Feature", "Frame")

        def shape(length):
            ends = ((0, 0, 0), (0, 0, 0.5)), ((0, 0, 0), (0, 0, length)), ((0, 0, length), (20, 0, length)), ((20, 0, length), (20, 0, 0))
            return Part.makeCompound([Part.makeLine(*pair) for pair in ends])

        frame.Shape = shape(30)
        mesh = api.add_mesh(frame, 5, 1)
        analysis = ObjectsFem.makeAnalysis(document)
        analysis.addObject(mesh)
        loads = [ObjectsFem.makeConstraintFixed(document, "On%d" % number) for number in range(1, 5)]
        for number, load in enumerate(loads, 1):
            load.References = [(frame, "Edge%d" % number)]
            analysis.addObject(load)
        document.recompute()
        frame.Shape = shape(34)
        document.recompute()
        self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
        self.assertEqual([load.References for load in loads], [[(frame, ("Edge%d" % number,))] for number in range(1, 5)])

    def loads_on(self, names, shape):
        """A frame of that shape with a mesh and a load on each of its sub-elements, by name."""
        document = new_document()
        frame = document.addObject("Part::Feature", "Frame")
        frame.Shape = shape
        mesh = api.add_mesh(frame, 5, 1)
        analysis = ObjectsFem.makeAnalysis(document)
        analysis.addObject(mesh)
        loads = {name: ObjectsFem.makeConstraintForce(document, "On" + name) for name in names}
        for name, load in loads.items():
            load.References = [(frame, name)]
            analysis.addObject(load)
        document.recompute()
        return frame, loads

    def check(self, frame, loads, shape, now):
        frame.Shape = shape
        frame.Document.recompute()
        self.assertEqual({name: [sub for _, sub in names_of(load)] for name, load in loads.items()}, now)

    def test_a_line_is_deleted_and_another_one_drawn(self):
        """The other line is no stranger's, and the new one not the one that was there."""
        frame, loads = self.loads_on(["Edge1", "Edge2", "Vertex1"], Part.makePolygon([(0, 0, 0), (0, 0, 30), (20, 0, 40)]))
        self.check(frame, loads, Part.makePolygon([(0, 0, 30), (20, 0, 40)]), {"Edge1": [], "Edge2": ["Edge1"], "Vertex1": []})
        self.assertEqual(loads["Edge1"].LostReferences, ["Edge1"])
        self.check(frame, loads, Part.makePolygon([(0, 0, 30), (20, 0, 40), (33, 0, 40)]), {"Edge1": [], "Edge2": ["Edge1"], "Vertex1": []})

    def test_one_of_two_wires_is_moved_and_turned(self):
        points = [(40, 0, 0), (60, 0, 0), (70, 0, 20), (75, 0, 50)]
        moved = [(40, 9, 0), (40, 29, 0), (40, 39, 20), (40, 44, 50)]
        other = Part.makePolygon([(0, 0, 0), (0, 0, 30), (20, 0, 40)])
        names = ["Edge1", "Edge3", "Edge4", "Edge5", "Vertex3", "Vertex4", "Vertex5", "Vertex7"]
        frame, loads = self.loads_on(names, Part.makeCompound([other, Part.makePolygon(points)]))
        self.check(frame, loads, Part.makeCompound([other, Part.makePolygon(moved)]), {name: [name] for name in names})
        self.check(frame, loads, Part.makeCompound([other, Part.makePolygon([*moved, (40, 60, 60)])]), {name: [name] for name in names})

    def test_a_beam_between_two_of_another_section(self):
        """Its nodes are theirs."""
        document = new_document()
        frame = document.addObject("Part::Feature", "Frame")
        frame.Shape = Part.makePolygon([(0, 0, 0), (30, 0, 0), (30, 10, 0), (60, 10, 0)])
        mesh = api.add_mesh(frame, 10, 1)
        analysis = ObjectsFem.makeAnalysis(document)
        analysis.addObject(mesh)
        add_solver(document, analysis)
        add_material(document, analysis, "Steel", STEEL)
        for kind, names in (("Circular", ["Edge1", "Edge3"]), ("Rectangular", ["Edge2"])):
            section = ObjectsFem.makeElementGeometry1D(document, kind, name=kind)
            section.References = [(frame, names)]
            analysis.addObject(section)
        document.recompute()
        getter = MeshSetsGetter(analysis, analysis.Group[1], mesh, AnalysisMember(analysis))
        getter.theshape = None   # as in 1.x of a mesh that 0.20 made
        getter.get_mesh_sets()
        self.assertEqual([len(entry["ids"]) for entry in getter.member.geos_beamrotation[0]["FEMRotations1D"]], [6, 1])
        self.assertEqual({entry["Object"].Name: len(entry["FEMElements"]) for entry in getter.member.geos_beamsection}, {"Circular": 6, "Rectangular": 1})

    def test_the_edges_of_a_body_as_asked(self):
        document = new_document()
        mesh = api.add_mesh(plate_with_hole(document), 5, dimension="Edges")
        document.recompute()
        self.assertEqual((mesh.FemMesh.VolumeCount, mesh.FemMesh.FaceCount), (0, 0))
        self.assertGreater(mesh.FemMesh.EdgeCount, 80)

    def test_formats_and_colours(self):
        document = new_document()
        mesh = api.add_mesh(line(document), 10)
        document.recompute()
        with tempfile.TemporaryDirectory() as folder:
            for file_format in export.FORMATS:
                path = os.path.join(folder, "axis." + file_format)
                with self.subTest(file_format):
                    if file_format in ("bdf", "stl", "z88"):
                        with self.assertRaisesRegex(UserError, "edges"):
                            api.export_mesh(mesh, path)
                        continue
                    api.export_mesh(mesh, path)
                    if file_format in ("inp", "msh", "vtu", "vtk"):   # FreeCAD reads no segments from VTK
                        with open(path, "rb") as stream:
                            self.assertIn({"inp": b"TYPE=B32", "msh": b"1 1 8 20", "vtu": b'NumberOfCells="20"', "vtk": b"CELL_TYPES 20"}[file_format], stream.read())
                    else:
                        self.assertEqual(Fem.read(path).EdgeCount, 20)
        with self.assertRaisesRegex(UserError, "segments only"):
            overlays.quality(mesh)


# (example, in each run)
EXAMPLES = [("ccx_cantilever_ele_seg3", True), ("ccx_cantilever_ele_seg2", False), ("ccx_cantilever_beam_circle", True), ("ccx_cantilever_beam_rect", False),
            ("ccx_cantilever_beam_pipe", False)]


@unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
class BeamsSolved(RemeshedExamples, unittest.TestCase):

    def test_our_beams_give_the_figures_of_the_examples(self):
        self.check_examples("beam", "segments", EXAMPLES)

    def meshing_of(self, part, fem_mesh):
        segment = fem_mesh.getElementNodes(fem_mesh.Edges[0])
        return fem_mesh.EdgeCount, part.Shape.Length / fem_mesh.EdgeCount, len(segment) - 1

    def test_an_edit_and_a_second_solution(self):
        """A cantilever of 20 x 20 mm that becomes a quarter longer: F L^3 / 3 E I."""
        document = new_document()
        axis = line(document)
        analysis = ObjectsFem.makeAnalysis(document, "Analysis")
        add_solver(document, analysis)
        add_material(document, analysis, "Steel", STEEL)
        analysis.addObject(ObjectsFem.makeElementGeometry1D(document, "Rectangular", 20.0, 20.0, name="Section"))
        fixed, load = ObjectsFem.makeConstraintFixed(document, "Fixed"), ObjectsFem.makeConstraintForce(document, "Load")
        ends = {vertex.X: "Vertex%d" % (i + 1) for i, vertex in enumerate(axis.Shape.Vertexes)}
        fixed.References, load.References = [(axis, ends[0])], [(axis, ends[200])]
        load.Force, load.DirectionVector = quantity(100.0, "N"), FreeCAD.Vector(0, 0, -1)
        analysis.addObject(fixed), analysis.addObject(load)
        mesh = api.add_mesh(axis, 10, active_analysis=analysis)
        document.recompute()
        for length in (200, 250):
            axis.X2 = length
            document.recompute()
            self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
            found = solve(analysis)
            force = sum(abs(float(words[2])) for words in (row.split(",") for row in found["input"].split("*CLOAD")[1].split("***")[0].splitlines())
                        if len(words) == 3)
            expected = force * length ** 3 / (3 * 210000 * 20 ** 4 / 12)
            self.assertLess(abs(found["displacement"] / expected - 1), WITHIN)
            self.assertGreater(found["displacement"], 0)
        self.assertGreater(mesh.KeptTets, 50)
        self.assertEqual([sub for _, subs in load.References for sub in subs], [name for name in (
            "Vertex%d" % (i + 1) for i, vertex in enumerate(axis.Shape.Vertexes) if vertex.X == 250)])

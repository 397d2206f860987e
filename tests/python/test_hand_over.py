# SPDX-License-Identifier: GPL-3.0-or-later
"""FreeCAD's mesh has the nodes, elements, numbers and groups of the engine's, whichever way it is handed over."""
import os
import re
import shutil
import tempfile
import unittest
from unittest import mock

import FreeCAD
import numpy as np
import ObjectsFem
import Part
from analyses import add_material, add_solver, solve
from freecad.featuremesh import api, hand_over, mesh_object, statics_result
from parts import new_document, plate_with_hole
from remeshed_examples import STEEL

ELEMENTS = (("Edges", "segments", "segment_mids", "segment_numbers"), ("Faces", "triangles", "triangle_mids", "triangle_numbers"),
            ("Volumes", "tets", "tet_mids", "tet_numbers"))


def connected(arrays, elements, mids):
    """(k, nodes per element) numbers of nodes, in the order in which FreeCAD keeps them."""
    table = np.hstack([arrays[elements], arrays[mids].reshape(len(arrays[elements]), -1)]) if len(arrays[mids]) else arrays[elements]
    if elements == "tets":
        table = table[:, hand_over.SMESH_TET[:table.shape[1]]]
    return arrays["node_numbers"][table]


def contents(fem_mesh):
    return ({number: tuple(point) for number, point in fem_mesh.Nodes.items()},
            {kind: {number: fem_mesh.getElementNodes(number) for number in getattr(fem_mesh, kind)} for kind, _, _, _ in ELEMENTS},
            {fem_mesh.getGroupName(group): (fem_mesh.getGroupElementType(group), sorted(fem_mesh.getGroupElements(group))) for group in fem_mesh.Groups})


def contents_of(arrays, groups):
    return (dict(zip(arrays["node_numbers"].tolist(), map(tuple, arrays["points"].tolist()))),
            {kind: dict(zip(arrays[own].tolist(), map(tuple, connected(arrays, elements, mids).tolist()))) for kind, elements, mids, own in ELEMENTS},
            {name: (kind, sorted(np.asarray(members).tolist())) for name, kind, members in groups})


def analysis_with_rigid_end(mesh):
    """One end of the plate is held, the other a rigid body that is pulled up."""
    document, part = mesh.Document, mesh.Document.getObject("Body")
    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    add_solver(document, analysis)
    add_material(document, analysis, "Steel", STEEL)
    held, pulled = (next("Face%d" % (i + 1) for i, face in enumerate(part.Shape.Faces) if face.BoundBox.XMin > x - 1e-6 and face.BoundBox.XMax < x + 1e-6)
                    for x in (0, 60))
    fixed, end = ObjectsFem.makeConstraintFixed(document, "Fixed"), ObjectsFem.makeConstraintRigidBody(document, "End")
    fixed.References, end.References, end.ReferenceNode = [(part, held)], [(part, pulled)], FreeCAD.Vector(60, 20, 5)
    end.TranslationalModeZ, end.ForceZ = "Load", "1000 N"
    for member in (fixed, end, mesh):
        analysis.addObject(member)
    document.recompute()
    return analysis


def analysis_of_turning_bars(part, mesh):
    """Two bars that turn round the y axis, held at their inner ends; the load is on the second one."""
    document = mesh.Document
    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    add_solver(document, analysis)
    add_material(document, analysis, "Steel", STEEL)
    fixed, load = ObjectsFem.makeConstraintFixed(document, "Fixed"), ObjectsFem.makeConstraintCentrif(document, "Turning")
    fixed.References = [(part, "Face%d" % (i + 1)) for i, face in enumerate(part.Shape.Faces) if face.BoundBox.XMax < 1e-6]
    axis = next("Edge%d" % (i + 1) for i, edge in enumerate(part.Shape.Edges) if edge.BoundBox.XMax < 1e-6 and edge.BoundBox.YLength > 1)
    load.References, load.RotationAxis, load.RotationFrequency = [(part, "Solid2")], [(part, axis)], "50 1/s"
    for member in (fixed, load, mesh):
        analysis.addObject(member)
    document.recompute()
    return analysis


class HandOver(unittest.TestCase):

    def meshed(self, order=1, dimension="From shape", size=6):
        document = new_document()
        mesh = api.add_mesh(plate_with_hole(document), size, order, dimension=dimension)
        mesh.AllGroups = True
        document.recompute()
        self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
        return mesh

    def edited(self, mesh, x):
        mesh.Document.getObject("HoleSketch").setDatum("X", FreeCAD.Units.Quantity("%g mm" % x))
        mesh.Document.recompute()
        self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)

    def check(self, arrays, groups, fem_mesh=None):
        found, wanted = contents(fem_mesh or hand_over.build(arrays, groups)), contents_of(arrays, groups)
        for what, expected in zip(found, wanted):
            self.assertEqual(what, expected)

    def groups_and_arrays(self, mesh):
        arrays = mesh.Proxy.arrays(mesh)
        return arrays, hand_over.EntityGroups(arrays).of_all_entities() + [("Some", "Volume", arrays["tet_numbers"][:50])] * bool(len(arrays["tets"]))

    def test_first_meshes_are_read_from_a_file(self):
        for order in (1, 2):
            for dimension in ("Solids", "Faces", "Edges"):
                arrays, groups = self.groups_and_arrays(self.meshed(order, dimension))
                with self.subTest(order=order, dimension=dimension), mock.patch.object(hand_over, "_Building", side_effect=AssertionError("one by one")):
                    self.check(arrays, groups)

    def test_updated_meshes_keep_their_numbers(self):
        for order in (1, 2):
            mesh = self.meshed(order)
            for x in (22, 24, 21):
                self.edited(mesh, x)
            arrays, groups = self.groups_and_arrays(mesh)
            self.assertTrue(hand_over.has_gaps(arrays))
            self.check(arrays, groups)
            with mock.patch.object(hand_over, "_LONG_RUN", 1):
                self.check(arrays, groups)
            with mock.patch.object(hand_over, "_counts_on", lambda: False):
                self.check(arrays, groups)
            with mock.patch.object(hand_over, "_CHUNK", 7):
                self.check(arrays, groups)
            self.assertGreater(len(contents(mesh.FemMesh)[2]), len(groups) - 2)
            self.check(arrays, [], hand_over.build(arrays, []))

    def test_an_opened_document_has_the_mesh_that_was_saved(self):
        for order, edits in ((1, ()), (2, ()), (1, (22, 24))):
            mesh = self.meshed(order)
            for x in edits:
                self.edited(mesh, x)
            arrays, found = mesh.Proxy.arrays(mesh), contents(mesh.FemMesh)
            with tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "part.FCStd")
                mesh.Document.saveAs(path)
                FreeCAD.closeDocument(mesh.Document.Name)
                opened, = api.meshes_of(FreeCAD.openDocument(path))
            points, elements, groups = contents(opened.FemMesh)
            self.assertEqual((elements, groups), found[1:])
            self.assertEqual(sorted(points), sorted(arrays["node_numbers"].tolist()))

    def test_many_groups_or_a_full_disk_are_no_hindrance(self):
        arrays, groups = self.groups_and_arrays(self.meshed())
        with mock.patch.object(hand_over, "_FEW_GROUPS", 3), mock.patch.object(hand_over, "_read_back", side_effect=AssertionError("by a file")):
            self.check(arrays, groups)
        with mock.patch.object(hand_over.vtk, "write", side_effect=OSError(28, "No space left on device")):
            hand_over._reader_turns_tets.cache_clear()
            self.check(arrays, groups)
        self.check(arrays, groups)

    def test_a_result_has_the_tets_alone_without_gaps(self):
        for order in (1, 2):
            mesh = self.meshed(order)
            self.edited(mesh, 22)
            arrays = mesh.Proxy.arrays(mesh)
            nodes, elements, groups = contents(statics_result.result_mesh(arrays))
            self.assertEqual(list(nodes.values()), [tuple(point) for point in arrays["points"].tolist()])
            self.assertEqual((elements["Edges"], elements["Faces"], groups), ({}, {}, {}))
            rows = connected({**arrays, "node_numbers": np.arange(1, len(arrays["points"]) + 1)}, "tets", "tet_mids")
            self.assertEqual(elements["Volumes"], dict(enumerate(map(tuple, rows.tolist()), 1)))

    def test_a_solid_with_shells_and_beams_beside_it(self):
        document = new_document()
        box, sheet = Part.makeBox(20, 20, 10), Part.makePlane(15, 20, FreeCAD.Vector(20, 0, 10))
        part = document.addObject("Part::Feature", "Mixed")
        part.Shape = Part.makeCompound([box, sheet, Part.makeLine((0, 0, 10), (0, 0, 40))])
        mesh = api.add_mesh(part, 6, 2)
        document.recompute()
        self.check(*self.groups_and_arrays(mesh))

    @unittest.skipUnless(shutil.which("ccx") and hasattr(ObjectsFem, "makeConstraintRigidBody"), "CalculiX, or FreeCAD's rigid bodies, are not there")
    def test_the_reference_nodes_of_a_rigid_body_are_none_of_the_mesh(self):
        mesh = self.meshed(2)
        self.edited(mesh, 22)
        analysis = analysis_with_rigid_end(mesh)
        self.assertGreater(max(mesh.FemMesh.Nodes), mesh.FemMesh.NodeCount + 2 * len(analysis.Group))
        found = solve(analysis)
        api.renumber_mesh(mesh)
        self.assertAlmostEqual(found["displacement"] / solve(analysis)["displacement"], 1, delta=1e-6)

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not there")
    def test_a_centrifugal_load_on_one_of_two_solids(self):
        document = new_document()
        bars = [document.addObject("Part::Box", name) for name in ("First", "Second")]
        for bar, y in zip(bars, (0, 30)):
            bar.Length, bar.Placement.Base = 40, FreeCAD.Vector(0, y, 0)
        both = document.addObject("Part::Compound", "Both")
        both.Links = bars
        document.recompute()
        mesh = api.add_mesh(both, 5)
        analysis = analysis_of_turning_bars(both, mesh)
        for length in (40, 50):
            bars[1].Length = length
            document.recompute()
            with mock.patch("femmesh.meshtools.get_femnodes_by_refshape", side_effect=AssertionError("searched")):
                found = solve(analysis)
            self.assert_turns_second_bar(found, mesh)
            solved, places = found["result"], found["result"].Mesh.FemMesh.Nodes
            first = [vector.Length for node, vector in zip(solved.NodeNumbers, solved.DisplacementVectors) if places[node].y < 20]
            self.assertLess(max(first), 1e-9 * found["displacement"])
        document.getObject("Turning").References = [(bars[1], "Solid1")]  # which is the first of its object, and the second of the meshed part
        document.recompute()
        self.assert_turns_second_bar(solve(analysis), mesh)

    def assert_turns_second_bar(self, found, mesh):
        listed = re.search(r"\*ELSET,ELSET=Turning\n([\d,\s]*)", found["input"]).group(1)
        points = mesh.FemMesh.Nodes
        self.assertEqual({int(number) for number in re.findall(r"\d+", listed)},
                         {number for number in mesh.FemMesh.Volumes if all(points[node].y > 20 for node in mesh.FemMesh.getElementNodes(number))})

    def test_nothing(self):
        mesh = self.meshed()
        self.assertEqual(hand_over.build({name: values[:0] for name, values in mesh.Proxy.arrays(mesh).items()}, []).NodeCount, 0)


if __name__ == "__main__":
    unittest.main()

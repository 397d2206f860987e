# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids with shells and beams on them in one mesh: in the document, and solved by CalculiX as they are with Gmsh's mesh."""
import json
import os
import tempfile
import unittest

import BOPTools.SplitFeatures
import meshio
import numpy as np
import ObjectsFem
from analyses import add_material, add_solver, quantity, solve
from freecad.featuremesh import api, export, mesh_object, mixed_elements
from freecad.featuremesh.errors import UserError
from freecad.featuremesh.messages import english
from parts import groups_of, new_document, placement
from remeshed_examples import STEEL, WITHIN

BLOCK = (20.0, 20.0, 10.0)
KINDS = (("tets", "tet_numbers"), ("triangles", "triangle_numbers"), ("segments", "segment_numbers"))


def block_with_sheet(with_beam=False, on_top=False):
    """BooleanFragments of a block and a sheet that ends at the middle of one side, or lies on top of it and goes on beside it, and a post on the
    sheet's corner; "Both"."""
    document = new_document()
    block = document.addObject("Part::Box", "Block")
    block.Length, block.Width, block.Height = BLOCK
    sheet = document.addObject("Part::Plane", "Sheet")
    sheet.Length, sheet.Width = 40, 20
    sheet.Placement = placement(0, 0, 10) if on_top else placement(20, 0, 5)
    parts = [block, sheet]
    if with_beam:
        post = document.addObject("Part::Line", "Post")
        post.X1, post.Y1, post.Z1, post.X2, post.Y2, post.Z2 = 60, 20, 5, 60, 20, 45
        parts.append(post)
    document.recompute()
    both = BOPTools.SplitFeatures.makeBooleanFragments(name="Both")
    both.Objects = parts
    document.recompute()
    return both


def faces_at(shape, is_there):
    return ["Face%d" % (i + 1) for i, face in enumerate(shape.Faces) if is_there(face.BoundBox)]


def edges_at(shape, is_there):
    return ["Edge%d" % (i + 1) for i, edge in enumerate(shape.Edges) if is_there(edge.BoundBox)]


def by_number(mesh):
    """[{number: points}] of tets, triangles and segments."""
    arrays = mesh.Proxy.arrays(mesh)
    return [{int(number): arrays["points"][nodes] for number, nodes in zip(arrays[numbers], arrays[kind])} for kind, numbers in KINDS]


def shares_kept(before, after):
    return [sum(number in was and np.array_equal(was[number], points) for number, points in now.items()) / len(was) for was, now in zip(before, after)]


def lines_of(path, kind):
    """How many elements of a kind are in an Abaqus file."""
    with open(path, encoding="ascii") as stream:
        return len(stream.read().split("TYPE=%s, ELSET=Eall\n" % kind)[1].split("*")[0].splitlines())


class MixedMeshes(unittest.TestCase):

    def test_a_solid_a_sheet_and_a_beam_share_nodes(self):
        for order in (1, 2):
            both = block_with_sheet(with_beam=True)
            mesh = api.add_mesh(both, 3, order)
            both.Document.recompute()
            self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
            self.assertEqual(json.loads(mesh.Report)["warnings"], [])
            nodes = groups_of(mesh)
            in_solid = {node for number in mesh.FemMesh.Volumes for node in mesh.FemMesh.getElementNodes(number)}
            sheet, = faces_at(both.Shape, lambda box: box.XMax > 59)
            post, = edges_at(both.Shape, lambda box: box.ZMax > 44)
            seam = [node for node in nodes[sheet + "_Nodes"] if abs(mesh.FemMesh.Nodes[node].x - 20) < 1e-9]
            self.assertEqual(in_solid & nodes[sheet + "_Nodes"], set(seam))
            self.assertGreater(len(seam), 5)
            self.assertEqual(len(nodes[sheet + "_Nodes"] & nodes[post + "_Nodes"]), 1)
            self.assertGreater(len(nodes[post]), 10)

    def test_an_edit_of_one_leaves_the_others(self):
        for order in (1, 2):
            both = block_with_sheet(with_beam=True)
            document = both.Document
            mesh = api.add_mesh(both, 3, order)
            document.recompute()
            before = by_number(mesh)
            document.Sheet.Length = 44
            document.Post.Placement = placement(4, 0, 0)
            document.recompute()
            self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
            self.assertIsNone(json.loads(mesh.Report)["fallback"])
            kept = shares_kept(before, by_number(mesh))
            self.assertEqual(kept[0], 1)
            self.assertGreater(kept[1], 0.8)
            self.assertGreater(kept[2], 0.7)
            before = by_number(mesh)
            document.Block.Length, document.Block.Placement = 26, placement(-6, 0, 0)
            document.recompute()
            self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
            kept = shares_kept(before, by_number(mesh))
            self.assertGreater(kept[0], 0.4)
            self.assertGreater(kept[1], 0.6)

    def test_a_sheet_that_moved_takes_its_triangles_along(self):
        document = new_document()
        block = document.addObject("Part::Box", "Block")
        sheet = document.addObject("Part::Plane", "Sheet")
        sheet.Length = sheet.Width = 20
        tool = document.addObject("Part::Box", "Tool")
        tool.Placement = placement(15, 15, -5)
        cut = document.addObject("Part::Cut", "Cut")
        cut.Base, cut.Tool = sheet, tool
        both = document.addObject("Part::Compound", "Both")
        both.Links = [block, cut]
        cut.Placement = placement(30, 0, 5)
        document.recompute()
        mesh = api.add_mesh(both, 2, 1)
        document.recompute()
        self.assertEqual(json.loads(mesh.Report)["warnings"], [])
        before = by_number(mesh)
        cut.Placement = placement(33, 4, 7)
        document.recompute()
        after = by_number(mesh)
        self.assertEqual(shares_kept(before, after)[0], 1)
        self.assertEqual(set(before[1]), set(after[1]))

    def test_only_the_solids_as_asked(self):
        both = block_with_sheet(with_beam=True)
        document = both.Document
        mesh = api.add_mesh(both, 4, 1, dimension="Solids")
        document.recompute()
        alone = mesh.FemMesh.FaceCount
        self.assertTrue(any("no solid has them" in english(line) for line in json.loads(mesh.Report)["warnings"]))
        before = by_number(mesh)
        mesh.Dimension = "From shape"
        document.recompute()
        self.assertGreater(mesh.FemMesh.FaceCount, alone)
        self.assertEqual(shares_kept(before, by_number(mesh))[0], 1)
        mesh.Dimension = "Solids"
        document.recompute()
        self.assertEqual(mesh.FemMesh.FaceCount, alone)

    def test_every_format_has_all_elements_or_refuses(self):
        both = block_with_sheet()
        mesh = api.add_mesh(both, 4, 2)
        both.Document.recompute()
        arrays = mesh.Proxy.arrays(mesh)
        shells = int((arrays["triangle_faces"] == int(faces_at(both.Shape, lambda box: box.XMax > 59)[0][4:]) - 1).sum())
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "mesh.inp")
            export.write(mesh, path, "inp")
            self.assertEqual((lines_of(path, "C3D10"), lines_of(path, "S6")), (len(arrays["tets"]), shells))
            path = os.path.join(folder, "mesh.bdf")
            export.write(mesh, path, "bdf")
            self.assertEqual({block.type: len(block.data) for block in meshio.read(path).cells}, {"tetra10": len(arrays["tets"]), "triangle6": shells})
            with self.assertRaisesRegex(UserError, "would lose the shells"):
                export.write(mesh, os.path.join(folder, "mesh.z88"), "z88")
            both = block_with_sheet(with_beam=True)
            mesh = api.add_mesh(both, 4, 2)
            both.Document.recompute()
            path = os.path.join(folder, "beam.inp")
            export.write(mesh, path, path.rpartition(".")[2])
            arrays = mesh.Proxy.arrays(mesh)
            beams = int((arrays["segment_edges"] == int(edges_at(both.Shape, lambda box: box.ZMax > 44)[0][4:]) - 1).sum())
            self.assertEqual(lines_of(path, "B32"), beams)
            for file_format in ("bdf", "z88"):
                with self.assertRaisesRegex(UserError, "would lose the beams"):
                    export.write(mesh, os.path.join(folder, "beam." + file_format), file_format)

    def test_a_sheet_inside_a_solid_is_named(self):
        document = new_document()
        block = document.addObject("Part::Box", "Block")
        sheet = document.addObject("Part::Plane", "Sheet")
        sheet.Length = sheet.Width = 4
        sheet.Placement = placement(3, 3, 5)
        both = document.addObject("Part::Compound", "Both")
        both.Links = [block, sheet]
        document.recompute()
        mesh = api.add_mesh(both, 3, 1)
        document.recompute()
        self.assertTrue(any("Face7 (Sheet) in Solid1" in english(line) for line in json.loads(mesh.Report)["warnings"]), mesh.Report)


    def test_a_datum_plane_by_which_a_body_is_cut_goes_on_beside_it(self):
        document = new_document()
        body = document.addObject("PartDesign::Body", "Body")
        box, plane = body.newObject("PartDesign::AdditiveBox", "Box"), body.newObject("PartDesign::Plane", "Plane")
        box.Length = box.Width = box.Height = 10
        plane.Placement = placement(0, 0, 4)
        document.recompute()
        halves = BOPTools.SplitFeatures.makeBooleanFragments("Halves")
        halves.Objects = [body, plane]
        document.recompute()
        mesh = api.add_mesh(halves, 5, 1)
        for mesh.Dimension, status in (("Solids", "up to date"), ("From shape", "of Halves has no end")):
            document.recompute()
            self.assertRegex(mesh.Status, status)
        halves.Mode = "CompSolid"
        document.recompute()
        self.assertEqual(mesh.Status, "up to date")


class MixedAnalyses(unittest.TestCase):

    def solved(self, both, kind, mesh_of):
        """CalculiX's result of a block held at its left, and a force at the end of what is on it."""
        document, shape = both.Document, both.Shape
        analysis = ObjectsFem.makeAnalysis(document, "Analysis")
        add_solver(document, analysis)
        add_material(document, analysis, "Steel", STEEL)
        fixed, load = ObjectsFem.makeConstraintFixed(document, "Fixed"), ObjectsFem.makeConstraintForce(document, "Load")
        fixed.References = [(both, name) for name in faces_at(shape, lambda box: box.XMax < 1e-9)]
        load.Force = quantity(100, "N")
        load.Direction = (both, faces_at(shape, lambda box: box.ZMax < 1e-9))
        if kind == "sheet":
            load.References = [(both, name) for name in edges_at(shape, lambda box: box.XMin > 39)]
        else:
            load.References = [(both, name) for name in faces_at(shape, lambda box: box.XMin > 99)]
        thickness = ObjectsFem.makeElementGeometry2D(document, 1.5, "Thickness")
        thickness.References = [(both, name) for name in faces_at(shape, lambda box: box.ZMin > 9.9)]
        for member in (fixed, load, thickness):
            analysis.addObject(member)
        mesh = mesh_of(both, analysis)
        document.recompute()
        return analysis, mesh

    def ours(self, both, analysis):
        return api.add_mesh(both, 3, 2, active_analysis=analysis)

    def gmsh(self, both, analysis):
        from femmesh.gmshtools import GmshTools
        mixed_elements.install()
        mesh = ObjectsFem.makeMeshGmsh(both.Document, "Gmsh")
        (setattr(mesh, "Part", both) if hasattr(mesh, "Part") else setattr(mesh, "Shape", both))
        mesh.CharacteristicLengthMax, mesh.ElementOrder = 3, "2nd"   # the default order of FreeCAD 1.1 is the first
        analysis.addObject(mesh)
        GmshTools(mesh).create_mesh()
        return mesh

    def compare(self, make, kind):
        theirs = solve(self.solved(make(), kind, self.gmsh)[0])
        both = make()
        analysis, mesh = self.solved(both, kind, self.ours)
        found = solve(analysis)
        self.assertIn("ELSET=Efaces", found["input"])
        self.assertAlmostEqual(found["displacement"] / theirs["displacement"], 1, delta=WITHIN)
        return both, analysis, mesh, found, theirs

    def test_a_sheet_on_a_block_bends_as_with_gmsh_before_and_after_an_edit(self):
        both, analysis, mesh, found, _ = self.compare(lambda: block_with_sheet(on_top=True), "sheet")
        before = by_number(mesh)
        both.Document.Sheet.Length = 44
        both.Document.recompute()
        self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
        kept = shares_kept(before, by_number(mesh))
        self.assertEqual(kept[0], 1)
        self.assertGreater(kept[1], 0.7)
        again = solve(analysis)
        anew, _ = self.solved(self.with_longer_sheet(), "sheet", self.gmsh)
        self.assertAlmostEqual(again["displacement"] / solve(anew)["displacement"], 1, delta=WITHIN)
        self.assertGreater(again["displacement"], 1.2 * found["displacement"])

    def with_longer_sheet(self):
        both = block_with_sheet(on_top=True)
        both.Document.Sheet.Length = 44
        both.Document.recompute()
        return both

    def test_a_skin_on_a_block_stiffens_it_as_with_gmsh(self):
        def bar():
            document = new_document()
            bar = document.addObject("Part::Box", "Bar")
            bar.Length, bar.Width, bar.Height = 100, 10, 10
            document.recompute()
            return bar
        both, analysis, _, found, _ = self.compare(bar, "skin")
        thickness, = [member for member in analysis.Group if member.Name.startswith("Thickness")]
        analysis.removeObject(thickness)
        bare = solve(analysis)
        self.assertGreater(bare["displacement"], 1.1 * found["displacement"])

    def test_a_pressure_on_a_shell_beside_a_solid_is_refused(self):
        both = block_with_sheet(on_top=True)
        analysis, _ = self.solved(both, "skin", self.ours)
        pressure = ObjectsFem.makeConstraintPressure(both.Document, "Pressure")
        pressure.References = [(both, faces_at(both.Shape, lambda box: box.XMax > 39)[0])]
        pressure.Pressure = quantity(1, "MPa")
        analysis.addObject(pressure)
        with self.assertRaisesRegex(RuntimeError, "Pressure presses on a shell beside a solid"):
            solve(analysis)
        if hasattr(ObjectsFem, "makeSolverCalculiX"):   # which goes on whatever FreeCAD's check says
            from femsolver.calculix.calculixtools import CalculiXTools
            solver = ObjectsFem.makeSolverCalculiX(both.Document, "SolverCalculiX")
            solver.WorkingDirectory = self.enterContext(tempfile.TemporaryDirectory())
            analysis.addObject(solver)
            both.Document.removeObject("Load")   # it refers to nothing
            with self.assertRaisesRegex(UserError, "Pressure presses on a shell beside a solid"):
                CalculiXTools(solver).prepare()

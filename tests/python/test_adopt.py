# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of Gmsh become ours and update locally; results go over to the updated mesh. Skipped where Gmsh is not installed."""
import os
import shutil
import tempfile
import unittest
from types import SimpleNamespace

import FreeCAD
import Fem
import numpy as np
import ObjectsFem
from freecad.featuremesh import adopt, api, cli, documents, statics_result, versions
from freecad.featuremesh.errors import UserError
from freecad.featuremesh.messages import english
from parts import groups_in_freecad, groups_of, new_document, plate_with_hole

SIZE = 4.0


def gmsh_mesh(body, order):
    """The mesh that FreeCAD's own Gmsh object makes."""
    from femmesh.gmshtools import GmshTools
    obj = ObjectsFem.makeMeshGmsh(body.Document, "GmshMesh")
    setattr(obj, versions.part_property(obj), body)
    obj.CharacteristicLengthMax, obj.ElementOrder = SIZE, order
    GmshTools(obj).create_mesh()
    return obj


def result_on(obj, displacement, temperature):
    """A result object as CalculiX's reader leaves it: on a mesh of its own, with numbers of nodes."""
    result = ObjectsFem.makeResultMechanical(obj.Document, "Solved")
    result.Mesh = obj.Document.addObject("Fem::FemMeshObject", "Solved_Mesh")
    result.Mesh.FemMesh = Fem.FemMesh(obj.FemMesh)
    nodes = obj.FemMesh.Nodes
    result.NodeNumbers = list(nodes)
    result.DisplacementVectors = [displacement(point) for point in nodes.values()]
    result.Temperature = [temperature(point) for point in nodes.values()]
    return result


class Adopt(unittest.TestCase):

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.document = new_document()
        self.body = plate_with_hole(self.document)

    def gmsh(self, order):
        if not shutil.which("gmsh"):
            self.skipTest("Gmsh is not installed")
        obj = gmsh_mesh(self.body, order)
        self.assertGreater(obj.FemMesh.VolumeCount, 500)
        return obj

    def check_adopted(self, order):
        foreign = self.gmsh(order)
        analysis = ObjectsFem.makeAnalysis(self.document)
        analysis.addObject(foreign)
        named = ObjectsFem.makeMeshGroup(self.document, foreign)
        named.References = [(self.body, "Face1")]
        self.document.recompute()
        mesh, report = api.adopt_mesh(foreign)
        self.assertNotIn("Touched", analysis.State)
        self.assertIsNone(report["fallback"])
        self.assertEqual(report["kept"]["nodes_share"], 1.0)
        before = {number: tuple(point) for number, point in foreign.FemMesh.Nodes.items()}
        self.assertEqual({number: tuple(point) for number, point in mesh.FemMesh.Nodes.items()}, before)
        tets = {number: set(foreign.FemMesh.getElementNodes(number)) for number in foreign.FemMesh.Volumes}
        self.assertEqual({number: set(mesh.FemMesh.getElementNodes(number)) for number in mesh.FemMesh.Volumes}, tets)
        self.assertAlmostEqual(mesh.Size.Value, SIZE, delta=0.35 * SIZE)
        self.assertIn(mesh, analysis.Group)
        self.assertNotIn(foreign, analysis.Group)
        self.assertEqual(mesh.MeshGroupList, [named])
        self.assertTrue(any(name.startswith(named.Name) for name in groups_in_freecad(mesh)))
        for number, face in enumerate(self.body.Shape.Faces, 1):
            self.assertEqual(groups_of(mesh)["Face%d_Nodes" % number], set(foreign.FemMesh.getNodesByFace(face)))
        mesh.Automatic = False
        api.set_parameters(self.document, ["HoleSketch.X=23"])
        self.document.recompute()
        report = api.update_mesh(mesh)
        self.assertGreater(report["kept"]["nodes_share"], 0.3)
        now = {number: tuple(point) for number, point in mesh.FemMesh.Nodes.items()}
        same = [number for number in now if number in before]
        self.assertTrue(all(now[number] == before[number] for number in same))
        self.assertGreater(len(same), 0.3 * len(now))
        same = [number for number in mesh.FemMesh.Volumes if number in tets]
        self.assertGreater(len(same), 0.2 * mesh.TetCount)
        self.assertTrue(all(set(mesh.FemMesh.getElementNodes(number)) == tets[number] for number in same))

    def test_gmsh_4_node(self):
        self.check_adopted("1st")

    def test_gmsh_10_node(self):
        self.check_adopted("2nd")

    def test_mesh_from_before_an_edit(self):
        foreign = self.gmsh("1st")
        api.set_parameters(self.document, ["HoleSketch.X=24"])
        self.document.recompute()
        mesh, report = api.adopt_mesh(foreign)
        self.assertIn("do not fit the part", english(report["fallback"]))
        self.assertGreater(report["kept"]["tets_share"], 0.3)
        self.assertLess(report["kept"]["tets_share"], 1.0)

    def test_a_mesh_in_place_of_another_has_its_order_where_none_is_asked_for(self):
        theirs = ObjectsFem.makeMeshGmsh(self.document, "Theirs")
        for asked, order, found in (("1st", None, "1st"), ("2nd", None, "2nd"), ("1st", 2, "2nd")):
            theirs.ElementOrder = asked
            self.assertEqual(api.add_mesh(self.body, SIZE, order, in_place_of=theirs).Order, found)
        self.assertEqual([adopt.asked_order(SimpleNamespace(SecondOrder=is_second, ElementOrder=3)) for is_second in (False, True)], [1, 2])   # Netgen's
        imported = self.document.addObject("Fem::FemMeshObject", "Imported")
        for nodes, order in ((0, 2), (4, 1)):
            fem_mesh = Fem.FemMesh()
            numbers = [fem_mesh.addNode(*map(float, point)) for point in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))]
            if nodes:
                fem_mesh.addVolume(numbers)
            imported.FemMesh = fem_mesh
            self.assertEqual(adopt.asked_order(imported), order)

    def test_command_and_refusals(self):
        self.gmsh("1st")
        box = self.document.addObject("Part::Box", "Box")
        box.Placement.Base.x = 200
        self.document.recompute()
        path = os.path.join(self.folder, "part.FCStd")
        documents.save_document(self.document, path)

        def run(**task):
            for name in list(FreeCAD.listDocuments()):
                FreeCAD.closeDocument(name)
            return cli.run(dict(task, command="adopt", part=path))
        for task, message in (({"mesh": "Nothing"}, "no object Nothing"), ({"mesh": "Box"}, "no FEM mesh"),
                              ({"mesh": "GmshMesh", "object": "Box"}, "No element of the mesh fits")):
            result = run(**task)
            self.assertEqual(result["exit_code"], 2, result["message"])
            self.assertIn(message, result["message"])
        result = run(mesh="GmshMesh")
        self.assertEqual(result["exit_code"], 0, result["message"])
        self.assertIn("100.0 % of the nodes kept", result["message"])
        result = run(mesh="GmshMesh")
        self.assertIn("has a mesh already", result["message"])

    def test_only_tets(self):
        obj = self.document.addObject("Fem::FemMeshObject", "Surface")
        surface = Fem.FemMesh()
        for number, point in enumerate(((0, 0, 0), (1, 0, 0), (0, 1, 0)), 1):
            surface.addNode(*point, number)
        surface.addFace([1, 2, 3], 1)
        obj.FemMesh = surface
        with self.assertRaisesRegex(UserError, "no tetrahedra"):
            adopt.arrays_of(obj)

    def test_nothing_is_left_of_parts_in_a_container_that_a_mesh_does_not_fit(self):
        obj = self.document.addObject("Fem::FemMeshObject", "Elsewhere")
        tet = Fem.FemMesh()
        for number, point in enumerate(((500, 0, 0), (501, 0, 0), (500, 1, 0), (500, 0, 1)), 1):
            tet.addNode(*point, number)
        tet.addVolume([1, 2, 3, 4], 1)
        obj.FemMesh = tet
        container = self.document.addObject("App::Part", "Machine")
        container.addObject(self.body)
        before = self.document.Objects
        with self.assertRaisesRegex(Exception, "No element of the mesh fits"):
            api.adopt_mesh(obj, container)
        self.assertEqual(self.document.Objects, before)


class Transfer(unittest.TestCase):

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.document = new_document()
        self.body = plate_with_hole(self.document)
        self.mesh = api.add_mesh(self.body, SIZE, order=1)
        self.mesh.Automatic = False
        api.update_mesh(self.mesh)

    def edit(self, x=23):
        api.set_parameters(self.document, ["HoleSketch.X=%d" % x])
        self.document.recompute()
        return api.update_mesh(self.mesh)

    def test_values_of_ones_own(self):
        before = {name: np.array(values) for name, values in self.mesh.Proxy.arrays(self.mesh).items()}
        report = self.edit()
        values = before["points"] @ np.array([[1.0, 0.5], [2.0, 0.0], [-1.0, 0.3]])
        found = api.transfer_field(before, self.mesh, values)
        after = self.mesh.Proxy.arrays(self.mesh)
        inside = found["sources"] < 2
        exact = after["points"] @ np.array([[1.0, 0.5], [2.0, 0.0], [-1.0, 0.3]])
        self.assertLess(np.abs(found["values"] - exact)[inside].max(), 1e-10)
        self.assertAlmostEqual((found["sources"] == 0).mean(), report["kept"]["nodes_share"], 6)
        self.assertEqual(found["figures"]["same"], int((found["sources"] == 0).sum()))
        with self.assertRaisesRegex(RuntimeError, "row per node"):
            api.transfer_field(before, self.mesh, values[1:])

    def test_result_object_across_documents_and_processes(self):
        result_on(self.mesh, lambda p: FreeCAD.Vector(p.x, 2 * p.y, -p.z), lambda p: 20 + 0.1 * p.x)
        solved, edited = (os.path.join(self.folder, name) for name in ("solved.FCStd", "edited.FCStd"))
        documents.save_document(self.document, solved)
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)
        result = cli.run({"command": "update", "part": solved, "out": edited, "set": ["HoleSketch.X=23"]})
        self.assertEqual(result["exit_code"], 0, result["message"])
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)
        result = cli.run({"command": "transfer", "part": solved, "new": edited, "result": "Solved"})
        self.assertEqual(result["exit_code"], 0, result["message"])
        figures = result["data"]["fields"]["Temperature"]
        self.assertGreater(figures["same"], 0.3 * figures["nodes"])
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)
        document = documents.open_document(edited)
        made = document.getObject("Solved_transferred")
        points = document.getObject("FeatureMesh").FemMesh.Nodes
        self.assertEqual(set(made.NodeNumbers), set(points))
        # the hole's old wall is in the new material and the other way round: there the nearest value counts
        wrong = sum(abs(value - 20 - 0.1 * points[number].x) > 1e-9 for number, value in zip(made.NodeNumbers, made.Temperature))
        self.assertLess(wrong, 0.2 * len(points))
        self.assertLessEqual(wrong, figures["outside"])

    def test_a_result_of_our_own_solver_on_a_mesh_with_gaps_between_its_numbers(self):
        self.edit()
        analysis, arrays = ObjectsFem.makeAnalysis(self.document), self.mesh.Proxy.arrays(self.mesh)
        analysis.addObject(self.mesh)
        points = arrays["points"]
        result = statics_result.show(analysis, arrays, {"displacements": points, "stresses": np.zeros((len(points), 6)), "von_mises": points[:, 0]})
        result.addProperty("App::PropertyFloatList", "Thickness")
        result.Thickness = points[:, 2].tolist()
        report = self.edit(25)
        made, transferred = api.transfer_result(result, self.mesh)
        figures = transferred["fields"]["vonMises"]
        self.assertAlmostEqual(figures["same"] / figures["nodes"], report["kept"]["nodes_share"], 6)
        heights = {number: point.z for number, point in self.mesh.FemMesh.Nodes.items()}
        wrong = sum(abs(heights[number] - value) > 1e-6 for number, value in zip(made.NodeNumbers, made.Thickness))
        self.assertLessEqual(wrong, figures["outside"])
        self.document.removeObject(result.Name)   # the next solution has a result of its own
        self.assertIsNot(statics_result.show(analysis, arrays, {"displacements": points, "stresses": np.zeros((len(points), 6)), "von_mises": points[:, 0]}), made)

    def test_refusals(self):
        path = os.path.join(self.folder, "part.FCStd")
        documents.save_document(self.document, path)
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)
        result = cli.run({"command": "transfer", "part": path})
        self.assertEqual(result["exit_code"], 2)
        self.assertIn("no result", result["message"])

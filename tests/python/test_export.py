# SPDX-License-Identifier: GPL-3.0-or-later
"""Every format is read back by another program's reader, FreeCAD's, meshio's or Gmsh's: nodes, elements, their order, and groups."""
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from unittest import mock

import Fem
import meshio
import numpy as np
import ObjectsFem
from freecad.featuremesh import api, versions
from freecad.featuremesh.errors import UserError
from freecad.featuremesh.formats import connectivity, inp, is_single_entity
from parts import new_document, plate_with_hole

PAIRS = ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))   # whose middles are the nodes 4 to 9
# What FreeCAD reads, and what of it with groups; its reader of BDF knows 10-node tets only.
READ_BY_FREECAD = {1: ("unv", "med", "inp", "z88", "vtk", "vtu"), 2: ("unv", "med", "inp", "z88", "vtk", "vtu", "bdf")}
WITH_GROUPS = ("unv", "med")
READ_BY_MESHIO = ("vtu", "vtk", "inp", "bdf", "msh", "med")
TO_A_FEW_DIGITS = {"bdf": 1e-7, "z88": 1e-5, "unv": 1e-7}   # mm


class Truth:
    """The mesh as it is, for comparison with what was read."""

    def __init__(self, mesh):
        self.arrays = mesh.Proxy.arrays(mesh)
        self.points = self.arrays["points"]
        self.blocks = {1: connectivity(self.arrays, "segments", "segment_mids"), 2: connectivity(self.arrays, "triangles", "triangle_mids"),
                       3: connectivity(self.arrays, "tets", "tet_mids")}
        self.groups = {name: self._nodes_of(kind, members) for name, kind, members in groups_of(mesh.FemMesh)}

    def _nodes_of(self, kind, members):
        """A group as a set of node indices, or of sets of them for its elements."""
        if kind == "Node":
            return set(np.flatnonzero(np.isin(self.arrays["node_numbers"], members)).tolist())
        dimension = {"Edge": 1, "Face": 2, "Volume": 3}[kind]
        numbers = self.arrays[{1: "segment", 2: "triangle", 3: "tet"}[dimension] + "_numbers"]
        return elements_as_sets(self.blocks[dimension][np.isin(numbers, members)])

    def rows_of(self, points, tolerance):
        """For each of the points the index of the node in its place."""
        direction = np.array([0.31, 0.83, 0.47])   # along which hardly two nodes are in one place
        order = np.argsort(self.points @ direction)
        near = np.searchsorted((self.points @ direction)[order], points @ direction)
        rows = np.full(len(points), -1)
        for step in range(-3, 3):
            candidates = order[np.clip(near + step, 0, len(order) - 1)]
            fits = np.abs(self.points[candidates] - points).max(axis=1) <= tolerance
            rows[fits] = candidates[fits]
        return rows


class NamesOfGroups(unittest.TestCase):

    def test_each_is_there_under_a_name_of_its_own(self):
        """Legacy VTK has no spaces in names: what looks the same then is told apart by a number."""
        document = new_document()
        body = plate_with_hole(document)
        mesh = api.add_mesh(body, 8.0, 1)
        for label, face in (("my side", "Face1"), ("my_side", "Face2"), ("Number", "Face3"), ('<A> & "b"', "Face4")):
            group = ObjectsFem.makeMeshGroup(document, mesh, True)
            group.Label, group.References = label, [(body, face)]
        document.recompute()
        counts = {name: len(members) for name, _, members in groups_of(mesh.FemMesh)}
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "plate.vtk")
            api.export_mesh(mesh, path)
            found = meshio.read(path)
            path = os.path.join(folder, "plate.vtu")
            api.export_mesh(mesh, path)
            self.assertEqual(Fem.read(path).NodeCount, mesh.NodeCount)   # VTK takes a > in a name for the end of what stands before the values
            self.assertIn('<A> & "b"', meshio.read(path).cell_data)
        cells = {name: sum(int(part.sum()) for part in parts) for name, parts in found.cell_data.items()}
        self.assertEqual([cells[name] for name in ("my_side", "my_side_2", "Number_2")], [counts[name] for name in ("my side", "my_side", "Number")])
        self.assertEqual(found.point_data["my_side_Nodes_2"].sum(), counts["my_side_Nodes"])

    def test_a_group_may_have_the_name_of_a_face(self):
        document = new_document()
        body = plate_with_hole(document)
        mesh = api.add_mesh(body, 8.0, 1)
        group = ObjectsFem.makeMeshGroup(document, mesh, True)
        group.Label, group.References = "Face1", [(body, ("Face2", "Face3"))]
        document.recompute()
        count = next(len(members) for name, kind, members in groups_of(mesh.FemMesh) if (name, kind) == ("Face1", "Face"))
        with tempfile.TemporaryDirectory() as folder:
            for ending in ("vtu", "msh"):
                path = os.path.join(folder, "plate." + ending)
                api.export_mesh(mesh, path)
                found = meshio.read(path)
                blocks = found.cell_data["Face1"] if ending == "vtu" else found.cell_sets["Face1"]
                self.assertEqual(sum(int(np.sum(block)) if ending == "vtu" else len(block) for block in blocks if block is not None), count, ending)


def elements_as_sets(nodes):
    return {frozenset(element) for element in np.asarray(nodes).tolist()}


def middles(tets):
    """{pair of corners: mid-side node} of 10-node tets."""
    return {frozenset((tet[i], tet[j])): tet[4 + k] for tet in tets.tolist() for k, (i, j) in enumerate(PAIRS)} if tets.shape[1] == 10 else {}


def volumes(points, tets):
    p = points[tets[:, :4]]
    return np.einsum("ij,ij->i", p[:, 1] - p[:, 0], np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 0])) / 6


def groups_of(fem_mesh):
    return [(fem_mesh.getGroupName(group), fem_mesh.getGroupElementType(group), sorted(fem_mesh.getGroupElements(group))) for group in fem_mesh.Groups]


class Export(unittest.TestCase):
    order = 1

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp()
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        document = new_document()
        body = plate_with_hole(document)
        analysis = ObjectsFem.makeAnalysis(document, "Analysis")
        cls.mesh = mesh = api.add_mesh(body, 5.0, cls.order)
        for make, name, faces in ((ObjectsFem.makeConstraintFixed, "Held", ("Face1", "Face2")), (ObjectsFem.makeConstraintForce, "Pulled", ("Face7",))):
            constraint = make(document, name)
            constraint.References = [(body, face) for face in faces]
            analysis.addObject(constraint)
        group = ObjectsFem.makeMeshGroup(document, mesh, name="Sides")
        group.References = [(body, ("Face3", "Face4"))]
        document.recompute()
        document.HoleSketch.setDatum("X", 22)   # so that the numbers have gaps
        mesh.AllGroups = True
        document.recompute()
        cls.truth = Truth(mesh)
        mesh.AllGroups = False
        document.recompute()
        assert mesh.KeptNodes == 100 and mesh.FemMesh.GroupCount < 10
        assert {"Held_Nodes", "Pulled_Nodes", "Sides", "Feature_Plate"} <= set(cls.truth.groups), sorted(cls.truth.groups)

    def exported(self, name):
        path = os.path.join(self.folder, "A plate." + name)
        api.export_mesh(self.mesh, path)
        return path

    def check_tets(self, name, points, tets, is_positive=True):
        """The same nodes in the same places, the same tets, middles between the same corners, and not inside out. Returns the rows of the nodes."""
        rows = self.truth.rows_of(points, TO_A_FEW_DIGITS.get(name, 1e-9))
        self.assertEqual(sorted(rows), list(range(len(self.truth.points))), name)
        self.assertEqual(elements_as_sets(rows[tets]), elements_as_sets(self.truth.blocks[3]), name)
        self.assertEqual(len(tets), len(self.truth.blocks[3]), name)
        self.assertEqual(middles(rows[tets]), middles(self.truth.blocks[3]), name)
        self.assertGreater((volumes(points, tets) * (1 if is_positive else -1)).min(), 0, name)
        return rows

    def test_a_link_stays_one_and_who_may_read_the_file_stays(self):
        link, path = os.path.join(self.folder, "link.inp"), os.path.join(self.folder, "elsewhere.inp")
        os.symlink(path, link)
        api.export_mesh(self.mesh, link)
        os.chmod(path, 0o600)
        api.export_mesh(self.mesh, link)
        self.assertEqual((os.path.islink(link), os.stat(path).st_mode & 0o777), (True, 0o600))
        os.unlink(link)

    def test_a_file_is_not_named_as_of_another_format(self):
        path = os.path.join(self.folder, "plate.VTU")
        with self.assertRaisesRegex(UserError, "plate.VTU is the name of a vtu file and would hold inp"):
            api.export_mesh(self.mesh, path, "inp")
        self.assertFalse(os.path.exists(path))

    def test_freecad_reads_it(self):
        for name in READ_BY_FREECAD[self.order]:
            with self.subTest(name):
                read = Fem.read(self.exported(name))
                places = read.Nodes
                numbers = np.array(sorted(places))
                points = np.array([tuple(places[number]) for number in numbers.tolist()])
                tets = np.searchsorted(numbers, [read.getElementNodes(number) for number in read.Volumes])
                turns_vtk = versions.version() >= (1, 0)   # before, FreeCAD took VTK's order for its own, which is the mirrored one
                rows = self.check_tets(name, points, tets, is_positive=name in ("vtk", "vtu") and not turns_vtk)
                if name in WITH_GROUPS:
                    self.assertEqual((read.EdgeCount, read.FaceCount), (len(self.truth.blocks[1]), len(self.truth.blocks[2])))
                    found = {group: self.members(read, kind, members, numbers, rows) for group, kind, members in groups_of(read)}
                    self.assertEqual(found, self.truth.groups)

    @staticmethod
    def members(read, kind, members, numbers, rows):
        if kind == "Node":
            return set(rows[np.searchsorted(numbers, members)].tolist())
        return elements_as_sets([rows[np.searchsorted(numbers, read.getElementNodes(member))] for member in members])

    def test_meshio_reads_it(self):
        for name in READ_BY_MESHIO:
            with self.subTest(name):
                read = meshio.read(self.exported(name))
                kind = {1: "tetra", 2: "tetra10"}[self.order]
                tets = np.concatenate([cells.data for cells in read.cells if cells.type == kind])
                rows = self.check_tets(name, read.points, tets, is_positive=name != "med")   # MED's own order is the mirrored one
                if name in ("vtu", "vtk", "inp", "msh"):
                    self.assertEqual(self.wanted_groups(name), getattr(self, "groups_of_" + name)(read, rows), name)

    def wanted_groups(self, name):
        """Groups as a format has them: Gmsh none of nodes alone, Abaqus no elements but tets, VTK those of single entities in one array. Gmsh and VTK have the
        only solid, too, which is no group of the mesh."""
        only_solid = {"Solid1": elements_as_sets(self.truth.blocks[3])}
        if name == "msh":
            return {**only_solid, **{group: members for group, members in self.truth.groups.items() if not group.endswith("_Nodes")}}
        if name == "inp":
            return {group: nodes for group, nodes in self.truth.groups.items() if re.match(r"Solid|Feature", group) or group.endswith("_Nodes")}
        return {**only_solid, **{group: nodes for group, nodes in self.truth.groups.items() if not group.endswith("_Nodes") or not is_single_entity(group)}}

    @staticmethod
    def groups_of_vtu(read, rows):
        found = {}
        for block, cells in enumerate(read.cells):
            nodes = rows[cells.data]
            for name, data in read.cell_data.items():
                if name not in ("Number", "Dimension", "Entity") and np.any(data[block]):
                    found.setdefault(name, set()).update(elements_as_sets(nodes[np.asarray(data[block]).reshape(-1) == 1]))
            for entity in np.unique(read.cell_data["Entity"][block]):
                stem = {1: "Edge", 2: "Face", 3: "Solid"}[int(read.cell_data["Dimension"][block][0].item())]
                found["%s%d" % (stem, entity)] = elements_as_sets(nodes[np.asarray(read.cell_data["Entity"][block]).reshape(-1) == entity])
        for name, data in read.point_data.items():
            if name != "Number":
                found[name] = set(rows[np.asarray(data).reshape(-1) == 1].tolist())
        return found

    groups_of_vtk = groups_of_vtu

    @staticmethod
    def groups_of_inp(read, rows):
        found = {name: set(rows[nodes].tolist()) for name, nodes in read.point_sets.items() if name != "Nall"}
        for name, blocks in read.cell_sets.items():
            if name != "Eall":
                found[name] = set().union(*(elements_as_sets(rows[cells.data[members]]) for cells, members in zip(read.cells, blocks) if members is not None and len(members)))
        return found

    @staticmethod
    def groups_of_msh(read, rows):
        found = {}
        for name, blocks in read.cell_sets.items():
            if name.endswith("_Nodes") or name.startswith("gmsh:"):
                continue
            for cells, members in zip(read.cells, blocks):
                if members is not None and len(members):
                    found.setdefault(name, set()).update(elements_as_sets(rows[cells.data[members]]))
        return found

    def test_gmsh_reads_it(self):
        path = self.exported("msh")
        again = os.path.join(self.folder, "again.bdf")
        done = subprocess.run(["gmsh", path, "-save", "-format", "bdf", "-o", again], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertNotRegex(done.stdout, "Error|Warning")
        names = dict(re.findall(r'^2 (\d+) "(.*)"$', open(path, encoding="utf-8").read(), re.MULTILINE))
        self.assertTrue({"Held_Nodes", "Pulled_Nodes", "Sides", "Face1"} <= set(names.values()), names)
        listed = subprocess.run(["gmsh", path, "-save", "-format", "msh2", "-o", again + ".msh"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        self.assertEqual(listed.returncode, 0)
        read = meshio.read(again + ".msh")
        self.assertEqual(len(read.points), len(self.truth.points))

    def test_nastrans_sets(self):
        text = open(self.exported("bdf"), encoding="ascii").read()
        nodes, numbers = self.truth.arrays["node_numbers"], self.truth.arrays["tet_numbers"]
        found = {}
        for name, card in re.findall(r"^\$ (\S+)\nSET1    (.*?)(?=^\$|^ENDDATA)", text, re.MULTILINE | re.DOTALL):
            members = [int(word) for word in card.replace("+\n+", "").split()][1:]
            if name.endswith("_Nodes"):
                found[name] = set(np.searchsorted(nodes, sorted(members)).tolist()) if np.all(np.diff(nodes) > 0) else {int(np.flatnonzero(nodes == m)[0]) for m in members}
            else:
                found[name] = elements_as_sets(self.truth.blocks[3][np.isin(numbers, members)])
        self.assertEqual(found, self.wanted_groups("inp"))

    def test_the_surface(self):
        read = meshio.read(self.exported("stl"))
        faces = np.concatenate([cells.data for cells in read.cells])
        self.assertEqual(len(faces), len(self.truth.arrays["triangles"]) * (4 if self.order == 2 else 1))
        corners = read.points[faces].astype(float)
        volume = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6
        inside = volumes(self.truth.points, self.truth.blocks[3]).sum()
        self.assertAlmostEqual(volume / inside, 1, 5 if self.order == 1 else 2)
        rows = self.truth.rows_of(read.points.astype(float), 1e-5)
        self.assertEqual(set(rows.tolist()), set(self.truth.blocks[2].reshape(-1).tolist()))
        self.assertEqual(Fem.read(self.exported("stl")).FaceCount, len(faces))


class NamesOfSets(unittest.TestCase):
    ARRAYS = {"points": np.eye(4, 3), "node_numbers": np.array([3, 4, 7, 9]), "tets": np.array([[0, 1, 2, 3]]), "tet_mids": np.zeros((0, 6), int),
              "tet_numbers": np.array([5]), "tet_solids": np.zeros(1, int), "triangles": np.zeros((0, 3), int), "triangle_mids": np.zeros((0, 3), int),
              "triangle_faces": np.zeros(0, int), "segments": np.zeros((0, 2), int), "segment_mids": np.zeros(0, int)}

    def test_labels_of_groups_that_differ_are_sets_that_do(self):
        labels = ["Größe", "Grüße", "left, right", "left right", "eall", "Sides", "sides", 100 * "x", 100 * "x" + "y"]
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "mesh.inp")
            inp.write(path, self.ARRAYS, [(label, "Node", np.array([number])) for number, label in enumerate(labels, 1)])
            with open(path, encoding="ascii") as stream:
                sets = re.findall(r"[*]NSET, NSET=(.*)\n(.*)\n", stream.read())
        self.assertEqual([members for _, members in sets], ["%d," % number for number in range(1, len(labels) + 1)])
        names = [name for name, _ in sets]
        self.assertEqual(len({name.upper() for name in names} - {"NALL", "EALL"}), len(labels), names)
        for name in names:
            self.assertRegex(name, r"^[A-Za-z0-9_-]{1,80}$")
        self.assertIn("Sides", names)


class QuadraticExport(Export):
    order = 2

    def test_med_where_the_system_sets_no_room_apart(self):
        path = os.path.join(self.folder, "mesh.med")
        with mock.patch.object(os, "posix_fallocate"):
            del os.posix_fallocate   # until the end of the block
            api.export_mesh(self.mesh, path)
        self.assertGreater(os.path.getsize(path), 10000)

    def test_a_name_too_long_for_med(self):
        with self.assertRaisesRegex(UserError, "64 characters"):
            api.export_mesh(self.mesh, os.path.join(self.folder, 70 * "x" + ".med"))
        self.assertFalse([name for name in os.listdir(self.folder) if name.startswith((".", "xxx"))])

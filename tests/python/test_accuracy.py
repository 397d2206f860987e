# SPDX-License-Identifier: GPL-3.0-or-later
"""Refinement by error: the mesh gets finer where the result is off, as far as is asked for, and stays as it is elsewhere."""
import json
import tempfile
import unittest
from pathlib import Path

import FreeCAD
import numpy as np
import ObjectsFem
import Part
from freecad.featuremesh import api, engine, error_sizes, mesh_object, tasks
from freecad.featuremesh.errors import UserError
from freecad.featuremesh.messages import english
from parts import new_document
from test_document_solving import FORCE, STEEL, face_at, newton

SIDE, WIDTH, THICKNESS, SIZE = 100.0, 40.0, 10.0, 8.0
CORNER = np.array([WIDTH, WIDTH])   # the re-entrant one, along z


def face_at_top(part):
    return "Face%d" % (1 + max(range(len(part.Shape.Faces)), key=lambda i: part.Shape.Faces[i].CenterOfMass.y))


def angle(document):
    """An L, fixed at its top, pulled down at its foot."""
    part = document.addObject("Part::Feature", "Angle")
    hole = Part.makeBox(SIDE, SIDE, THICKNESS, FreeCAD.Vector(WIDTH, WIDTH, 0))
    part.Shape = Part.makeBox(SIDE, SIDE, THICKNESS).cut(hole)
    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    material = ObjectsFem.makeMaterialSolid(document, "Steel")
    material.Material = STEEL
    fixed = ObjectsFem.makeConstraintFixed(document, "Fixed")
    fixed.References = [(part, face_at_top(part))]
    force = ObjectsFem.makeConstraintForce(document, "Force")
    force.References = [(part, face_at(part, SIDE))]
    force.Force, force.Direction = newton(FORCE), (part, [face_at_top(part)])
    for member in (material, fixed, force):
        analysis.addObject(member)
    document.recompute()
    return part, analysis


def places_of(mesh):
    """By number the coordinates of the nodes."""
    arrays = mesh.Proxy.arrays(mesh)
    return dict(zip(arrays["node_numbers"].tolist(), map(tuple, arrays["points"].tolist())))


@unittest.skipIf(engine.load().statics_missing(), "without PETSc nothing is solved live")
class Accuracy(unittest.TestCase):

    def setUp(self):
        self.document = new_document()
        self.part, self.analysis = angle(self.document)

    def mesh(self, size=SIZE, order=2):
        mesh = api.add_mesh(self.part, size=size, order=order)
        api.update_mesh(mesh)
        return mesh

    def test_the_error_comes_down_to_what_is_asked_for_with_far_fewer_elements_than_everywhere_finer_ones(self):
        for order, accuracy, finer, most in ((2, 0.02, 2.0, 0.3), (1, 0.12, 3.0, 0.8)):
            with self.subTest(order=order):
                mesh = self.mesh(order=order)
                report = api.solve_to(self.analysis, accuracy)
                errors = [found["mesh_error"] for found in report["rounds"]]
                self.assertEqual(errors, sorted(errors, reverse=True))
                self.assertLessEqual(report["mesh_error"], accuracy)
                adapted, energy = mesh.TetCount, report["responses"]["strain_energy_mj"]
                self.document.removeObject(mesh.MeshRegionList[0].Name)
                mesh.Size = finer
                api.update_mesh(mesh, full=True)
                uniform = api.solve_analysis(self.analysis, "live")
                as_good = mesh.TetCount * (uniform["mesh_error"] / report["mesh_error"]) ** (3 / order)   # with smaller elements everywhere
                self.assertLess(adapted, most * as_good)
                # the true energy, as both tell it: their estimates are of the right size
                told = [value / (1 - error ** 2) for value, error in ((energy, report["mesh_error"]), (uniform["responses"]["strain_energy_mj"], uniform["mesh_error"]))]
                self.assertAlmostEqual(told[0] / told[1], 1, delta=0.01)
                self.document.removeObject(mesh.Name)

    def test_only_where_the_result_is_off_the_mesh_is_another_one_and_it_is_so_in_a_document_that_is_opened_again(self):
        mesh = self.mesh(size=3)
        before = places_of(mesh)
        api.solve_analysis(self.analysis, "live")
        asked = api.refine_by_error(self.analysis, 0.03)
        refinement = mesh.MeshRegionList[0]
        self.assertEqual((asked["places"], refinement.Places), (len(refinement.Sizes), len(refinement.Sizes)))
        self.document.recompute()
        self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
        after = places_of(mesh)
        kept = np.array([before[number] for number in before.keys() & after.keys() if before[number] == after[number]])
        gone = np.array([before[number] for number in before.keys() - after.keys()])
        self.assertGreater(len(kept), 0.6 * len(before))
        reach = np.array(refinement.Centres)[:, :2]
        self.assertTrue((np.linalg.norm(gone[:, None, :2] - reach, axis=2).min(axis=1) < 12).all())
        self.assertLess(np.linalg.norm(reach - CORNER, axis=1).min(), 3)
        self.assertAlmostEqual(mesh.TetCount / asked["tets"], 1, delta=0.25)
        path = Path(tempfile.mkdtemp()) / "refined.FCStd"
        self.document.saveAs(str(path))
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(str(path))
        mesh = api.find_mesh(self.document)
        self.assertTrue(error_sizes.is_error_sizes(mesh.MeshRegionList[0]))
        self.assertEqual(api.update_mesh(mesh)["kept"]["nodes_share"], 1)
        self.assertEqual(places_of(mesh), after)

    def test_it_goes_with_the_part_and_is_left_out_where_it_is_suppressed(self):
        mesh = self.mesh()
        plain = mesh.TetCount
        api.solve_to(self.analysis, 0.04)
        refined, refinement = mesh.TetCount, mesh.MeshRegionList[0]
        self.part.Placement = FreeCAD.Placement(FreeCAD.Vector(30, 0, 50), FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), 90))
        self.document.recompute()
        report = json.loads(mesh.Report)
        self.assertGreater(report["kept"]["nodes_share"], 0.9)
        self.assertAlmostEqual(mesh.TetCount / refined, 1, delta=0.1)
        refinement.Suppressed = True
        self.document.recompute()
        self.assertLess(mesh.TetCount, (plain + refined) / 2)
        self.assertIn("is suppressed and left out", " ".join(map(english, json.loads(mesh.Report)["warnings"])))
        api.solve_analysis(self.analysis, "live")
        places = refinement.Places
        api.refine_by_error(self.analysis, 0.04)   # what is suppressed was for another mesh
        self.assertFalse(refinement.Suppressed)
        self.assertNotEqual(refinement.Places, places)
        self.assertEqual([refinement], mesh.MeshRegionList)

    def test_a_copy_of_the_analysis_with_a_mesh_of_its_own_is_refined_by_itself(self):
        mesh = self.mesh()
        api.solve_to(self.analysis, 0.04)
        refined = mesh.TetCount
        copy = api.copy_analysis(self.analysis, mesh="own")
        own, = [member for member in copy.Group if mesh_object.is_feature_mesh(member)]
        api.solve_to(copy, 0.02)
        self.document.recompute()
        self.assertEqual((mesh.TetCount, len(mesh.MeshRegionList)), (refined, 1))
        self.assertGreater(own.TetCount, refined)
        self.assertEqual(own.MeshRegionList[:1], mesh.MeshRegionList)

    def test_what_cannot_be_refined_is_said_and_nothing_is_left_in_the_document(self):
        mesh = self.mesh()
        for call in (api.refine_by_error, api.solve_to):
            self.assertRaises(UserError, call, mesh, 0.05)   # it is no analysis
        for accuracy, result in ((0.05, False), (2, True), (float("nan"), True), ("5 %", True)):
            if result:
                api.solve_analysis(self.analysis, "live")
            with self.assertRaises(UserError) as raised:
                api.refine_by_error(self.analysis, accuracy)
            self.assertIn("a share between 0 and 1" if result else "solve first", english(raised.exception.message))
        found = api.refine_by_error(self.analysis, 0.9)
        self.assertEqual((found["places"], mesh.MeshRegionList), (0, []))
        mesh.Size = 5
        self.document.recompute()
        with self.assertRaises(UserError) as raised:   # the result is of the mesh before
            api.refine_by_error(self.analysis, 0.05)
        self.assertIn("solve first", english(raised.exception.message))
        self.assertEqual(mesh.MeshRegionList, [])

    def test_from_the_console(self):
        self.mesh()
        folder = Path(tempfile.mkdtemp())
        self.document.saveAs(str(folder / "angle.FCStd"))
        words, report = tasks.solve({"part": str(folder / "angle.FCStd"), "accuracy": 0.03, "out": str(folder / "refined.FCStd")})
        self.assertGreater(len(report["rounds"]), 1)
        self.assertIn("; then %d elements, off by about" % report["rounds"][1]["elements"], words)
        self.assertLessEqual(report["mesh_error"], 0.03)

    def test_where_finer_elements_gain_little_it_ends_and_says_so(self):
        mesh = self.mesh()
        force = self.document.getObject("Force")
        force.References = [(self.part, "Vertex%d" % (1 + max(range(len(self.part.Shape.Vertexes)), key=lambda i: self.part.Shape.Vertexes[i].X)))]
        self.document.recompute()
        api.update_mesh(mesh)
        report = api.solve_to(self.analysis, 0.01)
        self.assertLess(mesh.TetCount, 20_000)
        self.assertIn("are still off by about", " ".join(map(english, report["warnings"])))

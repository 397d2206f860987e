# SPDX-License-Identifier: GPL-3.0-or-later
"""Problems with a known solution: the error of second order falls below one per cent as the tets get finer."""
import shutil
import unittest

from analyses import LONG, add_material, add_solver, hold_plane, print_table, quantity, solve
from freecad.featuremesh import api, mesh_object
from parts import Vector, circle, new_document, rectangle

import ObjectsFem

WITHIN = 0.01
MODULUS = 210000.0


def faces_at(part, axis, value):
    """Names of the plane faces of `part` normal to the axis ("x", "y", "z") there."""
    number = "xyz".index(axis)
    names = []
    for i, face in enumerate(part.Shape.Faces, 1):
        box = face.BoundBox
        ends = (box.XMin, box.XMax, box.YMin, box.YMax, box.ZMin, box.ZMax)[2 * number:2 * number + 2]
        if all(abs(end - value) < 1e-6 for end in ends):
            names.append("Face%d" % i)
    return names


def fresh_analysis(part, poisson):
    document = part.Document
    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    add_solver(document, analysis)
    add_material(document, analysis, "Steel", {"Name": "Steel", "YoungsModulus": "%g MPa" % MODULUS, "PoissonRatio": "%g" % poisson})
    return analysis


@unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
class Convergence(unittest.TestCase):

    def study(self, title, part, analysis, sizes, orders, measure, truth):
        """Meshes, solves and measures with each size and order; gives the relative errors by (order, size)."""
        mesh = api.add_mesh(part, sizes[0], order=1)
        errors, rows = {}, []
        for order in orders:
            for size in sizes:
                mesh.Size, mesh.Order = size, "2nd" if order == 2 else "1st"
                part.Document.recompute()
                self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
                value = measure(solve(analysis))
                errors[order, size] = value / truth - 1
                rows.append((order, "%g" % size, mesh.NodeCount, mesh.TetCount, "%.5g" % value, "%.5g" % truth,
                             "%+.2f" % (100 * errors[order, size])))
        print_table(title, ("order", "size, mm", "nodes", "tets", "found", "true", "off, %"), rows)
        return errors

    def test_cantilever(self):
        """Without Poisson's effect the clamped end is that of a beam with shear (Timoshenko), whose deflection is known."""
        length, side, force = 100.0, 10.0, 1000.0
        document = new_document()
        beam = document.addObject("Part::Box", "Beam")
        beam.Length, beam.Width, beam.Height = length, side, side
        document.recompute()
        analysis = fresh_analysis(beam, 0.0)
        fixed = ObjectsFem.makeConstraintFixed(document, "Fixed")
        fixed.References = [(beam, faces_at(beam, "x", 0)[0])]
        load = ObjectsFem.makeConstraintForce(document, "Force")
        load.References = [(beam, faces_at(beam, "x", length)[0])]
        load.Force = quantity(force, "N")
        upright = next(i for i, edge in enumerate(beam.Shape.Edges, 1) if abs(edge.tangentAt(edge.FirstParameter).z) > 0.99)
        load.Direction = (beam, ["Edge%d" % upright])
        analysis.addObject(fixed)
        analysis.addObject(load)
        truth = (force * length ** 3 / (3 * MODULUS * side ** 4 / 12) + force * length / (5 / 6 * MODULUS / 2 * side ** 2))
        sizes = (10.0, 5.0, 2.5) if LONG else (10.0, 5.0)
        errors = self.study("Cantilever: deflection, mm", beam, analysis, sizes, (1, 2), lambda found: found["displacement_z"], truth)
        for order in (1, 2):
            self.assertLess(abs(errors[order, sizes[-1]]), abs(errors[order, sizes[0]]))
        self.assertLess(abs(errors[2, sizes[-1]]), WITHIN)
        self.assertLess(abs(errors[2, sizes[0]]), abs(errors[1, sizes[-1]]))

    def test_plate_with_a_hole(self):
        """A strip in tension, in plane strain; the hole is half as wide as the strip (Howland 1930: 4.32 times the tension)."""
        width, length, radius, depth, tension, factor = 40.0, 80.0, 10.0, 2.0, 100.0, 4.32
        document = new_document()
        body = document.addObject("PartDesign::Body", "Quarter")
        outline = body.newObject("Sketcher::SketchObject", "Outline")
        rectangle(outline, 0, 0, length, width / 2)
        plate = body.newObject("PartDesign::Pad", "Plate")
        plate.Profile, plate.Length = outline, depth
        ring = body.newObject("Sketcher::SketchObject", "Ring")
        circle(ring, 0, 0, radius)
        hole = body.newObject("PartDesign::Pocket", "Hole")
        hole.Profile, hole.Type, hole.Reversed = ring, "ThroughAll", True
        document.recompute()
        analysis = fresh_analysis(body, 0.3)
        for axis, values in (("x", (0,)), ("y", (0,)), ("z", (0, depth))):
            for value in values:
                hold_plane(document, analysis, "Hold_%s%d" % (axis, value), body, faces_at(body, axis, value), axis)
        pull = ObjectsFem.makeConstraintPressure(document, "Pull")
        pull.References = [(body, faces_at(body, "x", length)[0])]
        pull.Pressure, pull.Reversed = quantity(tension, "MPa"), True
        analysis.addObject(pull)

        def at_the_hole(found):
            """Mean of the stress along x over the edge of the hole where it is largest."""
            result = found["result"]
            nodes = result.Mesh.FemMesh.Nodes
            stresses = [stress for number, stress in zip(result.NodeNumbers, result.NodeStressXX)
                        if (nodes[number] - Vector(0, radius, nodes[number].z)).Length < 1e-4]
            return sum(stresses) / len(stresses) / tension

        sizes = (8.0, 4.0, 2.0, 1.0) if LONG else (4.0, 2.0)
        errors = self.study("Plate with a hole: stress concentration", body, analysis, sizes, (1, 2), at_the_hole, factor)
        for order in (1, 2):
            self.assertLess(abs(errors[order, sizes[-1]]), abs(errors[order, sizes[0]]))
        self.assertLess(abs(errors[2, sizes[-1]]), WITHIN if LONG else 5 * WITHIN)

# SPDX-License-Identifier: GPL-3.0-or-later
"""A part with an analysis and our mesh, for the tests of what solves it."""
import unittest

import FreeCAD
import ObjectsFem
from analyses import add_material, add_solver, quantity
from freecad.featuremesh import api, engine
from parts import new_document

STEEL = {"Name": "Steel", "YoungsModulus": "210000 MPa", "PoissonRatio": "0.30", "Density": "7850 kg/m^3"}
SOFT = {"Name": "Soft", "YoungsModulus": "70000 MPa", "PoissonRatio": "0.33", "Density": "2700 kg/m^3"}
HAS_SOLVER = not engine.load().statics_missing()


def faces_at(part, axis, value):
    """Names of the plane faces of `part` normal to the axis (0, 1, 2) there."""
    found = []
    for number, face in enumerate(part.Shape.Faces, 1):
        box = face.BoundBox
        ends = ((box.XMin, box.XMax), (box.YMin, box.YMax), (box.ZMin, box.ZMax))[axis]
        if all(abs(end - value) < 1e-6 for end in ends):
            found.append("Face%d" % number)
    return found


def edges_along(part, axis):
    return ["Edge%d" % i for i, edge in enumerate(part.Shape.Edges, 1)
            if len(edge.Vertexes) == 2 and abs(edge.tangentAt(edge.FirstParameter)[axis]) > 0.999]


class Case(unittest.TestCase):
    """A part with an analysis and our mesh."""

    def setUp(self):
        self.document = new_document()

    def box(self, length=40.0, width=20.0, height=10.0):
        box = self.document.addObject("Part::Box", "Box")
        box.Length, box.Width, box.Height = length, width, height
        self.document.recompute()
        return box

    def drilled_box(self):
        box, drill = self.box(), self.document.addObject("Part::Cylinder", "Drill")
        drill.Radius, drill.Height, drill.Placement.Base = 4, 10, FreeCAD.Vector(20, 10, 0)
        cut = self.document.addObject("Part::Cut", "Cut")
        cut.Base, cut.Tool = box, drill
        self.document.recompute()
        return cut

    def analysis(self, materials=(("Steel", STEEL, ()),)):
        analysis = ObjectsFem.makeAnalysis(self.document, "Analysis")
        add_solver(self.document, analysis)
        for name, values, references in materials:
            add_material(self.document, analysis, name, values, references)
        return analysis

    def add(self, analysis, make, name, references, **values):
        member = make(self.document, name)
        if references:
            member.References = references
        for title, value in values.items():
            setattr(member, title, value)
        analysis.addObject(member)
        return member

    def fix(self, analysis, part, faces):
        return self.add(analysis, ObjectsFem.makeConstraintFixed, "Fixed", [(part, faces)])

    def force(self, analysis, part, subs, newtons=1000.0, name="Force", along=2):
        return self.add(analysis, ObjectsFem.makeConstraintForce, name, [(part, subs)], Force=quantity(newtons, "N"),
                        Direction=(part, [edges_along(part, along)[0]]))

    def mesh(self, part, size=5.0, order=1):
        mesh = api.add_mesh(part, size, order=order)
        self.document.recompute()
        self.assertGreater(mesh.TetCount, 0)
        return mesh

    def held_box(self, size=4.0):
        """A meshed box that is held at one end and loaded at the other; (the box, its analysis)."""
        part = self.box()
        analysis = self.analysis()
        self.fix(analysis, part, faces_at(part, 0, 0))
        self.force(analysis, part, faces_at(part, 0, 40))
        self.mesh(part, size)
        return part, analysis

# SPDX-License-Identifier: GPL-3.0-or-later
"""A block with a groove, and loads on it, for tests of what becomes of references."""
import json
import unittest

import ObjectsFem
from freecad.featuremesh import api
from freecad.featuremesh.messages import in_english
from parts import new_document, rectangle
from test_references import names_of

NEAR = 1e-4


def warnings_of(mesh):
    return in_english(json.loads(mesh.Report))["warnings"]


class BlockParts(unittest.TestCase):
    """What tests of blocks share."""

    def setUp(self):
        self.document = new_document()
        self.analysis = ObjectsFem.makeAnalysis(self.document, "Analysis")

    def load(self, target, name):
        load = ObjectsFem.makeConstraintPressure(self.document, "Load")
        load.References = [(target, name)]
        self.analysis.addObject(load)
        return load

    def face_at(self, part, axis, value):
        name, = ["Face%d" % n for n, face in enumerate(part.Shape.Faces, 1)
                 if abs(getattr(face.BoundBox, axis + "Min") - value) < NEAR and abs(getattr(face.BoundBox, axis + "Max") - value) < NEAR]
        return name

    def mesh_of(self, part):
        self.mesh = api.add_mesh(part, 5, order=1)
        self.document.recompute()

    def area_of(self, part, load):
        return sum(part.Shape.getElement(name).Area for _, name in names_of(load))

    def block(self):
        body = self.document.addObject("PartDesign::Body", "Body")
        sketch = body.newObject("Sketcher::SketchObject", "BlockSketch")
        rectangle(sketch, 0, 0, 100, 20)
        pad = body.newObject("PartDesign::Pad", "Block")
        pad.Profile, pad.Length = sketch, 20
        self.document.recompute()
        return body

    def groove(self, body, x=40):
        sketch = body.newObject("Sketcher::SketchObject", "GrooveSketch")
        sketch.Placement.Base.z = 20
        rectangle(sketch, x, -5, 10, 30)
        pocket = body.newObject("PartDesign::Pocket", "Groove")
        pocket.Profile, pocket.Length = sketch, 5
        body.Tip = pocket
        self.document.recompute()
        return pocket

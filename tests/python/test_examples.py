# SPDX-License-Identifier: GPL-3.0-or-later
"""The example parts: what their scripts make, and that the documents in the repository are the same."""
import math
import os
import sys
import unittest

import FreeCAD as App
from freecad.featuremesh import api

EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "resources", "examples")
sys.path.insert(0, EXAMPLES)

from all_examples import MAKERS  # noqa: E402

BLOCK_AND_CYLINDER = 80 * 50 * 20 + math.pi * 12 ** 2 * 40
# Volume and faces of the same bracket built from primitives with OCCT alone.
BRACKET_VOLUME, BRACKET_FACES = 166101.79030383, 21


def part_of(document):
    return document.getObject("Body") or document.getObject("Flange")


def names_of(document):
    """Without origins, which each FreeCAD makes in its own way."""
    return [obj.Name for obj in document.Objects if not obj.TypeId.startswith("App::")]


class Examples(unittest.TestCase):
    def setUp(self):
        self.documents = []

    def tearDown(self):
        for document in self.documents:
            App.closeDocument(document.Name)

    def made(self, name):
        self.documents.append(MAKERS[name]())
        return self.documents[-1]

    def stored(self, name):
        self.documents.append(App.openDocument(os.path.join(EXAMPLES, name + ".FCStd")))
        return self.documents[-1]

    def test_stored_documents_are_what_the_scripts_make(self):
        for name in MAKERS:
            with self.subTest(example=name):
                made, stored = part_of(self.made(name)), part_of(self.stored(name))
                self.assertAlmostEqual(made.Shape.Volume, stored.Shape.Volume, delta=1e-9 * made.Shape.Volume)
                self.assertEqual(len(made.Shape.Faces), len(stored.Shape.Faces))
                self.assertEqual(names_of(made.Document), names_of(stored.Document))

    def test_every_example_is_one_valid_solid_with_an_analysis(self):
        for name in MAKERS:
            with self.subTest(example=name):
                document = self.made(name)
                self.assertEqual([o.Name for o in document.Objects if "Invalid" in o.State], [])
                self.assertTrue(part_of(document).Shape.isValid())
                self.assertEqual(len(part_of(document).Shape.Solids), 1)
                self.assertEqual(len(document.getObject("Analysis").Group), 4)

    def test_volumes(self):
        bracket = part_of(self.made("bracket")).Shape
        self.assertAlmostEqual(bracket.Volume, BRACKET_VOLUME, delta=1e-3)
        self.assertEqual(len(bracket.Faces), BRACKET_FACES)
        self.assertAlmostEqual(part_of(self.made("block_and_cylinder")).Shape.Volume, BLOCK_AND_CYLINDER, delta=1e-6)
        tool, stiffened = part_of(self.made("tool")), part_of(self.made("tool_with_stiffener"))
        self.assertAlmostEqual(stiffened.Shape.Volume - tool.Shape.Volume, 110 * 5 * 6, delta=1e-6)

    def test_sketches_are_fully_constrained(self):
        for name in MAKERS:
            for sketch in (o for o in self.made(name).Objects if o.TypeId == "Sketcher::SketchObject"):
                self.assertTrue(sketch.FullyConstrained, f"{name}: {sketch.Name}")

    def test_a_hole_of_the_bracket_moves_by_its_named_constraint(self):
        document = self.made("bracket")
        document.getObject("HoleSketch").setDatum("Hole6X", App.Units.Quantity("105 mm"))
        document.recompute()
        shape = part_of(document).Shape
        self.assertAlmostEqual(shape.Volume, BRACKET_VOLUME, delta=1e-3)
        self.assertFalse(shape.isInside(App.Vector(102, 70, 7), 1e-6, True))
        self.assertTrue(shape.isInside(App.Vector(112, 70, 7), 1e-6, True))

    def test_forces_and_supports_hold_the_faces_meant(self):
        document = self.made("bracket")
        for name, place in (("Fixed", App.Vector(120, 40, 7.5)), ("Force", App.Vector(40, 40, 45))):
            (part, faces), = document.getObject(name).References
            self.assertEqual(part.Name, "Body")
            self.assertLess((part.Shape.getElement(faces[0]).CenterOfMass - place).Length, 1e-6)

    def test_the_estimate_of_elements_is_within_15_percent(self):
        for name, shares in (("bracket", (15, 18, 30, 50)), ("csg_flange", (12, 18, 30, 50)), ("tool", (18, 30, 50)), ("block_and_cylinder", (12, 18, 30))):
            part = part_of(self.stored(name))
            for share in shares:
                mesh = api.add_mesh(part, part.Shape.BoundBox.DiagonalLength / share, 1, join_analysis=False)
                estimate = api.estimate_tets(mesh)
                self.assertAlmostEqual(estimate / api.update_mesh(mesh)["tets"], 1, delta=0.15, msg="%s, diagonal / %d" % (name, share))

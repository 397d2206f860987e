# SPDX-License-Identifier: GPL-3.0-or-later
"""What a script may ask for by mistake is refused in a sentence: parts without a shape, objects that are gone, settings without sense, sizes far too small."""
import unittest

import FreeCAD
import ObjectsFem
import Part
from freecad.featuremesh import api, engine
from freecad.featuremesh.errors import UserError
from freecad.featuremesh.too_fine import _elements_around
from parts import new_document, plate_with_hole


class Parts(unittest.TestCase):
    def setUp(self):
        self.document = new_document()

    def refused(self, words, part, *settings, **more):
        count = len(self.document.Objects)
        with self.assertRaisesRegex(UserError, words):
            api.add_mesh(part, *settings, **more)
        self.assertEqual(len(self.document.Objects), count)

    def box(self):
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        return box

    def test_no_shape(self):
        self.refused("Empty has no shape", self.document.addObject("Part::Feature", "Empty"))
        self.refused("Body has no shape", self.document.addObject("PartDesign::Body", "Body"))
        self.refused("Group has no part with a solid", self.document.addObject("App::DocumentObjectGroup", "Group"))
        point = self.document.addObject("Part::Feature", "Point")
        point.Shape = Part.Vertex(0, 0, 0)
        self.refused("Point has no shape", point)

    def test_no_recompute(self):
        self.refused("Box has no shape yet; recompute the document first", self.document.addObject("Part::Box", "Box"))
        self.document.recompute()
        self.assertGreater(api.update_mesh(api.add_mesh(self.document.Box, 3))["tets"], 0)

    def test_an_object_in_error(self):
        box = self.box()
        box.Length = 0
        self.document.recompute()
        self.refused("FreeCAD could not compute Box", box)

    def test_no_object(self):
        for what in (None, "Box", Part.makeBox(1, 1, 1)):
            self.refused("no object of a document", what)

    def test_gone(self):
        other = FreeCAD.newDocument("Other")
        box = other.addObject("Part::Box", "Box")
        other.recompute()
        mesh = api.add_mesh(box, 3)
        FreeCAD.closeDocument("Other")
        self.refused("its document was closed", box)
        with self.assertRaisesRegex(UserError, "its document was closed"):
            api.update_mesh(mesh)

    def test_a_hidden_body_is_meshed(self):
        body = plate_with_hole(self.document)
        body.Visibility = False
        self.assertGreater(api.update_mesh(api.add_mesh(body, 6, order=1))["tets"], 0)

    def test_settings(self):
        box = self.box()
        self.refused("greater than 0 mm", box, float("nan"))
        self.refused("x is no length", box, "x")
        self.refused("3 kg is no length", box, "3 kg")
        self.refused("not 3", box, 3, order=3)
        self.refused("not 0", box, elements=0)
        self.assertEqual(api.add_mesh(box, "0.3 cm").Size.Value, 3)
        self.assertEqual(api.add_mesh(box, FreeCAD.Units.Quantity("0.3 cm")).Size.Value, 3)


class FarTooSmall(unittest.TestCase):
    def setUp(self):
        self.document = new_document()
        self.body = plate_with_hole(self.document)
        self.mesh = api.add_mesh(self.body, 4, order=1)

    def refused(self, words):
        with self.assertRaisesRegex(UserError, words):
            api.update_mesh(self.mesh)
        with self.assertRaisesRegex(UserError, words):
            api.estimate_tets(self.mesh)
        self.assertRegex(self.mesh.Status, words)

    def refine(self, places, size, label):
        region = ObjectsFem.makeMeshRegion(self.document, self.mesh, size)
        region.Label, region.References = label, [(self.body, place) for place in places]
        return region

    def test_the_size(self):
        self.mesh.Size = 1e-9
        self.refused("a size of 1e-09 mm would make more than a million million elements; at most 50 million are made")
        self.mesh.Size = 0.01
        with self.assertRaisesRegex(engine.load().InputError, "A size of 0.01 mm would make about [0-9]+ million"):
            api.update_mesh(self.mesh)

    def test_a_zone_is_named(self):
        middle = FreeCAD.Placement(self.body.Shape.BoundBox.Center, FreeCAD.Rotation())
        api.add_size_zone(self.mesh, "Sphere", placement=middle, inner=0.8, radius=2).Label = "Mild"
        api.add_size_zone(self.mesh, "Sphere", placement=middle, inner=0.01, radius=5).Label = "Fierce"
        with self.assertRaisesRegex(engine.load().InputError, "The refinement Fierce with a size of 0.01 mm would make about [0-9]+ million elements; at most 50"):
            api.update_mesh(self.mesh)

    def test_a_refinement_is_named(self):
        self.refine(["Face1"], 1.0, "Side")
        fine = self.refine(["Face6", "Edge1"], 0.001, "Top")
        self.refused(r"the refinement MeshRegion001 \(Top\) with 0.001 mm at Face6 would make about [0-9]+ million elements")
        fine.CharacteristicLength = 1e-9
        self.refused(r"\(Top\) with 1e-09 mm at Face6 would make more than a million million elements")
        fine.CharacteristicLength = 0.01   # what makes a sizing field for minutes, though it is not beyond all that can be meshed
        self.refused(r"\(Top\) with 0.01 mm at Face6 would make about [0-9]+ million elements; around one face or edge at most 10 million are made")
        fine.CharacteristicLength = 1.0
        self.assertGreater(api.update_mesh(self.mesh)["tets"], 0)

    def test_the_estimate_is_near_that_of_the_engine(self):
        """What a size on a face or an edge adds, told with and without a sizing field."""
        raw, options = api.estimate_input(self.mesh)
        for growth in (1.15, 1.3, 1.6):
            options.update(growth=growth, local=[])
            plain = api.estimated_tets(raw, options)
            for entity, bounds in (("Face1", (0.4, 2)), ("Face6", (0.4, 2)), ("Edge1", (0.3, 3))):
                added = api.estimated_tets(raw, dict(options, local=[(entity, 0.5)])) - plain
                ratio = _elements_around(self.body.Shape, entity, 0.5, 4.0, growth - 1) / added
                self.assertTrue(bounds[0] < ratio < bounds[1], (entity, growth, ratio))

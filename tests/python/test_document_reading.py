# SPDX-License-Identifier: GPL-3.0-or-later
"""What reading.py makes of a document: which objects, in which order, and their volumes in the final shape's frame."""
import os
import tempfile
import unittest

import FreeCAD
import Part
from freecad.featuremesh import engine, reading, versions
from freecad.featuremesh.errors import UserError
from freecad.featuremesh.properties import properties_of
from parts import Vector, new_document, placement, plate_with_hole


def shapes_in(raw):
    handle, path = tempfile.mkstemp(".bin")
    os.close(handle)
    with open(path, "wb") as stream:
        stream.write(raw["shapes"])
    compound = Part.Shape()
    compound.importBinary(path)
    os.unlink(path)
    return compound.SubShapes


def by_name(raw):
    return {record["name"]: record for record in raw["records"]}


class Reading(unittest.TestCase):

    def assert_same_solid(self, one, other):
        """The two fill the same space: their symmetric difference has no volume."""
        self.assertGreater(one.Volume, 0)
        self.assertLess(one.cut(other).Volume + other.cut(one).Volume, 1e-6 * one.Volume)

    def assert_order(self, raw):
        """What a record links to comes before it."""
        seen = set()
        for record in raw["records"]:
            for _, target, _ in record["links"]:
                self.assertIn(target, seen, "%s comes before its %s" % (record["name"], target))
            seen.add(record["name"])

    def test_own_volumes_of_a_moved_body_replay_its_final_shape(self):
        document = new_document()
        body = plate_with_hole(document)
        body.Placement = placement(5, -3, 20, 37, (1, 2, 3))
        document.recompute()
        raw = reading.read_document(body)
        shapes, records = shapes_in(raw), by_name(raw)
        replayed = shapes[records["Plate"]["own_volume"]].cut(shapes[records["Hole"]["own_volume"]])
        self.assert_same_solid(replayed, body.Shape)
        self.assert_same_solid(shapes[records["Hole"]["shape"]], body.Shape)
        self.assert_order(raw)

    @unittest.skipUnless(versions.version() >= (1, 1), "no feature can be suppressed")
    def test_a_suppressed_feature_has_the_shape_before_it(self):
        """FreeCAD 1.1 lists both once in a compound, so that the part's shape was taken for another one, and edges of loads were looked for there."""
        body = plate_with_hole(new_document())
        body.newObject("PartDesign::AdditiveCylinder", "Post").Placement.Base.z = 10
        body.Document.recompute()
        body.Document.Hole.Suppressed = True
        body.Document.recompute()
        raw = reading.read_document(body)
        self.assertEqual(len(shapes_in(raw)), max(max(record["shape"], record["own_volume"]) for record in raw["records"]) + 1)
        self.assert_same_solid(reading.shape_of_record(raw), body.Shape)

    def test_feature_attached_off_the_origin(self):
        document = new_document()
        body = plate_with_hole(document)
        cylinder = body.newObject("PartDesign::AdditiveCylinder", "Post")
        cylinder.Radius, cylinder.Height = 3, 15
        cylinder.Placement = placement(45, 30, 5, 20, (1, 0, 0))
        document.recompute()
        raw = reading.read_document(body)
        shapes, records = shapes_in(raw), by_name(raw)
        replayed = (shapes[records["Plate"]["own_volume"]].cut(shapes[records["Hole"]["own_volume"]])
                    .fuse(shapes[records["Post"]["own_volume"]]))
        self.assert_same_solid(replayed, body.Shape)

    def test_boolean_with_a_placement_of_its_own(self):
        document = new_document()
        box = document.addObject("Part::Box", "Box")
        tool = document.addObject("Part::Cylinder", "Tool")
        tool.Placement = placement(5, 5, -1)
        box.Placement = placement(1, 0, 0, 10)
        cut = document.addObject("Part::Cut", "Cut")
        cut.Base, cut.Tool = box, tool
        cut.Placement = placement(100, 0, 0, 90)
        document.recompute()
        raw = reading.read_document(cut)
        shapes, records = shapes_in(raw), by_name(raw)
        replayed = shapes[records["Box"]["shape"]].cut(shapes[records["Tool"]["shape"]])
        self.assert_same_solid(replayed, cut.Shape)

    def test_body_in_a_moved_boolean(self):
        document = new_document()
        body = plate_with_hole(document)
        body.Placement = placement(0, 0, 7)
        tool = document.addObject("Part::Box", "Tool")
        tool.Placement = placement(30, 10, 0)
        cut = document.addObject("Part::Cut", "Cut")
        cut.Base, cut.Tool, cut.Placement = body, tool, placement(3, 4, 5, 45)
        document.recompute()
        raw = reading.read_document(cut)
        shapes, records = shapes_in(raw), by_name(raw)
        replayed = (shapes[records["Plate"]["own_volume"]].cut(shapes[records["Hole"]["own_volume"]])
                    .cut(shapes[records["Tool"]["shape"]]))
        self.assert_same_solid(replayed, cut.Shape)
        self.assert_order(raw)

    def test_link_lies_where_the_link_is(self):
        document = new_document()
        box = document.addObject("Part::Box", "Box")
        box.Placement = placement(50, 0, 0)
        link = document.addObject("App::Link", "Link")
        link.LinkedObject = box
        link.Placement = placement(0, 30, 0, 30)
        document.recompute()
        for transform in (False, True):
            link.LinkTransform = transform
            document.recompute()
            raw = reading.read_document(link)
            shapes, records = shapes_in(raw), by_name(raw)
            self.assert_same_solid(shapes[records["Box"]["shape"]], Part.getShape(link))
            self.assert_same_solid(shapes[records["Link"]["shape"]], Part.getShape(link))

    def test_only_what_lies_before_the_tip(self):
        document = new_document()
        body = plate_with_hole(document)
        body.Tip = document.getObject("Plate")
        document.recompute()
        records = by_name(reading.read_document(body))
        self.assertIn("Plate", records)
        self.assertNotIn("Hole", records)

    def test_parameters(self):
        document = new_document()
        body = plate_with_hole(document)
        sheet = document.addObject("Spreadsheet::Sheet", "Sheet")
        sheet.set("B2", "=12 mm")
        sheet.setAlias("B2", "thickness")
        document.recompute()
        document.getObject("Plate").setExpression("Length", "Sheet.thickness")
        document.recompute()
        raw = reading.read_document(body)
        records = by_name(raw)
        self.assertEqual(records["Plate"]["numbers"]["Length"], 12.0)
        self.assertEqual(records["Hole"]["numbers"]["Reversed"], 1.0)
        self.assertEqual(records["Hole"]["texts"]["Type"], "ThroughAll")
        self.assertEqual(records["HoleSketch"]["numbers"]["Radius"], 6.0)
        self.assertEqual(records["Sheet"]["numbers"]["thickness"], 12.0)
        self.assertEqual([records[name]["measures"].get(key) for name, key in (("Plate", "Length"), ("Hole", "Reversed"), ("HoleSketch", "Radius"), ("Sheet", "thickness"))],
                         ["length", None, "length", "length"])
        self.assertEqual(records["HoleSketch"]["shape"], -1)
        self.assert_order(raw)

    def test_angle_constraints_are_degrees(self):
        import Sketcher
        document = new_document()
        sketch = document.addObject("Sketcher::SketchObject", "Sketch")
        sketch.addGeometry(Part.LineSegment(Vector(0, 0), Vector(10, 10)))
        sketch.renameConstraint(sketch.addConstraint(Sketcher.Constraint("Angle", 0, 0.5)), "Slope")
        document.recompute()
        numbers, _, measures = properties_of(sketch, sketch.TypeId).parameters(sketch)
        self.assertAlmostEqual(numbers["Slope"], 28.64788975654116)
        self.assertEqual(measures["Slope"], "angle")

    def test_an_objects_own_property_is_read_by_its_own_type(self):
        document = new_document()
        tool = document.addObject("Part::Cylinder", "Tool")
        for kind in ("Part::Box", "Part::FeaturePython"):
            named, linked = document.addObject(kind, "Named"), document.addObject(kind, "Linked")
            named.addProperty("App::PropertyFloat", "Extra").Extra = 4
            linked.addProperty("App::PropertyLink", "Extra").Extra = tool
            self.assertEqual(properties_of(named, kind).parameters(named)[0]["Extra"], 4.0)
            self.assertNotIn("Extra", properties_of(linked, kind).parameters(linked)[0])
            self.assertEqual(properties_of(linked, kind).links(linked), [("Extra", tool, "")])
            self.assertEqual(properties_of(named, kind).links(named), [])

    def test_parameters_are_what_the_attributes_are(self):
        document = new_document()
        part = document.addObject("Part::Cylinder", "Round")
        part.Radius, part.Angle, part.MapMode, part.MapReversed = 3, 90, "ObjectXY", True
        part.AttachmentOffset = placement(1, 2, 3, 40, (0, 1, 0))
        numbers, texts, measures = properties_of(part, part.TypeId).parameters(part)
        self.assertEqual({name: numbers[name] for name in ("Radius", "Angle", "MapReversed", "MapPathParameter", "AttachmentOffset.Base.z")},
                         {"Radius": part.Radius.Value, "Angle": 90.0, "MapReversed": 1.0, "MapPathParameter": part.MapPathParameter,
                          "AttachmentOffset.Base.z": 3.0})
        self.assertAlmostEqual(numbers["AttachmentOffset.Angle"], 40)
        self.assertEqual([numbers["AttachmentOffset.Axis." + axis] for axis in "xyz"], list(part.AttachmentOffset.Rotation.Axis))
        self.assertEqual({name: measures.get(name) for name in ("Radius", "Angle", "MapReversed", "AttachmentOffset.Base.z", "AttachmentOffset.Axis.z")},
                         {"Radius": "length", "Angle": "angle", "MapReversed": None, "AttachmentOffset.Base.z": "length", "AttachmentOffset.Axis.z": None})
        self.assertEqual(texts, {name: getattr(part, name) for name in texts})   # FreeCAD 1.1 has one more than 0.20
        self.assertEqual(texts["MapMode"], "ObjectXY")
        self.assertNotIn("Label", texts)
        self.assertFalse({"Visibility", "Placement.Base.x", "Label2"} & set(numbers))

    def test_error_is_freecads_own(self):
        document = new_document()
        body = plate_with_hole(document)
        document.getObject("Plate").Length = 0
        document.recompute()
        message = by_name(reading.read_document(body))["Plate"]["error"]
        self.assertEqual(message, document.getObject("Plate").getStatusString())
        self.assertTrue(message)

    def test_faces_stay_shared_between_features(self):
        document = new_document()
        body = plate_with_hole(document)
        body.newObject("PartDesign::AdditiveBox", "Block")  # or the hole would be the tip, which the body's copy stands for
        document.recompute()
        raw = reading.read_document(body)
        shapes, records = shapes_in(raw), by_name(raw)
        before, after = shapes[records["Plate"]["shape"]], shapes[records["Hole"]["shape"]]
        shared = [one for one in before.Faces if any(one.isPartner(other) for other in after.Faces)]
        self.assertEqual(len(shared), 4)  # the plate's sides, which the hole does not touch

    def test_the_shape_of_a_body_stands_for_that_of_its_tip(self):
        document = new_document()
        body = plate_with_hole(document)
        body.Placement = placement(5, -3, 20, 37, (1, 2, 3))
        document.recompute()
        raw = reading.read_document(body)
        records = by_name(raw)
        self.assertEqual(records["Hole"]["shape"], records["Body"]["shape"])
        self.assertEqual(len(shapes_in(raw)), 4)  # two volumes, the plate, the body
        document.getObject("Hole").touch()
        records = by_name(reading.read_document(body))
        self.assertNotEqual(records["Hole"]["shape"], records["Body"]["shape"])

    def test_a_tip_that_is_told_from_its_shape_keeps_it(self):
        document = new_document()
        body = plate_with_hole(document)
        fillet = body.newObject("PartDesign::Fillet", "Fillet")
        fillet.Base, fillet.Radius = (document.getObject("Hole"), ["Edge1"]), 1
        document.recompute()
        raw = reading.read_document(body)
        shapes, records = shapes_in(raw), by_name(raw)
        self.assertNotEqual(records["Fillet"]["shape"], records["Body"]["shape"])
        before, after = shapes[records["Hole"]["shape"]], shapes[records["Fillet"]["shape"]]
        self.assertTrue(any(one.isPartner(other) for one in before.Faces for other in after.Faces))

    def test_a_tip_that_is_placed_by_another_link_keeps_its_shape(self):
        document = new_document()
        body = plate_with_hole(document)
        body.Placement = placement(0, 0, 7)
        link = document.addObject("App::Link", "Link")
        link.LinkedObject, link.Placement = document.getObject("Hole"), placement(100)
        both = document.addObject("Part::MultiFuse", "Both")
        both.Shapes = [link, body]
        document.recompute()
        raw = reading.read_document(both)
        shapes, records = shapes_in(raw), by_name(raw)
        self.assertGreater(shapes[records["Hole"]["shape"]].BoundBox.XMin, 99)
        self.assert_same_solid(shapes[records["Body"]["shape"]], body.Shape)

    def test_long_chain_of_booleans(self):
        document = new_document()
        part = document.addObject("Part::Box", "Box")
        for index in range(1200):
            cut = document.addObject("Part::Compound", "Step%d" % index)
            cut.Links = [part]
            part = cut
        part.Shape = Part.makeBox(1, 1, 1)
        self.assertEqual(len(reading.dependencies(part)), 1201)


class Finding(unittest.TestCase):

    def test_the_only_body(self):
        document = new_document()
        body = plate_with_hole(document)
        self.assertIs(reading.find_meshable(document), body)

    def test_operands_do_not_count(self):
        document = new_document()
        box = document.addObject("Part::Box", "Box")
        tool = document.addObject("Part::Cylinder", "Tool")
        cut = document.addObject("Part::Cut", "Cut")
        cut.Base, cut.Tool = box, tool
        document.recompute()
        self.assertIs(reading.find_meshable(document), cut)
        self.assertIs(reading.find_meshable(document, "Box"), box)

    def test_several_are_listed(self):
        document = new_document()
        for name in ("First", "Second"):
            document.addObject("Part::Box", name)
        document.recompute()
        with self.assertRaisesRegex(UserError, "mesh: First, Second$"):
            reading.find_meshable(document)

    def test_none(self):
        document = new_document()
        document.addObject("App::FeaturePython", "Plan")
        document.recompute()
        with self.assertRaisesRegex(UserError, "has no part to mesh"):
            reading.find_meshable(document)

    def test_without_a_solid_faces_count_and_without_these_edges(self):
        document = new_document()
        wire = document.addObject("Part::Feature", "Wire")
        wire.Shape = Part.makeLine((0, 0, 0), (10, 0, 0))
        self.assertIs(reading.find_meshable(document), wire)
        other = document.copyObject(wire)
        with self.assertRaisesRegex(UserError, "^the document has several parts, .*Wire, Wire001"):
            reading.find_meshable(document)
        document.removeObject(other.Name)
        plane = document.addObject("Part::Plane", "Plane")
        document.recompute()
        self.assertIs(reading.find_meshable(document), plane)
        box = document.addObject("Part::Box", "Box")
        document.recompute()
        self.assertIs(reading.find_meshable(document), box)
        self.assertIs(reading.find_meshable(document, "Plane"), plane)

    def test_a_sketch_of_which_nothing_is_made(self):
        document = new_document()
        sketch = document.addObject("Sketcher::SketchObject", "Frame")
        sketch.addGeometry(Part.LineSegment(FreeCAD.Vector(0, 0), FreeCAD.Vector(30, 0)))
        document.recompute()
        self.assertIs(reading.find_meshable(document), sketch)
        self.assertIs(reading.find_meshable(document, "Frame"), sketch)
        extrusion = document.addObject("Part::Extrusion", "Wall")
        extrusion.Base, extrusion.Dir, extrusion.LengthFwd = sketch, FreeCAD.Vector(0, 0, 1), 20
        document.recompute()
        self.assertIs(reading.find_meshable(document), extrusion)
        with self.assertRaisesRegex(UserError, "Frame has no solid"):
            reading.find_meshable(document, "Frame")

    def test_unknown_name_comes_with_a_near_one(self):
        document = new_document()
        plate_with_hole(document)
        with self.assertRaisesRegex(UserError, "did you mean Body"):
            reading.find_meshable(document, "Bodi")

    def test_label_works_as_a_name(self):
        document = new_document()
        body = plate_with_hole(document)
        body.Label = "My plate"
        self.assertIs(reading.find_meshable(document, "My plate"), body)

    def test_feature_without_a_solid(self):
        document = new_document()
        plate_with_hole(document)
        with self.assertRaisesRegex(UserError, "PlateSketch has no solid"):
            reading.find_meshable(document, "PlateSketch")

    def test_the_engine_means_the_same_types_by_references(self):
        raw = reading.read_document(plate_with_hole(new_document()))
        sketch = next(record for record in raw["records"] if record["type"] == "Sketcher::SketchObject")
        types = ("Sketcher::SketchObject", "Sketcher::SketchObjectPython", "Spreadsheet::Sheet", "App::Line", "App::Plane", "App::Point", "App::Origin",
                 "App::TextDocument", "PartDesign::Plane", "PartDesign::Line", "PartDesign::Point", "PartDesign::CoordinateSystem",
                 "Part::DatumPlane", "Part::DatumLine", "Part::DatumPoint", *reading.BINDERS, "PartDesign::LinearPattern", "Part::Box")
        raw["records"] = [{**sketch, "name": "Another%d" % i, "type": kind, "links": []} for i, kind in enumerate(types)] + raw["records"]
        roles = {feature["name"]: feature["role"] for feature in engine.load().read_tree(raw)["features"]}
        for i, kind in enumerate(types):
            by_engine = roles["Another%d" % i]
            self.assertEqual(by_engine == "reference", reading.is_reference_type(kind), kind)
            if kind in reading.BINDERS:
                self.assertEqual(by_engine, "base", kind)

    def test_a_part_with_a_binder_of_another_body(self):
        document = new_document()
        body = plate_with_hole(document)
        other = document.addObject("PartDesign::Body", "Other")
        binder = other.newObject("PartDesign::SubShapeBinder", "Binder")
        binder.Support = [(body, "")]
        document.recompute()
        with self.assertRaisesRegex(UserError, "Body"):
            found = reading.find_meshable(document)
            raise UserError(found.Name)

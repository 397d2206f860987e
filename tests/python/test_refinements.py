# SPDX-License-Identifier: GPL-3.0-or-later
"""Refinement zones in a document: sizes where they are asked for, local updates when they change, and a sentence for each that does nothing."""
import json
import unittest
from types import SimpleNamespace

import FreeCAD
import numpy as np
import ObjectsFem
from freecad.featuremesh import api, mesh_object, refinements, size_zone
from freecad.featuremesh.errors import UserError
from freecad.featuremesh.messages import english, in_english
from meshed_plate import MeshedPlate, SIZE, points_of
from parts import placement

ALL_KINDS = {"Box": {"length": 8, "width": 6, "height": 4}, "Sphere": {"radius": 4}, "Cylinder": {"radius": 3, "height": 6}}
CENTRE = FreeCAD.Vector(45, 20, 5)


def sides_of(mesh):
    """(middles of the sides of all tets, their lengths), mm."""
    arrays = mesh.Proxy.arrays(mesh)
    corners = arrays["points"][arrays["tets"]]
    pairs = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)]
    first, second = corners[:, [a for a, _ in pairs]].reshape(-1, 3), corners[:, [b for _, b in pairs]].reshape(-1, 3)
    return (first + second) / 2, np.linalg.norm(second - first, axis=1)


def mean_side(mesh, is_in):
    """The mean length of the sides whose middles are in a place."""
    middles, lengths = sides_of(mesh)
    chosen = is_in(middles)
    assert chosen.sum() > 20, chosen.sum()
    return lengths[chosen].mean()


def near(point, radius):
    return lambda middles: np.linalg.norm(middles - np.array(point), axis=1) < radius


class Zones(MeshedPlate):

    def warnings(self):
        return in_english(json.loads(self.mesh.Report))["warnings"]

    def sphere(self, inner=0.8, radius=4, at=CENTRE, **settings):
        return api.add_size_zone(self.mesh, "Sphere", placement=FreeCAD.Placement(at, FreeCAD.Rotation()), inner=inner, radius=radius, **settings)

    def test_each_kind_has_its_size_inside_and_leaves_the_rest_alone(self):
        coarse = mean_side(self.mesh, near((5, 35, 5), 8))
        for kind, measures in ALL_KINDS.items():
            with self.subTest(kind):
                place = FreeCAD.Placement(CENTRE, FreeCAD.Rotation(FreeCAD.Vector(0, 1, 0), 20))
                zone = api.add_size_zone(self.mesh, kind, placement=place, inner=0.8, **measures)
                self.document.recompute()
                self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)
                middle = place.multVec({"Box": FreeCAD.Vector(4, 3, 2), "Cylinder": FreeCAD.Vector(0, 0, 3)}.get(kind, FreeCAD.Vector()))
                self.assertAlmostEqual(mean_side(self.mesh, near(middle, 1.5)), 0.85, delta=0.15)
                self.assertAlmostEqual(mean_side(self.mesh, near((5, 35, 5), 8)), coarse, delta=0.02)
                self.assertIsNone(json.loads(self.mesh.Report)["fallback"])
                self.document.removeObject(zone.Name)
                self.document.recompute()

    def test_a_zone_that_is_added_moved_and_suppressed_changes_the_mesh_there_only(self):
        before = points_of(self.mesh)
        zone = self.sphere()
        self.document.recompute()
        self.assert_kept_far_from(before, [CENTRE])
        with_zone, fine = points_of(self.mesh), self.mesh.TetCount
        zone.Placement.Base = CENTRE + FreeCAD.Vector(3, 0, 0)
        self.document.recompute()
        self.assert_kept_far_from(with_zone, [CENTRE, zone.Placement.Base])
        moved = points_of(self.mesh)
        zone.Suppressed = True
        self.document.recompute()
        self.assert_kept_far_from(moved, [zone.Placement.Base])
        self.assertLess(self.mesh.TetCount, 0.5 * fine)
        self.assertIn("The refinement %s is suppressed and left out." % zone.Label, self.warnings())

    def assert_kept_far_from(self, before, places):
        """All nodes further from the places than sizes are felt there, and some that had to change with them, are as they were."""
        far = [number for number, point in before.items() if all((FreeCAD.Vector(*point) - place).Length > 4 + 4 * SIZE + 8 for place in places)]
        now = points_of(self.mesh)
        self.assertGreater(len(far), 200)
        self.assertEqual([number for number in far if now.get(number) != before[number]], [])
        self.assertIsNone(json.loads(self.mesh.Report)["fallback"])

    def test_by_distance_from_a_face_it_follows_that_face(self):
        hole = next(i for i, face in enumerate(self.body.Shape.Faces, 1) if face.Surface.TypeId == "Part::GeomCylinder")
        zone = api.add_size_zone(self.mesh, "Distance", [(self.body, "Face%d" % hole)], inner=0.9, distance=2)
        self.document.recompute()

        def around(x):
            return lambda middles: np.abs(np.hypot(middles[:, 0] - x, middles[:, 1] - 20) - 7) < 0.8

        self.assertAlmostEqual(mean_side(self.mesh, around(20)), 0.95, delta=0.15)
        before = points_of(self.mesh)
        self.edit(26)
        self.assertEqual([name for _, names in zone.References for name in names], ["Face%d" % hole])
        self.assertAlmostEqual(mean_side(self.mesh, around(26)), 0.95, delta=0.15)
        now = points_of(self.mesh)
        far = [number for number, point in before.items() if point[0] > 50]
        self.assertGreater(len(far), 50)
        self.assertEqual([number for number in far if now.get(number) != before[number]], [])

    def test_it_begins_in_the_middle_of_a_part_that_is_in_a_placed_container(self):
        container = self.document.addObject("App::Part", "Part")
        container.addObject(self.body)
        container.Placement = placement(100, 50, 0, 30)
        self.document.recompute()
        count = self.mesh.TetCount
        api.add_size_zone(self.mesh, inner=1)
        self.document.recompute()
        self.assertGreater(self.mesh.TetCount, 1.5 * count)

    def test_it_grows_to_the_outer_size_over_the_transition(self):
        self.sphere(inner=0.8, radius=3, outer=1.5, transition=8)
        self.document.recompute()
        self.assertAlmostEqual(mean_side(self.mesh, near(CENTRE, 2.5)), 0.85, delta=0.15)

        def at(distance):
            return lambda middles: np.abs(np.linalg.norm(middles - np.array(CENTRE), axis=1) - 3 - distance) < 1

        self.assertAlmostEqual(mean_side(self.mesh, at(4)), 1.2, delta=0.15)
        self.assertAlmostEqual(mean_side(self.mesh, at(8)), 1.55, delta=0.2)

    def test_of_several_in_one_place_the_smallest_counts(self):
        self.sphere(inner=2.0, radius=8)
        self.sphere(inner=1.0, radius=3)
        region = ObjectsFem.makeMeshRegion(self.document, self.mesh, 0.5, "Fine")
        region.References = [(self.body, "Vertex1")]
        self.document.recompute()
        self.assertAlmostEqual(mean_side(self.mesh, near(CENTRE, 2)), 1.05, delta=0.15)
        corner = self.body.Shape.Vertexes[0].Point
        self.assertLess(mean_side(self.mesh, near(corner, 1.2)), 1.0)

    def test_it_is_saved_with_the_document_and_updates_as_locally_then(self):
        self.sphere()
        self.document.recompute()
        before = points_of(self.mesh)
        self.save_and_reopen()
        zone, = self.mesh.MeshRegionList
        self.assertTrue(size_zone.is_zone(zone))
        self.assertEqual((zone.Kind, zone.InnerSize.Value, zone.Radius.Value), ("Sphere", 0.8, 4.0))
        zone.InnerSize = 0.6
        self.document.recompute()
        self.assert_kept_far_from(before, [CENTRE])

    def test_a_sentence_for_each_that_changes_nothing(self):
        far_away = self.sphere(at=FreeCAD.Vector(300, 0, 0))
        coarse = self.sphere(inner=5)
        nothing = api.add_size_zone(self.mesh, "Distance")
        plain = ObjectsFem.makeMeshRegion(self.document, self.mesh, 1.0, "Plain")
        without_size = ObjectsFem.makeMeshRegion(self.document, self.mesh, 0.0, "WithoutSize")
        without_size.References = [(self.body, "Face1")]
        steep = self.sphere(inner=0.8, outer=2.0, transition=1.0)
        self.document.recompute()
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)
        said = "\n".join(self.warnings())
        for zone, words in ((far_away, "lies outside the part"), (coarse, "changes nothing"), (nothing, "refers to nothing"), (plain, "refers to nothing"),
                            (without_size, "has no size"), (steep, "grows to 2 mm over 4 mm, not over 1 mm")):
            self.assertEqual(said.count("The refinement %s %s" % (zone.Label, words)), 1, said)

    def test_one_that_contradicts_itself_is_refused_by_name_and_the_old_mesh_stays(self):
        zone, before = self.sphere(), points_of(self.mesh)
        for name, value, words in (("Radius", 0, "has a radius of 0 mm"), ("InnerSize", 0, "has an inner size of 0 mm"), ("OuterSize", 0.5, "is coarser inside")):
            was = getattr(zone, name)
            setattr(zone, name, value)
            self.document.recompute()
            self.assertIn("The refinement %s %s" % (zone.Label, words), self.mesh.Status)
            self.assertEqual(points_of(self.mesh), before)
            setattr(zone, name, was)
        self.document.recompute()
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)

    def test_what_makes_no_sense_is_refused_at_once(self):
        count = len(self.document.Objects)
        for words, arguments, settings in (("one of Box", ["Cone"], {}), ("no radius", ["Box"], {"radius": 3}),
                                           ("select faces", ["Distance", []], {}), ("local size is for", ["Distance", [(self.body, "")]], {})):
            with self.assertRaisesRegex(UserError, words):
                api.add_size_zone(self.mesh, *arguments, **settings)
        self.assertEqual(len(self.document.Objects), count)

    def test_far_too_fine_it_is_refused_before_it_costs_anything(self):
        api.add_size_zone(self.mesh, "Distance", [(self.body, "Face1")], inner=1e-4)
        self.document.recompute()
        self.assertRegex(self.mesh.Status, "failed: the refinement .* at Face1 would make")

    def test_an_fem_refinement_can_be_suppressed_too(self):
        region = ObjectsFem.makeMeshRegion(self.document, self.mesh, 1.0, "Fine")
        region.References = [(self.body, "Face1")]
        if "Suppressed" not in region.PropertiesList:
            region.addProperty("App::PropertyBool", "Suppressed")
        region.Suppressed = True
        count = self.mesh.TetCount
        self.document.recompute()
        self.assertEqual(self.mesh.TetCount, count)
        self.assertIn("The refinement Fine is suppressed and left out.", self.warnings())


class FreeCADsOwn(unittest.TestCase):
    """Objects that later versions of FreeCAD have, by the properties of these."""

    def test_a_distance(self):
        obj = SimpleNamespace(Label="D", Proxy=SimpleNamespace(Type="Fem::MeshDistance"), DistanceMinimum=2.0, DistanceMaximum=10.0, SizeMinimum=1.0, SizeMaximum=4.0)
        self.assertEqual(size_zone.wish_of(obj, ["Face3"]), {"name": "D", "inner": 1.0, "outer": 4.0, "transition": 8.0, "shape": "near",
                                                             "entities": ["Face3"], "reach": 2.0})

    def test_shapes_by_their_centre(self):
        sizes = {"SizeIn": 1.0, "SizeOut": 4.0, "Thickness": 2.0, "Label": "S", "Proxy": SimpleNamespace(Type="Fem::MeshShape")}
        box = SimpleNamespace(ShapeType="Box", BoxCenter=FreeCAD.Vector(1, 2, 3), BoxLength=2, BoxWidth=4, BoxHeight=6, **sizes)
        wish = size_zone.wish_of(box, [])
        self.assertEqual((wish["shape"], wish["sides"], wish["translation"], wish["transition"]), ("box", [2.0, 4.0, 6.0], [0.0, 0.0, 0.0], 2.0))
        sphere = SimpleNamespace(ShapeType="Sphere", SphereCenter=FreeCAD.Vector(1, 2, 3), SphereRadius=5, **sizes)
        wish = size_zone.wish_of(sphere, [])
        self.assertEqual((wish["shape"], wish["radius"], wish["translation"]), ("sphere", 5.0, [1.0, 2.0, 3.0]))
        self.assertIsNone(size_zone.wish_of(SimpleNamespace(ShapeType="Cylinder", **sizes), []))

    def test_others_are_told_and_left_out(self):
        found = refinements.Refinements()
        refinements._take(SimpleNamespace(Label="T", Proxy=SimpleNamespace(Type="Fem::MeshTransfiniteCurve")), ["Edge1"], found)
        self.assertEqual(found.zones + found.local, [])
        self.assertIn("not understood", english(found.notes[0]))


class InAContainer(unittest.TestCase):

    def test_the_zone_is_where_it_is_seen(self):
        from parts import new_document
        document = new_document()
        box = document.addObject("Part::Box", "Box")
        box.Length, box.Width, box.Height, box.Placement = 40, 30, 20, placement(100, 0, 0)
        document.recompute()
        mesh = api.add_mesh(box, 5.0, order=1)
        api.add_size_zone(mesh, "Sphere", placement=placement(120, 15, 10), inner=1.2, radius=4)
        document.recompute()
        self.assertAlmostEqual(mean_side(mesh, near((120, 15, 10), 3)), 1.27, delta=0.2)

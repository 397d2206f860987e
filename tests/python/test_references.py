# SPDX-License-Identifier: GPL-3.0-or-later
"""References as a click makes them and as a script does: both mean the same faces of the meshed part."""
import math
import os
import shutil
import tempfile
import unittest
from unittest import mock

import FreeCAD
import ObjectsFem
import Part
from analyses import quantity
from BOPTools import SplitFeatures
from freecad.featuremesh import api, assembled, mesh_object, resolving, solve_guard, statics_model, versions
from freecad.featuremesh.errors import UserError
from freecad.featuremesh.messages import english
from parts import circle, groups_of, new_document, placement, plate_with_hole, rectangle
from statics_cases import STEEL, faces_at

EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "resources", "examples")


def open_example(case, name):
    """A copy of an example; the documents of earlier tests are closed first."""
    new_document()
    folder = tempfile.mkdtemp()
    case.addCleanup(shutil.rmtree, folder)
    shutil.copyfile(os.path.join(EXAMPLES, name + ".FCStd"), os.path.join(folder, name + ".FCStd"))
    return FreeCAD.openDocument(os.path.join(folder, name + ".FCStd"))


def names_of(obj):
    """The (object name, sub-element) pairs of its references."""
    return [(target.Name, sub) for target, sub in resolving.pairs_of(obj)]


@unittest.skipUnless(versions.version() >= (1, 1), "patterns have one direction")
class PatternInTwoDirections(unittest.TestCase):
    """A plate with two rows of three holes, a load in one of them."""

    def setUp(self):
        self.document = new_document()
        self.body = self.document.addObject("PartDesign::Body", "Body")
        outline, hole = (self.body.newObject("Sketcher::SketchObject", name) for name in ("Outline", "HoleSketch"))
        rectangle(outline, 0, 0, 100, 60)
        circle(hole, 10, 10, 3)
        pad = self.body.newObject("PartDesign::Pad", "Pad")
        pad.Profile, pad.Length = outline, 6
        self.pocket = self.body.newObject("PartDesign::Pocket", "Pocket")
        self.pocket.Profile, self.pocket.Length, self.pocket.Reversed = hole, 6, True
        self.rows = self.body.newObject("PartDesign::LinearPattern", "Rows")
        self.rows.Originals, self.rows.Direction, self.rows.Direction2 = [self.pocket], (hole, ["H_Axis"]), (hole, ["V_Axis"])
        self.rows.Occurrences, self.rows.Length, self.rows.Occurrences2, self.rows.Length2 = 3, 40, 2, 30
        self.body.Tip = self.rows
        self.document.recompute()
        analysis = ObjectsFem.makeAnalysis(self.document, "Analysis")
        self.pressure = ObjectsFem.makeConstraintPressure(self.document, "Pressure")
        analysis.addObject(self.pressure)
        self.pressure.References = [(self.body, self.hole_at(50, 40))]
        self.mesh = api.add_mesh(self.body, 8, order=1)
        self.document.recompute()

    def centre(self, name):
        surface = self.body.Shape.getElement(name).Surface
        return (round(surface.Center.x, 1), round(surface.Center.y, 1)) if surface.TypeId == "Part::GeomCylinder" else None

    def hole_at(self, x, y):
        return next("Face%d" % i for i in range(1, len(self.body.Shape.Faces) + 1) if self.centre("Face%d" % i) == (x, y))

    def loaded(self):
        self.document.recompute()
        return [self.centre(sub) for _, sub in names_of(self.pressure)]

    def test_a_load_stays_in_its_hole(self):
        self.assertEqual(self.loaded(), [(50, 40)])
        self.rows.Occurrences = 4   # the rows are as long as before
        self.assertEqual(self.loaded(), [(36.7, 40)])
        self.rows.Occurrences = 3
        self.assertEqual(self.loaded(), [(50, 40)])
        self.rows.Mode, self.rows.Spacings = "Spacing", [12.0, 25.0]
        self.assertEqual(self.loaded(), [(47, 40)])
        self.rows.Occurrences = 4
        self.assertEqual(self.loaded(), [(47, 40)])
        self.pocket.Suppressed = True
        self.assertEqual(self.loaded(), [(47, 40)])
        self.pocket.Suppressed = False
        self.assertEqual(self.loaded(), [(47, 40)])


class FragmentsOfBoxes(unittest.TestCase):
    """What is between two solids, or of free form, is named by what the part is made of."""

    def setUp(self):
        self.document = new_document()
        self.left, self.right = (self.document.addObject("Part::Box", name) for name in ("Left", "Right"))
        self.right.Placement.Base.x = 10
        self.document.recompute()

    def fragments_of(self, *objects):
        fragments = SplitFeatures.makeBooleanFragments("Fragments")
        fragments.Objects = list(objects)
        self.document.recompute()
        return fragments

    def loaded(self, part, references):
        """An analysis of the meshed part with a force on these references, held at the end x = 0."""
        analysis = ObjectsFem.makeAnalysis(self.document, "Analysis")
        force, fixed, steel = ObjectsFem.makeConstraintForce(self.document, "Force"), ObjectsFem.makeConstraintFixed(self.document, "Fixed"), \
            ObjectsFem.makeMaterialSolid(self.document, "Steel")
        steel.Material = STEEL
        fixed.References = [(part, faces_at(part, 0, 0))]
        force.Force, force.References = quantity(100.0, "N"), references
        for member in (force, fixed, steel):
            analysis.addObject(member)
        self.document.recompute()
        before = FreeCAD.Vector(force.DirectionVector)
        mesh = api.add_mesh(part, 4.0, order=1)
        self.document.recompute()
        return analysis, mesh, force, before

    def test_a_force_on_a_face_between_solids_keeps_its_direction(self):
        for objects in ((self.left, self.right), (self.right, self.left)):
            for box, face in ((self.left, "Face2"), (self.right, "Face1")):
                part = self.fragments_of(*objects)
                between, = faces_at(part, 0, 10)
                self.assertEqual(resolving.Resolver(part).names(box, face), [between])
                _, _, force, before = self.loaded(part, [(box, face)])
                self.assertEqual(names_of(force), [(part.Name, between)])
                self.assertLess((force.DirectionVector - before).Length, 1e-9)
                for name in ["FeatureMesh", "Force", "Fixed", "Steel", "Analysis", "Fragments"]:
                    self.document.removeObject(name)

    def test_a_solid_is_all_its_pieces(self):
        """Also a core, all of whose faces are between two solids."""
        core = self.document.addObject("Part::Cylinder", "Core")
        core.Radius, core.Height, core.Placement.Base = 2, 5, FreeCAD.Vector(5, 5, 2)
        part, volume_of_core = self.fragments_of(self.left, self.right, core), 20 * math.pi
        volumes = {"Core": [volume_of_core], "Left": [volume_of_core, 1000 - volume_of_core], "Right": [1000]}
        for name, expected in volumes.items():
            names = resolving.Resolver(part).names(self.document.getObject(name), "Solid1")
            found = [part.Shape.Solids[int(own[len("Solid"):]) - 1].Volume for own in names]
            for volume, known in zip(sorted(found), expected, strict=True):
                self.assertAlmostEqual(volume, known, delta=1e-6 * known)

    def test_a_local_size_in_one_of_two_solids(self):
        part = self.fragments_of(self.left, self.right)
        mesh = api.add_mesh(part, 5.0, order=1)
        self.document.recompute()
        before = mesh.TetCount
        region = api.add_local_size(mesh, [(self.right, "Solid1")], 1.5)
        self.document.recompute()
        (_, name), = names_of(region)
        self.assertGreater(part.Shape.Solids[int(name[len("Solid"):]) - 1].CenterOfMass.x, 10)
        self.assertGreater(mesh.TetCount, 4 * before)
        with self.assertRaisesRegex(UserError, "the size of a whole part is the mesh's own"):
            api.add_local_size(mesh, ["Solid1", "Solid2"])

    def test_a_core_keeps_its_material(self):
        """All of its faces are faces of what is around it, too."""
        core, analysis = self.document.addObject("Part::Box", "Core"), ObjectsFem.makeAnalysis(self.document, "Analysis")
        core.Length, core.Width, core.Height, core.Placement.Base = 5, 5, 5, FreeCAD.Vector(2.5, 2.5, 2.5)
        part = self.fragments_of(self.left, core)
        volumes = {"Solid%d" % number: solid.Volume for number, solid in enumerate(part.Shape.Solids, 1)}
        materials = [ObjectsFem.makeMaterialSolid(self.document, name) for name in ("Around", "Within")]
        for material, name in zip(materials, sorted(volumes, key=volumes.get, reverse=True)):
            material.Material, material.References = STEEL, [(part, name)]
            analysis.addObject(material)
        api.add_mesh(part, 4.0, order=1, active_analysis=analysis)
        self.document.recompute()
        core.Height, core.Placement.Base.x = 6, 3
        self.document.recompute()
        found = [round(part.Shape.Solids[int(name[len("Solid"):]) - 1].Volume) for material in materials for _, name in names_of(material)]
        self.assertEqual(found, [850, 150])

    def test_a_solid_that_is_cut_in_two_keeps_its_material(self):
        """The other piece had the material of the rest, or none."""
        slot, cut = self.document.addObject("Part::Box", "Slot"), self.document.addObject("Part::Cut", "Cut")
        slot.Length, slot.Width, slot.Height, slot.Placement.Base = 2, 5, 20, FreeCAD.Vector(14, -1, -5)
        cut.Base, cut.Tool = self.right, slot
        part, analysis = self.fragments_of(self.left, cut), ObjectsFem.makeAnalysis(self.document, "Analysis")
        soft, steel = (ObjectsFem.makeMaterialSolid(self.document, name) for name in ("Soft", "Steel"))
        chosen, = ["Solid%d" % number for number, solid in enumerate(part.Shape.Solids, 1) if solid.CenterOfMass.x > 10]
        soft.Material = steel.Material = STEEL
        soft.References = [(part, chosen)]
        for material in (soft, steel):
            analysis.addObject(material)
        api.add_mesh(part, 4.0, order=1, active_analysis=analysis)
        self.document.recompute()
        for x in (14, 13):
            slot.Width, slot.Placement.Base.x = 20, x
            self.document.recompute()
            self.assertEqual(sorted(round(part.Shape.Solids[int(name[len("Solid"):]) - 1].Volume) for _, name in names_of(soft)), sorted([100 * (x - 10), 100 * (18 - x)]))

    def test_what_two_solids_have_in_common_gets_the_material_of_neither(self):
        ball, ring = self.document.addObject("Part::Sphere", "Ball"), self.document.addObject("Part::Torus", "Ring")
        ring.Placement.Base.x = 40
        part, analysis = self.fragments_of(ball, ring), ObjectsFem.makeAnalysis(self.document, "Analysis")
        materials = [ObjectsFem.makeMaterialSolid(self.document, name) for name in ("OfBall", "OfRing")]
        for material, is_left in zip(materials, (True, False)):
            material.Material = STEEL
            material.References = [(part, "Solid%d" % number) for number, solid in enumerate(part.Shape.Solids, 1) if (solid.CenterOfMass.x < 15) == is_left]
            analysis.addObject(material)
        api.add_mesh(part, 4.0, order=1, active_analysis=analysis)
        self.document.recompute()
        ring.Placement.Base.x = 15
        self.document.recompute()
        self.assertEqual(len(part.Shape.Solids), 3)
        common = min(part.Shape.Solids, key=lambda solid: solid.Volume)
        for _, name in [pair for material in materials for pair in names_of(material)]:
            self.assertFalse(part.Shape.Solids[int(name[len("Solid"):]) - 1].isSame(common))

    def test_what_was_cut_off_a_moved_body_has_nothing(self):
        """A face of an earlier feature is where its body is, not where another face of the part happens to be."""
        body = plate_with_hole(self.document)
        cutter = body.newObject("Sketcher::SketchObject", "CutterSketch")
        rectangle(cutter, -10, -10, 30, 60)
        pocket = body.newObject("PartDesign::Pocket", "Cutter")
        pocket.Profile, pocket.Type, pocket.Reversed = cutter, "ThroughAll", True
        self.document.recompute()
        end, = faces_at(self.document.Plate, 0, 0)
        for x in (0, -20):   # the end that is left at x = 20 comes to lie where the end that was cut off would be
            body.Placement.Base.x = x
            self.document.recompute()
            self.assertEqual(resolving.Resolver(body).names(self.document.Plate, end), [])

    def test_all_pieces_of_a_free_form(self):
        curve = Part.BSplineCurve()
        curve.interpolate([FreeCAD.Vector(x, 0, z) for x, z in ((0, 10), (10, 13), (20, 9), (30, 12), (40, 10))])
        corners = [FreeCAD.Vector(40, 0, 10), FreeCAD.Vector(40, 0, 0), FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(0, 0, 10)]
        wave, slot = self.document.addObject("Part::Feature", "Wave"), self.document.addObject("Part::Box", "Slot")
        wave.Shape = Part.Face(Part.Wire([curve.toShape()] + [Part.makeLine(*ends) for ends in zip(corners, corners[1:])])).extrude(FreeCAD.Vector(0, 20, 0))
        slot.Length, slot.Width, slot.Height, slot.Placement.Base = 60, 4, 30, FreeCAD.Vector(-5, 8, 5)
        self.document.recompute()
        part = self.fragments_of(wave, slot)
        for number, face in enumerate(wave.Shape.Faces, 1):
            found = [part.Shape.getElement(name) for name in resolving.Resolver(part).names(wave, "Face%d" % number)]
            self.assertAlmostEqual(sum(piece.Area for piece in found), face.Area, delta=1e-6 * face.Area)

    def test_what_the_kernel_made_a_spline_of(self):
        spline = self.document.addObject("Part::Feature", "Spline")
        spline.Shape = Part.makeBox(10, 10, 10).toNurbs()
        part = self.fragments_of(spline, self.right)
        for number in range(1, 7):
            self.assertEqual(len(resolving.Resolver(part).names(self.left, "Face%d" % number) or []), 0)   # it is not in the part
            found = resolving.Resolver(part).names(spline, "Face%d" % number)
            self.assertAlmostEqual(sum(part.Shape.getElement(name).Area for name in found), 100, delta=1e-6)

    def test_what_is_gone_beside_what_is_there_is_not_left_out_in_silence(self):
        cut, tool = self.document.addObject("Part::Cut", "Cut"), self.document.addObject("Part::Box", "Tool")
        tool.Length, tool.Width, tool.Height, tool.Placement.Base = 5, 30, 30, FreeCAD.Vector(15, -5, -5)
        cut.Base, cut.Tool = self.right, tool
        self.document.recompute()
        analysis, mesh, force, _ = self.loaded(cut, [(self.right, "Face2"), (cut, "Face1")])   # the face at x = 20 was cut off
        analysis.removeObject(self.document.Fixed)
        message = "Force refers to Right:Face2, which is not on the meshed part Cut and has no nodes in its mesh; choose faces"
        self.assertRegex(solve_guard.reason(analysis), message)
        self.assertNotIn("Force", mesh.Proxy._record(mesh))
        self.assertNotIn("Force_Nodes", groups_of(mesh))
        with self.assertRaisesRegex(UserError, message):
            statics_model.prepared(analysis, mesh)
        force.References = [(cut, "Face1")]
        self.document.recompute()
        self.assertEqual(solve_guard.reason(analysis), "")


class Resolving(unittest.TestCase):
    """What a reference of any kind means."""

    def setUp(self):
        self.document = open_example(self, "bracket")
        self.body = self.document.Body
        self.fillet = self.body.Tip

    def names(self, obj, sub, part=None):
        return resolving.Resolver(part or self.body).names(obj, sub)

    def test_the_tip_has_its_bodys_numbers(self):
        self.assertEqual(self.names(self.fillet, "Face19"), ["Face19"])
        self.assertEqual(self.names(self.fillet, "Edge7"), ["Edge7"])
        self.assertEqual(self.names(self.body, "Fillet.Face19"), ["Face19"])
        self.assertEqual(self.names(self.body, "Face19", self.fillet), ["Face19"])

    def test_the_only_solid_is_meant_though_freecad_lost_it(self):
        for obj in (self.body, self.fillet, self.document.Plate):
            self.assertEqual(self.names(obj, "?Solid1"), ["Solid1"])
            self.assertEqual(self.names(obj, "?Face1"), [])
        other = self.document.addObject("Part::Box", "Other")
        self.document.recompute()
        self.assertEqual(self.names(other, "?Solid1"), [])

    def test_a_feature_before_the_tip_has_its_faces_on_the_final_shape(self):
        for placed in (FreeCAD.Placement(), placement(10, 20, 30, 40, (1, 2, 3))):
            self.body.Placement = placed
            self.document.recompute()
            found = 0
            for number, face in enumerate(self.document.Plate.Shape.Faces, 1):
                moved = face.copy()
                moved.Placement = placed.multiply(moved.Placement)
                for name in self.names(self.document.Plate, "Face%d" % number):
                    found += 1
                    common = self.body.Shape.getElement(name).common(moved)
                    self.assertAlmostEqual(common.Area / self.body.Shape.getElement(name).Area, 1, 5)
            self.assertGreaterEqual(found, 6)

    def test_paths_through_links_and_containers(self):
        container = self.document.addObject("App::Part", "Assembly")
        container.addObject(self.body)
        container.Placement = placement(5, 6, 7, 30)
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = self.body
        self.document.recompute()
        self.assertEqual(self.names(container, "Body.Fillet.Face19"), ["Face19"])
        self.assertEqual(self.names(link, "Fillet.Face19"), ["Face19"])
        self.assertEqual(self.names(self.fillet, "Face19", link), ["Face19"])
        self.assertEqual(self.names(link, "Face19", link), ["Face19"])
        self.assertEqual(self.names(self.document.Plate, "Face1", link), self.names(self.document.Plate, "Face1"))

    def test_another_copy_is_another_thing(self):
        links = [self.document.addObject("App::Link", name) for name in ("One", "Two")]
        for link in links:
            link.LinkedObject = self.body
        links[1].Placement.Base.x = 500
        self.document.recompute()
        self.assertEqual(self.names(links[0], "Fillet.Face19", links[0]), ["Face19"])
        self.assertIsNone(self.names(links[1], "Fillet.Face19", links[0]))
        other = self.document.addObject("Part::Box", "Other")
        self.document.recompute()
        self.assertIsNone(self.names(other, "Face1"))

    def test_of_several_links_the_one_on_the_path_is_meant(self):
        container = self.document.addObject("App::Part", "Machine")
        container.Placement = placement(7, 8, 9, 50)
        for index, name in enumerate(("One", "Two", "Three")):
            link = self.document.addObject("App::Link", name)
            link.LinkedObject, link.Placement = self.body, placement(400 * index, 0, 0, 30 * index)
            container.addObject(link)
        self.document.recompute()
        shown = assembled.of(container)
        load = ObjectsFem.makeConstraintPressure(self.document, "Pressure")
        load.References = [(self.fillet, "Face19")]
        load.addProperty("App::PropertyStringList", resolving.CLICKED)
        for path in ("One.Fillet.Face19", "Two.Fillet.Face19", "Machine.Three.Fillet.Face19", "Machine.Two.Face19"):
            root, _, sub = path.partition(".")
            wanted = self.document.getObject(root).getSubObject(sub)
            if root != "Machine":
                wanted.Placement = container.Placement.multiply(wanted.Placement)
            (name,) = self.names(self.document.getObject(root), sub, shown)
            self.assertLess((shown.Shape.getElement(name).CenterOfMass - wanted.CenterOfMass).Length, 1e-6, path)
            setattr(load, resolving.CLICKED, [path])
            found = resolving.Resolver(shown).of_object(load)
            self.assertEqual(found, ([name], []) if "Fillet" in path else (["Face19"], []))   # of another click nothing is known
        self.document.removeObject("Three")
        setattr(load, resolving.CLICKED, ["Three.Fillet.Face19"])
        self.assertEqual(resolving.pairs_of(load), [(self.fillet, "Face19")])

    def test_bodies_of_a_container_that_a_link_shows(self):
        container = self.document.addObject("App::Part", "Assembly")
        container.addObject(self.body)
        other = self.document.addObject("PartDesign::Body", "Body001")
        box = other.newObject("PartDesign::AdditiveBox", "Box")
        box.Length = box.Width = box.Height = 7
        box.Placement.Base.z = 300
        container.addObject(other)
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = container
        link.Placement = placement(400, 0, 0, 90)
        self.document.recompute()
        for number in range(1, 7):
            (name,) = self.names(link, "Body001.Box.Face%d" % number, link)
            wanted = link.getSubObject("Body001.Box.Face%d" % number)
            self.assertLess((link.Shape.getElement(name).CenterOfMass - wanted.CenterOfMass).Length, 1e-6)


class AsClicked(unittest.TestCase):
    """The window gives the tip of the body; everything of the mesh understands it as it does the body itself."""

    def setUp(self):
        self.document = open_example(self, "bracket")
        self.body = self.document.Body
        self.fillet = self.body.Tip
        self.analysis = self.document.Analysis
        self.mesh = api.add_mesh(self.body, 6)
        self.mesh.Automatic = False

    def update(self):
        self.document.recompute()
        return api.update_mesh(self.mesh)

    def test_loads_supports_and_groups(self):
        self.document.Force.References = [(self.fillet, "Face19")]
        self.document.Fixed.References = [(self.document.Plate, "Face1"), (self.body, "Fillet.Face4")]
        group = ObjectsFem.makeMeshGroup(self.document, self.mesh, False, "Clamp")
        group.References = [(self.fillet, ("Face2", "Edge5"))]
        self.update()
        groups = groups_of(self.mesh)
        self.assertEqual(groups["Force_Nodes"], groups["Face19_Nodes"])
        self.assertEqual(groups["Clamp_Nodes"], groups["Face2_Nodes"] | groups["Edge5_Nodes"])
        (plate,) = resolving.Resolver(self.body).names(self.document.Plate, "Face1")
        self.assertEqual(groups["Fixed_Nodes"], groups[plate + "_Nodes"] | groups["Face4_Nodes"])
        self.assertNotEqual(plate, "Face4")
        self.assertEqual(names_of(self.document.Force), [("Body", "Face19")])

    def test_refinements(self):
        region = ObjectsFem.makeMeshRegion(self.document, self.mesh, 2.0, "Fine")
        region.References = [(self.fillet, "Face19")]
        self.update()
        many = len(groups_of(self.mesh)["Face19_Nodes"])
        self.document.removeObject(region.Name)
        self.update()
        self.assertGreater(many, 2 * len(groups_of(self.mesh)["Face19_Nodes"]))

    def test_a_refinement_of_another_object_is_refused_by_name(self):
        other = self.document.addObject("Part::Box", "Other")
        region = ObjectsFem.makeMeshRegion(self.document, self.mesh, 2.0, "Fine")
        region.References = [(other, "Face1")]
        self.document.recompute()
        with self.assertRaisesRegex(UserError, "Fine.*Other:Face1"):
            api.update_mesh(self.mesh)

    def test_the_selection_of_a_local_size(self):
        region = api.add_local_size(self.mesh, [(self.fillet, "Face19"), (self.document.Plate, "Face1")], 2.0)
        self.assertEqual({name for name, _ in names_of(region)}, {"Body"})
        self.assertIn(("Body", "Face19"), names_of(region))
        other = self.document.addObject("Part::Box", "Other")
        self.document.recompute()
        with self.assertRaisesRegex(UserError, "Other:Face1"):
            api.add_local_size(self.mesh, [(other, "Face1")])

    def test_the_selection_of_a_group(self):
        some = api.add_group(self.mesh, [(self.fillet, "Face19"), (self.body, "Edge1")], "Some")
        whole = api.add_group(self.mesh, [(self.body, "")], "Whole")
        empty = api.add_group(self.mesh, None, "Empty")
        self.assertEqual([names_of(group) for group in (some, whole, empty)],
                         [[("Body", "Face19"), ("Body", "Edge1")], [("Body", "Solid1")], []])
        self.assertEqual(self.mesh.MeshGroupList, [some, whole, empty])
        with self.assertRaisesRegex(UserError, "select solids, faces, edges or vertices of Body"):
            api.add_group(self.mesh, [])
        with self.assertRaisesRegex(UserError, "a local size is for faces, edges or vertices"):
            api.add_local_size(self.mesh, [(self.body, "")])

    def test_materials(self):
        material = ObjectsFem.makeMaterialSolid(self.document, "Second")
        self.analysis.addObject(material)
        material.References = [(self.fillet, "Solid1")]
        self.update()
        self.assertEqual(groups_of(self.mesh).get("Second_Volumes"), set(self.mesh.FemMesh.Volumes))

    def test_what_is_clicked_on_another_copy_is_said(self):
        one, two = (self.document.addObject("App::Link", name) for name in ("One", "Two"))
        one.LinkedObject = two.LinkedObject = self.body
        two.Placement.Base.x = 500
        self.document.removeObject(self.mesh.Name)
        self.document.recompute()
        force, said = self.document.Force, "Force refers to Two:Fillet.Face19, which is not on the meshed part One and has no nodes in its mesh"
        force.addProperty("App::PropertyStringList", resolving.CLICKED)
        setattr(force, resolving.CLICKED, ["Two.Fillet.Face19"])
        force.References = [(self.fillet, "Face19")]
        self.document.Fixed.References = [(self.body, "Face4")]
        self.mesh = api.add_mesh(one, 6)
        self.mesh.Automatic = False
        warnings = []
        with mock.patch.object(mesh_object.FreeCAD, "Console", mock.Mock(wraps=FreeCAD.Console, PrintWarning=warnings.append)):
            line, = [english(line) for line in self.update()["warnings"]]
            self.assertEqual(line, said + "; choose faces, edges or vertices of One instead")
            self.assertEqual([line in words for words in warnings], [True])
            self.assertNotIn("Force_Nodes", groups_of(self.mesh))
            self.assertIn(said, solve_guard.reason(self.analysis))   # FreeCAD would load the copy that lies where the original is
            setattr(force, resolving.CLICKED, ["One.Fillet.Face19"])
            force.References = [(self.fillet, "Face19")]
            self.assertEqual(groups_of(self.mesh)["Force_Nodes"], groups_of(self.mesh)["Face19_Nodes"])
            self.assertEqual(self.update()["warnings"], [])
            self.assertEqual(solve_guard.reason(self.analysis), "")
            pressure = ObjectsFem.makeConstraintPressure(self.document, "Pressure")
            pressure.addProperty("App::PropertyStringList", resolving.CLICKED)
            setattr(pressure, resolving.CLICKED, ["Two.Fillet.Face3"])
            pressure.References = [(self.fillet, "Face3")]
            self.analysis.addObject(pressure)
            self.assertIn("Pressure refers to Two:Fillet.Face3", warnings[-1])
            self.assertEqual(len(self.update()["warnings"]), 1)
        self.assertEqual(len(warnings), 2)   # each said once

    def test_a_reference_that_is_being_edited_is_not_rewritten(self):
        from freecad.featuremesh import references
        self.document.Force.References = [(self.fillet, "Face19")]
        references.is_in_edit = lambda obj: obj is self.document.Force
        self.addCleanup(setattr, references, "is_in_edit", None)
        self.update()
        self.assertEqual(names_of(self.document.Force), [(self.fillet.Name, "Face19")])
        self.assertEqual(groups_of(self.mesh)["Force_Nodes"], groups_of(self.mesh)["Face19_Nodes"])


class Written(unittest.TestCase):
    """FreeCAD's own writer puts the same nodes under the same loads, wherever the body stands."""

    def loads(self, clicked, placed):
        """Lines of the input file that hold the boundary nodes and the loads."""
        from analyses import add_solver, quantity
        from femtools import ccxtools
        document = open_example(self, "bracket")
        body, analysis = document.Body, document.Analysis
        body.Placement = placed
        document.recompute()
        target = body.Tip if clicked else body
        pressure = ObjectsFem.makeConstraintPressure(document, "Pressure")
        pressure.References, pressure.Pressure = [(target, "Face3")], quantity(1, "MPa")
        analysis.addObject(pressure)
        document.Fixed.References = [(target, document.Fixed.References[0][1])]
        document.Force.References = [(target, document.Force.References[0][1])]
        mesh = api.add_mesh(body, 8)
        api.update_mesh(mesh)
        solver = next((m for m in analysis.Group if m.isDerivedFrom("Fem::FemSolverObjectPython")), None) or add_solver(document, analysis)
        tools = ccxtools.FemToolsCcx(analysis, solver, test_mode=True)
        with tempfile.TemporaryDirectory() as folder:
            tools.setup_working_dir(folder)
            tools.update_objects()
            self.assertEqual(tools.check_prerequisites(), "")
            tools.write_inp_file()
            with open(tools.inp_file_name, encoding="utf-8") as stream:
                text = stream.read()
        kept, keep = [], False
        for line in text.splitlines():
            if line.startswith("*") and not line.startswith("**"):
                keep = line.upper().startswith(("*CLOAD", "*DLOAD", "*NSET", "*BOUNDARY"))
            if keep and not line.startswith("**"):
                kept.append(line)
        return kept

    def test_loads_of_a_placed_body_are_written(self):
        self.maxDiff = 2000
        for placed in (FreeCAD.Placement(), placement(10, 20, 30, 40, (1, 2, 3))):
            scripted, clicked = self.loads(False, placed), self.loads(True, placed)
            self.assertEqual(clicked, scripted)
            self.assertGreater(sum("BF" in line or ",P" in line.replace(" ", "") for line in clicked), 0)
            self.assertGreater(len(clicked), 50)

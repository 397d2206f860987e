# SPDX-License-Identifier: GPL-3.0-or-later
"""Several parts in one mesh: containers, links, touching parts, and ties and contacts that find their faces, solved by CalculiX."""
import json
import os
import re
import shutil
import sys
import tempfile
import unittest
from unittest import mock

import FreeCAD
import numpy as np
import ObjectsFem
import Part
from analyses import add_material, add_solver, quantity, solve
from freecad.featuremesh import api, assembled, calculix, contact_faces, mesh_object, resolving, solve_guard, tasks, versions
from freecad.featuremesh.errors import UserError
from freecad.featuremesh.messages import in_english
from parts import groups_in_freecad, new_document, placement

STEEL = {"Name": "Steel", "YoungsModulus": "210000 MPa", "PoissonRatio": "0.0", "Density": "7900 kg/m^3"}
SIDE, HEIGHT, COUNT, FORCE = 10, 4, 10, 1000.0   # mm, mm, parts, N


def tower(document, container=None, gap=0.0):
    """Ten boxes on one another."""
    boxes = []
    for index in range(COUNT):
        box = document.addObject("Part::Box", "Plate%d" % index)
        box.Length = box.Width = SIDE
        box.Height, box.Placement = HEIGHT, placement(0, 0, index * (HEIGHT + gap))
        boxes.append(box)
    if container is not None:
        for box in boxes:
            container.addObject(box)
    document.recompute()
    return boxes


def nodes_by_solid(mesh):
    """By solid the numbers of its nodes."""
    arrays = mesh.Proxy.arrays(mesh)
    numbers = arrays["node_numbers"]
    rows = [np.hstack([arrays["tets"], arrays["tet_mids"].reshape(len(arrays["tets"]), -1)])[arrays["tet_solids"] == solid]
            for solid in range(arrays["tet_solids"].max() + 1)]
    return [set(numbers[np.unique(part)].tolist()) for part in rows]


def points_of(mesh):
    return {number: np.array(point) for number, point in mesh.FemMesh.Nodes.items()}


def warnings_of_contact(mesh):
    """What the report says of parts that touch."""
    return [line for line in in_english(json.loads(mesh.Report))["warnings"] if "touch or overlap without sharing faces" in line]


def face_at(shape, solid, z):
    """Name of the horizontal face of one solid of a shape at that height."""
    own = [face for face in shape.Solids[solid].Faces if face.BoundBox.ZLength < 1e-6 and abs(face.CenterOfMass.z - z) < 1e-6]
    return next("Face%d" % number for number, face in enumerate(shape.Faces, 1) if face.isSame(own[0]))


def said_by_freecad(work):
    """What FreeCAD writes to its console, as text, while `work` is done."""
    with tempfile.TemporaryFile() as said:
        sys.stdout.flush()
        kept = [os.dup(number) for number in (1, 2)]
        try:
            for number in (1, 2):
                os.dup2(said.fileno(), number)
            work()
        finally:
            for number, handle in zip((1, 2), kept):
                os.dup2(handle, number)
                os.close(handle)
        said.seek(0)
        return said.read().decode(errors="replace")


class InADocument(unittest.TestCase):

    def setUp(self):
        self.document = new_document()

    def meshed(self, part, size=2.5, order=1):
        mesh = api.add_mesh(part, size, order=order)
        self.document.recompute()
        self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
        return mesh

    def compound(self, boxes):
        compound = self.document.addObject("Part::Compound", "Compound")
        compound.Links = boxes
        self.document.recompute()
        return compound

    def assert_own_nodes(self, mesh, count):
        parts = nodes_by_solid(mesh)
        self.assertEqual(len(parts), count)
        self.assertEqual(sum(map(len, parts)), len(set().union(*parts)))
        return parts

    def check_edit(self, mesh, boxes, edited=5, growth=2):
        """One part is made higher, those above it move up: parts below keep their bits, those above their numbers."""
        before, parts = points_of(mesh), self.assert_own_nodes(mesh, COUNT)
        boxes[edited].Height = HEIGHT + growth
        for box in boxes[edited + 1:]:
            box.Placement.Base.z += growth
        self.document.recompute()
        self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
        self.assertIsNone(json.loads(mesh.Report)["fallback"])
        now, parts_now = points_of(mesh), self.assert_own_nodes(mesh, COUNT)
        for index in range(COUNT):
            if index == edited:
                continue
            self.assertEqual(parts_now[index], parts[index], index)
            shift = (0, 0, growth if index > edited else 0)
            for number in parts[index]:
                if index < edited:
                    self.assertTrue(np.array_equal(now[number], before[number]), (index, number))
                else:
                    self.assertLess(np.abs(now[number] - before[number] - shift).max(), 1e-9, (index, number))


class Assembly(InADocument):

    def test_a_compound_of_touching_parts(self):
        boxes = tower(self.document)
        self.check_edit(self.meshed(self.compound(boxes)), boxes)

    def test_the_parts_of_a_container(self):
        container = self.document.addObject("App::Part", "Machine")
        boxes = tower(self.document, container)
        mesh = self.meshed(container)
        self.assertTrue(assembled.is_assembled(versions.part_of(mesh)))
        self.assertEqual(versions.part_of(mesh).Parts, boxes)
        self.check_edit(mesh, boxes)

    def test_a_part_in_a_group_in_a_container_counts_once(self):
        """Since 1.0 the container has what is in the group itself, too."""
        container = self.document.addObject("App::Part", "Machine")
        group = self.document.addObject("App::DocumentObjectGroup", "Screws")
        boxes = tower(self.document)
        group.Group = boxes[1:]
        container.Group = [boxes[0], group, *boxes[1:]]
        self.document.recompute()
        part = assembled.of(container)
        self.assertEqual(part.Parts, boxes)
        self.assertEqual(len(part.Shape.Solids), COUNT)

    def test_faces_and_solids_of_parts_in_one_place(self):
        """A part that overlaps another one has faces of its own, also where both lie in one place: loads and materials of each are its own."""
        container = self.document.addObject("App::Part", "Machine")
        boxes = [container.newObject("Part::Box", name) for name in ("Block", "Same")]
        self.document.recompute()
        analysis = ObjectsFem.makeAnalysis(self.document, "Analysis")
        loads = []
        for box in boxes:
            loads.append(ObjectsFem.makeConstraintFixed(self.document, "On" + box.Name))
            loads[-1].References = [(box, "Face2")]
            add_material(self.document, analysis, "Of" + box.Name, STEEL, [(box, "Solid1")])
            analysis.addObject(loads[-1])
        mesh = api.add_mesh(container, 3, order=1, join_analysis=False)
        analysis.addObject(mesh)
        self.document.recompute()
        part = versions.part_of(mesh)
        self.assertEqual([load.References for load in loads], [[(part, ("Face2",))], [(part, ("Face8",))]])
        tets = [numbers for name, numbers in groups_in_freecad(mesh).items() if name.endswith("_Volumes")]
        self.assertEqual(len(tets), 2)
        self.assertFalse(set(tets[0]) & set(tets[1]))

    def test_parts_in_containers_are_within_reach(self):
        """FreeCAD warns at each recompute of links that lead into a container, unless they are for that."""
        container = self.document.addObject("App::Part", "Machine")
        box = container.newObject("Part::Box", "Box")
        self.document.recompute()

        def work():
            FreeCAD.Console.PrintWarning("it is heard\n")
            for part in (box, container):
                mesh = api.add_mesh(part, 3, order=1)
                api.add_size_zone(mesh, "Distance", [(box, "Face1")] if part is box else [(versions.part_of(mesh), "Face1")], inner=1, distance=1)
                box.Length = box.Length.Value + 1
                self.document.recompute()
                self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
        said = said_by_freecad(work)
        self.assertIn("it is heard", said)
        self.assertNotIn("scope", said)

    def test_that_parts_touch_is_said_once(self):
        container = self.document.addObject("App::Part", "Frame")
        plate, left, right = (self.document.addObject("Part::Box", name) for name in ("Plate", "Left", "Right"))
        plate.Length, plate.Width, plate.Height = 60, 40, 10
        for column, x in ((left, 0), (right, 40)):
            column.Length, column.Width, column.Height, column.Placement = 20, 40, 30, placement(x, 0, 10)
        for box in (plate, left, right):
            container.addObject(box)
        self.document.recompute()
        mesh = self.meshed(container, 5)
        before = json.loads(mesh.Report)["warnings"]
        left.Length = 22
        said = said_by_freecad(self.document.recompute)
        self.assertNotEqual(json.loads(mesh.Report)["warnings"], before, "other faces, or the same in another order")
        self.assertEqual(len(warnings_of_contact(mesh)), 1)
        self.assertNotIn("touch", said)

    def test_a_part_that_is_hidden_placed_or_in_a_container_in_it_counts(self):
        outer, inner = (self.document.addObject("App::Part", name) for name in ("Outer", "Inner"))
        outer.addObject(inner)
        outer.Placement, inner.Placement = placement(100, 0, 0), placement(0, 50, 0, 90)
        box, tool, cut = (self.document.addObject(kind, name) for kind, name in (("Part::Box", "Box"), ("Part::Cylinder", "Tool"), ("Part::Cut", "Cut")))
        cut.Base, cut.Tool = box, tool
        for obj in (box, tool, cut):
            inner.addObject(obj)
        plain = self.document.addObject("Part::Box", "Plain")
        outer.addObject(plain)
        plain.Visibility = False
        self.document.recompute()
        shape = assembled.of(outer).Shape
        self.assertEqual([part.Name for part in assembled.of(outer).Parts], ["Cut", "Plain"])
        self.assertEqual(len(shape.Solids), 2)
        corners = [tuple(round(x, 6) for x in (solid.BoundBox.XMin, solid.BoundBox.YMin, solid.BoundBox.ZMin)) for solid in shape.Solids]
        self.assertEqual(corners, [(90.0, 50.0, 0.0), (100.0, 0.0, 0.0)])
        self.assertIs(assembled.of(outer), assembled.of(outer))

    def test_links_each_have_a_mesh_and_one_that_moves_takes_its_own_along(self):
        box = self.document.addObject("Part::Box", "Box")
        box.Length = box.Width = SIDE
        box.Height = HEIGHT
        container = self.document.addObject("App::Part", "Machine")
        links = []
        for index in range(3):
            link = self.document.addObject("App::Link", "Link%d" % index)
            link.LinkedObject, link.Placement = box, placement(0, 0, index * HEIGHT)
            container.addObject(link)
            links.append(link)
        self.document.recompute()
        mesh = self.meshed(container)
        before, parts = points_of(mesh), self.assert_own_nodes(mesh, 3)
        links[2].Placement = placement(1, 0, 2 * HEIGHT + 3, 90)
        self.document.recompute()
        self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
        now = points_of(mesh)
        self.assertEqual(self.assert_own_nodes(mesh, 3), parts)
        motion = links[2].Placement.multiply(placement(0, 0, 2 * HEIGHT).inverse())
        for number in parts[2]:
            self.assertLess((FreeCAD.Vector(*now[number]) - motion.multVec(FreeCAD.Vector(*before[number]))).Length, 1e-9)
        for number in parts[0] | parts[1]:
            self.assertTrue(np.array_equal(now[number], before[number]), number)

    def test_a_part_that_is_moved_without_a_mark_takes_its_mesh_along(self):
        """As FreeCAD's Assembly moves what is dragged: it sets the placement and takes the mark of an edit back."""
        container = self.document.addObject("App::Part", "Machine")
        boxes = tower(self.document, container, gap=1)
        mesh = self.meshed(container)
        self.document.UndoMode = 1
        self.document.openTransaction("Move part")
        boxes[0].Placement.Base.x += 20
        boxes[0].purgeTouched()
        self.document.commitTransaction()
        self.assertTrue(solve_guard.not_recomputed(mesh))
        self.document.recompute()
        self.assertEqual((mesh.Status, mesh.KeptTets, mesh.FemMesh.BoundBox.XMax), (mesh_object.UP_TO_DATE, 100, 20 + SIDE))
        self.document.undo()
        self.assertEqual(mesh.Status, mesh_object.OUT_OF_DATE)
        self.assertIn("was changed and not recomputed; update it", mesh.Proxy.why_not_to_solve(mesh))   # it is automatic already
        self.document.recompute()
        self.assertEqual((mesh.Status, mesh.KeptTets, mesh.FemMesh.BoundBox.XMax), (mesh_object.UP_TO_DATE, 100, SIDE))
        self.document.openTransaction("Cancelled")
        boxes[0].Placement.Base.x += 20
        boxes[0].purgeTouched()
        self.document.abortTransaction()
        self.assertEqual((mesh.Status, solve_guard.not_recomputed(mesh)), (mesh_object.UP_TO_DATE, ""))

    def test_the_parts_are_where_they_are(self):
        """Also after their object was moved, as *Transform* did."""
        container = self.document.addObject("App::Part", "Machine")
        tower(self.document, container, gap=1)
        mesh = self.meshed(container)
        shown = versions.part_of(mesh)
        shown.Placement.Base.x += 20
        self.document.recompute()
        self.assertEqual((mesh.Status, mesh.KeptTets, mesh.FemMesh.BoundBox.XMin, shown.Shape.BoundBox.XMin), (mesh_object.UP_TO_DATE, 100, 0, 0))

    def test_the_container_of_a_part_that_is_moved_takes_its_mesh_along(self):
        """FEM has the nodes of a part where it is seen since 1.0, and looks for loaded faces there."""
        container = self.document.addObject("App::Part", "Machine")
        container.Placement = placement(50, 0, 0)
        box = container.newObject("Part::Box", "Box")
        self.document.recompute()
        mesh = api.add_mesh(box, 5)
        self.document.recompute()
        self.document.UndoMode = 1
        self.document.openTransaction("Higher")
        box.Height = 12
        self.document.recompute()
        self.document.commitTransaction()
        self.document.undo()
        self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
        for mark in (True, False):
            container.Placement.Base.x += 10
            if not mark:
                container.purgeTouched()
            self.assertEqual(bool(mesh.Proxy.why_not_to_solve(mesh)), versions.version() >= (1, 0))
            self.document.recompute()
            self.assertEqual((mesh.Status, mesh.FemMesh.BoundBox.XMin), (mesh_object.UP_TO_DATE, versions.parent_frame(box).Base.x))

    def test_a_link_is_meshed_and_loaded_where_it_is(self):
        """FEM's writer looks for the nodes of a force on a face by their places."""
        box = self.document.addObject("Part::Box", "Box")
        box.Length = box.Width = SIDE
        box.Height = HEIGHT
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject, link.Placement = box, placement(30, 40, 50, 30, (1, 2, 3))
        self.document.recompute()
        mesh = api.add_mesh(link, 3)
        self.assertTrue(assembled.shows(versions.part_of(mesh), link))
        self.assertIs(versions.part_of(api.add_mesh(link, 3, join_analysis=False)), versions.part_of(mesh))
        self.document.recompute()
        self.assertLess(max(link.Shape.distToShape(Part.Vertex(*point))[0] for point in points_of(mesh).values()), 1e-6)
        shown = versions.part_of(mesh)
        link.Placement.Base.x += 5
        self.document.recompute()
        self.assertEqual((mesh.Status, mesh.KeptTets), (mesh_object.UP_TO_DATE, 100))
        (solid,) = shown.Shape.Solids
        self.assertLess((solid.CenterOfMass - link.Shape.Solids[0].CenterOfMass).Length, 1e-9)

    def test_a_link_to_a_container_with_datums_is_meshed_without_these(self):
        """Their shapes have no end."""
        inner, outer = self.document.addObject("App::Part", "Inner"), self.document.addObject("App::Part", "Outer")
        for type_, name in (("PartDesign::CoordinateSystem", "Origins"), ("Part::Box", "Box"), ("PartDesign::Plane", "Datum")):
            inner.addObject(self.document.addObject(type_, name))
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject, link.Placement = inner, placement(30, 40, 50, 30, (1, 2, 3))
        outer.addObject(link)
        self.document.recompute()
        for part in (link, outer):
            mesh = self.meshed(part, 3)
            shown = versions.part_of(mesh).Shape
            self.assertAlmostEqual(shown.Volume, 1000)
            self.assertEqual((len(shown.Faces), shown.BoundBox.DiagonalLength < 40), (6, True))
            at = link.Shape.getElement("Face4").CenterOfMass   # the first is that of the coordinate system
            names = resolving.Resolver(versions.part_of(mesh)).names(link, "Face4")
            self.assertEqual([(shown.getElement(name).CenterOfMass - at).Length < 1e-6 for name in names], [True])
            self.document.Box.Length = 12 if part is link else 10
            self.document.recompute()
            self.assertEqual((mesh.Status, mesh.KeptTets > 20), (mesh_object.UP_TO_DATE, True))
            self.document.Box.Length = 10
            self.document.recompute()
        with self.assertRaisesRegex(UserError, "^Compound has a face without an end"):
            api.add_mesh(self.compound([link]))

    def joined_tower(self):
        container = self.document.addObject("App::Part", "Machine")
        boxes = tower(self.document, container)
        for index, box in enumerate(boxes):   # each smaller than the one below, so that faces have to be cut
            box.Length = SIDE - 0.5 * index
        part = assembled.of(container)
        part.Join = True
        self.document.recompute()
        return part, boxes

    def test_parts_that_touch_are_joined_on_request_and_told_face_by_face(self):
        part, boxes = self.joined_tower()
        self.assertEqual(len(part.Joints), COUNT - 1)
        for index, line in enumerate(part.Joints):
            name, told = line.split(": ", 1)
            face = part.Shape.getElement(name)
            self.assertAlmostEqual(face.CenterOfMass.z, (index + 1) * HEIGHT)
            self.assertEqual(told, "Plate%d and Plate%d, %.6g mm^2" % (index, index + 1, face.Area))
        mesh = self.meshed(part)
        parts = nodes_by_solid(mesh)
        self.assertEqual(len(parts), COUNT)
        shared = [len(below & above) for below, above in zip(parts, parts[1:])]
        self.assertGreater(min(shared), 9)
        self.assertFalse(warnings_of_contact(mesh))
        before = points_of(mesh)
        boxes[-1].Height = HEIGHT + 2
        self.document.recompute()
        self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
        now, parts_now = points_of(mesh), nodes_by_solid(mesh)
        for own, then in zip(parts_now[:-1], parts[:-1]):
            self.assertEqual(own, then)
            self.assertTrue(all(np.array_equal(now[number], before[number]) for number in own))
        self.assertEqual(len(parts_now[-2] & parts_now[-1]), shared[-1])
        part.Join = False
        self.document.recompute()
        self.assertEqual(part.Joints, [])
        self.assert_own_nodes(mesh, COUNT)
        (warning,) = warnings_of_contact(mesh)
        self.assertIn("by the property Join of its object 'Parts of ...'", warning)

    def test_parts_that_overlap_are_not_joined(self):
        part, boxes = self.joined_tower()
        boxes[4].Height = HEIGHT + 1
        self.document.recompute()
        with self.assertRaisesRegex(UserError, "Plate4 and Plate5 overlap"):
            part.Proxy.assemble(part)

    def test_what_touches_nothing_is_there_when_parts_are_joined(self):
        """General Fuse lists no pieces of it, nor of a compound, as which later versions of FreeCAD have a body."""
        part, boxes = self.joined_tower()
        alone, container = self.document.addObject("Part::Cylinder", "Alone"), part.Container
        alone.Placement = placement(50, 50, 0)
        beside = self.document.addObject("Part::Feature", "Beside")
        beside.Shape = Part.makeCompound([Part.makeBox(2, SIDE, HEIGHT, FreeCAD.Vector(-2, 0, 0)), Part.makeBox(2, 2, 2, FreeCAD.Vector(-20, 0, 0))])
        for obj in (alone, beside):
            container.addObject(obj)
        self.document.recompute()
        self.assertEqual([len(shape.Solids) for shape in part.Shape.SubShapes], [1] * (COUNT + 1) + [2])
        self.assertAlmostEqual(part.Shape.Volume, sum(obj.Shape.Volume for obj in [*boxes, alone, beside]))
        self.assertEqual(len(part.Joints), COUNT)
        self.assertIn("Plate0 and Beside", part.Joints[-1] + part.Joints[0])

    def test_a_compound_that_overlaps_is_not_joined(self):
        part, boxes = self.joined_tower()
        box = self.document.addObject("Part::Feature", "Beside")
        box.Shape = Part.makeCompound([Part.makeBox(2, SIDE, HEIGHT, FreeCAD.Vector(-1, 0, 0))])
        part.Container.addObject(box)
        with self.assertRaisesRegex(UserError, "Plate0 and Beside overlap"):
            part.Proxy.assemble(part)

    def test_a_solid_that_is_inside_out_is_joined(self):
        part, boxes = self.joined_tower()
        box = self.document.addObject("Part::Feature", "Beside")
        box.Shape = Part.makeBox(2, SIDE, HEIGHT, FreeCAD.Vector(-2, 0, 0)).reversed()
        part.Container.addObject(box)
        self.document.recompute()
        self.assertAlmostEqual(part.Shape.Volume, sum(obj.Shape.Volume for obj in boxes) + 2 * SIDE * HEIGHT)
        self.assertEqual(len(part.Joints), COUNT)

    def test_an_empty_container_is_refused(self):
        empty = self.document.addObject("App::Part", "Empty")
        with self.assertRaisesRegex(UserError, "Empty has no part with a solid"):
            api.add_mesh(empty, 2.0)
        self.assertEqual([obj for obj in self.document.Objects if assembled.is_assembled(obj)], [])

    def test_a_command_takes_the_name_of_a_container(self):
        tower(self.document, self.document.addObject("App::Part", "Machine"))
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        path, edited = (os.path.join(folder, name + ".FCStd") for name in ("machine", "edited"))
        self.document.saveAs(path)

        def run(task, **words):
            new_document()   # closes what the one before has open
            return task({"part": path, "object": "Machine", **words})
        run(tasks.mesh, size=5.0, order=1)
        self.assertRegex(run(tasks.update, set=["Plate9.Length=9"], out=edited)[0], r"^FeatureMesh has \d+ nodes")
        _, found = run(tasks.diff, old=path, new=edited)
        self.assertEqual([feature["name"] for feature in found["features"] if feature["verdict"] == "reshaped"], ["Plate9"])
        self.assertEqual(run(tasks.tree)[1]["object"], "AssembledParts")

    def test_saved_and_reopened_it_updates_as_locally(self):
        container = self.document.addObject("App::Part", "Machine")
        tower(self.document, container)
        self.meshed(container)
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        path = os.path.join(folder, "machine.FCStd")
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        mesh = api.find_mesh(self.document)
        self.check_edit(mesh, [self.document.getObject("Plate%d" % index) for index in range(COUNT)])


@unittest.skipUnless(shutil.which("ccx"), "this machine has no CalculiX")
class TiedAndInContact(InADocument):
    """A tower, held at its foot, pressed from above: nine joints, of which one is a contact and the others are ties."""

    def add_analysis(self, mesh, with_joints=True):
        analysis = ObjectsFem.makeAnalysis(self.document, "Analysis")
        analysis.addObject(mesh)
        part, shape = versions.part_of(mesh), versions.part_of(mesh).Shape
        add_solver(self.document, analysis)
        add_material(self.document, analysis, "Material", STEEL)
        fixed = ObjectsFem.makeConstraintFixed(self.document, "Fixed")
        fixed.References = [(part, face_at(shape, 0, 0))]
        force = ObjectsFem.makeConstraintForce(self.document, "Force")
        force.References = [(part, face_at(shape, len(shape.Solids) - 1, len(shape.Solids) * HEIGHT))]
        force.Force = quantity(FORCE, "N")
        force.Reversed = True
        for obj in (fixed, force):
            analysis.addObject(obj)
        self.joints = []
        for index in range(1, COUNT if with_joints else 1):
            is_contact = index == COUNT - 1
            joint = (ObjectsFem.makeConstraintContact if is_contact else ObjectsFem.makeConstraintTie)(self.document, "Joint%d" % index)
            joint.References = [(part, face_at(shape, index, index * HEIGHT)), (part, face_at(shape, index - 1, index * HEIGHT))]
            if is_contact:
                joint.Friction, joint.Slope = 0.0 if versions.version() < (1, 0) else False, quantity(1e6, "GPa/m")
            else:
                joint.Tolerance = quantity(0.01, "mm")
            analysis.addObject(joint)
            self.joints.append(joint)
        self.document.recompute()
        return analysis

    def check_solution(self, analysis, mesh, length):
        solution = solve(analysis)
        parts = nodes_by_solid(mesh)
        elements = {number: set(mesh.FemMesh.getElementNodes(number)) for number in mesh.FemMesh.Volumes}
        surfaces = dict(re.findall(r"\*SURFACE, ?NAME=(\w+)\n((?:\d+,\s*S\d\n)+)", solution["input"], re.IGNORECASE))
        for index, joint in enumerate(self.joints, 1):
            of_joint = [surfaces[prefix + joint.Name] for prefix in (("DEP", "IND") if "Contact" in joint.TypeId else ("TIE_DEP", "TIE_IND"))]
            for solid, lines in zip((index, index - 1), of_joint):
                numbers = [int(line.split(",")[0]) for line in lines.split()]
                self.assertGreater(len(numbers), 10)
                self.assertEqual([number for number in numbers if not elements[number] <= parts[solid]], [], (joint.Name, solid))
        expected = FORCE * length / (210000 * SIDE * SIDE)
        self.assertAlmostEqual(solution["displacement_z"] / expected, 1, delta=0.06)

    def test_solved_before_and_after_an_edit(self):
        boxes = tower(self.document)
        mesh = self.meshed(self.compound(boxes), order=2)
        analysis = self.add_analysis(mesh)
        self.check_solution(analysis, mesh, COUNT * HEIGHT)
        self.check_edit(mesh, boxes)
        self.check_solution(analysis, mesh, COUNT * HEIGHT + 2)

    def test_parts_that_nothing_holds_are_named(self):
        analysis = self.add_analysis(self.meshed(self.compound(tower(self.document)[:3])), with_joints=False)
        with self.assertRaisesRegex(UserError, "^Solid2, Solid3 can still move along x, y and z and turn about x, y and z: add a support"):
            api.solve_analysis(analysis, "ccx")

    def test_solids_are_named_with_the_parts_that_they_are_of(self):
        container = self.document.addObject("App::Part", "Machine")
        tower(self.document, container)[3].Label = "Lid"
        mesh = self.meshed(container)
        self.assertIn(" Solid3 (Plate2) and Solid4 (Lid); ", *warnings_of_contact(mesh))
        with self.assertRaisesRegex(UserError, r"^Solid2 \(Plate1\), Solid3 \(Plate2\), Solid4 \(Lid\), .* can still move along"):
            api.solve_analysis(self.add_analysis(mesh, with_joints=False), "ccx")

    def test_a_tie_that_ties_nothing_is_refused_and_what_flies_away_is_said(self):
        boxes = tower(self.document)[:2]
        boxes[1].Placement.Base.z, boxes[1].Height = HEIGHT + 0.5, HEIGHT - 0.5
        mesh = self.meshed(self.compound(boxes))
        analysis, part = self.add_analysis(mesh, with_joints=False), versions.part_of(mesh)
        tie = ObjectsFem.makeConstraintTie(self.document, "Tie")
        tie.References = [(part, face_at(part.Shape, solid, HEIGHT + gap)) for solid, gap in ((1, 0.5), (0, 0))]
        analysis.addObject(tie)
        for tolerance, words in ((0.0, "its tolerance is 0 mm"), (0.4, "0.5 mm apart, and its tolerance is 0.4 mm"), (0.6, None)):
            tie.Tolerance = quantity(tolerance, "mm")
            self.document.recompute()
            self.assertEqual(words is None, solve_guard.reason(analysis) == "")
            self.assertIn(words or "", solve_guard.reason(analysis))
        tie.Tolerance = quantity(0.4, "mm")
        with mock.patch.object(contact_faces, "out_of_reach", lambda *_: None):
            warnings = in_english(api.solve_analysis(analysis, "ccx")["warnings"])
        self.assertRegex(warnings[0], "^the part moved by .* times its own size: it can move, since")
        solver = calculix.solver_of(analysis)
        self.assertEqual(in_english(calculix.has_flown(analysis, solver)), warnings[:1])   # which FEM's panel tells in the report view
        solver.AnalysisType = "frequency"
        self.assertEqual(calculix.has_flown(analysis, solver), [])

    def test_joined_parts_are_solved_without_ties(self):
        container = self.document.addObject("App::Part", "Machine")
        tower(self.document, container)
        part = assembled.of(container)
        part.Join = True
        self.document.recompute()
        mesh = self.meshed(part, order=2)
        analysis = self.add_analysis(mesh, with_joints=False)
        expected = FORCE * COUNT * HEIGHT / (210000 * SIDE * SIDE)
        self.assertAlmostEqual(solve(analysis)["displacement_z"] / expected, 1, delta=0.02)

    def test_references_as_they_are_clicked_on_the_parts(self):
        """A face of a part that lies on a face of another one: the part that was clicked is meant."""
        container = self.document.addObject("App::Part", "Machine")
        boxes = tower(self.document, container)
        mesh = self.meshed(container)
        analysis = ObjectsFem.makeAnalysis(self.document, "Analysis")
        analysis.addObject(mesh)
        tie = ObjectsFem.makeConstraintTie(self.document, "Tie")
        tie.References = [(boxes[3], face_at(boxes[3].Shape, 0, 3 * HEIGHT)), (boxes[2], face_at(boxes[2].Shape, 0, 3 * HEIGHT))]
        analysis.addObject(tie)
        self.document.recompute()
        part = versions.part_of(mesh)
        self.assertEqual([(obj, name) for obj, names in tie.References for name in names],
                         [(part, face_at(part.Shape, 3, 3 * HEIGHT)), (part, face_at(part.Shape, 2, 3 * HEIGHT))])

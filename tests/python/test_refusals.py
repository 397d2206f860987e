# SPDX-License-Identifier: GPL-3.0-or-later
"""What a script may ask for by mistake is refused in a sentence: parts without a shape, objects that are gone, settings without sense, sizes far too small."""
import errno
import os
import tempfile
import unittest
from unittest import mock

import FreeCAD
import ObjectsFem
import Part
from freecad.featuremesh import api, engine
from freecad.featuremesh.errors import UserError
from freecad.featuremesh.study import study_object, window_run
from freecad.featuremesh.too_fine import _elements_around, _measured, refuse_too_fine
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
        group = self.document.addObject("App::LinkGroup", "Links")
        group.ElementList = [self.box()]
        self.document.recompute()
        self.refused(r"Links is a group of links, which has no shape; make a compound of it", group)
        with self.assertRaisesRegex(UserError, "make a compound of it"):
            api.find_part(self.document, "Links")

    def test_a_study_where_nobody_may_write(self):
        body = plate_with_hole(self.document)
        study = api.add_study(body)
        study.Parameters, study.Responses = ["HoleSketch.Radius=5:7"], ["mass"]
        with mock.patch.object(os, "makedirs", side_effect=PermissionError(errno.EACCES, os.strerror(errno.EACCES))), \
                self.assertRaisesRegex(UserError, r"the study's folder .*-study cannot be made \(Permission denied\); save the document where you may write"):
            study_object.start(study)
        study.Folder = tempfile.mkdtemp()
        self.addCleanup(os.rmdir, study.Folder)
        with mock.patch.object(window_run, "open", create=True, side_effect=PermissionError(errno.EACCES, os.strerror(errno.EACCES), "run.log")), \
                self.assertRaisesRegex(UserError, "cannot write run.log: Permission denied"):
            study_object.go_on(study)

    def test_a_study_that_cannot_run_leaves_no_folder(self):
        study = api.add_study(plate_with_hole(self.document))
        study.Parameters, study.Responses = ["HoleSketch.Radius=5:7"], ["mass"]
        with tempfile.TemporaryDirectory() as folder:
            self.document.saveAs(os.path.join(folder, "part.FCStd"))
            with mock.patch.object(window_run, "program", side_effect=UserError("no program")), self.assertRaisesRegex(UserError, "no program"):
                study_object.start(study)
            self.assertEqual((os.listdir(folder), study.Folder), (["part.FCStd"], ""))

    def test_a_study_of_what_has_no_shape(self):
        study = api.add_study(self.box())
        study.Parameters, study.Responses, study.Part = ["Box.Height=5:7"], ["mass"], self.document.addObject("App::FeaturePython", "Point")
        with self.assertRaisesRegex(UserError, "^Point has no shape"):
            study_object.start(study)

    def test_the_range_of_an_angle_is_one_that_freecad_takes(self):
        cylinder = self.document.addObject("Part::Cylinder", "Cylinder")
        for angle, wanted in ((360, (324, 360)), (340, (306, 360)), (90, (81, 99))):
            cylinder.Angle = angle
            self.document.recompute()
            study = api.add_study(cylinder)
            found, = [dimension for dimension in study_object.dimensions_of(study) if dimension.name == "Angle"]
            self.assertEqual(found.usual_range(), wanted)
            api.set_parameters(self.document, ["Cylinder.Angle=%g" % wanted[1]])

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
        self.refused("is no length", box, FreeCAD.Units.Quantity("5 deg"))
        self.refused("not 3", box, 3, order=3)
        self.refused("not 0", box, elements=0)
        self.assertEqual(api.add_mesh(box, "0.3 cm").Size.Value, 3)
        for size in ("0.3 cm", 3, "3"):
            self.assertEqual(api.add_mesh(box, FreeCAD.Units.Quantity(size)).Size.Value, 3)

    def test_nothing_is_left_behind(self):
        container, box = self.document.addObject("App::Part", "Container"), self.document.addObject("Part::Box", "Inside")
        container.addObject(box)
        self.document.recompute()
        self.refused("not -1", container, -1)
        count = len(self.document.Objects)
        with self.assertRaises(TypeError):
            api.add_mesh(box, 3, automatic="yes")
        self.assertEqual(len(self.document.Objects), count)

    def test_a_number_that_is_none_is_called_so(self):
        self.refused("not nan", self.box(), float("nan"))
        self.refused("nan is no length", self.document.Box, 3, ignore_below=float("nan"))


class OfAMesh(unittest.TestCase):
    """What is given beside a mesh, or in its place."""

    def setUp(self):
        self.document = new_document()
        self.body = plate_with_hole(self.document)
        self.analysis = ObjectsFem.makeAnalysis(self.document, "Analysis")
        self.mesh = api.add_mesh(self.body, 8, order=1)
        self.count = len(self.document.Objects)

    def refused(self, words, function, *arguments, **more):
        with self.assertRaisesRegex(UserError, words):
            function(*arguments, **more)
        self.assertEqual(len(self.document.Objects), self.count)

    def test_another_object_than_a_mesh(self):
        removed = self.document.addObject("Part::Box", "Removed")
        self.document.removeObject("Removed")
        for function, more in ((api.update_mesh, ()), (api.renumber_mesh, ()), (api.estimate_tets, ()), (api.show_kept, ()), (api.show_quality, ()), (api.show_plain, ()),
                               (api.draw_quality, ("mesh.png",)), (api.export_mesh, ("mesh.inp",)), (api.add_local_size, ([(self.body, "Face1")],)),
                               (api.add_group, ([(self.body, "Face1")],)), (api.add_size_zone, ()), (api.share_mesh, (self.analysis,)),
                               (api.transfer_field, (self.mesh, [1.0]))):
            with self.subTest(function=function.__name__):
                self.refused("Body is no mesh of FeatureMesh", function, self.body, *more)
                self.refused("None is no object of a document; give a mesh of FeatureMesh", function, None, *more)
                self.refused("it was deleted", function, removed, *more)

    def test_a_picture_of_which_the_cut_leaves_nothing(self):
        self.document.recompute()
        box = self.body.Shape.BoundBox
        for cut in ("z>%g" % (box.ZMax + 1), "x<%g" % (box.XMin - 1)):
            with self.subTest(cut):
                self.refused("the cut leaves nothing of FeatureMesh; its nodes are from [(]", api.draw_quality, self.mesh, "mesh.png", cut=cut)

    def test_another_object_than_an_analysis(self):
        for function in (api.solve, api.solve_analysis, api.live_result, api.copy_analysis):
            with self.subTest(function=function.__name__):
                self.refused("Body is no analysis", function, self.body)
                self.refused("None is no object of a document; give an analysis", function, None)
        self.refused("the solver is live or ccx, not gmsh", api.solve_analysis, self.analysis, "gmsh")

    def test_no_document(self):
        for function in (api.recompute, api.find_mesh, api.find_part, api.find_analysis):
            with self.subTest(function=function.__name__):
                self.refused("None is no open document", function, None)
        self.refused("None is no open document", api.set_parameters, None, ["Plate.Length=8"])

    def test_an_analysis_of_another_document(self):
        other = FreeCAD.newDocument("Other")
        try:
            analysis = ObjectsFem.makeAnalysis(other, "There")
            self.refused("are in two documents", api.share_mesh, self.mesh, analysis)
            self.assertEqual([obj.Name for obj in other.Objects], ["There"])
            with self.assertRaises(ValueError):
                api.add_study(self.body, analysis)
            self.assertEqual(len(self.document.Objects), self.count)
        finally:
            FreeCAD.closeDocument("Other")

    def test_references(self):
        for words, references in (("not of Body:Face99", [(self.body, "Face99")]), ("not of Body:Face0", [(self.body, "Face0")]), ("not of Body:Lid", [(self.body, "Lid")]),
                                  ("not of Body:Face99", "Face99"), ("not of Body:Face99", [(self.body, ("Face1", "Face99"))]),
                                  ("a reference is an object and a name.*not 5", 5), ("a reference is an object and a name.*not 5", ["Face1", (self.body, 5)]),
                                  ("select .*faces, edges or vertices of Body", []), ("None is no object of a document", [(None, "Face1")])):
            for function, kind in ((api.add_local_size, ()), (api.add_group, ()), (api.add_size_zone, ("Distance",))):
                with self.subTest(words=words, function=function.__name__):
                    self.refused(words, function, self.mesh, *kind, references)

    def test_all_forms_of_references_that_mean_the_same(self):
        load = ObjectsFem.makeConstraintForce(self.document)
        load.References = [(self.body, ("Face1", "Face2"))]
        for references in (["Face1", "Face2"], ("Face1", "Face2"), [(self.body, "Face1"), (self.body, "Face2")], (self.body, ["Face1", "Face2"]), load.References):
            with self.subTest(references=str(references)):
                self.assertEqual(list(api.add_local_size(self.mesh, references).References), [(self.body, ("Face1", "Face2"))])
        for references in ("Face1", (self.body, "Face1")):
            self.assertEqual(list(api.add_group(self.mesh, references).References), [(self.body, ("Face1",))])
        for references in (self.body, (self.body, ""), "Solid1"):
            self.assertEqual(list(api.add_group(self.mesh, references).References), [(self.body, ("Solid1",))])

    def test_threads(self):
        for wrong in (-1, "2", None, 1.5):
            self.refused("the number of threads is a whole number", api.add_mesh, self.body, 4, 2, wrong)

    def test_one_edit_alone(self):
        api.set_parameters(self.document, "Plate.Length=8")
        self.assertEqual(self.document.Plate.Length.Value, 8)

    def test_sizes_of_refinements(self):
        for wrong, words in ((0, "greater than 0 mm, not 0"), (-1, "greater than 0 mm, not -1"), (float("nan"), "not nan"), ("x", "x is no length")):
            self.refused(words, api.add_local_size, self.mesh, [(self.body, "Face1")], wrong)
            self.refused(words, api.add_size_zone, self.mesh, inner=wrong)
        self.refused("length has to be 0 mm or more, not -2", api.add_size_zone, self.mesh, length=-2)
        self.refused("inf is no length", api.add_size_zone, self.mesh, outer=float("inf"))
        with self.assertRaises(TypeError):
            api.add_size_zone(self.mesh, placement=FreeCAD.Vector(1, 2, 3))
        self.assertEqual(len(self.document.Objects), self.count)
        self.assertEqual(api.add_local_size(self.mesh, [(self.body, "Face1")], "0.2 cm").CharacteristicLength.Value, 2)

    def test_limits_and_cuts(self):
        api.update_mesh(self.mesh)
        for limits in ((1,), (1, 1), "ab", 5, (0, float("nan"))):
            self.refused("two numbers that differ", api.show_quality, self.mesh, "radius_ratio", limits)
        for cut in ("z=nan", 5, "z"):
            self.refused("a cut is x, y or z", api.show_quality, self.mesh, cut=cut)


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
        self.mesh.Size = float("inf")
        with self.assertRaisesRegex(engine.load().InputError, "is larger than the part"):
            api.update_mesh(self.mesh)
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
                ratio = _elements_around(_measured(self.body.Shape), entity, 0.5, 4.0, growth - 1) / added
                self.assertTrue(bounds[0] < ratio < bounds[1], (entity, growth, ratio))

    def test_the_part_is_measured_once_for_all_refinements(self):
        """Whoever types a size waits for that: of 196 faces with a size each it took 3.3 s."""
        asked = []

        class Asked:
            def __getattr__(self, name):
                asked.append(name)
                return getattr(shape, name)
        shape = self.body.Shape
        refuse_too_fine(Asked(), 5, 1.3, [("Face%d" % (i + 1), 1.0, "Fine") for i in range(len(shape.Faces))])
        self.assertEqual(asked.count("Volume"), 1)

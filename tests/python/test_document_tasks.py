# SPDX-License-Identifier: GPL-3.0-or-later
"""The launcher's commands from end to end, and everything a user can get wrong: one message, no file touched."""
import errno
import json
import os
import re
import shutil
import tempfile
import unittest
import zipfile
from unittest import mock

import FreeCAD
import Part
import Sketcher
from freecad.featuremesh import api, cli, documents, export, tables, tasks
from parts import new_document, plate_with_hole

BRACKET = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "resources", "examples", "bracket.FCStd")


class Tasks(unittest.TestCase):

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.part = self.path("part.FCStd")
        self.document = new_document()
        plate_with_hole(self.document)
        documents.save_document(self.document, self.part)

    def path(self, name):
        return os.path.join(self.folder, name)

    def run_task(self, **task):
        """Every task starts from what is on disk, as in a process of its own."""
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)
        return cli.run(task)

    def test_what_was_done_and_cannot_be_told_is_another_exit(self):
        """FreeCAD would run the task once more, and say that it was not done."""
        ended = []
        with mock.patch.dict(os.environ, FEATUREMESH_TASK='{"command": "none"}', FEATUREMESH_RESULT=self.path("no/folder/result.json")), \
                mock.patch("freecad.featuremesh.parent_process.end_with"), mock.patch.object(cli, "run", lambda task: {"exit_code": 0}), \
                mock.patch.object(os, "_exit", ended.append):
            cli.run_from_environment()
        self.assertEqual(ended, [cli.RESULT_NOT_WRITTEN])

    def done(self, **task):
        result = self.run_task(**task)
        self.assertEqual(result["exit_code"], 0, result["message"])
        return result

    def refused(self, message, **task):
        """Exit code 2, one line, and no file written or changed."""
        before = self.files()
        result = self.run_task(**task)
        self.assertEqual(result["exit_code"], 2, result["message"])
        self.assertRegex(result["message"], message)
        self.assertNotIn("\n", result["message"])
        self.assertEqual(self.files(), before)

    def files(self):
        contents = {}
        for name in os.listdir(self.folder):
            with open(self.path(name), "rb") as stream:
                contents[name] = stream.read()
        return contents

    def mesh(self, **options):
        return self.done(command="mesh", part=self.part, size=4.0, **{"order": 1, **options})

    def save(self, *shapes):
        """A document with these shapes as Part features."""
        document = new_document()
        for index, shape in enumerate(shapes, 1):
            document.addObject("Part::Feature", "Shape%d" % index).Shape = shape
        path = self.path("shapes.FCStd")
        documents.save_document(document, path)
        return path

    # What works

    def test_angles_that_the_part_forces_are_told_from_others(self):
        points = [FreeCAD.Vector(*point) for point in ((0, 0, 0), (10, 0, 0), (10, 0.8, 0), (10, 0.4, 10))]
        flat = Part.Solid(Part.Shell([Part.Face(Part.makePolygon([points[i] for i in corners])) for corners in ((0, 1, 2, 0), (0, 1, 3, 0), (1, 2, 3, 1), (0, 2, 3, 0))]))
        wedge = Part.Face(Part.makePolygon([FreeCAD.Vector(*point) for point in ((0, 0), (20, 0), (20, 1), (0, 0))])).extrude(FreeCAD.Vector(0, 0, 10))
        for shape, size, words in ((flat, 9, "the part's own details force such angles everywhere"), (wedge, 4, "[2-9][0-9]?[.][0-9] deg where the part")):
            document = new_document()
            document.addObject("Part::Feature", "Part").Shape = shape
            documents.save_document(document, self.path("sharp.FCStd"))
            self.assertRegex(self.done(command="mesh", part=self.path("sharp.FCStd"), size=size, order=1)["message"], "smallest angle [0-9.]+ deg, " + words)

    def test_the_parts_of_a_container_are_meshed_and_updated(self):
        document = new_document()
        container = document.addObject("App::Part", "Machine")
        for index in range(2):
            box = document.addObject("Part::Box", "Box%d" % index)
            box.Placement.Base.z = 10 * index
            container.addObject(box)
        document.recompute()
        path = self.path("machine.FCStd")
        documents.save_document(document, path)
        self.done(command="mesh", part=path, object="Machine", size=4.0, order=1)
        result = self.done(command="update", part=path, set=["Box1.Height=12"])
        self.assertIsNone(result["data"]["fallback"])
        self.assertGreater(result["data"]["kept"]["nodes_share"], 0.4)

    def test_a_report_is_written_as_a_whole_or_not_at_all(self):
        report = self.path("report.json")
        self.mesh(json=report)
        before = self.files()

        def half(value, stream, **_):
            stream.write("{")
            raise OSError(errno.ENOSPC, "No space left on device")
        with mock.patch.object(tasks.json, "dump", half):
            result = self.run_task(command="update", part=self.part, set=["HoleSketch.X=23"], json=report)
        self.assertEqual((result["exit_code"], result["message"]), (2, "saved %s, but cannot write the report: No space left on device" % self.part))
        self.assertEqual({name: content for name, content in self.files().items() if name != "part.FCStd"},
                         {name: content for name, content in before.items() if name != "part.FCStd"})
        os.symlink("elsewhere.json", self.path("link.json"))
        with open(self.path("report.json.tmp"), "w", encoding="utf-8") as stream:
            stream.write("somebody's own")
        os.chmod(report, 0o600)
        for name in ("link.json", "report.json"):
            self.done(command="update", part=self.part, set=["HoleSketch.X=24"], json=self.path(name))
        self.assertTrue(os.path.islink(self.path("link.json")) and os.path.isfile(self.path("elsewhere.json")))
        self.assertEqual(os.stat(report).st_mode & 0o777, 0o600)
        self.assertEqual(self.files()["report.json.tmp"], b"somebody's own")
        self.done(command="update", part=self.part, set=["HoleSketch.X=25"], json="/dev/null")
        self.assertFalse(os.path.isfile("/dev/null"))

    def test_mesh_then_update(self):
        self.mesh(json=self.path("first.json"))
        result = self.done(command="update", part=self.part, set=["HoleSketch.X=23"], json=self.path("second.json"))
        with open(self.path("second.json"), encoding="utf-8") as stream:
            report = json.load(stream)
        self.assertEqual(report, json.loads(json.dumps(result["data"])))
        for key in ("nodes", "tets", "order", "size", "seconds", "peak_memory_mb", "quality", "kept", "difference", "fallback"):
            self.assertIn(key, report)
        for step in ("read", "difference", "keep", "surface", "volume", "optimise", "validate", "engine_total",
                     "hand_over", "recompute"):
            self.assertIn(step, report["seconds"])
        self.assertIsNone(report["fallback"])
        self.assertGreater(report["kept"]["nodes_share"], 0.3)
        opened = documents.open_document(self.part)
        self.assertEqual(opened.getObject("FeatureMesh").TetCount, report["tets"])
        self.assertAlmostEqual(opened.getObject("HoleSketch").getDatum("X").Value, 23)

    def test_update_of_several_parameters_into_another_file(self):
        self.mesh()
        before = self.files()["part.FCStd"]
        self.done(command="update", part=self.part, out=self.path("out.FCStd"),
                  set=["HoleSketch.X=24", "HoleSketch.Radius=5", "Plate.Length=12"])
        self.assertEqual(self.files()["part.FCStd"], before)
        opened = documents.open_document(self.path("out.FCStd"))
        self.assertAlmostEqual(opened.getObject("Body").Shape.Volume, 12 * (2400 - 25 * 3.14159265358979), 6)

    def test_full_mesh_of_the_edited_part(self):
        self.mesh()
        report = self.done(command="update", part=self.part, set=["HoleSketch.X=24"], full=True)["data"]
        self.assertEqual(report["kept"]["nodes_share"], 0)
        self.assertIn("--full", report["fallback"])

    def test_elements_have_10_nodes_unless_4_are_asked_for(self):
        for task, order, corners in (({}, "2nd", 10), ({"order": 1}, "1st", 4), ({}, "1st", 4)):   # the last meshes the same object again
            self.done(command="mesh", part=self.part, size=8.0, **task)
            mesh, = api.meshes_of(documents.open_document(self.part))
            self.assertEqual(mesh.Order, order)
            self.assertEqual(len(mesh.FemMesh.getElementNodes(mesh.FemMesh.Volumes[0])), corners)

    def test_mesh_twice_gives_one_mesh(self):
        self.mesh()
        self.mesh()
        self.assertEqual(len(api.meshes_of(documents.open_document(self.part))), 1)

    def test_tree_and_diff(self):
        tree = self.done(command="tree", part=self.part)
        self.assertEqual({feature["name"]: feature["role"] for feature in tree["data"]["features"]}["Hole"], "subtractive")
        self.assertIn("Hole", tree["message"])
        self.mesh()
        self.done(command="update", part=self.part, out=self.path("new.FCStd"), set=["HoleSketch.X=24"])
        diff = self.done(command="diff", old=self.part, new=self.path("new.FCStd"))
        verdicts = {feature["name"]: feature["verdict"] for feature in diff["data"]["features"]}
        self.assertEqual(verdicts["Hole"], "moved")
        self.assertIn(verdicts["Plate"], ("same", "interaction changed"))  # the hole trims it elsewhere
        json.dumps(diff["data"])

    def test_volumes_of_what_came_and_went(self):
        feature = {"name": "Fillet", "label": "Fillet", "verdict": "suppressed", "detail": None, "old_faces": [], "new_faces": []}
        volumes = [tables.rows_of_difference({"features": [{**feature, "old_volume": old, "new_volume": new}]})[1][0][3] for old, new in ((226.5, 0.0), (0.0, 3.0), (0.0, 0.0))]
        self.assertEqual(volumes, ["226.5 -> 0", "0 -> 3", ""])

    def test_picture_of_a_difference(self):
        self.mesh()
        self.done(command="update", part=self.part, out=self.path("new.FCStd"), set=["HoleSketch.X=24"])
        answer = self.done(command="diff", old=self.part, new=self.path("new.FCStd"), picture=self.path("diff.png"))
        self.assertIn("diff.png", answer["message"])
        from matplotlib import image
        red, green, blue = (image.imread(self.path("diff.png"))[:, :, channel] for channel in range(3))
        self.assertGreater(((red > green + 0.3) & (red > blue + 0.3)).sum(), 200)  # the old wall
        self.assertGreater(((green > red + 0.2) & (green > blue + 0.1)).sum(), 200)  # the new wall

    def test_picture_of_the_quality(self):
        self.mesh()
        from matplotlib import image
        seen = []
        for options in ({}, {"cut": "z=5"}, {"cut": "z=5", "filled": True}, {"limits": [0.99, 1.0]}):
            answer = self.done(command="picture", part=self.part, quality="radius_ratio", out=self.path("mesh.png"), **options)
            self.assertRegex(answer["message"], "radius ratio from 0[.][0-9]+ to ")
            seen.append(image.imread(self.path("mesh.png")))
            red, green, blue = (seen[-1][:, :, channel] for channel in range(3))
            self.assertGreater(((red > green + 0.2) & (red > blue + 0.2) if "limits" in options else (green > red + 0.1) & (green > blue + 0.1)).sum(), 2000)
        self.assertFalse(any(one.shape == other.shape and (one == other).all() for one, other in zip(seen, seen[1:])))
        self.refused("a cut is x, y or z", command="picture", part=self.part, quality="skewness", cut="w", out=self.path("mesh.png"))
        self.refused("the picture could not be drawn: Format 'txt' is not supported", command="picture", part=self.part, quality="skewness", out=self.path("mesh.txt"))

    def test_export(self):
        self.mesh()
        for name in export.FORMATS:
            answer = self.done(command="export", part=self.part, format=name, out=self.path("mesh." + name))
            self.assertGreater(os.path.getsize(self.path("mesh." + name)), 10000)
            has_groups = name not in ("stl", "z88")
            self.assertEqual((answer["data"]["groups"] > 5, "groups" in answer["message"]), (has_groups, has_groups), answer["message"])

    def test_what_is_written_of_an_old_mesh_is_told(self):
        self.mesh()
        self.assertEqual(self.done(command="export", part=self.part, format="inp", out=self.path("mesh.inp"))["data"]["warnings"], [])
        document = documents.open_document(self.part)
        api.find_mesh(document).Automatic = False
        api.edit(document, "HoleSketch.X=25")
        documents.save_document(document, self.part)
        warning, = self.done(command="export", part=self.part, format="inp", out=self.path("mesh.inp"))["data"]["warnings"]
        self.assertRegex(warning, "^These are the elements of the last mesh: out of date")

    def test_abaqus_surfaces_have_the_area_of_the_faces(self):
        self.mesh()
        self.done(command="export", part=self.part, format="inp", out=self.path("mesh.inp"))
        with open(self.path("mesh.inp"), encoding="ascii") as stream:
            blocks = stream.read().split("*")
        nodes, tets, areas = {}, {}, {}
        sides = {"S1": (0, 1, 2), "S2": (0, 1, 3), "S3": (1, 2, 3), "S4": (0, 2, 3)}
        for block in blocks:
            lines = [[word.strip() for word in line.split(",")] for line in block.split("\n")[1:] if line.strip()]
            if block.startswith("NODE,"):
                nodes = {int(line[0]): FreeCAD.Vector(*map(float, line[1:])) for line in lines}
            elif block.startswith("ELEMENT,"):
                tets = {int(line[0]): [int(word) for word in line[1:]] for line in lines}
            elif block.startswith("SURFACE,"):
                corners = [[nodes[tets[int(number)][i]] for i in sides[side]] for number, side in lines]
                areas[block.split("NAME=")[1].split(",")[0]] = sum(
                    (b - a).cross(c - a).Length / 2 for a, b, c in corners)
        shape = documents.open_document(self.part).getObject("Body").Shape
        self.assertEqual(len(areas), len(shape.Faces))
        for name, area in areas.items():
            face = shape.getElement(name)
            self.assertAlmostEqual(area / face.Area, 1, delta=0.05, msg=name)

    # What does not

    def test_files_that_are_no_documents(self):
        with open(self.path("text.FCStd"), "w", encoding="utf-8") as stream:
            stream.write("hello")
        self.refused("not a FreeCAD document", command="mesh", part=self.path("text.FCStd"))
        self.refused("no file", command="update", part=self.path("none.FCStd"))

    def test_document_without_a_solid(self):
        path = self.save(Part.Vertex(3, 4, 0))
        self.refused("has no part to mesh", command="mesh", part=path)

    def test_document_of_a_sheet(self):
        path = self.save(Part.makePlane(3, 4))
        self.refused("no solid", command="mesh", part=path, dimension="solids")
        self.assertGreater(self.done(command="mesh", part=path)["data"]["triangles"], 100)
        lines = self.done(command="mesh", part=path, dimension="edges")
        self.assertGreater(lines["data"]["segments"], 10)
        self.assertNotIn("angle", lines["message"])

    def test_several_solids(self):
        path = self.save(Part.makeBox(1, 1, 1), Part.makeSphere(2))
        self.refused(r"Shape1, Shape2 \(name it with --object\)", command="mesh", part=path)
        self.done(command="mesh", part=path, object="Shape2")

    def test_solids_that_overlap_are_meshed_with_a_warning_in_the_console(self):
        both = Part.makeCompound([Part.makeBox(10, 10, 10), Part.makeBox(10, 10, 10, FreeCAD.Vector(5, 5, 5))])
        with tempfile.TemporaryFile() as console:
            stderr = os.dup(2)
            os.dup2(console.fileno(), 2)
            try:
                path = self.save(both)
                result = self.done(command="mesh", part=path, size=4.0)
            finally:
                os.dup2(stderr, 2)
                os.close(stderr)
            console.seek(0)
            said = console.read().decode()
        self.assertRegex(" ".join(result["data"]["warnings"]), "Solid1 and Solid2.*the material counts twice")
        for line in result["data"]["warnings"]:
            self.assertIn("FeatureMesh: " + line, said)
        self.assertRegex(" ".join(self.done(command="tree", part=path)["data"]["notes"]), "overlap by 125")

    def test_a_mesh_that_no_analysis_takes_is_said_to_be_in_none(self):
        document = documents.open_document(BRACKET)
        document.Analysis.addObject(document.addObject("Fem::FemMeshObject", "Older"))
        documents.save_document(document, self.part)
        self.assertRegex(" ".join(self.mesh()["data"]["warnings"]), "in no analysis: Analysis has Older already")

    def test_a_document_of_a_later_freecad_is_written_with_a_warning(self):
        with zipfile.ZipFile(self.part) as archive:
            members = {name: archive.read(name) for name in archive.namelist()}
        members["Document.xml"] = re.sub(rb'(?<=ProgramVersion=")[^"]*', b"999.1R1", members["Document.xml"])
        with zipfile.ZipFile(self.part, "w") as archive:
            for name, content in members.items():
                archive.writestr(name, content)
        self.assertRegex(" ".join(self.mesh()["data"]["warnings"]), r"^FreeCAD 999\.1 saved this document")
        self.assertEqual(self.mesh()["data"]["warnings"], [])

    def test_open_shell(self):
        path = self.save(Part.Solid(Part.Shell(Part.makeBox(1, 2, 3).Faces[:5])))
        self.refused("open|closed", command="mesh", part=path)

    def test_sizes_that_make_no_sense(self):
        for size, message in ((0.0, "greater than 0"), (-2.0, "greater than 0"), (500.0, "larger than the part"),
                              (1e-3, "million|tets")):
            self.refused(message, command="mesh", part=self.part, size=size)

    def test_update_without_a_mesh(self):
        self.refused("has no mesh", command="update", part=self.part, set=["Plate.Length=12"])

    def test_unknown_names(self):
        self.mesh()
        self.refused("did you mean Plate", command="update", part=self.part, set=["Plat.Length=12"])
        self.refused("did you mean Length", command="update", part=self.part, set=["Plate.Lengt=12"])
        self.refused("OBJECT.PROPERTY=VALUE", command="update", part=self.part, set=["Plate"])
        self.refused("no object Nothing; its parts are Body", command="mesh", part=self.part, object="Nothing")

    def test_edit_that_cannot_be_recomputed(self):
        self.mesh()
        self.refused("cannot recompute Plate: .+", command="update", part=self.part, set=["Plate.Length=0"])
        document = documents.open_document(self.part)
        document.HoleSketch.addConstraint(Sketcher.Constraint("Radius", 0, 7))   # it has one: FreeCAD says so in several lines
        documents.save_document(document, self.part)
        self.refused("cannot recompute HoleSketch: .+", command="update", part=self.part, set=["HoleSketch.Placement.Base.x=1"])

    def test_edit_that_leaves_nothing(self):
        self.mesh()
        self.refused("Hole", command="update", part=self.part, set=["HoleSketch.Radius=100"])

    def test_unwritable_output(self):
        self.refused("cannot write", command="mesh", part=self.part, size=4.0, out=self.path("none/out.FCStd"))

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_an_analysis_without_a_mesh_is_not_solved(self):
        for which in ({}, {"ccx": True}):
            self.refused("^Analysis has no mesh; mesh its part first, by Mesh a part or `featuremesh mesh`$", command="solve", part=BRACKET,
                         out=self.path("out.FCStd"), **which)
        self.refused("needs one mesh of FeatureMesh", command="solve", part=BRACKET, live=True, out=self.path("out.FCStd"))

    def test_a_saved_mesh_that_is_damaged(self):
        self.mesh()
        document = documents.open_document(self.part)
        with open(document.FeatureMesh.SavedState, "r+b") as stream:
            stream.seek(200)
            stream.write(b"damage")
        documents.save_document(document, self.part)
        self.refused("the saved mesh state is damaged", command="export", part=self.part, format="vtu", out=self.path("mesh.vtu"))
        self.refused("the saved mesh state is damaged", command="picture", part=self.part, quality="radius_ratio", out=self.path("mesh.png"))

    def test_export_without_a_mesh_and_unknown_format(self):
        self.refused("has no mesh", command="export", part=self.part, format="vtu", out=self.path("mesh.vtu"))
        self.mesh()
        self.refused("vtu, vtk, inp", command="export", part=self.part, format="obj", out=self.path("mesh.obj"))

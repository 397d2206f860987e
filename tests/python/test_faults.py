# SPDX-License-Identifier: GPL-3.0-or-later
"""What goes wrong around a mesh: damaged states, a process killed while it saves, a full disk. Each is a clear message, and no document is lost."""
import contextlib
import io
import json
import logging
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import zipfile
from unittest import mock

import FreeCAD
import numpy as np
from freecad.featuremesh import api, documents, export, log, mesh_object, picture_process, state, disk_room, worker
from freecad.featuremesh.errors import StateError, UserError
from freecad.featuremesh.messages import english
from parts import new_document, plate_with_hole

SIZE = 4.0
EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "resources", "examples")
HERE = os.path.dirname(os.path.abspath(__file__))
SAVING_FOR_EVER = """
import os, sys
import freecad
freecad.__path__.append({package!r})
from freecad.featuremesh import documents
document = documents.open_document({path!r})
document.addObject("App::FeaturePython", "Mark")
print("saving", flush=True)
while True:
    documents.save_document(document, {path!r})
"""


class Faults(unittest.TestCase):

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.document = new_document()
        self.body = plate_with_hole(self.document)
        self.mesh = api.add_mesh(self.body, SIZE, order=1)
        self.document.recompute()
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)
        self.path = os.path.join(self.folder, "part.FCStd")

    def edit(self, x=22):
        api.set_parameters(self.document, ["HoleSketch.X=%g" % x])
        self.document.recompute()

    def reopen(self):
        documents.save_document(self.document, self.path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = documents.open_document(self.path)
        self.mesh = self.document.getObject("FeatureMesh")

    def state_bytes(self):
        with open(self.mesh.SavedState, "rb") as stream:
            return bytearray(stream.read())

    def put_state(self, content):
        with open(self.mesh.SavedState, "wb") as stream:
            stream.write(content)

    def assert_full_mesh_after_edit(self, message):
        """The next edit meshes from scratch, says why, gives no number twice; the one after that is local again."""
        numbers = set(self.mesh.FemMesh.Nodes)
        self.edit(23)
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)
        self.assertRegex(english(json.loads(self.mesh.Report)["fallback"]), message)
        self.assertEqual(self.mesh.KeptNodes, 0)
        self.assertFalse(numbers & set(self.mesh.FemMesh.Nodes))
        self.edit(24)
        self.assertIsNone(json.loads(self.mesh.Report)["fallback"])
        self.assertGreater(self.mesh.KeptNodes, 20)

    # States

    def test_no_state(self):
        self.reopen()
        os.unlink(self.mesh.SavedState)
        self.assert_full_mesh_after_edit("no mesh state")

    def test_a_cache_folder_that_was_emptied_keeps_nobody_from_saving(self):
        """FreeCAD saves nothing of a document of which an included file is gone."""
        nodes = dict(self.mesh.FemMesh.Nodes)
        for is_in_memory in (True, False):
            shutil.rmtree(self.document.TransientDir)
            self.document.saveAs(self.path)
            FreeCAD.closeDocument(self.document.Name)
            self.document = documents.open_document(self.path)
            self.mesh = self.document.getObject("FeatureMesh")
            self.assertEqual((self.mesh.Status, dict(self.mesh.FemMesh.Nodes)), (mesh_object.UP_TO_DATE, nodes))
            self.assertEqual(bool(state.checksum_of(self.mesh.SavedState)), is_in_memory)
        shutil.rmtree(self.document.TransientDir)
        self.assert_full_mesh_after_edit("no mesh state")

    def test_a_mesh_of_which_nothing_can_be_read_is_not_up_to_date(self):
        """As where the disk is full on which FreeCAD puts all that it reads."""
        documents.save_document(self.document, self.path)
        FreeCAD.closeDocument(self.document.Name)
        with zipfile.ZipFile(self.path) as whole:
            members = {name: whole.read(name) for name in whole.namelist()}
        with zipfile.ZipFile(self.path, "w") as cut:
            for name, content in members.items():
                cut.writestr(name, content[:len(content) // 2] if name.endswith((".unv", ".npz")) else content)
        self.document = documents.open_document(self.path)
        self.mesh = self.document.getObject("FeatureMesh")
        self.assertRegex(self.mesh.Status, "failed: the saved mesh state is damaged")
        with mock.patch.object(shutil, "disk_usage", lambda folder: mock.Mock(free=4096)), self.assertRaisesRegex(StateError, "there was no room in .*FreeCAD_Doc"):
            state.load(self.mesh.SavedState)
        api.update_mesh(self.mesh)
        self.assertEqual((self.mesh.Status, self.mesh.FemMesh.VolumeCount), (mesh_object.UP_TO_DATE, self.mesh.TetCount))

    def test_state_cut_short(self):
        self.reopen()
        self.put_state(self.state_bytes()[:-2000])
        self.assert_full_mesh_after_edit("damaged")

    def test_flipped_bit(self):
        self.reopen()
        content = self.state_bytes()
        content[len(content) // 2] ^= 4
        self.put_state(content)
        self.assert_full_mesh_after_edit("damaged")

    def test_newer_schema(self):
        self.reopen()
        saved = state.load(self.mesh.SavedState)
        now = state.SCHEMA
        try:
            state.SCHEMA = now + 1
            state.save(self.mesh.SavedState, saved)
        finally:
            state.SCHEMA = now
        self.assert_full_mesh_after_edit("newer FeatureMesh")

    def test_state_whose_mesh_is_of_another_shape(self):
        self.reopen()
        saved = state.load(self.mesh.SavedState)
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        other = api.add_mesh(box, SIZE, order=1, name="Other")
        api.update_mesh(other)
        saved.arrays = state.load(other.SavedState).arrays
        self.document.removeObject(other.Name)
        state.save(self.mesh.SavedState, saved)
        self.assert_full_mesh_after_edit("does not fit the part")

    def test_state_of_the_same_part_edited_outside(self):
        self.reopen()
        self.mesh.Automatic = False
        self.edit(26)
        self.reopen()   # another program changed the part and left the mesh alone
        self.assertEqual(self.mesh.Status, mesh_object.OUT_OF_DATE)
        report = api.update_mesh(self.mesh)
        self.assertIsNone(report["fallback"])
        self.assertGreater(report["kept"]["nodes_share"], 0.2)
        hole = [face for face in self.body_now().Shape.Faces if face.Surface.TypeId == "Part::GeomCylinder"][0]
        self.assertGreater(len(self.mesh.FemMesh.getNodesByFace(hole)), 8)

    def body_now(self):
        return self.document.getObject("Body")

    # Saving

    def test_killed_while_saving(self):
        documents.save_document(self.document, self.path)
        script = os.path.join(self.folder, "saving.py")
        package = os.path.join(HERE, "..", "..", "Mod", "FeatureMesh", "freecad")
        with open(script, "w", encoding="utf-8") as stream:
            stream.write(SAVING_FOR_EVER.format(package=package, path=self.path))
        marks = set()
        for _ in range(3):
            program = subprocess.Popen([shutil.which("freecadcmd") or shutil.which("FreeCADCmd"), script], stdin=subprocess.DEVNULL,
                                       stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
            while b"saving" not in program.stdout.readline():
                self.assertIsNone(program.poll())
            time.sleep(random.uniform(0.05, 0.5))
            program.send_signal(signal.SIGKILL)
            program.wait()
            program.stdout.close()
            opened = documents.open_document(self.path)   # reads every member back
            marks.add(opened.getObject("Mark") is not None)
            self.assertEqual(opened.getObject("FeatureMesh").TetCount, self.mesh.TetCount)
            FreeCAD.closeDocument(opened.Name)
        self.assertLessEqual(marks, {True, False})
        documents.save_document(self.document, self.path)
        left = set(os.listdir(self.folder)) - {"__pycache__"}
        self.assertEqual(left, {"part.FCStd", "saving.py"})   # what the killed ones left is swept up

    def test_full_disk_while_freecad_saves_a_document(self):
        """It takes what is cut off for saved."""
        told = []
        self.mesh.SavedForFreeCAD = "Never"
        with mock.patch.object(disk_room, "tell", lambda document, error: told.append(str(error))):
            self.document.saveAs(self.path)
            self.assertEqual(told, [])
            self.full_disk(os.path.getsize(self.path) // 2)
            self.document.save()
            self.doCleanups_of_limit()
        self.assertEqual(len(told), 1)
        self.assertRegex(told[0], "part.FCStd was not saved as a whole; is the disk full")

    def test_a_link_stays_one_and_a_private_document_private(self):
        documents.save_document(self.document, self.path)
        os.chmod(self.path, 0o600)
        link = os.path.join(self.folder, "link.FCStd")
        os.symlink("part.FCStd", link)
        self.edit()
        documents.save_document(self.document, link)
        self.assertTrue(os.path.islink(link))
        self.assertEqual(os.stat(self.path).st_mode & 0o777, 0o600)
        FreeCAD.closeDocument(self.document.Name)
        self.document = documents.open_document(self.path)
        self.assertEqual(self.document.getObject("HoleSketch").getDatum("X").Value, 22)

    def full_disk(self, size):
        """From now on no file gets larger than `size` bytes, as on a disk that is full."""
        soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        self.addCleanup(resource.setrlimit, resource.RLIMIT_FSIZE, (soft, hard))
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, hard))

    def test_full_disk_while_a_document_is_saved(self):
        documents.save_document(self.document, self.path)
        with open(self.path, "rb") as stream:
            before = stream.read()
        for share in (0.02, 0.5, 0.95):
            with self.subTest(share=share):
                self.full_disk(int(share * len(before)))
                with self.assertRaisesRegex(UserError, "cannot write .* is it full"):
                    documents.save_document(self.document, self.path)
                self.doCleanups_of_limit()
                with open(self.path, "rb") as stream:
                    self.assertEqual(stream.read(), before)
                self.assertEqual(os.listdir(self.folder), ["part.FCStd"])

    def doCleanups_of_limit(self):
        resource.setrlimit(resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY, resource.getrlimit(resource.RLIMIT_FSIZE)[1]))

    def test_no_room_for_temporary_files_while_a_document_is_saved_or_opened(self):
        """FreeCAD writes and reads a mesh by way of a file there, which is larger than the whole document."""
        documents.save_document(self.document, self.path)
        whole, again = {name: len(values) for name, values in self.mesh.Proxy.arrays(self.mesh).items()}, os.path.join(self.folder, "again.FCStd")
        with zipfile.ZipFile(self.path) as archive:
            size = archive.getinfo("FemMesh.unv").file_size
        self.assertGreater(size, 1.2 * os.path.getsize(self.path))
        self.full_disk(size - 5000)
        with self.assertRaisesRegex(UserError, "FreeCAD cannot write a mesh to the folder for temporary files"):
            documents.save_document(self.document, again)
        told = []
        for free in (size // 2, size):   # what the window says before FreeCAD's "Output file not good"
            with mock.patch.object(shutil, "disk_usage", lambda folder, free=free: mock.Mock(free=free)), \
                    mock.patch.object(FreeCAD, "Console", mock.Mock(wraps=FreeCAD.Console, PrintError=told.append)):
                disk_room.tell_before_saving(self.document)
        self.assertEqual(len(told), 1)
        self.assertRegex(told[0], "^FeatureMesh cannot be saved: that takes .* MB in the folder for temporary files")
        FreeCAD.closeDocument(self.document.Name)
        self.document = documents.open_document(self.path)
        self.doCleanups_of_limit()
        mesh = self.document.getObject("FeatureMesh")
        self.assertEqual((mesh.FemMesh.NodeCount, mesh.FemMesh.VolumeCount), (whole["node_numbers"], whole["tets"]))
        with mock.patch.object(shutil, "disk_usage", lambda folder: mock.Mock(free=size - 1)), self.assertRaisesRegex(UserError, "cannot read the meshes of"):
            documents.open_document(self.path)
        with mock.patch.object(os, "access", lambda *_: False), self.assertRaisesRegex(UserError, "where 0 MB can be written"):
            documents.open_document(self.path)
        self.assertEqual(os.listdir(self.folder), ["part.FCStd"])

    def test_full_disk_while_a_mesh_is_exported(self):
        """FreeCAD's writers for UNV, MED and Z88 do not look whether all was written."""
        for name in export.FORMATS:
            with self.subTest(format=name):
                path = os.path.join(self.folder, "mesh." + name)
                api.export_mesh(self.mesh, path)
                with open(path, "rb") as stream:
                    before = stream.read()
                for share in (0.3, 0.9):
                    self.full_disk(int(share * len(before)))
                    with self.assertRaisesRegex(UserError, "cannot write"):
                        api.export_mesh(self.mesh, path)
                    self.doCleanups_of_limit()
                    with open(path, "rb") as stream:
                        self.assertEqual(stream.read(), before)
                os.unlink(path)
        self.assertEqual(os.listdir(self.folder), [])

    def test_a_line_of_the_log_for_which_there_is_no_room_is_lost_in_silence(self):
        log.write("the first line opens it")
        handler = logging.getLogger("featuremesh").handlers[0]
        with mock.patch.object(handler, "flush", side_effect=OSError(28, "No space left on device")), contextlib.redirect_stderr(io.StringIO()) as shown:
            log.write("another line")
        self.assertEqual(shown.getvalue(), "")

    def test_a_picture_that_cannot_be_drawn_says_why(self):
        """Of interpreters that fail the one that could draw tells the reason, not one without what drawing takes."""
        said_by = {"/one": "OSError: [Errno 28] No space left on device", "/other": "ModuleNotFoundError: No module named 'numpy'"}
        for interpreters in (list(said_by), list(reversed(said_by))):
            with mock.patch.object(worker, "interpreters", lambda interpreters=interpreters: interpreters), \
                    mock.patch.object(picture_process, "_run", lambda python, *rest: mock.Mock(returncode=1, stderr="Traceback\n" + said_by[python])), \
                    self.assertRaisesRegex(UserError, "No space left on device"):
                api.draw_quality(self.mesh, os.path.join(self.folder, "mesh.png"))
        with mock.patch.object(worker, "interpreters", list), self.assertRaisesRegex(UserError, "no Python interpreter was found"):
            api.draw_quality(self.mesh, os.path.join(self.folder, "mesh.png"))

    def test_full_disk_while_a_mesh_is_stored(self):
        before = {number: tuple(point) for number, point in self.mesh.FemMesh.Nodes.items()}
        checksum = state.checksum_of(self.mesh.SavedState)
        self.mesh.Automatic = False
        self.edit()
        self.full_disk(os.path.getsize(self.mesh.SavedState) // 2)
        with self.assertRaises((UserError, OSError, RuntimeError)) as caught:
            api.update_mesh(self.mesh)
        self.doCleanups_of_limit()
        self.assertTrue(self.mesh.Status.startswith("failed: "), self.mesh.Status)
        self.assertIn("disk", str(caught.exception))
        self.assertEqual({number: tuple(point) for number, point in self.mesh.FemMesh.Nodes.items()}, before)
        self.assertEqual(state.checksum_of(self.mesh.SavedState), checksum)
        report = api.update_mesh(self.mesh)
        self.assertIsNone(report["fallback"])
        self.assertGreater(report["kept"]["nodes_share"], 0.2)

    # A history

    def test_edit_and_set_back_has_the_old_kept_part_and_the_same_edit_the_same_bytes(self):
        self.mesh.Automatic = False
        first = self.arrays()
        self.edit(23)
        api.update_mesh(self.mesh)
        middle = self.arrays()
        self.edit(20)
        api.update_mesh(self.mesh)
        last = self.arrays()
        stayed = np.intersect1d(first["node_numbers"], middle["node_numbers"])
        again = np.intersect1d(stayed, last["node_numbers"])
        self.assertGreater(len(again), 0.2 * len(stayed))
        for arrays in (middle, last):
            self.assertTrue(np.array_equal(self.points(first, again), self.points(arrays, again)))
        self.reopen_with(first)
        self.edit(23)
        api.update_mesh(self.mesh)
        for name, values in self.arrays().items():
            self.assertEqual(values.tobytes(), middle[name].tobytes(), name)

    def reopen_with(self, arrays):
        """The document as it was with this mesh."""
        self.edit(20)
        saved = state.load(self.mesh.SavedState)
        saved.arrays = arrays
        state.save(self.mesh.SavedState, saved)

    def arrays(self):
        return {name: np.array(values) for name, values in self.mesh.Proxy.arrays(self.mesh).items()}

    def points(self, arrays, numbers):
        order = np.argsort(arrays["node_numbers"])
        return arrays["points"][order[np.searchsorted(arrays["node_numbers"], numbers, sorter=order)]]

    def test_numbers_stay_below_four_times_the_count_over_twenty_edits(self):
        """A hole that moves on and on, with other dimensions changed in between, and nobody asks for a renumbering."""
        path = os.path.join(self.folder, "bracket.FCStd")
        shutil.copyfile(os.path.join(EXAMPLES, "bracket.FCStd"), path)
        document = documents.open_document(path)
        mesh = api.add_mesh(document.getObject("Body"), 4.0, order=1)
        mesh.Automatic = False
        api.update_mesh(mesh)
        for edit in range(20):
            parameter = {6: "HoleSketch.Hole1Radius=%g" % (4.5 + 0.02 * edit), 3: "PlateSketch.PlateLength=%g" % (120 + 0.5 * edit)}.get(
                edit % 7, "HoleSketch.Hole6X=%g" % (96 + edit % 9))
            api.set_parameters(document, [parameter])
            api.recompute(document)
            report = api.update_mesh(mesh)
            self.assertIsNone(report["fallback"])
        for numbers, count in ((mesh.FemMesh.Nodes, mesh.NodeCount), (mesh.FemMesh.Volumes, mesh.TetCount)):
            self.assertLess(max(numbers), 4 * count)
            self.assertGreater(max(numbers), count)

    def test_renumbering_is_asked_for(self):
        for x in range(20):
            self.edit(21 + x % 2)
        self.assertGreater(max(self.mesh.FemMesh.Nodes), self.mesh.NodeCount)
        before = self.arrays()
        largest = api.renumber_mesh(self.mesh)
        self.assertEqual(largest[0], before["node_numbers"].max() if before["counters"][2] == before["node_numbers"].max() + 1
                         else before["counters"][2] - 1)
        after = self.arrays()
        self.assertEqual(after["node_numbers"].tolist(), list(range(1, self.mesh.NodeCount + 1)))
        self.assertTrue(np.array_equal(before["points"], after["points"]))
        self.assertTrue(np.array_equal(before["tets"], after["tets"]))
        self.assertEqual(set(self.mesh.FemMesh.Nodes), set(range(1, self.mesh.NodeCount + 1)))
        self.edit(24)
        self.assertIsNone(json.loads(self.mesh.Report)["fallback"])
        self.assertGreater(self.mesh.KeptNodes, 20)


if __name__ == "__main__":
    sys.exit("run by run_tests.py")

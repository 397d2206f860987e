# SPDX-License-Identifier: GPL-3.0-or-later
"""The engine in a process of its own: the same bytes, and a death in it costs nothing but the work it was at."""
import math
import os
import signal
import tempfile
import threading
import time
import unittest
from unittest import mock

import FreeCAD
import numpy as np
from freecad.featuremesh import api, engine, mesh_object, reading, state, waiting, worker
from freecad.featuremesh.messages import english
from parts import groups_of, new_document, plate_with_hole

SIZE = 3.0
OPTIONS = {"size": SIZE, "threads": 1}
DYING_WORKER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "dying_worker.py")


def points_of(mesh):
    return {number: tuple(point) for number, point in mesh.FemMesh.Nodes.items()}


ALWAYS_IN_WORKER = engine.chosen().brings_its_libraries()


@unittest.skipIf(ALWAYS_IN_WORKER, "this engine never runs in FreeCAD's process")
class Here(unittest.TestCase):

    def test_wanted_sizes(self):
        body = plate_with_hole(new_document())
        mesh, _ = engine.load().mesh_part(reading.read_document(body), {**OPTIONS, "elements_per_circle": 24})
        points = mesh.arrays()["points"]
        sizes = mesh.wanted_sizes(points)
        self.assertEqual(sizes.shape, (len(points),))
        self.assertLessEqual(sizes.max(), SIZE)
        self.assertLess(sizes.min(), 0.9 * SIZE)  # at the hole, where curvature asks for less
        with self.assertRaises(engine.load().Error):
            mesh.wanted_sizes(points[:, :2])

    def test_python_goes_on_while_sizes_are_asked(self):
        mesh, _ = engine.load().mesh_part(reading.read_document(plate_with_hole(new_document())), {**OPTIONS, "elements_per_circle": 24})
        many = np.tile(mesh.arrays()["points"], (2_000_000 // len(mesh.arrays()["points"]), 1))
        done, rounds = threading.Event(), []

        def go_on():
            while not done.wait(0.001):
                rounds.append(time.monotonic())
        other = threading.Thread(target=go_on)
        other.start()
        try:
            begin = time.monotonic()
            mesh.wanted_sizes(many)
            end = time.monotonic()
        finally:
            done.set()
            other.join()
        self.assertGreater(sum(begin < moment < end for moment in rounds), 10)


def going_on(step, share):
    return True


class InWorker(unittest.TestCase):
    """With a worker that gives itself a signal where it is asked to, see dying_worker.py."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.order = os.path.join(folder.name, "order")
        for patch in (mock.patch.object(worker, "_PROGRAM", DYING_WORKER),
                      mock.patch.dict(os.environ, FEATUREMESH_WORKER=worker._PROGRAM, FEATUREMESH_WORKERS_ORDER=self.order)):
            patch.start()
            self.addCleanup(patch.stop)
        engine.run_in_worker()
        self.addCleanup(engine.run_here)
        self.document = new_document()
        self.body = plate_with_hole(self.document)

    def give(self, sent, place):
        """Lets the worker give itself that signal at that step, or before it runs that function."""
        with open(self.order, "w", encoding="utf-8") as stream:
            stream.write("%d %s" % (sent, place))

    def meshed(self):
        mesh = api.add_mesh(self.body, SIZE, order=1)
        self.document.recompute()
        self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
        return mesh

    def edit(self, x=22):
        self.document.getObject("HoleSketch").setDatum("X", FreeCAD.Units.Quantity("%g mm" % x))
        self.document.recompute()


class Retired(unittest.TestCase):

    def test_a_process_that_is_retired_while_a_call_ends(self):
        """Just before the call gives back the lock, by another thread, which is not to wait for it."""
        remote = worker.WorkerEngine()
        lane = remote._lanes["looks"]
        lane.process, lock = mock.Mock(), lane.lock

        def release():
            thread = threading.Thread(target=remote.retire)
            thread.start()
            thread.join()
            lane.lock = lock
            lock.release()
        lane.lock = mock.Mock(wraps=lock, release=release)
        process = lane.process
        with mock.patch.object(remote, "_ask", return_value=7):
            self.assertEqual(remote.estimate_tets(), 7)
        process.kill.assert_called_once_with()
        self.assertIsNone(lane.process)


class AnotherPlace(InWorker):

    def test_ctrl_c_in_the_console_of_freecad_is_not_for_the_worker(self):
        self.addCleanup(signal.signal, signal.SIGINT, signal.signal(signal.SIGINT, signal.default_int_handler))   # as in a window, also where tests ignore it
        self.meshed()
        process = engine.load().process_id
        self.give(signal.SIGINT, "update_part")
        self.edit()
        self.assertFalse(os.path.exists(self.order))
        self.assertEqual((self.document.FeatureMesh.Status, engine.load().process_id), (mesh_object.UP_TO_DATE, process))

    def test_what_is_being_made_is_done_where_it_was_begun(self):
        """The preference is changed meanwhile."""
        raw, steps = reading.read_document(self.body), []

        def change(step, share):
            if not steps:
                engine.run_here()
            steps.append(step)
            return True
        mesher = engine.load()
        done = []
        thread = threading.Thread(target=lambda: done.append(mesher.mesh_part(raw, OPTIONS, change)))
        thread.start()
        process = mesher.process_id
        thread.join()
        self.assertGreater(len(done[0][0].arrays()["tets"]), 100)
        self.assertTrue(steps and process is not None and mesher.process_id is None)


class SameEitherWay(InWorker):

    def saved(self, mesh):
        """The bytes of the saved mesh. FreeCAD 0.20 numbers the lines of sketches anew in each document, so the records differ."""
        found = state.load(mesh.SavedState)
        return found.raw["shapes"], {name: values.tobytes() for name, values in found.arrays.items()}

    def states(self):
        """The saved states of a mesh and of an update, and what FreeCAD got."""
        mesh = self.meshed()
        found = [self.saved(mesh)]
        self.edit()
        found += [self.saved(mesh), points_of(mesh), mesh.KeptNodes,
                  groups_of(mesh)]
        return found

    def test_same_bytes(self):
        self.assertTrue(engine.runs_in_worker())
        there = self.states()
        self.assertIsNotNone(engine.load().process_id)
        engine.run_here()
        self.document = new_document()
        self.body = plate_with_hole(self.document)
        self.assertEqual(self.states(), there)

    def test_whatever_can_be_asked_of_a_mesh(self):
        raw = reading.read_document(self.body)
        mesh, _ = engine.load().mesh_part(options={**OPTIONS, "elements_per_circle": 24}, raw=raw)
        engine.load().stop()   # the next process makes it anew from what it was made of
        points = mesh.arrays()["points"]
        there = mesh.wanted_sizes(points)
        with self.assertRaises(worker.Error):
            mesh.wanted_sizes(points[:, :2])
        engine.run_here()
        here, _ = engine.load().mesh_part(raw, {**OPTIONS, "elements_per_circle": 24})
        self.assertEqual(there.tobytes(), here.wanted_sizes(points).tobytes())
        for name in (name for name in dir(here) if not name.startswith("_")):
            self.assertTrue(hasattr(mesh, name), name)

    def test_changing_places_between_mesh_and_update(self):
        mesh = self.meshed()
        engine.run_here()
        self.edit()
        self.assertGreater(mesh.KeptNodes, 30)
        engine.run_in_worker()
        self.edit(24)
        self.assertGreater(mesh.KeptNodes, 30)
        self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)

    def test_looks(self):
        raw = reading.read_document(self.body)
        there = engine.load()
        tree, count = there.read_tree(raw), there.estimate_tets(raw, OPTIONS)
        engine.run_here()
        self.assertEqual(engine.load().read_tree(raw), tree)
        self.assertEqual(engine.load().estimate_tets(raw, OPTIONS), count)


class WhileACallWaits(InWorker):
    """The window draws meanwhile, and what it draws may be asked of the same process."""

    def test_another_one_gets_its_own_answer(self):
        raw = reading.read_document(self.body)
        mesh, _ = engine.load().mesh_part(raw, OPTIONS)
        points, found = mesh.arrays()["points"], []

        def look():
            if not found:
                found.append(None)
                found[0] = mesh.wanted_sizes(points)
        with mock.patch.object(waiting, "repaint", look):
            _, report = engine.load().mesh_part(raw, {**OPTIONS, "size": 1.0})
        self.assertEqual((report["size"], found[0].shape), (1.0, (len(points),)))

    def test_the_process_is_stopped(self):
        raw, mesher = reading.read_document(self.body), engine.load()
        with self.assertRaises(worker.WorkerDied):
            mesher.mesh_part(raw, OPTIONS, progress=lambda step, share: mesher.stop() or True)


class Deaths(InWorker):

    def test_a_crash_in_a_first_mesh(self):
        raw = reading.read_document(self.body)
        self.give(signal.SIGSEGV, "surface")
        with self.assertRaisesRegex(worker.WorkerDied, "SIGSEGV.*meshing Body.*surface"):
            engine.load().mesh_part(raw, OPTIONS, progress=going_on)
        mesh, _ = engine.load().mesh_part(raw, OPTIONS)
        self.assertGreater(len(mesh.arrays()["tets"]), 1000)

    def test_a_crash_in_an_update_leaves_the_document_and_the_next_one_is_local(self):
        mesh = self.meshed()
        mesh.Automatic = False
        before, saved = points_of(mesh), state.checksum_of(mesh.SavedState)
        self.edit()
        self.give(signal.SIGSEGV, "surface")
        with self.assertRaisesRegex(worker.WorkerDied, "updating the mesh of Body"):
            api.update_mesh(mesh, progress=going_on)
        self.assertEqual(points_of(mesh), before)
        self.assertEqual(state.checksum_of(mesh.SavedState), saved)
        self.assertIn("crashed (SIGSEGV)", mesh.Status)
        report = api.update_mesh(mesh, progress=going_on)
        self.assertIsNone(report["fallback"])
        self.assertGreater(mesh.KeptNodes, 30)
        self.assertNotEqual(points_of(mesh), before)

    def test_a_crash_while_the_saved_mesh_is_read_gives_a_full_mesh_and_says_so(self):
        mesh = self.meshed()
        mesh.Automatic = False
        mesh.Proxy.onDocumentRestored(mesh)   # as after opening the document: nothing is in memory
        self.give(signal.SIGSEGV, "restore_part")
        report = api.update_mesh(mesh)
        self.assertIn("reading the saved mesh of Body", english(report["fallback"]))
        self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)

    def test_killed_between_two_calls(self):
        mesh = self.meshed()
        process_id = engine.load().process_id
        os.kill(process_id, signal.SIGKILL)
        os.waitid(os.P_PID, process_id, os.WEXITED | os.WNOWAIT)
        self.edit()
        self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
        self.assertGreater(mesh.KeptNodes, 30)

    def test_what_it_was_at_is_said_in_the_users_language(self):
        german = {"working on %s": "Arbeiten an %s", "a mesh": "einem Netz"}
        mesh, _ = engine.load().mesh_part(reading.read_document(self.body), OPTIONS)
        self.give(signal.SIGSEGV, "PartMesh.wanted_sizes")
        with mock.patch.object(worker, "translate", lambda _, text: german.get(text, text)), self.assertRaisesRegex(worker.WorkerDied, "Arbeiten an einem Netz"):
            mesh.wanted_sizes(mesh.arrays()["points"])

    def test_killed_by_the_system(self):
        self.give(signal.SIGKILL, "surface")
        with self.assertRaisesRegex(worker.WorkerDied, "memory"):
            engine.load().mesh_part(reading.read_document(self.body), OPTIONS, progress=going_on)


class Cancels(InWorker):

    def test_cancel_of_a_worker_that_does_not_answer(self):
        mesh = self.meshed()
        mesh.Automatic = False
        before = points_of(mesh)
        self.edit()
        self.give(signal.SIGSTOP, "surface")
        with self.assertRaises(engine.load().Cancelled):
            api.update_mesh(mesh, progress=lambda step, share: step != "surface")
        self.assertEqual(points_of(mesh), before)
        api.update_mesh(mesh)
        self.assertGreater(mesh.KeptNodes, 30)

    def test_cancel_of_one_that_does(self):
        first = engine.load().process_id
        with self.assertRaises(engine.load().Cancelled):
            engine.load().mesh_part(reading.read_document(self.body), OPTIONS, progress=lambda step, share: False)
        self.assertEqual(engine.load().process_id, first)

    def test_cancel_at_the_last_step(self):
        steps = []
        with self.assertRaises(engine.load().Cancelled):   # whether it hears of it or is done before that
            engine.load().mesh_part(reading.read_document(self.body), OPTIONS, progress=lambda step, share: steps.append(step) or step != "validate")
        self.assertIn("validate", steps)


    def test_what_the_progress_function_throws_ends_the_call_and_leaves_no_answer_for_the_next_one(self):
        def throw(step, share):
            if step == "surface":
                raise ReferenceError("the object is gone")
            return True
        raw = reading.read_document(self.body)
        with self.assertRaisesRegex(ReferenceError, "the object is gone"):
            engine.load().mesh_part(raw, OPTIONS, progress=throw)
        _, report = engine.load().mesh_part(raw, {**OPTIONS, "size": 5.0})
        self.assertEqual(report["size"], 5.0)


class Errors(InWorker):

    def test_what_the_engine_throws_arrives(self):
        raw = reading.read_document(self.body)
        with self.assertRaisesRegex(engine.load().InputError, "nonsense"):
            engine.load().mesh_part(raw, {"size": SIZE, "nonsense": 1})
        for option in ("keep_margin", "target_dihedral_deg", "most_tets"):
            for value in (math.nan, math.inf, -1.0):
                with self.assertRaisesRegex(engine.load().InputError, option):
                    engine.load().mesh_part(raw, {"size": SIZE, option: value})
        with self.assertRaises(engine.load().StateError):
            engine.load().restore_part(raw, OPTIONS, {})
        with self.assertRaises(TypeError):
            engine.load().mesh_part(raw)

    @unittest.skipIf(ALWAYS_IN_WORKER, "this engine never runs in FreeCAD's process")
    def test_without_an_interpreter_it_runs_here(self):
        usual = worker.interpreters
        self.addCleanup(setattr, worker, "interpreters", usual)
        worker.interpreters = lambda: ["/bin/false"]
        self.assertEqual(engine.load().__name__, "featuremesh_engine")
        self.assertFalse(engine.runs_in_worker())

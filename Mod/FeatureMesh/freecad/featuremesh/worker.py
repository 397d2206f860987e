# SPDX-License-Identifier: GPL-3.0-or-later
"""The engine in a process of its own, so that a crash of the geometry kernel is a message and not a lost session.

`WorkerEngine` has the functions of the module `featuremesh_engine` with the same results, bit for bit. The process is started when
it is first needed, and anew after it died; what it knew is sent to it again from the arrays kept here.
"""

import builtins
import io
import os
import pickle
import queue
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import weakref
from collections import deque

import FreeCAD

from . import log
from .errors import Said
from .messages import of_error, said, several
from .waiting import let_the_window_live
from .worker_main import read_message, write_message

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

_PROGRAM = os.path.join(os.path.dirname(os.path.abspath(__file__)), "worker_main.py")
_POLL, GRACE, _START_SECONDS = 0.03, 0.3, 60
_GRACE_OF_SOLVING = 3   # nobody waits for a cancelled solution, and what its process knows makes the next one fast
_KILLED = -getattr(signal, "SIGKILL", 9)
_WINDOWS_EXCEPTION = 0xC0000000   # exit codes from here on are crashes there
_EXECUTABLE = ".exe" if os.name == "nt" else ""
# FreeCAD 1.1 starts Python without its signal handlers: to write to a process that has died must be an error, not FreeCAD's end.
if hasattr(signal, "SIGPIPE") and threading.current_thread() is threading.main_thread() \
        and signal.getsignal(signal.SIGPIPE) == signal.SIG_DFL:
    signal.signal(signal.SIGPIPE, signal.SIG_IGN)


class Error(RuntimeError):
    """Base of all errors of the engine, as featuremesh_engine.Error; `message` says it with parameters (messages.py), where it has any."""

    message = None


class InputError(Error):
    """The user's fault."""


class KernelError(Error):
    """The geometry kernel could not."""


class MeshError(Error):
    """No valid mesh."""


class StateError(Error):
    """A saved state is damaged or foreign."""


class Cancelled(Error):
    """The user cancelled."""


class WorkerDied(Error):
    """The process ended in the middle of something; the next call starts another."""


class CannotStart(Said, RuntimeError):
    """No process with the engine can be started here."""


_ERRORS = {cls.__name__: cls for cls in (Error, InputError, KernelError, MeshError, StateError, Cancelled)}
_DOING = {
    "mesh_part": QT_TRANSLATE_NOOP("FeatureMesh", "meshing %s"),
    "update_part": QT_TRANSLATE_NOOP("FeatureMesh", "updating the mesh of %s"),
    "adopt_part": QT_TRANSLATE_NOOP("FeatureMesh", "adopting a mesh of %s"),
    "restore_part": QT_TRANSLATE_NOOP("FeatureMesh", "reading the saved mesh of %s"),
    "compare": QT_TRANSLATE_NOOP("FeatureMesh", "comparing two states of %s"),
    "read_tree": QT_TRANSLATE_NOOP("FeatureMesh", "reading the features of %s"),
    "estimate_tets": QT_TRANSLATE_NOOP("FeatureMesh", "estimating the mesh of %s"),
    "solve_statics": QT_TRANSLATE_NOOP("FeatureMesh", "solving the statics of %s"),
    "": QT_TRANSLATE_NOOP("FeatureMesh", "working on %s"),
}
# The engine's names of the arguments that may be given without one.
_PARAMETERS = {
    "mesh_part": ("raw", "options"),
    "update_part": ("old", "raw", "options"),
    "adopt_part": ("raw", "options", "arrays"),
    "restore_part": ("raw", "options", "arrays"),
    "compare": ("old", "new"),
    "read_tree": ("raw",),
    "estimate_tets": ("raw", "options"),
    "labels_of_owners": ("raw", "options", "names"),
}


class WorkerMesh:
    """A mesh whose engine object lives in a worker; what can be asked of it is here, or asked there."""

    def __init__(self, contents, engine):
        self._contents, self._engine = contents, engine
        self._process = self._key = None   # where the engine's object is
        self._recipe = None                # (raw, options) it was made from, to make it anew in another process
        self.order, self.corner_count = contents["order"], contents["corner_count"]

    def arrays(self):
        return dict(self._contents["arrays"])

    def node_origin(self):
        return self._contents["node_origin"]

    def tet_origin(self):
        return self._contents["tet_origin"]

    def active_points(self):
        return self._contents["active_points"]

    def owners_of_faces(self):
        return self._engine.call("PartMesh.owners_of_faces", self)

    def labels_of_owners(self, names):
        return self._engine.call("PartMesh.labels_of_owners", self, names)

    def owners_of_tets(self):
        return self._engine.call("PartMesh.owners_of_tets", self)

    def wanted_sizes(self, points):
        return self._engine.call("PartMesh.wanted_sizes", self, points)


class WorkerEngine:
    """The engine's functions. Those that mesh run in one process, quick looks in another, solving in a third, so none waits for another."""

    PartMesh = WorkerMesh
    Error, InputError, KernelError = Error, InputError, KernelError
    MeshError, StateError, Cancelled = MeshError, StateError, Cancelled
    _LOOKS = ("estimate_tets", "compare", "read_tree", "trace_sub_elements")

    def __init__(self, folder=None):
        self.folder = folder   # of the compiled engine; None: on the Python path
        self._lanes = {"meshing": _Lane(self), "looks": _Lane(self), "statics": _Lane(self, _GRACE_OF_SOLVING)}

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        return lambda *args, **kwargs: self.call(name, *args, **kwargs)

    def start(self):
        """Starts the process that meshes, if it does not run; gives what its engine says about itself. Throws CannotStart."""
        lane = self._lanes["meshing"]
        process = lane.process
        if process is not None and process.is_alive():
            return process.about   # without waiting for what it does
        with lane.lock:
            return lane.running(self.folder).about

    def stop(self):
        """Ends the processes; a later call starts them again."""
        for lane in self._lanes.values():
            lane.end()

    def retire(self):
        """Ends the processes, those that are at work when they are done; a later call starts them again."""
        for lane in self._lanes.values():
            lane.retire()

    @property
    def process_id(self):
        """Of the process that meshes; None when it does not run."""
        process = self._lanes["meshing"].process
        return process.program.pid if process is not None and process.is_alive() else None

    def call(self, name, *args, progress=None, **kwargs):
        """Calls a function of the engine in a worker and waits for its answer. `progress` may be the last of `args`, too."""
        if args and callable(args[-1]):
            *args, progress = args
        lane = self._lanes["statics" if "statics" in name else "looks" if name in self._LOOKS else "meshing"]
        while not lane.lock.acquire(timeout=_POLL):
            if progress is not None and not progress("waiting", 0.0):
                raise Cancelled("cancelled")
            let_the_window_live()
        lane.calls += 1
        try:
            for mesh in (value for value in args if isinstance(value, WorkerMesh)):
                self._bring(mesh, lane, progress)
            if progress is not None:
                kwargs["progress"] = True
            return self._ask(lane, name, args, kwargs, progress)
        finally:
            lane.calls -= 1
            lane.lock.release()
            lane.end_if_retired()

    def _bring(self, mesh, lane, progress):
        """Makes sure that the lane's process knows the mesh, which another one may have taken along into death."""
        process = lane.running(self.folder)
        if mesh._process is process:
            return
        raw, options = mesh._recipe
        twin = self._ask(lane, "restore_part", (raw, options, mesh.arrays()), {"progress": True} if progress is not None else {}, progress)
        mesh._process, mesh._key = twin._process, twin._key
        twin._finalizer.detach()
        weakref.finalize(mesh, process.forget, mesh._key)

    def _ask(self, lane, name, args, kwargs, progress):
        process = lane.running(self.folder)
        given = {**dict(zip(_PARAMETERS.get(name, ()), args)), **kwargs}
        raw = given.get("raw") or given.get("new")
        what = translate("FeatureMesh", _DOING.get(name, _DOING[""])) % (raw["final_object"] if raw else translate("FeatureMesh", "a mesh"))
        answer, made = process.ask((name, args, kwargs), what, progress)
        for mesh in made:
            mesh._recipe = given["raw"], given["options"]
        return answer


class _Lane:
    """A process that is there whenever it is needed, for one caller at a time."""

    def __init__(self, engine, grace=None):
        self.lock = threading.RLock()
        self.engine = engine
        self.grace = grace   # seconds that cancelled work has to end by itself; None: GRACE
        self.process = None
        self.calls = 0   # that wait for an answer, of the one that has the lock
        self.is_to_end = False   # when these have theirs

    def running(self, folder):
        if self.process is None or not self.process.is_alive():
            self.process = start_process(folder)
            self.process.engine, self.process.grace = self.engine, self.grace
        return self.process

    def end(self):
        self.is_to_end = False
        if self.process is not None:
            self.process.kill()
            self.process = None

    def retire(self):
        self.is_to_end = True
        self.end_if_retired()

    def end_if_retired(self):
        """To be called without the lock: whoever has it does so after giving it back."""
        if self.is_to_end and self.lock.acquire(blocking=False):
            if not self.calls:
                self.end()
            self.lock.release()


def start_process(folder):
    """A worker process with the first interpreter that can load the engine. Throws CannotStart."""
    reasons = []
    for python in interpreters():
        try:
            return _Process(python, folder)
        except CannotStart as error:
            reasons.append(said("{python:text}: {why:messages}", python=python, why=of_error(error)))
    raise CannotStart(several(reasons) or said("no Python interpreter was found"))


def interpreters():
    """Programs that may be the interpreter inside FreeCAD, the likeliest first."""
    version = "python%d.%d" % sys.version_info[:2]
    beside = os.path.dirname(os.path.realpath(sys.executable or ""))
    folders = [os.path.join(sys.exec_prefix, "bin"), beside, sys.exec_prefix]
    places = [os.environ.get("FEATUREMESH_PYTHON"), *(os.path.join(folder, name + _EXECUTABLE) for folder in folders for name in (version, "python")),
              "/usr/bin/" + version, "/usr/bin/python3", shutil.which(version)]
    return [place for place in dict.fromkeys(places) if place and os.path.isfile(place) and os.access(place, os.X_OK)]


class _Call:
    """What a worker process was asked."""

    progress = "", 0.0   # the step that it is at, and how far
    answer = None        # the message, and the meshes that are new in it


class _Process:
    """One worker process and the line to it."""

    def __init__(self, python, folder):
        self._last_words = -1
        try:
            self._last_words, self._last_words_path = tempfile.mkstemp(prefix="featuremesh-")
            self.program = subprocess.Popen(
                [python, _PROGRAM, self._last_words_path] + ([folder] if folder else []), bufsize=0, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0))
        except OSError as error:
            self._close_last_words()
            raise CannotStart(of_error(error)) from error
        self._messages = queue.SimpleQueue()
        self.engine = None   # whose meshes it makes
        self.grace = None
        self._forgotten = []
        self._waiting = deque()   # calls without an answer, in the order of those: while one waits, what the window does may ask, too
        self.about = {}   # what the engine says about itself
        threading.Thread(target=self._listen, args=(self.program.stdout,), daemon=True).start()
        self._await_ready()

    def _listen(self, stream):
        """Puts what arrives into the queue; at the end of all, None."""
        try:
            while True:
                self._messages.put(read_message(stream))
        except (EOFError, OSError, ValueError):
            self._messages.put(None)

    def _next_message(self, seconds):
        """The next message, or None when there is none in that time. Throws EOFError when the process is gone."""
        try:
            data = self._messages.get(timeout=seconds)
        except queue.Empty:
            return None
        if data is None:
            self._messages.put(None)
            raise EOFError
        return data

    def _await_ready(self):
        try:
            data = self._next_message(_START_SECONDS)
            if data is None:
                reason = said("it does not answer")
            else:
                kind, words = pickle.loads(data)
                if kind == "ready":
                    self.about = words
                    self._unlink_last_words()
                    return
                reason = words
        except (EOFError, OSError, pickle.UnpicklingError):
            reason = said("it ended at once")
        self.kill()
        raise CannotStart(reason)

    def is_alive(self):
        return self.program.poll() is None

    def kill(self):
        """Ends the process whatever it does."""
        if self.program.poll() is None:
            self.program.kill()
        self.program.wait()
        self.program.stdin.close()
        self._close_last_words()

    def forget(self, key):
        """Lets the worker drop a mesh, at the next call."""
        self._forgotten.append(key)

    def ask(self, call, what, progress):
        """(answer, the meshes that are new in it). Throws what the engine or `progress` threw, Cancelled, and WorkerDied."""
        mine = _Call()
        try:
            return self._ask(mine, call, what, progress)
        finally:
            if mine.answer is None:
                self.kill()   # what it is still at would be taken for the answer to the next call

    def _ask(self, mine, call, what, progress):
        cancelled_at = None
        try:
            if self._forgotten:
                gone, self._forgotten = self._forgotten, []
                self._send(("forget", gone))
            self._send(("call", *call))
            self._waiting.append(mine)
            while True:
                data = self._next_message(_POLL) if mine.answer is None else None
                if data is not None:
                    self._take(data)
                if mine.answer is not None:
                    (kind, *words), made = mine.answer
                    if kind == "error":
                        raise _error(*words)
                    if cancelled_at is not None:
                        raise Cancelled("cancelled")   # done before it heard of that
                    return words[0], made
                let_the_window_live()
                if cancelled_at is None and progress is not None and not progress(*mine.progress):
                    cancelled_at = time.monotonic()
                    write_message(self.program.stdin, b"cancel")
                if cancelled_at is not None and time.monotonic() - cancelled_at > (self.grace or GRACE):
                    raise Cancelled("cancelled")
        except (EOFError, OSError, pickle.UnpicklingError) as error:
            if mine.answer is not None:
                raise
            if cancelled_at is not None:
                raise Cancelled("cancelled") from None
            raise self._obituary(what, mine.progress[0]) from error

    def _take(self, data):
        """Gives a message to the call that waits longest."""
        (kind, *words), made = self._received(data)
        if kind == "progress":
            self._waiting[0].progress = words
        else:
            self._waiting.popleft().answer = (kind, *words), made

    def _send(self, message):
        stream = io.BytesIO()
        pickler = pickle.Pickler(stream, pickle.HIGHEST_PROTOCOL)
        pickler.persistent_id = lambda value: value._key if isinstance(value, WorkerMesh) else None
        pickler.dump(message)
        write_message(self.program.stdin, stream.getbuffer())

    def _received(self, data):
        made = []

        def mesh_of(identity):
            key, contents = identity
            mesh = WorkerMesh(contents, self.engine)
            mesh._process, mesh._key = self, key
            mesh._finalizer = weakref.finalize(mesh, self.forget, key)
            made.append(mesh)
            return mesh

        unpickler = pickle.Unpickler(io.BytesIO(data))
        unpickler.persistent_load = mesh_of
        return unpickler.load(), made

    def _obituary(self, what, step):
        """The error for a process that died while it did `what`."""
        try:
            code = self.program.wait(5)
        except subprocess.TimeoutExpired:
            code = None
        try:
            where = os.read(self._last_words, 1000).decode("utf-8", "replace") or step
        except OSError:
            where = step
        self.kill()
        text = translate("FeatureMesh", "FeatureMesh's worker process %s while %s%s. FreeCAD and the document are as they were. %s") % (
            _how_it_ended(code), what, " (%s)" % where if where else "",
            translate("FeatureMesh", "Perhaps memory ran out: try a larger size.") if code == _KILLED else
            translate("FeatureMesh", "Check the shape there (Part: Check geometry), mesh from scratch, or try another size."))
        log.write("%s", text)
        return WorkerDied(text)

    def _close_last_words(self):
        if self._last_words >= 0:
            os.close(self._last_words)
            self._last_words = -1
            self._unlink_last_words()

    def _unlink_last_words(self):
        """Removes the file's name, where it may be removed while the file is open; whoever ends without a word leaves none then."""
        try:
            os.unlink(self._last_words_path)
        except OSError:
            pass


def _how_it_ended(code):
    if code is None or 0 <= code < _WINDOWS_EXCEPTION:
        return translate("FeatureMesh", "ended")
    if code >= _WINDOWS_EXCEPTION:
        return translate("FeatureMesh", "crashed (%s)") % ("0x%X" % code)
    try:
        name = signal.Signals(-code).name
    except ValueError:
        name = "signal %d" % -code
    if code == _KILLED:
        return translate("FeatureMesh", "was ended from outside (%s)") % name
    return translate("FeatureMesh", "crashed (%s)") % name


def _error(name, text, message):
    if name in _ERRORS:
        error = _ERRORS[name](text)
        error.message = message
        return error
    known = getattr(builtins, name, None)
    if isinstance(known, type) and issubclass(known, Exception):
        return known(text)
    return Error("%s: %s" % (name, text))

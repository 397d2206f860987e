# SPDX-License-Identifier: GPL-3.0-or-later
"""The engine in a process of its own, so that a crash of the geometry kernel is a message and not a lost session.

`WorkerEngine` has the functions of the module `featuremesh_engine` with the same results, bit for bit. The process is started when
it is first needed, and anew after it died; what it knew is sent to it again from the arrays kept here.
"""

import builtins
import io
import os
import pickle
import shutil
import signal
import subprocess
import sys
import threading
import time
import weakref
from multiprocessing import connection as connections

import FreeCAD

from .waiting import let_the_window_live

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

_PROGRAM = os.path.join(os.path.dirname(os.path.abspath(__file__)), "worker_main.py")
_POLL, GRACE, _START_SECONDS = 0.03, 0.3, 60
# FreeCAD 1.1 starts Python without its signal handlers: to write to a process that has died must be an error, not FreeCAD's end.
if hasattr(signal, "SIGPIPE") and threading.current_thread() is threading.main_thread() \
        and signal.getsignal(signal.SIGPIPE) == signal.SIG_DFL:
    signal.signal(signal.SIGPIPE, signal.SIG_IGN)


class Error(RuntimeError):
    """Base of all errors of the engine, as featuremesh_engine.Error."""


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


class CannotStart(RuntimeError):
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
    "": QT_TRANSLATE_NOOP("FeatureMesh", "working on %s"),
}


class WorkerMesh:
    """A mesh whose engine object lives in a worker; what can be asked of it is here."""

    def __init__(self, contents):
        self._contents = contents
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
        return self._contents["owners_of_faces"]

    def owners_of_tets(self):
        return self._contents["owners_of_tets"]


class WorkerEngine:
    """The engine's functions. Those that mesh run in one process, quick looks in another, so neither waits for the other."""

    PartMesh = WorkerMesh
    Error, InputError, KernelError = Error, InputError, KernelError
    MeshError, StateError, Cancelled = MeshError, StateError, Cancelled
    _LOOKS = ("estimate_tets", "compare", "read_tree")

    def __init__(self, folder=None):
        self.folder = folder   # of the compiled engine; None: on the Python path
        self._lanes = {False: _Lane(), True: _Lane()}

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        return lambda *args, **kwargs: self.call(name, *args, **kwargs)

    def start(self):
        """Starts the process that meshes, if it does not run. Throws CannotStart."""
        lane = self._lanes[False]
        process = lane.process
        if process is not None and process.is_alive():
            return   # without waiting for what it does
        with lane.lock:
            lane.running(self.folder)

    def stop(self):
        """Ends the processes; a later call starts them again."""
        for lane in self._lanes.values():
            lane.end()

    @property
    def process_id(self):
        """Of the process that meshes; None when it does not run."""
        process = self._lanes[False].process
        return process.program.pid if process is not None else None

    def call(self, name, *args, progress=None, **kwargs):
        """Calls a function of the engine in a worker and waits for its answer. `progress` may be the last of `args`, too."""
        if args and callable(args[-1]):
            *args, progress = args
        lane = self._lanes[name in self._LOOKS]
        while not lane.lock.acquire(timeout=_POLL):
            if progress is not None and not progress("waiting", 0.0):
                raise Cancelled("cancelled")
            let_the_window_live()
        try:
            for mesh in (value for value in args if isinstance(value, WorkerMesh)):
                self._bring(mesh, lane, progress)
            if progress is not None:
                kwargs["progress"] = True
            return self._ask(lane, name, args, kwargs, progress)
        finally:
            lane.lock.release()

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
        raws = [value for value in args if isinstance(value, dict) and "records" in value]
        what = translate("FeatureMesh", _DOING.get(name, _DOING[""])) % (raws[-1]["final_object"] if raws else "a mesh")
        try:
            answer, made = process.ask((name, args, kwargs), what, progress)
        except (WorkerDied, Cancelled):
            if not process.is_alive():
                lane.process = None
            raise
        options = [value for value in args if isinstance(value, dict)]
        for mesh in made:
            mesh._recipe = raws[-1], options[options.index(raws[-1]) + 1]
        return answer


class _Lane:
    """A process that is there whenever it is needed, for one caller at a time."""

    def __init__(self):
        self.lock = threading.RLock()
        self.process = None

    def running(self, folder):
        if self.process is None or not self.process.is_alive():
            self.process = start_process(folder)
        return self.process

    def end(self):
        if self.process is not None:
            self.process.kill()
            self.process = None


def start_process(folder):
    """A worker process with the first interpreter that can load the engine. Throws CannotStart."""
    reasons = []
    for python in interpreters():
        try:
            return _Process(python, folder)
        except CannotStart as error:
            reasons.append("%s: %s" % (python, error))
    raise CannotStart("; ".join(reasons) or "no Python interpreter was found")


def interpreters():
    """Programs that may be the interpreter inside FreeCAD, the likeliest first."""
    version = "python%d.%d" % sys.version_info[:2]
    beside = os.path.dirname(os.path.realpath(sys.executable or ""))
    places = [os.environ.get("FEATUREMESH_PYTHON"), os.path.join(sys.exec_prefix, "bin", version), os.path.join(beside, version),
              os.path.join(beside, "python"), "/usr/bin/" + version, "/usr/bin/python3", shutil.which(version)]
    return [place for place in dict.fromkeys(places) if place and os.access(place, os.X_OK)]


class _Process:
    """One worker process and the line to it."""

    def __init__(self, python, folder):
        ours, theirs = connections.Pipe()
        self._last_words, writable = os.pipe()
        arguments = [python, _PROGRAM, str(theirs.fileno()), str(writable)] + ([folder] if folder else [])
        try:
            self.program = subprocess.Popen(arguments, pass_fds=(theirs.fileno(), writable), stdin=subprocess.DEVNULL,
                                            stdout=subprocess.DEVNULL)
        except OSError as error:
            os.close(self._last_words)
            raise CannotStart(str(error)) from error
        finally:
            theirs.close()
            os.close(writable)
        self._connection = ours
        self._forgotten = []
        self._await_ready()

    def _await_ready(self):
        try:
            if self._connection.poll(_START_SECONDS):
                kind, *reason = pickle.loads(self._connection.recv_bytes())
                if kind == "ready":
                    return
            else:
                reason = ["it does not answer"]
        except (EOFError, OSError):
            reason = ["it ended at once"]
        self.kill()
        raise CannotStart("".join(reason))

    def is_alive(self):
        return self.program.poll() is None

    def kill(self):
        """Ends the process whatever it does."""
        if self.program.poll() is None:
            self.program.kill()
        self.program.wait()
        self._connection.close()
        self._close_last_words()

    def forget(self, key):
        """Lets the worker drop a mesh, at the next call."""
        self._forgotten.append(key)

    def ask(self, call, what, progress):
        """(answer, the meshes that are new in it). Throws what the engine threw, Cancelled, and WorkerDied."""
        step, share, cancelled_at = "", 0.0, None
        try:
            if self._forgotten:
                gone, self._forgotten = self._forgotten, []
                self._send(("forget", gone))
            self._send(("call", *call))
            while True:
                if self._connection.poll(_POLL):
                    (kind, *words), made = self._receive()
                    if kind == "done":
                        return words[0], made
                    if kind == "error":
                        raise _error(*words)
                    step, share = words
                let_the_window_live()
                if cancelled_at is None and progress is not None and not progress(step, share):
                    cancelled_at = time.monotonic()
                    self._connection.send_bytes(b"cancel")
                if cancelled_at is not None and time.monotonic() - cancelled_at > GRACE:
                    self.kill()
                    raise Cancelled("cancelled")
        except (EOFError, OSError, pickle.UnpicklingError) as error:
            if cancelled_at is not None:
                self.kill()
                raise Cancelled("cancelled") from None
            raise self._obituary(what, step) from error

    def _send(self, message):
        stream = io.BytesIO()
        pickler = pickle.Pickler(stream, pickle.HIGHEST_PROTOCOL)
        pickler.persistent_id = lambda value: value._key if isinstance(value, WorkerMesh) else None
        pickler.dump(message)
        self._connection.send_bytes(stream.getbuffer())

    def _receive(self):
        made = []

        def mesh_of(identity):
            key, contents = identity
            mesh = WorkerMesh(contents)
            mesh._process, mesh._key = self, key
            mesh._finalizer = weakref.finalize(mesh, self.forget, key)
            made.append(mesh)
            return mesh

        unpickler = pickle.Unpickler(io.BytesIO(self._connection.recv_bytes()))
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
            translate("FeatureMesh", "Perhaps memory ran out: try a larger size.") if code == -signal.SIGKILL else
            translate("FeatureMesh", "Check the shape there (Part: Check geometry), mesh from scratch, or try another size."))
        return WorkerDied(text)

    def _close_last_words(self):
        if self._last_words is not None:
            os.close(self._last_words)
            self._last_words = None


def _how_it_ended(code):
    if code is None or code >= 0:
        return translate("FeatureMesh", "ended")
    try:
        name = signal.Signals(-code).name
    except ValueError:
        name = "signal %d" % -code
    if code == -signal.SIGKILL:
        return translate("FeatureMesh", "was ended from outside (%s)") % name
    return translate("FeatureMesh", "crashed (%s)") % name


def _error(name, text):
    if name in _ERRORS:
        return _ERRORS[name](text)
    known = getattr(builtins, name, None)
    if isinstance(known, type) and issubclass(known, Exception):
        return known(text)
    return Error("%s: %s" % (name, text))

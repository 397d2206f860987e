# SPDX-License-Identifier: GPL-3.0-or-later
"""Starts and speaks with a worker: a FreeCAD process that runs worker_main.py. It ends when the process that started it does."""

import json
import os
import select
import signal
import subprocess
import tempfile
import time

from ..errors import Said
from ..messages import of_error, said

WORKER_SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "worker_main.py")
_GRACE = 30.0   # s that a worker has beyond a case's limit to end the case itself


class WorkerDied(Said, RuntimeError):
    """The worker's process ended before it answered."""


class BaseBroken(Said, RuntimeError):
    """The worker cannot open the base document."""


class WorkerProcess:
    """One FreeCAD, which runs one case at a time."""

    def __init__(self, command, environment, settings, log_path):
        """`command` starts freecadcmd, without the script; `settings` are base, study, solver, seconds_limit, memory_limit of worker_main."""
        self._limit = settings["seconds_limit"] + _GRACE
        theirs_in, ours_out = os.pipe()
        ours_in, theirs_out = os.pipe()
        self._cache = tempfile.TemporaryDirectory(prefix="featuremesh-", ignore_cleanup_errors=True)   # of FreeCAD, which is not let end by itself
        said = {**settings, "requests": theirs_in, "answers": theirs_out, "parent": os.getpid()}
        with open(log_path, "wb") as log:
            self._process = subprocess.Popen(
                [command, WORKER_SCRIPT], stdin=subprocess.DEVNULL, stdout=log, stderr=log, pass_fds=(theirs_in, theirs_out),
                start_new_session=True, env={**environment, "FEATUREMESH_STUDY_WORKER": json.dumps(said), "OMP_NUM_THREADS": "1",
                                             "FREECAD_USER_TEMP": self._cache.name})
        os.close(theirs_in)
        os.close(theirs_out)
        self._out = os.fdopen(ours_out, "w", encoding="utf-8")
        self._in = ours_in
        self._buffer = b""
        self._ended = False
        self._end = time.monotonic() + self._limit   # of what it does now: it starts

    @property
    def pid(self):
        return self._process.pid

    def fileno(self):
        """Readable when there is an answer, or when the worker died."""
        return self._in

    def is_overdue(self):
        """Should it have answered long ago? It ends each case at its limit, unless it is stuck or was stopped itself."""
        return time.monotonic() > self._end

    def send(self, case):
        """Gives it a case: {"id", "set", "parameters", "folder"}. Throws WorkerDied."""
        self._end = time.monotonic() + self._limit
        try:
            self._out.write(json.dumps(case) + "\n")
            self._out.flush()
        except OSError as error:
            raise WorkerDied(said("FreeCAD ended ({why:messages})", why=of_error(error))) from error

    def answer(self):
        """Its next answer, waited for until it is overdue. Throws WorkerDied, BaseBroken."""
        while b"\n" not in self._buffer:
            if not select.select([self._in], [], [], max(0.0, self._end - time.monotonic()))[0]:
                raise WorkerDied(said("FreeCAD does not answer"))
            chunk = os.read(self._in, 1 << 16)
            if not chunk:
                raise WorkerDied(said("FreeCAD ended"))
            self._buffer += chunk
        line, _, self._buffer = self._buffer.partition(b"\n")
        answer = json.loads(line)
        if "broken" in answer:
            raise BaseBroken(answer["broken"])
        return answer

    def end(self):
        """Ends it and all that it started. May be called twice."""
        if self._ended:
            return
        self._ended = True
        kill_session(self._process.pid)
        self._process.wait()
        os.close(self._in)
        self._cache.cleanup()
        try:
            self._out.close()
        except OSError:
            pass   # what was not sent is of no use any more


def kill_session(session):
    """Ends every process of a session: a worker, its copies, their CalculiX."""
    for name in os.listdir("/proc"):
        if name.isdigit():
            try:
                if os.getsid(int(name)) == session:
                    os.kill(int(name), signal.SIGKILL)
            except (ProcessLookupError, PermissionError):
                pass   # it ended meanwhile

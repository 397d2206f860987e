# SPDX-License-Identifier: GPL-3.0-or-later
"""A study that runs beside the window: its process, and how far it is."""

import json
import os
import shutil
import signal
import subprocess
import sys
import time

import FreeCAD

from .. import engine
from ..errors import UserError
from ..messages import said
from ..user_words import in_words
from . import progress
from .database import RUNNING
from .folder import StudyFolder, has_study

translate = FreeCAD.Qt.translate
_SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "run_main.py")
_NAMES = ("freecadcmd", "FreeCADCmd")
_LOOK_EVERY = 0.5   # s
# Waits for a job in the window, which lives meanwhile; None where there is no window.
run_job = None


class WindowRun:
    """The process that runs the study in a folder; it ends with FreeCAD."""

    def __init__(self, folder, jobs=0, more=0):
        """`jobs` cases at once, 0 or less: as many as the processors; `more` cases of the same sampling are added. Throws UserError."""
        if not sys.platform.startswith("linux"):
            raise UserError(said("studies run on Linux only"))
        self.folder = folder
        processors = len(os.sched_getaffinity(0))
        self.jobs = min(jobs, processors) if jobs > 0 else processors
        self._result = os.path.join(folder, "run.json")
        order = {"folder": folder, "jobs": self.jobs, "more": more, "freecad": program(), "parent": os.getpid()}
        environment = {**os.environ, "FEATUREMESH_STUDY_RUN": json.dumps(order), "FEATUREMESH_ENGINE": engine.folder(), "LC_ALL": "C.UTF-8"}
        try:
            if os.path.exists(self._result):
                os.unlink(self._result)
            with open(os.path.join(folder, "run.log"), "wb") as log:
                self._process = subprocess.Popen([order["freecad"], _SCRIPT], stdin=subprocess.DEVNULL, stdout=log, stderr=log, start_new_session=True,
                                                 env=environment)
        except OSError as error:
            raise UserError(said("cannot write {path:text}: {why:messages}", path=error.filename, why=error.strerror)) from error

    def is_running(self):
        return self._process.poll() is None

    def wait(self):
        """Returns when it has ended. Throws UserError where it ended before all cases were run."""
        if run_job is None:
            self.run()
        else:
            run_job(self)
        if self.problem():
            raise UserError(self.problem())

    def run(self, progress=lambda step, share: True):
        """The same as a job, for any thread: `progress` returns False to stop the study."""
        while self.is_running():
            finished, total, *_ = how_far(self.folder)
            if not progress("cases", finished / max(1, total)):
                self.stop()
            time.sleep(_LOOK_EVERY)

    def stop(self):
        """Asks it to end; what was finished is kept."""
        if self.is_running():
            self._process.send_signal(signal.SIGTERM)

    def kill(self):
        """Ends it at once and waits for that. What was finished is kept."""
        self._process.kill()
        self._process.wait()

    def problem(self):
        """Why it ended before all cases were run, in one line; "" when it did not."""
        if self.is_running():
            return ""
        try:
            with open(self._result, encoding="utf-8") as stream:
                ended = json.load(stream)
        except (OSError, ValueError):
            return translate("FeatureMesh", "the study's process ended; see %s") % os.path.join(self.folder, "run.log")
        return translate("FeatureMesh", "stopped") if ended["state"] == "stopped" else in_words(ended["message"])


def how_far(folder, jobs=1, running_since=None):
    """(cases finished, cases in all, seconds left or None, progress.summary) of the study in a folder, (0, 0, None, "") before it has cases. `running_since` is a
    dict that remembers from one call to the next since when cases run."""
    if not has_study(folder):
        return 0, 0, None, ""
    database = StudyFolder(folder).database
    try:
        counts, mean, running, lost = database.counts(), database.mean_seconds(), database.cases(RUNNING), database.first_lost()
    finally:
        database.close()
    now, known = time.monotonic(), running_since or {}
    since = {(case.id, case.attempts): known.get((case.id, case.attempts), now) for case in running}
    if running_since is not None:
        running_since.clear()
        running_since.update(since)
    left = progress.seconds_left(counts, [now - begun for begun in since.values()], [] if mean is None else [mean], jobs)
    return counts["done"] + counts["infeasible"] + counts["failed"], sum(counts.values()), left, progress.summary(counts, lost)


def program():
    """freecadcmd of the FreeCAD that runs. Throws UserError."""
    beside = os.path.dirname(os.path.realpath("/proc/self/exe"))
    folders = (beside, os.path.join(FreeCAD.getHomePath(), "bin"))
    found = [os.environ.get("FREECADCMD"), *(os.path.join(folder, name) for folder in folders for name in _NAMES), *map(shutil.which, _NAMES)]
    for path in filter(None, found):
        if os.path.isfile(path) and os.access(path, os.X_OK):
            return path
    raise UserError(said("FreeCAD's program freecadcmd was not found; set FREECADCMD to it"))


def new_folder(document_path, name):
    """A folder for a study that is not there yet: beside the document, or with the user's data where that was never saved."""
    where = os.path.dirname(document_path) if document_path else os.path.join(FreeCAD.getUserAppDataDir(), "FeatureMesh", "studies")
    stem = os.path.splitext(os.path.basename(document_path))[0] if document_path else time.strftime("%Y-%m-%d")
    first = os.path.join(where, "%s-%s" % (stem, name.lower()))
    number, path = 1, first
    while os.path.exists(path):
        number += 1
        path = "%s-%d" % (first, number)
    return path

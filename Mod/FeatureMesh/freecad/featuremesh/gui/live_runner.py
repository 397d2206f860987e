# SPDX-License-Identifier: GPL-3.0-or-later
"""Solves live results beside FreeCAD's own thread: one solution each at a time, and a newer one ends the one under way.

FreeCAD takes longer to take a mesh than the engine to solve it, so a solution begins before FreeCAD has the mesh, with its arrays. When the document is
recomputed, what is to be solved is read again; if that is something else the early solution is forgotten.
"""

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import live_result, mesh_object, solve_guard, waiting
from ..errors import UserError
from .running import RunningJob, step_in_words

translate = FreeCAD.Qt.translate
_POLL_MS = 40
_runs = {}        # (document, object) -> _Run
followers = []    # called with a live result whenever its run got further


def install():
    """To be called once."""
    live_result.solve_later = solve
    live_result.solve_early = begin_early
    live_result.cancel = forget


def solve(live):
    """Solves it as soon as FreeCAD has recomputed; what is under way for it ends."""
    _run_for(live).start()


def begin_early(live, arrays):
    """Begins to solve it on a mesh that FreeCAD is about to take; `solve` is called when it has."""
    _run_for(live).begin_early(arrays)


def cancel(live):
    """Ends its solution by the user's wish."""
    run = run_of(live)
    if run is not None:
        run.stop()
        live.Proxy.set_status(live, live_result.CANCELLED)
        run.tell()


def forget(live):
    """Ends its solution, which nobody needs any longer, an early one, too."""
    run = _runs.get((live.Document.Name, live.Name))
    if run is not None:
        run.stop()


def run_of(live):
    """What is under way for it, or None."""
    run = _runs.get((live.Document.Name, live.Name))
    return run if run is not None and run.is_active() else None


def _run_for(live):
    key = live.Document.Name, live.Name
    known = _runs.get(key)
    if known is None or known.live is not live:   # that of another object which had the name, perhaps in a document that was closed
        if known is not None:
            known.stop()
        _runs[key] = _Run(live)
    return _runs[key]


class _Run:
    """The solutions of one live result, one after the other."""

    def __init__(self, live):
        self.live = live
        self.job = self.running = None
        self._early = None   # (job, RunningJob) on a mesh that FreeCAD was about to take
        self._is_wanted = False
        self._bar = _Bar(self)
        self._timer = QtCore.QTimer()
        self._timer.setInterval(_POLL_MS)
        self._timer.timeout.connect(self._look)

    def start(self):
        self._leave()
        self._is_wanted = True
        self._timer.start()
        QtCore.QTimer.singleShot(0, self._look)   # a solution that began early may be there when the recompute ends, before the window draws the old one

    def begin_early(self, arrays):
        self.stop()
        try:
            job = self.live.Proxy.prepare_early(self.live, arrays)
        except (UserError, RuntimeError):
            return   # it is said when FreeCAD has the mesh
        self._early = job, RunningJob(job)
        self._timer.start()

    def stop(self):
        self._forget_early()
        self._leave()

    def _forget_early(self):
        if self._early is not None:
            self._early[1].cancel()
        self._early = None

    def _leave(self):
        """Ends what is under way, but not what began early."""
        if self.running is not None:
            self.running.cancel()   # its thread ends by itself, and what it finds is not looked at
        self.job = self.running = None
        self._is_wanted = False
        self._timer.stop()
        self._bar.end()

    def is_active(self):
        return self._is_wanted or self.running is not None

    def words(self):
        """The step under way and how far it is, 0 to 1."""
        running = self.running
        return (step_in_words(running.step), running.share) if running is not None else (step_in_words("waiting"), 0.0)

    def tell(self):
        for follow in list(followers):
            follow(self.live)

    def _look(self):
        if not self._is_there():
            self.stop()
            return
        if self.live.Document.Recomputing or waiting.is_waiting():
            return
        if self.running is None:
            self._begin() if self._is_wanted else self.stop()   # the recompute failed
        if self.running is not None and self.running.is_done():
            self._end()
        if self.running is not None:
            self._bar.show_step(*self.words())
        self.tell()

    def _begin(self):
        if Gui.editDocument() is None:
            solve_guard.recompute_left(self.live.Proxy.analysis(self.live))
        self._is_wanted = False
        try:
            job = self.live.Proxy.prepare(self.live)
        except (UserError, RuntimeError) as error:
            self._fail(error)
            return
        if self._early is not None and self._early[0].statics.is_same(job.statics):
            (self.job, self.running), self._early = self._early, None
            self.job.state = job.state
        else:
            self._forget_early()
            self.job, self.running = job, RunningJob(job)

    def _end(self):
        job, error = self.job, self.running.error
        self.stop()
        if error is not None:
            self._fail(error)
            return
        try:
            self.live.Proxy.finish(self.live, job)
        except (UserError, RuntimeError) as problem:
            self._fail(problem)

    def _fail(self, error):
        self.stop()
        self.live.Proxy.fail(self.live, error)
        if not mesh_object.is_cancelled(error):
            self.live.Proxy.tell(self.live, error)
        self.tell()

    def _is_there(self):
        try:
            document, name = self.live.Document, self.live.Name   # that undo took away has in FreeCAD 1.1 a document, but no name
            return document is not None and name is not None and document.getObject(name) is self.live
        except (ReferenceError, RuntimeError):   # deleted, perhaps with its document
            return False


class _Bar(QtGui.QWidget):
    """The step of a solution in FreeCAD's status bar, with a button to cancel it."""

    def __init__(self, run):
        super().__init__()
        self.setObjectName("FeatureMeshLiveBar")
        layout = QtGui.QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        self.label, self.bar, self.button = QtGui.QLabel(), QtGui.QProgressBar(), QtGui.QToolButton()
        self.bar.setRange(0, 100)
        self.bar.setMaximumWidth(120)
        self.button.setText(translate("FeatureMesh", "Cancel"))
        self.button.clicked.connect(lambda: cancel(run.live))
        for widget in (self.label, self.bar, self.button):
            layout.addWidget(widget)

    def show_step(self, step, share):
        if self.parent() is None:
            Gui.getMainWindow().statusBar().addPermanentWidget(self)
            self.show()
        self.label.setText(translate("FeatureMesh", "Live result: %s") % step)
        self.bar.setValue(round(100 * share))

    def end(self):
        if self.parent() is not None:
            Gui.getMainWindow().statusBar().removeWidget(self)
            self.setParent(None)

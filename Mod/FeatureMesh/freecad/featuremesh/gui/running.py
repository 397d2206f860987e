# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a mesh job beside FreeCAD's own thread, which keeps the window alive."""

import threading

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import worker

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
STEPS = {
    "": QT_TRANSLATE_NOOP("FeatureMesh", "starting"),
    "waiting": QT_TRANSLATE_NOOP("FeatureMesh", "waiting for other work"),
    "read": QT_TRANSLATE_NOOP("FeatureMesh", "reading the part"),
    "cells": QT_TRANSLATE_NOOP("FeatureMesh", "intersecting the features"),
    "difference": QT_TRANSLATE_NOOP("FeatureMesh", "comparing with the old part"),
    "keep": QT_TRANSLATE_NOOP("FeatureMesh", "choosing what is kept"),
    "surface": QT_TRANSLATE_NOOP("FeatureMesh", "meshing the faces"),
    "volume": QT_TRANSLATE_NOOP("FeatureMesh", "filling the solid"),
    "optimise": QT_TRANSLATE_NOOP("FeatureMesh", "improving the elements"),
    "validate": QT_TRANSLATE_NOOP("FeatureMesh", "checking the mesh"),
    "assemble": QT_TRANSLATE_NOOP("FeatureMesh", "assembling the stiffness matrix"),
    "setup": QT_TRANSLATE_NOOP("FeatureMesh", "preparing the solver"),
    "solve": QT_TRANSLATE_NOOP("FeatureMesh", "solving"),
    "cases": QT_TRANSLATE_NOOP("FeatureMesh", "running the cases of the study"),
    "stresses": QT_TRANSLATE_NOOP("FeatureMesh", "working out the stresses"),
}


def step_in_words(step):
    """The engine's step in the user's language."""
    return translate("FeatureMesh", STEPS.get(step, step))


class RunningJob:
    """A job in a thread of its own; asked from time to time how far it is."""

    def __init__(self, job):
        self.step, self.share = "", 0.0
        self._job = job
        self._error = None
        self._cancelled = False
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def is_done(self, wait=0.0):
        """Is it done? Waits up to `wait` seconds for that."""
        self._thread.join(wait)
        return not self._thread.is_alive()

    @property
    def error(self):
        """What a job that is done ended with, None for success. A cancel counts even when the job was done before it heard of that."""
        return worker.Cancelled("cancelled") if self._cancelled and self._error is None else self._error

    def cancel(self):
        """Ends the work at its next step."""
        self._cancelled = True

    def _run(self):
        try:
            self._job.run(self._progress)
        except BaseException as error:
            self._error = error

    def _progress(self, step, share):
        self.step, self.share = step, share
        return not self._cancelled


def repaint():
    """Lets the window redraw itself while FreeCAD's own thread waits; keys and clicks wait, too."""
    QtGui.QApplication.processEvents(QtCore.QEventLoop.ExcludeUserInputEvents)


def run_with_escape(job):
    """Runs a job while FreeCAD recomputes. The window lives, takes no input, and Escape cancels.

    FreeCAD's own progress bar is taken by the recompute itself, which shares it with nobody.
    """
    running = RunningJob(job)
    status = Gui.getMainWindow().statusBar()
    keys = _OnlyEscape()
    QtGui.QApplication.instance().installEventFilter(keys)
    try:
        while not running.is_done(0.05):
            if keys.escaped:
                running.cancel()
            status.showMessage(translate("FeatureMesh", "FeatureMesh: %s, %d %% (Escape cancels)")
                               % (step_in_words(running.step), 100 * running.share))
            QtGui.QApplication.processEvents()
    finally:
        QtGui.QApplication.instance().removeEventFilter(keys)
        status.clearMessage()
    if keys.escaped:
        running.cancel()
    if running.error is not None:
        raise running.error


class _OnlyEscape(QtCore.QObject):
    """Swallows what the user does, and remembers Escape."""

    def __init__(self):
        super().__init__()
        self.escaped = False

    def eventFilter(self, target, event):
        if event.type() in (QtCore.QEvent.KeyPress, QtCore.QEvent.ShortcutOverride) and event.key() == QtCore.Qt.Key_Escape:
            self.escaped = True
        return event.type() in _INPUT


_INPUT = {QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease, QtCore.QEvent.Shortcut, QtCore.QEvent.ShortcutOverride,
          QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonRelease, QtCore.QEvent.MouseButtonDblClick,
          QtCore.QEvent.Wheel, QtCore.QEvent.ContextMenu, QtCore.QEvent.Close, QtCore.QEvent.DragEnter, QtCore.QEvent.Drop}

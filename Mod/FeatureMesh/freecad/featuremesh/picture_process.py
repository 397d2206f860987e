# SPDX-License-Identifier: GPL-3.0-or-later
"""Has a picture drawn by a program of its own, with an interpreter that has VTK and Matplotlib."""

import os
import subprocess
import tempfile

import FreeCAD
import numpy

from . import worker
from .errors import UserError

_FOLDER = os.path.dirname(os.path.abspath(__file__))


def draw(program, arrays, path):
    """Runs a program of this folder on the arrays; it writes the picture. Throws UserError when no interpreter can draw it."""
    said = "no Python interpreter was found"
    with tempfile.TemporaryDirectory(prefix="featuremesh-") as folder:
        task = os.path.join(folder, "task.npz")
        numpy.savez(task, **arrays)
        for python in worker.interpreters():
            done = _run(python, program, task, path)
            if done.returncode < 0:   # VTK aborts when it cannot reach its screen, which another try mends
                done = _run(python, program, task, path)
            if done.returncode == 0:
                return
            said = (done.stderr.strip().splitlines() or ["it ended with code %d" % done.returncode])[-1]
    raise UserError(FreeCAD.Qt.translate("FeatureMesh", "the picture could not be drawn: %s") % said)


def _run(python, program, task, path):
    return subprocess.run([python, os.path.join(_FOLDER, program), task, os.path.abspath(path)], stdin=subprocess.DEVNULL,
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors="replace")

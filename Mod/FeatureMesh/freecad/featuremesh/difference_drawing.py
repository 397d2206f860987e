# SPDX-License-Identifier: GPL-3.0-or-later
"""Has the picture of a difference drawn by a process of its own."""

import json
import os
import subprocess
import tempfile

import FreeCAD
import numpy

from . import reading, worker
from .errors import UserError

_PROGRAM = os.path.join(os.path.dirname(os.path.abspath(__file__)), "difference_picture.py")


def draw(old_part, new_part, changes, path):
    """Writes the picture. Throws UserError when no interpreter with VTK and Matplotlib can draw it."""
    arrays = {"changes": json.dumps(changes), **_packed("old", reading.outline_of(old_part)),
              **_packed("new", reading.outline_of(new_part))}
    said = "no Python interpreter was found"
    with tempfile.TemporaryDirectory(prefix="featuremesh-") as folder:
        task = os.path.join(folder, "task.npz")
        numpy.savez(task, **arrays)
        for python in worker.interpreters():
            done = _run(python, task, path)
            if done.returncode < 0:   # VTK aborts when it cannot reach its screen, which another try mends
                done = _run(python, task, path)
            if done.returncode == 0:
                return
            said = (done.stderr.strip().splitlines() or ["it ended with code %d" % done.returncode])[-1]
    raise UserError(FreeCAD.Qt.translate("FeatureMesh", "the picture could not be drawn: %s") % said)


def _run(python, task, path):
    return subprocess.run([python, _PROGRAM, task, os.path.abspath(path)], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, text=True, errors="replace")


def _packed(name, side):
    packed = {}
    for kind, shape in (("faces", (0, 3, 3)), ("edges", (0, 3))):
        packed["%s_%s" % (name, kind)] = numpy.concatenate([numpy.zeros(shape), *side[kind]])
        packed["%s_%s_sizes" % (name, kind)] = numpy.array([len(part) for part in side[kind]], dtype=int)
    return packed

# SPDX-License-Identifier: GPL-3.0-or-later
"""Has a picture drawn by a program of its own, with an interpreter that has VTK and Matplotlib."""

import os
import re
import subprocess
import tempfile

import numpy

from . import worker
from .errors import UserError
from .messages import said

_FOLDER = os.path.dirname(os.path.abspath(__file__))


def draw(program, arrays, path):
    """Runs a program of this folder on the arrays; it writes the picture. Throws UserError when no interpreter can draw it."""
    reasons = []
    with tempfile.TemporaryDirectory(prefix="featuremesh-") as folder:
        task = os.path.join(folder, "task.npz")
        numpy.savez(task, **arrays)
        for python in worker.interpreters():
            done = _run(python, program, task, path)
            if done.returncode < 0:   # VTK aborts when it cannot reach its screen, which another try mends
                done = _run(python, program, task, path)
            if done.returncode == 0:
                return
            reasons.append((done.stderr.strip().splitlines() or [said("it ended with code {code:count}", code=done.returncode)])[-1])
    why = min(reasons, key=_lacks_a_module, default=said("no Python interpreter was found"))   # of those that could draw, if there is one
    raise UserError(said("the picture could not be drawn: {why:messages}", why=_in_words(why)))


def _in_words(reason):
    """Without the names that Python gives to what is wrong with the file to write."""
    return re.sub(r"^(\w*Error): (\[Errno \d+\] )?", "", reason) if isinstance(reason, str) and not _lacks_a_module(reason) else reason


def _lacks_a_module(reason):
    return str(reason).startswith("ModuleNotFoundError")


def _run(python, program, task, path):
    return subprocess.run([python, os.path.join(_FOLDER, program), task, os.path.abspath(path)], stdin=subprocess.DEVNULL,
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors="replace")

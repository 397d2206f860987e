# SPDX-License-Identifier: GPL-3.0-or-later
"""A process of a study or of a command, and CalculiX, ends when the one that started it does, even when that is killed."""

import contextlib
import ctypes
import os
import signal
import subprocess
from types import SimpleNamespace

_DIE_WITH_PARENT = 1   # PR_SET_PDEATHSIG


def end_with(parent):
    """This process ends with its parent, whose id that is; at once where that has ended already."""
    ctypes.CDLL(None).prctl(_DIE_WITH_PARENT, signal.SIGKILL)
    if os.getppid() != parent:
        os._exit(1)


@contextlib.contextmanager
def of_what_starts(module):
    """Meanwhile the processes that a module of FreeCAD starts with `subprocess` end with this one, where the system knows such a thing."""
    parent, known = os.getpid(), module.subprocess
    if os.name == "posix" and hasattr(ctypes.CDLL(None), "prctl"):
        module.subprocess = SimpleNamespace(**{**vars(subprocess), "Popen": _starting(parent)})
    try:
        yield
    finally:
        module.subprocess = known


def _starting(parent):
    return lambda *rest, **named: subprocess.Popen(*rest, preexec_fn=lambda: end_with(parent), **named)

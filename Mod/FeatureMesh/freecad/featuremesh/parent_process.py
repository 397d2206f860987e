# SPDX-License-Identifier: GPL-3.0-or-later
"""A process of a study or of a command ends when the one that started it does, even when that is killed."""

import ctypes
import os
import signal

_DIE_WITH_PARENT = 1   # PR_SET_PDEATHSIG


def end_with(parent):
    """This process ends with its parent, whose id that is; at once where that has ended already."""
    ctypes.CDLL(None).prctl(_DIE_WITH_PARENT, signal.SIGKILL)
    if os.getppid() != parent:
        os._exit(1)

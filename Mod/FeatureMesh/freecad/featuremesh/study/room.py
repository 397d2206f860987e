# SPDX-License-Identifier: GPL-3.0-or-later
"""Tells a full disk from what else ends a case."""

import errno
import os
import shutil
import tempfile

from .database import FAILED

DISK_FULL = "disk full"   # a state that only a worker and a runner know
_FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)
_NO_ROOM = 1 << 20   # bytes; a disk with less is full


def state_after(error, folder):
    """What a case is that ended with the error: CalculiX and FreeCAD tell of a full disk in words of their own. Its folder may be gone."""
    is_full = getattr(error, "errno", None) in _FULL or any(
        shutil.disk_usage(path).free < _NO_ROOM for path in (folder, tempfile.gettempdir()) if os.path.isdir(path))
    return DISK_FULL if is_full else FAILED

# SPDX-License-Identifier: GPL-3.0-or-later
"""A text file that is there as a whole, or as it was before."""
import os
import shutil
from contextlib import contextmanager


@contextmanager
def written(path, **options):
    """The stream of a file beside `path`, which takes its place at the end of the block; what is no file, such as /dev/stdout, is written itself.
    Throws OSError.
    """
    target = os.path.realpath(path)
    if os.path.exists(target) and not os.path.isfile(target):
        with open(target, "w", encoding="utf-8", **options) as stream:
            yield stream
        return
    beside = target + ".tmp"
    try:
        with open(beside, "w", encoding="utf-8", **options) as stream:
            yield stream
        if os.path.exists(target):
            shutil.copymode(target, beside)
        os.replace(beside, target)
    finally:
        if os.path.exists(beside):
            os.unlink(beside)

# SPDX-License-Identifier: GPL-3.0-or-later
"""A file that is there as a whole, or as it was before."""
import os
import shutil
from contextlib import contextmanager, nullcontext


@contextmanager
def replaced(path):
    """The path of a file beside `path`, which takes its place at the end of the block; a link stays one, and who may read the file stays. Throws OSError."""
    target = os.path.realpath(path)
    beside = "%s.%d.tmp" % (target, os.getpid())
    try:
        yield beside
        if os.path.exists(target):
            shutil.copymode(target, beside)
        os.replace(beside, target)
    finally:
        if os.path.exists(beside):
            os.unlink(beside)


@contextmanager
def written(path, **options):
    """The stream of a text file, likewise; what is no file, such as /dev/stdout, is written itself."""
    is_file = os.path.isfile(path) or not os.path.exists(path)
    with replaced(path) if is_file else nullcontext(path) as place, open(place, "w", encoding="utf-8", **options) as stream:
        yield stream

# SPDX-License-Identifier: GPL-3.0-or-later
"""Standard output (`-`), a pipe or a device in place of a file to write: a file is written all the same, and its bytes go there afterwards."""
import os
import shutil
import stat
import sys
import tempfile
from contextlib import contextmanager
from pathlib import Path

from layout import UserError

STANDARD_OUTPUT = "-"


class Stream:
    """What `name` stands for; `ending` is that of the file in its place."""

    def __init__(self, name, ending):
        self.name, self.ending = "standard output" if name == STANDARD_OUTPUT else name, ending
        self.is_standard_output = name == STANDARD_OUTPUT or os.path.samestat(os.stat(name), os.fstat(1))

    def take(self, file):
        """Passes the bytes of the file on. Throws UserError, and BrokenPipeError where nobody reads them any more."""
        sys.stdout.flush()
        try:
            with open(file, "rb") as source, open(os.dup(1) if self.is_standard_output else self.name, "wb") as target:
                shutil.copyfileobj(source, target)
        except BrokenPipeError:
            raise
        except OSError as error:
            raise UserError(f"cannot write {self.name}: {error.strerror}") from error


def beside(*targets):
    """Where to tell what was written to these: not into the midst of it."""
    return sys.stderr if any(isinstance(target, Stream) and target.is_standard_output for target in targets) else sys.stdout


def is_stream(name):
    """Is what is to be written no file? What standard output was sent to is none either, though it may be one."""
    try:
        found = None if name == STANDARD_OUTPUT else os.stat(name)
    except OSError:
        return False
    return found is None or not (stat.S_ISREG(found.st_mode) or stat.S_ISDIR(found.st_mode)) or os.path.samestat(found, os.fstat(1))


@contextmanager
def file_for(target):
    """The path to write to for a target that may be a Stream, which gets all of it at the end of the block."""
    if not isinstance(target, Stream):
        yield target
        return
    with tempfile.TemporaryDirectory(prefix="featuremesh-") as folder:
        file = Path(folder, "featuremesh" + target.ending)
        yield str(file)
        if file.is_file():
            target.take(file)

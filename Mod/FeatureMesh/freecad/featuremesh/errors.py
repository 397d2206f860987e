# SPDX-License-Identifier: GPL-3.0-or-later
"""The errors of the FreeCAD side; the engine has its own (featuremesh_engine.Error)."""

import sys

from .messages import english, is_message


class Said:
    """Of an error whose `message` says it with parameters, as those of the engine's errors do; a text from elsewhere is said as it is."""

    def __init__(self, said=""):
        super().__init__(english(said))
        if is_message(said):
            self.message = said


class UserError(Said, ValueError):
    """What was asked cannot be done; it says what, where and what to try."""


class NotSelected(UserError):
    """Several objects may be meant, of which one is to be selected; in the console an option names it."""

    OBJECT, ANALYSIS = "--object", "--analysis"

    def __init__(self, said, option):
        super().__init__(said)
        self.option = option


class _NamedAsTheMesh(type):

    title = ""   # of the mesh whose update failed last

    def __str__(cls):
        return cls.title


class FailedUpdate(UserError, metaclass=_NamedAsTheMesh):
    """What a recompute of FreeCAD is told, which prints an exception's class, its text and the lines of code that led to it.

    To a user the text is enough, so the lines are left out while FreeCAD prints this one, that is, as long as it exists; the log has them.
    """

    def __init__(self, title, message):
        super().__init__(message)
        type(self).title = title
        self._limit = getattr(sys, "tracebacklimit", None)
        sys.tracebacklimit = 0

    def __del__(self):
        if self._limit is not None:
            sys.tracebacklimit = self._limit
        elif hasattr(sys, "tracebacklimit"):
            del sys.tracebacklimit


class StateError(Said, RuntimeError):
    """A saved mesh state is damaged, foreign or from a newer program."""


class EngineMissing(RuntimeError):
    """The compiled engine cannot be loaded."""

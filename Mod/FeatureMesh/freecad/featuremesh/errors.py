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

    To a user the text is enough, so the lines are left out while FreeCAD prints such errors, that is, as long as one exists; the log has them.
    """

    _alive, _limit = 0, None   # how many there are; what sys.tracebacklimit was before the first of them

    def __init__(self, title, message):
        if not FailedUpdate._alive:
            FailedUpdate._limit = getattr(sys, "tracebacklimit", None)
        FailedUpdate._alive += 1
        FailedUpdate.title, sys.tracebacklimit = title, 0
        super().__init__(message)

    def __del__(self):
        FailedUpdate._alive -= 1
        if FailedUpdate._alive:
            return
        if FailedUpdate._limit is None:
            vars(sys).pop("tracebacklimit", None)
        else:
            sys.tracebacklimit = FailedUpdate._limit


class StateError(UserError):
    """A saved mesh state is damaged, foreign or from a newer program."""


class EngineMissing(RuntimeError):
    """The compiled engine cannot be loaded."""

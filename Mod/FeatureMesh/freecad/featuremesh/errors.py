# SPDX-License-Identifier: GPL-3.0-or-later
"""The errors of the FreeCAD side; the engine has its own (featuremesh_engine.Error)."""


class UserError(ValueError):
    """What was asked cannot be done; the message says what, where and what to try."""


class StateError(RuntimeError):
    """A saved mesh state is damaged, foreign or from a newer program."""


class EngineMissing(RuntimeError):
    """The compiled engine cannot be loaded."""

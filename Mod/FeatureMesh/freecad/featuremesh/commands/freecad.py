# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the commands known to FreeCAD, which begins each macro that they are recorded in by importing what has the name of this file."""

import FreeCADGui as Gui

from . import COMMANDS, made


def register():
    """To be called once."""
    for name in COMMANDS:
        Gui.addCommand(name, made(name))

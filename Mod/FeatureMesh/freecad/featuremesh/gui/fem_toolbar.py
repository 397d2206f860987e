# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts our commands into the Mesh toolbar and menu of FreeCAD's FEM workbench."""

import FreeCADGui as Gui
from PySide import QtGui

_PLACE = "FEM_MeshGmshFromShape"


def install(commands):
    """Once, when FreeCAD's window is there."""
    if hasattr(Gui, "addWorkbenchManipulator"):
        Gui.addWorkbenchManipulator(_Manipulator(commands))
    else:
        Gui.getMainWindow().workbenchActivated.connect(lambda name: _add_actions(name, commands))


class _Manipulator:
    """FreeCAD 1.0 and later ask it whenever toolbars and menus are built."""

    def __init__(self, commands):
        self._commands = commands

    def modifyToolBars(self):
        return [{"append": name, "toolBar": "Mesh"} for name in self._commands]

    def modifyMenuBar(self):
        return [{"insert": name, "menuItem": _PLACE, "after": ""} for name in reversed(self._commands)]


def _add_actions(workbench, commands):
    if workbench != "FemWorkbench":
        return
    bar = Gui.getMainWindow().findChild(QtGui.QToolBar, "Mesh")
    if bar is None:
        return
    present = {action.objectName() for action in bar.actions()}
    for name in commands:
        for action in Gui.Command.get(name).getAction():
            if name not in present:
                action.setObjectName(name)
                bar.addAction(action)

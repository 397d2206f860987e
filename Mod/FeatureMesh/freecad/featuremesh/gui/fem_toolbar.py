# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts our commands into the Mesh toolbar and menu of FreeCAD's FEM workbench."""

import FreeCADGui as Gui
from PySide import QtGui

from .. import versions

_PLACE = "FEM_MeshGmshFromShape"   # an entry of FEM's Mesh menu in every version


def install(commands):
    """Once, when FreeCAD's window is there."""
    if versions.asks_manipulators():
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
    window = Gui.getMainWindow()
    bar = window.findChild(QtGui.QToolBar, "Mesh")
    if bar is not None:
        _add_to(bar, commands)
    for action in window.menuBar().actions():   # PySide deletes a menu once its action is let go, so it is used right here
        menu = action.menu()
        if menu is not None and any(entry.objectName() == _PLACE for entry in menu.actions()):
            _add_to(menu, commands)


def _add_to(place, commands):
    present = {action.objectName() for action in place.actions()}
    if present & set(commands):
        return
    place.addSeparator()
    for name in commands:
        for action in Gui.Command.get(name).getAction():
            action.setObjectName(name)
            place.addAction(action)

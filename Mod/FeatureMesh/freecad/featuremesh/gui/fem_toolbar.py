# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts our commands into the Mesh toolbar and menu of FreeCAD's FEM workbench."""

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import versions
from ..commands import OF_A_MESH
from ..commands.base import selected_meshes

_PLACE = "FEM_MeshGmshFromShape"   # an entry of FEM's Mesh menu in every version
_IN_EVERY_VIEW = "Std_ViewFitAll"   # an entry of the menu that the right button opens there
_REFRESH = 100   # milliseconds


def install(commands):
    """Once, when FreeCAD's window is there."""
    if versions.asks_manipulators():
        Gui.addWorkbenchManipulator(_Manipulator(commands))
    else:
        actions = _Actions(commands)
        Gui.getMainWindow().workbenchActivated.connect(actions.follow)


def is_mesh_selected():
    """Is a mesh of ours selected, or a part that has one?"""
    return FreeCAD.ActiveDocument is not None and bool(selected_meshes(FreeCAD.ActiveDocument))


class _Manipulator:
    """FreeCAD 1.0 and later ask it whenever toolbars and menus are built."""

    def __init__(self, commands):
        self._commands = commands

    def modifyToolBars(self):
        return [{"append": name, "toolBar": "Mesh"} for name in self._commands]

    def modifyMenuBar(self):
        return [{"insert": name, "menuItem": _PLACE, "after": ""} for name in reversed(self._commands)]

    def modifyContextMenu(self, recipient):
        """In FEM; our own workbench has these already."""
        if recipient != "View" or Gui.activeWorkbench().name() != "FemWorkbench" or not is_mesh_selected():
            return []
        return [{"insert": name, "menuItem": _IN_EVERY_VIEW} for name in OF_A_MESH]


class _Actions(QtCore.QObject):
    """FreeCAD 0.20 asks nobody, and has no actions for commands that no activated workbench shows: these are our own.

    They are enabled and named as FreeCAD does it with its own, from time to time while FEM is active.
    """

    def __init__(self, commands):
        super().__init__(Gui.getMainWindow())
        self._actions = [self._action(name) for name in commands]
        self._separator = QtGui.QAction(self)
        self._separator.setSeparator(True)
        self._timer = QtCore.QTimer(self)
        self._timer.timeout.connect(self._refresh)

    def _action(self, name):
        info = Gui.Command.get(name).getInfo()
        action = QtGui.QAction(QtGui.QIcon(info["pixmap"]), info["menuText"], self)
        action.setObjectName(name)
        action.triggered.connect(lambda: Gui.runCommand(name))
        return action

    def follow(self, workbench):
        """Joins FEM when it is activated."""
        if workbench != "FemWorkbench":
            self._timer.stop()
            return
        self._refresh()
        self._timer.start(_REFRESH)
        window = Gui.getMainWindow()
        bar = window.findChild(QtGui.QToolBar, "Mesh")
        if bar is not None:
            bar.addActions([self._separator, *self._actions])
        for entry in window.menuBar().actions():   # PySide deletes a menu once its action is let go, so it is used right here
            menu = entry.menu()
            if menu is not None and any(action.objectName() == _PLACE for action in menu.actions()):
                menu.addActions([self._separator, *self._actions])

    def _refresh(self):
        for action in self._actions:
            name = action.objectName()
            command = Gui.Command.get(name)
            info = command.getInfo()
            action.setEnabled(command.isActive())
            action.setText(FreeCAD.Qt.translate(name, info["menuText"]))
            action.setToolTip(FreeCAD.Qt.translate(name, info["toolTip"]))

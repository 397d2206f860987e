# SPDX-License-Identifier: GPL-3.0-or-later
"""How the mesh object looks and what a double click does."""

import os

import FreeCADGui as Gui

from . import mesh_object

ICONS = os.path.join(os.path.dirname(__file__), "icons")


def icon(name):
    """Path of one of our icons."""
    return os.path.join(ICONS, name + ".svg")


def attach(mesh):
    """Gives a mesh object its view, if it has none of ours yet."""
    view = mesh.ViewObject
    if view is not None and not isinstance(getattr(view, "Proxy", None), ViewFeatureMesh):
        ViewFeatureMesh(view)


class ViewFeatureMesh:
    """Proxy of the view. Its class path is stored in documents and never changes."""

    def __init__(self, view):
        view.Proxy = self

    def attach(self, view):
        self.Object = view.Object

    def getIcon(self):
        status = getattr(getattr(self, "Object", None), "Status", mesh_object.UP_TO_DATE)
        if status.startswith("failed"):
            return icon("FeatureMesh_Failed")
        return icon("FeatureMesh" if status == mesh_object.UP_TO_DATE else "FeatureMesh_Stale")

    def updateData(self, mesh, name):
        if name == "Status":
            mesh.ViewObject.signalChangeIcon()

    def colour(self, mesh, colours):
        """Colours elements {number: (red, green, blue)}; none: as usual."""
        mesh.ViewObject.ElementColor = colours

    def claimChildren(self):
        mesh = getattr(self, "Object", None)
        return list(mesh.MeshRegionList) + list(mesh.MeshGroupList) if mesh is not None else []

    def setEdit(self, view, mode=0):
        from .gui.task_panel import MeshPanel
        if Gui.Control.activeDialog():
            return False
        Gui.Control.showDialog(MeshPanel(view.Object))
        return True

    def unsetEdit(self, view, mode=0):
        Gui.Control.closeDialog()
        return True

    def doubleClicked(self, view):
        document = Gui.getDocument(view.Object.Document)
        if not document.getInEdit():
            document.setEdit(view.Object.Name)
        return True

    def dumps(self):
        return None

    def loads(self, saved):
        return None

    __getstate__ = dumps
    __setstate__ = loads

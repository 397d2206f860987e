# SPDX-License-Identifier: GPL-3.0-or-later
"""How the mesh object looks and what a double click does."""

import os

import FreeCADGui as Gui

from . import commands, refinements
from .gui.edited_in_panel import EditedInPanel
from .mesh_properties import FAILED, UP_TO_DATE
from .section import EDGES

# Called as (mesh, property) when a property of a mesh object has changed.
followers = []
ICONS = os.path.join(os.path.dirname(__file__), "icons")
_MOST_INNER_FACES = 50000   # as FreeCAD has it


def icon(name):
    """Path of one of our icons."""
    return os.path.join(ICONS, name + ".svg")


def drawn_icon(name):
    """One of our icons as a QIcon, drawn by FreeCAD, which needs no Qt plugin for SVG."""
    return Gui.getIcon(icon(name))


def kept_icon(name):
    """Path of one of our icons, which FreeCAD has drawn and keeps: without a Qt plugin for SVG it could not load it from the path."""
    drawn_icon(name)
    return icon(name)


def status_icon(view, fresh, stale):
    """That of a view whose object has a Status: where that is up to date, failed, or neither."""
    status = getattr(getattr(view, "Object", None), "Status", UP_TO_DATE)
    return kept_icon(fresh if status == UP_TO_DATE else "FeatureMesh_Failed" if status.startswith(FAILED) else stale)


class ViewFeatureMesh(EditedInPanel):
    """Proxy of the view. Its class path is stored in documents and never changes."""

    def attach(self, view):
        """Called by FreeCAD."""
        super().attach(view)
        self.onChanged(view, "ShowInner")

    def onChanged(self, view, name):
        """Called by FreeCAD before it draws: unless what is inside is to be shown, it looks for that by places, as in a large mesh. It would compare up to
        50 000 faces with one another, in each undo, too."""
        if name == "ShowInner":
            view.MaxFacesShowInner = _MOST_INNER_FACES if view.ShowInner else 0

    def getIcon(self):
        return status_icon(self, "FeatureMesh", "FeatureMesh_Stale")

    def updateData(self, mesh, name):
        if name == "Status":
            mesh.ViewObject.signalChangeIcon()
        if name == "FemMesh" and getattr(self, "_elements", None) is not None:
            self._elements.end()   # colours and points of a mesh that is no more
        for follow in list(followers):
            follow(mesh, name)

    def elements(self, mesh):
        """The drawing of elements in colours, see element_view."""
        from .element_view import ElementView
        if getattr(self, "_elements", None) is None:
            self._elements = ElementView(mesh.ViewObject.RootNode)
        return self._elements

    def show(self, mesh, overlay, plane=None, is_filled=False):
        """Draws the elements of an overlays.Overlay in place of FreeCAD's drawing; None: as usual."""
        if overlay is None:
            self.elements(mesh).end()
        else:
            self.elements(mesh).show(overlay, plane, is_filled)

    def mark_points(self, mesh, points, colour):
        """Draws points over everything else; none: takes them away."""
        self.elements(mesh).mark(points, (), colour)

    def mark_tets(self, mesh, overlay, rows, colour):
        """Draws the edges of elements of an overlay over everything else; none: takes them away."""
        corners = overlay.points[overlay.elements[rows]].reshape(-1, 3) if len(rows) else ()
        lines, width = [], overlay.elements.shape[1]
        for start in range(0, width * len(rows), width):
            for first, second in EDGES[:3 if width == 3 else 6].tolist():
                lines += [start + first, start + second, -1]
        self.elements(mesh).mark(corners, lines, colour)

    def claimChildren(self):
        mesh = getattr(self, "Object", None)
        return list(mesh.MeshRegionList) + list(mesh.MeshGroupList) if mesh is not None else []

    def canDelete(self, obj):
        """Without one of its refinements or groups it is another mesh, but none that is broken."""
        return obj in self.claimChildren()

    # What can be dragged from a mesh in the tree to another, and a copy, which is in none, to one.

    def canDragObjects(self):
        return True

    canDropObjects = canDragObjects

    def canDragObject(self, obj):
        return obj in self.claimChildren()

    def canDropObject(self, obj):
        return refinements.list_for(obj) is not None and obj not in self.claimChildren()

    def dragObject(self, view, obj):
        name = refinements.list_for(obj)
        setattr(view.Object, name, [other for other in getattr(view.Object, name) if other is not obj])

    def dropObject(self, view, obj):
        name = refinements.list_for(obj)
        setattr(view.Object, name, getattr(view.Object, name) + [obj])

    def setupContextMenu(self, view, menu):
        """Puts commands that work on the mesh into its menu in the tree, where it is selected."""
        for name in commands.OF_A_MESH:
            menu.addAction(drawn_icon(name), commands.made(name).title).triggered.connect(lambda *_, name=name: Gui.runCommand(name))

    def panel_of(self, obj):
        from .gui.task_panel import MeshPanel
        return MeshPanel(obj)

# SPDX-License-Identifier: GPL-3.0-or-later
"""How the mesh object looks and what a double click does."""

import os

import FreeCADGui as Gui

from . import mesh_object, versions

_MARKED = "FeatureMeshMarkedPoints"
ICONS = os.path.join(os.path.dirname(__file__), "icons")


def icon(name):
    """Path of one of our icons."""
    return os.path.join(ICONS, name + ".svg")


def drawn_icon(name):
    """One of our icons as a QIcon, drawn by FreeCAD, which needs no Qt plugin for SVG."""
    return Gui.getIcon(icon(name))


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
        name = "FeatureMesh" if status == mesh_object.UP_TO_DATE else "FeatureMesh_Failed" if status.startswith("failed") else "FeatureMesh_Stale"
        drawn_icon(name)   # FreeCAD keeps it; without a Qt plugin for SVG it could not load it from the path
        return icon(name)

    def updateData(self, mesh, name):
        if name == "Status":
            mesh.ViewObject.signalChangeIcon()

    def colour(self, mesh, colours):
        """Colours elements {number: (red, green, blue)}; none: as usual."""
        versions.colour_elements(mesh.ViewObject, colours)

    def mark_points(self, mesh, points, colour):
        """Draws points over everything else; none: takes them away."""
        self._mark(mesh, [tuple(point) for point in points], colour, ())

    def mark_tets(self, mesh, numbers, colour):
        """Draws the edges of tets over everything else; none: takes them away."""
        points, lines = [], []
        for number in numbers:
            start = len(points)
            points += [tuple(mesh.FemMesh.getNodeById(node)) for node in mesh.FemMesh.getElementNodes(number)[:4]]
            for first, second in ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)):
                lines += [start + first, start + second, -1]
        self._mark(mesh, points, colour, lines)

    def _mark(self, mesh, points, colour, lines):
        from pivy import coin
        root = mesh.ViewObject.RootNode
        for index in range(root.getNumChildren() - 1, -1, -1):
            if root.getChild(index).getName() == _MARKED:
                root.removeChild(index)
        if not points:
            return
        node = coin.SoAnnotation()   # drawn last and not hidden by what is in front
        node.setName(_MARKED)
        light, binding, style, base = coin.SoLightModel(), coin.SoMaterialBinding(), coin.SoDrawStyle(), coin.SoBaseColor()
        light.model = coin.SoLightModel.BASE_COLOR
        binding.value = coin.SoMaterialBinding.OVERALL   # the mesh's own drawing leaves one colour per element behind
        style.pointSize, style.lineWidth = 5, 3
        base.rgb = colour
        places = coin.SoCoordinate3()
        places.point.setValues(0, len(points), points)
        drawn = coin.SoPointSet()
        if lines:
            drawn = coin.SoIndexedLineSet()
            drawn.coordIndex.setValues(0, len(lines), lines)
        for child in (light, binding, style, base, places, drawn):
            node.addChild(child)
        root.addChild(node)

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

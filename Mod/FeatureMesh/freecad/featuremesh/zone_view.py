# SPDX-License-Identifier: GPL-3.0-or-later
"""How a refinement zone looks: its place in the 3D view, and what a double click does; and the icon of a refinement by error, which the mesh alone shows."""

import math

import FreeCAD
from pivy import coin

from . import size_zone, versions, view_provider
from .gui.edited_in_panel import DrawnByUs
from .proxies import View

_COLOUR, _FADED = (0.95, 0.55, 0.16), (0.6, 0.6, 0.6)   # as it is, and suppressed
_TRANSPARENCY = 0.7
_LINE, _THICK_LINE, _POINT = 1.5, 5, 9   # pixels
_DEFLECTION = 1 / 200   # of the size of a face, by which its triangles may be off it


class ViewSizeZone(DrawnByUs):
    """Proxy of the view. Its class path is stored in documents and never changes."""

    mode = "Zone"

    # FreeCAD's side

    def attach(self, view):
        super().attach(view)
        self._drawing = coin.SoSeparator()
        view.addDisplayMode(self._drawing, self.mode)
        self._draw(view.Object)

    def getIcon(self):
        return view_provider.kept_icon("FeatureMesh_AddSizeZone")

    def updateData(self, zone, name):
        if "Suppressed" in zone.PropertiesList:   # the last one that is added
            self._draw(zone)

    def setEdit(self, view, mode=0):
        """FreeCAD's own ways to edit, such as its dragger for placements, stay."""
        return super().setEdit(view, mode) if mode == 0 else None

    def panel_of(self, obj):
        from .gui.zone_panel import ZonePanel
        return ZonePanel(obj)

    # Drawing

    def _draw(self, zone):
        self._drawing.removeAllChildren()
        for node in _look(_FADED if zone.Suppressed else _COLOUR):
            self._drawing.addChild(node)
        for node in _near(zone) if zone.Kind == size_zone.DISTANCE else _solid(zone):
            self._drawing.addChild(node)


class ViewErrorSizes(View):
    """Proxy of the view. Its class path is stored in documents and never changes."""

    def getIcon(self):
        return view_provider.kept_icon("FeatureMesh_AddSizeZone")


def _look(colour):
    picking, material, hints = coin.SoPickStyle(), coin.SoMaterial(), coin.SoShapeHints()
    picking.style = coin.SoPickStyle.UNPICKABLE   # the part's faces behind it are to be chosen
    material.diffuseColor, material.transparency = colour, _TRANSPARENCY
    hints.vertexOrdering, hints.creaseAngle = coin.SoShapeHints.COUNTERCLOCKWISE, 0.5
    return picking, material, hints


def _solid(zone):
    """A box, sphere or cylinder, filled, and its outline through the part, in the frame of its placement, which FreeCAD applies."""
    move, measures = coin.SoTransform(), [getattr(zone, name).Value for name in size_zone.MEASURES[zone.Kind]]
    if zone.Kind == size_zone.BOX:
        shape = coin.SoCube()
        shape.width, shape.height, shape.depth = measures
        move.translation = [side / 2 for side in measures]
    elif zone.Kind == size_zone.SPHERE:
        shape = coin.SoSphere()
        shape.radius = measures[0]
    else:
        shape = coin.SoCylinder()   # along y
        shape.radius, shape.height = measures
        move.translation = (0, 0, measures[1] / 2)
        move.rotation = coin.SbRotation(coin.SbVec3f(1, 0, 0), math.pi / 2)
    filled = coin.SoSeparator()
    for node in (move, shape):
        filled.addChild(node)
    return filled, _lines(size_zone.outline(zone.Kind, *measures))


def _lines(polylines):
    lines, style, light, places, drawn = coin.SoAnnotation(), coin.SoDrawStyle(), coin.SoLightModel(), coin.SoCoordinate3(), coin.SoLineSet()
    style.lineWidth, light.model = _LINE, coin.SoLightModel.BASE_COLOR
    points = [point for line in polylines for point in line]
    places.point.setValues(0, len(points), points)
    drawn.numVertices.setValues(0, len(polylines), [len(line) for line in polylines])
    for node in (style, light, places, drawn):
        lines.addChild(node)
    return lines


def _near(zone):
    """The faces, edges and vertices from which the distance is measured, where FEM has their nodes."""
    back = zone.Placement.inverse()
    nodes = []
    for obj, names in zone.References or ():
        for name in names:
            shape = obj.getSubObject(name)
            if shape is not None:
                nodes += _drawn(shape, back.multiply(versions.parent_frame(obj)))
    return nodes


def _drawn(shape, back):
    node, offset, style, light = coin.SoAnnotation(), coin.SoPolygonOffset(), coin.SoDrawStyle(), coin.SoLightModel()
    style.lineWidth, style.pointSize, light.model = _THICK_LINE, _POINT, coin.SoLightModel.BASE_COLOR
    offset.factor = offset.units = -1
    if shape.ShapeType == "Face":
        points, triangles = shape.tessellate(max(_DEFLECTION * shape.BoundBox.DiagonalLength, 1e-7))
        drawn = coin.SoIndexedFaceSet()
        indices = [index for triangle in triangles for index in (*triangle, -1)]
        drawn.coordIndex.setValues(0, len(indices), indices)
    elif shape.ShapeType == "Edge":
        points, drawn = shape.discretize(QuasiDeflection=max(_DEFLECTION * shape.Length, 1e-7)), coin.SoLineSet()
    else:
        points, drawn = [shape.Point], coin.SoPointSet()
    places = coin.SoCoordinate3()
    places.point.setValues(0, len(points), [tuple(back.multVec(FreeCAD.Vector(point))) for point in points])
    for child in (offset, style, light, places, drawn):
        node.addChild(child)
    return [node]

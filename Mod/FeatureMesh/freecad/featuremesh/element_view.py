# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws elements in colours in the 3D view, in place of FreeCAD's own drawing of the mesh.

FreeCAD colours elements one by one, which takes minutes for a hundred thousand; here the triangles that can be seen go to Coin as arrays.
"""

import numpy as np
from pivy import coin

_NAME = "FeatureMeshElements"
_EDGES = (0.25, 0.29, 0.33)
_LIGHT = np.array((0.36, -0.48, 0.80))   # where it comes from
_DARKEST = 0.72                          # share of a colour that faces along the light keep
_MARK_SIZE, _MARK_WIDTH = 5, 3


class ElementView:
    """The drawing below the node of one mesh object; nothing is drawn until `show` or `mark`."""

    def __init__(self, root):
        self._root = root
        self._nodes = []          # in the root, while there is something to draw
        self._elements = self._marks = None
        self._overlay = None

    @property
    def overlay(self):
        """What is shown, None where nothing is."""
        return self._overlay

    def show(self, overlay, plane=None, is_filled=False):
        """What an overlays.Overlay, or a live_overlay.FieldOverlay, has to draw, cut open by a section.Plane: whole elements, or with the cut filled."""
        self._overlay = overlay
        self._make_nodes()
        corners, colours = overlay.drawn(plane, is_filled)
        self._elements.removeAllChildren()
        if len(corners):
            for node in _triangle_nodes(corners, colours, overlay.has_edges):
                self._elements.addChild(node)
        self._root.touch()   # Coin shows what it has kept of the last picture otherwise

    def mark(self, points, lines, colour):
        """Draws points, or lines between them, over everything else; none: takes them away."""
        if self._nodes or len(points):
            self._make_nodes()
            self._marks.removeAllChildren()
            if len(points):
                self._marks.addChild(_mark_node(points, lines, colour))
            self._root.touch()

    def end(self):
        """Lets FreeCAD draw again."""
        for node in self._nodes:
            self._root.removeChild(node)
        self._root.touch()
        self.__init__(self._root)

    def _make_nodes(self):
        """Our drawing before FreeCAD's, which the style between makes invisible; it is hidden whenever FreeCAD hides the mesh."""
        if self._nodes:
            return
        index = next(i for i in range(self._root.getNumChildren()) if isinstance(self._root.getChild(i), coin.SoSwitch))
        modes = self._root.getChild(index)
        drawing, self._elements, self._marks = coin.SoSeparator(), coin.SoSeparator(), coin.SoAnnotation()
        for node in (_unpickable(), self._elements, self._marks):
            drawing.addChild(node)
        shown = coin.SoSwitch()
        shown.setName(_NAME)
        for _ in range(modes.getNumChildren()):   # the same for each of FreeCAD's ways to show the mesh
            shown.addChild(drawing)
        shown.whichChild.connectFrom(modes.whichChild)
        instead = coin.SoDrawStyle()
        instead.style = coin.SoDrawStyle.INVISIBLE
        instead.setOverride(True)
        self._nodes = [shown, instead]
        for node in reversed(self._nodes):
            self._root.insertChild(node, index)


def _unpickable():
    style = coin.SoPickStyle()
    style.style = coin.SoPickStyle.UNPICKABLE
    return style


def _triangle_nodes(corners, colours, has_edges):
    """Triangles with a colour each, or one for each corner, then their edges; (k,3,3) mm and (k,3) or (k,3,3). Colours are shaded here, so that they
    are as the legend has them from any side."""
    count = len(corners)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.sqrt(np.einsum("ij,ij->i", normals, normals))
    shades = _DARKEST + (1 - _DARKEST) * np.abs(normals @ _LIGHT) / np.maximum(lengths, np.finfo(float).tiny)
    is_by_face = colours.ndim == 2
    shades = shades[:, None] if is_by_face else shades[:, None, None]
    light, places, faces, binding = coin.SoLightModel(), coin.SoCoordinate3(), coin.SoFaceSet(), coin.SoMaterialBinding()
    light.model = coin.SoLightModel.BASE_COLOR
    binding.value = coin.SoMaterialBinding.PER_FACE if is_by_face else coin.SoMaterialBinding.PER_VERTEX
    places.point.setValues(0, 3 * count, corners.reshape(-1, 3).astype(np.float32))
    faces.numVertices.setValues(0, count, [3] * count)
    material = coin.SoPackedColor()
    material.orderedRGBA.setValues(0, count if is_by_face else 3 * count, _packed(colours * shades).tolist())
    edges = coin.SoSeparator()
    dark, overall, style = coin.SoBaseColor(), coin.SoMaterialBinding(), coin.SoDrawStyle()
    dark.rgb, overall.value = _EDGES, coin.SoMaterialBinding.OVERALL
    style.style, style.lineWidth = coin.SoDrawStyle.LINES, 1
    for node in (dark, overall, style, faces):
        edges.addChild(node)
    filled = coin.SoSeparator()
    for node in (coin.SoPolygonOffset(), material, binding, faces):
        filled.addChild(node)
    return (light, places, filled, edges) if has_edges else (light, places, filled)


def _packed(colours):
    """(...) numbers 0xRRGGBBAA of (...,3) colours, which Coin takes ten times as fast as those."""
    return (np.rint(255 * colours).astype(np.uint32) << np.array((24, 16, 8), np.uint32)).sum(axis=-1, dtype=np.uint32).reshape(-1) | np.uint32(255)


def _mark_node(points, lines, colour):
    node = coin.SoSeparator()
    light, binding, style, base = coin.SoLightModel(), coin.SoMaterialBinding(), coin.SoDrawStyle(), coin.SoBaseColor()
    light.model, binding.value = coin.SoLightModel.BASE_COLOR, coin.SoMaterialBinding.OVERALL
    style.pointSize, style.lineWidth = _MARK_SIZE, _MARK_WIDTH
    base.rgb = colour
    places = coin.SoCoordinate3()
    places.point.setValues(0, len(points), np.asarray(points).tolist())
    drawn = coin.SoPointSet()
    if len(lines):
        drawn = coin.SoIndexedLineSet()
        drawn.coordIndex.setValues(0, len(lines), list(lines))
    for child in (light, binding, style, base, places, drawn):
        node.addChild(child)
    return node

# SPDX-License-Identifier: GPL-3.0-or-later
"""The refinement zone: a document object that asks for a size in a box, a sphere, a cylinder, or near faces, edges and vertices.

It is in the MeshRegionList of its mesh, beside FEM's own refinements. Objects of the same purpose that FreeCAD has itself in later versions
are read, too.
"""

import math

import FreeCAD

from . import versions
from .proxies import HIDDEN, GetsReady, add_missing, type_of

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

BOX, SPHERE = QT_TRANSLATE_NOOP("FeatureMesh", "Box"), QT_TRANSLATE_NOOP("FeatureMesh", "Sphere")
CYLINDER, DISTANCE = QT_TRANSLATE_NOOP("FeatureMesh", "Cylinder"), QT_TRANSLATE_NOOP("FeatureMesh", "Distance")
KINDS = (BOX, SPHERE, CYLINDER, DISTANCE)
# What of the properties below each kind has.
MEASURES = {BOX: ("Length", "Width", "Height"), SPHERE: ("Radius",), CYLINDER: ("Radius", "Height"), DISTANCE: ("Distance",)}
# (type, name, group, default, read-only, tooltip)
PROPERTIES = [
    ("App::PropertyEnumeration", "Kind", "Zone", list(KINDS), False, "Box from a corner, sphere around its centre, cylinder along its axis, or all that is near the references"),
    ("App::PropertyLength", "Length", "Zone", 10.0, False, "Length of the box, along its x axis"),
    ("App::PropertyLength", "Width", "Zone", 10.0, False, "Width of the box, along its y axis"),
    ("App::PropertyLength", "Height", "Zone", 10.0, False, "Height of the box or the cylinder, along its z axis"),
    ("App::PropertyLength", "Radius", "Zone", 5.0, False, "Radius of the sphere or the cylinder"),
    ("App::PropertyLength", "Distance", "Zone", 0.0, False, "How far from the references the inner size reaches"),
    ("App::PropertyLinkSubListGlobal", "References", "Zone", None, False, "Faces, edges and vertices from which the distance is measured"),
    ("App::PropertyLength", "InnerSize", "Size", 1.0, False, "Wanted edge length of the elements inside"),
    ("App::PropertyLength", "OuterSize", "Size", 0.0, False, "Edge length to which it grows outside; 0: the size of the mesh"),
    ("App::PropertyLength", "Transition", "Size", 0.0, False, "Over how much it grows to the outer size; 0: as fast as the mesh's Growth allows"),
    ("App::PropertyBool", "Suppressed", "Zone", False, False, "Leaves the refinement out"),
]
_SHOWN = 0   # of the property editor
_RING = 48   # pieces of a drawn circle
# Called with every zone that was made or opened; the window's side adds its view there.
on_ready = []


class SizeZone(GetsReady):
    """Proxy of the object. Its class path is stored in documents and never changes."""

    Type = "Fem::FeatureMeshSizeZone"

    def execute(self, zone):
        """The mesh reads it."""

    def onChanged(self, zone, name):
        """Called by FreeCAD when a property was set: shows those of the kind alone."""
        if name == "Kind" and "Suppressed" in zone.PropertiesList:   # the last one that is added
            self._show_measures(zone)

    def _get_ready(self, zone):
        add_missing(zone, PROPERTIES)
        self._show_measures(zone)
        for hook in on_ready:
            hook(zone)

    def _show_measures(self, zone):
        own = (*MEASURES[zone.Kind], "References" if zone.Kind == DISTANCE else "Placement")
        for name in ("Length", "Width", "Height", "Radius", "Distance", "References", "Placement"):
            zone.setEditorMode(name, _SHOWN if name in own else HIDDEN)


def add(mesh, kind, inner):
    """A new zone of the mesh object."""
    zone = mesh.Document.addObject("App::GeometryPython", "SizeZone")
    SizeZone(zone)
    zone.Label = translate("FeatureMesh", "Refinement zone")
    zone.Kind, zone.InnerSize = kind, inner
    mesh.MeshRegionList = mesh.MeshRegionList + [zone]
    return zone


def fit_to(zone, part):
    """Puts the zone into the middle of the part, where FEM has its nodes, a quarter as large."""
    box = part.Shape.BoundBox
    side = box.DiagonalLength / 8
    zone.Length = zone.Width = zone.Height = 2 * side
    zone.Radius = side
    zone.Placement = versions.parent_frame(part).multiply(FreeCAD.Placement(box.Center - _middle(zone), FreeCAD.Rotation()))


def change_kind(zone, kind):
    """Another kind around the same middle."""
    before = zone.Placement.multVec(_middle(zone))
    zone.Kind = kind
    turn = zone.Placement.Rotation
    zone.Placement = FreeCAD.Placement(before - turn.multVec(_middle(zone)), turn)


def _middle(zone):
    """In the frame of the zone's placement."""
    height = zone.Height.Value / 2
    return {BOX: FreeCAD.Vector(zone.Length.Value / 2, zone.Width.Value / 2, height), CYLINDER: FreeCAD.Vector(0, 0, height)}.get(zone.Kind, FreeCAD.Vector())


def outline(kind, *measures):
    """Lines that show a box, a sphere or a cylinder of these measures (mm, see MEASURES) in the frame of its placement: lists of (x, y, z)."""
    if kind == BOX:
        x, y, z = measures
        rings = [[(0, 0, at), (x, 0, at), (x, y, at), (0, y, at), (0, 0, at)] for at in (0, z)]
        return rings + [[corner, (*corner[:2], z)] for corner in rings[0][:4]]
    radius = measures[0]
    if kind == SPHERE:
        return [[point[turn:] + point[:turn] for point in _ring(radius, 0)] for turn in range(3)]
    rings = [_ring(radius, at) for at in (0, measures[1])]
    return rings + [[low, high] for low, high in list(zip(*rings))[:_RING:_RING // 4]]


def _ring(radius, z):
    angles = [2 * math.pi * i / _RING for i in range(_RING + 1)]
    return [(radius * math.cos(angle), radius * math.sin(angle), z) for angle in angles]


def is_zone(obj):
    """Is this one of our zones?"""
    return isinstance(getattr(obj, "Proxy", None), SizeZone)


def is_suppressed(refinement):
    """Is a refinement of any kind to be left out?"""
    return bool(getattr(refinement, "Suppressed", False))


def wish_of(obj, names):
    """What the object asks of the engine, a dict (see SizeZone in sizing/size_zone.h), None for a refinement that is no zone.

    `names` are the faces, edges and vertices of the part that its references mean.
    """
    if is_zone(obj):
        return _wish_of_ours(obj, names)
    reader = _FREECADS.get(type_of(obj))
    return reader(obj, names) if reader else None


def _wish_of_ours(zone, names):
    sizes = _sizes(zone, zone.InnerSize, zone.OuterSize, zone.Transition)
    if zone.Kind == DISTANCE:
        return {**sizes, **_near(names, zone.Distance)}
    return {**sizes, **_placed(zone.Kind, versions.frame_of(zone), *(getattr(zone, name).Value for name in MEASURES[zone.Kind]))}


def _sizes(obj, inner, outer, transition):
    return {"name": obj.Label, "inner": float(inner), "outer": float(outer), "transition": float(transition)}


def _near(names, reach):
    return {"shape": "near", "entities": list(names), "reach": float(reach)}


def _placed(kind, placement, *measures):
    named = {BOX: {"sides": list(measures)}, SPHERE: {"radius": measures[0]}, CYLINDER: dict(zip(("radius", "height"), measures))}
    matrix = placement.toMatrix().A   # row by row
    return {"shape": kind.lower(), "rotation": [matrix[4 * i + j] for i in range(3) for j in range(3)], "translation": list(placement.Base), **named[kind]}


def _of_mesh_distance(obj, names):
    """FreeCAD's Fem::MeshDistance."""
    sizes = _sizes(obj, obj.SizeMinimum, obj.SizeMaximum, max(0.0, float(obj.DistanceMaximum) - float(obj.DistanceMinimum)))
    return {**sizes, **_near(names, obj.DistanceMinimum)}


def _of_mesh_shape(obj, names):
    """FreeCAD's Fem::MeshShape: a box or a sphere around its centre. Its cylinder has no length, so it is no zone of ours."""
    sizes = _sizes(obj, obj.SizeIn, obj.SizeOut, obj.Thickness)
    if obj.ShapeType == BOX:
        sides = [float(side) for side in (obj.BoxLength, obj.BoxWidth, obj.BoxHeight)]
        return {**sizes, **_placed(BOX, FreeCAD.Placement(obj.BoxCenter - FreeCAD.Vector(*sides) / 2, FreeCAD.Rotation()), *sides)}
    if obj.ShapeType == SPHERE:
        return {**sizes, **_placed(SPHERE, FreeCAD.Placement(obj.SphereCenter, FreeCAD.Rotation()), float(obj.SphereRadius))}
    return None


_FREECADS = {"Fem::MeshDistance": _of_mesh_distance, "Fem::MeshShape": _of_mesh_shape}

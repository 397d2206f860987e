# SPDX-License-Identifier: GPL-3.0-or-later
"""Documents for the tests, made on the spot."""
import FreeCAD
import Part
import Sketcher
from freecad.featuremesh import export

Vector = FreeCAD.Vector


def new_document(name="Test"):
    """An empty document; the ones of earlier tests are closed first."""
    for known in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(known)
    return FreeCAD.newDocument(name)


def groups_of(mesh):
    """{name: numbers} of the groups that an export of the mesh has."""
    return {name: set(numbers.tolist()) for name, _, numbers in export.groups_of(mesh)}


def groups_in_freecad(mesh):
    """{name: numbers} of those that FreeCAD's mesh has."""
    return {name: set(numbers.tolist()) for name, _, numbers in export.groups_in(mesh.FemMesh)}


def placement(x=0, y=0, z=0, angle=0, axis=(0, 0, 1)):
    return FreeCAD.Placement(Vector(x, y, z), FreeCAD.Rotation(Vector(*axis), angle))


def rectangle(sketch, x, y, width, height):
    """Four lines whose lower left corner and size are the named constraints X, Y, Width, Height."""
    corners = [Vector(x, y), Vector(x + width, y), Vector(x + width, y + height), Vector(x, y + height)]
    for i in range(4):
        sketch.addGeometry(Part.LineSegment(corners[i], corners[(i + 1) % 4]))
    for i in range(4):
        sketch.addConstraint(Sketcher.Constraint("Coincident", i, 2, (i + 1) % 4, 1))
    for i in range(4):
        sketch.addConstraint(Sketcher.Constraint("Horizontal" if i % 2 == 0 else "Vertical", i))
    for name, kind, *places in (("Width", "DistanceX", 0, 1, 0, 2, width), ("Height", "DistanceY", 1, 1, 1, 2, height),
                                ("X", "DistanceX", -1, 1, 0, 1, x), ("Y", "DistanceY", -1, 1, 0, 1, y)):
        sketch.renameConstraint(sketch.addConstraint(Sketcher.Constraint(kind, *places)), name)


def circle(sketch, x, y, radius):
    """A circle with the named constraints X, Y, Radius."""
    sketch.addGeometry(Part.Circle(Vector(x, y), Vector(0, 0, 1), radius))
    for name, kind, *places in (("Radius", "Radius", 0, radius), ("X", "DistanceX", -1, 1, 0, 3, x),
                                ("Y", "DistanceY", -1, 1, 0, 3, y)):
        sketch.renameConstraint(sketch.addConstraint(Sketcher.Constraint(kind, *places)), name)


def plate_with_hole(document, name="Body"):
    """A Body: Plate 60 x 40 x 10 (PlateSketch) and a hole of radius 6 at (20, 20) through it (Hole, HoleSketch)."""
    body = document.addObject("PartDesign::Body", name)
    sketch = body.newObject("Sketcher::SketchObject", "PlateSketch")
    rectangle(sketch, 0, 0, 60, 40)
    pad = body.newObject("PartDesign::Pad", "Plate")
    pad.Profile, pad.Length = sketch, 10
    hole_sketch = body.newObject("Sketcher::SketchObject", "HoleSketch")
    circle(hole_sketch, 20, 20, 6)
    pocket = body.newObject("PartDesign::Pocket", "Hole")
    pocket.Profile, pocket.Type, pocket.Reversed = hole_sketch, "ThroughAll", True
    document.recompute()
    return body

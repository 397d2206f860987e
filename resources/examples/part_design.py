# SPDX-License-Identifier: GPL-3.0-or-later
"""Short ways to draw with PartDesign: sketches of rectangles, circles and polygons whose dimensions are named constraints."""
import math

import FreeCAD as App
import Part
import Sketcher

START, CENTER, ORIGIN = 1, 3, -1


def new_document(name):
    document = App.newDocument(name)
    body = document.addObject("PartDesign::Body", "Body")
    body.Label = name
    return document, body


def add_sketch(body, name, height=0.0):
    """An empty sketch in the body's XY plane, lifted to a height."""
    sketch = body.newObject("Sketcher::SketchObject", name)
    support = "AttachmentSupport" if hasattr(sketch, "AttachmentSupport") else "Support"
    plane = next(plane for plane in body.Origin.OriginFeatures if plane.Name.startswith("XY_Plane"))
    setattr(sketch, support, (plane, [""]))
    sketch.MapMode = "FlatFace"
    sketch.AttachmentOffset = App.Placement(App.Vector(0, 0, height), App.Rotation())
    return sketch


def dimension(sketch, name, *constraint):
    """A named constraint, so that it can be edited as Sketch.NAME."""
    sketch.renameConstraint(sketch.addConstraint(Sketcher.Constraint(*constraint)), name)


def draw_rectangle(sketch, prefix, x, y, length, width):
    """A rectangle with its lower left corner at (x, y): PREFIXX, PREFIXY, PREFIXLength, PREFIXWidth."""
    corners = [(x, y), (x + length, y), (x + length, y + width), (x, y + width)]
    first = draw_closed_polyline(sketch, corners)
    bottom, right, top, left = range(first, first + 4)
    for line, direction in ((bottom, "Horizontal"), (right, "Vertical"), (top, "Horizontal"), (left, "Vertical")):
        sketch.addConstraint(Sketcher.Constraint(direction, line))
    place(sketch, prefix, bottom, START, x, y)
    dimension(sketch, prefix + "Length", "DistanceX", bottom, 1, bottom, 2, length)
    dimension(sketch, prefix + "Width", "DistanceY", right, 1, right, 2, width)


def draw_circle(sketch, prefix, x, y, radius):
    """A circle: PREFIXX, PREFIXY, PREFIXRadius."""
    circle = sketch.addGeometry(Part.Circle(App.Vector(x, y, 0), App.Vector(0, 0, 1), radius), False)
    place(sketch, prefix, circle, CENTER, x, y)
    dimension(sketch, prefix + "Radius", "Radius", circle, radius)


def draw_hexagon(sketch, prefix, x, y, radius):
    """A regular hexagon around (x, y) with its corners on a construction circle: PREFIXX, PREFIXY, PREFIXRadius."""
    circle = sketch.addGeometry(Part.Circle(App.Vector(x, y, 0), App.Vector(0, 0, 1), radius), True)
    angles = [math.radians(60 * i) for i in range(6)]
    first = draw_closed_polyline(sketch, [(x + radius * math.cos(a), y + radius * math.sin(a)) for a in angles])
    for line in range(first, first + 6):
        sketch.addConstraint(Sketcher.Constraint("PointOnObject", line, START, circle))
    for line in range(first + 1, first + 6):
        sketch.addConstraint(Sketcher.Constraint("Equal", first, line))
    sketch.addConstraint(Sketcher.Constraint("Horizontal", circle, CENTER, first, START))
    place(sketch, prefix, circle, CENTER, x, y)
    dimension(sketch, prefix + "Radius", "Radius", circle, radius)


def draw_closed_polyline(sketch, corners):
    """Lines from corner to corner and back; gives the number of the first."""
    ends = zip(corners, corners[1:] + corners[:1])
    lines = [sketch.addGeometry(Part.LineSegment(App.Vector(*a, 0), App.Vector(*b, 0)), False) for a, b in ends]
    for line, following in zip(lines, lines[1:] + lines[:1]):
        sketch.addConstraint(Sketcher.Constraint("Coincident", line, 2, following, 1))
    return lines[0]


def place(sketch, prefix, geometry, point, x, y):
    for axis, value in (("X", x), ("Y", y)):
        if value:
            dimension(sketch, prefix + axis, "Distance" + axis, ORIGIN, 1, geometry, point, value)
        else:
            # A distance of zero has no side, so the point is put on the axis.
            axis_line = -2 if axis == "X" else -1
            sketch.addConstraint(Sketcher.Constraint("PointOnObject", geometry, point, axis_line))


def add_feature(body, kind, name):
    """A feature that leaves its faces as its operation made them, whatever the running FreeCAD does by default."""
    feature = body.newObject("PartDesign::" + kind, name)
    feature.Refine = False
    return feature


def pad(body, name, sketch, length):
    feature = add_feature(body, "Pad", name)
    feature.Profile = sketch
    feature.Length = length
    return feature


def pocket_through(body, name, sketch, upwards=True):
    """A pocket through all; upwards for a sketch that lies under the material."""
    feature = add_feature(body, "Pocket", name)
    feature.Profile = sketch
    feature.Type = "ThroughAll"
    feature.Reversed = upwards
    return feature


def edges_where(shape, test):
    """Names of the edges (Edge1, ...) for which the test holds."""
    return [f"Edge{i}" for i, edge in enumerate(shape.Edges, 1) if test(edge)]

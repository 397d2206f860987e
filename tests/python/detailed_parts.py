# SPDX-License-Identifier: GPL-3.0-or-later
"""Random parts with details of a millionth to a hundredth of their size: what booleans, imports and careless sketches leave behind."""
import math

import FreeCAD
import Part

Vector = FreeCAD.Vector
SMALLEST, LARGEST = 1e-6, 1e-2    # of a detail, in diagonals of the part


def detailed_part(chance):
    """A solid of random shape with one to three details, somewhere in space, and its making in words. Draws again until the kernel calls it valid."""
    while True:
        words, shape = chance.choice(BASES)(chance)
        made = [words]
        for _ in range(chance.randint(1, 3)):
            detail = shape.BoundBox.DiagonalLength * 10 ** chance.uniform(math.log10(SMALLEST), math.log10(LARGEST))
            kind = chance.choice(DETAILS)
            try:
                changed = kind(chance, shape, detail)
            except Exception:    # whatever FreeCAD raises where the kernel cannot do it
                continue
            if _is_sound(changed) and 0.5 * shape.Volume < changed.Volume < 2 * shape.Volume:
                shape = changed.Solids[0]
                made.append("%s %.2g" % (kind.__name__.strip("_"), detail))
        if len(made) > 1:
            if chance.random() < 0.5:
                shape = shape.copy()
                shape.Placement = FreeCAD.Placement(Vector(*(chance.uniform(-50, 50) for _ in range(3))),
                                                    FreeCAD.Rotation(_direction(chance), chance.uniform(0, 180)))
            return shape, ", ".join(made)


def _is_sound(shape):
    return len(shape.Solids) == 1 and shape.isValid() and shape.Solids[0].isClosed() and shape.Solids[0].Volume > 0


def _direction(chance):
    return Vector(*(chance.gauss(0, 1) for _ in range(3)))


def _block(chance):
    sides = [chance.uniform(15, 100) for _ in range(3)]
    return "block", Part.makeBox(*sides)


def _shaft(chance):
    return "shaft", Part.makeCylinder(chance.uniform(10, 30), chance.uniform(20, 90))


def _tube(chance):
    radius, height = chance.uniform(15, 30), chance.uniform(20, 80)
    return "tube", Part.makeCylinder(radius, height).cut(Part.makeCylinder(chance.uniform(0.4, 0.8) * radius, height)).Solids[0]


def _bracket(chance):
    length, width, height, wall = chance.uniform(40, 90), chance.uniform(20, 50), chance.uniform(30, 70), chance.uniform(6, 14)
    return "bracket", Part.makeBox(length, width, wall).fuse(Part.makeBox(wall, width, height)).removeSplitter().Solids[0]


def _cone(chance):
    radius = chance.uniform(15, 35)
    return "cone", Part.makeCone(radius, chance.uniform(0.3, 0.8) * radius, chance.uniform(20, 60))


def _plate(chance):
    length, width, height = chance.uniform(50, 100), chance.uniform(40, 80), chance.uniform(5, 12)
    plate = Part.makeBox(length, width, height)
    for x in (0.25, 0.7):
        plate = plate.cut(Part.makeCylinder(chance.uniform(4, 9), height, Vector(x * length, chance.uniform(0.3, 0.7) * width, 0)))
    return "plate", plate.Solids[0]


BASES = [_block, _shaft, _tube, _bracket, _cone, _plate]


def _edge(chance, shape):
    return chance.choice([edge for edge in shape.Edges if not edge.Degenerated and edge.Length > 0.05 * shape.BoundBox.DiagonalLength])


def _chamfer(chance, shape, detail):
    return shape.makeChamfer(detail, [_edge(chance, shape)])


def _fillet(chance, shape, detail):
    return shape.makeFillet(detail, [_edge(chance, shape)])


def _at_top(chance, shape):
    """A place on the top of the shape's box, and a width there."""
    box = shape.BoundBox
    return box, Vector(box.XMin + chance.uniform(0.2, 0.6) * box.XLength, box.YMin + chance.uniform(0.2, 0.6) * box.YLength, box.ZMax), \
        chance.uniform(0.1, 0.3) * box.DiagonalLength


def _step_up(chance, shape, detail):
    """A pad as low as the detail, which begins inside the part."""
    box, at, width = _at_top(chance, shape)
    depth = 0.1 * box.ZLength
    return shape.fuse(Part.makeBox(width, width, depth + detail, at - Vector(0, 0, depth)).common(
        Part.makeBox(box.XLength, box.YLength, 2 * box.ZLength, Vector(box.XMin, box.YMin, box.ZMin))))


def _step_down(chance, shape, detail):
    box, at, width = _at_top(chance, shape)
    return shape.cut(Part.makeBox(10 * width, width, 2 * detail, at - Vector(chance.choice([0, 5 * width]), 0, detail)))


def _hole_near_face(chance, shape, detail):
    """A hole that leaves a wall as thin as the detail before the box's side, or cuts it open by as much."""
    box, _, width = _at_top(chance, shape)
    radius = 0.3 * width
    off = radius + chance.choice([1, -1]) * detail
    return shape.cut(Part.makeCylinder(radius, 3 * box.ZLength, Vector(box.XMin + chance.uniform(0.3, 0.7) * box.XLength, box.YMin + off,
                                                                      box.ZMin - box.ZLength)))


def _bottom_near_face(chance, shape, detail):
    """A blind hole whose bottom is a detail above the part's."""
    box, at, width = _at_top(chance, shape)
    return shape.cut(Part.makeCylinder(0.3 * width, 2 * box.ZLength, Vector(at.x, at.y, box.ZMin + detail)))


def _two_holes(chance, shape, detail):
    """Two holes with a wall between them as thin as the detail, or a slit between them as wide."""
    box, at, width = _at_top(chance, shape)
    first, second = 0.2 * width, 0.2 * width * chance.uniform(0.6, 1.5)
    off = first + second + chance.choice([1, -1]) * detail
    low = Vector(at.x, at.y, box.ZMin - box.ZLength)
    holes = [Part.makeCylinder(first, 3 * box.ZLength, low), Part.makeCylinder(second, 3 * box.ZLength, low + Vector(off, 0, 0))]
    return shape.cut(holes[0]).cut(holes[1])


def _slit(chance, shape, detail):
    box, at, width = _at_top(chance, shape)
    return shape.cut(Part.makeBox(width, detail, 0.5 * box.ZLength, at - Vector(0, 0, 0.4 * box.ZLength)))


def _groove(chance, shape, detail):
    """All the way across."""
    box, at, _ = _at_top(chance, shape)
    return shape.cut(Part.makeBox(3 * box.XLength, detail, 2 * detail, Vector(box.XMin - box.XLength, at.y, box.ZMax - detail)))


def _pin(chance, shape, detail):
    box, at, _ = _at_top(chance, shape)
    return shape.fuse(Part.makeCylinder(detail, 0.1 * box.ZLength + 3 * detail, at - Vector(0, 0, 0.1 * box.ZLength)))


def _drill(chance, shape, detail):
    box, at, _ = _at_top(chance, shape)
    return shape.cut(Part.makeCylinder(detail, 6 * detail, at - Vector(0, 0, 3 * detail)))


def _tangent_boss(chance, shape, detail):
    """A round boss whose side ends a detail before or beyond the box's side, or exactly there."""
    box, _, width = _at_top(chance, shape)
    radius = 0.3 * width
    off = radius + chance.choice([1, -1, 0]) * detail
    return shape.fuse(Part.makeCylinder(radius, 0.4 * box.ZLength, Vector(box.XMin + chance.uniform(0.3, 0.7) * box.XLength, box.YMin + off,
                                                                         box.ZMax - 0.2 * box.ZLength)))


def _offset_block(chance, shape, detail):
    """A block against the part, all but flush with its sides."""
    box = shape.BoundBox
    dx, dy = (chance.choice([1, -1, 0]) * detail for _ in range(2))
    return shape.fuse(Part.makeBox(box.XLength, box.YLength, 0.3 * box.ZLength, Vector(box.XMin + dx, box.YMin + dy, box.ZMax - 0.1 * box.ZLength)))


def _wedge(chance, shape, detail):
    """The top cut off askew, by the detail at one side and by nothing at the other."""
    box = shape.BoundBox
    knife = Part.makeBox(3 * box.XLength, 3 * box.YLength, box.ZLength, Vector(-1.5 * box.XLength, -box.YLength, 0))
    knife.Placement = FreeCAD.Placement(Vector(box.Center.x, box.YMin, box.ZMax),
                                        FreeCAD.Rotation(Vector(1, 0, 0), -math.degrees(math.atan2(detail, box.YLength))))
    return shape.cut(knife)


def _cavity(chance, shape, detail):
    """A ball inside the part a detail below its top, or open to it by as much."""
    box, at, width = _at_top(chance, shape)
    radius = min(0.4 * width, 0.3 * box.ZLength)
    return shape.cut(Part.makeSphere(radius, at - Vector(0, 0, radius + chance.choice([1, -1]) * detail)))


def _askew_bore(chance, shape, detail):
    """Two bores along each other, almost of one radius and almost of one axis: a rim of slivers."""
    box, at, width = _at_top(chance, shape)
    radius = 0.25 * width
    low = Vector(at.x, at.y, box.ZMin - box.ZLength)
    once = shape.cut(Part.makeCylinder(radius, 3 * box.ZLength, low))
    return once.cut(Part.makeCylinder(radius, 0.5 * box.ZLength, Vector(at.x + detail, at.y, box.ZMax - 0.4 * box.ZLength)))


DETAILS = [_chamfer, _fillet, _step_up, _step_down, _hole_near_face, _bottom_near_face, _two_holes, _slit, _groove, _pin, _drill, _tangent_boss,
           _offset_block, _wedge, _cavity, _askew_bore]

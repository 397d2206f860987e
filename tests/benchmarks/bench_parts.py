# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts that are made for the benchmarks only; run in FreeCAD."""
import FreeCAD as App


def make(name):
    """The document called plate_COUNT (holes in a square plate) or bosses_COUNT (bosses on a plate of fixed size)."""
    kind, count = name.rsplit("_", 1)
    side = round(int(count) ** 0.5)
    document = App.newDocument(name)
    if kind == "plate":
        plate, round_parts = make_plate(document, side)
        operation, base = "Part::Cut", plate
    else:
        plate, round_parts = make_bosses(document, side)
        operation, base = "Part::MultiFuse", plate
    result = document.addObject(operation, "Plate")
    if operation == "Part::Cut":
        holes = document.addObject("Part::Compound", "Holes")
        holes.Links = round_parts
        result.Base, result.Tool = base, holes
    else:
        result.Shapes = [base, *round_parts]
    document.recompute()
    return document


def make_plate(document, side):
    """260 x 260 x 10 mm with side x side holes of radius 3."""
    block = add_block(document, 260, 260, 10)
    pitch = 260 / side
    return block, [add_cylinder(document, f"Hole{i}", 3, 10, ((i % side + 0.5) * pitch, (i // side + 0.5) * pitch, 0))
                   for i in range(side * side)]


def make_bosses(document, side):
    """120 x 120 x 10 mm with side x side bosses of radius 5 and height 12."""
    block = add_block(document, 120, 120, 10)
    pitch = 120 / side
    return block, [add_cylinder(document, f"Boss{i + 1}", 5, 12, ((i % side + 0.5) * pitch, (i // side + 0.5) * pitch, 10))
                   for i in range(side * side)]


def add_block(document, length, width, height):
    block = document.addObject("Part::Box", "Block")
    block.Length, block.Width, block.Height = length, width, height
    return block


def add_cylinder(document, name, radius, height, base):
    cylinder = document.addObject("Part::Cylinder", name)
    cylinder.Radius, cylinder.Height = radius, height
    cylinder.Placement.Base = App.Vector(*base)
    return cylinder

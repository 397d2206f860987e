# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts that are made for the benchmarks only; run in FreeCAD."""
import FreeCAD as App


def make(name):
    """The document called plate_COUNT (holes in a square plate), bosses_COUNT (bosses on a plate of fixed size), features_COUNT (bosses and holes in a
    long plate), walls_LENGTH (an open box) or rod_LENGTH."""
    kind, count = name.rsplit("_", 1)
    if kind in ("walls", "rod"):
        document = App.newDocument(name)
        (make_walls if kind == "walls" else make_rod)(document, int(count))
        document.recompute()
        return document
    side = round(int(count) ** 0.5)
    document = App.newDocument(name)
    if kind == "plate":
        base, round_parts = make_plate(document, side)
        operation = "Part::Cut"
    elif kind == "features":
        base, round_parts = make_features(document, int(count))
        operation = "Part::Cut"
    else:
        base, round_parts = make_bosses(document, side)
        operation = "Part::MultiFuse"
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


def make_features(document, count):
    """A plate 150 mm wide with `count` features including itself: every third a boss, the others holes, 10 mm apart."""
    rows = -(-count // 15)
    plate = add_block(document, 150, 10 * rows, 5)
    bosses, holes = [plate], []
    for i in range(count - 1):
        x, y = 10 * (i % 15) + 5, 10 * (i // 15) + 5
        if i % 3:
            holes.append(add_cylinder(document, f"Hole{i}", 2.5, 5, (x, y, 0)))
        else:
            bosses.append(add_box(document, f"Boss{i}", (4, 4, 6), (x - 2, y - 2, 5)))
    fusion = document.addObject("Part::MultiFuse", "Bosses")
    fusion.Shapes = bosses
    return fusion, holes


def add_block(document, length, width, height):
    return add_box(document, "Block", (length, width, height), (0, 0, 0))


def add_box(document, name, size, base):
    box = document.addObject("Part::Box", name)
    box.Length, box.Width, box.Height = size
    box.Placement.Base = App.Vector(*base)
    return box


def add_cylinder(document, name, radius, height, base):
    cylinder = document.addObject("Part::Cylinder", name)
    cylinder.Radius, cylinder.Height = radius, height
    cylinder.Placement.Base = App.Vector(*base)
    return cylinder


def make_walls(document, length):
    """A box of `length` in x, 0.8 of it in y and 0.6 in z, open above, with walls of 1 mm."""
    width, height = round(0.8 * length), round(0.6 * length)
    walls = document.addObject("Part::Cut", "Part")
    walls.Base = add_block(document, length, width, height)
    walls.Tool = add_box(document, "Inside", (length - 2, width - 2, height), (1, 1, 1))


def make_rod(document, length):
    """1 x 1 mm across, along x."""
    add_box(document, "Part", (length, 1, 1), (0, 0, 0))

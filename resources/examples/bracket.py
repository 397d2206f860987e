# SPDX-License-Identifier: GPL-3.0-or-later
"""A bracket: plate with boss, bore, six holes, a rib block and a fillet at the boss's foot, in PartDesign."""
import part_design as draw
from analysis import add_analysis

HOLES = [(x, y) for x in (10, 110) for y in (10, 40, 70)]
THICKNESS, BOSS_RADIUS = 15, 18


def make():
    document, body = draw.new_document("bracket")
    plate = draw.add_sketch(body, "PlateSketch")
    draw.draw_rectangle(plate, "Plate", 0, 0, 120, 80)
    draw.pad(body, "Plate", plate, THICKNESS)
    boss = draw.add_sketch(body, "BossSketch", THICKNESS)
    draw.draw_circle(boss, "Boss", 40, 40, BOSS_RADIUS)
    draw.pad(body, "Boss", boss, 30)
    rib = draw.add_sketch(body, "RibSketch", THICKNESS)
    draw.draw_rectangle(rib, "Rib", 75, 30, 25, 20)
    draw.pad(body, "Rib", rib, 20)
    bore = draw.add_sketch(body, "BoreSketch")
    draw.draw_circle(bore, "Bore", 40, 40, 10)
    draw.pocket_through(body, "Bore", bore)
    holes = draw.add_sketch(body, "HoleSketch")
    for number, (x, y) in enumerate(HOLES, 1):
        draw.draw_circle(holes, f"Hole{number}", x, y, 4)
    last = draw.pocket_through(body, "Holes", holes)
    document.recompute()
    fillet = draw.add_feature(body, "Fillet", "Fillet")
    fillet.Base = (last, draw.edges_where(last.Shape, is_boss_foot))
    fillet.Radius = 3
    document.recompute()
    add_analysis(document, body, fixed_at=[(120, 5, 7)], force_at=(26, 40, 45), force_newton=2000)
    document.recompute()
    return document


def is_boss_foot(edge):
    return edge.Closed and abs(edge.CenterOfMass.z - THICKNESS) < 1e-6 and abs(edge.Curve.Radius - BOSS_RADIUS) < 1e-6

# SPDX-License-Identifier: GPL-3.0-or-later
"""A pipe flange as a tree of Part primitives and booleans, with its bolt circle as a polar array."""
import FreeCAD as App
import Draft
from analysis import add_analysis


def make():
    document = App.newDocument("csg_flange")
    disk = add_cylinder(document, "Disk", 60, 14)
    hub = add_cylinder(document, "Hub", 32, 50)
    collar = document.addObject("Part::Cone", "Collar")
    collar.Radius1, collar.Radius2, collar.Height = 42, 32, 14
    collar.Placement.Base = App.Vector(0, 0, 14)
    solid = document.addObject("Part::MultiFuse", "Solid")
    solid.Shapes, solid.Refine = [disk, collar, hub], False
    bore = add_cylinder(document, "Bore", 24, 50)
    bored = document.addObject("Part::Cut", "Bored")
    bored.Base, bored.Tool, bored.Refine = solid, bore, False
    bolt = add_cylinder(document, "Bolt", 5, 14)
    bolt.Placement.Base = App.Vector(50, 0, 0)
    document.recompute()
    circle = Draft.make_polar_array(bolt, number=6, angle=360, center=App.Vector(0, 0, 0), use_link=False)
    circle.Label = "BoltCircle"
    flange = document.addObject("Part::Cut", "Flange")
    flange.Base, flange.Tool, flange.Refine = bored, circle, False
    document.recompute()
    add_analysis(document, flange, fixed_at=[(56, 10, 0)], force_at=(28, 0, 50), force_newton=20000)
    document.recompute()
    return document


def add_cylinder(document, name, radius, height):
    cylinder = document.addObject("Part::Cylinder", name)
    cylinder.Radius, cylinder.Height = radius, height
    return cylinder

# SPDX-License-Identifier: GPL-3.0-or-later
"""A base block with a cylinder on top that moves by its placement (Cylinder.Placement.Base.x)."""
import FreeCAD as App
import part_design as draw
from analysis import add_analysis


def make():
    document, body = draw.new_document("block_and_cylinder")
    block = draw.add_feature(body, "AdditiveBox", "Block")
    block.Length, block.Width, block.Height = 80, 50, 20
    cylinder = draw.add_feature(body, "AdditiveCylinder", "Cylinder")
    cylinder.Radius, cylinder.Height = 12, 40
    cylinder.Placement = App.Placement(App.Vector(25, 25, 20), App.Rotation())
    document.recompute()
    add_analysis(document, body, fixed_at=[(5, 5, 0)], force_at=(25, 25, 60), force_newton=5000)
    document.recompute()
    return document

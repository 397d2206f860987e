# SPDX-License-Identifier: GPL-3.0-or-later
"""The benchmark's cases: a part, an edit, an edge length in mm."""
from dataclasses import dataclass


@dataclass(frozen=True)
class Case:
    name: str
    part: str            # a document of resources/examples, or a maker of bench_parts.py
    final: str           # name of the object that is meshed
    edit: tuple          # assignments as for `featuremesh update --set`, none for an unchanged part
    size: float
    after: str = ""      # the document with the edited part, where an edit is more than assignments
    about: str = ""


CASES = (
    Case("bracket", "bracket", "Body", ("HoleSketch.Hole6X=105",), 1.5, about="one hole moved by 5 mm"),
    Case("bracket-fine", "bracket", "Body", ("HoleSketch.Hole6X=105",), 0.9, about="one hole moved by 5 mm"),
    Case("bracket-finest", "bracket", "Body", ("HoleSketch.Hole6X=105",), 0.63, about="one hole moved by 5 mm, five million tets"),
    Case("bracket-diameter", "bracket", "Body", ("HoleSketch.Hole1Radius=5",), 1.5, about="one hole's radius 4 to 5"),
    Case("bracket-longer", "bracket", "Body", ("PlateSketch.PlateLength=130",), 1.5, about="the plate 10 mm longer at one end"),
    Case("bracket-unchanged", "bracket", "Body", (), 1.5, about="no change at all"),
    Case("cylinder", "block_and_cylinder", "Body", ("Cylinder.Placement.Base.x=35",), 1.5, about="the cylinder moved by 10 mm"),
    Case("stiffener", "tool", "Body", (), 1.2, after="tool_with_stiffener", about="a stiffener added"),
    Case("flange", "csg_flange", "Flange", ("Bolt.Radius=5.5",), 3.0, about="the six bolt holes wider"),
    Case("plate-625", "plate_625", "Plate", ("Hole312.Radius=3.5",), 1.46, about="one of 625 holes changed"),
    *(Case(f"bosses-{count}", f"bosses_{count}", "Plate", ("Boss1.Radius=6",), 2.0, about=f"one of {count} bosses changed")
      for count in (1, 4, 16, 64)),
    *(Case(f"features-{count}", f"features_{count}", "Plate", ("Hole61.Placement.Base.x=16.5",), 4.0, about=f"one of {count} features moved by 1.5 mm")
      for count in (150, 600)),
)


def named(name):
    return next((case for case in CASES if case.name == name), None)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Solves an analysis with CalculiX, through FreeCAD's own tools, for scripts."""

from dataclasses import dataclass, field

import FreeCAD

from . import analyses, reading, solve_guard
from .user_words import in_words


@dataclass
class Solution:
    """What solving an analysis gave."""
    result: object                               # FreeCAD's result object; with several steps or modes, the last
    figures: dict = field(default_factory=dict)  # displacement (mm), stress (MPa, von Mises), temperature (K): largest values, as far as there are any


def solve(analysis):
    """Solves `analysis` with its CalculiX solver, which it gets if it has none. Throws UserError when something is missing or CalculiX fails."""
    from . import calculix   # FreeCAD's tools for CalculiX take a while to load
    analyses.refuse_other(analysis)
    solve_guard.refuse(analysis)
    with calculix.solved(analysis) as run:
        result = calculix.read_by_freecad(run.tools, analysis)
    for remark in run.remarks + calculix.has_flown(analysis, run.solver):
        FreeCAD.Console.PrintMessage("%s: %s\n" % (reading.describe(analysis), in_words(remark)))
    return Solution(result, figures_of(result))


def figures_of(result):
    """Largest values of a result."""
    figures = {}
    if len(result.DisplacementVectors):
        figures["displacement"] = max(vector.Length for vector in result.DisplacementVectors)
    for name, values in (("stress", result.vonMises), ("temperature", result.Temperature)):
        if len(values):
            figures[name] = max(values)
    return figures

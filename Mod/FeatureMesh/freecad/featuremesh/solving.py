# SPDX-License-Identifier: GPL-3.0-or-later
"""Solves an analysis with CalculiX, through FreeCAD's own tools, for scripts."""

import contextlib
import sys
import tempfile
from dataclasses import dataclass, field

import FreeCAD
import ObjectsFem

from . import analyses, reading, solve_guard, solvers, statics_model
from .errors import UserError
from .messages import said
from .proxies import type_of
from .user_words import in_words

_TYPES = ("Fem::SolverCcxTools", "Fem::SolverCalculiX")   # the second one since 1.1


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
    calculix.program()   # refuses before anything is changed
    calculix.refuse_free_motions(calculix.as_arrays(analysis))
    solver = solver_of(analysis)
    tools = calculix.ccxtools.FemToolsCcx(analysis, solver, test_mode=False)
    with tempfile.TemporaryDirectory(prefix="featuremesh-") as folder, contextlib.redirect_stdout(sys.__stderr__):   # FreeCAD's tools print what they write
        calculix.write_input(tools, folder, analysis)
        if calculix.run(tools):
            complaints = [line.strip() for line in tools.ccx_stdout.splitlines() if "ERROR" in line.upper()] or [said("it says nothing of why")]
            raise UserError(said("CalculiX could not solve {analysis:text}: {why:messages}", analysis=reading.describe(analysis), why=complaints[0]))
        tools.load_results()
    for remark in solvers.remarks(analysis, solver):
        FreeCAD.Console.PrintMessage("%s: %s\n" % (reading.describe(analysis), in_words(remark)))
    result = last_result(analysis)
    if result is None:
        raise UserError(said("CalculiX gave no result for {analysis:text}", analysis=reading.describe(analysis)))
    return Solution(result, figures_of(result))


def last_result(analysis):
    """CalculiX's result object that came last, None where there is none. FreeCAD removes all of them before, and recomputes afterwards: a live result of the analysis
    then makes its own anew, behind those."""
    of_live = [member.Result for member in analysis.Group if type_of(member) == statics_model.LIVE_RESULT]
    return next((member for member in reversed(analysis.Group) if member.isDerivedFrom("Fem::FemResultObject") and member not in of_live), None)


def solver_of(analysis):
    """The CalculiX solver that is meant, or a new one where FreeCAD's own tools can run none. Throws UserError."""
    if not any(type_of(solver) in _TYPES for solver in solvers.of_calculix(analysis)):
        return add_solver(analysis)
    return solvers.for_calculix(analysis)


def add_solver(analysis):
    """A new CalculiX solver for linear statics in the analysis."""
    make = getattr(ObjectsFem, "makeSolverCalculiXCcxTools", None) or ObjectsFem.makeSolverCalculixCcxTools
    solver = make(analysis.Document, "CalculiX")
    solver.GeometricalNonlinearity = "linear"
    solver.ThermoMechSteadyState = solver.IterationsControlParameterTimeUse = False
    analysis.addObject(solver)
    return solver


def figures_of(result):
    """Largest values of a result."""
    figures = {}
    if len(result.DisplacementVectors):
        figures["displacement"] = max(vector.Length for vector in result.DisplacementVectors)
    for name, values in (("stress", result.vonMises), ("temperature", result.Temperature)):
        if len(values):
            figures[name] = max(values)
    return figures

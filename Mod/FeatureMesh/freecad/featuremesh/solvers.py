# SPDX-License-Identifier: GPL-3.0-or-later
"""Which of the solver objects of an analysis is meant where nobody has selected one."""

from femtools import femutils

from .errors import UserError
from .messages import said
from .reading import describe

_LINEAR_STATICS = (("AnalysisType", "static"), ("GeometricalNonlinearity", "linear"), ("MaterialNonlinearity", "linear"))


def of_calculix(analysis):
    """Its CalculiX solvers that are not suppressed, of every kind that FreeCAD has."""
    return [member for member in analysis.Group if hasattr(member, "AnalysisType") and not getattr(member, "Suppressed", False)]


def beyond_linear_statics(solver):
    """(property, value) by which a solver asks for more than linear statics; None where it does not."""
    for name, value in _LINEAR_STATICS:
        found = getattr(solver, name, value)
        if isinstance(found, bool):   # a switch since FreeCAD 1.1
            found = "nonlinear" if found else "linear"
        if found != value:
            return name, str(found)
    return None


def for_linear_statics(analysis):
    """The first CalculiX solver that asks for linear statics, or the first of all; None where there is none. What else linear solvers say makes no difference."""
    found = of_calculix(analysis)
    return next((solver for solver in found if beyond_linear_statics(solver) is None), found[0] if found else None)


def for_calculix(analysis):
    """The CalculiX solver to run, None where there is none. As in FreeCAD that of ccxtools, where there are others beside it, and of several the one for statics.
    Throws UserError where that leaves several."""
    found = of_calculix(analysis)
    for is_meant in (lambda solver: femutils.is_of_type(solver, "Fem::SolverCcxTools"), lambda solver: solver.AnalysisType == "static"):
        if len(found) > 1:
            found = list(filter(is_meant, found)) or found
    if len(found) > 1:
        raise UserError(said("the analysis {analysis:text} has several CalculiX solvers that may be meant, leave one of them in it: {solvers:text}",
                             analysis=describe(analysis), solvers=", ".join(map(describe, found))))
    return found[0] if found else None


def remarks(analysis, solver):
    """Says which of several was taken."""
    others = [other for other in of_calculix(analysis) if other is not solver]
    if not others:
        return []
    return [said("solved as {solver:text} asks, not {others:text}", solver=describe(solver), others=", ".join(map(describe, others)))]

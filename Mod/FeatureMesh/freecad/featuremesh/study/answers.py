# SPDX-License-Identifier: GPL-3.0-or-later
"""What the finished cases of a study say: which parameter matters how much, compromises between responses, the best case."""

from dataclasses import dataclass

import numpy as np

from ..errors import UserError
from ..messages import said
from . import surface
from .database import DONE
from .expressions import Expression, Limit

_SAME = 1e-9      # of values: what differs less is the same
_SAMPLES = 2048   # a power of two: points of the Sobol' sequence


@dataclass
class Data:
    """The finished cases as arrays."""
    study: object
    cases: list
    names: list                # as the parameters that were varied are shown
    points: np.ndarray         # (n,k) coded: -1 lowest, 1 highest
    limits: list               # (lowest, highest) of each; of words their numbers in the list of values

    def values(self, response):
        """(n,)."""
        return np.array([case.responses[response] for case in self.cases])


@dataclass
class Effects:
    """How one response depends on each parameter, by its surface."""
    response: str
    surface: surface.Surface
    main: np.ndarray     # (k,) mean change of the response from a parameter's lowest to its highest value
    first: np.ndarray    # (k,) Sobol' indices of first order
    total: np.ndarray    # (k,) total indices


def data_of(folder):
    """The finished cases. Throws UserError when there are none."""
    study, cases = folder.study(), folder.database.cases(DONE)
    if not cases:
        raise UserError(said("the study in {folder:text} has no finished case yet", folder=folder.path))
    columns, limits, names = [], [], []
    for parameter in study.parameters:
        column = np.array(_numbers(parameter, [case.parameters[parameter.name] for case in cases]))
        if column.min() < column.max():
            names.append(parameter.title)
            limits.append((float(column.min()), float(column.max())))
            columns.append(2 * (column - column.min()) / (column.max() - column.min()) - 1)
    return Data(study, cases, names, np.column_stack(columns) if columns else np.zeros((len(cases), 0)), limits)


def _numbers(parameter, values):
    """Of words their places in the list of values; those of the document or of somebody's rows that are not in it come after it."""
    words = list(dict.fromkeys([*parameter.values, *values]))
    return [float(words.index(value)) if isinstance(value, str) else float(value) for value in values]


def effects(data, response):
    """The response's Effects, or None where there are too few cases for a surface."""
    values = data.values(response)
    fitted = surface.fit(data.points, values) if data.names else None
    if fitted is None:
        return None
    if are_the_same(values):
        none = np.zeros(len(data.names))
        return Effects(response, fitted, none, none, none)
    main = np.array([_main_effect(fitted, column, len(data.names)) for column in range(len(data.names))])
    return Effects(response, fitted, main, *sobol_indices(fitted.predict, len(data.names)))


def are_the_same(values):
    """Do they differ by no more than what solving leaves?"""
    return np.ptp(values) <= _SAME * np.abs(values).max()


def _main_effect(fitted, column, count):
    low = _points(count)[:_SAMPLES]
    high = low.copy()
    low[:, column], high[:, column] = -1, 1
    return float(fitted.predict(high).mean() - fitted.predict(low).mean())


def sobol_indices(function, count):
    """(first, total), (k,) each, of a function of points in [-1, 1]^k: Saltelli's (2010) and Jansen's (1999) estimators."""
    both = _points(2 * count)
    one, other = both[:, :count], both[:, count:]
    at_one, at_other = function(one), function(other)
    variance = np.concatenate([at_one, at_other]).var()
    if variance <= 0:
        return np.zeros(count), np.zeros(count)
    first, total = np.empty(count), np.empty(count)
    for column in range(count):
        mixed = one.copy()
        mixed[:, column] = other[:, column]
        at_mixed = function(mixed)
        first[column] = (at_other * (at_mixed - at_one)).mean() / variance
        total[column] = ((at_one - at_mixed) ** 2).mean() / 2 / variance
    return first, total


def _points(count):
    from scipy.stats import qmc   # takes a second to load
    return 2 * qmc.Sobol(count, scramble=True, seed=1).random(_SAMPLES) - 1


def pareto(data, first, second):
    """The cases that no other case beats in both responses, the less the better; by the first response."""
    order = sorted(data.cases, key=lambda case: (case.responses[first], case.responses[second], case.id))
    front, best = [], np.inf
    for case in order:
        if case.responses[second] < best:
            front.append(case)
            best = case.responses[second]
    return front


def best(data, goal, limits=()):
    """The case with the least value of the expression `goal` among those that keep all `limits`, or None. Throws UserError."""
    objective, kept = Expression(goal, said("the goal")), [Limit(text) for text in limits]
    allowed = [case for case in data.cases if all(limit.is_kept(all_values(case)) for limit in kept)]
    return min(allowed, key=lambda case: objective.value(all_values(case)), default=None)


def all_values(case):
    """{name: value} of a case's parameters and responses."""
    return {**case.parameters, **case.responses}

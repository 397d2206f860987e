# SPDX-License-Identifier: GPL-3.0-or-later
"""Looks for the best case: surfaces through all finished cases are minimised, the point found becomes a case, and so on.

The cases of the study before count, too, and every evaluation is a case of the study; so an optimisation that was ended goes on where it was.
"""

import math
from dataclasses import dataclass

import numpy as np

from ..errors import UserError
from ..messages import said
from . import answers, planning, surface
from .database import DONE, FAILED, INFEASIBLE
from .expressions import Expression, Limit

_SAME_POINT = 2e-3     # of a parameter's range: a point as near to a case is that case
_DIGITS = 4            # of the range that a proposed value is rounded to
_PENALTY = 1e3         # times the objective's spread, for a limit that is broken by all of its right side
_MARGIN = 1e-3         # by which surfaces have to keep a limit, so that cases do
_ROUNDS_WITHOUT_GAIN = 4
_POINTS_FOR_ONE = 16   # looked at for each that is solved


@dataclass
class Found:
    """What came out: the best case that keeps all limits (None where none does), the solutions spent, why it ended."""
    case: object
    solves: int
    reason: str


class Optimiser:
    """Minimises the expression `goal` of parameters and responses under `limits`."""

    def __init__(self, folder, goal, limits=(), seed=1):
        """Throws UserError for expressions that cannot be read or that use what the study has not."""
        self._folder, self._study = folder, planning.with_integers(folder)
        self._goal, self._limits, self._seed = Expression(goal, said("the goal")), [Limit(text) for text in limits], seed
        self._varied = [parameter for parameter in self._study.parameters if _is_varied(parameter)]
        if not self._varied:
            raise UserError(said("nothing is varied: every parameter has one value only"))
        for expression in (self._goal, *self._limits):
            expression.refuse_unknown([entry.name for entry in self._study.parameters + self._study.responses])

    def run(self, solve, most_solves, tell=lambda *_: None):
        """Spends at most `most_solves` cases; `solve(case_id)` runs one, `tell(case, best)` is called after each. Returns Found."""
        spent = self._first_cases(solve, most_solves, tell)
        if spent < most_solves and not self._can_be_fitted():
            return Found(self.best(), spent, "no other case was found")
        without_gain = 0
        while spent < most_solves:
            point = self._proposal(self._seed + spent)
            if point is None:
                return Found(self.best(), spent, "the surfaces have their best point at a case that is known")
            before = self._best_value()
            self._solved(self._decoded(point), solve, tell)
            spent += 1
            gained = before is None or self._best_value() < before - 1e-4 * abs(before)
            without_gain = 0 if gained else without_gain + 1
            if without_gain == _ROUNDS_WITHOUT_GAIN:
                return Found(self.best(), spent, "the last %d cases brought nothing" % without_gain)
        return Found(self.best(), spent, "all %d solutions were spent" % most_solves)

    def best(self):
        """The best finished case that keeps all limits, or None."""
        found = [case for case in self._folder.database.cases(DONE)
                 if self._goal_of(case) < math.inf and all(limit.is_kept(answers.all_values(case)) for limit in self._limits)]
        return min(found, key=self._goal_of, default=None)

    def _best_value(self):
        best = self.best()
        return None if best is None else self._goal_of(best)

    def _goal_of(self, case):
        """Infinite where the goal has no value, such as where it divides by 0."""
        try:
            value = self._goal.value(answers.all_values(case))
        except UserError:
            return math.inf
        return value if math.isfinite(value) else math.inf

    def _first_cases(self, solve, most, tell):
        """Points of the Sobol' sequence until surfaces can be made. Returns how many were solved."""
        from scipy.stats import qmc   # takes a second to load
        spent, sequence = 0, qmc.Sobol(len(self._varied), scramble=True, seed=self._seed)
        for _ in range(self._most_points(most)):
            if spent == most or self._can_be_fitted():
                break
            values = self._decoded(2 * sequence.random(1)[0] - 1)
            if not self._is_solved(values):
                self._solved(values, solve, tell)
                spent += 1
        return spent

    def _most_points(self, most_solves):
        """How many points to look at for so many that are not solved: some are, by a search before, and few values have few points."""
        return len(self._folder.database.cases()) + _POINTS_FOR_ONE * most_solves

    def _is_solved(self, values):
        return any(case.parameters == values and case.state in (DONE, INFEASIBLE, FAILED) for case in self._folder.database.cases())

    def _can_be_fitted(self):
        """Are there enough cases, and do they not all lie in a plane?"""
        points, count = self._points(self._cases(DONE)), len(self._varied)
        return len(points) >= 2 * count + 3 and np.linalg.matrix_rank(points - points.mean(axis=0)) == count

    def _cases(self, state=None):
        """Those whose values are in the lists of values, at one place each."""
        found = [case for case in self._folder.database.cases(state)
                 if all(case.parameters[parameter.name] in parameter.values for parameter in self._study.parameters if parameter.values)]
        return list({tuple(self._coded(case.parameters)): case for case in found}.values())

    def _points(self, cases):
        """(n,k), coded."""
        return np.array([self._coded(case.parameters) for case in cases]).reshape(-1, len(self._varied))

    def _solved(self, values, solve, tell):
        """The case with these values, solved."""
        case_id = planning.add_point(self._folder, values, "optimise")
        solve(case_id)
        case = self._folder.database.case(case_id)
        tell(case, self.best())
        return case

    def _proposal(self, seed):
        """The coded point where the surfaces have their minimum, or None where a case is already."""
        from scipy.optimize import differential_evolution
        found = differential_evolution(self._cost(self._cases(DONE)), [(-1, 1)] * len(self._varied), seed=seed, popsize=8, maxiter=60, tol=1e-6,
                                       polish=False, init="sobol").x
        there = self._coded(self._decoded(found))
        return None if np.abs(self._points(self._cases()) - there).max(axis=1).min() < 2 * _SAME_POINT else there

    def _cost(self, cases):
        """The function of a coded point that is to be minimised: the goal of what surfaces through the cases say, and what limits lack."""
        points, names = self._points(cases), [response.name for response in self._study.responses]
        surfaces = {name: surface.through(points, np.array([case.responses[name] for case in cases])) for name in names}
        goals = [goal for goal in map(self._goal_of, cases) if goal < math.inf] or [0.0]
        scale = _PENALTY * (max(goals) - min(goals) or 1.0)

        def cost(point):
            values = self._decoded(point)
            if self._study.constraint_not_kept(values):
                return max(goals) + scale
            there = self._coded(values)[None, :]
            values.update((name, float(found(there)[0])) for name, found in surfaces.items())
            try:
                value = self._goal.value(values) + scale * sum(max(0.0, limit.excess(values) + _MARGIN) for limit in self._limits)
            except UserError:   # they have no value there
                return max(goals) + scale
            return value if math.isfinite(value) else max(goals) + scale
        return cost

    def _ends(self, parameter):
        """What -1 and 1 mean: the bounds, or the first and the last place in the list of values."""
        return parameter.bounds or (0, len(parameter.values) - 1)

    def _coded(self, values):
        """(k,) in [-1, 1]."""
        point = []
        for parameter in self._varied:
            low, high = self._ends(parameter)
            value = parameter.values.index(values[parameter.name]) if parameter.values else values[parameter.name]
            point.append(2 * (value - low) / (high - low) - 1)
        return np.array(point)

    def _decoded(self, point):
        """{name: value}, with few digits."""
        values = {parameter.name: (parameter.values or parameter.bounds)[0] for parameter in self._study.parameters}
        for parameter, share in zip(self._varied, point):
            low, high = self._ends(parameter)
            value = low + (share + 1) / 2 * (high - low)
            if parameter.values:
                values[parameter.name] = parameter.values[min(int(round(value)), len(parameter.values) - 1)]
            elif parameter.integer:
                values[parameter.name] = int(round(value))
            else:
                digits = _DIGITS - int(np.floor(np.log10(high - low)))
                values[parameter.name] = float(min(max(round(float(value), digits), low), high))
        return values


def _is_varied(parameter):
    return len(parameter.values) > 1 if parameter.values else parameter.bounds[0] < parameter.bounds[1]

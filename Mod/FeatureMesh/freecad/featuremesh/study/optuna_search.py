# SPDX-License-Identifier: GPL-3.0-or-later
"""Optuna in place of the surfaces: for goals that surfaces cannot follow. Every trial is a case of the study."""
import math

from ..errors import UserError
from ..messages import said
from . import answers
from .database import DONE
from .optimise import Found, Optimiser

_EXCESS = "excess"   # of the limits, noted with each trial


class OptunaOptimiser(Optimiser):
    """The same, by Optuna's tree-structured Parzen estimator. Trials start anew with each run; cases that are known are not solved again."""

    def run(self, solve, most_solves, tell=lambda *_: None):
        """As Optimiser.run. Throws UserError where Optuna is not installed."""
        try:
            import optuna
        except ImportError as error:
            raise UserError(said("--method optuna needs Optuna: install Debian's package python3-optuna")) from error
        optuna.logging.set_verbosity(optuna.logging.WARNING)
        sampler = optuna.samplers.TPESampler(seed=self._seed, constraints_func=lambda trial: trial.user_attrs.get(_EXCESS, (1.0,)))
        trials = optuna.create_study(sampler=sampler, direction="minimize")
        spent = 0
        for _ in range(self._most_points(most_solves)):
            if spent == most_solves:
                break
            trial = trials.ask()
            values = self._suggested(trial)
            spent += not self._is_solved(values)
            case = self._solved(values, solve, tell)
            if case.state != DONE or self._goal_of(case) == math.inf:
                trials.tell(trial, state=optuna.trial.TrialState.FAIL)
                continue
            values = answers.all_values(case)
            trial.set_user_attr(_EXCESS, [limit.excess(values) for limit in self._limits] or [0.0])
            trials.tell(trial, self._goal_of(case))
        return Found(self.best(), spent, "all %d solutions were spent" % spent if spent == most_solves else "no other case was found")

    def _suggested(self, trial):
        """{name: value} as Optuna proposes."""
        values = {}
        for parameter in self._study.parameters:
            if parameter.values:
                values[parameter.name] = trial.suggest_categorical(parameter.name, parameter.values)
            elif parameter.integer:
                values[parameter.name] = trial.suggest_int(parameter.name, *map(int, parameter.bounds))
            else:
                values[parameter.name] = trial.suggest_float(parameter.name, *parameter.bounds)
        return values

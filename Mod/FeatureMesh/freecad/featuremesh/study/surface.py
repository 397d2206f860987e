# SPDX-License-Identifier: GPL-3.0-or-later
"""Response surfaces: a response as a function of the parameters, fitted to the finished cases, with the error that it has between them."""

import itertools
from dataclasses import dataclass

import numpy as np

_FOLDS = 10
_TINY = 1e-12


@dataclass
class Surface:
    """A fitted surface; parameters are coded: -1 is the lowest value among the cases, 1 the highest."""
    kind: str            # "linear", "quadratic" or "thin-plate spline"
    predict: object      # (n,k) coded parameters -> (n,)
    error: float         # cross-validated: root mean square of what cases are off when they are left out, in the response's unit
    spread: float        # standard deviation of the response over the cases

    @property
    def relative_error(self):
        """The error over the spread; 1 is as bad as the mean of all cases."""
        return self.error / self.spread if self.spread > _TINY * (1 + abs(self.error)) else 0.0


def fit(points, values):
    """The surface with the least cross-validated error, or None where there are too few cases. `points` (n,k) coded, `values` (n,)."""
    found = []
    for kind, (make, terms) in _KINDS.items():
        if len(points) >= terms(points.shape[1]) + 2:
            try:
                found.append(Surface(kind, make(points, values), _left_out_error(make, points, values), float(values.std())))
            except np.linalg.LinAlgError:
                pass   # the cases do not lie so that this kind can be fitted
    return min(found, key=lambda surface: surface.error, default=None)


def through(points, values):
    """A function that has the values at the points, smooth between them; needs more points than parameters."""
    return _spline(points, values)


def _left_out_error(make, points, values):
    """Ten folds, or each case by itself where there are few; case by case, so that the folds do not depend on chance."""
    folds = min(len(points), _FOLDS) if len(points) > 2 * _FOLDS else len(points)
    fold = np.arange(len(points)) % folds
    off = np.empty(len(points))
    for number in range(folds):
        out = fold == number
        off[out] = make(points[~out], values[~out])(points[out]) - values[out]
    return float(np.sqrt((off ** 2).mean()))


def _polynomial(terms):
    def make(points, values):
        coefficients, _, rank, _ = np.linalg.lstsq(terms(points), values, rcond=None)
        if rank < len(coefficients):
            raise np.linalg.LinAlgError("the cases do not tell the terms apart")
        return lambda others: terms(others) @ coefficients
    return make


def _linear_terms(points):
    return np.column_stack([np.ones(len(points)), points])


def _quadratic_terms(points):
    pairs = itertools.combinations_with_replacement(range(points.shape[1]), 2)
    return np.column_stack([_linear_terms(points), *(points[:, a] * points[:, b] for a, b in pairs)])


def _spline(points, values):
    from scipy.interpolate import RBFInterpolator   # takes a while to load
    return RBFInterpolator(points, values, kernel="thin_plate_spline")


# Kind -> (what fits it, the number of its terms for k parameters).
_KINDS = {"linear": (_polynomial(_linear_terms), lambda k: 1 + k),
          "quadratic": (_polynomial(_quadratic_terms), lambda k: (k + 1) * (k + 2) // 2),
          "thin-plate spline": (_spline, lambda k: 2 + 2 * k)}

# SPDX-License-Identifier: GPL-3.0-or-later
"""Which cases a study has: rows of values, one for each parameter."""

import csv
import itertools
import math
import warnings

import numpy as np

from ..errors import UserError
from ..messages import of_error, said
from .classic_designs import box_behnken, central_composite
from .design import COUNTED, MOST_CASES


def rows(study, base, count=None, start=0, batch=0):
    """The study's cases as lists of values, in the order of its parameters.

    `base` are the values that the document has. Of sequences (Sobol', Halton) `start` points are passed over; a Latin hypercube of another
    `batch` is another one. Throws UserError.
    """
    if study.sampling in COUNTED:
        return _from_unit(study, _sequence(study, count or study.cases, start, batch))
    if study.sampling == "csv":
        return read_rows(study, study.rows)
    if study.sampling == "grid":
        return _limited(itertools.product(*map(levels_of, study.parameters)), study)
    if study.sampling == "one_at_a_time":
        return _one_at_a_time(study, base)
    make = {"box_behnken": box_behnken, "central_composite": central_composite}[study.sampling]
    return _from_unit(study, (make(len(study.parameters)) + 1) / 2)


def levels_of(parameter):
    """The values that a grid gives a parameter."""
    if parameter.values:
        return list(parameter.values)
    values = np.linspace(*parameter.bounds, parameter.levels)
    return list(dict.fromkeys(_as_asked(parameter, value) for value in values))


def read_rows(study, path):
    """The rows of a CSV file whose columns are named as the parameters are. Throws UserError."""
    try:
        with open(path, newline="", encoding="utf-8-sig") as stream:   # Excel begins it with a mark
            reader = csv.DictReader(stream)
            missing = [entry.name for entry in study.parameters if entry.name not in (reader.fieldnames or [])]
            if missing:
                raise UserError(said("{path:text} has no column {column:text}", path=path, column=missing[0]))
            found = [[_value(entry, row[entry.name], path, number) for entry in study.parameters] for number, row in enumerate(reader, 2)]
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise UserError(said("cannot read {path:text}: {why:messages}", path=path, why=getattr(error, "strerror", None) or of_error(error))) from error
    if not found:
        raise UserError(said("{path:text} has no rows", path=path))
    return found


def _value(parameter, text, path, line):
    if parameter.values and not all(isinstance(value, (int, float)) for value in parameter.values):
        return (text or "").strip()
    try:
        value = float(text)
        if not math.isfinite(value):
            raise ValueError
    except (TypeError, ValueError):
        raise UserError(said("{path:text}, line {line:count}: {text:text} is no number for {parameter:text}",
                             path=path, line=line, text=text, parameter=parameter.name)) from None
    return int(value) if parameter.integer and value == int(value) else value


def _sequence(study, count, start, batch):
    """(count, parameters) points of the unit cube."""
    from scipy.stats import qmc   # takes a second to load
    dimensions = len(study.parameters)
    if study.sampling == "lhs":
        return qmc.LatinHypercube(dimensions, seed=np.random.default_rng([study.seed, batch])).random(count)
    sequence = {"sobol": qmc.Sobol, "halton": qmc.Halton}[study.sampling](dimensions, scramble=True, seed=study.seed)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)   # of counts that are no power of two; a study may be extended at any count
        if start:
            sequence.fast_forward(start)
        return sequence.random(count)


def _from_unit(study, points):
    return [[_from_share(parameter, float(share)) for parameter, share in zip(study.parameters, point)] for point in points]


def _from_share(parameter, share):
    """The value at a share of the parameter's range."""
    if parameter.values:
        return parameter.values[min(int(share * len(parameter.values)), len(parameter.values) - 1)]
    low, high = parameter.bounds
    if parameter.integer:
        return min(int(low + np.floor(share * (high - low + 1))), int(high))
    return low + share * (high - low)


def _as_asked(parameter, value):
    return int(round(value)) if parameter.integer else float(value)


def _one_at_a_time(study, base):
    """The document as it is, then each parameter over its levels with the others as they are."""
    centre = [base[parameter.name] for parameter in study.parameters]
    found = [centre]
    for column, parameter in enumerate(study.parameters):
        for value in levels_of(parameter):
            row = [*centre[:column], value, *centre[column + 1:]]
            if row not in found:
                found.append(row)
    return found


def _limited(product, study):
    found = [list(row) for row in itertools.islice(product, MOST_CASES + 1)]
    if len(found) > MOST_CASES:
        raise UserError(said("the grid of {parameters:count} {parameters:parameter|parameters} has more than {most:count} cases; take fewer levels, or sobol",
                             parameters=len(study.parameters), most=MOST_CASES))
    return found

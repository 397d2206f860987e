# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts the cases of a study into its database: those of its sampling, more of the same sequence, rows of one's own."""
import math

from ..errors import UserError
from ..messages import alternatives, said
from . import sampling
from .design import COUNTED, refuse_too_many


def plan(folder):
    """Adds the cases that the study asks for. Returns how many there are."""
    study, facts = with_integers(folder), folder.facts()
    rows = sampling.rows(study, facts["base_values"])
    folder.database.add_cases(_with_messages(study, rows), study.sampling, {"sampled": len(rows), "batches": 1})
    return len(rows)


def extend(folder, count=None, csv_path=None):
    """Adds `count` cases of the same sequence, or the rows of a file. Returns how many were added. Throws UserError."""
    study, database = with_integers(folder), folder.database
    before = sum(database.counts().values())
    if csv_path:
        database.add_cases(_with_messages(study, sampling.read_rows(study, csv_path)), "csv")
        return sum(database.counts().values()) - before
    refuse_too_many(before + count)
    if study.sampling not in COUNTED:
        raise UserError(said("the sampling {sampling:text} is complete; add rows of a CSV file, or start a study with {others:messages}",
                             sampling=study.sampling, others=alternatives(COUNTED)))
    sampled, batches = database.value("sampled"), database.value("batches")
    rows = sampling.rows(study, folder.facts()["base_values"], count, sampled, batches)
    database.add_cases(_with_messages(study, rows), study.sampling, {"sampled": sampled + count, "batches": batches + 1})
    return sum(database.counts().values()) - before


def add_point(folder, values, maker):
    """The id of the case with these values, made if it is not there."""
    study = with_integers(folder)
    row = [values[parameter.name] for parameter in study.parameters]
    return folder.database.add_cases(_with_messages(study, [row]), maker)[0]


def with_integers(folder):
    """The study, whose parameters know which of them are whole numbers in the document, with whole bounds."""
    study, integers = folder.study(), folder.facts()["integers"]
    for parameter in study.parameters:
        parameter.integer = parameter.integer or parameter.name in integers
        if parameter.integer and parameter.bounds:
            parameter.bounds = _whole_bounds(parameter)
    return study


def _whole_bounds(parameter):
    low, high = parameter.bounds
    if math.ceil(low) > math.floor(high):
        raise UserError(said("no whole number is between {low:number} and {high:number}, the bounds of {parameter:text}",
                             low=low, high=high, parameter=parameter.name))
    return float(math.ceil(low)), float(math.floor(high))


def _with_messages(study, rows):
    """(parameters, why not) for each row; the second is None for a case that keeps all constraints."""
    found = []
    for row in rows:
        values = dict(zip([parameter.name for parameter in study.parameters], row))
        broken = study.constraint_not_kept(values)
        found.append((values, said("the constraint {constraint:text} is not kept", constraint=broken) if broken else None))
    return found

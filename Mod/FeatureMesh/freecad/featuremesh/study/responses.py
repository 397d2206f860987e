# SPDX-License-Identifier: GPL-3.0-or-later
"""One number for each response of one case. What is no number is an error."""

import math
import runpy
from dataclasses import dataclass, field

import numpy as np

from .. import mass
from ..errors import UserError
from ..messages import alternatives, of_error, said
from ..statics_result import principal, von_mises
from .expressions import Expression
from .response_words import OF_PART

# What an analysis of one kind gives; FreeCAD's names of the kinds.
_OF_STATICS = ("static", "thermomech")
_NEEDS = {"buckling_factor": ("buckling",), "frequency": ("frequency",), "max_temperature": ("thermomech",), "min_temperature": ("thermomech",)}
_ONLY_CCX = ("buckling_factor", "frequency", "max_temperature", "min_temperature")


@dataclass
class SolvedCase:
    """What a response may be made of; a file's `response(case)` gets it."""
    id: int
    parameters: dict       # name -> value
    part: object           # FreeCAD's
    analysis: object       # FreeCAD's, or None
    arrays: dict           # of the mesh
    fields: object         # case_solver.Fields, None where no response needs any
    places: object         # places.Places
    responses: dict = field(default_factory=dict)   # those before


def refuse_unfit(responses, kind, live):
    """Throws UserError for a response that an analysis of that kind, or the live solver, does not give."""
    for response in responses:
        if response.kind is None or response.kind in OF_PART:
            continue
        needed = _NEEDS.get(response.kind, _OF_STATICS)
        if kind not in needed:
            raise UserError(said("the response {response:text} needs an analysis of the kind {kinds:messages}, not {kind:text}",
                                 response=response.name, kinds=alternatives(needed), kind=kind))
        if live and response.kind in _ONLY_CCX:
            raise UserError(said('the response {response:text} needs CalculiX; take solver = "ccx"', response=response.name))


def evaluate(responses, case):
    """{name: number}. Throws UserError that names the response."""
    for response in responses:
        try:
            value = _value(response, case)
        except UserError as error:
            raise UserError(said("response {response:text}: {why:messages}", response=response.name, why=of_error(error))) from error
        if isinstance(value, bool) or not isinstance(value, (int, float, np.number)) or not math.isfinite(value):
            raise UserError(said("response {response:text} is not a number: {value:text}", response=response.name, value=str(value)))
        case.responses[response.name] = float(value)
    return case.responses


def _value(response, case):
    if response.expression:
        return Expression(response.expression, said("the response")).value({**case.parameters, **case.responses})
    if response.file:
        return _of_file(response.file, case)
    if response.kind == "volume":
        return mass.whole(case.part, "tets")
    if response.kind == "area":
        return mass.whole(case.part, "triangles")
    if response.kind == "mass":
        return mass.of_part(case.part, case.analysis, case.arrays)
    if response.kind.startswith("reaction"):
        return _reaction(response, case.fields)
    if response.kind == "strain_energy":
        return _given(case.fields.strain_energy, said("strain energy"))
    if response.kind in ("frequency", "buckling_factor"):
        return _mode(response, case.fields)
    return _of_nodes(response, case)


def _of_nodes(response, case):
    fields = case.fields

    def there(values, what):
        return case.places.values(response.at, _given(values, what), fields.rows)

    if response.kind.endswith("temperature"):
        values, sign = there(fields.temperatures, said("temperature")), -1 if response.kind[:3] == "min" else 1
    elif "displacement" in response.kind:
        values, sign = _displacements(response.kind, there(fields.displacements, said("displacement"))), 1
    else:
        values, sign = _stresses(response.kind, there(fields.stresses, said("stress"))), -1 if response.kind[:3] == "min" else 1
    if response.percentile is not None:
        return float(np.percentile(values, response.percentile))
    return float(values[np.argmax(np.abs(values))] if response.kind.startswith("displacement_") else sign * (sign * values).max())


def _displacements(kind, vectors):
    """(m,) lengths, or one component."""
    return vectors[:, "xyz".index(kind[-1])] if kind.startswith("displacement_") else np.linalg.norm(vectors, axis=1)


def _stresses(kind, stresses):
    """(m,) MPa."""
    if not np.isfinite(stresses).all():
        return np.array([np.nan])
    if kind == "max_mises":
        return von_mises(stresses)
    return principal(stresses)[:, 2 if kind == "max_principal" else 0]


def _reaction(response, fields):
    """Of the support, or of all supports together: the length of the force, or one component."""
    if response.at and response.at not in fields.reactions:
        raise UserError(said("no support {support:text} has a reaction; there are {supports:messages}",
                             support=response.at, supports=", ".join(fields.reactions) or said("none")))
    found = [fields.reactions[response.at]] if response.at else list(fields.reactions.values())
    if not found:
        raise UserError(said("no support has a reaction"))
    total = np.sum(found, axis=0)
    return float(np.linalg.norm(total) if response.kind == "reaction" else total["xyz".index(response.kind[-1])])


def _mode(response, fields):
    found = fields.frequencies if response.kind == "frequency" else fields.buckling_factors
    if response.mode > len(found):
        raise UserError(said("CalculiX found {modes:count} {modes:mode|modes}; ask its solver for more", modes=len(found)))
    return found[response.mode - 1]


def _given(value, what):
    if value is None:
        raise UserError(said("the analysis gives no {what:messages}", what=what))
    return value


def _of_file(path, case):
    try:
        return runpy.run_path(path)["response"](case)
    except (UserError, OSError):
        raise
    except Exception as error:
        raise UserError(said("{path:text}: {kind:text}: {why:messages}", path=path, kind=type(error).__name__, why=of_error(error))) from error

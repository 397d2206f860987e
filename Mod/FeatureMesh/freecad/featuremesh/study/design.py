# SPDX-License-Identifier: GPL-3.0-or-later
"""What a study is: the document, what is varied and how, what is asked for. Read from study.toml or from a command line."""

import math
import os
import re
from dataclasses import asdict, dataclass, field

from ..errors import UserError
from ..messages import of_error, said
from .expressions import Expression
from .response_words import Response, parse_response

SAMPLINGS = ("grid", "one_at_a_time", "lhs", "sobol", "halton", "box_behnken", "central_composite", "csv")
COUNTED = ("lhs", "sobol", "halton")   # those that take any number of cases
SOLVERS = ("live", "ccx")
MOST_SECONDS = 1e8    # of a case, three years; the system cannot wait much longer
MOST_CASES = 100000   # of a study, so that a number with too many noughts is told at once
KEPT_FILES = ("mesh", "inp", "frd")
# What each key of a study's file holds.
_NUMBER = (int, float)
_KEYS = {"document": str, "object": str, "analysis": str, "solver": str, "threads": int, "keep": list, "seed": int, "sampling": str, "cases": int, "rows": str,
         "constraints": list, "responses": list, "mesh": dict, "limits": dict, "parameters": list}
_MESH_KEYS = {"size": _NUMBER, "order": int}
_LIMIT_KEYS = {"seconds": _NUMBER, "memory_gb": _NUMBER}
_PARAMETER_KEYS = {"set": str, "name": str, "range": list, "values": list, "unit": str, "levels": int, "integer": bool, "label": str}
_IN_WORDS = {str: said("a text in quotes"), int: said("a whole number"), _NUMBER: said("a number"), list: said("a list in square brackets"),
             dict: said("a table"), bool: said("true or false")}


@dataclass
class Parameter:
    """One thing that is varied: between two bounds, or over a list of values."""
    target: str                                  # OBJECT.PROPERTY, as `--set` takes it
    name: str                                    # its column
    bounds: tuple = ()                           # (lowest, highest), in `unit`
    values: list = field(default_factory=list)   # numbers or words, instead of bounds
    unit: str = ""                               # mm and degrees when empty
    levels: int = 3                              # of a grid, between the bounds
    integer: bool = False                        # whole numbers only; known for a property that is one
    label: str = ""                              # what it is called where cases are shown, if not as its column

    @property
    def title(self):
        """What plots, tables on the screen and the page call it."""
        return self.label or self.name

    def assignment(self, value):
        """The edit that gives it a value."""
        text = value if isinstance(value, str) else repr(value)
        return "%s=%s%s" % (self.target, text, " " + self.unit if self.unit else "")


@dataclass
class Study:
    """Everything that decides what the cases are and what comes out of them."""
    document: str                                 # path
    parameters: list
    responses: list
    object: str = None
    analysis: str = None
    solver: str = None                            # "live" or "ccx"; None: live where that knows all that the analysis holds
    sampling: str = "lhs"
    cases: int = 0
    rows: str = None                              # CSV of one's own, for sampling "csv"
    seed: int = 1
    constraints: list = field(default_factory=list)
    mesh_size: float = None                       # mm; None: as the document's mesh has it
    mesh_order: int = None
    threads: int = 1                              # of each case; the bits of a result may depend on it, never on the number of jobs
    keep: list = field(default_factory=list)      # of KEPT_FILES
    seconds_limit: float = 3600.0                 # of one case
    memory_limit_gb: float = None                 # of one case; None: what the machine has

    def to_plain(self):
        """As JSON takes it."""
        return asdict(self)

    def constraint_not_kept(self, values):
        """The first constraint that the parameters' values break, or None. Throws UserError for one that cannot be evaluated."""
        for text in self.constraints:
            if not Expression(text, said("the constraint")).value(values):
                return text
        return None


def from_plain(plain):
    """The study that to_plain gave."""
    return Study(**{**plain, "parameters": [Parameter(**{**entry, "bounds": tuple(entry["bounds"])}) for entry in plain["parameters"]],
                    "responses": [Response(**entry) for entry in plain["responses"]]})


def read_toml(path):
    """The study in a file; paths in it are relative to the file. Throws UserError."""
    try:
        import tomllib
    except ImportError as error:
        raise UserError(said("files of studies need Python 3.11 or newer, which this FreeCAD has not")) from error
    try:
        with open(path, "rb") as stream:
            given = tomllib.load(stream)
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise UserError(said("{path:text} cannot be read: {why:messages}", path=path, why=of_error(error))) from error
    _refuse_wrong(given, _KEYS, path)
    folder = os.path.dirname(os.path.abspath(path))
    for key in ("document", "parameters", "responses"):
        if not given.get(key):
            raise UserError(said("{path:text} has no {key:text}; a study's file needs document, parameters and responses", path=path, key=key))
    mesh, limits = given.get("mesh", {}), given.get("limits", {})
    _refuse_wrong(mesh, _MESH_KEYS, path + ", [mesh]")
    _refuse_wrong(limits, _LIMIT_KEYS, path + ", [limits]")
    study = Study(
        document=os.path.join(folder, given["document"]), parameters=[_parameter(entry, path) for entry in given["parameters"]],
        responses=[parse_response(entry) for entry in given["responses"]], object=given.get("object"), analysis=given.get("analysis"),
        solver=given.get("solver"), sampling=given.get("sampling", "lhs"), cases=given.get("cases", 0),
        rows=os.path.join(folder, given["rows"]) if given.get("rows") else None, seed=given.get("seed", 1),
        constraints=given.get("constraints", []), mesh_size=mesh.get("size"), mesh_order=mesh.get("order"), threads=given.get("threads", 1),
        keep=given.get("keep", []), seconds_limit=limits.get("seconds", 3600.0), memory_limit_gb=limits.get("memory_gb"))
    for response in study.responses:
        if response.file:
            response.file = os.path.join(folder, response.file)
    check(study)
    return study


def parse_parameter(text):
    """A parameter from `OBJECT.PROPERTY=LOW:HIGH`, `=LOW:HIGH:LEVELS` or `=A,B,C`, with a unit at the end if need be. Throws UserError."""
    target, separator, rest = text.rpartition("=")   # a label may have equals signs, too
    target, rest = target.strip(), rest.strip()
    if not (separator and "." in target and rest):
        raise _unreadable(text)
    if ":" not in rest:
        values, unit = _listed(rest)
        return Parameter(target, target, values=values, unit=unit)
    numbers, unit = _without_unit(rest)
    parts = numbers.split(":")
    try:
        low, high = float(parts[0]), float(parts[1])
        levels = int(parts[2]) if len(parts) == 3 else 3
    except ValueError:
        raise _unreadable(text) from None
    if len(parts) > 3:
        raise _unreadable(text)
    return Parameter(target, target, bounds=(low, high), unit=unit, levels=levels)


def check(study):
    """Throws UserError for what makes no sense, before anything is started."""
    if study.sampling not in SAMPLINGS:
        raise UserError(said("the sampling is one of {samplings:text}, not {sampling:text}", samplings=", ".join(SAMPLINGS), sampling=study.sampling))
    if study.sampling in COUNTED and not study.cases > 0:
        raise UserError(said("the sampling {sampling:text} needs a number of cases, such as --cases 32 (in a study's file cases = 32)",
                             sampling=study.sampling))
    refuse_too_many(study.cases)
    if study.sampling == "csv" and not study.rows:
        raise UserError(said("the sampling csv needs a file of rows: --rows ROWS.csv (in a study's file rows = \"ROWS.csv\")"))
    if study.sampling == "box_behnken" and len(study.parameters) < 3:
        raise UserError(said("Box-Behnken needs at least three parameters, not {count:count}; take central_composite", count=len(study.parameters)))
    if study.solver not in (None, *SOLVERS):
        raise UserError(said("the solver is live or ccx, not {solver:text}", solver=study.solver))
    if study.threads < 1:
        raise UserError(said("a case needs at least one thread, not {threads:count}", threads=study.threads))
    if study.seed < 0:
        raise UserError(said("the seed is 0 or larger, not {seed:count}", seed=study.seed))
    check_limits(study)
    if study.mesh_order not in (None, 1, 2):
        raise UserError(said("the order of the elements is 1 or 2, not {order:count}", order=study.mesh_order))
    for name in study.keep:
        if name not in KEPT_FILES:
            raise UserError(said("of a case can be kept: {kinds:text}, not {kind:text}", kinds=", ".join(KEPT_FILES), kind=name))
    for parameter in study.parameters:
        _check_parameter(parameter)
    names = [entry.name for entry in study.parameters + study.responses]
    for name in names:
        if names.count(name) > 1:
            raise UserError(said("two columns are named {name:text}; give one of them another name", name=name))
    for text in study.constraints:
        Expression(text, said("the constraint"))


def refuse_too_many(cases):
    """Throws UserError for more cases than anybody can mean."""
    if cases > MOST_CASES:
        raise UserError(said("a study has at most {most:count} cases; {cases:count} are too many", most=MOST_CASES, cases=cases))


def check_limits(study):
    """Throws UserError for a limit that no case could keep to."""
    if not study.seconds_limit > 0:
        raise UserError(said("the time limit of a case is more than 0 s, not {seconds:number}", seconds=study.seconds_limit))
    if study.seconds_limit > MOST_SECONDS:
        raise UserError(said("the time limit of a case is at most {most:number} s, not {seconds:number}", most=MOST_SECONDS, seconds=study.seconds_limit))
    if study.memory_limit_gb is not None and not 0 < study.memory_limit_gb < math.inf:
        raise UserError(said("the memory limit of a case is more than 0 GB, not {gigabytes:number}; leave it out where the whole machine may be used",
                             gigabytes=study.memory_limit_gb))


def _refuse_wrong(given, known, where):
    """Throws UserError for a key that means nothing, or that holds another kind of value than `known` says."""
    for key, value in given.items():
        if key not in known:
            raise UserError(said("{where:text}: there is no {key:text}; known are {known:text}", where=where, key=key, known=", ".join(sorted(known))))
        if not isinstance(value, known[key]) or (isinstance(value, bool) and known[key] is not bool):
            raise UserError(said("{where:text}: {key:text} is {kind:messages}, not {value:text}",
                                 where=where, key=key, kind=_IN_WORDS[known[key]], value=repr(value)))


def _check_parameter(parameter):
    if bool(parameter.bounds) == bool(parameter.values):
        raise UserError(said("the parameter {parameter:text} needs a range of two numbers or a list of values", parameter=parameter.name))
    if parameter.bounds and not -math.inf < parameter.bounds[0] < parameter.bounds[1] < math.inf:
        low, high = parameter.bounds
        raise UserError(said("the range of {name:text} has to rise, not {low:number}:{high:number}; write its low end first",
                             name=parameter.name, low=low, high=high))
    if not _are_alike(parameter.values):
        raise UserError(said("the values of {parameter:text} are numbers, or words, all of them", parameter=parameter.name))
    if not 2 <= parameter.levels <= MOST_CASES:
        raise UserError(said("{parameter:text} needs two levels to {most:count}, not {levels:count}", parameter=parameter.name, most=MOST_CASES,
                             levels=parameter.levels))


def _parameter(given, path):
    if not isinstance(given, dict):
        raise UserError(said('{path:text}: a parameter is a table [[parameters]] with set = "OBJECT.PROPERTY", not {entry:text}', path=path, entry=repr(given)))
    _refuse_wrong(given, _PARAMETER_KEYS, "%s, [[parameters]]" % path)
    if not given.get("set"):
        raise UserError(said('{path:text}: a parameter has no set = "OBJECT.PROPERTY"', path=path))
    bounds = given.get("range", [])
    if bounds and (len(bounds) != 2 or not all(isinstance(entry, (int, float)) for entry in bounds)):
        raise UserError(said("{path:text}: the range of {parameter:text} is two numbers", path=path, parameter=given["set"]))
    return Parameter(given["set"], given.get("name", given["set"]), tuple(map(float, bounds)), list(given.get("values", [])), given.get("unit", ""),
                     given.get("levels", 3), given.get("integer", False), given.get("label", ""))


def _listed(text):
    """(values, unit) of a list whose last number may have a unit: that of all of them."""
    *others, last = [entry.strip() for entry in text.split(",")]
    number, unit = _without_unit(last)
    if others and unit and all(isinstance(_value(entry), float) for entry in (*others, number)):
        return [_value(entry) for entry in (*others, number)], unit
    return [_value(entry) for entry in (*others, last)], ""


def _without_unit(text):
    return re.fullmatch(r"(.*?)\s*([A-Za-z]*)", text).groups()


def _are_alike(values):
    """Are they all words, or all numbers with an end?"""
    return all(isinstance(value, str) and value for value in values) or all(isinstance(value, (int, float)) and math.isfinite(value) for value in values)


def _value(text):
    try:
        return float(text)
    except ValueError:
        return text


def _unreadable(text):
    return UserError(said("cannot read '{text:text}'; a parameter is OBJECT.PROPERTY=LOW:HIGH, with :LEVELS for a grid, or OBJECT.PROPERTY=A,B,C", text=text))

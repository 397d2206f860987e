# SPDX-License-Identifier: GPL-3.0-or-later
"""How a response is written: KIND, KIND@PLACE, KIND:pNN for a percentile; or a table with name, kind, at, percentile, expression, file."""

import difflib
import re
from dataclasses import dataclass

from ..errors import UserError
from ..messages import said
from .expressions import Expression

# Kind -> what it is and its unit.
KINDS = {
    "mass": "kg", "volume": "mm^3", "area": "mm^2", "max_mises": "MPa", "max_principal": "MPa", "min_principal": "MPa", "max_displacement": "mm",
    "displacement_x": "mm", "displacement_y": "mm", "displacement_z": "mm", "reaction": "N", "reaction_x": "N", "reaction_y": "N",
    "reaction_z": "N", "strain_energy": "mJ", "buckling_factor": "", "frequency": "Hz", "max_temperature": "K", "min_temperature": "K",
}
# Kind -> what a person calls it; the database, tables for programs and expressions have its name.
WORDS = {
    "mass": said("mass"), "volume": said("volume"), "area": said("area"), "max_mises": said("largest von Mises stress"),
    "max_principal": said("largest principal stress"), "min_principal": said("smallest principal stress"), "max_displacement": said("largest displacement"),
    "displacement_x": said("displacement in x"), "displacement_y": said("displacement in y"), "displacement_z": said("displacement in z"),
    "reaction": said("force on all supports"), "reaction_x": said("force on all supports in x"), "reaction_y": said("force on all supports in y"),
    "reaction_z": said("force on all supports in z"), "strain_energy": said("strain energy"), "buckling_factor": said("first buckling factor"),
    "frequency": said("first frequency"), "max_temperature": said("largest temperature"), "min_temperature": said("smallest temperature"),
}
_OF_SOME_NODES = {"max_mises": said("von Mises stress"), "max_displacement": said("displacement"), "max_temperature": said("temperature"), "min_temperature": said("temperature")}
_ON_A_SUPPORT = {"reaction": said("force"), "reaction_x": said("force in x"), "reaction_y": said("force in y"), "reaction_z": said("force in z")}
_OF_A_MODE = {"buckling_factor": said("buckling factor {mode:count}", mode=2), "frequency": said("frequency {mode:count}", mode=2)}
OF_PART = ("mass", "volume", "area")   # need no solution
STRESSES = ("max_mises", "max_principal", "min_principal")
_OF_NODES = (*STRESSES, "max_displacement", "displacement_x", "displacement_y", "displacement_z", "max_temperature", "min_temperature")
_BY_MODE = ("buckling_factor", "frequency")
_KEYS = {"name": str, "kind": str, "at": str, "percentile": (int, float), "mode": int, "expression": str, "file": str}   # what each holds


@dataclass
class Response:
    """One number asked of every case."""
    name: str
    kind: str = None           # of KINDS; None: an expression or a file of one's own
    at: str = None             # Face3, Edge2, Vertex1, a feature's name, "x,y,z" in mm; of a reaction the support; None: the part
    percentile: float = None   # of the nodes' values there, instead of the largest
    mode: int = 1              # of buckling factors and frequencies, from 1
    expression: str = None     # of parameters and of the responses before it
    file: str = None           # a Python file with a function `response(case)`

    @property
    def unit(self):
        return KINDS.get(self.kind, "")

    @property
    def words(self):
        """What a person calls it, a message: by the name that the user gave it, else by what it is."""
        return said("{name:text}", name=self.name) if self._has_own_name() else _in_words(self)

    @property
    def title(self):
        """Words and unit, as an axis or a column has them, a message."""
        return said("{name:messages}, {unit:text}", name=self.words, unit=self.unit) if self.unit else self.words

    def _has_own_name(self):
        kinds = [self.kind, "%s_%d" % (self.kind, self.mode), "%s%d" % (self.kind, self.mode)]
        without_share = self.name.rpartition(":p")[0] or self.name if self.percentile is not None else self.name
        return self.kind is None or without_share not in [*kinds, *("%s@%s" % (kind, self.at) for kind in kinds)]


def _in_words(response):
    words = WORDS[response.kind]
    if response.kind in _OF_A_MODE and response.mode > 1:
        words = {**_OF_A_MODE[response.kind], "parameters": {"mode": response.mode}}
    if response.percentile is not None:
        words = said("{what:messages} (percentile {percent:number})", what=_OF_SOME_NODES.get(response.kind, words), percent=response.percentile)
    if response.at:
        words = said("{what:messages} at {place:text}", what=_ON_A_SUPPORT.get(response.kind, words), place=response.at)
    return words


def parse_response(given):
    """A response from its text or table. Throws UserError."""
    if not isinstance(given, (str, dict)):
        raise UserError(said('a response is a text such as "max_mises" or a table, not {response:text}', response=repr(given)))
    response = _from_table(given) if isinstance(given, dict) else _from_text(given)
    if response.kind is None and bool(response.expression) == bool(response.file):
        raise UserError(said("the response {response:text} needs a kind, an expression or a file", response=response.name))
    if response.kind is not None and response.kind not in KINDS:
        near = difflib.get_close_matches(response.kind, KINDS, 1)
        raise UserError(said("there is no response {kind:text}{near:messages}; there are {kinds:text}",
                             kind=response.kind, near=said(", did you mean {name:text}?", name=near[0]) if near else "", kinds=", ".join(KINDS)))
    if response.percentile is not None and (response.kind not in _OF_NODES or not 0 <= response.percentile <= 100):
        raise UserError(said("the response {response:text} cannot have a percentile, or one outside of 0 to 100", response=response.name))
    if response.mode < 1:
        raise UserError(said("the response {response:text} counts its modes from 1", response=response.name))
    if response.at and response.kind not in _OF_NODES and not (response.kind or "").startswith("reaction"):
        raise UserError(said("the response {response:text} is of the whole part, not at {place:text}", response=response.name, place=response.at))
    if response.expression:
        Expression(response.expression, said("the response"))
    return response


def at_place(kind, place):
    """The text of a response of that kind at a face, edge, vertex or feature."""
    return "%s@%s" % (kind, place)


def needs_solution(responses):
    """Must the analysis be solved for these?"""
    return any(response.kind not in OF_PART and not response.expression for response in responses)


def needs_analysis(responses):
    """Must there be an analysis for these? A mass needs its materials."""
    return needs_solution(responses) or any(response.kind == "mass" for response in responses)


def _from_table(given):
    for key in given:
        if key not in _KEYS:
            raise UserError(said("a response has no {key:text}; known are {known:text}", key=key, known=", ".join(sorted(_KEYS))))
        if not isinstance(given[key], _KEYS[key]) or isinstance(given[key], bool):
            raise UserError(said("{key:text} of the response {response:text} cannot be {value:text}", key=key, response=str(given), value=repr(given[key])))
    name = given.get("name") or given.get("kind") or given.get("file")
    if not name:
        raise UserError(said("a response has no name: {response:text}", response=str(given)))
    return Response(**{"name": name, **given})


def _from_text(text):
    own_name, equals, rest = text.partition("=")
    words = rest if equals else text
    found = re.fullmatch(r"\s*([a-z_]+?)(?:_?(\d+))?(?:@(.+?))?(?::p(\d+(?:\.\d+)?))?\s*", words)
    if not found or (found.group(2) and found.group(1) not in _BY_MODE):
        raise UserError(said("cannot read the response '{response:text}'; it is KIND, KIND@PLACE or KIND:p95", response=text))
    kind, mode, place, percentile = found.groups()
    return Response(own_name.strip() if equals else words.strip(), kind, place, float(percentile) if percentile else None, int(mode or 1))


def parse_list(text):
    """The responses of a command line, separated by commas; the commas of a point belong to it."""
    entries = re.split(r",(?=\s*[A-Za-z_])", text)
    return [parse_response(entry.strip()) for entry in entries]

# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a study as the study.toml that design.read_toml reads."""

import json
import os

from .design import Parameter, Study

_TOP = ("object", "analysis", "solver", "sampling", "cases", "rows", "seed", "constraints", "threads", "keep")


def write(study, path):
    """Paths in it are relative to the file."""
    folder = os.path.dirname(os.path.abspath(path))
    usual = Study("", [], [])
    lines = ["document = %s" % _text(os.path.relpath(study.document, folder))]
    lines += ["%s = %s" % (key, _text(getattr(study, key))) for key in _TOP if getattr(study, key) != getattr(usual, key)]
    lines.append("responses = [%s]" % ", ".join(_response(entry, folder) for entry in study.responses))
    lines += _table("mesh", {"size": study.mesh_size, "order": study.mesh_order})
    lines += _table("limits", {"seconds": study.seconds_limit, "memory_gb": study.memory_limit_gb})
    for parameter in study.parameters:
        lines += ["", "[[parameters]]", *_parameter(parameter)]
    with open(path, "w", encoding="utf-8") as stream:
        stream.write("\n".join(lines) + "\n")


def _parameter(parameter):
    usual = Parameter(parameter.target, parameter.target)
    lines = ["set = %s" % _text(parameter.target)]
    for key, name in (("name", "name"), ("range", "bounds"), ("values", "values"), ("unit", "unit"), ("levels", "levels"), ("integer", "integer"), ("label", "label")):
        if getattr(parameter, name) != getattr(usual, name):
            lines.append("%s = %s" % (key, _text(getattr(parameter, name))))
    return lines


def _response(response, folder):
    entries = {"name": response.name, "kind": response.kind, "at": response.at, "percentile": response.percentile,
               "mode": response.mode if response.mode != 1 else None, "expression": response.expression,
               "file": os.path.relpath(response.file, folder) if response.file else None}
    return "{%s}" % ", ".join("%s = %s" % (key, _text(value)) for key, value in entries.items() if value is not None)


def _table(name, entries):
    said = ["%s = %s" % (key, _text(value)) for key, value in entries.items() if value is not None]
    return ["", "[%s]" % name, *said] if said else []


def _text(value):
    """A string, number, switch or list as TOML has it, which for these is JSON."""
    return json.dumps(list(value) if isinstance(value, tuple) else value, ensure_ascii=False)

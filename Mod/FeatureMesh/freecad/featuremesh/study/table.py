# SPDX-License-Identifier: GPL-3.0-or-later
"""The cases of a study as a table: CSV or JSON, with columns named as parameters and responses are."""

import csv
import json
import os
from dataclasses import asdict

from .. import whole_file
from ..errors import UserError
from ..messages import english, in_english, said


def write(folder, path, file_format=None):
    """Writes all cases. Returns how many. Throws UserError."""
    file_format = (file_format or os.path.splitext(path)[1].lstrip(".")).lower()
    writers = {"csv": _write_csv, "json": _write_json}
    if file_format not in writers:
        raise UserError(said("a table is written as csv or json, not {format:text}", format=file_format or path))
    cases = folder.database.cases()
    try:
        with whole_file.written(path, newline="") as stream:
            writers[file_format](folder.study(), cases, stream)
    except OSError as error:
        raise UserError(said("cannot write {path:text}: {why:messages}", path=path, why=error.strerror)) from error
    return len(cases)


def _write_csv(study, cases, stream):
    parameters, responses = [entry.name for entry in study.parameters], [entry.name for entry in study.responses]
    writer = csv.writer(stream)
    writer.writerow(["case", "state", *parameters, *responses, "seconds", "kept_share", "message"])
    for case in cases:
        writer.writerow([case.id, case.state, *(case.parameters[name] for name in parameters), *(case.responses.get(name, "") for name in responses),
                         case.seconds.get("total", ""), case.mesh.get("kept_share", ""), english(case.message)])


def _write_json(study, cases, stream):
    json.dump({"study": study.to_plain(), "cases": [in_english(asdict(case)) for case in cases]}, stream, indent=1, sort_keys=True)

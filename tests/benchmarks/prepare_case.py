# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads a part before and after its edit, in FreeCAD, so that the meshers can be measured without it.

FEATUREMESH_CASE is JSON: part, after, final, edit, folder. Writes old.json, new.json (raw documents), new.brep and
reading.json there: the seconds that FreeCAD takes to recompute all of the edited document and that it takes to read it.
"""
import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

from in_freecad import open_part, tell  # noqa: E402
from raw_files import write_raw  # noqa: E402
from timing import seconds_of, shortest  # noqa: E402


def prepare(case):
    from freecad.featuremesh import api, reading
    folder = Path(case["folder"])
    document = open_part(case["part"])
    write_raw(folder / "old.json", reading.read_document(document.getObject(case["final"])))
    if case["after"]:
        document = open_part(case["after"])
    api.set_parameters(document, case["edit"])
    api.recompute(document)
    part = document.getObject(case["final"])
    write_raw(folder / "new.json", reading.read_document(part))
    part.Shape.exportBrep(str(folder / "new.brep"))
    part.Shape.exportStep(str(folder / "new.step"))
    seconds = {"recompute": shortest(lambda: seconds_of(lambda: recompute_all(document))),
               "read": shortest(lambda: seconds_of(lambda: reading.read_document(part)))}
    (folder / "reading.json").write_text(json.dumps(seconds), encoding="utf-8")


def recompute_all(document):
    for obj in document.Objects:
        obj.touch()
    document.recompute()


if __name__ == "prepare_case":
    tell(prepare)

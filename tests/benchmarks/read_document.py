# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the largest part of any document, and the same part after edits of single dimensions, in FreeCAD.

FEATUREMESH_CASE is JSON: path, edits (how many), folder. Writes 0.json (the raw document as opened), 1.json ... (after each edit, made on the
document opened anew) and part.brep there. The result holds the part's diagonal in mm and the edits that were made.
"""
import signal
import sys
from pathlib import Path

import FreeCAD as App

sys.path.insert(0, str(Path(__file__).parent))

from in_freecad import tell  # noqa: E402
from raw_files import write_raw  # noqa: E402

SHARE = 0.05                # by which a dimension is changed
TRIED_FOR_EACH_EDIT = 3     # dimensions, where FreeCAD cannot recompute with some, or they change nothing
LIMIT_SECONDS = 300         # then FreeCAD ends by a signal, whatever it is in


def read(case):
    from freecad.featuremesh import api, reading
    from freecad.featuremesh.study import dimensions
    folder = Path(case["folder"])
    document = App.openDocument(case["path"])
    part = largest_part(document, reading)
    name, volume = part.Name, part.Shape.Volume
    write_raw(folder / "0.json", reading.read_document(part))
    part.Shape.exportBrep(str(folder / "part.brep"))
    found = {"diagonal": part.Shape.BoundBox.DiagonalLength, "edits": []}
    for edit in spread([edit_of(one) for one in dimensions.of_part(part)], TRIED_FOR_EACH_EDIT * case["edits"]):
        if len(found["edits"]) == case["edits"]:
            break
        App.closeDocument(document.Name)
        document = App.openDocument(case["path"])
        part = document.getObject(name)
        if is_made(document, part, edit, volume, api):
            found["edits"].append(edit)
            write_raw(folder / f"{len(found['edits'])}.json", reading.read_document(part))
    return found


def largest_part(document, reading):
    parts = reading.final_parts(document)
    if not parts:
        raise RuntimeError("there is no solid to mesh")
    return max(parts, key=lambda part: part.Shape.Volume)


def edit_of(dimension):
    """As `--set` takes it."""
    value = dimension.value
    return f"{dimension.target}={value + 1 if isinstance(value, int) else value * (1 + SHARE):.9g}"


def spread(everything, count):
    """At most so many, evenly over the list."""
    count = min(count, len(everything))
    return [everything[(2 * i + 1) * len(everything) // (2 * count)] for i in range(count)]


def is_made(document, part, edit, volume, api):
    """Whether FreeCAD makes the edit, and the part is another valid one by it."""
    try:
        api.set_parameters(document, [edit])
        api.recompute(document)
    except Exception as error:   # whatever FreeCAD says of other people's parts: the next dimension is tried
        print(f"{edit}: {error}")
        return False
    return part.Shape.isValid() and bool(part.Shape.Solids) and abs(part.Shape.Volume - volume) > 1e-9 * volume


if __name__ == "read_document":
    signal.alarm(LIMIT_SECONDS)
    tell(read)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes a part, updates its mesh by each edit, and meshes each edited part from nothing, on one thread, in a process of its own.

mesh_document.py FOLDER SIZE writes measured.json there (see measure); what read_document.py wrote is read.
"""
import json
import sys
from pathlib import Path

from raw_files import read_raw
from timing import processor_seconds


def measure(folder, size):
    """{"first": row, "edits": [{"full": row, "update": row}]}. A row has the message of a refusal, or figures; seconds are those of the processor."""
    import featuremesh_engine as engine
    options = {"size": size, "order": 1, "threads": 1}
    first, old = row_of(lambda: engine.mesh_part(read_raw(folder / "0.json"), options))
    if old is None:
        return {"first": first, "edits": []}
    return {"first": first, "edits": [measure_edit(engine, old, read_raw(path), options) for path in edited(folder)]}


def edited(folder):
    """Files of the part after each edit, in the order of the edits."""
    return sorted(folder.glob("[1-9]*.json"), key=lambda path: int(path.stem))


def measure_edit(engine, old, raw, options):
    update, _ = row_of(lambda: engine.update_part(old, raw, options))
    full, _ = row_of(lambda: engine.mesh_part(raw, options))
    return {"update": update, "full": full}


def row_of(mesh):
    """(row, PartMesh or nothing)"""
    before = processor_seconds()
    try:
        part_mesh, report = mesh()
    except Exception as error:
        return {"refused": str(error).splitlines()[0] if str(error) else type(error).__name__}, None
    return {"processor_seconds": processor_seconds() - before, "seconds": report["seconds"], "tets": report["tets"], "kept": report["kept"]["nodes_share"],
            "fallback": bool(report["fallback"]), "min_dihedral": report["quality"]["min_dihedral"]}, part_mesh


if __name__ == "__main__":
    place = Path(sys.argv[1])
    (place / "measured.json").write_text(json.dumps(measure(place, float(sys.argv[2]))), encoding="utf-8")

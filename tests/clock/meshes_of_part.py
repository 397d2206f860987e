# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes a part, updates the mesh and writes what came out: meshes_of_part.py OLD.json NEW.json SIZE ORDER THREADS prints one line of JSON.

`digest` tells two results apart that differ in a single bit; `clock` is what a tenth of a second took by the clock of this process.
"""
import hashlib
import json
import select
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "benchmarks"))

import featuremesh_engine as engine  # noqa: E402
from raw_files import read_raw  # noqa: E402

MEASURED = ("seconds", "peak_memory_mb")


def main(old, new, size, order, threads):
    options = {"size": float(size), "order": int(order), "threads": int(threads)}
    digest = hashlib.sha256()
    start = time.monotonic()
    select.select([], [], [], 0.1)  # the time that it waits does not come from a clock of this process
    clock = time.monotonic() - start
    raw, edited = read_raw(Path(old)), read_raw(Path(new))
    mesh, report = engine.mesh_part(raw, options)
    add(digest, mesh, report)
    kept, large_cavities = [], []
    for document in (edited, raw):
        mesh, report = engine.update_part(mesh, document, options)
        add(digest, mesh, report)
        kept.append(report["kept"]["nodes_share"])
        large_cavities.append(report["volume"]["large_cavities"])
    for told in (engine.read_tree(raw), engine.compare(raw, edited)):
        add_told(digest, told)
    print(json.dumps({"digest": digest.hexdigest(), "clock": clock, "kept": kept, "tets": report["tets"], "large_cavities": large_cavities}))


def add(digest, mesh, report):
    for name, array in sorted(mesh.arrays().items()):
        digest.update(name.encode() + array.tobytes())
    add_told(digest, {key: value for key, value in report.items() if key not in MEASURED})
    add_told(digest, mesh.owners_of_faces())


def add_told(digest, told):
    digest.update(json.dumps(told, sort_keys=True, default=lambda array: array.tolist()).encode())


main(*sys.argv[1:])

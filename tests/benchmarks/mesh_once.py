# SPDX-License-Identifier: GPL-3.0-or-later
"""One full mesh in a process of its own: mesh_once.py RAW.json SIZE THREADS OUT.json writes the number of tets."""
import json
import sys
from pathlib import Path

from raw_files import read_raw


def main(raw, size, threads, out):
    import featuremesh_engine as engine
    _, report = engine.mesh_part(read_raw(Path(raw)), {"size": float(size), "order": 1, "threads": int(threads)})
    Path(out).write_text(json.dumps({"tets": report["tets"]}), encoding="utf-8")


main(*sys.argv[1:])

# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures every document of a folder: its first mesh, and updates by edits of its dimensions beside full meshes of the edited parts.

Each document is read by a FreeCAD of its own and meshed in a process of its own, so what crashes costs one document. Gmsh's HXT meshes the
first state.
"""
import json
import os
import sys
import tempfile
from pathlib import Path

import numpy
from freecad_task import run_script
from gmsh_peer import mesh_with_gmsh
from layout import RELEASE, Failure
from measured_process import run_measured

PERCENTILES = (10, 30, 50, 70, 80, 90)
LIMIT_SECONDS = 600    # of all meshes of one document
MESHING = ("surface", "volume", "optimise")   # the steps that make elements


def measure(folder, divisor, edits, is_with_peer):
    """Prints a line for every document and a table. Gives {path in the folder: what was measured}. RuntimeError without any document."""
    paths = sorted(Path(folder).rglob("*.FCStd"))
    if not paths:
        raise RuntimeError(f"no document (*.FCStd) is in {folder}")
    found = {}
    for path in paths:
        name = path.relative_to(folder).as_posix()
        try:
            found[name] = measure_document(path, divisor, edits, is_with_peer)
            print(f"{name}: {in_words(found[name])}", flush=True)
        except (RuntimeError, Failure) as error:
            print(f"{name}: not measured: {str(error).splitlines()[0]}", flush=True)
    print("\n".join(table(found, len(paths) - len(found))), flush=True)
    return found


def measure_document(path, divisor, edits, is_with_peer):
    with tempfile.TemporaryDirectory(prefix="featuremesh-bench-") as name:
        folder = Path(name)
        task = {"path": str(path.resolve()), "edits": edits, "folder": name}
        read = run_script(Path(__file__).parent / "read_document.py", {"FEATUREMESH_CASE": json.dumps(task)})
        if read["exit_code"]:
            raise RuntimeError(read["message"])
        size = read["data"]["diagonal"] / divisor
        command = [sys.executable, str(Path(__file__).parent / "mesh_document.py"), name, str(size)]
        run_measured(command, folder / "measured.json", LIMIT_SECONDS, {**os.environ, "PYTHONPATH": str(RELEASE / "bindings")})
        measured = json.loads((folder / "measured.json").read_text(encoding="utf-8"))
        for edit, row in zip(read["data"]["edits"], measured["edits"]):
            row["edit"] = edit
        if is_with_peer and "refused" not in measured["first"]:
            measured["hxt"] = peer_of(folder / "part.brep", size)
        return measured


def peer_of(brep, size):
    """Tets per processor second of HXT's process, or nothing where it gives no mesh."""
    try:
        used, _, tets = mesh_with_gmsh("gmsh-hxt", brep, size, 1)
    except RuntimeError:
        return None
    return len(tets) / used.processor_seconds


def in_words(measured):
    first = measured["first"]
    if "refused" in first:
        return f"refused: {first['refused']}"
    words = [f"{first['tets']:,d} tets in {first['processor_seconds']:.2f} s, smallest angle {first['min_dihedral']:.1f} deg"]
    for row in measured["edits"]:
        refused = next((row[which]["refused"] for which in ("update", "full") if "refused" in row[which]), None)
        words.append(f"{row['edit']} refused: {refused}" if refused else
                     f"{row['edit']} {ratio_of(row):.2f} of a full mesh, {row['update']['kept']:.0%} kept" + (", fallback" if row["update"]["fallback"] else ""))
    return "; ".join(words)


def table(found, not_measured):
    """Lines: counts, then percentiles of each ratio."""
    firsts = [measured["first"] for measured in found.values()]
    meshed = [first for first in firsts if "refused" not in first]
    edits = [row for measured in found.values() for row in measured["edits"]]
    updated = [row for row in edits if "refused" not in row["update"] and "refused" not in row["full"]]
    rows = {"update / full mesh": [ratio_of(row) for row in updated],
            "kept nodes": [row["update"]["kept"] for row in updated],
            "first mesh / meshing alone": [first["seconds"]["engine_total"] / sum(first["seconds"][step] for step in MESHING) for first in meshed],
            "tets per second over HXT's": [measured["first"]["tets"] / measured["first"]["processor_seconds"] / measured["hxt"]
                                           for measured in found.values() if measured.get("hxt")]}
    return [f"{len(found) + not_measured} documents, {not_measured} not measured, {len(firsts) - len(meshed)} refused; {len(edits)} edits, {len(edits) - len(updated)} refused, "
            f"{sum(row['update']['fallback'] for row in updated)} by a fallback",
            f"{'':28s}" + "".join(f"{f'{percent} %':>8s}" for percent in PERCENTILES),
            *(f"{name:28s}" + "".join(f"{value:8.2f}" for value in numpy.percentile(values, PERCENTILES)) for name, values in rows.items() if values)]


def ratio_of(row):
    """Processor seconds of the update over those of a full mesh of the same state."""
    return row["update"]["processor_seconds"] / row["full"]["processor_seconds"]

# SPDX-License-Identifier: GPL-3.0-or-later
"""Solves a part before and after its edit, in FreeCAD, live and with CalculiX, and measures it.

FEATUREMESH_CASE is JSON: part, final, edit, size, order, calculix (its solvers to measure), is_in_document, held_end. In the document everything that a user waits for
counts; else the engine alone is measured, without FreeCAD's mesh. Seconds are [by the clock, of the processors]. The result's data has the figures.
"""
import json
import resource
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

from in_freecad import open_part, tell  # noqa: E402
from timing import processor_seconds  # noqa: E402

THREADS = 2
STEEL = [[210000.0, 0.3, 7.85e-9]]   # MPa, -, t/mm^3
KEEP = "bench"


class Clock:
    """Seconds since it was made."""

    def __init__(self):
        self._wall, self._processors = time.perf_counter(), processor_seconds()

    def read(self):
        return [time.perf_counter() - self._wall, processor_seconds() - self._processors]


def gigabytes(is_now=False):
    """The most memory that this process had, or what it has."""
    if is_now:
        return int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1]) * resource.getpagesize() / 2**30
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20


def figures_of(report):
    return {"iterations": report["iterations"], "energy_error": report["energy_error"], "reused": report["reused"], "seconds": report["seconds"],
            "max_mises": report["responses"]["max_mises_mpa"], "max_displacement": report["responses"]["max_displacement_mm"]}


def in_document(case):
    """As a user works: recompute, solve, result object."""
    from freecad.featuremesh import api
    document = open_part(case["part"])
    mesh = api.add_mesh(document.getObject(case["final"]), case["size"], case["order"], THREADS)
    api.recompute(document)
    analysis = api.find_analysis(document)
    found = {"nodes": mesh.FemMesh.NodeCount, "tets": mesh.FemMesh.VolumeCount}
    clock = Clock()
    report = api.solve_analysis(analysis, "live", THREADS, KEEP)
    found["from scratch"] = {"seconds": clock.read(), "report": figures_of(report)}
    clock = Clock()
    api.set_parameters(document, case["edit"])
    document.recompute()
    recompute = clock.read()
    report = api.solve_analysis(analysis, "live", THREADS, KEEP)
    found["after the edit"] = {"seconds": clock.read(), "recompute": recompute, "mesh": json.loads(mesh.Report)["seconds"], "report": figures_of(report)}
    clock = Clock()
    report = api.solve_analysis(analysis, "live", THREADS)
    found["edited, from scratch"] = {"seconds": clock.read(), "report": figures_of(report)}
    for solver in case["calculix"]:
        document.Solver.MatrixSolverType = solver
        clock = Clock()
        report = api.solve_analysis(analysis, "ccx")
        found["CalculiX, " + solver] = {"seconds": clock.read(), "report": figures_of(report)}
    return found


def of_arrays(case):
    """The solver alone, on a part that is held at its lower end along the axis `held_end` and whose weight pulls along the next axis."""
    import numpy as np
    from freecad.featuremesh import api, engine, reading
    document = open_part(case["part"])
    options = {"size": case["size"], "order": case["order"], "threads": THREADS}
    part, end = document.getObject(case["final"]), "xyz".index(case["held_end"])
    old, _ = engine.load().mesh_part(reading.read_document(part), options)
    found = {"nodes": len(old.arrays()["points"]), "tets": len(old.arrays()["tets"]), "gigabytes before": gigabytes(is_now=True)}

    def solve(mesh, keep):
        arrays = mesh.arrays()
        points, materials = arrays["points"], np.zeros(len(arrays["tets"]), dtype=np.int32)
        held = np.repeat((points[:, end] < points[:, end].min() + 1e-9)[:, None], 3, axis=1)
        clock = Clock()
        loads = engine.load().statics_weight(arrays, STEEL, materials, np.roll([9806.0, 0.0, 0.0], end + 1).tolist())
        model = {"materials": np.array(STEEL), "tet_materials": materials, "loads": loads, "held": held, "given": np.zeros_like(points)}
        fields = engine.load().solve_statics(arrays, model, keep, THREADS)
        return {"seconds": clock.read(), "report": {
            "iterations": fields["iterations"], "energy_error": fields["energy_error"], "seconds": dict(fields["seconds"]),
            "reused": {"preconditioner": fields["kept_preconditioner"], "start_share": fields["kept_start_share"]},
            "max_mises": float(fields["von_mises"].max()), "max_displacement": float(np.linalg.norm(fields["displacements"], axis=1).max())}}

    found["from scratch"] = solve(old, KEEP)
    found["gigabytes"] = gigabytes()
    if case["edit"]:
        api.set_parameters(document, case["edit"])
        api.recompute(document)
        new, _ = engine.load().update_part(old, reading.read_document(part), options)
        found["after the edit"] = solve(new, KEEP)
        found["edited, from scratch"] = solve(new, "")
    return found


def measure(case):
    return in_document(case) if case["is_in_document"] else of_arrays(case)


if __name__ == "solve_once":
    tell(measure)

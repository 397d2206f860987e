# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures studies: their cases beside the same cases meshed anew by FreeCAD's Gmsh object, the growth with the number of cases, one process against two.

Seconds are those of the processors, so that what else the machine does counts less.
"""
import json
import resource
import sqlite3
import statistics
import tempfile
import threading
import time
from dataclasses import dataclass
from pathlib import Path

import study_commands
from freecad_task import freecad_environment, freecadcmd, run_script
from layout import EXAMPLES

study_commands.workbench()
from freecad.featuremesh.study import beginning, design, response_words  # noqa: E402
from freecad.featuremesh.study.runner import Machine, Runner  # noqa: E402
from freecad.featuremesh.study.steps import PROCESSORS, processor_seconds  # noqa: E402

_STEPS = ("recompute", "mesh", "hand_over", "write", "solve", "read", "responses", "hashes")
_OVERHEAD = "overhead"   # what is no step: the copy of the process, the runner, the database
_LOOK_EVERY = 0.1        # s between two looks of another program into the database


@dataclass(frozen=True)
class Case:
    name: str
    about: str
    what: str                 # peer, growth or jobs
    part: str
    parameters: tuple         # as for --vary
    responses: str
    size: float
    cases: tuple              # how many: of the study, of the peer; of a growth each number
    solver: str = None


_BRACKET = {"part": "bracket", "parameters": ("HoleSketch.Hole6X=95:115", "Fillet.Radius=2:6"), "responses": "mass,max_mises,max_displacement", "size": 3.0}
_BLOCK = {"part": "block_and_cylinder", "parameters": ("Cylinder.Radius=6:9", "Cylinder.Height=30:40"), "responses": "volume", "size": 8.0}
CASES = (
    Case("study-bracket", "10-node, two parameters, CalculiX, beside Gmsh", "peer", cases=(4, 4), solver="ccx", **_BRACKET),
    Case("study-bracket-live", "10-node, two parameters, live, beside Gmsh and CalculiX", "peer", cases=(12, 3), solver="live", **_BRACKET),
    Case("study-growth", "a small part without a solution, 100 and 1000 cases", "growth", cases=(100, 1000), **_BLOCK),
    Case("study-jobs", "a small part without a solution, by one process and by two", "jobs", cases=(1000,), **_BLOCK),
)


def named(name):
    return next((case for case in CASES if case.name == name), None)


def measure(case):
    """Measures one case and prints its rows. Gives the figures."""
    print(f"{case.name}: {case.about}, size {case.size:g} mm, one thread; processor seconds a case", flush=True)
    with tempfile.TemporaryDirectory(prefix="featuremesh-bench-") as folder:
        return {"peer": beside_gmsh, "growth": growth, "jobs": one_and_two}[case.what](case, Path(folder))


def beside_gmsh(case, folder):
    ours = run_study(case, case.cases[0], folder / "study")
    theirs = run_peer(case, folder / "study", ours["cases"][:case.cases[1]])
    names = [name for name in (*_STEPS, _OVERHEAD) if any(name in row["steps"] for row in (ours, theirs))]
    print(f"  {'':20s} {'nodes':>9s} {'total':>8s}  " + " ".join(f"{name:>9s}" for name in names))
    for who, row in (("ours", ours), ("Gmsh and CalculiX", theirs)):
        print(f"  {who:20s} {row['nodes']:9,.0f} {row['total']:8.2f}  " + " ".join(f"{row['steps'].get(name, 0.0):9.3f}" for name in names))
    if theirs["failed"]:
        print(f"  Gmsh and CalculiX failed in {len(theirs['failed'])} of {case.cases[1]} cases")
    meshing = ours["steps"]["mesh"], ours["steps"]["mesh"] + ours["steps"]["hand_over"]
    ratios = {"end_to_end": ours["total"] / theirs["total"], "meshing": meshing[0] / theirs["steps"]["mesh"],
              "meshing_with_hand_over": meshing[1] / theirs["steps"]["mesh"]}
    print(f"  ours / Gmsh: end to end {ratios['end_to_end']:.1%}, meshing {ratios['meshing']:.1%}, with the hand-over to FreeCAD, which Gmsh's has, too, "
          f"{ratios['meshing_with_hand_over']:.1%}\n", flush=True)
    return {"ours": figures_of(ours), "gmsh": figures_of(theirs), **ratios}


def growth(case, folder):
    rows = [run_study(case, count, folder / str(count)) for count in case.cases]
    show_studies(rows)
    ratio = rows[-1]["total"] / rows[0]["total"]
    print(f"  a case of {case.cases[-1]} / one of {case.cases[0]}: {ratio:.3f}\n", flush=True)
    return {"growth": ratio, "rows": [figures_of(row) for row in rows]}


def one_and_two(case, folder):
    rows = [run_study(case, case.cases[0], folder / str(jobs), jobs) for jobs in (1, 2)]
    show_studies(rows)
    same = [one["result"] for one in rows[0]["cases"]] == [one["result"] for one in rows[1]["cases"]]
    ratio, speed = rows[1]["total"] / rows[0]["total"], rows[0]["wall"] / rows[1]["wall"]
    print(f"  by two processes a case takes {ratio:.2f} times as long of the processors; they are {speed:.2f} times as fast by the clock; "
          f"{'the same' if same else 'OTHER'} bits\n", flush=True)
    if not same:
        raise RuntimeError("the results have other bits")
    return {"processors": ratio, "speed": speed, "rows": [figures_of(row) for row in rows]}


def show_studies(rows):
    for row in rows:
        print(f"  {len(row['cases']):5d} cases by {row['jobs']} process{'es' if row['jobs'] > 1 else ''}: {row['wall']:7.1f} s by the clock, "
              f"{row['total']:.4f} s a case, of which overhead {row['steps'][_OVERHEAD]:.4f}; its database was read {row['reads']} times meanwhile, in "
              f"{1000 * row['slowest_read']:.1f} ms at most", flush=True)


def run_study(case, count, path, jobs=1):
    """Runs the study; the means of what its cases took."""
    study = design.Study(str(EXAMPLES / (case.part + ".FCStd")), [design.parse_parameter(text) for text in case.parameters],
                         response_words.parse_list(case.responses), solver=case.solver, sampling="sobol", cases=count, mesh_size=case.size, mesh_order=2)
    folder = beginning.begin(study, path, study_commands.make_base)
    reader = Reader(path / "study.sqlite")
    start, worked = time.perf_counter(), processor_seconds(resource.RUSAGE_SELF)
    with reader, Runner(folder, Machine(freecadcmd(), freecad_environment(), jobs)) as runner:
        runner.run()
    of_runner = processor_seconds(resource.RUSAGE_SELF) - worked - reader.worked
    found = [{"seconds": one.seconds, "nodes": one.mesh["nodes"], "parameters": one.parameters, "id": one.id, "result": one.hashes["result"]}
             for one in folder.database.cases("done")]
    if len(found) < count:
        raise RuntimeError(f"{count - len(found)} cases are not done; see {path}")
    return {**means(found, of_runner / count), "wall": time.perf_counter() - start, "jobs": jobs, "reads": reader.count, "slowest_read": reader.slowest}


def run_peer(case, path, cases):
    """The same cases by FreeCAD's Gmsh object and CalculiX, in copies of a process that has the document open."""
    task = {"base": str(path / "base.FCStd"), "size": case.size, "threads": 1, "folder": str(path),
            "cases": [{"id": one["id"], "set": ["%s=%r" % entry for entry in one["parameters"].items()]} for one in cases]}
    result = run_script(Path(__file__).parent / "study_peer.py", {"FEATUREMESH_CASE": json.dumps(task)})
    if result["exit_code"]:
        raise RuntimeError(result["message"])
    done, failed = result["data"]["done"], result["data"]["failed"]
    if not done:
        raise RuntimeError(f"the peer failed in all cases; see {path}")
    return {**means(done, 0.0), "failed": failed}


def means(cases, of_runner):
    """By step, of processor seconds; `of_runner` are those of the runner for each case."""
    processors = [one["seconds"][PROCESSORS] for one in cases]
    steps = {name: statistics.mean(entry[name] for entry in processors) for name in processors[0] if name != "total"}
    total = statistics.mean(entry["total"] for entry in processors) + of_runner
    return {"cases": cases, "nodes": statistics.mean(one["nodes"] for one in cases), "total": total, "steps": {**steps, _OVERHEAD: total - sum(steps.values())}}


def figures_of(row):
    return {name: value for name, value in row.items() if name != "cases"} | {"cases": len(row["cases"])}


class Reader:
    """Another program that reads a study's database as long as the `with` statement lasts."""

    def __init__(self, path):
        self.count, self.slowest, self.worked = 0, 0.0, 0.0
        self._path, self._end = path, threading.Event()
        self._thread = threading.Thread(target=self._read)

    def __enter__(self):
        self._thread.start()

    def __exit__(self, *_):
        self._end.set()
        self._thread.join()

    def _read(self):
        while not self._end.wait(_LOOK_EVERY):
            start = time.perf_counter()
            link = sqlite3.connect(self._path, timeout=0)
            link.execute("select state, responses, seconds from cases").fetchall()
            link.close()
            self.slowest = max(self.slowest, time.perf_counter() - start)
            self.count += 1
        self.worked = processor_seconds(resource.RUSAGE_THREAD)

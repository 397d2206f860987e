# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures linear statics: live from scratch and after an edit, beside CalculiX on the same document, and the solver alone on large meshes."""
import json
from dataclasses import asdict, dataclass
from pathlib import Path

from freecad_task import run_script

SOLVERS = ("spooles", "iterativecholesky")   # where the choice is ours, large models get the second; the first is what CalculiX chooses
_ROWS = ("from scratch", "after the edit", "edited, from scratch", *("CalculiX, " + solver for solver in SOLVERS))


@dataclass(frozen=True)
class Case:
    name: str
    part: str
    final: str
    edit: tuple
    size: float
    order: int
    about: str
    is_in_document: bool = True
    calculix: tuple = SOLVERS
    held_end: str = "z"   # where the solver alone is measured: along which axis the part is held at its lower end; its weight pulls along the next


CASES = (
    Case("statics-bracket", "bracket", "Body", ("HoleSketch.Hole6X=105",), 1.5, 1, "4-node, one hole moved by 5 mm"),
    Case("statics-bracket-10", "bracket", "Body", ("HoleSketch.Hole6X=105",), 2.5, 2, "10-node, one hole moved by 5 mm"),
    Case("statics-plate-625", "plate_625", "Plate", ("Hole312.Radius=3.5",), 1.46, 1, "4-node, one of 625 holes changed, the solver alone", False, ()),
    *(Case(f"statics-size-{size:g}", "bracket", "Body", (), size, 2, "10-node, the solver alone", False, ()) for size in (3.5, 2.5, 1.08)),
    *(Case(f"statics-size-{size:g}-4", "bracket", "Body", (), size, 1, "4-node, the solver alone", False, ()) for size in (2.5, 1.5, 0.65)),
    *(Case(f"statics-{part.replace('_', '-')}-{kind}", part, "Part", (), size, order, f"{kind}-node, {about}, the solver alone", False, (), "x")
      for part, size, about in (("walls_50", 3, "open box 50 x 40 x 30, walls of 1"), ("walls_100", 3, "open box 100 x 80 x 60, walls of 1"),
                                ("rod_200", 0.5, "rod 200 x 1 x 1"))
      for order, kind in ((1, "4"), (2, "10"))),
)


def named(name):
    return next((case for case in CASES if case.name == name), None)


def measure(case, threads=2):
    """Measures one case and prints its rows. Gives the figures."""
    print(f"{case.name}: {case.about}, size {case.size:g} mm, {threads} threads", flush=True)
    result = run_script(Path(__file__).parent / "solve_once.py", {"FEATUREMESH_CASE": json.dumps(asdict(case))})
    if result["exit_code"]:
        raise RuntimeError(result["message"])
    found = result["data"]
    print(f"  {found['nodes']:,d} nodes, {found['tets']:,d} tets" + (
        f"; {found['gigabytes']:.2f} GB at most, {found['gigabytes before']:.2f} GB before solving" if "gigabytes" in found else ""))
    print(f"  {'':28s} {'seconds':>8s} {'of proc.':>8s} {'iterations':>10s} {'us/unkn.':>8s}  steps")
    for row in _ROWS:
        if row in found:
            print("  " + row_in_words(row, found[row], found["nodes"]), flush=True)
    return found


def row_in_words(name, row, nodes):
    report, (wall, processors) = row["report"], row["seconds"]
    steps = {key: value for key, value in report["seconds"].items() if value and key != "total"}
    if "recompute" in row:
        steps = {"FreeCAD and mesh": row["recompute"][0], "of which hand-over": row["mesh"]["hand_over"], **steps}
    return (f"{name:28s} {wall:8.2f} {processors:8.2f} {report['iterations'] or '-':>10} {1e6 * processors / (3 * nodes):8.1f}  "
            + ", ".join(f"{key} {value:.2f}" for key, value in steps.items()))

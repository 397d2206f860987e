# SPDX-License-Identifier: GPL-3.0-or-later
"""The demo's work inside FreeCAD: mesh the bracket, solve, move a hole, update the mesh, solve again.

Writes documents, numbers and arrays to the folder named by FEATUREMESH_DEMO_OUT; draw_report.py makes pictures of them.
"""
import json
import os
import shutil
import sys
import time
import traceback
from pathlib import Path

import FreeCAD as App
import freecad
import numpy as np

ROOT = Path(__file__).resolve().parents[2]
OUT = Path(os.environ["FEATUREMESH_DEMO_OUT"])
SIZE = 2.5
EDIT = "HoleSketch.Hole6X=105"
EDIT_IN_WORDS = "the hole at (110, 70) is moved by 5 mm, to (105, 70)"


def say(line=""):
    print("featuremesh: " + line, file=sys.stderr, flush=True)


def run():
    from freecad.featuremesh import api, documents, engine, reading
    from freecad.featuremesh.mesh_object import options_of
    from freecad.featuremesh.messages import in_english
    from freecad.featuremesh.tables import verdict_in_words
    OUT.mkdir(parents=True, exist_ok=True)
    path = OUT / "bracket.FCStd"
    shutil.copyfile(ROOT / "resources" / "examples" / "bracket.FCStd", path)
    document = App.openDocument(str(path))
    part = document.getObject("Body")
    numbers = {"size": SIZE, "edit": EDIT_IN_WORDS, "read": read_part(api, part)}

    mesh = api.add_mesh(part, SIZE, order=1)
    api.update_mesh(mesh)
    numbers["first"] = json.loads(mesh.Report)
    tell_mesh("First mesh", numbers["first"])
    old = mesh.Proxy.last_part_mesh(mesh)
    old_numbers = number_arrays(old)
    numbers["first_solution"], old_fields = solve(document, old_numbers)
    numbers["first_live"] = solve_live(document)
    documents.save_document(document, str(path))   # FreeCAD's own way leaves the file before as .FCStd1

    say(f"Edit           {EDIT_IN_WORDS}  ({EDIT})")
    api.set_parameters(document, [EDIT])
    numbers["recompute_seconds"] = api.recompute(document)
    numbers["update"] = in_english(json.loads(mesh.Report))
    for feature in numbers["update"]["difference"]["features"]:
        feature["what_happened"] = verdict_in_words(feature["verdict"])
    new = mesh.Proxy.last_part_mesh(mesh)
    numbers["full"] = mesh_in_full(engine.load(), reading.read_document(part), options_of(mesh, part))
    tell_update(numbers)
    new_numbers = number_arrays(new)
    numbers["second_solution"], new_fields = solve(document, new_numbers)
    numbers["second_live"] = solve_live(document)
    documents.save_document(document, str(OUT / "bracket_edited.FCStd"))

    kept = new_numbers["tet_origin"]
    old_numbers["tet_kept"] = np.isin(np.arange(len(old_numbers["tets"])), kept[kept >= 0])
    np.savez(OUT / "old.npz", **old_numbers, **old_fields)
    np.savez(OUT / "new.npz", **new_numbers, **new_fields, active=new.active_points())
    (OUT / "numbers.json").write_text(json.dumps(numbers, indent=1), encoding="utf-8")


def mesh_in_full(api, raw, options):
    """The report of a full mesh of the edited part, made only to compare with."""
    _, report = api.mesh_part(raw, options)
    return {name: report[name] for name in ("nodes", "tets", "size", "seconds", "quality")}


def read_part(api, part):
    start = time.perf_counter()
    tree = api.tree(part)
    seconds = time.perf_counter() - start
    features = [feature for feature in tree["features"] if feature["volumes"]]
    say(f"Read           {len(features)} features, {len(part.Shape.Faces)} faces, {tree['cells']} cells in {seconds:.2f} s: "
        + ", ".join(feature["label"] for feature in features))
    return {"features": [(f["label"], f["type"], f["role"]) for f in features], "faces": len(part.Shape.Faces),
            "cells": tree["cells"], "seconds": seconds, "volume": part.Shape.Volume}


def tell_mesh(what, report):
    quality = report["quality"]
    say(f"{what:14s} {report['tets']} elements, {report['nodes']} nodes, size {report['size']:g} mm, "
        f"{report['seconds']['engine_total']:.2f} s; smallest dihedral angle {quality['min_dihedral']:.1f} deg, "
        f"mean radius ratio {quality['mean_radius_ratio']:.3f}")


def tell_update(numbers):
    update, full = numbers["update"], numbers["full"]
    shown = {name for name, _, _ in numbers["read"]["features"]}
    changed = [f"{f['label']} {f['what_happened']}" + (f" ({f['detail']})" if f["detail"] else "")
               for f in update["difference"]["features"] if f["verdict"] != "same" and f["label"] in shown]
    say("Difference     " + ("; ".join(changed) or "none") + "; all other features are the same")
    tell_mesh("Updated mesh", update)
    tell_mesh("Full mesh", full)
    ratio = update["seconds"]["engine_total"] / full["seconds"]["engine_total"]
    say(f"Kept           {update['kept']['nodes_share']:.1%} of the nodes and {update['kept']['tets_share']:.1%} of the elements, bit for bit; "
        f"the update took {ratio:.0%} of the full mesh's time")
    if update["fallback"]:
        say("Not kept       " + str(update["fallback"]))


def number_arrays(part_mesh):
    """What the pictures need of a mesh; copies, since the engine's arrays are views."""
    arrays = part_mesh.arrays()
    wanted = {name: np.array(arrays[name]) for name in ("points", "tets", "node_numbers", "tet_numbers")}
    return {**wanted, "tet_origin": np.array(part_mesh.tet_origin()), "node_origin": np.array(part_mesh.node_origin())}


def solve(document, mesh):
    """Runs CalculiX on the document's analysis: the largest values, and displacement and stress by node of the mesh."""
    from femtools import ccxtools
    start = time.perf_counter()
    tool = ccxtools.FemToolsCcx(document.getObject("Analysis"), document.getObject("Solver"), test_mode=False)
    tool.update_objects()
    tool.setup_working_dir()
    tool.setup_ccx(ccx_binary=shutil.which("ccx"))
    problems = tool.check_prerequisites()
    if problems:
        raise RuntimeError("CalculiX cannot run: " + problems)
    tool.purge_results()
    tool.write_inp_file()
    if tool.ccx_run() != 0:
        raise RuntimeError("CalculiX failed; its files are in " + tool.working_dir)
    tool.load_results()
    result = next(member for member in document.getObject("Analysis").Group if member.isDerivedFrom("Fem::FemResultObject"))
    rows = rows_of_result(result, mesh["node_numbers"])
    displacement, stress = np.zeros((len(rows), 3)), np.zeros(len(rows))
    displacement[rows] = [tuple(vector) for vector in result.DisplacementVectors]
    stress[rows] = result.vonMises
    solution = {"displacement": float(np.linalg.norm(displacement, axis=1).max()), "stress": float(stress.max()),
                "seconds": time.perf_counter() - start}
    say(f"CalculiX       largest displacement {solution['displacement']:.4f} mm, largest von Mises stress "
        f"{solution['stress']:.1f} MPa, {solution['seconds']:.1f} s")
    return solution, {"displacement": displacement, "stress": stress}


def solve_live(document):
    """Likewise by the live solver, which reuses its first solution for the second; None where PETSc is not installed."""
    from freecad.featuremesh import engine, statics
    if engine.load().statics_missing():
        say("Live           not solved: PETSc is not installed")
        return None
    _, report = statics.solve(document.getObject("Analysis"), keep="demo")
    found, seconds = report["responses"], report["seconds"]["total"]
    reused = ", with the set-up of the first" if report["reused"]["preconditioner"] else ""
    say(f"Live           largest displacement {found['max_displacement_mm']:.4f} mm, largest von Mises stress {found['max_mises_mpa']:.1f} MPa on "
        f"{found['max_mises_at']['on']}, {seconds:.1f} s{reused}")
    return {"displacement": found["max_displacement_mm"], "stress": found["max_mises_mpa"], "seconds": seconds, "reused": report["reused"]}


def rows_of_result(result, numbers):
    """By node of a result the row of the mesh's arrays. FreeCAD counts the nodes of a result from 1, in the order of their numbers."""
    if len(result.NodeNumbers) != len(numbers):
        raise RuntimeError(f"the result has {len(result.NodeNumbers)} nodes, the mesh {len(numbers)}")
    return np.argsort(numbers)[np.argsort(np.argsort(result.NodeNumbers))]


def main():
    try:
        run()
        result = {"exit_code": 0, "message": f"the demo is done; open {OUT / 'report.html'}", "data": {}}
    except Exception as error:
        traceback.print_exc()
        result = {"exit_code": 1, "message": f"the demo failed: {error}", "data": {}}
    Path(os.environ["FEATUREMESH_RESULT"]).write_text(json.dumps(result), encoding="utf-8")


if __name__ == "run_demo":
    freecad.__path__.append(str(ROOT / "Mod" / "FeatureMesh" / "freecad"))
    main()

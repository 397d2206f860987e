# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the full mesh, the update and Gmsh on the same parts in one run, and prints a table.

Seconds of the engine are its `engine_total` (from FreeCAD's shapes to a validated mesh); Gmsh's are those of its whole
process. In every round each of them runs once, one after the other, and ratios are medians of the rounds' ratios, so that
a machine that is slower for a while does not bend them. Results are appended to build/benchmarks.jsonl.
"""
import argparse
import json
import os
import platform
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(Path(__file__).parent), str(ROOT / "resources" / "launcher"), str(ROOT / "build" / "release" / "bindings"),
                str(ROOT / "Mod" / "FeatureMesh")]

import bench_documents  # noqa: E402
import bench_statics  # noqa: E402
import bench_study  # noqa: E402
import cases  # noqa: E402
from closed_pipe import run_until_unread  # noqa: E402
from freecad.featuremesh.messages import english  # noqa: E402
from freecad_task import run_script  # noqa: E402
from gmsh_peer import ALGORITHMS, mesh_with_gmsh, quality_of  # noqa: E402
from measured_process import run_measured  # noqa: E402
from netgen_peer import mesh_with_netgen  # noqa: E402
from raw_files import read_raw  # noqa: E402
from timing import seconds_of, shortest  # noqa: E402

RESULTS = ROOT / "build" / "benchmarks.jsonl"
OTHERS = {"statics": bench_statics, "study": bench_study}   # measured in ways of their own; by the key of their figures in the results
OURS = ("full mesh", "update")
TWO_THREADS = "on two threads"
SLOW_PEER = 20  # seconds; a peer that takes longer is measured in one round only
HEADER = (f"  {'':14s} {'tets':>9s} {'seconds':>8s} {'spread':>13s} {'tets/s':>9s} {'min deg':>8s} {'max deg':>8s} {'ratio':>6s} {'<25 deg':>8s} "
          f"{'GB/Mtets':>8s}")


def main():
    given = parse_arguments()
    if given.list:
        for case in all_cases():
            print(f"{case.name:20s} {case.about}, size {case.size:g} mm")
        return 0
    if given.history:
        return show_history(given.case)
    if given.documents:
        return measure_documents(given)
    names = given.case or [case.name for case in all_cases()]
    unknown = [name for name in names if name not in [case.name for case in all_cases()]]
    if unknown:
        print(f"featuremesh bench: there is no case {unknown[0]}; ./featuremesh bench --list names all", file=sys.stderr)
        return 2
    others = [(kind, case) for kind, bench in OTHERS.items() for case in map(bench.named, names) if case]
    chosen = [case for case in map(cases.named, names) if case]
    failed, updates, cells, per_tet = 0, {}, {}, {}
    for case in chosen:
        try:
            updates[case.name], cells[case.name], per_tet[case.name] = measure(case, given)
        except Exception as error:
            failed += 1
            print(f"  {case.name} failed: {error}", file=sys.stderr, flush=True)
    for kind, case in others:
        try:
            measure_other(kind, case)
        except Exception as error:
            failed += 1
            print(f"  {case.name} failed: {error}", file=sys.stderr, flush=True)
    if "bracket" in per_tet and "bracket-finest" in per_tet:
        print(f"growth: a tet of the finest bracket takes {per_tet['bracket-finest'] / per_tet['bracket']:.2f} times the time of one at size 1.5")
    if "bosses-1" in updates and "bosses-64" in updates:
        print(f"growth: the update with 64 bosses takes {updates['bosses-64'] / updates['bosses-1']:.2f} times that with 1")
    if "features-150" in cells and "features-600" in cells:
        print(f"growth: the cells of 600 features take {cells['features-600'] / cells['features-150']:.1f} times those of 150 (n log n: 5.1)")
    print(f"{len(chosen) + len(others) - failed} of {len(chosen) + len(others)} cases measured; appended to {RESULTS}")
    return 1 if failed else 0


def measure_documents(given):
    if given.case or given.threads != 1 or given.netgen:
        print("featuremesh bench: --documents measures on one thread, beside Gmsh at most; leave out --case, --threads and --netgen", file=sys.stderr)
        return 2
    try:
        found = bench_documents.measure(given.documents, given.divisor, given.edits, not given.ours)
    except RuntimeError as error:
        print(f"featuremesh bench: {error}", file=sys.stderr)
        return 2
    append_to_results({"case": "documents", "divisor": given.divisor, "machine": machine(), "documents": found})
    return 0 if found else 1


def all_cases():
    return [case for bench in (cases, *OTHERS.values()) for case in bench.CASES]


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--case", action="append")
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--netgen", action="store_true", help="Netgen, too, in one round")
    parser.add_argument("--ours", action="store_true", help="without Gmsh")
    parser.add_argument("--documents")
    parser.add_argument("--divisor", type=float, default=40)
    parser.add_argument("--edits", type=int, default=3)
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--history", action="store_true", help="what was measured before, by case and commit")
    return parser.parse_args()


def measure(case, given):
    """Measures one case, prints its rows and appends them to the results. Gives the median seconds of the update, of the cells, and of the full mesh per tet."""
    print(f"{case.name}: {case.about}, size {case.size:g} mm, {given.threads} thread{'s' if given.threads > 1 else ''}, "
          f"{given.repeat} rounds\n{HEADER}", flush=True)
    with tempfile.TemporaryDirectory(prefix="featuremesh-bench-") as name:
        folder = Path(name)
        prepare(case, folder)
        rows = run_rounds(case, folder, given)
        reading = reading_of(folder)
        query = seconds_of_a_query(case, folder)
        cells = seconds_of_cells(folder, reading)
    for who, row in rows.items():
        print(row_in_words(who, row), flush=True)
    summary = compare_rows(rows) | {"sizing_query": query, "cells": cells}
    for line in summary_in_words(summary):
        print("  " + line, flush=True)
    print(f"  first mesh / meshing alone {summary['first_over_meshing']:.3f}; difference {summary['difference']:.3f} s; cells, which only tree and diff make, "
          f"{summary['cells']:.3f} s", flush=True)
    print(f"  surface {summary['surface_triangles_per_second']:,.0f} triangles/s; graded sizing field {1e6 * query:.3f} us a query", flush=True)
    print(f"  reading the tree {reading['read']:.4f} s in FreeCAD + {reading['interpret']:.4f} s in the engine, {reading['share']:.1%} of "
          f"FreeCAD's recompute ({reading['recompute']:.3f} s); after the edit + {reading['interpret_again']:.4f} s, {reading['share_again']:.1%}\n", flush=True)
    record = {"case": case.name, "size": case.size, "threads": given.threads, "machine": machine(), "rows": rows, "summary": summary,
              "reading": reading}
    append_to_results(record)
    full = rows["full mesh"]
    return statistics.median(rows["update"]["seconds"]), summary["cells"], statistics.median(full["seconds"]) / full["tets"]


def measure_other(kind, case):
    append_to_results({"case": case.name, "size": case.size, "machine": machine(), kind: OTHERS[kind].measure(case)})


def append_to_results(record):
    with open(RESULTS, "a", encoding="utf-8") as results:
        results.write(json.dumps(record) + "\n")


def prepare(case, folder):
    task = {"part": case.part, "after": case.after, "final": case.final, "edit": case.edit, "folder": str(folder)}
    result = run_script(Path(__file__).parent / "prepare_case.py", {"FEATUREMESH_CASE": json.dumps(task)})
    if result["exit_code"]:
        raise RuntimeError(result["message"])


def run_rounds(case, folder, given):
    """By mesher: the seconds of every round, and the figures of its mesh."""
    import featuremesh_engine as engine
    options = {"size": case.size, "order": 1, "threads": given.threads}
    old_raw, new_raw = (read_raw(folder / name) for name in ("old.json", "new.json"))
    old, _ = engine.mesh_part(old_raw, options)
    rows = {}
    for _ in range(given.repeat):
        _, report = engine.mesh_part(new_raw, options)
        add_round(rows, "full mesh", report["seconds"]["engine_total"], figures_of(report))
        if given.threads == 1 and os.cpu_count() > 1:
            _, report = engine.mesh_part(new_raw, {**options, "threads": 2})
            add_round(rows, TWO_THREADS, report["seconds"]["engine_total"], figures_of(report))
        _, report = engine.update_part(old, new_raw, options)
        add_round(rows, "update", report["seconds"]["engine_total"], figures_of(report) | kept_of(report))
        for peer in () if given.ours else ALGORITHMS:
            if peer in rows and rows[peer]["seconds"][0] > SLOW_PEER:
                continue
            add_peer_round(rows, peer, lambda: mesh_with_gmsh(peer, folder / "new.brep", case.size, given.threads))
    rows["full mesh"]["peak_memory_mb"] = memory_of_a_full_mesh(folder, case.size, given.threads)
    if given.netgen:
        add_peer_round(rows, "netgen", lambda: mesh_with_netgen(folder / "new.step", case.size))
    return rows


def memory_of_a_full_mesh(folder, size, threads):
    """MB of a process that does nothing else."""
    out = folder / "once.json"
    command = [sys.executable, str(Path(__file__).parent / "mesh_once.py"), str(folder / "new.json"), str(size), str(threads), str(out)]
    engine = {**os.environ, "PYTHONPATH": str(ROOT / "build" / "release" / "bindings")}
    return run_measured(command, out, limit_seconds=600, environment=engine).megabytes


def seconds_of_a_query(case, folder, count=1_000_000):
    """Of a graded sizing field: the median of five times over random points of the part's box."""
    import featuremesh_engine as engine
    part_mesh, _ = engine.mesh_part(read_raw(folder / "old.json"), {"size": 4 * case.size, "order": 1, "elements_per_circle": 24})
    points = part_mesh.arrays()["points"]
    places = numpy.random.default_rng(1).uniform(points.min(axis=0), points.max(axis=0), (count, 3))
    seconds = []
    for _ in range(5):
        start = time.perf_counter()
        part_mesh.wanted_sizes(places)
        seconds.append((time.perf_counter() - start) / count)
    return statistics.median(seconds)


def reading_of(folder):
    """Seconds to read the edited part and to interpret it, from nothing and after the edit, and their share of FreeCAD's own recompute of the document: the
    shortest of several rounds each."""
    import featuremesh_engine as engine
    old, new = (read_raw(folder / name) for name in ("old.json", "new.json"))
    seconds = json.loads((folder / "reading.json").read_text(encoding="utf-8"))
    seconds |= {"interpret": shortest(lambda: engine.seconds_to_interpret(new)), "interpret_again": shortest(lambda: engine.seconds_to_interpret(new, old))}
    share = {name: (seconds["read"] + seconds[interpret]) / seconds["recompute"]
             for name, interpret in (("share", "interpret"), ("share_again", "interpret_again"))}
    return {**seconds, **share}


def seconds_of_cells(folder, reading):
    """To fuse the volumes of the edited part's features: reading its tree without interpreting it; the shortest of several rounds."""
    import featuremesh_engine as engine
    new = read_raw(folder / "new.json")
    return shortest(lambda: seconds_of(lambda: engine.read_tree(new))) - reading["interpret"]


def add_peer_round(rows, peer, mesh_once):
    try:
        used, points, tets = mesh_once()
    except RuntimeError as error:
        print(f"  {peer}: {error}", file=sys.stderr)
        return
    figures = {"tets": len(tets), "peak_memory_mb": used.megabytes} | ({} if peer in rows else quality_of(points, tets))
    add_round(rows, peer, used.seconds, figures)


def add_round(rows, who, seconds, figures):
    row = rows.setdefault(who, {"seconds": []})
    row["seconds"].append(seconds)
    for step, value in figures.get("steps", {}).items():
        row.setdefault("all_steps", {}).setdefault(step, []).append(value)
    if "steps" in figures:
        row.setdefault("first_over_meshing", []).append(seconds / sum(figures["steps"][step] for step in bench_documents.MESHING))
    row.update(figures)


def figures_of(report):
    quality = {name: report["quality"][name] for name in ("min_dihedral", "max_dihedral", "mean_radius_ratio", "below_25")}
    return {"tets": report["tets"], "new_triangles": report["surface"]["new_triangles"], "steps": report["seconds"], **quality}


def kept_of(report):
    return {"kept_nodes": report["kept"]["nodes_share"], "kept_tets": report["kept"]["tets_share"], "fallback": english(report["fallback"]) or None}


def compare_rows(rows):
    """Medians of the rounds' ratios, and what the update kept."""
    update, full = rows["update"]["seconds"], rows["full mesh"]["seconds"]
    summary = {"kept_nodes": rows["update"]["kept_nodes"], "kept_tets": rows["update"]["kept_tets"],
               "update_over_full": statistics.median(a / b for a, b in zip(update, full)), "fallback": rows["update"]["fallback"],
               "mean_radius_ratio_less": rows["full mesh"]["mean_radius_ratio"] - rows["update"]["mean_radius_ratio"],
               "min_dihedral_less": rows["full mesh"]["min_dihedral"] - rows["update"]["min_dihedral"]}
    summary["difference"] = statistics.median(rows["update"]["all_steps"]["difference"])
    summary["first_over_meshing"] = statistics.median(rows["full mesh"]["first_over_meshing"])
    summary["surface_triangles_per_second"] = rows["full mesh"]["new_triangles"] / statistics.median(rows["full mesh"]["all_steps"]["surface"])
    if TWO_THREADS in rows:
        summary["two_threads_over_one"] = statistics.median(a / b for a, b in zip(full, rows[TWO_THREADS]["seconds"]))
    for peer in ALGORITHMS:
        if peer in rows:
            seconds = rows[peer]["seconds"]
            summary[f"update_over_{peer}"] = statistics.median(a / b for a, b in zip(update, seconds))
            for who, name in (("full mesh", f"full_speed_over_{peer}"), (TWO_THREADS, f"speed_of_two_threads_over_{peer}")):
                if who in rows:
                    summary[name] = statistics.median((rows[who]["tets"] / a) / (rows[peer]["tets"] / b) for a, b in zip(rows[who]["seconds"], seconds))
    return summary


def row_in_words(who, row):
    middle = statistics.median(row["seconds"])
    spread = f"{min(row['seconds']):.2f}..{max(row['seconds']):.2f}"
    memory = f"{row['peak_memory_mb'] / 1024 / (row['tets'] / 1e6):8.2f}" if "peak_memory_mb" in row else ""
    return (f"  {who:14s} {row['tets']:9,d} {middle:8.3f} {spread:>13s} {row['tets'] / middle:9,.0f} {row['min_dihedral']:8.1f} {row['max_dihedral']:8.1f} "
            f"{row['mean_radius_ratio']:6.3f} {row['below_25']:8,d} {memory}").rstrip()


def summary_in_words(summary):
    """Lines: what the update kept and cost, then each peer."""
    words = [f"kept {summary['kept_nodes']:.1%} of the nodes", f"update / full mesh {summary['update_over_full']:.1%}",
             f"mean radius ratio less by {summary['mean_radius_ratio_less']:.4f}, smallest angle by {summary['min_dihedral_less']:.2f} deg"]
    lines = ["; ".join(words + ([f"fallback: {summary['fallback']}"] if summary["fallback"] else []))]
    if "two_threads_over_one" in summary:
        lines.append(f"full mesh {TWO_THREADS}: {summary['two_threads_over_one']:.2f} times as fast")
    for peer in ALGORITHMS:
        if f"update_over_{peer}" in summary:
            speeds = [f"{summary[name]:.2f} {threads}" for name, threads in ((f"full_speed_over_{peer}", "times"), (f"speed_of_two_threads_over_{peer}", "on two threads"))
                      if name in summary]
            lines.append(f"{peer}: update / its mesh {summary[f'update_over_{peer}']:.1%}; full mesh's tets per second against its {', '.join(speeds)}")
    return lines


def show_history(names):
    """One line per measurement, the oldest first, so that changes for better or worse can be seen."""
    records = [json.loads(line) for line in RESULTS.read_text(encoding="utf-8").splitlines()] if RESULTS.is_file() else []
    print(f"{'case':18s} {'time':16s} {'commit':8s} {'threads':>7s} {'full s':>8s} {'update s':>8s} {'spread':>13s} {'of full':>8s} {'of gmsh':>8s} {'kept':>7s}")
    for record in sorted(records, key=lambda r: (r["case"], r["machine"]["time"])):
        if names and record["case"] not in names or "rows" not in record:
            continue
        full, update = (statistics.median(record["rows"][who]["seconds"]) for who in OURS)
        runs, summary = record["rows"]["update"]["seconds"], record["summary"]
        gmsh = summary.get("update_over_gmsh-delaunay")
        print(f"{record['case']:18s} {record['machine']['time'][:16]:16s} {record['machine']['commit']:8s} {record['threads']:7d} {full:8.3f} {update:8.3f} "
              f"{f'{min(runs):.3f}..{max(runs):.3f}':>13s} {summary['update_over_full']:8.1%} {'-' if gmsh is None else f'{gmsh:.1%}':>8s} "
              f"{summary['kept_nodes']:7.1%}")
    return 0


def machine():
    """What a later reader must know to compare figures."""
    with open("/proc/cpuinfo", encoding="utf-8") as info:
        model = next((line.split(":")[1].strip() for line in info if line.startswith("model name")), platform.machine())
    return {"processor": model, "processors": os.cpu_count(), "memory_gb": round(os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30, 1),
            "system": platform.platform(), "commit": commit(), "time": time.strftime("%Y-%m-%dT%H:%M:%S%z")}


def commit():
    if not shutil.which("git"):
        return ""
    return subprocess.run(["git", "-C", str(ROOT), "rev-parse", "--short", "HEAD"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                          text=True).stdout.strip()


sys.exit(run_until_unread(main))

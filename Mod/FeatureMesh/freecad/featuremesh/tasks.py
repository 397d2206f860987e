# SPDX-License-Identifier: GPL-3.0-or-later
"""The launcher's commands: a task (dict with the command line's options) in, (message, data) out."""

import json
import os
import runpy
import sys
import traceback

from . import about, analyses, api, documents, engine, reading, tables, versions, whole_file
from .errors import UserError
from .transfer import find_result
from .mesh_properties import FROM_SHAPE, element_count, what_it_is_of
from .messages import english, in_english, of_error, said
from .reports import add_fallback, plain
from .quality import MEASURES


def mesh(task):
    """Adds a mesh to a document and saves it."""
    document = documents.open_document(task["part"])
    part = api.find_part(document, task.get("object"))
    reading.refuse_errors(part)
    existing = [m for m in api.meshes_of(document) if versions.part_of(m) is part]
    size = task.get("size")
    if existing:
        obj = existing[0]
        if size is not None:
            api.check_size(float(size), part)
            obj.Size = float(size)
        if task.get("order"):
            obj.Order = "2nd" if task["order"] == 2 else "1st"
        if task.get("dimension"):
            obj.Dimension = task["dimension"].capitalize()
    else:
        obj = api.add_mesh(part, size, task.get("order") or 2, dimension=(task.get("dimension") or FROM_SHAPE).capitalize())
    obj.Threads = task.get("threads") or 0
    if task.get("ignore_below") is not None:
        obj.IgnoreBelow = task["ignore_below"]
    report = api.update_mesh(obj, full=True, progress=_progress)
    report["seconds"]["recompute"] = 0.0
    if not analyses.holding(obj):
        report["warnings"] += filter(None, [analyses.for_new_mesh(part)[1]])   # why it is in none
    out = _save(document, task, report)
    return "%s has %s%s; saved as %s" % (obj.Name, _size_in_words(report), _fallback_in_words(report), out), report


def adopt(task):
    """Makes another maker's mesh in a document ours and saves it."""
    document = documents.open_document(task["part"])
    foreign = reading.find_object(document, task["mesh"])
    part = api.find_part(document, task["object"]) if task.get("object") else None
    obj, report = api.adopt_mesh(foreign, part, task.get("size"), _progress)
    report["seconds"]["recompute"] = 0.0
    out = _save(document, task, report)
    return ("%s is %s with %s, %.1f %% of the nodes kept%s; saved as %s"
            % (obj.Name, foreign.Name, _size_in_words(report), 100 * report["kept"]["nodes_share"], _fallback_in_words(report), out)), report


def update(task):
    """Edits a meshed document, updates its mesh and saves it."""
    document = documents.open_document(task["part"])
    obj = api.find_mesh(document, task.get("object"))
    if task.get("threads"):
        obj.Threads = task["threads"]
    automatic = obj.Automatic
    obj.Automatic = False
    seconds = api.edit(document, task.get("set") or [])
    obj.Automatic = automatic
    report = api.update_mesh(obj, full=bool(task.get("full")), progress=_progress)
    if task.get("full"):
        add_fallback(report, said("meshed from scratch, as asked with --full"))
    report["seconds"]["recompute"] = seconds
    solved = ""
    if task.get("solve"):
        report["solution"] = api.solve_analysis(api.find_analysis(document), threads=task.get("threads") or 0, progress=_progress)
        solved = "; " + solution_in_words(report["solution"])
    out = _save(document, task, report)
    kept = report.get("kept") or {}
    return ("%s has %s, %.1f %% of the nodes kept%s%s; saved as %s"
            % (obj.Name, _size_in_words(report), 100 * kept.get("nodes_share", 0.0), _fallback_in_words(report), solved, out)), report


def solve(task):
    """Solves an analysis and saves the result with the document."""
    document = documents.open_document(task["part"])
    analysis = api.find_analysis(document, task.get("analysis"))
    which = "live" if task.get("live") else "ccx" if task.get("ccx") else None
    threads = task.get("threads") or 0
    report = api.solve_to(analysis, task["accuracy"], threads, _progress) if task.get("accuracy") else api.solve_analysis(analysis, which, threads=threads, progress=_progress)
    out = _save(document, task, report)
    return "%s%s; saved as %s" % (solution_in_words(report), _rounds_in_words(report), out), report


def diff(task):
    """The feature difference of two documents."""
    old = api.find_part(documents.open_document(task["old"]), task.get("object"))
    new = api.find_part(documents.open_document(task["new"]), task.get("object"))
    found = plain(api.difference(old, new))
    message = tables.of_difference(found)
    if task.get("picture"):
        api.draw_difference(old, new, found, task["picture"])
        message += "\nwrote " + _shown(task["picture"])
    return message, found


def tree(task):
    """The feature tree as the engine understands it."""
    part = api.find_part(documents.open_document(task["part"]), task.get("object"))
    found = plain(api.tree(part))
    return tables.of_tree(found), found


def export(task):
    """Writes a document's mesh to another format."""
    document = documents.open_document(task["part"])
    obj = api.find_mesh(document, task.get("object"))
    data = {"groups": api.export_mesh(obj, task["out"], task["format"]), "nodes": obj.FemMesh.NodeCount, "tets": obj.TetCount,
            "warnings": _what_it_is_of(obj)}
    groups = ", %d groups" % data["groups"] if data["groups"] else ""
    return "wrote %s (%d nodes, %d elements%s)" % (_shown(task["out"]), data["nodes"], data["tets"], groups), data


def about_all(task):
    """Versions, where things are and how they were installed."""
    return about.text(), dict(about.facts())


def picture(task):
    """A picture of a document's mesh."""
    document = documents.open_document(task["part"])
    obj = api.find_mesh(document, task.get("object"))
    limits = tuple(task["limits"]) if task.get("limits") else None
    overlay = api.draw_quality(obj, task["out"], task["quality"], limits, task.get("cut"), bool(task.get("filled")))
    kind = MEASURES[task["quality"]]
    data = {"least": float(overlay.values.min()), "mean": float(overlay.values.mean()), "greatest": float(overlay.values.max()),
            "beyond": kind.count_bad(overlay.values, limits), "tets": len(overlay.values), "warnings": _what_it_is_of(obj)}
    return "wrote %s (%s from %s to %s, mean %s; %d of %d elements beyond the limit)" % (
        _shown(task["out"]), kind.title, *(kind.in_words(data[name]) for name in ("least", "greatest", "mean")), data["beyond"], data["tets"]), data


def run(task):
    """Runs a script of the user's, with `api` and, when one is named, the open `document`; what it prints goes where the user reads."""
    names = {"api": api, "document": documents.open_document(task["part"]) if task.get("part") else None}
    sys.argv = [task["script"], *([task["part"]] if task.get("part") else [])]
    sys.path.insert(0, os.path.dirname(task["script"]))
    shown = sys.stdout
    if task.get("output") is not None:
        sys.stdout = open(task["output"], "w", encoding="utf-8", buffering=1)
    try:
        runpy.run_path(task["script"], names, "__main__")
    except UserError:
        raise
    except SystemExit as end:
        if end.code not in (None, 0):
            raise UserError(said("{script:text} ended with {code:text}", script=os.path.basename(task["script"]), code=str(end.code))) from None
    except Exception as error:
        if is_users_fault(error):
            raise
        raise UserError(said("{path:text}: {kind:text}: {why:messages}",
                             path=_place_in(task["script"], error), kind=type(error).__name__, why=of_error(error))) from error
    finally:
        sys.stdout.flush()
        sys.stdout = shown
    return "", {}


def _place_in(script, error):
    """The script's line that was at work when the error came."""
    lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == script]
    if isinstance(error, SyntaxError) and error.filename == script:
        lines.append(error.lineno)
    return "%s, line %d" % (os.path.basename(script), lines[-1]) if lines else os.path.basename(script)


def study_base(task):
    """The document that all cases of a study start from."""
    from .study import base
    return "", base.make(task["study"], task["out"])


def renumber(task):
    """Numbers a mesh anew and saves it."""
    document = documents.open_document(task["part"])
    obj = api.find_mesh(document, task.get("object"))
    nodes, elements = api.renumber_mesh(obj)
    counters = obj.Proxy.arrays(obj)["counters"]
    report = {"before": {"node": nodes, "element": elements}, "after": {"node": int(counters[2]) - 1, "element": int(counters[3]) - 1}}
    out = _save(document, task, report)
    return "%s has node numbers up to %d (before: %d) and element numbers up to %d (%d); saved as %s" % (
        obj.Name, counters[2] - 1, nodes, counters[3] - 1, elements, out), report


def transfer(task):
    """Puts the result of one document, or of the same before its edit, on the mesh of another and saves that one."""
    new_file = task.get("new") or task["part"]
    document = documents.open_document(new_file)
    source = documents.open_document(task["part"]) if new_file != task["part"] else document
    result = find_result(source, task.get("result"))
    obj = api.find_mesh(document, task.get("object"))
    made, report = api.transfer_result(result, obj)
    out = _save(document, dict(task, part=new_file), report)
    figures = max(report["fields"].values(), key=lambda f: f["largest_error"] / (f["largest_value"] or 1.0))
    return ("%s has %s of %s: %d nodes the same, %d interpolated, %d outside the old mesh; estimated error at most %.2g %% of the field (%s); "
            "saved as %s" % (made.Name, ", ".join(report["fields"]), result.Name, figures["same"], figures["interpolated"], figures["outside"],
                             100 * figures["largest_error"] / (figures["largest_value"] or 1.0),
                             next(n for n, f in report["fields"].items() if f is figures), out)), report


COMMANDS = {"renumber": renumber, "transfer": transfer, "mesh": mesh, "adopt": adopt, "update": update, "solve": solve, "diff": diff, "tree": tree,
            "export": export, "about": about_all, "picture": picture, "run": run,
            "study_base": study_base}


def is_users_fault(error):
    """Is it the engine's word that what was given cannot be meshed, or read, rather than a failure of ours?"""
    return isinstance(error, (engine.load().InputError, engine.load().StateError))


def _what_it_is_of(mesh):
    """A warning where the mesh is not that of its part as it is."""
    return list(filter(None, [what_it_is_of(mesh)]))


def _save(document, task, report):
    """Writes the report and the document; what was there stays when either fails."""
    out, later = task.get("out") or task["part"], versions.later_that_saved(document)
    if later:
        report["warnings"] = report.get("warnings", []) + [said(
            "FreeCAD {later:text} saved this document: what FreeCAD {version:text} does not know of it is not in the file that was written now, and an edit of it may fail",
            later=later, version=versions.text())]
    documents.save_document(document, out)
    if task.get("json"):
        try:
            with whole_file.written(task["json"]) as stream:
                json.dump(in_english(report), stream, indent=1, sort_keys=True)
        except OSError as error:
            raise UserError(said("saved {path:text}, but cannot write the report: {why:messages}", path=out, why=error.strerror or of_error(error))) from error
    return _shown(out)


def _shown(path):
    """As short as it can be typed."""
    relative = os.path.relpath(path)
    return path if relative.startswith("..") else relative


def _progress(step, share):
    print("featuremesh: %s %d %%" % (step, round(100 * share)), file=sys.stderr, flush=True)
    return True


def _size_in_words(report):
    return "%d nodes and %d elements%s in %.2f s, %.2f s of it meshing" % (
        report["nodes"], element_count(report), _angles_in_words(report), report["seconds"]["total"], report["seconds"]["engine_total"])


def _angles_in_words(report):
    """Nothing of segments, which have none."""
    quality = report["quality"]
    if report.get("dimension") == "edges":
        return ""
    forced = ""
    if quality["forced_by_cad"] == element_count(report):
        forced = ", the part's own details force such angles everywhere"
    elif quality["forced_by_cad"]:
        forced = ", %.1f deg where the part's own details do not force less" % quality["min_dihedral_unforced"]
    return " (smallest angle %.1f deg%s)" % (quality["min_dihedral"], forced)


def solution_in_words(report):
    """What a solution gave, in a line."""
    found, how = report["responses"], ", %d iterations" % report["iterations"] if report["iterations"] is not None else ""
    return "%s: %s, in %.2f s%s" % ("live" if report["solver"] == "live" else report["solver"], _responses_in_words(found), report["seconds"]["total"], how)


def _rounds_in_words(report):
    """How the mesh got finer."""
    rounds = report.get("rounds") or []
    return "".join("; %s%d elements, off by about %.2g %%" % ("then " if index else "", found["elements"], 100 * found["mesh_error"]) for index, found in enumerate(rounds))


def _responses_in_words(found):
    for name, words in (("frequencies_hz", "frequencies %s Hz"), ("buckling_factors", "buckling factors %s")):
        if name in found:
            return words % (", ".join("%.4g" % value for value in found[name]) or "none")
    where, words = found["max_mises_at"], []
    if found["max_displacement_mm"] is not None:
        words = ["largest von Mises stress %.4g MPa%s" % (found["max_mises_mpa"], " on %s" % where["on"] if where else ""),
                 "largest displacement %.4g mm" % found["max_displacement_mm"]]
    return ", ".join(words + (["highest temperature %.4g K" % found["max_temperature_k"]] if "max_temperature_k" in found else []))


def _fallback_in_words(report):
    return " (%s)" % english(report["fallback"]) if report.get("fallback") else ""

# SPDX-License-Identifier: GPL-3.0-or-later
"""The launcher's commands: a task (dict with the command line's options) in, (message, data) out."""

import json
import os
import sys

from . import api, documents, engine, reading, tables, versions
from .errors import UserError
from .transfer import find_result
from .mesh_object import add_fallback, one_line, plain


def mesh(task):
    """Adds a mesh to a document and saves it."""
    document = documents.open_document(task["part"])
    part = reading.find_meshable(document, task.get("object"))
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
    else:
        obj = api.add_mesh(part, size, task.get("order") or 1)
    obj.Threads = task.get("threads") or 0
    report = api.update_mesh(obj, full=True, progress=_progress)
    report["seconds"]["recompute"] = 0.0
    out = _save(document, task, report)
    return "%s has %s%s; saved as %s" % (obj.Name, _size_in_words(report), _fallback_in_words(report), out), report


def adopt(task):
    """Makes another maker's mesh in a document ours and saves it."""
    document = documents.open_document(task["part"])
    foreign = reading.find_object(document, task["mesh"])
    part = reading.find_meshable(document, task["object"]) if task.get("object") else None
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
    api.set_parameters(document, task.get("set") or [])
    seconds = api.recompute(document)
    obj.Automatic = automatic
    report = api.update_mesh(obj, full=bool(task.get("full")), progress=_progress)
    if task.get("full"):
        add_fallback(report, "meshed from scratch, as asked with --full")
    report["seconds"]["recompute"] = seconds
    out = _save(document, task, report)
    kept = report.get("kept") or {}
    return ("%s has %s, %.1f %% of the nodes kept%s; saved as %s"
            % (obj.Name, _size_in_words(report), 100 * kept.get("nodes_share", 0.0), _fallback_in_words(report), out)), report


def diff(task):
    """The feature difference of two documents."""
    old = reading.find_meshable(documents.open_document(task["old"]), task.get("object"))
    new = reading.find_meshable(documents.open_document(task["new"]), task.get("object"))
    found = plain(api.difference(old, new))
    message = tables.of_difference(found)
    if task.get("picture"):
        api.draw_difference(old, new, found, task["picture"])
        message += "\nwrote " + task["picture"]
    return message, found


def tree(task):
    """The feature tree as the engine understands it."""
    part = reading.find_meshable(documents.open_document(task["part"]), task.get("object"))
    found = plain(api.tree(part))
    return tables.of_tree(found), found


def export(task):
    """Writes a document's mesh to another format."""
    document = documents.open_document(task["part"])
    obj = api.find_mesh(document, task.get("object"))
    api.export_mesh(obj, task["out"], task.get("format"))
    data = {"nodes": obj.FemMesh.NodeCount, "tets": obj.FemMesh.VolumeCount, "groups": obj.FemMesh.GroupCount}
    return "wrote %s (%d nodes, %d tets, %d groups)" % (task["out"], data["nodes"], data["tets"], data["groups"]), data


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


COMMANDS = {"renumber": renumber, "transfer": transfer, "mesh": mesh, "adopt": adopt, "update": update, "diff": diff, "tree": tree, "export": export}


def is_users_fault(error):
    """Is it the engine's word that what was given cannot be meshed, rather than a failure of ours?"""
    return isinstance(error, engine.load().InputError)


def _save(document, task, report):
    """Writes the report and the document; what was there stays when either fails."""
    out = task.get("out") or task["part"]
    documents.save_document(document, out)
    if task.get("json"):
        try:
            with open(task["json"], "w", encoding="utf-8") as stream:
                json.dump(report, stream, indent=1, sort_keys=True)
        except OSError as error:
            raise UserError("saved %s, but cannot write the report: %s" % (out, one_line(error))) from error
    return os.path.relpath(out) if not os.path.relpath(out).startswith("..") else out


def _progress(step, share):
    print("featuremesh: %s %d %%" % (step, round(100 * share)), file=sys.stderr, flush=True)
    return True


def _size_in_words(report):
    quality = report["quality"]
    forced = "" if not quality["forced_by_cad"] else ", %.1f deg where the part's own details do not force less" % quality["min_dihedral_unforced"]
    return "%d nodes and %d tets (smallest angle %.1f deg%s) in %.2f s" % (
        report["nodes"], report["tets"], quality["min_dihedral"], forced, report["seconds"]["total"])


def _fallback_in_words(report):
    return " (%s)" % report["fallback"] if report.get("fallback") else ""

# SPDX-License-Identifier: GPL-3.0-or-later
"""One case: a function of the base document and the case's parameters. Runs in a copy of the process that opened the base."""

import hashlib
import json
import os
import shutil
import traceback

from .. import api, documents, engine, reading, recompute_errors, solve_guard, state, versions
from ..errors import UserError
from ..messages import of_error, said, several
from ..mesh_properties import element_count
from . import case_solver, places, response_words, responses, room, subject
from .database import DONE, FAILED, INFEASIBLE
from .design import from_plain
from .steps import step

KILLED = "killed"   # a state that only a worker and a runner know


class Infeasible(UserError):
    """FreeCAD cannot make the part that the parameters ask for."""


class Base:
    """The base document, opened once; what it holds is never changed by the process that opened it."""

    def __init__(self, path, plain_study, solver):
        self.study = from_plain(plain_study)
        self.solver = solver                        # "live" or "ccx"
        self.document = documents.open_document(path)
        self.analysis = subject.analysis_of(self.document, self.study)
        self.mesh = subject.mesh_of(self.document, self.study, self.analysis)
        self.part = versions.part_of(self.mesh)
        self.mesh.Threads = self.study.threads
        for mesh in api.meshes_of(self.document):   # each case asks for its own mesh when it is ready, and for no other
            mesh.Automatic = False
        self.mesh.Proxy.last_part_mesh(self.mesh)   # into memory, for all cases
        self.solution = case_solver.solve_live_base(self.analysis) if solver == "live" else None
        if solver == "ccx":
            import feminout.importCcxFrdResults  # noqa: F401  what FreeCAD's writer loads, loaded once


def run(base, case):
    """The result of a case: {"state", "responses", "message", "seconds", "mesh", "hashes"}; never throws."""
    seconds = {}
    try:
        return _run(base, case, seconds)
    except Infeasible as error:
        return {"state": INFEASIBLE, "message": of_error(error), "seconds": seconds}
    except case_solver.Killed as error:
        return {"state": KILLED, "message": of_error(error)}
    except MemoryError:
        return {"state": FAILED, "message": said("the memory was not enough"), "seconds": seconds}
    except Exception as error:
        if not isinstance(error, (OSError, UserError, engine.load().Error)):
            traceback.print_exc()
        return {"state": room.state_after(error, case["folder"]), "message": of_error(error), "seconds": seconds}


def _run(base, case, seconds):
    with step(seconds, "recompute"):
        edit(base, case)
    report = _mesh(base, seconds)
    part_mesh = base.mesh.Proxy.last_part_mesh(base.mesh)
    arrays = part_mesh.arrays()
    fields = _solve(base, arrays, case["folder"], seconds)
    with step(seconds, "responses"):
        solved = responses.SolvedCase(case["id"], case["parameters"], base.part, base.analysis, arrays, fields,
                                      places.Places(base.mesh, base.part, arrays, part_mesh, base.study.responses))
        values = responses.evaluate(base.study.responses, solved)
        if "mesh" in base.study.keep:
            api.export_mesh(base.mesh, os.path.join(case["folder"], "case.vtu"))
    with step(seconds, "hashes"):
        mesh_hash = state.digest(arrays).hex()
        hashes = {"mesh": mesh_hash, "result": _hash_of_values(mesh_hash, values)}
    return {"state": DONE, "responses": values, "seconds": seconds, "message": several(report["warnings"]) or "",
            "mesh": {"nodes": report["nodes"], "elements": element_count(report), "kept_share": (report.get("kept") or {}).get("nodes_share", 0.0),
                     "fallback": report["fallback"]},
            "hashes": hashes}


def edit(base, case):
    """Gives `base.part` in `base.document` the case's parameters. Throws Infeasible with FreeCAD's word."""
    try:
        api.edit(base.document, case["set"])
        error = recompute_errors.error_of_part(base.part, recompute_errors.in_error(base.document))
        if error:   # also from before: what depends on it is as it was
            raise error
        reading.refuse_unmeshable(base.part)
    except UserError as error:
        raise Infeasible(of_error(error)) from error
    if not base.part.Shape.isValid():
        raise Infeasible(said("FreeCAD made a shape of {part:text} that is not valid", part=reading.describe(base.part)))


def _mesh(base, seconds):
    with step(seconds, "mesh"):
        job = base.mesh.Proxy.prepare(base.mesh)
        try:
            job.run()
        except engine.load().InputError as error:
            raise Infeasible(of_error(error)) from error
    with step(seconds, "hand_over"):
        shown_by = subject.shown_in(base.analysis, base.mesh) if base.solver == "ccx" else []
        exported = [base.mesh] if "mesh" in base.study.keep and base.mesh not in shown_by else []
        report = base.mesh.Proxy.take_over(base.mesh, job, shown_by + exported)
    report.setdefault("fallback", None)
    return report


def _solve(base, arrays, folder, seconds):
    if not response_words.needs_solution(base.study.responses):
        return None
    solve_guard.refuse_lost(base.analysis)
    if base.solver == "live":
        with step(seconds, "solve"):
            return case_solver.solve_live(base.analysis, base.study.threads, base.solution)
    work = os.path.join(folder, "calculix")
    shutil.rmtree(work, ignore_errors=True)   # of an attempt that was killed
    os.makedirs(work)
    fields = case_solver.solve_ccx(base.analysis, arrays, work, base.study.threads, seconds)
    case_solver.keep_files(work, folder, [name for name in base.study.keep if name != "mesh"])
    return fields


def _hash_of_values(mesh, values):
    return hashlib.sha256(json.dumps([mesh, values], sort_keys=True).encode()).hexdigest()

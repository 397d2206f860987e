# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the base of a study: a copy of the document with the mesh that every case starts from. Checks everything that cases rely on."""

import os

from .. import api, documents, edits, engine, live_result, mesh_object, reading, statics, statics_model, versions
from ..errors import UserError
from . import places, response_words, responses
from .design import from_plain


def make(plain_study, out):
    """Writes the base document to `out`. Returns what is known then: the parameters' base values, the solver, the mesh. Throws UserError."""
    study = from_plain(plain_study)
    document = documents.open_document(study.document)
    values = {parameter.name: edits.parameter_value(document, parameter.target) for parameter in study.parameters}
    integers = [parameter.name for parameter in study.parameters if type(values[parameter.name]) is int]
    for live in [obj for obj in document.Objects if live_result.is_live_result(obj)]:
        document.removeObject(live.Name)   # it would be solved with every recompute
    mesh = _mesh_of(document, study)
    part = versions.part_of(mesh)
    reading.refuse_errors(part)
    groups = places.add_groups(mesh, part, study.responses)
    _refuse_unknown_places(study, part)
    mesh.Threads = study.threads
    full = mesh.Status != mesh_object.UP_TO_DATE or study.mesh_size is not None or study.mesh_order is not None
    if full:
        api.update_mesh(mesh, full=True)
    elif groups:
        mesh.Proxy.note_references(mesh, groups)
    solver = _solver(document, study, mesh)
    documents.save_document(document, out)
    arrays = mesh.Proxy.arrays(mesh)
    return {"base_values": values, "integers": integers, "solver": solver, "nodes": len(arrays["points"]), "tets": len(arrays["tets"]),
            "order": 2 if len(arrays["tet_mids"]) else 1, "part": part.Name, "mesh": mesh.Name, "engine": engine.about()["version"],
            "freecad": ".".join(map(str, versions.version())), "bytes": os.path.getsize(out)}


def _mesh_of(document, study):
    """The document's mesh, with the size and order that the study asks for, or a new one."""
    part = reading.find_meshable(document, study.object)
    found = [mesh for mesh in api.meshes_of(document) if versions.part_of(mesh) is part]
    if not found:
        return api.add_mesh(part, study.mesh_size, study.mesh_order or 2)
    mesh = found[0]
    if study.mesh_size is not None:
        api.check_size(study.mesh_size, part)
        mesh.Size = study.mesh_size
    if study.mesh_order is not None:
        mesh.Order = "2nd" if study.mesh_order == 2 else "1st"
    return mesh


def _refuse_unknown_places(study, part):
    for response in study.responses:
        if response.at and not response.kind.startswith("reaction") and response.at not in places.of_nodes(study.responses) \
                and places.point_of(response.at) is None:
            places.feature(part, response.at)


def _solver(document, study, mesh):
    """"live" or "ccx": what was asked for, else live where that knows all that the analysis holds. Throws UserError."""
    if not response_words.needs_solution(study.responses):
        return None
    analysis = api.find_analysis(document, study.analysis)
    if mesh not in analysis.Group:
        raise UserError("the analysis %s has another mesh than %s" % (reading.describe(analysis), reading.describe(mesh)))
    chosen = study.solver or ("live" if _live_can(analysis, mesh, study) else "ccx")
    if chosen == "live":
        if engine.load().statics_missing():
            raise UserError("the live solver needs PETSc: %s" % engine.load().statics_missing())
        statics.refuse_free_motions(statics_model.read(analysis, mesh))
        responses.refuse_unfit(study.responses, "static", True)
    else:
        from .. import calculix   # FreeCAD's tools for CalculiX take a while to load
        responses.refuse_unfit(study.responses, calculix.solver_of(analysis).AnalysisType, False)
        calculix.program()
    return chosen


def _live_can(analysis, mesh, study):
    try:
        responses.refuse_unfit(study.responses, "static", True)
        statics_model.read(analysis, mesh)
    except UserError:
        return False
    return not engine.load().statics_missing()

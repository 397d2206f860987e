# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the base of a study: a copy of the document with the mesh that every case starts from. Checks everything that cases rely on."""

import os

from femtools import femutils

from .. import analyses, api, documents, edits, engine, formats, live_result, mesh_object, reading, solve_guard, statics, statics_model, versions
from ..errors import UserError
from ..messages import said
from . import places, response_words, responses, subject
from .design import from_plain


def make(plain_study, out):
    """Writes the base document to `out`. Returns what is known then: the parameters' base values, the solver, the mesh. Throws UserError."""
    study = from_plain(plain_study)
    document = documents.open_document(study.document)
    values = {parameter.name: edits.value_to_vary(document, parameter.target, parameter.unit) for parameter in study.parameters}
    integers = [parameter.name for parameter in study.parameters if edits.is_whole_number(document, parameter.target)]
    for live in live_result.in_document(document):
        document.removeObject(live.Name)   # it would be solved with every recompute
    analysis = subject.analysis_of(document, study)
    mesh = _mesh_of(document, study, analysis)
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
    _refuse_volume(study, part)
    solver = _solver(analysis, study, mesh)
    documents.save_document(document, out)
    arrays = mesh.Proxy.arrays(mesh)
    places.refuse_points_outside(arrays, study.responses)
    _refuse_mixed(analysis, study, part, arrays)
    kind, mids, _, _ = formats.filling_of(arrays)
    return {"base_values": values, "integers": integers, "solver": solver, "iterative": _is_iterative(analysis, solver),
            "nodes": len(arrays["points"]), "elements": len(arrays[kind]), "filled_by": kind, "order": 2 if len(arrays[mids]) else 1,
            "part": part.Name, "mesh": mesh.Name, "engine": engine.about()["version"],
            "freecad": ".".join(map(str, versions.version())), "bytes": os.path.getsize(out), "remarks": _remarks(analysis, study, solver, kind == "tets")}


def _mesh_of(document, study, analysis):
    """The document's mesh, with the size and order that the study asks for, or a new one."""
    mesh, part = subject.mesh_of(document, study, analysis), api.find_part(document, study.object)
    if mesh is None:
        return api.add_mesh(part, study.mesh_size, study.mesh_order, in_place_of=_other_makers_mesh(document, study, analysis))
    if study.mesh_size is not None:
        api.check_size(study.mesh_size, part)
        mesh.Size = study.mesh_size
    if study.mesh_order is not None:
        mesh.Order = "2nd" if study.mesh_order == 2 else "1st"
    return mesh


def _other_makers_mesh(document, study, analysis):
    """The mesh that the study's analysis has where that is not ours, or None."""
    found = analyses.other_makers_mesh(document, analysis) if response_words.needs_solution(study.responses) else None
    return found[1] if found else None


def _refuse_unknown_places(study, part):
    for response in study.responses:
        if response.at and not response.kind.startswith("reaction") and response.at not in places.of_nodes(study.responses) \
                and places.point_of(response.at) is None:
            places.feature(part, response.at)


def _refuse_volume(study, part):
    for response in study.responses:
        if response.kind == "volume" and not part.Shape.Solids:
            raise UserError(said("the response {response:text} needs a solid, and {part:text} has none; ask for its mass or area",
                                 response=response.name, part=reading.describe(part)))


def _refuse_mixed(analysis, study, part, arrays):
    """Throws UserError where shells or beams lie beside solids, or on their skin: what is known here of masses and places is of one kind of element."""
    if not response_words.needs_analysis(study.responses):
        return
    members = analyses.members_of(analysis)
    skins = [member for member in members for kind in ("Fem::ElementGeometry1D", "Fem::ElementGeometry2D") if femutils.is_of_type(member, kind)]
    if len(formats.fillings_of(arrays)) > 1 or (len(arrays["tets"]) and skins):
        raise UserError(said("a study asks for figures of solids, of shells or of beams alone, and {part:text} has several of them in one analysis; study "
                             "a part of one kind, or ask for its volume or area only",
                             part=reading.describe(part)))


def _remarks(analysis, study, solver, is_solid):
    """What the figures of the cases do not say, in sentences."""
    if solver != "ccx":
        return []
    from .. import calculix   # FreeCAD's tools for CalculiX take a while to load
    asked = calculix.solver_of(analysis)
    of_stresses = any(response.kind in response_words.STRESSES for response in study.responses)
    return (calculix.remarks(is_solid, asked) if of_stresses else []) + calculix.left_out(analysis, asked)


def _solver(analysis, study, mesh):
    """"live" or "ccx": what was asked for, else live where that knows all that the analysis holds. Throws UserError."""
    if not response_words.needs_solution(study.responses):
        return None
    if not subject.shown_in(analysis, mesh):
        raise UserError(said("the analysis {analysis:text} has another mesh than {mesh:text}",
                             analysis=reading.describe(analysis), mesh=reading.describe(mesh)))
    solve_guard.refuse_lost(analysis)
    chosen = study.solver or ("live" if _live_can(analysis, mesh, study) else "ccx")
    if chosen == "live":
        if engine.load().statics_missing():
            raise UserError(said("the live solver needs PETSc: {why:messages}", why=engine.load().statics_missing()))
        statics.refuse_free_motions(statics_model.read(analysis, mesh))
        responses.refuse_unfit(study.responses, "static", True)
    else:
        from .. import calculix   # FreeCAD's tools for CalculiX take a while to load
        responses.refuse_unfit(study.responses, calculix.solver_of(analysis).AnalysisType, False)
        calculix.program()
    return chosen


def _is_iterative(analysis, solver):
    """Does CalculiX solve the base by an iterative solver?"""
    if solver != "ccx":
        return False
    from .. import calculix   # FreeCAD's tools for CalculiX take a while to load
    return calculix.solves_iteratively(calculix.solver_of(analysis), calculix.as_arrays(analysis))


def _live_can(analysis, mesh, study):
    try:
        responses.refuse_unfit(study.responses, "static", True)
        statics_model.read(analysis, mesh)
    except UserError:
        return False
    return not engine.load().statics_missing()

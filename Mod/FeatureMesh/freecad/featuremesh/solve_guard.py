# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps an analysis from being solved on a mesh that is not that of its part, or with a load that has lost its face.

FreeCAD's own ways to a solver do not ask: the command and the panels of CalculiX (ccxtools in every version, a second solver since 1.1), Elmer, Z88 and
Mystran. Each passes one of the functions below on its way, which are wrapped once the first of our meshes is there; an analysis without one is solved
as ever.
"""

import contextlib
import threading

import FreeCAD

from . import analyses, contact_faces, formats, history, materials, references, resolving, results, versions
from .errors import UserError
from .hand_over import EntityGroups, is_material
from .mesh_properties import is_of_its_part
from .messages import said
from .proxies import type_of
from .reading import describe
from .user_words import in_words
from .wrapping import wrap

translate, QT_TRANSLATE_NOOP = FreeCAD.Qt.translate, FreeCAD.Qt.QT_TRANSLATE_NOOP
# Of meshes of faces and of edges: what gives an element its size, and what is said of one without.
_SECTIONS = {"triangles": ("Face", "Fem::ElementGeometry2D", QT_TRANSLATE_NOOP("FeatureMesh", "{place:entities} has no shell thickness; choose one for it")),
             "segments": ("Edge", "Fem::ElementGeometry1D", QT_TRANSLATE_NOOP("FeatureMesh", "{place:entities} has no beam section; choose one for it"))}
# What acts on nodes, which faces and edges without elements share with others.
_ON_NODES = ("Fem::ConstraintFixed", "Fem::ConstraintDisplacement", "App::MaterialObject")
# How the window shows a refusal; None: in the report view.
tell = None
_is_in_report = False   # Is what an input lacks told by who has it written?


def reason(analysis):
    """Why the analysis must not be solved now, as a sentence; "" when nothing is in the way."""
    if analysis is None:
        return ""
    meshes, known = analyses.meshes_of(analysis), analyses.meshes_in(analysis.Document)
    if suppressed := analyses.suppressed_mesh_of(analysis):
        return in_words(said(analyses.MESH_IS_SUPPRESSED, mesh=describe(suppressed), analysis=describe(analysis)))
    if known and not meshes:
        return translate("FeatureMesh", "%s has no mesh; let it share %s (api.share_mesh), or give it one of its own") % (analysis.Label, known[0].Label)
    for mesh in filter(analyses.is_ours, meshes):
        source = analyses.source_of(mesh)
        is_fresh = source is not None and is_of_its_part(source)
        problem = is_fresh and not_recomputed(source) or mesh.Proxy.why_not_to_solve(mesh) or _why_not_on(source, analysis)
        if problem:
            return problem
    return _lost(analysis)


def _why_not_on(mesh, analysis):
    """What of the analysis does not go with a mesh of ours that is up to date."""
    arrays, members = mesh.Proxy.arrays(mesh), analyses.members_of(analysis)
    resolver, entities = resolving.Resolver(versions.part_of(mesh)), EntityGroups(arrays)
    return mesh.Proxy.clicked_elsewhere(mesh, members) or _without_elements(members, resolver, entities) \
        or _material_in_doubt(members, resolver, entities) or _without_section(members, resolver, entities, formats.filling_of(arrays)[0]) \
        or _without_trace(members, resolver) or in_words(contact_faces.out_of_reach(members, resolver, mesh.Size.Value))


def _lost(analysis):
    return next((sentence for _, sentence in references.unmended(analysis)), "")


def _without_trace(members, resolver):
    """A load on a face of the part and on one of an earlier feature of which nothing is left would lose its share there in silence."""
    for member in members:
        if hasattr(member, "References") and not is_material(member) and resolver.without_trace(member):
            return in_words(references.elsewhere([member], resolver)[member.Name])
    return ""


def not_recomputed(mesh):
    """What its part comes from and was edited since the last recompute."""
    edited = history.edited_behind(mesh)
    return translate("FeatureMesh", "%s was edited and not recomputed; recompute the document (Edit, Refresh) before solving") % describe(edited[0]) if edited else ""


def recompute_left(analysis):
    """Recomputes what a panel of FreeCAD's has left touched behind the mesh, such as that of a pattern of patterns, or of a joint when it is cancelled; unless the
    user has FreeCAD skip recomputes."""
    meshes = analyses.meshes_of(analysis) if analysis is not None and not analysis.Document.RecomputesFrozen else []
    if any(map(history.edited_behind, filter(None, map(analyses.source_of, meshes)))):
        analysis.Document.recompute()


def _reason_in_window(analysis):
    """The same as `reason`, where edits are recomputed at once. Solvers also ask from threads, which may not."""
    if tell is not None and threading.current_thread() is threading.main_thread():
        recompute_left(analysis)
    return reason(analysis)


def _without_elements(members, resolver, entities):
    """A load on nothing but what is too small for elements would be left out of the input."""
    small = entities.names_without_elements()
    for member in members if small else ():
        if hasattr(member, "References") and not any(member.isDerivedFrom(kind) for kind in _ON_NODES):
            names, foreign = resolver.of_object(member)
            if names and not foreign and small.issuperset(names):
                return in_words(said(references.ACTS_ON_NOTHING, object=member.Label, places=names))
    return ""


def _material_in_doubt(members, resolver, entities):
    """Solids have become one, or there is another one, since materials were chosen for them."""
    problem = materials.doubt(list(filter(is_material, members)), resolver, entities)
    return in_words(problem) if problem else ""


def _without_section(members, resolver, entities, filling):
    """Where all of several thicknesses or beam sections have faces or edges of their own, what an edit has brought may have none, and CalculiX would end. A
    single one is for all."""
    if filling not in _SECTIONS:
        return ""
    kind, fem_type, words = _SECTIONS[filling]
    chosen = [member for member in members if type_of(member) == fem_type]
    if len(chosen) < 2 or not all(member.References for member in chosen):
        return ""
    known = {name for member in chosen for name in resolver.of_object(member)[0]}
    bare = [name for name in entities.of_kind(kind) if name not in known]
    return in_words(said(words, place=bare[:1])) if bare else ""


def refuse(analysis):
    """Throws UserError when the analysis must not be solved now."""
    if problem := reason(analysis):
        raise UserError(problem)


def refuse_lost(analysis):
    """Throws UserError when a load of the analysis has lost its face, or what it acts along."""
    if problem := _lost(analysis):
        raise UserError(problem)


@contextlib.contextmanager
def told_in_a_report():
    """The report view has no word of what is not in the input that is written meanwhile."""
    global _is_in_report
    _is_in_report = True
    try:
        yield
    finally:
        _is_in_report = False


def install():
    """To be called once one of our meshes is there; further calls do nothing. What a FreeCAD has not, cannot solve in it."""
    for guarded in _GUARDED:
        wrap(*guarded)


def _of_run(original, solver, *rest, **named):
    """The command that runs a solver; earlier results stay."""
    problem = _reason_in_window(solver.getParentGroup())
    if not problem:
        return original(solver, *rest, **named)
    if tell is not None:
        tell(UserError(problem))
    else:
        FreeCAD.Console.PrintError(problem + "\n")
    return None


def _of_check(original, analysis, *rest, **named):
    """What the panel of CalculiX and scripts ask before they write its input: the messages of what is missing."""
    problem = _reason_in_window(analysis)
    if problem:
        return problem + "\n"
    results.input_is_written(analysis)
    return original(analysis, *rest, **named)


def _of_task(original, task):
    """The first step of the solvers that run as a chain of tasks."""
    problem = reason(task.analysis)
    if not problem:
        results.input_is_written(task.analysis)
        return original(task)
    task.report.error(problem)
    task.fail()
    return False


def _of_tools(original, tools, *rest, **named):
    """The solvers of 1.1 and later; their panels print the error."""
    refuse(tools.analysis)
    results.input_is_written(tools.analysis)
    return original(tools, *rest, **named)


def _of_panel(original, panel):
    """The panel's button that starts CalculiX on input written before."""
    problem = _reason_in_window(panel.fea.analysis)
    if problem:
        panel.femConsoleMessage(problem, "#FF0000")
        return None
    return original(panel)


def _of_writer(original, writer):
    """FreeCAD says nothing of what its input for CalculiX has not."""
    path = original(writer)
    if path and not _is_in_report and any(map(analyses.is_ours, analyses.meshes_of(writer.analysis))):
        from . import calculix   # FreeCAD's tools for CalculiX take a while to load
        for remark in calculix.lacks(writer.analysis, writer.solver_obj, path):
            FreeCAD.Console.PrintWarning("%s: %s\n" % (describe(writer.analysis), in_words(remark)))
    return path


def _of_results(original, tools):
    """FreeCAD shows a part that has flown away as any other."""
    original(tools)
    if not _is_in_report:
        from . import calculix
        for remark in calculix.has_flown(tools.analysis, tools.solver):
            FreeCAD.Console.PrintWarning("%s: %s\n" % (describe(tools.analysis), in_words(remark)))


_GUARDED = (
    ("femsolver.run", None, "run_fem_solver", _of_run),
    ("femtools.checksanalysis", None, "check_member_for_solver_calculix", _of_check),
    ("femsolver.run", "Check", "check_mesh_exists", _of_task),
    ("femsolver.calculix.calculixtools", "CalculiXTools", "prepare", _of_tools),
    ("femsolver.calculix.writer", "FemInputWriterCcx", "write_solver_input", _of_writer),
    ("femtools.ccxtools", "FemToolsCcx", "load_results", _of_results),
    ("femsolver.elmer.elmertools", "ElmerTools", "prepare", _of_tools),
    ("femsolver.z88.z88tools", "Z88Tools", "prepare", _of_tools),
) + ((("femtaskpanels.task_solver_ccxtools", "_TaskPanel", "runCalculix", _of_panel),) if FreeCAD.GuiUp else ())

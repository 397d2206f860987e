# SPDX-License-Identifier: GPL-3.0-or-later
"""Solves an analysis with CalculiX through FreeCAD, with the figures that the live solver gives.

The input is FreeCAD's own, with two additions: figures to print, and for large linear models an iterative solver where the user left the choice to
CalculiX. Results of what the live solver knows, too, are read as arrays; all others by FreeCAD.
"""

import contextlib
import importlib
import os
import re
import shutil
import sys
import tempfile
import time
from types import SimpleNamespace

import FreeCAD
import numpy as np
import ObjectsFem
from femtools import ccxtools, femutils

from . import analyses, frd, mass, modes, parent_process, resolving, solve_guard, solvers, statics, statics_model, statics_result, statics_supports, versions
from .errors import UserError
from .hand_over import is_material
from .messages import said
from .proxies import type_of
from .reading import describe

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
_TOTAL = re.compile(r"total force \(fx,fy,fz\) for set (\S+) and time\s+\S+\s+(\S+)\s+(\S+)\s+(\S+)")
_ENERGY = re.compile(r"total internal energy for set \S+ and time\s+\S+\s+(\S+)")
_MASS = re.compile(r"total mass for set \S+ and time\s+\S+\s+(\S+)")
# The line of the label of a load before it, and nothing but comments and empty lines after it.
_EMPTY_LOAD = re.compile(r"^\*\* (.*)\n\*(?:DLOAD|FILM|DFLUX)\b.*\n(?:\*\*.*\n|[ \t]*\n)*(?=\*[A-Z])", re.MULTILINE)
_ALL = re.compile(r"^\*ELSET,\s*ELSET=(Eall|Evolumes)\s*$", re.MULTILINE | re.IGNORECASE)
_NODE_FILE = re.compile(r"^\*NODE FILE\nU\n", re.MULTILINE)
_STATIC = re.compile(r"^\*STATIC\s*$", re.MULTILINE)
_MANY = 50_000   # unknowns, from which on the iterative solver is faster
# It looks at the forces that are left, which are small there long before the part has turned as far as it does.
_MOVED = "points or faces are moved, and the iterative solver ends too soon"
_HELD_AT_POINTS = "points or edges hold the part, where the iterative solver ends too soon"
_WRITERS = {"ElectrostaticPotential": "electrostatic"}   # of constraints, where FreeCAD's module has another name
_REFERENCE = "_REFNODE"   # of a rigid body, behind its name
_SHOWN = 3       # lines of what CalculiX says when it fails
_BALANCED = 1e-3   # share of the loads that reactions may be off by
_FLOWN = 100     # times the size of a part, beyond which a displacement is none
_BY_PLACE = QT_TRANSLATE_NOOP("FeatureMesh", "{object:text} refers to {where:entities}, which is not on the meshed part {part:text}: CalculiX got what FreeCAD found in the "
                              "same place, and no edit is followed there; choose faces, edges or vertices of {part:text} instead")


def solve(analysis):
    """Runs CalculiX and leaves FreeCAD's result object in the analysis. Returns the report, keys as statics.solve. Throws UserError."""
    start = time.perf_counter()
    with solved(analysis) as run:
        base, known = run.tools.inp_file_name[:-len("inp")], run.known
        read = _read_arrays(analysis, known, base + "frd") if known is not None else None
        if read is None:
            result, reactions, unbalanced = read_by_freecad(run.tools, analysis), None, 0.0
        else:
            run.tools.load_results_ccxdat()
            result, reactions, unbalanced = read
        with open(base + "dat", encoding="utf-8") as stream:
            printed = stream.read()
    found, total = _responses(analysis, result, read is not None, printed, run.solver.AnalysisType), time.perf_counter() - start
    return {"solver": "CalculiX", "matrix_solver": {**run.matrix_solver, "preconditioner": None}, "result": result.Name,
            "responses": {**found,
                          "reactions_n": reactions if read is not None else {} if run.solver.AnalysisType in modes.TABLES else printed_reactions(printed, analysis),
                          "mass_kg": _mass(analysis, known, printed),
                          "strain_energy_mj": printed_strain_energy(printed)},
            "iterations": None, "residual": None, "energy_error": None, "mesh_error": None,
            "reused": {"preconditioner": False, "start_share": 0.0},
            "warnings": run.remarks + _doubts(analysis, found["max_displacement_mm"]) + _doubts_of_reactions(run.solver, unbalanced),
            "seconds": {**run.seconds, "assemble": 0.0, "setup": 0.0, "stresses": 0.0, "result": total - sum(run.seconds.values()), "total": total}}


@contextlib.contextmanager
def solved(analysis):
    """CalculiX has solved the analysis, with its solver, which it gets if it has none; meanwhile its files are there. Throws UserError when something is missing
    or CalculiX fails."""
    program()   # refuses before anything is changed
    start, known = time.perf_counter(), as_arrays(analysis)
    refuse_free_motions(known)
    solver = solver_of(analysis)
    tools = ccxtools.FemToolsCcx(analysis, solver, test_mode=False)
    with tempfile.TemporaryDirectory(prefix="featuremesh-") as folder, contextlib.redirect_stdout(sys.__stderr__):   # FreeCAD's tools print what they write
        write_input(tools, folder, analysis)
        matrix_solver = amend(tools.inp_file_name, solver, known)
        written = time.perf_counter()
        refuse_failure(run(tools), tools.ccx_stdout)
        yield SimpleNamespace(tools=tools, solver=solver, known=known, matrix_solver=matrix_solver,
                              remarks=solvers.remarks(analysis, solver) + remarks(tools.mesh.FemMesh.VolumeCount > 0, solver)
                                      + lacks(analysis, solver, tools.inp_file_name),
                              seconds={"read": written - start, "solve": time.perf_counter() - written})


def refuse_failure(code, words):
    """Throws UserError where CalculiX ended with that exit code, with its first error of all that it said, else its last lines."""
    if code:
        lines = words.splitlines()
        first = next((number for number, line in enumerate(lines) if "*ERROR" in line), max(0, len(lines) - _SHOWN))
        why = " ".join(" ".join(lines[first:first + _SHOWN]).split())
        raise UserError(said("CalculiX failed (exit code {code:count}): {why:messages}", code=code, why=why or said("it says nothing of why")))


def read_by_freecad(tools, analysis):
    """The result object that FreeCAD makes of CalculiX's files, of several that which came last; that of a live result is none of them. Throws UserError where
    there is none."""
    with solve_guard.told_in_a_report():
        tools.load_results()
    result = _last_result(analysis)
    if result is None:
        raise UserError(said("CalculiX gave no result for {analysis:text}", analysis=describe(analysis)))
    return result


def _last_result(analysis):
    of_live = [member.Result for member in analysis.Group if type_of(member) == statics_model.LIVE_RESULT]
    return next((member for member in reversed(analysis.Group) if member.isDerivedFrom("Fem::FemResultObject") and member not in of_live), None)


def refuse_free_motions(known):
    """Throws UserError for what can move as a rigid body, where the live solver knows all that holds it: CalculiX lets it fly for hundreds of kilometres."""
    with contextlib.suppress(statics.NotUnderstood):   # of very many pieces
        if known is not None:
            statics.refuse_free_motions(known)


def remarks(is_solid, solver):
    """What the stresses of shells and beams do not say."""
    if is_solid or solver.AnalysisType in modes.TABLES or getattr(solver, "BeamShellResultOutput3D", False):
        return []
    return [said("the stresses of shells and beams are those in the middle of the thickness, where bending makes none; switch "
                 "BeamShellResultOutput3D of {solver:text} on for those on the outside", solver=describe(solver))]


def lacks(analysis, solver, path):
    """What of the analysis the input in that file has not, where FreeCAD found a place for it by itself, and a choice of CalculiX's solver that does not fit: it says
    nothing of these."""
    return left_out(analysis, solver) + empty_loads(path) + _by_place(analysis) + _unfit_choice(analysis, solver)


def _unfit_choice(analysis, solver):
    if solver.AnalysisType != "static" or not getattr(solver, "MatrixSolverType", "default").startswith("iterative"):
        return []
    known = as_arrays(analysis)
    return [said("{solver:text} asks for an iterative solver, which ends too soon where points or edges hold the part or supports move it: displacements, stresses and "
                 "reactions may be off by several per cent. Choose another MatrixSolverType.", solver=describe(solver))] if known is not None and _why_unfit(known) else []


def left_out(analysis, solver):
    """What of the analysis is not in the input, of which FreeCAD says nothing."""
    members = [describe(member) for member in analyses.members_of(analysis) if not _is_written(femutils.type_of_obj(member), solver.AnalysisType)]
    return [said("CalculiX got nothing of {loads:text}, which FreeCAD does not write for the type of analysis {kind:text}", loads=", ".join(members),
                 kind=solver.AnalysisType)] if members else []


def empty_loads(path):
    """Loads of which the input has a heading only, such as a flux of heat on shells."""
    with open(path, encoding="utf-8") as stream:
        found = _EMPTY_LOAD.findall(stream.read())
    return [said("CalculiX got nothing of {loads:text}, for which FreeCAD found no elements", loads=", ".join(found))] if found else []


def _by_place(analysis):
    if _arrays(analysis) is None:
        return []
    resolver = resolving.Resolver(versions.part_of(statics.mesh_of(analysis)))
    return [said(_BY_PLACE, object=member.Label, where=[resolving.describe(*pair) for pair in foreign], part=describe(resolver.part))
            for member in analyses.members_of(analysis) if hasattr(member, "References") and not is_material(member) and (foreign := resolver.of_object(member)[1])]


def _is_written(member_type, kind):
    """Has FreeCAD's writer a module for constraints of that type, for analyses of that kind?"""
    _, is_constraint, name = member_type.partition("Fem::Constraint")
    if not is_constraint:
        return True
    try:
        writer = importlib.import_module("femsolver.calculix.write_constraint_" + _WRITERS.get(name, name).lower())
    except ImportError:
        return False
    kinds = writer.get_analysis_types()
    return kinds == "all" or kind in kinds


def _doubts(analysis, moved):
    """What makes the figures of a mesh of ours doubtful; `moved` is the largest displacement, None of modes."""
    arrays = _arrays(analysis)
    if arrays is None:
        return []
    return _flown(arrays, moved) + (statics.remarks(arrays) if len(arrays["tets"]) else [])


def has_flown(analysis, solver):
    """That the part moved in FreeCAD's results of a solution of CalculiX as none does that is held."""
    arrays, result = _arrays(analysis), _last_result(analysis)
    if arrays is None or result is None or solver.AnalysisType in modes.TABLES:
        return []
    return _flown(arrays, max((vector.Length for vector in result.DisplacementVectors), default=None))


def _flown(arrays, moved):
    size = np.ptp(arrays["points"], axis=0).max()
    return [] if moved is None or moved <= _FLOWN * size else [
        said("the part moved by {times:number} times its own size: it can move, since its supports and ties do not hold all of it, or a unit is wrong", times=moved / size)]


def _doubts_of_reactions(solver, unbalanced):
    """What CalculiX's iterative solver leaves, which ends by the forces at single nodes."""
    if unbalanced < _BALANCED:
        return []
    return [said("The reactions are off by {share:number} % of the loads, since CalculiX's iterative solver ends early; with a direct one, the property "
                 "MatrixSolverType of {solver:text}, they are not", share=100 * unbalanced, solver=describe(solver))]


def as_arrays(analysis):
    """What the live solver reads of the analysis, None where it does not know all that it holds."""
    try:
        return statics_model.prepared(analysis, statics.mesh_of(analysis))
    except UserError:
        return None


def write_input(tools, folder, analysis):
    """FreeCAD's input file, in the folder. Throws UserError."""
    if not analyses.meshes_of(analysis):
        raise UserError(said("{analysis:text} has no mesh; mesh its part first, by Mesh a part or `featuremesh mesh`", analysis=describe(analysis)))
    if tools.solver.AnalysisType == "check":
        raise UserError(said("{solver:text} only checks the mesh (Check Mesh), which gives no result; choose another type of analysis in its panel",
                             solver=describe(tools.solver)))
    tools.setup_working_dir(folder)
    tools.update_objects()
    problem = tools.check_prerequisites()
    if problem:
        raise UserError(said("CalculiX cannot solve {analysis:text}: {why:text}", analysis=describe(analysis), why=" ".join(problem.split())))
    try:
        with solve_guard.told_in_a_report():
            tools.write_inp_file()
    except Exception as error:   # FreeCAD's writer looks at little before it counts with it
        raise UserError(said("FreeCAD could not write CalculiX's input for {analysis:text}: {why:text}; is there a load of 0, on nothing, or on a face and an edge at once?",
                             analysis=describe(analysis), why=str(error))) from error
    tools.purge_results()
    if not tools.inp_file_name or not os.path.isfile(tools.inp_file_name):
        raise UserError(said("FreeCAD could not write CalculiX's input for {analysis:text}; its report view says why",
                             analysis=describe(analysis)))


def amend(path, solver, known):
    """Adds figures to print and, where that is better and left open, the solver. Returns {"name", "why"} of the solver."""
    with open(path, encoding="utf-8") as stream:
        text = stream.read()
    text, chosen = _with_solver(text, solver, known)
    everything = _ALL.search(text)
    if known is not None:
        text = _NODE_FILE.sub("*NODE FILE\nU, RF\n", text, count=1)
    if everything and solver.AnalysisType == "static":
        asked = "*EL PRINT, ELSET=%s, TOTALS=ONLY\n%s\n" % (everything.group(1), "ELSE, EMAS" if "*DENSITY" in text else "ELSE")
        text = text.replace("*END STEP", asked + "*END STEP", 1)
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)
    return chosen


def solves_iteratively(solver, known):
    """Will CalculiX be given an iterative solver, by the user or by us? It takes far less memory than a direct one. `known` as as_arrays gives it."""
    setting = getattr(solver, "MatrixSolverType", "default")
    return setting.startswith("iterative") or (setting == "default" and solver.AnalysisType == "static" and _why_direct(known) is None)


def _why_direct(known):
    """Why CalculiX's iterative solver is not for this model; None where it is."""
    if known is None:
        return "CalculiX's own choice"
    unknowns = 3 * len(known.arrays["points"])
    return "few unknowns (%d)" % unknowns if unknowns < _MANY else _why_unfit(known)


def _why_unfit(known):
    """Why the iterative solver would not be exact enough; None where it is."""
    if known.given.any():
        return _MOVED
    motions, _, _ = statics_supports.free_motions(known.arrays, statics_supports.held_by_faces(known.arrays, known.held))
    return None if motions is not None and not motions.shape[2] else _HELD_AT_POINTS


def _with_solver(text, solver, known):
    setting = getattr(solver, "MatrixSolverType", "default")
    if setting != "default":
        return text, {"name": setting, "why": "the solver object %s says so" % describe(solver)}
    why_direct = _why_direct(known)
    text, times = (text, 0) if why_direct else _STATIC.subn("*STATIC, SOLVER=ITERATIVE CHOLESKY", text, count=1)
    if not times:
        return text, {"name": "default", "why": why_direct or "CalculiX's own choice"}
    return text, {"name": "iterativecholesky", "why": "%d unknowns, linear statics of solids: the direct solver takes longer and more memory; "
                  "the property MatrixSolverType of %s chooses another" % (3 * len(known.arrays["points"]), describe(solver))}


def _read_arrays(analysis, known, path):
    """The result object from the file's arrays, the reactions by support, and what share of the loads these do not balance; None where the file has not what is
    expected. Throws UserError."""
    blocks = frd.read(path, {"DISP": 3, "STRESS": 6, "TOSTRAIN": 6, "FORC": 3})
    numbers = known.arrays["node_numbers"]
    order = np.argsort(numbers)
    if not {"DISP", "STRESS", "FORC"} <= set(blocks) or any(not np.array_equal(np.sort(found), numbers[order]) for found, _ in blocks.values()):
        return None
    if not all(np.isfinite(values).all() for _, values in blocks.values()):
        raise UserError(said("CalculiX gave what is no number for {analysis:text}: look at its loads, materials and units, or choose another MatrixSolverType",
                             analysis=describe(analysis)))
    rows = np.empty(len(numbers), dtype=np.int64)

    def by_row(name):
        found, values = blocks[name]
        rows[order] = np.argsort(found)
        return values[rows]

    stresses = by_row("STRESS")
    fields = {"displacements": by_row("DISP"), "stresses": stresses, "von_mises": statics_result.von_mises(stresses)}
    if "TOSTRAIN" in blocks:
        fields["strains"] = by_row("TOSTRAIN")
    loads = known.add_up().loads
    left = by_row("FORC") - loads   # of the forces within the part; none but where it is held, if they are exact
    unbalanced = np.abs(np.where(known.held, 0, left).sum(axis=0)).max() / np.abs(loads).sum() if loads.any() else 0.0
    return statics_result.show(analysis, known.arrays, fields, "CCX_Results"), statics.reactions(known, left), unbalanced


def solver_of(analysis):
    """The CalculiX solver that is meant, or a new one for linear statics where it has none. Throws UserError."""
    solver = solvers.for_calculix(analysis)
    if solver is None:
        make = getattr(ObjectsFem, "makeSolverCalculiXCcxTools", None) or ObjectsFem.makeSolverCalculixCcxTools
        solver = make(analysis.Document, "CalculiX")
        solver.GeometricalNonlinearity = "linear"
        solver.ThermoMechSteadyState = solver.IterationsControlParameterTimeUse = False
        analysis.addObject(solver)
    return solver


def program():
    """The one that FreeCAD runs: the user's own setting, else the program on the path. Throws UserError."""
    settings = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/Fem/Ccx")
    is_chosen = not (versions.can_leave_chosen_calculix() and settings.GetBool("UseStandardCcxLocation", True))
    chosen = settings.GetString("ccxBinaryPath", "") if is_chosen else ""
    found = shutil.which(chosen or "ccx")
    if chosen and not found:
        raise UserError(said("CalculiX's program is set to {path:text}, which cannot be run; choose another one in FreeCAD's preferences, FEM > CalculiX", path=chosen))
    if not found:
        raise UserError(said("CalculiX (ccx) is not installed; on Debian its package is calculix-ccx"))
    return found


def run(tools):
    """Has FreeCAD's tools run CalculiX on the input they wrote. Returns its exit code. Throws UserError where the program is another one."""
    with parent_process.of_what_starts(ccxtools):
        code = tools.ccx_run()
    if not tools.ccx_binary_present:
        raise UserError(said("CalculiX's program is set to {path:text}, which is not CalculiX; choose another one in FreeCAD's preferences, FEM > CalculiX", path=program()))
    return code


def _responses(analysis, result, is_by_row, printed, kind):
    """`is_by_row`: are the result's nodes those of the mesh's arrays, row by row? FreeCAD counts them in the order of their numbers. How large the
    displacements, stresses and reactions of a mode are says nothing."""
    nothing = dict.fromkeys(("max_mises_mpa", "max_mises_at", "max_displacement_mm", "max_displacement_at"))
    if kind in modes.TABLES:
        return {**nothing, "frequencies_hz" if kind == "frequency" else "buckling_factors": modes.read(printed, kind)}
    temperature = {"max_temperature_k": max(result.Temperature)} if kind == "thermomech" and len(result.Temperature) else {}
    if not len(result.DisplacementVectors):   # of heat alone
        return {**nothing, **temperature}
    displacements = np.array([tuple(vector) for vector in result.DisplacementVectors])
    mises, lengths = np.array(result.vonMises), np.linalg.norm(displacements, axis=1)
    worst, farthest = int(mises.argmax()), int(lengths.argmax())
    arrays = _arrays(analysis)
    order = np.argsort(arrays["node_numbers"]) if arrays is not None and not is_by_row else np.arange(len(mises))
    rows = np.argsort(np.argsort(result.NodeNumbers))

    def place(row):
        return statics.place(arrays, int(order[rows[row]])) if arrays is not None and len(order) == len(rows) else None

    return {"max_mises_mpa": float(mises[worst]), "max_mises_at": place(worst),
            "max_displacement_mm": float(lengths[farthest]), "max_displacement_at": place(farthest), **temperature}


def _arrays(analysis):
    try:
        mesh = statics.mesh_of(analysis)
    except statics_model.NotUnderstood:
        return None
    return mesh.Proxy.arrays(mesh)


def _mass(analysis, known, printed):
    """kg, None where it is not known. CalculiX prints it where something weighs."""
    if known is not None and known.has_density:
        return statics.mass(known)
    arrays = _arrays(analysis)
    if arrays is None:
        return _figure(_MASS, printed, statics.TONNE)
    with contextlib.suppress(UserError):
        return mass.of_part(versions.part_of(statics.mesh_of(analysis)), analysis, arrays)
    return None


def printed_reactions(text, analysis):
    """Of the supports, whose sums FreeCAD asks CalculiX to print: reactions and what loads their nodes. Of a rigid body what holds its reference node; what
    CalculiX prints of its turning are moments."""
    members, found = {member.Name.upper(): member for member in analysis.Group}, {}
    for name, *force in _TOTAL.findall(text):
        member, values = members.get(name.removesuffix(_REFERENCE)), [float(value) for value in force]
        if name.endswith(_REFERENCE) and name not in members and member is not None:
            held = [getattr(member, "TranslationalMode" + axis) == "Constraint" for axis in "XYZ"]
            if any(held):
                found[member.Name] = [value if is_held else 0.0 for value, is_held in zip(values, held)]
        elif member is not None:
            found[member.Name] = values
    return found


def printed_strain_energy(text):
    """mJ, or None where it was not printed."""
    return _figure(_ENERGY, text)


def _figure(pattern, text, factor=1.0):
    found = pattern.findall(text)
    return float(found[-1]) * factor if found else None

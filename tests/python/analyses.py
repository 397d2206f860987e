# SPDX-License-Identifier: GPL-3.0-or-later
"""Analyses for the tests: made for the running FreeCAD, solved by CalculiX, and tables of what came out."""
import os
import shutil
import sys
import tempfile

import ObjectsFem
from femtools import ccxtools
from freecad.featuremesh import versions

LONG = bool(os.environ.get("FEATUREMESH_LONG"))  # also what takes minutes


def quantity(value, unit):
    """A load as the running FreeCAD wants it: a number on 0.20, with its unit later."""
    return value if versions.version() < (1, 0) else "%.9g %s" % (value, unit)


def add_solver(document, analysis, kind="static"):
    """CalculiX with plain settings."""
    make = getattr(ObjectsFem, "makeSolverCalculiXCcxTools", None) or ObjectsFem.makeSolverCalculixCcxTools
    solver = make(document, "Solver")
    solver.AnalysisType, solver.GeometricalNonlinearity = kind, "linear"
    solver.ThermoMechSteadyState = solver.IterationsControlParameterTimeUse = False
    analysis.addObject(solver)
    return solver


def add_material(document, analysis, name, values, references=()):
    material = ObjectsFem.makeMaterialSolid(document, name)
    material.Material = values
    if references:
        material.References = list(references)
    analysis.addObject(material)
    return material


def hold_plane(document, analysis, name, part, faces, axis):
    """Nothing of these faces moves along the axis "x", "y" or "z"."""
    held = ObjectsFem.makeConstraintDisplacement(document, name)
    held.References = [(part, face) for face in faces]
    setattr(held, axis + "Free", False)
    analysis.addObject(held)
    return held


def solver_of(analysis):
    solver, = [member for member in analysis.Group if member.isDerivedFrom("Fem::FemSolverObjectPython")]
    return solver


def clear_results(analysis):
    """Removes what an earlier solution left in the document."""
    document = analysis.Document
    for kind in ("Fem::FemPostObject", "Fem::FemResultObject"):
        for name in [obj.Name for obj in document.Objects if obj.isDerivedFrom(kind)]:
            document.removeObject(name)
    for name in [obj.Name for obj in document.Objects if obj.Name.startswith("ResultMesh")]:
        document.removeObject(name)


def solve(analysis):
    """Runs CalculiX. Gives {"displacement": largest, mm, "displacement_z": largest along z, mm, "coldest": K, "frequency": Hz,
    "buckling": factor}, as far as the analysis has it, with "result": the result object, None for frequency and buckling, and
    "input": the input file's text."""
    clear_results(analysis)
    solver = solver_of(analysis)
    tools = ccxtools.FemToolsCcx(analysis, solver, test_mode=False)
    with tempfile.TemporaryDirectory(prefix="featuremesh-") as folder:
        tools.setup_working_dir(folder)
        tools.update_objects()
        tools.setup_ccx(ccx_binary=shutil.which("ccx"))
        problem = tools.check_prerequisites()
        if problem:
            raise RuntimeError(problem)
        tools.write_inp_file()
        if tools.ccx_run():
            raise RuntimeError("CalculiX failed: " + tools.ccx_stdout[-600:])
        with open(tools.inp_file_name, encoding="utf-8") as stream:
            found = {"result": None, "input": stream.read()}
        if solver.AnalysisType in ("frequency", "buckling"):
            found[solver.AnalysisType] = first_value(tools.inp_file_name[:-len("inp")] + "dat", solver.AnalysisType)
            return found
        tools.load_results()
    result = [member for member in analysis.Group if member.isDerivedFrom("Fem::FemResultObject")][-1]
    found.update(result=result, displacement=max(vector.Length for vector in result.DisplacementVectors),
                 displacement_z=max(abs(vector.z) for vector in result.DisplacementVectors))
    if len(result.Temperature):
        found["coldest"] = min(result.Temperature)
    return found


def first_value(path, kind):
    """The lowest frequency or buckling factor of CalculiX's table."""
    title, columns, column = {"frequency": ("E I G E N V A L U E   O U T P U T", 5, 3),
                              "buckling": ("B U C K L I N G", 2, 1)}[kind]
    with open(path, encoding="utf-8") as stream:
        lines = iter(stream.read().splitlines())
    if not any(title in line for line in lines):
        raise RuntimeError("no %s in %s" % (kind, path))
    words = next(line.split() for line in lines if len(line.split()) == columns and line.split()[0].isdigit())
    return float(words[column])


def print_table(title, head, rows):
    """A table in Markdown, each line by itself so that it can be picked out of a log."""
    rows = [[str(cell) for cell in row] for row in rows]
    widths = [max(len(row[i]) for row in [head, *rows]) for i in range(len(head))]
    print("\n" + title, file=sys.stderr)
    for row in [head, ["-" * width for width in widths], *rows]:
        print("| " + " | ".join(cell.ljust(width) for cell, width in zip(row, widths)) + " |", file=sys.stderr)


def held_and_pushed(document, part):
    """The plate held at one end and pushed down at the other."""
    from statics_cases import STEEL, edges_along, faces_at
    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    add_solver(document, analysis)
    add_material(document, analysis, "Steel", STEEL)
    box = part.Shape.BoundBox
    fixed = ObjectsFem.makeConstraintFixed(document, "Fixed")
    fixed.References = [(part, faces_at(part, 0, box.XMin))]
    force = ObjectsFem.makeConstraintForce(document, "Force")
    force.References = [(part, faces_at(part, 0, box.XMax))]
    force.Force = quantity(1000, "N")
    force.Direction = (part, edges_along(part, 2)[:1])
    force.Reversed = True
    analysis.addObject(fixed)
    analysis.addObject(force)
    for obj in (fixed, force):
        obj.ViewObject.Visibility = False
    return analysis

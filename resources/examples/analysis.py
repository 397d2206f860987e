# SPDX-License-Identifier: GPL-3.0-or-later
"""A static analysis for CalculiX on an example: steel, one fixed face, one force on a face; the mesh is added later."""
import FreeCAD as App
import ObjectsFem

STEEL = {"Name": "Steel", "YoungsModulus": "210000 MPa", "PoissonRatio": "0.30", "Density": "7850 kg/m^3"}


def add_analysis(document, part, fixed_at, force_at, force_newton):
    """Fixes the faces through the points `fixed_at`, and presses on the face through `force_at` against its normal."""
    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    make_solver = getattr(ObjectsFem, "makeSolverCalculiXCcxTools", None) or ObjectsFem.makeSolverCalculixCcxTools
    solver = make_solver(document, "Solver")
    solver.AnalysisType = "static"
    solver.GeometricalNonlinearity = "linear"
    solver.ThermoMechSteadyState = False
    solver.IterationsControlParameterTimeUse = False
    material = ObjectsFem.makeMaterialSolid(document, "Steel")
    material.Material = STEEL
    fixed = ObjectsFem.makeConstraintFixed(document, "Fixed")
    fixed.References = [(part, face_through(part.Shape, point)) for point in fixed_at]
    force = ObjectsFem.makeConstraintForce(document, "Force")
    force.References = [(part, face_through(part.Shape, force_at))]
    force.Force = force_newton if isinstance(force.Force, float) else f"{force_newton} N"
    force.Reversed = True
    for member in (solver, material, fixed, force):
        analysis.addObject(member)
    return analysis


def face_through(shape, point):
    """The name of the face through a point, such as "Face3"."""
    vertex = App.Vector(*point)
    for number, face in enumerate(shape.Faces, 1):
        if face.isInside(vertex, 1e-4, True):
            return f"Face{number}"
    raise ValueError(f"no face goes through {point}")

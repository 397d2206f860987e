# SPDX-License-Identifier: GPL-3.0-or-later
"""Run by `featuremesh run`: saves a plate with a hole and an analysis, meshed coarsely, as FEATUREMESH_STUDY_PART.

FEATUREMESH_STUDY_KIND is the kind of analysis: static (default: pulled), buckling (pressed), frequency (free at the far end), thermomech (pulled, and
warmer at the far end), gmsh (static, with a mesh of Gmsh's in place of ours).
"""
import os

import FreeCAD
import ObjectsFem
from analyses import add_material, add_solver, quantity, solver_of
from freecad.featuremesh import api, documents, engine
from parts import plate_with_hole

STEEL = {"Name": "Steel", "YoungsModulus": "210000 MPa", "PoissonRatio": "0.30", "Density": "7850 kg/m^3",
         "ThermalConductivity": "50 W/m/K", "ThermalExpansionCoefficient": "1.2e-5 m/m/K", "SpecificHeat": "500 J/kg/K"}


def face_at(part, x):
    """Name of the plane face normal to the x axis at x."""
    return next("Face%d" % number for number, face in enumerate(part.Shape.Faces, 1) if face.BoundBox.XLength < 1e-6 and abs(face.BoundBox.XMin - x) < 1e-6)


def add_temperatures(document, analysis, part):
    """300 K at the fixed face, 400 K at the far end."""
    start = ObjectsFem.makeConstraintInitialTemperature(document, "Start")
    start.initialTemperature = quantity(300.0, "K")
    analysis.addObject(start)
    for name, x, kelvin in (("Cold", 0, 300.0), ("Warm", 60, 400.0)):
        held = ObjectsFem.makeConstraintTemperature(document, name)
        held.References = [(part, face_at(part, x))]
        held.Temperature = quantity(kelvin, "K")
        analysis.addObject(held)
    solver_of(analysis).ThermoMechSteadyState = True


document = FreeCAD.newDocument("Study")
body = plate_with_hole(document)
analysis = ObjectsFem.makeAnalysis(document, "Analysis")
KIND = os.environ.get("FEATUREMESH_STUDY_KIND", "static")
add_solver(document, analysis, "static" if KIND == "gmsh" else KIND)
add_material(document, analysis, "Steel", STEEL)
fixed = ObjectsFem.makeConstraintFixed(document, "Fixed")
fixed.References = [(body, face_at(body, 0))]
force = ObjectsFem.makeConstraintForce(document, "Force")
force.References = [(body, face_at(body, 60))]
force.Force = quantity(6000.0, "N")   # in tension
force.Reversed = KIND == "buckling"
for member in (fixed, force)[:1 if KIND == "frequency" else 2]:
    analysis.addObject(member)
if KIND == "thermomech":
    add_temperatures(document, analysis, body)
if KIND == "gmsh":
    mesh = ObjectsFem.makeMeshGmsh(document, "Gmsh")
    mesh.CharacteristicLengthMax = 10.0
    analysis.addObject(mesh)
else:
    mesh = api.add_mesh(body, 10.0)
document.recompute()
has_live_solver = not engine.load().statics_missing()
if KIND == "static" and has_live_solver:
    api.live_result(analysis)   # as a document has it that was worked with
documents.save_document(document, os.environ["FEATUREMESH_STUDY_PART"])
print(face_at(body, 60), "live" if has_live_solver else "ccx")

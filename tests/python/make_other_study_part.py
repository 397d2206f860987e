# SPDX-License-Identifier: GPL-3.0-or-later
"""Run by `featuremesh run`: saves a part that is no single solid, with an analysis, meshed, as FEATUREMESH_STUDY_PART.

FEATUREMESH_STUDY_KIND is what it is: sheet (a cantilever 200 x 50 mm, 8 mm thick), middle (likewise, with stresses in the middle of the
thickness), sheets (two of them, of two thicknesses and materials), beam (a cantilever of 20 x 20 mm), tied (two blocks of 10 x 10 x 20 mm of two
materials, held by a tie), mixed (a block beside a sheet), zone (the plate with a hole, refined round a point).
"""
import os

import FreeCAD
import ObjectsFem
from analyses import add_material, add_solver, quantity, solver_of
from freecad.featuremesh import api, assembled, documents, size_zone
from parts import placement, plate_with_hole

STEEL = {"Name": "Steel", "YoungsModulus": "210000 MPa", "PoissonRatio": "0.0", "Density": "7850 kg/m^3"}
ALUMINIUM = {**STEEL, "Name": "Aluminium", "YoungsModulus": "70000 MPa", "Density": "2700 kg/m^3"}
SHARP = 1e-6   # mm


def named(shape, kind, axis, at):
    """Name of the only face, edge or vertex all of whose points are there."""
    box = "%s%s" % (axis.upper(), "%s")
    elements = {"Face": shape.Faces, "Edge": shape.Edges, "Vertex": shape.Vertexes}[kind]
    found, = ["%s%d" % (kind, number) for number, element in enumerate(elements, 1)
              if all(abs(getattr(element.BoundBox, box % end) - at) < SHARP for end in ("Min", "Max"))]
    return found


def add_supports(part, analysis, kind, axis, end, newtons, direction):
    """Held where the axis begins, loaded at its end."""
    fixed, load = ObjectsFem.makeConstraintFixed(part.Document, "Fixed"), ObjectsFem.makeConstraintForce(part.Document, "Load")
    fixed.References, load.References = [(part, named(part.Shape, kind, axis, 0))], [(part, named(part.Shape, kind, axis, end))]
    load.Force, load.DirectionVector = quantity(newtons, "N"), FreeCAD.Vector(*direction)
    for member in (fixed, load):
        analysis.addObject(member)


def sheet(document, analysis):
    part = document.addObject("Part::Plane", "Sheet")
    part.Length, part.Width = 200, 50
    document.recompute()
    add_material(document, analysis, "Steel", STEEL)
    analysis.addObject(ObjectsFem.makeElementGeometry2D(document, 8.0, "Thickness"))
    solver_of(analysis).BeamShellResultOutput3D = KIND == "sheet"
    add_supports(part, analysis, "Edge", "x", 200, 100.0, (0, 0, -1))
    return part, 10


def sheets(document, analysis):
    part = document.addObject("Part::Compound", "Sheets")
    part.Links = halves = [document.addObject("Part::Plane", name) for name in ("Near", "Far")]
    for half in halves:
        half.Length, half.Width = 100, 50
    halves[1].Placement = placement(0, 60, 0)
    document.recompute()
    for half, number, values, thickness in zip(halves, (1, 2), (STEEL, ALUMINIUM), (8.0, 2.0)):
        add_material(document, analysis, "Material" + half.Name, values, [(part, "Face%d" % number)])
        made = ObjectsFem.makeElementGeometry2D(document, thickness, "Thickness" + half.Name)
        made.References = [(part, "Face%d" % number)]
        analysis.addObject(made)
    return part, 10


def beam(document, analysis):
    part = document.addObject("Part::Line", "Axis")
    part.X2, part.Y2, part.Z2 = 200, 0, 0
    document.recompute()
    add_material(document, analysis, "Steel", STEEL)
    analysis.addObject(ObjectsFem.makeElementGeometry1D(document, "Rectangular", 20.0, 20.0, name="Section"))
    solver_of(analysis).BeamShellResultOutput3D = True
    add_supports(part, analysis, "Vertex", "x", 200, 100.0, (0, 0, -1))
    return part, 10


def tied(document, analysis):
    container = document.addObject("App::Part", "Machine")
    for number, name in enumerate(("Lower", "Upper")):
        block = document.addObject("Part::Box", name)
        block.Length, block.Width, block.Height = 10, 10, 20
        block.Placement = placement(0, 0, 20 * number)
        container.addObject(block)
    document.recompute()
    part = assembled.of(container)
    document.recompute()
    for number, values in enumerate((STEEL, ALUMINIUM), 1):
        add_material(document, analysis, "Material%d" % number, values, [(part, "Solid%d" % number)])
    tie = ObjectsFem.makeConstraintTie(document, "Tie")
    faces = [face for face in range(1, len(part.Shape.Faces) + 1)
             if abs(part.Shape.Faces[face - 1].CenterOfMass.z - 20) < SHARP and part.Shape.Faces[face - 1].BoundBox.ZLength < SHARP]
    tie.References = [(part, "Face%d" % face) for face in reversed(faces)]
    tie.Tolerance = quantity(0.01, "mm")
    analysis.addObject(tie)
    add_supports(part, analysis, "Face", "z", 40, 1000.0, (0, 0, 1))
    return part, 5


def mixed(document, analysis):
    block, sheet = document.addObject("Part::Box", "Block"), document.addObject("Part::Plane", "Sheet")
    block.Length, block.Width, block.Height = 10, 10, 20
    sheet.Length, sheet.Width, sheet.Placement = 40, 10, placement(10, 0, 0)
    part = document.addObject("Part::Compound", "Both")
    part.Links = [block, sheet]
    document.recompute()
    add_material(document, analysis, "Steel", STEEL)
    analysis.addObject(ObjectsFem.makeElementGeometry2D(document, 2.0, "Thickness"))
    return part, 5


def zone(document, analysis):
    part = plate_with_hole(document)
    add_material(document, analysis, "Steel", STEEL)
    add_supports(part, analysis, "Face", "x", 60, 6000.0, (1, 0, 0))
    return part, 10


document = FreeCAD.newDocument("Study")
analysis = ObjectsFem.makeAnalysis(document, "Analysis")
add_solver(document, analysis)
KIND = os.environ["FEATUREMESH_STUDY_KIND"]
part, size = {"sheet": sheet, "middle": sheet, "sheets": sheets, "beam": beam, "tied": tied, "mixed": mixed, "zone": zone}[KIND](document, analysis)
mesh = api.add_mesh(part, size, active_analysis=analysis)
if KIND == "zone":
    made = size_zone.add(mesh, size_zone.SPHERE, 3.0)
    made.Radius, made.Placement = 5, placement(45, 20, 5)
document.recompute()
documents.save_document(document, os.environ["FEATUREMESH_STUDY_PART"])

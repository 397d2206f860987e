# SPDX-License-Identifier: GPL-3.0-or-later
"""A wire and a sheet by hand, from nothing to a second result: which part is meant, what can be clicked after the mesh, what the colours show.

Run by test_window.py; see drive_window.py for the result and the pictures.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import Draft  # noqa: E402
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import numpy as np  # noqa: E402
import ObjectsFem  # noqa: E402
import window  # noqa: E402
from analyses import add_material, add_solver, quantity, solve  # noqa: E402
from PySide import QtGui  # noqa: E402
from window import click, click_in_panel, click_in_view, is_whole, panel, picture, pixels, spin, wait_for  # noqa: E402

Vector = FreeCAD.Vector
LONG_LABEL = "Open CASCADE STEP translator 7.6 1.1.2"   # as FreeCAD labels what a file gives no name
STEEL = {"Name": "Steel", "YoungsModulus": "210000 MPa", "PoissonRatio": "0.30", "Density": "7900 kg/m^3"}


def new_document(name):
    document = FreeCAD.newDocument(name)
    document.UndoMode = 1
    return document


def fit():
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    spin()


def are_seen(*objects):
    return [obj.ViewObject.Visibility for obj in objects]


def mesh_what_is_there(size):
    """Without a selection: the only part there is. The panel fits, and says what is done in lines that do."""
    Gui.Selection.clearSelection()
    Gui.runCommand("FeatureMesh_MeshPart")
    spin()
    settings = panel("MeshPanel")
    assert is_whole(settings.form), settings.form.width()
    for row in range(settings.order.count()):
        text = settings.order.fontMetrics().boundingRect(settings.order.itemText(row)).width()
        assert settings.order.width() > text + 40, (settings.order.itemText(row), text, settings.order.width())   # 40 for its frame and arrow
    settings.size.setProperty("rawValue", size)
    click_in_panel("Apply")
    wait_for(lambda: settings.running is None or settings.step.text())
    picture("shells_panel")
    wait_for(lambda: settings.running is None)
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    return settings.mesh


def add_fixed(analysis, part, mesh, place):
    """FEM's own support after the mesh: the part is there to be clicked while the panel is open, and the mesh is back after it."""
    assert are_seen(part, mesh) == [False, True]
    before = set(part.Document.Objects)
    Gui.Selection.clearSelection()
    Gui.runCommand("FEM_ConstraintFixed")
    spin()
    assert are_seen(part, mesh) == [True, False], are_seen(part, mesh)
    click(Gui.getMainWindow().findChild(QtGui.QToolButton, "btnAdd"))
    click_in_view(place)
    picture("shells_fixed")
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    assert are_seen(part, mesh) == [False, True], are_seen(part, mesh)
    support, = set(part.Document.Objects) - before
    assert support in analysis.Group and [target for target, _ in support.References] == [part], support.References
    return support


def check_wire():
    """A wire of Draft, whose edges are beams; FEM's panel of sections hides all meshes, and shows nothing by itself."""
    document = new_document("Beams")
    wire = Draft.make_wire([Vector(0, 0, 0), Vector(100, 0, 0), Vector(100, 0, 80)], closed=False, face=False)
    wire.Label = LONG_LABEL
    document.recompute()
    fit()
    Gui.runCommand("FEM_Analysis")
    spin()
    analysis = document.Analysis
    mesh = mesh_what_is_there(10)
    assert mesh in analysis.Group and mesh.TetCount == mesh.FemMesh.EdgeCount == 18, mesh.TetCount
    add_fixed(analysis, wire, mesh, Vector(50, 0, 0))
    for button in ("Cancel", "Ok"):
        Gui.runCommand("FEM_ElementGeometry1D")
        spin()
        assert are_seen(wire, mesh) == [True, False]
        click_in_panel(button)
        wait_for(lambda: not Gui.Control.activeDialog())
        assert are_seen(wire, mesh) == [False, True], (button, are_seen(wire, mesh))
    FreeCAD.closeDocument(document.Name)


def check_selected_sketch():
    """A sketch of an extrusion means that; one of which nothing is made means its lines."""
    import Part
    from freecad.featuremesh.commands.base import selected_part
    document = new_document("Sketches")
    sketch = document.addObject("Sketcher::SketchObject", "Sketch")
    sketch.addGeometry(Part.LineSegment(Vector(0, 0), Vector(30, 0)))
    document.recompute()
    Gui.Selection.addSelection(sketch)
    assert selected_part(document) is sketch
    extrusion = document.addObject("Part::Extrusion", "Extrusion")
    extrusion.Base, extrusion.Dir, extrusion.LengthFwd = sketch, Vector(0, 0, 1), 20
    document.recompute()
    assert selected_part(document) is extrusion
    FreeCAD.closeDocument(document.Name)


def check_sheet():
    """What was solved before the last edit does not cover the colours of the mesh, and is there again after them."""
    document = new_document("Sheet")
    sheet = document.addObject("Part::Plane", "Sheet")
    sheet.Length, sheet.Width = 100, 50
    document.recompute()
    fit()
    Gui.runCommand("FEM_Analysis")
    spin()
    analysis = document.Analysis
    for solver in [member for member in analysis.Group if member.isDerivedFrom("Fem::FemSolverObjectPython")]:
        document.removeObject(solver.Name)
    mesh = mesh_what_is_there(10)
    analysis.addObject(ObjectsFem.makeElementGeometry2D(document, 2.0))
    add_material(document, analysis, "Steel", STEEL)
    add_solver(document, analysis)
    support = add_fixed(analysis, sheet, mesh, Vector(50, 25, 0))
    load = ObjectsFem.makeConstraintForce(document, "Load")
    load.Force = quantity(10, "N")
    analysis.addObject(load)
    support.References, load.References = [(sheet, "Edge1")], [(sheet, "Edge3")]
    document.recompute()
    result = solve(analysis)["result"]
    sheet.Width = 60
    document.recompute()
    for obj in (sheet, result.Mesh):
        obj.ViewObject.Visibility = True
    mesh.ViewObject.Visibility = False
    fit()
    from freecad.featuremesh import overlays
    for command, kind, colours in (("FeatureMesh_ShowKept", "KeptPanel", overlays.kept_legend()[:2]), ("FeatureMesh_ShowQuality", "QualityPanel", ())):
        Gui.runCommand(command)
        spin()
        shown = panel(kind)
        assert are_seen(sheet, result.Mesh, mesh) == [False, False, True], (kind, are_seen(sheet, result.Mesh, mesh))
        picture("shells_" + kind)
        for colour in colours:
            assert count_of(colour, pixels()) > 3000, (colour, count_of(colour, pixels()))
        shown.reject()
        spin()
        assert are_seen(sheet, result.Mesh, mesh) == [True, True, False]
    FreeCAD.closeDocument(document.Name)


def count_of(colour, seen):
    """How many pixels have about the hue of a colour, whatever light falls on it."""
    hues = seen / np.maximum(np.linalg.norm(seen, axis=2), 1)[:, :, None]
    return int((np.abs(hues - np.array(colour) / np.linalg.norm(colour)).max(axis=2) < 0.09).sum())


def drive():
    Gui.getMainWindow().setGeometry(0, 0, 1280, 800)
    Gui.activateWorkbench("FemWorkbench")
    spin()
    check_wire()
    check_selected_sketch()
    check_sheet()


window.run(drive)

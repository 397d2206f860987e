# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the user's guide's pictures of the window anew, with the bracket of the examples:

    FEATUREMESH_PICTURES=docs/pictures /usr/bin/python3 tests/python/test_window.py draw_guide.py
"""
import os
import shutil
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import Part  # noqa: E402
import window  # noqa: E402
from PySide import QtCore, QtGui  # noqa: E402
from window import panel, spin, wait_for  # noqa: E402

BRACKET = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "resources", "examples", "bracket.FCStd")


def save(name, box=None, width=1000):
    """Saves what the screen shows, or a part (x, y, width, height) of it, at that width."""
    spin(1)
    shot = QtGui.QGuiApplication.primaryScreen().grabWindow(0)
    shot = shot.copy(*box) if box else shot
    shot.scaledToWidth(width, QtCore.Qt.SmoothTransformation).save(os.path.join(window.PICTURES, name + ".jpg"), "JPG", 85)


def opened_bracket(folder):
    """A copy of the bracket in the window, seen from the corner whose hole will move."""
    path = os.path.join(folder, "bracket.FCStd")
    shutil.copy(BRACKET, path)
    document = FreeCAD.openDocument(path)
    document.UndoMode = 1
    for obj in document.Objects:
        if obj.isDerivedFrom("Fem::Constraint"):
            obj.ViewObject.Visibility = False
    view = Gui.activeDocument().activeView()
    view.viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    return document, path


def meshed(document):
    """The mesh, with its panel still open."""
    from freecad.featuremesh import api
    Gui.runCommand("FeatureMesh_MeshPart")
    spin()
    mesh, = api.meshes_of(document)
    settings = panel("MeshPanel")
    settings.size.setProperty("rawValue", 4)
    wait_for(lambda: "elements" in settings.estimate.text())
    settings.start(False)
    wait_for(lambda: settings.running is None)
    return mesh, settings


def draw():
    from freecad.featuremesh import versions
    from freecad.featuremesh.commands import compare
    main = Gui.getMainWindow()
    main.setGeometry(0, 0, 1280, 770)
    for dock in main.findChildren(QtGui.QDockWidget):
        if dock.objectName() in ("Report view", "Python console"):
            dock.hide()
    Gui.activateWorkbench("FeatureMeshWorkbench")
    spin()
    window.open_dialog().close()
    document, path = opened_bracket(os.path.dirname(os.environ["FEATUREMESH_RESULT"]))
    mesh, settings = meshed(document)
    save("panel")
    settings.reject()
    spin()
    Gui.runCommand("FeatureMesh_ShowQuality")
    spin()
    shown = panel("QualityPanel")
    shown.worst.setCurrentRow(0)
    save("quality_panel")
    shown.reject()
    document.getObject("HoleSketch").setDatum("Hole6X", FreeCAD.Units.Quantity("105 mm"))
    document.recompute()
    Gui.runCommand("FeatureMesh_ShowKept")
    spin()
    save("kept_panel")
    panel("KeptPanel").reject()
    spin()
    draw_live(document, mesh)
    draw_difference(main, versions.part_of(mesh), mesh, compare.Command().show, path)
    draw_menu(main)
    draw_shells()


def folded_sheet(document):
    """A sheet with a round fold and a hole in it; "Sheet", and "Tool", which cuts the hole."""
    Vector = FreeCAD.Vector
    wire = Part.Wire([Part.makeLine(Vector(0, 0, 60), Vector(0, 0, 12)), Part.Arc(Vector(0, 0, 12), Vector(3.5, 0, 3.5), Vector(12, 0, 0)).toShape(),
                      Part.makeLine(Vector(12, 0, 0), Vector(90, 0, 0))])
    profile, fold = document.addObject("Part::Feature", "Profile"), document.addObject("Part::Extrusion", "Fold")
    profile.Shape = wire
    fold.Base, fold.DirMode, fold.Dir, fold.LengthFwd, fold.Solid = profile, "Custom", Vector(0, 1, 0), 70, False
    tool, sheet = document.addObject("Part::Cylinder", "Tool"), document.addObject("Part::Cut", "Sheet")
    tool.Radius, tool.Height, tool.Placement.Base = 10, 20, Vector(45, 35, -10)
    sheet.Base, sheet.Tool = fold, tool
    document.recompute()
    return sheet, tool


def draw_menu(main):
    """FEM's own menu with our commands."""
    Gui.activateWorkbench("FemWorkbench")
    spin()
    bar = main.menuBar()
    entry, = [action for action in bar.actions() if action.text().replace("&", "") == "Mesh"]
    entry.menu().popup(bar.mapToGlobal(bar.actionGeometry(entry).bottomLeft()))
    save("fem_menu", (0, 0, 1000, 120 + entry.menu().sizeHint().height()))
    entry.menu().close()


def draw_shells():
    """What the last update of a sheet kept."""
    from freecad.featuremesh import api
    document = FreeCAD.newDocument("Shells")
    sheet, tool = folded_sheet(document)
    mesh = api.add_mesh(sheet, 4)
    document.recompute()
    tool.Placement.Base = FreeCAD.Vector(52, 35, -10)
    document.recompute()
    sheet.ViewObject.Visibility = False
    view = Gui.activeDocument().activeView()
    view.viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(mesh)
    Gui.runCommand("FeatureMesh_ShowKept")
    save("shells")
    panel("KeptPanel").reject()


def draw_live(document, mesh):
    """The live result before an edit, and what the edit changed."""
    from freecad.featuremesh import live_result
    Gui.runCommand("FeatureMesh_LiveResult")
    spin()
    shown = panel("LivePanel")
    wait_for(lambda: shown.live.Status == live_result.UP_TO_DATE)
    save("live_result")
    document.getObject("HoleSketch").setDatum("Hole6X", FreeCAD.Units.Quantity("102 mm"))
    document.recompute()
    wait_for(lambda: shown.live.Status == live_result.UP_TO_DATE)
    shown.difference.setChecked(True)
    save("live_change")
    shown.reject()
    shown.live.ViewObject.Visibility = False


def draw_difference(main, part, mesh, compare, path):
    """The table of what changed, its first change opened, above the part with the faces of it."""
    mesh.ViewObject.Visibility = False
    dialog = compare(part, path)
    dialog.setGeometry(140, 470, 1090, 280)
    rows = dialog.findChild(QtGui.QTreeWidget)
    row, = rows.findItems("Holes", QtCore.Qt.MatchExactly)
    rows.setCurrentItem(row)
    row.setExpanded(True)
    for column, width in enumerate((130, 150, 420, 110, 110, 110)):
        rows.setColumnWidth(column, width)
    rows.scrollToItem(row, QtGui.QAbstractItemView.PositionAtCenter)
    save("difference_table", (0, 100, 1280, 660))
    dialog.close()


window.run(draw)

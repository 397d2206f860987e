# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the user's guide's pictures anew, with the bracket of the examples:

    FEATUREMESH_PICTURES=docs/pictures /usr/bin/python3 tests/python/test_window.py draw_guide.py

drive_first_use.py draws those of first_use. kept.jpg, in the README, is pictures/kept.png of `./featuremesh demo`.
"""
import base64
import os
import re
import shutil
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import Part  # noqa: E402
import window  # noqa: E402
from parts import new_document, plate_with_hole  # noqa: E402
from PySide import QtCore, QtGui  # noqa: E402
from window import click, panel, spin, wait_for  # noqa: E402

VIEW = (290, 130, 980, 610)   # the 3D view on the screen, (x, y, width, height)
BRACKET = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "resources", "examples", "bracket.FCStd")


def hide_reports():
    """Closes what FreeCAD opens below the view for a warning."""
    for dock in Gui.getMainWindow().findChildren(QtGui.QDockWidget):
        if dock.objectName() in ("Report view", "Python console"):
            dock.hide()
    spin()


def fit_view():
    hide_reports()
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")


def save(name, box=None, width=1000):
    """Saves what the screen shows, or a part (x, y, width, height) of it, at that width."""
    hide_reports()
    spin(1)
    shot = QtGui.QGuiApplication.primaryScreen().grabWindow(0)
    write(name, shot.copy(*box) if box else shot, width)


def write(name, picture, width):
    """Writes a picture for the guide, of that width."""
    picture.scaledToWidth(width, QtCore.Qt.SmoothTransformation).save(os.path.join(window.PICTURES, name + ".jpg"), "JPG", 85)


def opened_bracket(folder):
    """A copy of the bracket in the window, seen from the corner whose hole will move."""
    path = os.path.join(folder, "bracket.FCStd")
    shutil.copy(BRACKET, path)
    document = FreeCAD.openDocument(path)
    document.UndoMode = 1
    for obj in document.Objects:
        if obj.isDerivedFrom("Fem::Constraint"):
            obj.ViewObject.Visibility = False
    fit_view()
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
    window.choose_workbench(height=770)
    folder = os.path.dirname(os.environ["FEATUREMESH_RESULT"])
    document, path = opened_bracket(folder)
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
    move_hole(document, "105 mm")
    Gui.runCommand("FeatureMesh_ShowKept")
    spin()
    save("kept_panel")
    panel("KeptPanel").reject()
    spin()
    draw_live(document, mesh)
    draw_difference(versions.part_of(mesh), mesh, compare.Command().show, path)
    draw_menu(Gui.getMainWindow())
    FreeCAD.closeDocument(document.Name)
    draw_difference_picture(folder)
    draw_local_size(folder)
    draw_adopted(folder)
    draw_preferences()
    draw_shells()
    draw_zone()
    draw_study(folder)


def draw_difference_picture(folder):
    """Both states of the bracket, as `./featuremesh diff --picture` draws them."""
    from freecad.featuremesh import api
    before = FreeCAD.openDocument(shutil.copy(BRACKET, os.path.join(folder, "before.FCStd")))
    after, _ = opened_bracket(folder)
    move_hole(after, "105 mm")
    parts = api.find_part(before), api.find_part(after)
    path = os.path.join(folder, "difference.png")
    api.draw_difference(*parts, api.difference(*parts), path)
    write("difference", QtGui.QImage(path), 1400)
    for document in (before, after):
        FreeCAD.closeDocument(document.Name)


def draw_local_size(folder):
    """The bracket with a finer bore."""
    from freecad.featuremesh import api
    document, _ = opened_bracket(folder)
    mesh = api.add_mesh(api.find_part(document), 6)
    bore = document.getObject("Bore")
    radius = document.getObject("BoreSketch").Geometry[0].Radius
    names = ["Face%d" % (index + 1) for index, face in enumerate(bore.Shape.Faces)
             if isinstance(face.Surface, Part.Cylinder) and abs(face.Surface.Radius - radius) < 1e-6]
    api.add_local_size(mesh, [(bore, name) for name in names], 1.5)
    document.recompute()
    save("local_size", VIEW)
    FreeCAD.closeDocument(document.Name)


def draw_adopted(folder):
    """A mesh that FreeCAD's Gmsh object made, adopted, and what an edit kept of it."""
    import ObjectsFem
    from femmesh.gmshtools import GmshTools
    from freecad.featuremesh import api
    document, _ = opened_bracket(folder)
    part = api.find_part(document)
    foreign = ObjectsFem.makeMeshGmsh(document, "FEMMeshGmsh")
    setattr(foreign, "Shape" if hasattr(foreign, "Shape") else "Part", part)
    foreign.CharacteristicLengthMax = 5
    GmshTools(foreign).create_mesh()
    mesh, _ = api.adopt_mesh(foreign, part)
    foreign.ViewObject.Visibility = part.ViewObject.Visibility = False
    move_hole(document, "105 mm")
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(mesh)
    Gui.runCommand("FeatureMesh_ShowKept")
    save("adopted")
    panel("KeptPanel").reject()
    FreeCAD.closeDocument(document.Name)


def draw_preferences():
    """Our page of FreeCAD's preferences."""
    def draw_and_close():
        dialog = QtGui.QApplication.activeModalWidget()
        place = dialog.frameGeometry()
        save("preferences", (place.x(), place.y(), place.width(), place.height()))
        dialog.reject()
    QtCore.QTimer.singleShot(2000, draw_and_close)
    Gui.showPreferences("FeatureMesh", 0)


def move_hole(document, x):
    document.getObject("HoleSketch").setDatum("Hole6X", FreeCAD.Units.Quantity(x))
    document.recompute()
    spin()


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
    fit_view()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(mesh)
    Gui.runCommand("FeatureMesh_ShowKept")
    save("shells")
    panel("KeptPanel").reject()


def draw_zone():
    """A sphere in the panel, and the mesh that is finer in it."""
    from freecad.featuremesh import api
    document = new_document("Zone")
    body = plate_with_hole(document)
    mesh = api.add_mesh(body, 4)
    document.recompute()
    fit_view()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(mesh)
    Gui.runCommand("FeatureMesh_AddSizeZone")
    spin()
    settings = panel("ZonePanel")
    settings.kind.setCurrentIndex(1)
    for widget, value in ((settings.place[0], 45), (settings.place[1], 20), (settings.place[2], 10),
                          (settings.lengths["Radius"], 12), (settings.lengths["InnerSize"], 1)):
        widget.setProperty("rawValue", value)
    spin(1)
    before = QtGui.QGuiApplication.primaryScreen().grabWindow(0)
    settings.accept()
    spin(1)
    after = QtGui.QGuiApplication.primaryScreen().grabWindow(0).copy(*VIEW)
    both = QtGui.QPixmap(VIEW[0] + 2 * VIEW[2], VIEW[3])
    painter = QtGui.QPainter(both)
    painter.drawPixmap(0, 0, before.copy(0, VIEW[1], VIEW[0] + VIEW[2], VIEW[3]))
    painter.drawPixmap(VIEW[0] + VIEW[2], 0, after)
    painter.end()
    write("zone", both, 1200)
    FreeCAD.closeDocument(document.Name)


def draw_study(folder):
    """The panel while a study runs, the lines of its cases, and these in its report."""
    from freecad.featuremesh.gui import study_runs
    document, _ = opened_bracket(folder)
    Gui.Selection.clearSelection()
    Gui.runCommand("FeatureMesh_Study")
    spin()
    shown = panel("StudyPanel")
    for target in ("Boss.Length", "Fillet.Radius"):
        shown.dimensions.item_of(target).setCheckState(0, QtCore.Qt.Checked)
    window.click(shown.run_button)
    wait_for(lambda: shown.bar.maximum() == 16 and shown.bar.value() > 1, 600)
    save("study_panel")
    wait_for(lambda: not study_runs.run_of(shown.study).is_running(), 900)
    results = shown.show_results()
    results.tabs.setCurrentIndex(1)
    wait_for(lambda: results.plots[1].canvas is not None)
    results.table.selectRow(4)
    spin(1)
    place = results.geometry()
    save("study_results", (place.x(), place.y(), place.width(), place.height()), place.width())
    results.close()
    draw_study_report(shown.study.Folder, os.path.join(folder, "report.html"))
    shown.reject()
    FreeCAD.closeDocument(document.Name)


def draw_study_report(of_study, page):
    """The picture of all cases in a study's report."""
    from freecad.featuremesh.study import report
    from freecad.featuremesh.study.folder import StudyFolder
    study = StudyFolder(of_study)
    report.write(study, page)
    study.database.close()
    with open(page, encoding="utf-8") as stream:
        drawn, = re.findall('alt="All cases at once" src="data:image/png;base64,([^"]*)"', stream.read())
    picture = QtGui.QImage.fromData(base64.b64decode(drawn))
    write("study", picture, picture.width())


def draw_live(document, mesh):
    """The live result before an edit, what the edit changed, and the mesh that is refined where the result is off."""
    from freecad.featuremesh import live_result
    Gui.runCommand("FeatureMesh_LiveResult")
    spin()
    shown = panel("LivePanel")
    wait_for(lambda: shown.live.Status == live_result.UP_TO_DATE)
    save("live_result")
    move_hole(document, "102 mm")
    wait_for(lambda: shown.live.Status == live_result.UP_TO_DATE)
    shown.difference.setChecked(True)
    save("live_change")
    shown.difference.setChecked(False)
    click(shown.finer)
    wait_for(lambda: mesh.MeshRegionList and shown.live.Status == live_result.UP_TO_DATE)
    shown.live.ViewObject.Visibility, mesh.ViewObject.Visibility = False, True
    save("refined")
    shown.reject()
    document.removeObject(mesh.MeshRegionList[0].Name)
    document.recompute()


def draw_difference(part, mesh, compare, path):
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

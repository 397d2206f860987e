# SPDX-License-Identifier: GPL-3.0-or-later
"""Drives FreeCAD's real window: mesh, cancel, edit, undo, copy, overlays, tables, errors, icons. Run by test_window.py.

Writes what went wrong to the file FEATUREMESH_RESULT ("ok" when nothing did), and pictures to the folder FEATUREMESH_PICTURES
when that is set.
"""
import importlib
import os
import signal
import sys
import tempfile
import time
from pathlib import Path
from unittest import mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import window  # noqa: E402
from PySide import QtCore, QtGui  # noqa: E402
from window import (PICTURES, answer_with, click_in_panel, figures, is_shown, messages, open_dialog, panel, picture, report_view,  # noqa: E402
                    spin, texts_of, wait_for)


def run_as_one_step(document, command):
    """Runs a command of ours; exactly one step of undo, with its name, is its."""
    from freecad.featuremesh.commands import COMMANDS
    title = importlib.import_module("freecad.featuremesh.commands." + COMMANDS[command]).Command().title
    count = document.UndoCount
    Gui.runCommand(command)
    spin()
    assert document.UndoCount == count + 1 and document.UndoNames[0] == title, (command, count, document.UndoNames[:3])


def run_and_accept(command):
    """Runs one of FreeCAD's commands and accepts what it asks."""
    def accept():
        dialog = QtGui.QApplication.activeModalWidget()
        if isinstance(dialog, QtGui.QMessageBox):
            dialog.button(QtGui.QMessageBox.Yes if dialog.button(QtGui.QMessageBox.Yes) else QtGui.QMessageBox.Ok).click()
        elif dialog is not None:
            dialog.accept()
    timer = QtCore.QTimer()
    timer.timeout.connect(accept)
    timer.start(100)
    Gui.runCommand(command)
    spin(0.5)
    timer.stop()


def wait_for_step(running, step):
    """Waits, without the event loop, until the job is at that step or after it; on a fast machine a step is short."""
    from freecad.featuremesh.gui.running import STEPS
    steps = list(STEPS)
    while steps.index(running.step) < steps.index(step):
        assert not running.is_done(0.001), "done before it came to " + step


def points_of(mesh):
    return {number: tuple(point) for number, point in mesh.FemMesh.Nodes.items()}


def check_escape(document, mesh):
    """Escape ends the update within a recompute; the mesh is as it was and says that it is out of date."""
    from freecad.featuremesh import mesh_object
    before, size = points_of(mesh), mesh.Size.Value
    said = []

    def press():
        message = Gui.getMainWindow().statusBar().currentMessage()
        if "Escape" in message and not said:   # a second one would be FreeCAD's own, which asks back
            said.append(message)
            QtGui.QApplication.postEvent(Gui.getMainWindow(), QtGui.QKeyEvent(QtCore.QEvent.KeyPress, QtCore.Qt.Key_Escape, QtCore.Qt.NoModifier))
    timer = QtCore.QTimer()
    timer.timeout.connect(press)
    timer.start(50)
    mesh.Size = 0.7
    document.recompute()
    timer.stop()
    assert mesh.Status == mesh_object.CANCELLED and points_of(mesh) == before, (mesh.Status, said)
    mesh.Size = size
    document.recompute()
    assert mesh.Status == mesh_object.UP_TO_DATE, mesh.Status


def check_errors(body):
    """An error shows its message and selects the faces it is about, if the part has them; a cancel shows nothing."""
    from freecad.featuremesh import worker
    from freecad.featuremesh.errors import StateError
    from freecad.featuremesh.gui import errors
    from freecad.featuremesh.messages import said
    errors.show(StateError(said("{faces:entities} cross", faces=["Face2", "Face4711"])), body)
    assert messages[-1] == "Face2, Face4711 cross"
    selected, = Gui.Selection.getSelectionEx()
    assert (selected.Object, selected.SubElementNames) == (body, ("Face2",)), selected.SubElementNames
    count = len(messages)
    errors.show(worker.Cancelled("cancelled"), body)
    assert len(messages) == count
    Gui.Selection.clearSelection()


def check_preferences(api, engine, document, body):
    """What is set on the page of the preferences is obeyed by the next mesh."""
    from freecad.featuremesh import overlays, preferences
    from freecad.featuremesh.gui.preferences_page import PreferencesPage
    page = PreferencesPage()
    page.loadSettings()
    assert page.in_worker.isChecked() and page.elements.value() == 30
    page.form.show()
    picture("preferences")
    page.elements.setValue(10)
    page.order.setCurrentIndex(1)
    page.automatic.setChecked(False)
    page.threads.setValue(1)
    page.in_worker.setChecked(False)
    page.colours["NewColour"].setProperty("color", QtGui.QColor(0, 255, 0))
    page.saveSettings()
    page.form.close()
    assert not engine.runs_in_worker() and overlays.kept_legend()[1] == (0.0, 1.0, 0.0)
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(body)
    asked = answer_with("Add another mesh", [])
    Gui.runCommand("FeatureMesh_MeshPart")
    spin()
    assert not asked.isActive()
    mesh = api.meshes_of(document)[-1]
    assert (mesh.Size.Value, mesh.Order, mesh.Automatic, mesh.Threads) == (api.default_size(body, 10), "2nd", False, 1)
    click_in_panel("Cancel")
    fields = [field for field in page.form.findChildren(QtGui.QWidget) if field.property("prefEntry")]   # which FreeCAD's Reset looks for
    for field in fields:
        group = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/" + field.property("prefPath"))
        for kind, name, _ in group.GetContents():
            if name == field.property("prefEntry"):
                {"Boolean": group.RemBool, "Integer": group.RemInt, "Unsigned Long": group.RemUnsigned}[kind](name)
    page.loadSettings()
    assert (page.elements.value(), page.threads.value(), page.automatic.isChecked(), page.in_worker.isChecked()) == (30, 0, True, True)
    assert overlays.kept_legend()[1] == preferences.colour("NewColour") != (0.0, 1.0, 0.0)
    FreeCAD.ParamGet(preferences.GROUP).Clear()
    assert mesh not in document.Objects
    Gui.Selection.clearSelection()


def check_copy_and_deletion(api, document, body, mesh):
    """Copy and paste give a mesh of its own; a deleted mesh comes back by undo; a label is only that."""
    before = points_of(mesh)
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(mesh)
    run_and_accept("Std_Copy")
    run_and_accept("Std_Paste")
    copies = [other for other in api.meshes_of(document) if other is not mesh]
    assert len(copies) == 1 and points_of(copies[0]) == before, [other.Name for other in copies]
    Gui.Selection.clearSelection()
    Gui.runCommand("FeatureMesh_UpdateNow")
    assert "several meshes, select one" in messages[-1] and not document.HasPendingTransaction, messages
    pasted = [obj for obj in document.Objects if obj not in (mesh, copies[0]) and obj.Name.startswith(body.Name) and obj is not body]
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(copies[0])
    run_and_accept("Std_Delete")
    assert api.meshes_of(document) == [mesh]
    for obj in pasted:
        obj.removeObjectsFromDocument()
        document.removeObject(obj.Name)
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(mesh)
    run_and_accept("Std_Delete")
    assert not api.meshes_of(document)
    document.undo()
    mesh, = api.meshes_of(document)
    assert points_of(mesh) == before
    mesh.Label = "Netz der Platte"
    Gui.Selection.clearSelection()
    run_as_one_step(document, "FeatureMesh_UpdateNow")
    assert points_of(mesh) == before
    return mesh


def check_tables_close(compare, saved):
    """With the part, or the document, whose faces they would select; the document to compare with is looked for beside the part's."""
    active = FreeCAD.ActiveDocument
    said = report_view()
    for close in (lambda other: FreeCAD.closeDocument(other.Name), lambda other: other.removeObject("Body")):
        other = FreeCAD.openDocument(saved)
        name = other.Name
        other.HoleSketch.setDatum("X", FreeCAD.Units.Quantity("28 mm"))
        other.recompute()
        asked = []
        with mock.patch.object(QtGui.QFileDialog, "getOpenFileName", lambda parent, title, folder, kinds: asked.append(folder) or ("", "")):
            compare.Command().run(other)
        assert asked == [os.path.dirname(saved)], (asked, saved)
        dialog = compare.Command().show(other.Body, saved)
        assert is_shown(dialog)
        rows = dialog.findChild(QtGui.QTreeWidget)
        rows.setCurrentItem(rows.findItems("Hole", QtCore.Qt.MatchExactly)[0])   # which shows the part
        assert Gui.Selection.getSelectionEx()[0].SubElementNames
        close(other)
        spin()
        assert not is_shown(dialog) and "Traceback" not in report_view()[len(said):], report_view()
        if name in FreeCAD.listDocuments():
            FreeCAD.closeDocument(name)
    FreeCAD.setActiveDocument(active.Name)
    spin()


def check_names_of_files():
    """The format is that of the filter unless the name says one; a dot in the name does not. What was written, and where, is said without a box."""
    with tempfile.TemporaryDirectory() as folder:
        for name, kind, written in (("1.5 mm", "NASTRAN (*.bdf)", "1.5 mm.bdf"), ("plate.INP", "VTK (*.vtu)", "plate.INP"), ("plate", "Surface (*.stl)", "plate.stl"),
                                    ("proposed.vtu", "UNV (*.unv)", "proposed.unv")):
            with mock.patch.object(QtGui.QFileDialog, "getSaveFileName", return_value=(os.path.join(folder, name), kind)):
                Gui.runCommand("FeatureMesh_Export")
            assert os.listdir(folder) == [written], (name, os.listdir(folder), messages)
            path = os.path.join(folder, written)
            in_status_bar = Gui.getMainWindow().statusBar().currentMessage()
            spin()   # the report view shows it in a later turn
            for said in (in_status_bar, report_view()):
                assert " was written to %s (" % path in said, (path, said)
            os.unlink(path)
        check_what_is_replaced(folder)


def check_what_is_replaced(folder):
    """Qt has asked for the name as it was typed; a file of the name with its ending is there, and stays unless it is to go."""
    path = os.path.join(folder, "plate.stl")
    for answer, is_kept in (("No", True), ("Yes", False)):
        Path(path).write_text("mine", encoding="utf-8")
        asked = []
        timer = answer_with(answer, asked)
        with mock.patch.object(QtGui.QFileDialog, "getSaveFileName", return_value=(os.path.join(folder, "plate"), "Surface (*.stl)")):
            Gui.runCommand("FeatureMesh_Export")
        assert asked == ["%s is there already. Replace it?" % path] and not timer.isActive(), asked
        assert (Path(path).read_bytes() == b"mine") == is_kept, answer


def check_icons():
    """Every icon can be told from a light and from a dark background at 16 pixels."""
    from freecad.featuremesh.view_provider import ICONS, drawn_icon
    names = sorted(name[:-len(".svg")] for name in os.listdir(ICONS))
    sheet = QtGui.QWidget()
    layout = QtGui.QGridLayout(sheet)
    for row, background in enumerate(("#f0f0f0", "#2b2b2b")):
        for column, name in enumerate(names):
            image = QtGui.QImage(16, 16, QtGui.QImage.Format_RGB32)
            image.fill(QtGui.QColor(background))
            painter = QtGui.QPainter(image)
            painter.drawPixmap(0, 0, drawn_icon(name).pixmap(16, 16))
            painter.end()
            seen = sum(contrast(image.pixel(x, y), QtGui.QColor(background).rgb()) > 2 for x in range(16) for y in range(16))
            assert seen > 30, "%s on %s: %d of 256 pixels stand out" % (name, background, seen)
            for index, size in enumerate((16, 48)):
                label = QtGui.QLabel()
                label.setPixmap(QtGui.QPixmap.fromImage(image.scaled(size, size)))
                label.setToolTip(name)
                layout.addWidget(label, 2 * row + index, column)
    sheet.show()
    picture("icons")
    sheet.close()


def contrast(first, second):
    """The ratio of luminances, as for texts on web pages; 1: none."""
    def luminance(rgb):
        parts = [channel / 255 for channel in QtGui.QColor(rgb).getRgb()[:3]]
        return sum(weight * (part / 12.92 if part <= 0.03928 else ((part + 0.055) / 1.055) ** 2.4)
                   for weight, part in zip((0.2126, 0.7152, 0.0722), parts))
    light, dark = sorted((luminance(first), luminance(second)), reverse=True)
    return (light + 0.05) / (dark + 0.05)


def check_overlay(kind, shown, mesh):
    """What a panel says is true of the mesh."""
    from freecad.featuremesh import overlays
    if kind == "KeptPanel":
        legend = [label.text() for label in shown.form.findChildren(QtGui.QLabel) if label.text()]
        assert len(legend) == 3 and legend[0].startswith("kept: ") and "(%d." % mesh.KeptTets in legend[0], legend
    else:
        assert sum(shown.form.findChild(QtGui.QWidget, "histogram").counts) == mesh.TetCount
        number, angle = overlays.worst_tets(mesh, 1)[0]
        assert shown.worst.item(0).text() == "%d:  %.2f deg" % (number, angle) and abs(angle - mesh.MinDihedral.Value) < 1e-6
        shown.worst.setCurrentRow(0)
        spin()
        picture("worst")


def drive():
    from freecad.featuremesh import api, engine, mesh_object
    from freecad.featuremesh.commands import COMMANDS, compare
    from parts import plate_with_hole
    main = Gui.getMainWindow()
    main.setGeometry(0, 0, 1280, 800)
    assert set(COMMANDS) <= set(Gui.listCommands())
    Gui.activateWorkbench("FeatureMeshWorkbench")
    spin()
    picture("welcome")
    open_dialog().close()
    assert engine.runs_in_worker()
    document = FreeCAD.newDocument("Window")
    document.UndoMode = 1
    body = plate_with_hole(document)
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")

    # Mesh from the panel
    Gui.runCommand("FeatureMesh_MeshPart")
    spin()
    mesh, = api.meshes_of(document)
    settings = panel("MeshPanel")
    settings.size.setProperty("rawValue", 2.5)
    wait_for(lambda: "elements" in settings.estimate.text())
    picture("panel")
    settings.start(False)
    assert settings.working.isVisible() and not settings.full_button.isEnabled()
    wait_for(lambda: settings.running is None)
    assert mesh.Status == mesh_object.UP_TO_DATE, mesh.Status
    assert mesh.Size.Value == 2.5 and mesh.TetCount == mesh.FemMesh.VolumeCount > 1000
    assert mesh.ViewObject.Visibility and not body.ViewObject.Visibility
    picture("meshed")

    # Cancel leaves everything as it was
    if PICTURES:
        settings.start(True)
        wait_for(lambda: settings.running is None or settings.running.step in ("volume", "optimise"))
        picture("running")
        wait_for(lambda: settings.running is None)
    before = points_of(mesh)
    settings.size.setProperty("rawValue", 0.9)   # so that each step lasts
    for step in ("", "surface", "volume"):
        settings.start(True)
        wait_for_step(settings.running, step)
        start = time.monotonic()
        settings.stop_button.click()
        wait_for(lambda: settings.running is None)
        figures.append("cancel at step '%s': %.2f s" % (step, time.monotonic() - start))
        assert points_of(mesh) == before and "Cancelled" in settings.result.text(), settings.result.text()
    settings.size.setProperty("rawValue", 2.5)

    # A crash of the engine's process costs the work it was at
    settings.start(True)
    wait_for_step(settings.running, "read")
    os.kill(engine.load().process_id, signal.SIGSEGV)
    wait_for(lambda: settings.running is None)
    assert "SIGSEGV" in settings.status.text() and points_of(mesh) == before, settings.status.text()
    picture("crash")
    settings.start(False)
    wait_for(lambda: settings.running is None)
    assert mesh.Status == mesh_object.UP_TO_DATE, mesh.Status
    settings.reject()
    spin()
    assert not Gui.Control.activeDialog()

    # An edit is followed; undo and redo bring the meshes back
    document.openTransaction("Move the hole")
    document.getObject("HoleSketch").setDatum("X", FreeCAD.Units.Quantity("25 mm"))
    document.recompute()
    document.commitTransaction()
    after = points_of(mesh)
    assert mesh.Status == mesh_object.UP_TO_DATE and mesh.KeptNodes > 30 and after != before
    document.undo()
    assert points_of(mesh) == before
    document.redo()
    assert points_of(mesh) == after

    check_escape(document, mesh)

    # Overlays
    document.getObject("HoleSketch").setDatum("X", FreeCAD.Units.Quantity("26 mm"))
    document.recompute()
    for command, kind, name in (("FeatureMesh_ShowKept", "KeptPanel", "kept"),
                                ("FeatureMesh_ShowQuality", "QualityPanel", "quality")):
        Gui.runCommand(command)
        spin()
        shown = panel(kind)
        picture(name)
        check_overlay(kind, shown, mesh)
        shown.reject()
        spin()

    # Tables
    Gui.runCommand("FeatureMesh_ShowTree")
    spin()
    dialog = open_dialog()
    picture("tree")
    assert dialog.findChild(QtGui.QTreeWidget).topLevelItemCount() >= 4
    dialog.close()
    saved = os.environ["FEATUREMESH_RESULT"] + ".FCStd"
    document.saveCopy(saved)
    document.getObject("HoleSketch").setDatum("X", FreeCAD.Units.Quantity("28 mm"))
    document.recompute()
    dialog = compare.Command().show(body, saved)
    rows = dialog.findChild(QtGui.QTreeWidget)
    verdicts = {rows.topLevelItem(i).text(0): rows.topLevelItem(i).text(1) for i in range(rows.topLevelItemCount())}
    assert verdicts["Hole"] == "moved", verdicts
    rows.setCurrentItem(rows.findItems("Hole", QtCore.Qt.MatchExactly)[0])
    spin()
    picture("difference")
    assert Gui.Selection.getSelectionEx()[0].SubElementNames
    assert body.ViewObject.Visibility and not mesh.ViewObject.Visibility
    dialog.close()
    assert mesh.ViewObject.Visibility and not body.ViewObject.Visibility
    Gui.Selection.clearSelection()

    check_tables_close(compare, saved)

    # A local size on a selected face; for a whole part a message
    Gui.Selection.addSelection(body)
    Gui.runCommand("FeatureMesh_AddLocalSize")
    spin()
    assert messages and "is for faces, edges or vertices" in messages[-1], messages
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(body, "Face1")
    run_as_one_step(document, "FeatureMesh_AddLocalSize")
    Gui.Control.closeDialog()
    Gui.activeDocument().resetEdit()
    assert mesh.MeshRegionList[0].References == [(body, ("Face1",))]
    few = mesh.NodeCount
    document.recompute()
    assert mesh.NodeCount > few and mesh.Status == mesh_object.UP_TO_DATE, mesh.Status

    mesh = check_copy_and_deletion(api, document, body, mesh)
    check_icons()

    # What fails says so and leaves the mesh
    count = mesh.TetCount
    mesh.Size = 0
    document.recompute()
    assert mesh.Status.startswith("failed") and mesh.FemMesh.VolumeCount == count
    picture("failed")

    check_errors(body)
    check_names_of_files()
    check_preferences(api, engine, document, body)

    # In FreeCAD's FEM workbench
    Gui.activateWorkbench("FemWorkbench")
    spin()
    texts = [action.text() for action in main.findChild(QtGui.QToolBar, "Mesh").actions()]
    assert {"Mesh a part", "Show the quality", "Export the mesh"} <= set(texts), texts
    menus = [texts_of(action) for action in main.menuBar().actions()]
    assert any(len(menu) > len(COMMANDS) and "Show the quality" in menu for menu in menus), menus[6:]
    picture("fem")
    mesh = check_adoption(api, document, body, mesh)
    check_german(main, document, mesh)


def check_adoption(api, document, body, mesh):
    """A foreign mesh becomes ours by one command, as is preferred, and one undo takes that back."""
    from freecad.featuremesh import preferences
    mesh.Size = 2.5
    document.recompute()
    foreign = document.addObject("Fem::FemMeshObject", "Foreign")
    foreign.FemMesh = mesh.FemMesh
    before = points_of(mesh)
    document.removeObject(mesh.Name)
    preferences.put("Automatic", False)
    preferences.put("Threads", 1)
    run_as_one_step(document, "FeatureMesh_Adopt")
    FreeCAD.ParamGet(preferences.GROUP).Clear()
    adopted, = api.meshes_of(document)
    assert (adopted.Automatic, adopted.Threads, adopted.Status) == (False, 1, "up to date"), adopted.Status
    adopted.Automatic = True
    shared = len(points_of(adopted).items() & points_of(foreign).items())
    assert shared > 0.9 * len(before), (shared, len(before), messages[-1])
    assert adopted.ViewObject.Visibility and not foreign.ViewObject.Visibility
    document.undo()
    assert not api.meshes_of(document)
    document.redo()
    adopted, = api.meshes_of(document)
    return adopted


def check_half_saved(document):
    """That the end of a document did not arrive on the disk is told, and FreeCAD asks before it is closed."""
    from freecad.featuremesh import disk_room
    with tempfile.TemporaryDirectory() as folder, mock.patch.object(disk_room.zipfile, "is_zipfile", lambda path: False):
        document.saveAs(os.path.join(folder, "half.FCStd"))
        Gui.SendMsgToActiveView("Save")
        wait_for(lambda: "was not saved as a whole" in messages[-1], 10)
        spin()
    assert Gui.getDocument(document.Name).Modified


def check_german(main, document, mesh):
    """The window speaks the user's language as soon as it is chosen."""
    check_half_saved(document)
    from freecad.featuremesh import mesh_object
    from freecad.featuremesh.gui import welcome
    Gui.setLocale("de")
    spin()
    assert mesh_object.status_in_words(mesh) == "aktuell", mesh.Status
    mesh.Growth = 0.5
    mesh.Document.recompute()
    assert mesh.Status == "failed: The growth rate is 0.5; it must be at least 1 (1.3 is usual).", mesh.Status
    assert mesh_object.status_in_words(mesh) == "fehlgeschlagen: Das Wachstum ist 0.5; es muss mindestens 1 sein (üblich ist 1.3)."
    mesh.Growth = 1.3
    mesh.Document.recompute()
    texts = [action.text() for action in main.findChild(QtGui.QToolBar, "Mesh").actions()]
    assert "Bauteil vernetzen" in texts, texts
    Gui.activateWorkbench("FeatureMeshWorkbench")
    Gui.activeDocument().setEdit(mesh.Name)
    spin()
    wait_for(lambda: "Elemente" in panel("MeshPanel").estimate.text() or not mesh.Size.Value)
    dialog = welcome.show()
    picture("german")
    dialog.close()
    check_closing_in_the_middle(document)


def check_closing_in_the_middle(document):
    """Closing the document ends the work on it."""
    settings = panel("MeshPanel")
    settings.size.setProperty("rawValue", 0.8)
    settings.start(True)
    running = settings.running
    wait_for(lambda: running.step)
    FreeCAD.closeDocument(document.Name)
    wait_for(running.is_done)
    assert type(running.error).__name__ == "Cancelled", running.error


window.run(drive)

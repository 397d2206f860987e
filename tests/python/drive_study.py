# SPDX-License-Identifier: GPL-3.0-or-later
"""A study by hand, from the bracket to its plots: ticks, ranges, Run, rows that open a case, Stop, Go on. Run by test_window.py with the bracket."""
import hashlib
import os
import re
import shutil
import sys
import tempfile
from pathlib import Path
from unittest import mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import window  # noqa: E402
from PySide import QtCore, QtGui  # noqa: E402
from window import (click, click_button_of, click_in_panel, click_in_view, double_click, figures, is_whole, panel, picture, report_view,  # noqa: E402
                    press_at, send_key, spin, tick, wait_for)

LONG = 900   # s, for what a busy machine does in its own time


def type_range(shown, item, text):
    """A double click on the range, the text, Enter."""
    shown.dimensions.scrollToItem(item)
    spin()
    box = shown.dimensions.visualItemRect(item)
    x = shown.dimensions.columnViewportPosition(1) + shown.dimensions.columnWidth(1) // 2
    double_click(shown.dimensions.viewport(), QtCore.QPoint(x, box.center().y()))
    editor, = [widget for widget in shown.dimensions.viewport().findChildren(QtGui.QLineEdit) if widget.isVisible()]
    send_key(editor, QtCore.Qt.Key_A, QtCore.Qt.ControlModifier)
    for letter in text:
        send_key(editor, 0, QtCore.Qt.NoModifier, letter)
    send_key(editor, QtCore.Qt.Key_Return)
    spin()


def study_window():
    found, = [widget for widget in QtGui.QApplication.topLevelWidgets() if type(widget).__name__ == "StudyWindow" and widget.isVisible()]
    return found


def cases_of(study):
    from freecad.featuremesh.study.folder import StudyFolder
    folder = StudyFolder(study.Folder)
    found = folder.database.cases()
    folder.database.close()
    return found


def has_ended(study):
    from freecad.featuremesh.gui import study_runs
    return not study_runs.run_of(study).is_running()


def check_width(shown, column):
    """FreeCAD's dock as it is at first has room for the panel, and one column of the dimensions for its texts; the other has tool tips."""
    assert is_whole(shown.form), shown.form.width()
    assert shown.dimensions.sizeHintForColumn(column) <= shown.dimensions.columnWidth(column), (column, shown.dimensions.columnWidth(column))


def check_only_looked_at(document):
    """A new study that nothing was chosen in is gone when its panel is closed, whatever else was done meanwhile; one with a tick stays."""
    before = [obj.Name for obj in document.Objects]
    for label, ticked in (("", False), ("Tip", False), ("", True)):
        click_button_of("FeatureMesh_Study")
        shown = panel("StudyPanel")
        assert not document.HasPendingTransaction   # what is edited meanwhile is a step of its own
        if label:
            document.openTransaction("Label")
            document.Fillet.Label = label
            document.commitTransaction()
        if ticked:
            tick(shown, "Boss.Length")
        steps = list(document.UndoNames)
        click_in_panel("Close")
        spin()
        assert not Gui.Control.activeDialog()
        left = [obj.Name for obj in document.Objects if obj.Name not in before]
        assert left == (["Study"] if ticked else []), (label, ticked, left)
        assert ticked or len(document.UndoNames) == len(steps) + (1 if label else -1), (steps, document.UndoNames)
    document.removeObject("Study")
    document.Fillet.Label = "Fillet"
    document.clearUndos()


def check_saving_is_told(shown):
    """By a click on *Run*; the window draws nothing more until the copy is saved."""
    from freecad.featuremesh import documents
    save, told = documents.save_document, []

    def look(*words):
        told.append((shown.status.text(), QtGui.QApplication.overrideCursor() is not None))
        save(*words)
    with mock.patch.object(documents, "save_document", look):
        click(shown.run_button)
    assert told == [("saving a copy of the document, from which all cases start", True)] and QtGui.QApplication.overrideCursor() is None, told


def check_five_clicks(document):
    """From the bracket to a plot: the command, two dimensions, Run, Results."""
    before = hashlib.sha256(Path(document.FileName).read_bytes()).hexdigest()
    clicks = 0
    click_button_of("FeatureMesh_Study")
    shown, clicks = panel("StudyPanel"), clicks + 1
    study = shown.study
    assert study.Analysis is document.Analysis and study.Part.TypeId == "PartDesign::Body", (study.Analysis, study.Part)
    assert shown.status.text() == "not run yet" and not shown.results_button.isEnabled() and not shown.bar.isVisible()
    check_width(shown, 0)
    for button in (shown.run_button, shown.results_button):
        assert button.visibleRegion().boundingRect().size() == button.size(), button.text()   # without scrolling
        assert button.mapTo(shown.form, QtCore.QPoint(0, 0)).y() < shown.dimensions.y()
    for target in ("Boss.Length", "Fillet.Radius"):
        item = tick(shown, target)
        clicks += 1
        assert ":" in item.text(1)
    assert list(study.Parameters) == ["Boss.Length=27.0:33.0", "Fillet.Radius=2.7:3.3"], study.Parameters
    assert list(study.Responses) == ["mass", "max_mises", "max_displacement"]
    picture("study_panel")
    check_width(shown, 1)
    check_saving_is_told(shown)
    clicks += 1
    wait_for(lambda: shown.bar.isVisible() and shown.bar.maximum() == 16 and shown.bar.value() > 0, LONG)
    assert shown.run_button.text() == "Stop" and "of 16 cases done" in shown.status.text(), shown.status.text()
    picture("study_running")
    left = set()
    wait_for(lambda: left.add(shown.status.text().rpartition(", ")[2]) or has_ended(study), LONG)
    assert not any("about 0 " in words for words in left) and left & {"nearly done", "about 1 s left", "about 2 s left"}, left
    shown.refresh()
    assert shown.status.text().startswith("16 of 16 cases done"), shown.status.text()
    click(shown.results_button)
    clicks += 1
    results = study_window()
    wait_for(lambda: results.plots[0].canvas is not None)
    assert clicks == 5
    results._seen = None   # as where a case more is done: drawing takes long, after which the window rests
    results.refresh()
    wait_for(lambda: results._timer.interval() > 1000)
    picture("study_scatter")
    assert hashlib.sha256(Path(document.FileName).read_bytes()).hexdigest() == before
    return shown, study, results


def check_plots(study, results):
    """All cases are in each plot; a click on a point marks its row."""
    done = [case for case in cases_of(study) if case.state == "done"]
    assert len(done) == 16, [(case.state, case.message) for case in cases_of(study)]
    scatter = results.plots[0].canvas
    axes = scatter.figure.axes
    assert len(axes) == 2 * 3 and all(len(plot.collections[0].get_offsets()) == len(done) for plot in axes)
    scatter.draw()
    x, y = axes[0].transData.transform(axes[0].collections[0].get_offsets()[4])
    ratio = scatter.devicePixelRatioF()
    press_at(scatter, QtCore.QPoint(round(x / ratio), round((scatter.figure.bbox.height - y) / ratio)))
    chosen, = results.table.selectionModel().selectedRows()
    marked = next(case for case in cases_of(study) if case.id == int(results.table.item(chosen.row(), 0).text()))
    near = [case for case in done if abs(case.parameters["Boss.Length"] - done[4].parameters["Boss.Length"]) < 0.3]
    assert marked.id in [case.id for case in near], (marked.id, done[4].id)
    assert results.note.text().startswith("Case %d: Boss.Length" % marked.id)
    for tab, name in ((1, "parallel"), (2, "tornado")):
        press_at(results.tabs.tabBar(), results.tabs.tabBar().tabRect(tab).center())
        wait_for(lambda: results.plots[tab].canvas is not None)
        picture("study_" + name)
    assert len(results.plots[1].canvas.figure.axes[0].lines) >= len(done)
    assert len(results.plots[2].canvas.figure.axes) == 3


def check_rows(document, study, results):
    """A click on a row tells its case. A double click gives the document the case's values: part, mesh and result; undo and As it was take that back."""
    from freecad.featuremesh import api, engine, live_result
    press_at(results.tabs.tabBar(), results.tabs.tabBar().tabRect(3).center())
    cases = cases_of(study)
    assert results.table.rowCount() == len(cases) == 16
    picture("study_cases")
    for row in (1, 0):
        press_at(results.table.viewport(), results.table.visualItemRect(results.table.item(row, 1)).center())
        assert results.note.text().startswith("Case %d: Boss.Length" % cases[row].id), results.note.text()
    check_sorted(results, cases)
    row = max((row for row, case in enumerate(cases) if case.state == "done"), key=lambda row: cases[row].parameters["Fillet.Radius"])
    case, volume, steps = cases[row], study.Part.Shape.Volume, document.UndoCount
    results.table.scrollToItem(results.table.item(row, 0))
    spin()
    double_click(results.table.viewport(), results.table.visualItemRect(results.table.item(row, 2)).center())
    assert document.UndoCount == steps + 1, document.UndoNames
    assert abs(document.Fillet.Radius.Value - case.parameters["Fillet.Radius"]) < 1e-9
    density = float(FreeCAD.Units.Quantity(document.Steel.Material["Density"]).getValueAs("kg/mm^3"))
    assert abs(study.Part.Shape.Volume * density / case.responses["mass"] - 1) < 1e-9 and study.Part.Shape.Volume != volume
    mesh, = api.meshes_of(document)
    assert mesh.Status == "up to date"
    live = next((obj for obj in document.Objects if live_result.is_live_result(obj)), None)
    assert (live is None) == bool(engine.load().statics_missing())   # without PETSc CalculiX solves it
    if live is not None:
        check_live(live, case)
    else:
        solved, = [obj for obj in study.Analysis.Group if obj.isDerivedFrom("Fem::FemResultObject")]
        assert abs(max(solved.vonMises) / case.responses["max_mises"] - 1) < 0.02, (max(solved.vonMises), case.responses)
    results.hide()
    picture("study_case")
    results.show()
    click(results.back_button)
    wait_for(lambda: live is None or live.Status == live_result.UP_TO_DATE, LONG)
    assert document.Fillet.Radius.Value == 3 and abs(study.Part.Shape.Volume / volume - 1) < 1e-9
    document.undo()
    assert abs(document.Fillet.Radius.Value - case.parameters["Fillet.Radius"]) < 1e-9
    document.undo()
    document.recompute()
    assert document.Fillet.Radius.Value == 3


def check_case_that_cannot_be_made(document, results):
    """It is told why, and nothing in the document is left in error."""
    case = results._cases[1]
    radius = case.parameters["Fillet.Radius"]
    case.parameters["Fillet.Radius"] = 40.0
    steps = document.UndoCount
    double_click(results.table.viewport(), results.table.visualItemRect(results.table.item(0, 1)).center())
    case.parameters["Fillet.Radius"] = radius
    assert "cannot recompute Fillet" in window.messages[-1], window.messages
    assert document.Fillet.Radius == 3 and document.UndoCount == steps, document.UndoNames
    assert not [obj.Name for obj in document.Objects if not obj.isValid() or obj.MustExecute or "Touched" in obj.State], [(obj.Name, obj.State) for obj in document.Objects]


def check_theme(study):
    """What a plot's tab says can be read in a dark theme, which colours texts and what is behind them, but no palette."""
    from freecad.featuremesh.gui import study_window as windows
    before, folder = QtGui.QApplication.instance().styleSheet(), study.Folder
    QtGui.QApplication.instance().setStyleSheet(
        "QDialog {background-color: #202020} QTabWidget::pane {background-color: #202020; border: 1px solid black} "
        "QAbstractScrollArea {background-color: transparent} QLabel {color: white}")
    study.Folder = ""
    shown = windows.show(study)
    spin(1)
    picture("study_dark")
    label = shown.plots[0].widget()
    behind = shown.grab().toImage().pixelColor(label.mapTo(shown, QtCore.QPoint(3, 3)))
    assert label.text() == "No case is done yet." and behind.lightness() < 80, (label.text(), behind.name())
    shown.close()
    study.Folder = folder
    QtGui.QApplication.instance().setStyleSheet(before)
    spin()


def check_sorted(results, cases):
    """A click on a column's title sorts by its numbers, one more the other way round; the selected case stays selected."""
    header, name = results.table.horizontalHeader(), "Fillet.Radius"
    wanted = [case.id for case in sorted(cases, key=lambda case: case.parameters[name])]
    column = next(column for column in range(results.table.columnCount()) if results.table.horizontalHeaderItem(column).text() == name)
    for place, order in ((column, wanted), (column, wanted[::-1]), (0, [case.id for case in cases])):
        press_at(header.viewport(), QtCore.QPoint(header.sectionViewportPosition(place) + 20, header.height() // 2))
        assert [int(results.table.item(row, 0).text()) for row in range(16)] == order, order
        chosen, = results.table.selectionModel().selectedRows()
        assert int(results.table.item(chosen.row(), 0).text()) == cases[0].id


def check_is_left(shown):
    """The panel that the case closed hears of no selection any longer, nor of the time."""
    assert not Gui.Control.activeDialog()
    Gui.Selection.addSelection(FreeCAD.ActiveDocument.Body)
    Gui.Selection.clearSelection()
    spin(1)
    assert "already deleted" not in report_view(), report_view()
    assert not shown._timer.isActive()


def check_edited_sketch(document, results):
    """No case is shown, and no panel closed, while something else is edited in one."""
    document.HoleSketch.ViewObject.doubleClicked()
    spin()
    steps = document.UndoCount
    double_click(results.table.viewport(), results.table.visualItemRect(results.table.item(0, 1)).center())
    assert window.messages[-1] == "HoleSketch is being edited; close its panel first" and document.UndoCount == steps, window.messages
    assert Gui.Control.activeDialog() and Gui.activeDocument().getInEdit().Object is document.HoleSketch
    Gui.activeDocument().resetEdit()
    Gui.activateWorkbench("FeatureMeshWorkbench")
    spin()


def check_live(live, case):
    """The window's result is that of the case."""
    from freecad.featuremesh import live_result
    wait_for(lambda: live.Status == live_result.UP_TO_DATE, LONG)
    spin(1)
    assert abs(live.MaxMises / case.responses["max_mises"] - 1) < 0.2, (live.MaxMises, case.responses)
    assert abs(live.MaxDisplacement / case.responses["max_displacement"] - 1) < 0.02, (live.MaxDisplacement, case.responses)
    figures.append("stress of the case %.2f MPa, in the window %.2f MPa" % (case.responses["max_mises"], live.MaxMises))


def check_report(study, results):
    with mock.patch.object(QtGui.QDesktopServices, "openUrl") as opened:
        click(results.report_button)
    path = opened.call_args[0][0].toLocalFile()
    page = Path(path).read_text(encoding="utf-8")
    assert page.count("data:image/png;base64,") == 4 and "Pareto" in page
    assert "<h1>Study of bracket.FCStd</h1>" in page, page[:2000]
    with tempfile.TemporaryDirectory() as folder:
        with mock.patch.object(QtGui.QFileDialog, "getSaveFileName", return_value=(os.path.join(folder, "of 12.5 mm"), "JSON (*.json)")):
            click(results.export_button)
        assert os.listdir(folder) == ["of 12.5 mm.json"], (os.listdir(folder), window.messages)
    results.close()


def check_folder_goes(study):
    """While the study's window is open: it is told, and what is shown stays."""
    from freecad.featuremesh.gui import study_window as windows
    results, away = windows.show(study), study.Folder + "-away"
    spin(1)
    shutil.move(study.Folder, away)
    for button in (results.report_button, results.export_button):
        with mock.patch.object(QtGui.QFileDialog, "getSaveFileName", return_value=(away + ".csv", "CSV (*.csv)")), mock.patch.object(QtGui.QDesktopServices, "openUrl"):
            click(button)
        assert window.messages.pop().startswith("The study's folder %s is gone" % study.Folder), window.messages
    wait_for(lambda: "is gone" in results.note.text(), 20)
    os.makedirs(study.Folder)
    Path(study.Folder, "study.sqlite").write_text("no database", encoding="utf-8")
    wait_for(lambda: "is no study's database" in results.note.text(), 20)
    assert results.table.rowCount() == 16
    shutil.rmtree(study.Folder)
    shutil.move(away, study.Folder)
    results.close()
    assert "Traceback" not in report_view(), report_view()


def check_folder(study):
    """That of a study that was moved with its document is found beside that; a file in it that is no study's is told of, and the panel can be used."""
    before = study.Folder
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "study.sqlite").write_text("no database", encoding="utf-8")
        for place, is_there, status in (("/gone/" + os.path.basename(before), True, "16 of 16 cases done"), ("/gone/study", False, "The study's folder /gone/study is gone"),
                                        (folder, False, "is no study's database")):
            study.Folder = place
            study.ViewObject.doubleClicked()
            spin(1)
            shown = panel("StudyPanel")
            assert shown.results_button.isEnabled() == is_there and status in shown.status.text(), (place, shown.status.text())
            click_in_panel("Close")
    assert "Traceback" not in report_view(), report_view()
    study.Folder = before


def check_copied_folder(document, study):
    """A copy of the project's folder has its own cases, also while the first one is there; a document that was saved elsewhere alone has those it had."""
    from freecad.featuremesh.study import study_object
    with tempfile.TemporaryDirectory() as folder:
        copied = shutil.copytree(os.path.dirname(document.FileName), os.path.join(folder, "copied project"))
        alone = shutil.copy(os.path.join(copied, os.path.basename(document.FileName)), os.path.join(folder, "alone.FCStd"))
        other = FreeCAD.openDocument(alone)
        assert study_object.folder_of(other.getObject(study.Name)) == study.Folder
        FreeCAD.closeDocument(other.Name)
        other = FreeCAD.openDocument(os.path.join(copied, os.path.basename(document.FileName)))
        spin()
        of_copy = other.getObject(study.Name)
        of_copy.ViewObject.doubleClicked()
        spin(1)
        shown = panel("StudyPanel")
        assert shown.status.text().startswith("16 of 16 cases done"), shown.status.text()
        shown.cases.setValue(1)
        assert shown.go_on_button.text() == "Add cases" and shown.go_on_button.isVisible()
        click(shown.go_on_button)
        wait_for(lambda: has_ended(of_copy), LONG)
        shown.refresh()
        assert shown.status.text() == "17 of 17 cases done", shown.status.text()
        picture("study_of_a_copy")
        click_in_panel("Close")
        assert len(cases_of(study)) == 16
        FreeCAD.closeDocument(other.Name)
    FreeCAD.setActiveDocument(document.Name)
    spin()


def check_bounds_of_a_script(study):
    """They have more digits than the panel shows, and stay what they are when something else is changed."""
    before = study.Parameters
    study.Parameters = ["Fillet.Radius=2.70000012:3.3"]
    study.ViewObject.doubleClicked()
    spin()
    shown = panel("StudyPanel")
    assert shown.dimensions.item_of("Fillet.Radius").text(1) == "2.7 : 3.3"
    tick(shown, "Boss.Length")
    assert "Fillet.Radius=2.70000012:3.3" in study.Parameters and len(study.Parameters) == 2, study.Parameters
    tick(shown, "Boss.Length")
    shown.reject()
    study.Parameters = before
    spin()


def check_settings(document, study):
    """Double click in the tree; a range that is typed, a response at a face that is clicked, nothing ticked."""
    check_bounds_of_a_script(study)
    study.ViewObject.doubleClicked()
    spin()
    shown = panel("StudyPanel")
    item = shown.dimensions.item_of("Fillet.Radius")
    assert item.checkState(0) == QtCore.Qt.Checked and item.text(1) == "2.7 : 3.3"
    type_range(shown, item, "2.7 : 5")
    assert "Fillet.Radius=2.7:5.0" in study.Parameters, study.Parameters
    place = shown.dimensions.y()
    type_range(shown, item, "2.7 : x")
    assert shown.dimensions.y() == place   # nothing moves under the mouse
    assert "two numbers" in shown.status.text() and "Fillet.Radius=2.7:5.0" in study.Parameters, (shown.status.text(), study.Parameters)
    type_range(shown, item, "2.7 : 5")
    for name in ("Live", "FeatureMesh"):
        obj = document.getObject(name)
        if obj is not None:
            obj.ViewObject.Visibility = False
    study.Part.ViewObject.Visibility = True
    other = FreeCAD.newDocument("Other", hidden=True)
    Gui.Selection.addSelection(other.addObject("Part::Box", "Fillet"), "Face1")
    spin()
    assert not shown.at_button.isEnabled()   # of another document
    FreeCAD.closeDocument(other.Name)
    click_in_view(FreeCAD.Vector(70, 40, 15))   # the upper side of the plate
    wait_for(shown.at_button.isEnabled, 20)
    click(shown.at_button)
    added = study.Responses[-1]
    assert added.startswith("max_mises@Face"), study.Responses
    tick(shown, "Fillet.Radius")
    tick(shown, "Boss.Length")
    assert not study.Parameters
    click(shown.run_button)
    assert "tick a dimension" in window.messages[-1], window.messages
    check_no_case_can_be_made(study, shown)
    tick(shown, "Boss.Length")
    return shown


def check_no_case_can_be_made(study, shown):
    """It is said, with the reason, and none is called done."""
    before, folder = study.Responses, study.Folder
    tick(shown, "Fillet.Radius")
    type_range(shown, shown.dimensions.item_of("Fillet.Radius"), "60 : 70")
    shown.cases.setValue(2)
    click(shown.run_button)
    wait_for(lambda: study.Folder != folder and has_ended(study), LONG)
    shown.refresh()
    assert re.match("0 of 2 cases done, 2 could not be made or solved; case 1: .*Fillet", shown.status.text()), shown.status.text()
    type_range(shown, shown.dimensions.item_of("Fillet.Radius"), "2.7 : 5")
    tick(shown, "Fillet.Radius")
    shown.cases.setValue(16)
    assert study.Responses == before


def check_renamed(document, study):
    """A dimension that was renamed has a row of its own, is told before anything is made, and can be let go."""
    shown = panel("StudyPanel")
    tick(shown, "HoleSketch.Hole6X")
    parameters, folder = list(study.Parameters), study.Folder
    click_in_panel("Close")
    number = [constraint.Name for constraint in document.HoleSketch.Constraints].index("Hole6X")
    document.HoleSketch.renameConstraint(number, "Far")
    study.ViewObject.doubleClicked()
    spin()
    shown = panel("StudyPanel")
    assert set(study.Parameters) == set(parameters)
    window.messages.clear()
    click(shown.run_button)
    assert "no constraint or property Hole6X" in window.messages[0], window.messages
    assert study.Folder == folder and shown.results_button.isEnabled()
    row = shown.dimensions.topLevelItem(shown.dimensions.topLevelItemCount() - 1)
    assert row.text(0).startswith("HoleSketch.Hole6X="), row.text(0)
    shown.dimensions.scrollToItem(row)
    spin()
    box = shown.dimensions.visualItemRect(row)
    press_at(shown.dimensions.viewport(), QtCore.QPoint(box.left() + 10, box.center().y()))
    assert set(study.Parameters) == {text for text in parameters if "Hole6X" not in text}, study.Parameters
    document.HoleSketch.renameConstraint(number, "Hole6X")


def check_stop(shown, study):
    """Stop keeps what is done, Go on runs the rest; a deleted study ends."""
    from freecad.featuremesh.gui import study_runs
    first = study.Folder
    click(shown.run_button)
    wait_for(lambda: study.Folder != first and shown.bar.value() > 0, LONG)
    click(shown.run_button)
    wait_for(lambda: has_ended(study), LONG)
    shown.refresh()
    assert shown.status.text().endswith("cases done: stopped"), shown.status.text()
    states = [case.state for case in cases_of(study)]
    assert "running" not in states and 0 < states.count("done") < 16, states
    assert shown.go_on_button.isVisible()
    click(shown.go_on_button)
    wait_for(lambda: has_ended(study), LONG)
    assert [case.state for case in cases_of(study)] == ["done"] * 16
    assert all("max_mises@Face" in "".join(case.responses) for case in cases_of(study))
    shown.refresh()   # another button comes beside this one, which must not move under the mouse
    spin()
    click(shown.run_button)
    run = study_runs.run_of(study)
    assert run.is_running()
    study.Document.removeObject(study.Name)
    wait_for(lambda: not Gui.Control.activeDialog(), 20)
    assert not run.is_running()


def drive():
    window.choose_workbench(height=1024)
    from freecad.featuremesh import preferences
    preferences.put("SecondOrder", False)   # what a new mesh starts with, also that of a study
    document = FreeCAD.ActiveDocument
    document.UndoMode = 1
    window.choose_tab(document.Label)
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    spin()
    check_only_looked_at(document)
    shown, study, results = check_five_clicks(document)
    check_plots(study, results)
    check_rows(document, study, results)
    check_is_left(shown)
    check_case_that_cannot_be_made(document, results)
    check_edited_sketch(document, results)
    check_report(study, results)
    check_folder(study)
    check_folder_goes(study)
    check_theme(study)
    document.save()
    check_copied_folder(document, study)
    check_settings(document, study)
    check_renamed(document, study)
    check_stop(panel("StudyPanel"), study)


window.run(drive)

# SPDX-License-Identifier: GPL-3.0-or-later
"""What the panels show of long and odd labels, in narrow columns, in inches and with decimal commas, and what they read. Run by test_window.py with the bracket."""
import json
import os
import re
import sys
from pathlib import Path
from unittest import mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FemGui  # noqa: E402
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import Part  # noqa: E402
import window  # noqa: E402
from PySide import QtCore, QtGui  # noqa: E402
from window import click_in_panel, figures, is_whole, panel, picture, send_key, spin, wait_for  # noqa: E402

ODD = 'Welle <b>Ø8</b> & "Nabe" für das lange Lager'


def open_panel(command, kind):
    Gui.runCommand("FeatureMesh_" + command)
    spin()
    return panel(kind)


def close(button="Close"):
    click_in_panel(button)
    wait_for(lambda: not Gui.Control.activeDialog(), 20)


def check_labels(body, mesh):
    """Labels are shown as they are, and make no panel wider than the dock."""
    before = body.Label, mesh.Label
    body.Label = mesh.Label = ODD
    mesh.ViewObject.doubleClicked()
    spin()
    settings = panel("MeshPanel")
    part = next(label for label in settings.form.findChildren(QtGui.QLabel) if label.toolTip() == body.Label)
    assert part.textFormat() == QtCore.Qt.PlainText
    picture("odd_label")
    close("Cancel")
    shown = open_panel("ShowQuality", "QualityPanel")
    picture("odd_label_quality")
    assert is_whole(shown.form), shown.form.width()
    close()
    body.Label, mesh.Label = before


def check_boxes(body, mesh):
    """The question about a part that has a mesh already, and an error, name things as they are."""
    from freecad.featuremesh.errors import UserError
    from freecad.featuremesh.gui import errors, message_box
    from freecad.featuremesh.messages import said
    seen = []

    def look():
        box = QtGui.QApplication.activeModalWidget()
        if isinstance(box, QtGui.QMessageBox) and box.isVisible():
            timer.stop()
            seen.append((box.textFormat(), box.text()))
            box.reject()
    timer = QtCore.QTimer()
    timer.timeout.connect(look)
    body.Label = ODD
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(body)
    with mock.patch.object(message_box, "warn", window.shown[0]):
        for show in (lambda: Gui.runCommand("FeatureMesh_MeshPart"), lambda: errors.show(UserError(said("{part:text} is gone", part=ODD)))):
            timer.start(50)
            show()
            spin()
    assert seen == [(QtCore.Qt.PlainText, "%s has the mesh %s already." % (ODD, mesh.Label)), (QtCore.Qt.PlainText, ODD + " is gone")], seen
    Gui.Selection.clearSelection()


def check_remarks(mesh):
    """The panel has room for three remarks; where the others are is true."""
    report = mesh.Report
    mesh.Report = json.dumps({**json.loads(report), "warnings": ["remark %d <x>" % number for number in range(1, 6)]})
    mesh.ViewObject.doubleClicked()
    spin()
    settings = panel("MeshPanel")
    result = settings.result
    assert "remark 3" in result.text() and "remark 4" not in result.text() and "and 2 more: let the mouse rest here" in result.text(), result.text()
    assert result.textFormat() == settings.estimate.textFormat() == QtCore.Qt.PlainText
    assert result.toolTip() == "remark 4 &lt;x><br>remark 5 &lt;x>", result.toolTip()
    close("Cancel")
    mesh.Report = report


def check_forced_angles(document):
    """Where a part's own angles are small, the panel says how good all other elements are."""
    one = Part.makeCylinder(5, 10)
    part = document.addObject("Part::Feature", "Touching")
    part.Shape = one.fuse(Part.makeCylinder(5, 10, FreeCAD.Vector(9.97, 0, 0)))
    from freecad.featuremesh import api
    mesh = api.add_mesh(part, 3.0, order=1, join_analysis=False)
    document.recompute()
    mesh.ViewObject.doubleClicked()
    spin()
    words = re.search(r"smallest angle ([0-9.]+) deg, ([0-9.]+) deg where the part's own angles do not force less; mean", panel("MeshPanel").result.text())
    assert words and float(words.group(1)) < 10 < 15 < float(words.group(2)), panel("MeshPanel").result.text()
    picture("forced_angles")
    close("Cancel")
    for obj in (mesh, part):
        document.removeObject(obj.Name)


def drawn_in_list(shown, target):
    """(the text that the row of a dimension is drawn with, the room for it in pixels, its width)."""
    rows = shown.dimensions
    item = rows.item_of(target)
    rows.scrollToItem(item)
    spin()
    index = rows.indexFromItem(item, 0)
    option = QtGui.QStyleOptionViewItem()
    option.rect, option.widget, option.font = rows.visualRect(index), rows, rows.font()
    option.fontMetrics = rows.fontMetrics()
    rows.itemDelegateForColumn(0).initStyleOption(option, index)
    room = rows.style().subElementRect(QtGui.QStyle.SE_ItemViewItemText, option, rows).width()
    return option.text, room, option.fontMetrics.boundingRect(option.text).width()


def check_dimensions():
    """Beside the ranges there is little room: names are shortened, values never. Ranges are numbers."""
    shown = open_panel("Study", "StudyPanel")
    rows = shown.dimensions
    assert drawn_in_list(shown, "HoleSketch.Hole4X")[0] == "Hole4X  110 mm"
    rows.item_of("Fillet.Radius").setCheckState(0, QtCore.Qt.Checked)
    rows.setFixedWidth(210)   # as in FreeCAD 0.20's dock; 1.1 has more room
    spin()
    texts = {}
    for target, value in (("HoleSketch.Hole4X", "  110 mm"), ("HoleSketch.Hole4Radius", "  4 mm"), ("PlateSketch.PlateLength", "  120 mm"), ("Fillet.Radius", "  3 mm")):
        text, room, width = drawn_in_list(shown, target)
        assert text.endswith(value) and width <= room, (target, text, room, width)
        texts[target] = text
    assert "…" in texts["HoleSketch.Hole4Radius"], texts
    picture("dimensions_in_inches")
    for text in ("5 : inf", "nan : 3", "1e999 : 3"):
        rows.item_of("Fillet.Radius").setText(1, text)
        shown.refresh()
        assert shown.status.text().startswith("The range of Fillet.Radius has to be two numbers"), (text, shown.status.text())
    rows.item_of("Fillet.Radius").setCheckState(0, QtCore.Qt.Unchecked)
    close()


def go_to(field):
    """The next keys are for that field."""
    QtGui.QApplication.setActiveWindow(Gui.getMainWindow())   # there is no window manager
    field.setFocus()
    spin()


def type_place(cut, text):
    """In place of what the field has, key by key, and Tab."""
    go_to(cut.place)
    send_key(cut.place, QtCore.Qt.Key_A, QtCore.Qt.ControlModifier)
    for letter in text:
        send_key(cut.place, 0, QtCore.Qt.NoModifier, letter)
    typed = cut.place.property("text")
    send_key(cut.place, QtCore.Qt.Key_Tab)
    spin()
    return typed


def check_cut():
    """A place is typed with its unit; one beyond the mesh is the end of it."""
    shown = open_panel("ShowQuality", "QualityPanel")
    shown.cut.setChecked(True)
    for text, place in (("30 mm", 30.0), ("12 mm", 12.0), ("500 mm", 45.0)):
        assert type_place(shown.cut, text) == text, (text, shown.cut.place.property("text"))
        assert abs(shown.cut.at() - place) < 1e-9, (text, shown.cut.at())
    close()


def check_live():
    """Stresses of thousands of psi are written as people write them."""
    shown = open_panel("LiveResult", "LivePanel")
    wait_for(lambda: shown.largest.text(), 60)
    picture("live_in_inches")
    for text in (shown.largest.text(), *shown.legend.labels):
        assert "e+" not in text, (shown.largest.text(), shown.legend.labels)
    assert shown.legend.labels[-1].endswith("00 psi"), shown.legend.labels
    close()
    check_load_begun(shown.live)
    check_all_new(shown.live)


def check_load_begun(live):
    """FEM's panel of a new load, which has no face yet: nothing is said of that."""
    wait_for(lambda: live.Status == "up to date", 60)
    FemGui.setActiveAnalysis(live.Document.Analysis)
    Gui.runCommand("FEM_ConstraintPressure")
    wait_for(lambda: "refers to nothing" in live.Status, 20)
    spin()
    assert "refers to nothing" not in window.report_view(), window.report_view()
    click_in_panel("Cancel")
    wait_for(lambda: live.Status == "up to date", 60)


def check_all_new(live):
    """After a mesh from scratch the change since the last result is known nowhere: it is said why all is grey."""
    from freecad.featuremesh import api
    before = live.Proxy.solution
    api.update_mesh(live.Proxy.mesh(live), True)
    live.Document.recompute()
    wait_for(lambda: live.Status == "up to date" and live.Proxy.solution is not before, 60)
    shown = open_panel("LiveResult", "LivePanel")
    shown.difference.setChecked(True)
    spin()
    assert shown.grey.isVisible() and not shown.legend.labels, shown.legend.labels
    shown.difference.setChecked(False)
    close()


def check_difference(body, path):
    """Dimensions of the part and places are in inches, too."""
    from freecad.featuremesh.commands import made
    sketch = body.Document.HoleSketch
    sketch.setDatum("Hole6X", FreeCAD.Units.Quantity("101.6 mm"))
    body.Document.recompute()
    found = made("FeatureMesh_Compare").show(body, path)
    header = found.tree.headerItem()
    assert [header.text(column) for column in (2, 3)] == ["by how much", "volume"], header.text(2)
    assert found.tree.topLevelItem(2).text(3).endswith("in^3"), found.tree.topLevelItem(2).text(3)
    details = [found.tree.topLevelItem(row).text(2) for row in range(found.tree.topLevelItemCount())]
    assert "Hole6X 4.3307 in -> 4 in" in details, details
    assert "1 of 6 holes moved by (-0.33071 in, 0 in, 0 in) from x 4.3307 in, y 2.7559 in to x 4 in, y 2.7559 in" in details, details
    picture("difference_in_inches")
    found.close()
    sketch.setDatum("Hole6X", FreeCAD.Units.Quantity("110 mm"))
    body.Document.recompute()
    spin()


def check_commas(body, path):
    """Numbers in lists and tables have the decimal sign of all others."""
    from freecad.featuremesh.commands import made
    from freecad.featuremesh.gui import study_window
    QtCore.QLocale.setDefault(QtCore.QLocale("de_DE"))
    assert FreeCAD.Units.Quantity("0.5 mm").UserString == "0,50 mm"
    shown = open_panel("Study", "StudyPanel")
    item = shown.dimensions.item_of("Fillet.Radius")
    item.setCheckState(0, QtCore.Qt.Checked)
    assert item.text(1) == "2,7 : 3,3", item.text(1)
    item.setText(1, "2,5 : 3,5")
    assert list(shown.study.Parameters) == ["Fillet.Radius=2.5:3.5"], shown.study.Parameters
    item.setCheckState(0, QtCore.Qt.Unchecked)
    close()
    found = made("FeatureMesh_Compare").show(body, path)
    volumes = [found.tree.topLevelItem(row).text(3) for row in range(found.tree.topLevelItemCount())]
    assert any("," in volume for volume in volumes) and not any("." in volume for volume in volumes), volumes
    found.close()
    assert study_window._shown(1234567.0) == "1234600" and study_window._shown(2.5) == "2,5"
    QtCore.QLocale.setDefault(QtCore.QLocale.c())


def check_typed_lengths(mesh):
    """What a length was read as is shown when its field is left, and is not rounded to what is shown."""
    mesh.ViewObject.doubleClicked()
    spin()
    settings = panel("MeshPanel")
    shown = {"3,5": "35.00 mm", "1,5 in": "381.00 mm"}   # in English
    for typed, text in shown.items():
        go_to(settings.size)
        window.type_into(settings.size, typed)
        assert settings.size.property("text") == text, (typed, settings.size.property("text"))
    close("Cancel")
    count_in(mesh.Document, 3)
    mesh.ViewObject.doubleClicked()
    spin()
    settings = panel("MeshPanel")
    for typed, size in (("0.3125", 7.9375), ("0.002 in", 0.0508)):
        settings._write(settings.size, 8.0)
        go_to(settings.size)
        window.type_into(settings.size, typed)
        assert abs(settings.settings()["Size"] - size) < 1e-9, (typed, settings.settings()["Size"])
    close("Cancel")
    count_in(mesh.Document, 0)


def check_field_of_before():
    """Where FreeCAD takes a new field for one that is gone, by whose signals it was known, another one is made."""
    from freecad.featuremesh.gui import freecad_widget
    gone, new = (freecad_widget.made("Gui::QuantitySpinBox") for _ in range(2))
    vars(gone)["editingFinished"] = gone.editingFinished   # as PySide 6 keeps it
    loader = mock.Mock()
    loader.createWidget.side_effect = [gone, new]
    with mock.patch.object(Gui, "UiLoader", return_value=loader):
        assert freecad_widget.made("Gui::QuantitySpinBox") is new


def check_widgets_of_before():
    """What FreeCAD takes for a widget that is gone is left out where a panel's fields are looked for."""
    from freecad.featuremesh.gui import freecad_widget, wheel
    field, gone, form = freecad_widget.made("Gui::QuantitySpinBox"), mock.Mock(), mock.Mock()
    gone.objectName.side_effect = RuntimeError("Internal C++ object already deleted.")
    form.findChildren.side_effect = lambda kind: [gone, field] if kind is QtGui.QAbstractSpinBox else []
    freecad_widget.silence(form)
    assert field.signalsBlocked() and not gone.blockSignals.called
    panel_form = QtGui.QWidget()
    field.setParent(panel_form)
    field.setFocusPolicy(QtCore.Qt.WheelFocus)
    wheel.scrolls(panel_form)
    assert field.focusPolicy() == QtCore.Qt.StrongFocus


def count_in(document, schema):
    """FreeCAD's number of a unit scheme; since 1.0 each document has its own, too."""
    if hasattr(document, "UnitSystem"):
        document.UnitSystem = document.getEnumerationsOfProperty("UnitSystem")[schema]
    FreeCAD.Units.setSchema(schema)


def drive():
    from freecad.featuremesh import api, engine
    window.choose_workbench()
    document = FreeCAD.ActiveDocument
    document.UndoMode = 1
    body = document.Body
    path = str(Path(document.FileName).with_name("before.FCStd"))
    document.saveCopy(path)
    mesh = api.add_mesh(body, 8.0, order=1)
    document.recompute()
    check_labels(body, mesh)
    check_boxes(body, mesh)
    check_remarks(mesh)
    check_forced_angles(document)
    check_cut()
    check_typed_lengths(mesh)
    check_field_of_before()
    check_widgets_of_before()
    count_in(document, 3)   # inches with decimals
    check_dimensions()
    check_difference(body, path)
    if not engine.load().statics_missing():
        check_live()
    count_in(document, 0)
    check_commas(body, path)
    figures.append("words: labels, units and decimal signs are as they should be")


window.run(drive)

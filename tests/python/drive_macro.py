# SPDX-License-Identifier: GPL-3.0-or-later
"""A macro recorded while our buttons and panels are used, and played in another copy of the document: the same comes out. Run by test_window.py."""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import window  # noqa: E402
from analyses import held_and_pushed  # noqa: E402
from parts import new_document, plate_with_hole  # noqa: E402
from PySide import QtCore, QtGui  # noqa: E402
from window import click, click_button_of, click_in_panel, panel, spin, tick, type_into, wait_for  # noqa: E402

FOLDER = os.environ["HOME"]
MACRO = os.path.join(FOLDER, "ours.FCMacro")
EXPORTED = os.path.join(FOLDER, "plate.inp")


def start_recording():
    """In FreeCAD's dialog."""
    def fill():
        box = QtGui.QApplication.activeModalWidget()
        if box is not None:
            timer.stop()
            for field, text in (("lineEditPath", "ours"), ("lineEditMacroPath", FOLDER + "/")):
                box.findChild(QtGui.QLineEdit, field).setText(text)
            box.findChild(QtGui.QPushButton, "buttonStart").click()
    timer = QtCore.QTimer()
    timer.timeout.connect(fill)
    timer.start(50)
    Gui.runCommand("Std_DlgMacroRecord")
    assert not timer.isActive()


def stop_recording():
    """The macro's text."""
    commands = Gui.listCommands()
    Gui.runCommand("Std_MacroStopRecord" if "Std_MacroStopRecord" in commands else "Std_DlgMacroRecord")   # one of FreeCAD 1.1 begins and ends it
    spin()
    with open(MACRO, encoding="utf-8") as stream:
        return stream.read()


def play(text):
    """As FreeCAD does."""
    exec(compile(text, MACRO, "exec"), {"__name__": "__main__", "FreeCAD": FreeCAD, "App": FreeCAD, "FreeCADGui": Gui, "Gui": Gui})
    spin()


def press(command, *selected):
    Gui.Selection.clearSelection()
    for entry in selected:
        Gui.Selection.addSelection(*entry)
    click_button_of("FeatureMesh_" + command)


def open_with(command, *selected):
    """The panel that the command opens."""
    press(command, *selected)
    wait_for(Gui.Control.activeDialog)
    spin(0.5)


def close_with(name):
    click_in_panel(name)
    wait_for(lambda: not Gui.Control.activeDialog())
    spin()


def live_result_of(document):
    from freecad.featuremesh import live_result
    return next(obj for obj in document.Objects if live_result.is_live_result(obj))


def use_buttons(document, body):
    """What the macro is to have."""
    open_with("MeshPart", (body,))
    type_into(panel("MeshPanel").size, "7")
    close_with("Ok")
    mesh = document.FeatureMesh
    for command, face in (("AddLocalSize", "Face1"), ("AddGroup", "Face2")):
        open_with(command, (body, face))
        if command == "AddLocalSize":   # FEM's own panel
            field, = [field for field in Gui.getMainWindow().findChildren(QtGui.QWidget) if field.objectName() in ("if_elelen", "qsb_elelen") and field.isVisible()]
            type_into(field, "2.5")
        close_with("Ok")
    open_with("AddSizeZone", (mesh,))
    settings = panel("ZonePanel")
    settings.kind.setCurrentIndex(1)
    settings.lengths["Radius"].setProperty("rawValue", 9.0)
    settings.place[0].setProperty("rawValue", 41.5)
    close_with("Ok")
    press("UpdateNow", (mesh,))
    spin()
    open_with("Study", (body,))
    tick(panel("StudyPanel"), "Plate.Length")
    panel("StudyPanel").cases.setValue(5)
    click(panel("StudyPanel").run_button)
    wait_for(lambda: len(done_of(document.Study)) == 5, 300)
    panel("StudyPanel").cases.setValue(2)
    wait_for(lambda: panel("StudyPanel").go_on_button.text() == "Add cases" and panel("StudyPanel").go_on_button.isVisible())
    click(panel("StudyPanel").go_on_button)
    wait_for(lambda: len(done_of(document.Study)) == 7, 300)
    close_with("Close")
    mesh.ViewObject.doubleClicked()
    spin(0.5)
    panel("MeshPanel").growth.setValue(1.5)
    close_with("Ok")
    mesh.ViewObject.doubleClicked()
    spin(0.5)
    panel("MeshPanel").automatic.setChecked(False)
    close_with("Ok")
    open_with("LiveResult", (document.Analysis,))
    wait_for(lambda: live_result_of(document).Status == "up to date")
    close_with("Close")
    export(mesh)


def use_in_vain(document):
    """What is cancelled, or only looked at, is in no macro."""
    mesh = document.FeatureMesh
    for command, selected, end in (("AddSizeZone", (mesh,), "Cancel"), ("Study", (document.Box,), "Close"), ("ShowQuality", (mesh,), "Close"),
                                   ("MeshPart", (document.Box,), "Cancel"), ("LiveResult", (document.Analysis,), "Close")):
        open_with(command, selected)
        close_with(end)


def export(mesh):
    from freecad.featuremesh.gui import save_dialog
    asked = save_dialog.QtGui.QFileDialog.getSaveFileName
    save_dialog.QtGui.QFileDialog.getSaveFileName = staticmethod(lambda *words: (EXPORTED, "Abaqus, CalculiX (*.inp)"))
    try:
        press("Export", (mesh,))
    finally:
        save_dialog.QtGui.QFileDialog.getSaveFileName = asked


def done_of(study):
    from freecad.featuremesh.study.folder import StudyFolder, has_study
    if not has_study(study.Folder):
        return []
    database = StudyFolder(study.Folder).database
    try:
        return [case.parameters for case in database.cases("done")]
    finally:
        database.close()


def contents(document):
    """What is in the document, as far as a user has set or made it."""
    from freecad.featuremesh.gui import recording
    mesh, live = document.FeatureMesh, live_result_of(document)
    with open(EXPORTED, encoding="utf-8") as stream:
        exported = stream.read()
    return [sorted(obj.Name for obj in document.Objects), mesh.NodeCount, mesh.TetCount, mesh.Status, live.Status, round(live.MaxMises, 9), exported, done_of(document.Study),
            *(recording._settings_of(obj) for obj in document.Objects if obj.Name.startswith(("FeatureMesh", "SizeZone", "Study", "Mesh", "FEMMesh")))]


def lines_of(macro):
    return [line for line in macro.splitlines() if line and not line.startswith(("#", "import "))]


def drive():
    window.choose_workbench()
    document = new_document("Plate")
    body = plate_with_hole(document)
    document.addObject("Part::Box", "Box").Placement.Base = FreeCAD.Vector(0, 0, 50)
    held_and_pushed(document, body)
    document.recompute()
    path = os.path.join(FOLDER, "plate.FCStd")
    document.saveAs(path)
    start_recording()
    use_buttons(document, body)
    macro = stop_recording()
    wanted = contents(document)
    os.unlink(MACRO)
    os.unlink(EXPORTED)
    start_recording()
    use_in_vain(document)
    text = stop_recording()
    assert not lines_of(text), lines_of(text)
    FreeCAD.closeDocument(document.Name)
    again = FreeCAD.openDocument(path)
    spin()
    assert len(again.Objects) < len(wanted[0])
    play(macro)
    wait_for(lambda: live_result_of(again).Status == wanted[4], 60)
    found = contents(again)
    for one, other in zip(found, wanted):
        assert one == other, (one, other)
    assert len(found) == len(wanted)
    from freecad.featuremesh.gui import study_runs
    assert study_runs.run_of(again.Study) is not None   # so that its panel can stop it
    FreeCAD.closeDocument(again.Name)


if os.environ.get("FEATUREMESH_RESULT"):
    window.run(drive)

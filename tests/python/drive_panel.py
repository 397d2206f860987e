# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel of a mesh by hand: OK, Apply, Cancel, what it says, and which part and analysis a new mesh is for. Run by test_window.py."""
import json
import os
import sys
from unittest import mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FemGui  # noqa: E402
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import ObjectsFem  # noqa: E402
import window  # noqa: E402
from parts import groups_of  # noqa: E402
from PySide import QtCore, QtGui  # noqa: E402
from window import answer_with, button_in_panel, click, click_button_of, click_in_panel  # noqa: E402
from window import figures, is_whole, panel, picture, report_view, send_key, spin, turn_wheel, type_into, wait_for  # noqa: E402


def names(document):
    return {obj.Name for obj in document.Objects}


def open_new(body_or_sketch):
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(body_or_sketch)
    click_button_of("FeatureMesh_MeshPart")
    return panel("MeshPanel")


def check_width(settings):
    """FreeCAD's dock as it is at first has room for the panel and the buttons above it, with their whole texts."""
    assert is_whole(settings.form), (settings.form.width(), settings.form.visibleRegion().boundingRect().width())
    for name in ("Ok", "Cancel", "Apply"):
        button = button_in_panel(name)
        assert is_whole(button), (name, button.width(), button.visibleRegion().boundingRect().width())
        assert button.width() > button.fontMetrics().boundingRect(button.text()).width(), name


def check_cancel(document, sketch):
    """A sketch that was edited is still selected: its body is meant. Cancel leaves nothing behind, nor does an error."""
    before, steps = names(document), document.UndoCount
    settings = open_new(sketch)
    assert settings.mesh.Name not in before and settings.form.isVisible()
    assert settings.min_automatic.isChecked() and not settings.min_size.isVisible() and not settings.working.isVisible()
    assert settings.status.text() == "Status: not meshed yet", settings.status.text()
    picture("panel_new")
    check_in_sight(settings)
    check_width(settings)
    click_in_panel("Cancel")
    assert names(document) == before and document.UndoCount == steps and not document.HasPendingTransaction
    assert not Gui.Control.activeDialog() and Gui.activeDocument().getInEdit() is None

    document.UndoMode = 0   # as one of FreeCAD's preferences has it
    open_new(sketch)
    click_in_panel("Cancel")
    assert names(document) == before, names(document) - before
    document.UndoMode = 1

    settings = open_new(sketch)   # a size that cannot be meshed: the panel stays and says so, and Cancel takes all of it back
    settings.size.setProperty("rawValue", 1000.0)
    click_in_panel("Apply")
    wait_for(lambda: settings.running is None)
    assert "failed" in settings.status.text() and Gui.Control.activeDialog(), settings.status.text()
    picture("panel_failed")
    check_next_size(settings)
    click_in_panel("Cancel")
    assert names(document) == before and document.UndoCount == steps and not document.HasPendingTransaction


def check_next_size(settings):
    """After a size that was refused another one is typed: what the panel tells is of that. Where the memory is not enough for it, it asks."""
    from freecad.featuremesh.study import memory
    type_into(settings.size, "0 mm")
    click_in_panel("Apply")
    wait_for(lambda: "greater than 0 mm" in settings.status.text())
    type_into(settings.size, "4 mm")
    wait_for(lambda: "about" in settings.estimate.text())
    assert settings.status.text() == "Status: settings changed, not meshed yet", settings.status.text()
    seen = []
    timer = answer_with("Cancel", seen)
    with mock.patch.object(memory, "available_bytes", lambda: 1e6):
        click_in_panel("Ok")
    assert not timer.isActive() and "need about 0 GB of memory; 0 GB are free" in seen[0], seen
    assert settings.running is None and Gui.Control.activeDialog()


def check_errors(document, body):
    """An error in the middle leaves the document as it was, with no open transaction."""
    from freecad.featuremesh import api, mesh_object
    before, steps = names(document), document.UndoCount

    def half_done(part, **settings):
        document.addObject("App::FeaturePython", "LeftBehind")
        raise RuntimeError("in the middle")
    timer = answer_with("Add another mesh", [])
    with mock.patch.object(api, "add_mesh", half_done):
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(body)
        Gui.runCommand("FeatureMesh_MeshPart")
        spin()
    assert not timer.isActive() and window.messages[-1] == "in the middle"
    assert names(document) == before and document.UndoCount == steps and not document.HasPendingTransaction
    mesh = api.meshes_of(document)[0]
    mesh.ViewObject.doubleClicked()
    spin()
    settings = panel("MeshPanel")
    with mock.patch.object(mesh_object.FeatureMesh, "finish", side_effect=RuntimeError("handing over failed")):
        click_in_panel("Apply")
        wait_for(lambda: settings.running is None)
    assert "handing over failed" in settings.status.text() and not document.HasPendingTransaction, settings.status.text()
    assert document.UndoCount == steps, (steps, document.UndoNames)
    click_in_panel("Ok")   # what failed is meshed again
    wait_for(lambda: not Gui.Control.activeDialog())
    assert mesh.Status == "up to date", mesh.Status


def check_apply_and_ok(document, body):
    """Apply meshes and stays, as one step of undo with the object; what is set after that is gone with Cancel, and meshed with OK."""
    steps = document.UndoCount
    settings = open_new(body)
    mesh = settings.mesh
    assert versions().part_of(mesh) is body
    settings.size.setProperty("rawValue", 4.0)
    click_in_panel("Apply")
    assert settings.working.isVisible() or settings.running is None
    wait_for(lambda: settings.running is None)
    assert not settings.working.isVisible() and mesh.TetCount and Gui.Control.activeDialog()
    assert document.UndoCount == steps + 1 and document.UndoNames[0] == "Mesh a part", document.UndoNames
    assert settings.status.text() == "Status: up to date" and "elements" in settings.result.text()
    count = mesh.TetCount
    settings.size.setProperty("rawValue", 6.0)
    spin()
    assert settings.status.text() == "Status: settings changed, not meshed yet", settings.status.text()
    picture("panel_changed")
    click_in_panel("Cancel")
    assert mesh.Size.Value == 4.0 and mesh.TetCount == count and mesh.Status == "up to date" and not Gui.Control.activeDialog()

    mesh.ViewObject.doubleClicked()
    spin()
    settings = panel("MeshPanel")
    settings.size.setProperty("rawValue", 6.0)
    settings.min_automatic.click()
    spin()
    assert settings.min_size.isVisible() and abs(settings.min_size.property("rawValue") - 0.6) < 1e-9
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    assert (mesh.Size.Value, mesh.MinSize.Value, mesh.Status) == (6.0, 0.6, "up to date") and mesh.TetCount < count
    mesh.Automatic = False
    mesh.Size = 5.0
    assert mesh.Status == "settings changed, not meshed yet"
    mesh.Size = 6.0
    assert mesh.Status == "up to date"
    mesh.Automatic = True
    return mesh


def check_edit_while_open(document, body):
    """Undo of a mesh shows its part again, redo the mesh. An edit of the part while the panel is open is what the panel tells of."""
    settings = open_new(body)
    document.getObject("Plate").Length = 11   # in the property editor, which leaves the recompute to the end of the transaction
    click_in_panel("Apply")
    wait_for(lambda: settings.running is None)
    assert abs(max(point.z for point in settings.mesh.FemMesh.Nodes.values()) - 11) < 1e-9 and settings.mesh.Status == "up to date"
    wait_for(lambda: not settings._estimate_timer.isActive() and not settings._estimate.is_alive())
    spin()
    mesh, name = settings.mesh, settings.mesh.Name
    before, estimated = settings.result.text(), settings.estimate.text()
    document.openTransaction("Thicker")
    document.getObject("Plate").Length = 12
    document.recompute()
    document.commitTransaction()
    wait_for(lambda: settings.estimate.text() != estimated)
    assert settings.result.text() != before and "%d nodes" % mesh.NodeCount in settings.result.text(), (before, settings.result.text())
    document.undo()
    wait_for(lambda: settings.estimate.text() == estimated)
    assert "%d nodes" % mesh.NodeCount in settings.result.text(), settings.result.text()
    assert mesh.Visibility and not body.Visibility
    document.undo()
    spin()
    assert document.getObject(name) is None and not Gui.Control.activeDialog() and body.Visibility
    picture("undone")
    document.redo()
    spin()
    assert document.getObject(name).Visibility and not body.Visibility
    body.Tip.Visibility, body.Visibility = False, True   # so FreeCAD's panels of patterns leave the tip of a hidden body
    assert body.Tip.Visibility
    body.Visibility = False
    document.removeObject(name)
    spin()
    assert body.Visibility


def check_details(mesh):
    """What is ignored: automatic, a length, off; each is the property's value, and Status says that it was changed."""
    mesh.ViewObject.doubleClicked()
    spin()
    settings = panel("MeshPanel")
    assert settings.details.currentText() == "automatic" and not settings.ignore_below.isVisible()
    settings.details.setCurrentIndex(1)
    spin()
    assert settings.ignore_below.isVisible() and abs(settings.ignore_below.property("rawValue") - 0.06) < 1e-9, settings.ignore_below.property("rawValue")
    assert settings.status.text() == "Status: settings changed, not meshed yet", settings.status.text()
    type_into(settings.ignore_below, "0.05 mm")
    picture("panel_details")
    check_width(settings)
    assert "Traceback" not in report_view(), report_view()
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    assert (mesh.IgnoreBelow.Value, mesh.Status) == (0.05, "up to date"), mesh.IgnoreBelow
    for index, wanted in ((2, -1), (0, 0)):
        mesh.ViewObject.doubleClicked()
        spin()
        settings = panel("MeshPanel")
        assert settings.details.currentIndex() == {0.05: 1, -1: 2}[mesh.IgnoreBelow.Value]
        settings.details.setCurrentIndex(index)
        spin()
        assert not settings.ignore_below.isVisible()
        click_in_panel("Ok")
        wait_for(lambda: not Gui.Control.activeDialog())
        assert (mesh.IgnoreBelow.Value, mesh.Status) == (wanted, "up to date"), mesh.IgnoreBelow


def fields_of(settings):
    """What the fields show."""
    return (round(settings.size.property("rawValue"), 6), settings.min_automatic.isChecked(), settings.order.currentIndex(), settings.dimension.currentIndex(),
            settings.per_circle.value(), settings.across_gap.value(), settings.growth.value(), settings.details.currentText(), settings.automatic.isChecked())


def check_undo_while_open(document, mesh):
    """Settings and the mesh made with them are one step. Undo and redo change the fields of the open panel, too, so that the next Apply does not bring
    back what was undone."""
    mesh.ViewObject.doubleClicked()
    spin()
    settings = panel("MeshPanel")
    before, count = fields_of(settings), mesh.TetCount
    type_into(settings.size, "5 mm")
    click(settings.min_automatic)
    for chooser, index in ((settings.order, 0 if mesh.Order == "2nd" else 1), (settings.dimension, 1), (settings.details, 2)):
        chooser.setCurrentIndex(index)
    for widget, text in ((settings.per_circle, "10"), (settings.across_gap, "1"), (settings.growth, "1.4")):
        type_into(widget, text)
    click(settings.automatic)
    after = fields_of(settings)
    assert all(one != other for one, other in zip(before, after)), (before, after)
    click_in_panel("Apply")
    wait_for(lambda: settings.running is None)
    changed = mesh.TetCount
    Gui.runCommand("Std_Undo")
    spin()
    assert fields_of(settings) == before and mesh.TetCount == count, (before, fields_of(settings))
    wait_for(lambda: settings.status.text() == "Status: up to date")
    Gui.runCommand("Std_Redo")
    spin()
    assert fields_of(settings) == after and mesh.TetCount == changed, (after, fields_of(settings))
    Gui.runCommand("Std_Undo")
    spin()
    mesh.Growth = 1.333   # in the property editor; more digits than the field shows
    wait_for(lambda: settings.growth.text() == "1.33")
    assert "settings changed" in settings.status.text(), settings.status.text()
    settings.growth.setValue(1.3)
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    assert (mesh.Size.Value, mesh.MinSize.Value, mesh.Growth, mesh.TetCount) == (6.0, 0.6, 1.3, count), (mesh.Size, mesh.MinSize, mesh.Growth)


def check_keyboard_and_wheel(mesh):
    """A size can be typed at once. The wheel over a field scrolls the panel and changes no setting, until the field is clicked."""
    Gui.getMainWindow().activateWindow()
    wait_for(Gui.getMainWindow().isActiveWindow)
    mesh.ViewObject.doubleClicked()
    spin()
    settings = panel("MeshPanel")
    before = fields_of(settings)
    assert settings.form.window().focusWidget() is settings.size, settings.form.window().focusWidget()
    turn_wheel(settings.size)
    assert fields_of(settings) == before, fields_of(settings)
    for letter in "7.5":
        send_key(settings.size, 0, QtCore.Qt.NoModifier, letter)
    assert (settings.settings()["Size"], settings.size.property("text")) == (7.5, "7.5 mm"), settings.size.property("text")
    settings.size.setProperty("rawValue", mesh.Size.Value)
    settings.full_button.setFocus()
    before = fields_of(settings)
    for widget in (settings.size, settings.dimension, settings.order, settings.per_circle, settings.across_gap, settings.growth, settings.details):
        turn_wheel(widget)
        assert fields_of(settings) == before and not widget.hasFocus(), (before, fields_of(settings))
    settings.growth.setFocus(QtCore.Qt.MouseFocusReason)   # as a click does
    turn_wheel(settings.growth)
    assert settings.growth.value() > before[6], settings.growth.value()
    click_in_panel("Cancel")


def check_in_sight(settings):
    """How many elements come out, how far the mesher is, *Stop* and the status are above what few people change, for where there is little room."""
    settings.working.show()
    spin()
    for widget in (settings.estimate, settings.working, settings.status):
        assert settings.size.y() < widget.y() < settings.per_circle.y(), (widget, widget.y(), settings.per_circle.y())
    settings.working.hide()


def check_units(mesh):
    """In inches 6 mm are shown as 0.24 in, which are 6.1 mm: the size stays what it is, and what is said has inches, too."""
    FreeCAD.Units.setSchema(3)
    count = mesh.TetCount
    mesh.ViewObject.doubleClicked()
    spin(1)
    settings = panel("MeshPanel")
    assert settings.size.property("text") == "0.24 in" and settings.status.text() == "Status: up to date", settings.status.text()
    settings.size.setProperty("rawValue", 1000.0)
    click_in_panel("Apply")
    wait_for(lambda: settings.running is None)
    assert " in across); try 0." in settings.status.text() and "mm" not in settings.status.text(), settings.status.text()
    settings.size.setProperty("rawValue", 6.0)
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    FreeCAD.Units.setSchema(0)
    assert (mesh.Size.Value, mesh.MinSize.Value, mesh.Status, mesh.TetCount) == (6.0, 0.6, "up to date", count), (mesh.Size, mesh.MinSize, mesh.Status)


def check_numbers(mesh):
    """What a script gave and the panel's boxes round, or do not reach, stays what it is; what is typed counts."""
    mesh.Growth, mesh.ElementsPerCircle, mesh.ElementsAcrossGap = 1.255, 12.5, 25
    mesh.Document.recompute()
    mesh.ViewObject.doubleClicked()
    spin(1)
    settings = panel("MeshPanel")
    assert settings.status.text() == "Status: up to date", settings.status.text()
    settings.growth.setValue(1.5)
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    assert (mesh.Growth, mesh.ElementsPerCircle, mesh.ElementsAcrossGap) == (1.5, 12.5, 25), (mesh.Growth, mesh.ElementsPerCircle, mesh.ElementsAcrossGap)
    mesh.Growth, mesh.ElementsPerCircle, mesh.ElementsAcrossGap = 1.3, 12, 0
    mesh.Document.recompute()


def check_without_part(mesh):
    """The panel says what is missing."""
    from freecad.featuremesh.versions import part_property
    name = part_property(mesh)
    part = getattr(mesh, name)
    setattr(mesh, name, None)
    mesh.ViewObject.doubleClicked()
    spin(1)
    settings = panel("MeshPanel")
    wait_for(lambda: "has no part to mesh" in settings.estimate.text(), 20)
    click_in_panel("Apply")
    wait_for(lambda: settings.running is None)
    assert "has no part to mesh" in settings.status.text(), settings.status.text()
    click_in_panel("Cancel")
    setattr(mesh, name, part)
    mesh.Document.recompute()
    assert mesh.Status == "up to date", mesh.Status


def check_question(document, body, mesh):
    """The part has a mesh: open that, add another one, or neither."""
    before, seen = names(document), []
    for text, check in (("Cancel", lambda: not Gui.Control.activeDialog()), ("Open it", lambda: panel("MeshPanel").mesh is mesh),
                        ("Add another mesh", lambda: panel("MeshPanel").mesh is not mesh)):
        timer = answer_with(text, seen)
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(body)
        Gui.runCommand("FeatureMesh_MeshPart")
        spin()
        assert not timer.isActive() and check(), text
        if Gui.Control.activeDialog():
            click_in_panel("Cancel")
        assert names(document) == before and not document.HasPendingTransaction, text
    assert seen == ["Body has the mesh %s already." % mesh.Label] * 3, seen


def check_analyses(document, body):
    """The active one of several gets the new mesh; one that has a mesh gets no second one."""
    first, second = (ObjectsFem.makeAnalysis(document, name) for name in ("First", "Second"))
    FemGui.setActiveAnalysis(second)
    settings = open_new(body)
    assert second.Group == [settings.mesh] and not first.Group, (first.Group, second.Group)
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    timer = answer_with("Add another mesh", [])
    settings = open_new(body)
    assert not timer.isActive() and settings.mesh not in second.Group + first.Group
    click_in_panel("Cancel")
    for name in [obj.Name for obj in [*second.Group, first, second]]:
        document.removeObject(name)


def choose_in_menu(mesh, text):
    """An entry of the mesh's menu in the tree, where it is selected."""
    Gui.Selection.addSelection(mesh)
    menu = QtGui.QMenu()
    mesh.ViewObject.Proxy.setupContextMenu(mesh.ViewObject, menu)
    next(action for action in menu.actions() if action.text() == text).trigger()
    spin()


def face_of_hole(body):
    return next("Face%d" % (i + 1) for i, face in enumerate(body.Shape.Faces) if face.Surface.TypeId == "Part::GeomCylinder")


def check_shown():
    """Of several parts the only one that is shown is meant where none is selected; of two that are shown one has to be selected."""
    document = FreeCAD.newDocument("Several")
    document.UndoMode = 1
    first, second = (document.addObject("Part::Box", "Box%d" % index) for index in range(2))
    second.Placement.Base.x = 20
    document.recompute()
    for hidden, shown in ((first, second), (second, first)):
        hidden.ViewObject.Visibility, shown.ViewObject.Visibility = False, True
        Gui.Selection.clearSelection()
        Gui.runCommand("FeatureMesh_MeshPart")
        spin()
        assert versions().part_of(panel("MeshPanel").mesh) is shown
        click_in_panel("Cancel")
    second.ViewObject.Visibility = True
    Gui.runCommand("FeatureMesh_MeshPart")
    spin()
    assert not Gui.Control.activeDialog() and "several parts, select one" in window.messages[-1], window.messages[-1]
    FreeCAD.closeDocument(document.Name)


def check_container():
    """All parts of a selected container are meshed; Cancel leaves nothing of that behind, and a second time the mesh is asked about."""
    document = FreeCAD.newDocument("Machine")
    document.UndoMode = 1
    container = document.addObject("App::Part", "Container")
    for index in range(2):
        box = document.addObject("Part::Box", "Box%d" % index)
        box.Placement.Base.z = 10 * index
        container.addObject(box)
    document.recompute()
    before = names(document)
    assert open_new(container).form.isVisible()
    click_in_panel("Cancel")
    assert names(document) == before and not document.HasPendingTransaction, names(document) - before
    settings = open_new(container)
    mesh, part = settings.mesh, versions().part_of(settings.mesh)
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    assert mesh.Status == "up to date" and part.Parts == [document.Box0, document.Box1] and len(part.Shape.Solids) == 2, mesh.Status
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    picture("container")
    seen = []
    timer = answer_with("Cancel", seen)
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(container)
    Gui.runCommand("FeatureMesh_MeshPart")
    spin()
    assert not timer.isActive() and len(seen) == 1 and not document.HasPendingTransaction, seen
    FreeCAD.closeDocument(document.Name)


def check_groups(document, body, mesh):
    """Groups and refinements of clicked faces, or of what is clicked in FEM's panel once the mesh alone was selected; groups follow edits."""
    wall, steps = face_of_hole(body), document.UndoCount
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(document.Name, body.Name, "Hole." + wall)   # as a click into the view
    Gui.runCommand("FeatureMesh_AddGroup")
    spin()
    group, = mesh.MeshGroupList
    assert group.References == [(body, (wall,))], group.References
    assert document.UndoCount == steps + 1 and document.UndoNames[0] == "Add a mesh group", document.UndoNames
    assert Gui.activeDocument().getInEdit().Object is group and body.ViewObject.Visibility
    picture("group")
    click_in_panel("Ok")
    spin()
    assert groups_of(mesh)[group.Name] == groups_of(mesh)[wall] and groups_of(mesh)[group.Name + "_Nodes"] == groups_of(mesh)[wall + "_Nodes"]
    document.getObject("HoleSketch").setDatum("X", FreeCAD.Units.Quantity("23 mm"))
    document.recompute()
    assert groups_of(mesh)[group.Name] and groups_of(mesh)[group.Name] == groups_of(mesh)[face_of_hole(body)]

    Gui.Selection.clearSelection()
    choose_in_menu(mesh, "Add a mesh group")
    group = mesh.MeshGroupList[1]
    assert not group.References and body.ViewObject.Visibility
    add, = [button for button in Gui.getMainWindow().findChildren(QtGui.QPushButton) if button.text() == "Add" and button.isVisible()]
    click(add)
    Gui.Selection.addSelection(document.Name, body.Name, "Hole.Face1")
    spin()
    click_in_panel("Ok")
    assert groups_of(mesh)[group.Name] == groups_of(mesh)["Face1"], group.References

    count = mesh.NodeCount
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(document.Name, body.Name, "Hole.Face1")
    choose_in_menu(mesh, "Add a local size")
    assert mesh.MeshRegionList[0].References == [(body, ("Face1",))]
    click_in_panel("Ok")
    document.recompute()
    assert mesh.NodeCount > count, (count, mesh.NodeCount)
    for obj in [*mesh.MeshGroupList, *mesh.MeshRegionList]:
        document.removeObject(obj.Name)
    document.recompute()


def check_report_view(document, mesh):
    """A failed recompute is one sentence without lines of code; a warning that the last mesh had, too, is not said again."""
    before = len(report_view())
    mesh.Size = 0
    document.recompute()
    spin()
    said = report_view()[before:]
    picture("report_view")
    times = 1 if versions().version() < (1, 0) else 2   # since 1.0 FreeCAD itself prints the same line twice
    assert 1 <= said.count("%s: the size has to be greater than 0 mm" % mesh.Label) <= times and "Traceback" not in said and "File" not in said and "class" not in said, said
    mesh.Size = 6
    document.recompute()
    before = len(report_view())
    warned = {**json.loads(mesh.Report), "warnings": ["one that is known"]}
    for repetition in range(2):
        with mock.patch.object(type(mesh.Proxy), "_report_with_references", lambda proxy, mesh, job: dict(warned)):
            mesh.Proxy.update(mesh)
    spin()
    assert report_view()[before:].count("one that is known") == 1, report_view()[before:]


def check_solving(document, body, mesh):
    """A mesh that does not fit the part is solved neither by FEM's command nor by CalculiX's panel, which say why; an old result is marked in the tree."""
    from test_document_solving import STEEL, analysis_of
    analysis = analysis_of(document, body, [("Steel", STEEL, [])])
    Gui.activateWorkbench("FemWorkbench")
    FemGui.setActiveAnalysis(analysis)
    analysis.addObject(mesh)
    document.recompute()
    result = ObjectsFem.makeResultMechanical(document, "CCX_Results")
    analysis.addObject(result)
    solver = document.getObject("Solver")
    mesh.Automatic = False
    document.getObject("HoleSketch").setDatum("X", FreeCAD.Units.Quantity("24 mm"))
    document.recompute()
    assert result.Label.endswith(" (before the last edit)"), result.Label
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(solver)
    Gui.runCommand("FEM_SolverRun")
    spin()
    assert "out of date" in window.messages[-1] and "update it before solving" in window.messages[-1], window.messages
    assert result in analysis.Group
    seen = []
    solver.ViewObject.doubleClicked()
    spin()
    write, = [button for button in Gui.getMainWindow().findChildren(QtGui.QPushButton) if button.text().lower().startswith("write") and button.isVisible()]
    timer = answer_with("OK", seen)
    click(write)
    wait_for(lambda: seen)
    assert "out of date" in seen[0] and not timer.isActive(), seen
    picture("refused")
    Gui.activeDocument().resetEdit()
    spin()
    mesh.Automatic = True
    Gui.Selection.clearSelection()
    Gui.runCommand("FeatureMesh_UpdateNow")
    spin()
    assert mesh.Status == "up to date" and result.Label.endswith(" (before the last edit)"), (mesh.Status, result.Label)
    picture("old_result")
    document.undo()


def versions():
    from freecad.featuremesh import versions as module
    return module


def drive():
    from parts import plate_with_hole
    window.choose_workbench()
    document = FreeCAD.newDocument("Panel")
    document.UndoMode = 1
    body = plate_with_hole(document)
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    check_cancel(document, document.getObject("HoleSketch"))
    check_analyses(document, body)
    check_edit_while_open(document, body)
    mesh = check_apply_and_ok(document, body)
    check_details(mesh)
    check_undo_while_open(document, mesh)
    check_keyboard_and_wheel(mesh)
    check_units(mesh)
    check_numbers(mesh)
    check_without_part(mesh)
    check_question(document, body, mesh)
    check_errors(document, body)
    check_report_view(document, mesh)
    document.clearUndos()   # FreeCAD counts no more than twenty steps
    check_groups(document, body, mesh)
    check_solving(document, body, mesh)
    check_shown()
    check_container()
    figures.append("panel: as other panels of FreeCAD")


window.run(drive)

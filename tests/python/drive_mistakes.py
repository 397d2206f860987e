# SPDX-License-Identifier: GPL-3.0-or-later
"""What a person selects wrongly, or not at all, before a command: each says what to do, or takes what is meant. Run by test_window.py."""
import contextlib
import os
import sys
import threading
from unittest import mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FemGui  # noqa: E402
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import Mesh  # noqa: E402
import ObjectsFem  # noqa: E402
import window  # noqa: E402
from PySide import QtCore, QtGui  # noqa: E402
from window import answer_with, click_in_panel, double_click, figures, item_of_tree, panel, picture, press_at, send_key, spin, wait_for  # noqa: E402


def select(*entries):
    Gui.Selection.clearSelection()
    for entry in entries:
        Gui.Selection.addSelection(*entry)


def run_command(name):
    Gui.runCommand("FeatureMesh_" + name)
    spin()


def close_panel():
    """Whatever it is, by its button."""
    for name in ("Cancel", "Close", "Ok"):
        if window.button_in_panel(name) is not None:
            click_in_panel(name)
            wait_for(lambda: not Gui.Control.activeDialog(), 20)
            return


def said_by(name):
    """What the command tells, in one message box; it opens no panel."""
    count = len(window.messages)
    run_command(name)
    assert len(window.messages) == count + 1 and not Gui.Control.activeDialog(), (name, window.messages[count:])
    return window.messages[-1]


def check_which_part(document, first, second):
    """Of two parts that are selected neither is meshed in silence."""
    before = len(document.Objects)
    select((first,), (second,))
    for name in ("MeshPart", "Study", "ShowTree", "Compare"):
        assert said_by(name).startswith("Several parts are selected, select one, or the container of those to mesh: Box (Links), Box001 (Größe"), window.messages[-1]
    assert len(document.Objects) == before and not document.HasPendingTransaction
    select((second, "Face1"), (second, "Edge2"))   # which are of one
    run_command("MeshPart")
    assert panel("MeshPanel").mesh.Document is document
    close_panel()


def check_triangles(document):
    """Of a selected STL mesh it is said what to make of it; the only part is not meshed in its place."""
    triangles = document.addObject("Mesh::Feature", "Stl")
    triangles.Mesh = Mesh.createBox(5, 5, 5)
    select((triangles,))
    assert said_by("MeshPart").startswith("Stl consists of triangles; make a solid of it"), window.messages[-1]
    document.removeObject("Stl")


def check_which_mesh(document, meshes, second):
    """Of several meshes that of the clicked face is meant; where nothing is clicked it is asked for."""
    select()
    for name in ("UpdateNow", "AddLocalSize", "AddSizeZone", "AddGroup", "ShowKept", "ShowQuality", "Export"):
        assert said_by(name).startswith("The document has several meshes, select one"), (name, window.messages[-1])
    assert [mesh.Status for mesh in meshes] == ["up to date"] * 2
    select((second, "Face1"))
    run_command("AddLocalSize")
    assert [len(mesh.MeshRegionList) for mesh in meshes] == [0, 1]
    close_panel()
    select((second, "Face1"))
    run_command("ShowQuality")
    assert panel("QualityPanel").mesh is meshes[1]
    picture("quality_of_the_clicked")
    close_panel()


def check_by_hand(document):
    """A new mesh that is not to be updated automatically: the part is edited while its panel is open, and the first size is refused."""
    from freecad.featuremesh import preferences
    part = document.addObject("Part::Box", "Third")
    document.recompute()
    preferences.put("Automatic", False)
    select((part,))
    run_command("MeshPart")
    settings = panel("MeshPanel")
    part.Length = 12
    document.recompute()
    assert settings.mesh.Status == "not meshed yet", settings.mesh.Status
    settings.size.setProperty("rawValue", 1000.0)
    click_in_panel("Apply")
    wait_for(lambda: settings.running is None)
    assert "failed" in settings.status.text(), settings.status.text()
    check_theme(settings)
    settings.size.setProperty("rawValue", 3.0)
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    mesh = document.getObject("FeatureMesh002")
    assert (mesh.Status, mesh.Automatic, mesh.TetCount > 0) == ("up to date", False, True), (mesh.Status, mesh.Automatic, mesh.TetCount)
    preferences.put("Automatic", True)


def check_theme(settings):
    """In a dark theme, whose texts are bright, so is the red of a failure."""
    application = QtGui.QApplication.instance()
    before, seen = application.styleSheet(), []
    for sheet in ("QLabel {color: #f0f0f0}", "QLabel {color: #101010}"):
        application.setStyleSheet(sheet)
        settings._show_status()
        seen.append(settings.status.palette().color(QtGui.QPalette.WindowText).lightness())
    application.setStyleSheet(before)
    assert seen[0] > seen[1] + 50, seen


def check_what_has_no_part(document, body, mesh):
    """Loads, groups, results and studies have no part of their own: they are no reason to refuse the only one that there is."""
    group = mesh.Proxy and ObjectsFem.makeMeshGroup(document, mesh)
    for obj in (group, document.Analysis, document.addObject("Spreadsheet::Sheet", "Table")):
        timer = answer_with("Open it", [])
        select((obj,))
        run_command("MeshPart")
        assert not timer.isActive(), obj.Name
        wait_for(Gui.Control.activeDialog, 10)
        spin(0.5)   # FreeCAD 1.1 shows the panel a little later
        assert panel("MeshPanel").mesh is mesh, obj.Name
        close_panel()
        select((obj,))
        run_command("Study")
        assert panel("StudyPanel").study.Part is body, obj.Name
        close_panel()


def kept_study(part):
    """A new study of the part that stays, because something of it was set."""
    select((part,))
    run_command("Study")
    shown = panel("StudyPanel")
    shown.cases.setValue(shown.cases.value() + 1)
    close_panel()
    return shown.study


def check_which_study(body, other):
    """A part that has no study gets one; what is selected of a part with a study opens that."""
    first, second = kept_study(body), kept_study(other)
    assert second is not first and (first.Part, second.Part) == (body, other), (first.Part, second.Part)
    assert "Touched" not in second.State
    for selected, wanted in (((other, "Face1"), second), ((first.Part, "Face1"), first), ((first,), first), (None, first)):
        select(*([selected] if selected else []))
        run_command("Study")
        assert panel("StudyPanel").study is wanted, (selected, panel("StudyPanel").study.Name)
        close_panel()


def check_unreadable_parameter(body):
    """The panel opens, keeps what cannot be read, and says so when it runs."""
    study = next(obj for obj in body.Document.Objects if hasattr(obj, "SecondsLimit") and obj.Part is body)
    study.Parameters, study.Responses = ["HoleSketch.Radius"], ["mass"]
    select((study,))
    run_command("Study")
    shown = panel("StudyPanel")
    shown.cases.setValue(shown.cases.value() + 1)
    assert list(study.Parameters) == ["HoleSketch.Radius"], study.Parameters
    window.click(shown.run_button)
    assert "Cannot read 'HoleSketch.Radius'" in window.messages[-1] and not study.Folder, window.messages[-1]
    close_panel()


def check_which_analysis(document, body):
    """Of several analyses the active one is solved; where none is active one has to be selected."""
    second = ObjectsFem.makeAnalysis(document, "Second")
    FemGui.setActiveAnalysis()
    select()
    assert "several analyses, select one" in said_by("LiveResult"), window.messages[-1]
    FemGui.setActiveAnalysis(second)
    with contextlib.suppress(AttributeError):   # FreeCAD 0.20 does not let it be set
        Gui.ActiveDocument.Modified = False
    is_changed = Gui.ActiveDocument.Modified
    assert "needs one mesh of FeatureMesh in the analysis Second" in said_by("LiveResult"), window.messages[-1]
    assert Gui.ActiveDocument.Modified == is_changed and not second.Group, second.Group
    select((document.Analysis,))
    run_command("LiveResult")
    assert panel("LivePanel").live in document.Analysis.Group
    close_panel()


def check_result_without_material():
    """A live result that was never solved shows nothing: the mesh is seen again after FEM's panel of a material, and after its own."""
    from freecad.featuremesh import api, engine
    document = FreeCAD.newDocument("NoMaterial")
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    material = ObjectsFem.makeMaterialSolid(document, "Material")
    material.Material = {}
    analysis.addObject(material)
    mesh = api.add_mesh(box, 5.0)
    document.recompute()
    FemGui.setActiveAnalysis(analysis)
    box.ViewObject.Visibility = False
    run_command("LiveResult")
    close_panel()
    for obj in (material, mesh):
        Gui.activeDocument().setEdit(obj.Name)
        spin()
        if obj is mesh:
            window.type_into(panel("MeshPanel").size, "4 mm")
        click_in_panel("Ok")
        wait_for(lambda: not Gui.Control.activeDialog(), 20)
        spin(0.5)
        assert mesh.ViewObject.Visibility and not box.ViewObject.Visibility, obj.Name
    if not engine.load().statics_missing():
        check_result_is_seen_with_what_was_missing(document, material, mesh)
    FreeCAD.closeDocument(document.Name)


def check_result_is_seen_with_what_was_missing(document, material, mesh):
    """Also where nothing is drawn of it while FEM's panel of a support asks for faces, and the mesh is shown meanwhile."""
    from statics_cases import STEEL
    live = document.Live
    material.Material = STEEL
    document.recompute()
    wait_for(lambda: "add a support" in live.Status and not mesh.ViewObject.Visibility, 30)
    Gui.runCommand("FEM_ConstraintFixed")
    spin(0.5)
    window.click(next(button for button in Gui.getMainWindow().findChildren(QtGui.QToolButton) if button.objectName() == "btnAdd" and button.isVisible()))
    select((document.Box, "Face6"))
    spin(0.5)
    click_in_panel("Ok")
    wait_for(lambda: live.Status == "up to date", 30)
    spin(0.5)
    assert live.ViewObject.Visibility and not mesh.ViewObject.Visibility
    for change, is_seen in ((document.Analysis.removeObject, True), (document.Analysis.addObject, False)):   # as dragged in the tree
        change(mesh)
        document.recompute()
        wait_for(lambda: (live.Status != "up to date") == is_seen, 30)
        spin(0.5)
        assert mesh.ViewObject.Visibility == is_seen
    material.Material = {}
    document.recompute()
    wait_for(lambda: "Material" in live.Status, 30)
    document.removeObject(mesh.Name)
    document.recompute()
    wait_for(lambda: "Material" not in live.Status, 30)
    assert live.ViewObject.Proxy.drawn is None   # the part is seen


def check_mesh_of_another_maker():
    """The analysis has Gmsh's mesh: ours takes its place with what belongs to it, or leaves it there; undo and Cancel bring it back."""
    document = FreeCAD.newDocument("Gmsh")
    document.UndoMode = 1
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    theirs = ObjectsFem.makeMeshGmsh(document, "Gmsh")
    region, group = ObjectsFem.makeMeshRegion(document, theirs, 0.5), ObjectsFem.makeMeshGroup(document, theirs)
    region.References, group.References = [(box, "Face1")], [(box, "Face2")]
    theirs.CharacteristicLengthMax, theirs.ElementOrder = 2.5, "1st"
    analysis.addObject(theirs)
    document.recompute()
    seen = []
    for text, button, members in (("Cancel", None, [theirs]), ("Leave it there", "Cancel", [theirs]), ("Take its place", "Cancel", [theirs]),
                                  ("Take its place", "Ok", None)):
        timer = answer_with(text, seen)
        select((box,))
        run_command("MeshPart")
        assert not timer.isActive() and bool(Gui.Control.activeDialog()) == (text != "Cancel"), text
        picture("mesh_of_another_maker")
        if button:
            mesh = panel("MeshPanel").mesh
            click_in_panel(button)
            wait_for(lambda: not Gui.Control.activeDialog())
        assert analysis.Group == (members or [mesh]), (text, button, analysis.Group)
    assert seen == ["Analysis has the mesh Gmsh, and an analysis is solved with one mesh."] * 4, seen
    assert (mesh.Size.Value, mesh.Order, mesh.MeshRegionList, mesh.MeshGroupList) == (2.5, "1st", [region], [group])
    assert (mesh.Status, theirs.ViewObject.Visibility) == ("up to date", False), mesh.Status
    groups = [mesh.FemMesh.getGroupName(number) for number in mesh.FemMesh.Groups]
    assert any(name.startswith(group.Name) for name in groups), groups
    Gui.runCommand("Std_Undo")
    spin()
    assert analysis.Group == [theirs] and not document.getObject("FeatureMesh"), analysis.Group
    FreeCAD.closeDocument(document.Name)


def check_part_deleted(document, mesh):
    """The panel and the commands of a mesh without its part say so; undo brings it back."""
    document.openTransaction("Delete")
    document.removeObject("Box")
    FreeCAD.ActiveDocument.commitTransaction()
    for name in ("UpdateNow", "AddLocalSize", "AddSizeZone", "AddGroup"):
        select((mesh,))
        assert "has no part to mesh, set its property" in said_by(name), window.messages[-1]
    mesh.ViewObject.doubleClicked()
    spin()
    settings = panel("MeshPanel")
    click_in_panel("Apply")
    wait_for(lambda: "has no part to mesh, set its property" in settings.estimate.text() and "has no part to mesh" in settings.status.text(), 20)
    close_panel()
    Gui.runCommand("Std_Undo")
    spin()
    document.recompute()
    assert mesh.Status == "up to date", mesh.Status


def check_adopted_beside_ours(document, analysis, mesh):
    """The part of an adopted mesh has one of ours: the adopted one takes its place in the analysis, or nothing is done; undo brings both back."""
    theirs = document.addObject("Fem::FemMeshObject", "Theirs")
    theirs.FemMesh = mesh.FemMesh
    analysis.addObject(theirs)
    before, seen = set(document.Objects), []
    for text in ("Cancel", "Take its place"):
        assert set(document.Objects) == before and {mesh, theirs} < set(analysis.Group), analysis.Group
        timer = answer_with(text, seen)
        select((theirs,))
        run_command("Adopt")
        assert not timer.isActive()
    adopted, = set(document.Objects) - before
    assert seen == ["Body has the mesh FeatureMesh already."] * 2, seen
    assert adopted in analysis.Group and not {mesh, theirs} & set(analysis.Group), analysis.Group
    assert adopted.TetCount == mesh.TetCount and [obj.ViewObject.Visibility for obj in (adopted, mesh, theirs)] == [True, False, False]
    Gui.runCommand("Std_Undo")
    spin()
    assert set(document.Objects) == before and {mesh, theirs} < set(analysis.Group), analysis.Group
    document.removeObject(theirs.Name)


def check_expression(document, mesh):
    """What an expression drives is not typed in the panel, where it would be another value again after the next edit; the rest is."""
    mesh.setExpression("Size", "2 * 4")
    document.recompute()
    mesh.ViewObject.doubleClicked()
    spin()
    settings = panel("MeshPanel")
    assert not settings.size.isEnabled() and "2 * 4" in settings.size.toolTip() and settings.growth.isEnabled(), settings.size.toolTip()
    settings.growth.setValue(1.5)
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    assert (mesh.Size.Value, mesh.Growth, mesh.Status) == (8, 1.5, "up to date"), (mesh.Size, mesh.Growth, mesh.Status)
    mesh.setExpression("Size", None)


@contextlib.contextmanager
def mesher_waits():
    """A mesh that a panel begins within is done after that, however fast the mesher is."""
    from freecad.featuremesh.job import MeshJob
    may_end, as_it_is = threading.Event(), MeshJob.run

    def run(job, progress=None):
        if threading.current_thread() is not threading.main_thread() and waits:
            may_end.wait()
        return as_it_is(job, progress)
    waits = [True]
    with mock.patch.object(MeshJob, "run", run):
        try:
            yield waits
        finally:
            may_end.set()


def check_overtaken(document, mesh):
    """The part is edited, or what was set is undone, while the panel's mesh is being made: that is not taken for the mesh of the part as it is."""
    from freecad.featuremesh import versions
    part = document.Plate
    for size, height, automatic in ((5.0, 12, True), (5.5, 14, False), (6.0, 10, True)):
        mesh.ViewObject.doubleClicked()
        spin()
        settings = panel("MeshPanel")
        settings.size.setProperty("rawValue", size)
        settings.automatic.setChecked(automatic)
        with mesher_waits() as waits:
            click_in_panel("Apply")
            assert settings.running is not None
            waits.clear()   # what the recompute itself begins
            part.Length = height
            document.recompute()
        wait_for(lambda: settings.running is None)
        assert (mesh.Size.Value, mesh.Status) == (size, "up to date") and abs(mesh.FemMesh.BoundBox.ZMax - height) < 1e-9, (mesh.Status, mesh.FemMesh.BoundBox)
        assert not settings.working.isVisible()
        close_panel()
    count = mesh.TetCount
    mesh.ViewObject.doubleClicked()
    spin()
    settings = panel("MeshPanel")
    settings.size.setProperty("rawValue", 3.0)
    with mesher_waits():
        click_in_panel("Apply")
        Gui.runCommand("Std_Undo")
    wait_for(lambda: settings.running is None)
    assert (mesh.Size.Value, mesh.TetCount, mesh.Status) == (6.0, count, "up to date"), (mesh.Size, mesh.TetCount, mesh.Status)
    with mesher_waits():
        settings.size.setProperty("rawValue", 4.0)
        click_in_panel("Apply")
        setattr(mesh, versions.part_property(mesh), None)
    wait_for(lambda: settings.running is None)
    assert "has no part to mesh" in settings.status.text(), settings.status.text()
    close_panel()
    setattr(mesh, versions.part_property(mesh), document.Body)
    mesh.Size = 6
    document.recompute()


def check_overtaken_while_new(document, body):
    """A recompute makes the mesh of a new object before its panel's is done: as after any *Apply*, Cancel leaves the mesh there, and the edit."""
    select((body,))
    timer = answer_with("Add another mesh", [])
    run_command("MeshPart")
    assert not timer.isActive()
    settings, part = panel("MeshPanel"), document.Plate
    settings.size.setProperty("rawValue", 7.0)
    with mesher_waits() as waits:
        click_in_panel("Apply")
        waits.clear()
        part.Length = 13
        document.recompute()
    wait_for(lambda: settings.running is None)
    mesh = settings.mesh
    assert mesh.ViewObject.Visibility and not body.ViewObject.Visibility
    close_panel()
    assert mesh in document.Objects and (mesh.Status, mesh.Size.Value, part.Length.Value) == ("up to date", 7, 13), part.Length
    assert not document.HasPendingTransaction
    Gui.runCommand("Std_Undo")
    assert "FeatureMesh001" not in [obj.Name for obj in document.Objects]


def check_name_not_changed(document, part, mesh):
    """FreeCAD leaves a step of undo open where a name in the tree was to be changed and was not. What is done next is in it, and stays when the panel opens."""
    Gui.getMainWindow().activateWindow()
    wait_for(Gui.getMainWindow().isActiveWindow)
    tree, place = item_of_tree(part.Label)
    press_at(tree, place)
    send_key(tree.parent(), QtCore.Qt.Key_F2)
    wait_for(lambda: isinstance(QtGui.QApplication.focusWidget(), QtGui.QLineEdit), 10)
    Gui.getMainWindow().centralWidget().setFocus()   # as a click there
    spin()
    assert FreeCAD.getActiveTransaction() is not None
    height = part.Height.Value + 1
    part.Height = height
    document.recompute()
    double_click(*item_of_tree(mesh.Label))
    wait_for(Gui.Control.activeDialog)
    spin()
    assert part.Height.Value == height and panel("MeshPanel").mesh is mesh, part.Height
    close_panel()
    document.undo()
    document.recompute()
    assert part.Height.Value == height - 1, part.Height


def check_frozen(document, part, mesh):
    """A script sets the length of a part that FreeCAD's command froze: the shape changes, and FreeCAD asks for no recompute."""
    select((part,))
    Gui.runCommand("Std_ToggleFreeze")
    part.Length = 30
    assert (part.Shape.BoundBox.XMax, part.State) == (30, ["Up-to-date"]), (part.Shape.BoundBox.XMax, part.State)
    assert "is out of date" in mesh.Proxy.why_not_to_solve(mesh)
    document.recompute()
    assert (mesh.Status, mesh.FemMesh.BoundBox.XMax, mesh.Proxy.why_not_to_solve(mesh)) == ("up to date", 30, ""), mesh.Status
    select((part,))
    Gui.runCommand("Std_ToggleFreeze")
    document.recompute()
    assert mesh.Status == "up to date", mesh.Status


def drive():
    from freecad.featuremesh import api, engine, versions
    from analyses import add_material
    from parts import plate_with_hole
    from statics_cases import STEEL
    window.choose_workbench()
    two = FreeCAD.newDocument("Two")
    two.UndoMode = 1
    first, second = two.addObject("Part::Box", "Box"), two.addObject("Part::Box", "Box")
    first.Label, second.Label = "Links", "Größe äß"
    second.Placement.Base.x = 20
    two.recompute()
    check_which_part(two, first, second)
    meshes = [api.add_mesh(part, 4.0, order=1) for part in (first, second)]
    two.recompute()
    check_which_mesh(two, meshes, second)
    check_by_hand(two)
    check_part_deleted(two, meshes[0])
    check_name_not_changed(two, two.Box, two.FeatureMesh)
    if versions.version() >= (1, 1):   # 1.0 tells nobody what is frozen
        check_frozen(two, two.Box, two.FeatureMesh)
    FreeCAD.closeDocument(two.Name)
    check_result_without_material()
    check_mesh_of_another_maker()
    document = FreeCAD.newDocument("Mistakes")
    document.UndoMode = 1
    body = plate_with_hole(document)
    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    add_material(document, analysis, "Steel", STEEL)
    mesh = api.add_mesh(body, 6.0, order=1)
    document.recompute()
    check_triangles(document)
    check_what_has_no_part(document, body, mesh)
    check_adopted_beside_ours(document, analysis, mesh)
    check_expression(document, mesh)
    check_overtaken(document, mesh)
    check_overtaken_while_new(document, body)
    other = document.addObject("Part::Box", "Other")
    other.Placement.Base.z = 50
    document.recompute()
    check_which_study(body, other)
    check_unreadable_parameter(body)
    if not engine.load().statics_missing():
        check_which_analysis(document, body)
    figures.append("mistakes: each is told, or what is meant is taken")


window.run(drive)

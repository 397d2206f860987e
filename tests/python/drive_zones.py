# SPDX-License-Identifier: GPL-3.0-or-later
"""A refinement zone by hand: its command, its panel and what the 3D view shows of it. Run by test_window.py."""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import numpy as np  # noqa: E402
import ObjectsFem  # noqa: E402
import window  # noqa: E402
from analyses import held_and_pushed  # noqa: E402
from PySide import QtCore, QtGui  # noqa: E402
from parts import new_document, plate_with_hole  # noqa: E402
from pivy import coin  # noqa: E402
from window import click, click_button_of, click_in_panel, is_whole, panel, picture, pixels, report_view, spin, type_into, wait_for  # noqa: E402


def orange_pixels():
    """How much of the 3D view has the colour of zones."""
    seen = pixels()
    return int(np.count_nonzero((seen[:, :, 0] > seen[:, :, 2] + 40) & (seen[:, :, 0] > seen[:, :, 1] + 15)))


def settle_view():
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    spin(1)


def open_with(*selected):
    Gui.Selection.clearSelection()
    for entry in selected:
        Gui.Selection.addSelection(*entry)
    spin()
    click_button_of("FeatureMesh_AddSizeZone")
    wait_for(lambda: Gui.Control.activeDialog())
    spin()
    return panel("ZonePanel")


def open_again(zone):
    zone.ViewObject.doubleClicked()
    spin()
    return panel("ZonePanel")


def check_kinds(mesh):
    """Every kind is in the middle of the part, also when it is chosen after another; the fields say where that puts it."""
    settings = open_with((mesh,))
    middle, zone = mesh.FemMesh.BoundBox.Center, settings.zone
    for kind in (1, 2, 3, 1, 0, 3, 2, 0):   # box, sphere, cylinder, distance
        settings.kind.setCurrentIndex(kind)
        spin()
        corner = {0: (zone.Length.Value / 2, zone.Width.Value / 2, zone.Height.Value / 2), 2: (0, 0, zone.Height.Value / 2)}.get(kind, (0, 0, 0))
        assert (zone.Placement.Base + FreeCAD.Vector(*corner) - middle).Length < 1e-6, (zone.Kind, zone.Placement, middle)
        shown = [widget.property("rawValue") for widget in settings.place]
        assert (FreeCAD.Vector(*shown) - zone.Placement.Base).Length < 0.02, (zone.Kind, shown)   # fields round
    click_in_panel("Cancel")


def check_cancel(document, mesh):
    document.recompute()
    names, steps = {obj.Name for obj in document.Objects}, document.UndoCount
    settings = open_with((mesh,))
    assert settings.zone in mesh.MeshRegionList and settings.zone.Kind == "Box"
    picture("zone_new")
    assert orange_pixels() > 5000, orange_pixels()
    said, field = report_view(), settings.lengths["Length"].findChild(QtGui.QLineEdit)
    type_into(field, "-3")
    click_in_panel("Cancel")
    assert "Traceback" not in report_view()[len(said):], report_view()
    assert {obj.Name for obj in document.Objects} == names and document.UndoCount == steps and not document.HasPendingTransaction
    assert not mesh.MeshRegionList and not Gui.Control.activeDialog()
    assert "Touched" not in mesh.State   # there is nothing to recompute


def check_sphere(document, mesh):
    """Chosen in the panel, drawn at once, meshed by OK, as one step of undo."""
    count, steps = mesh.TetCount, document.UndoCount
    settings = open_with((mesh,))
    settings.kind.setCurrentIndex(1)
    spin()
    assert settings.lengths["Radius"].isVisible() and not settings.lengths["Width"].isVisible() and not settings.references.isVisible()
    for widget, value in ((settings.place[0], 45.0), (settings.place[1], 20.0), (settings.place[2], 10.0),
                          (settings.lengths["Radius"], 7.0), (settings.lengths["InnerSize"], 1.0)):
        widget.setProperty("rawValue", value)
    small = orange_pixels()
    zone = settings.zone
    assert (zone.Kind, zone.Radius.Value, zone.InnerSize.Value, tuple(zone.Placement.Base)) == ("Sphere", 7.0, 1.0, (45.0, 20.0, 10.0))
    settings.lengths["Radius"].setProperty("rawValue", 12.0)
    assert orange_pixels() > 1.5 * small, (orange_pixels(), small)
    picture("zone_panel")
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    assert mesh.Status == "up to date" and mesh.TetCount > 1.5 * count, (mesh.Status, mesh.TetCount, count)
    assert document.UndoCount == steps + 1 and not document.HasPendingTransaction, document.UndoNames
    spin(0.5)
    picture("zone_meshed")
    document.undo()
    spin()
    assert not mesh.MeshRegionList and mesh.TetCount == count
    document.redo()
    spin()
    assert mesh.MeshRegionList and mesh.TetCount > 1.5 * count


def check_double_click(document, mesh):
    zone, = mesh.MeshRegionList
    document.recompute()
    count = mesh.TetCount
    settings = open_again(zone)
    settings.lengths["InnerSize"].setProperty("rawValue", 0.5)
    click_in_panel("Cancel")
    assert zone.InnerSize.Value == 1.0 and not document.HasPendingTransaction
    assert not {"Touched"} & {*zone.State, *mesh.State}, (zone.State, mesh.State)
    settings = open_again(zone)
    click(settings.suppressed)
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    assert zone.Suppressed and mesh.TetCount < 0.7 * count, (zone.Suppressed, mesh.TetCount, count)


def check_deleted(document, mesh):
    """FreeCAD does not say that the mesh might break, but of the part it does."""
    zone, = mesh.MeshRegionList
    asked = window.delete(zone)
    assert not asked and not mesh.MeshRegionList, asked
    document.undo()
    spin()
    assert mesh.MeshRegionList
    asked, = window.delete(document.Body)
    assert mesh.Label in asked, asked
    document.undo()
    document.recompute()
    spin()
    assert mesh.Status == "up to date", mesh.Status


def check_local_size(document, body, mesh):
    """FEM's own refinement of a face and what its panel's OK meshes are one step of undo, too."""
    count, steps = mesh.TetCount, document.UndoCount
    body.ViewObject.Visibility = False
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(body, "Face1")
    click_button_of("FeatureMesh_AddLocalSize")
    wait_for(Gui.Control.activeDialog)
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    finer = mesh.TetCount
    assert mesh.ViewObject.Visibility and not body.ViewObject.Visibility   # as it was before
    body.ViewObject.Visibility = True
    assert finer > 1.2 * count and document.UndoCount == steps + 1 and not document.HasPendingTransaction, (count, finer, document.UndoNames)
    for command, regions, tets in (("Std_Undo", 0, count), ("Std_Redo", 1, finer), ("Std_Undo", 0, count)):
        Gui.runCommand(command)
        spin()
        assert (len(mesh.MeshRegionList), mesh.TetCount, mesh.Status) == (regions, tets, "up to date"), (command, mesh.TetCount, finer, count)


def check_nothing_selected(body, mesh):
    """The faces are chosen in the panel: the part, which may be hidden, is seen while it is open."""
    body.ViewObject.Visibility = False
    for command, name in (("FeatureMesh_AddLocalSize", "MeshRegionList"), ("FeatureMesh_AddGroup", "MeshGroupList")):
        Gui.Selection.clearSelection()
        click_button_of(command)
        wait_for(Gui.Control.activeDialog)
        added, = getattr(mesh, name)
        assert body.ViewObject.Visibility and not added.References, added.References
        click_in_panel("Cancel")
        wait_for(lambda: not Gui.Control.activeDialog())
        for left in getattr(mesh, name):   # by the panels of FreeCAD 0.20
            mesh.Document.removeObject(left.Name)
        mesh.Document.recompute()
    body.ViewObject.Visibility = True


def check_distance(document, body, mesh):
    """With a face selected it is measured from that; others are taken while the panel is open."""
    hole = next(i for i, face in enumerate(body.Shape.Faces, 1) if face.Surface.TypeId == "Part::GeomCylinder")
    settings = open_with((body, "Face%d" % hole))
    assert settings.zone.Kind == "Distance" and settings.references.text() == "Face%d" % hole and not settings.place[0].isVisible()
    settings.lengths["InnerSize"].setProperty("rawValue", 1.2)
    settings.lengths["Distance"].setProperty("rawValue", 2.0)
    picture("zone_distance")
    assert orange_pixels() > 300, orange_pixels()
    Gui.Selection.clearSelection()
    click(settings.choose)   # nothing is selected
    assert "Select faces" in window.messages[-1] and settings.references.text() == "Face%d" % hole, window.messages
    for number in range(1, 13):
        Gui.Selection.addSelection(body, "Edge%d" % number)
    click(settings.choose)
    picture("zone_of_many")
    assert is_whole(settings.form), settings.form.width()
    assert settings.references.text() == "Edge1, Edge2, Edge3, Edge4, Edge5, Edge6 and 6 more", settings.references.text()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(body, "Edge1")
    Gui.Selection.addSelection(body, "Vertex1")
    click(settings.choose)
    assert settings.references.text() == "Edge1, Vertex1", settings.references.text()
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    assert mesh.Status == "up to date", mesh.Status


def check_distance_in_a_container():
    """The face from which it is measured is drawn over the mesh."""
    from freecad.featuremesh import api
    document = new_document("Placed")
    container, box = document.addObject("App::Part", "Part"), document.addObject("Part::Box", "Box")
    container.addObject(box)
    container.Placement.Base.x = 100
    document.recompute()
    mesh = api.add_mesh(box, 5, order=1)
    zone = api.add_size_zone(mesh, "Distance", ["Face1"])   # its smallest x
    document.recompute()
    measured = coin.SoGetBoundingBoxAction(coin.SbViewportRegion(100, 100))
    measured.apply(zone.ViewObject.RootNode)
    drawn = measured.getBoundingBox()   # what it gives is gone with it
    assert abs(drawn.getMax()[0] - mesh.FemMesh.BoundBox.XMin) < 1e-5, (drawn.getMax().getValue(), mesh.FemMesh.BoundBox)
    FreeCAD.closeDocument(document.Name)


def check_dragged(document, body, mesh):
    """A copy of a zone is in no mesh until it is dragged to one; what a mesh has can be dragged to another, also from FEM's mesh of Gmsh, as FEM's users do."""
    theirs = ObjectsFem.makeMeshGmsh(document, "Gmsh")
    region = ObjectsFem.makeMeshRegion(document, theirs, 1.5)
    region.References = [(body, "Face1")]
    zone, view = mesh.MeshRegionList[0], mesh.ViewObject
    copy = document.copyObject(zone)
    copy.Suppressed = False
    settings = open_again(copy)
    assert "This is in no mesh" in settings.rows.itemAt(0).widget().text() and not settings.choose.isEnabled()
    picture("zone_in_no_mesh")
    click_in_panel("Cancel")
    assert [view.canDropObject(obj) for obj in (copy, region, zone, body)] == [True, True, False, False] and view.canDragObject(zone) and not view.canDragObject(body)
    for obj, source in ((copy, None), (region, theirs)):
        count = mesh.TetCount
        if source is not None:
            source.ViewObject.dragObject(obj)
        view.dropObject(obj)
        document.recompute()
        assert obj in mesh.MeshRegionList and mesh.TetCount > count and mesh.Status == "up to date", (obj.Name, mesh.TetCount, count)
    count = mesh.TetCount
    view.dragObject(copy)
    document.recompute()
    assert copy not in mesh.MeshRegionList and mesh.TetCount < count, (mesh.TetCount, count)


def check_expression(mesh):
    """What an expression drives is not typed in the panel."""
    zone = mesh.MeshRegionList[0]
    for path in ("InnerSize", "Placement.Base.y"):
        zone.setExpression(path, "1.5 mm")
    mesh.Document.recompute()
    settings = open_again(zone)
    closed = [widget for widget in (*settings.place, *settings.lengths.values()) if not widget.isEnabled()]
    assert closed == [settings.place[1], settings.lengths["InnerSize"]] and all("drives this" in widget.toolTip() for widget in closed), closed
    click_in_panel("Cancel")
    for path in ("InnerSize", "Placement.Base.y"):
        zone.setExpression(path, None)


def check_panel_is_open(document, mesh):
    """A double click says that a panel is open, unless it is that of what was clicked."""
    zone, count = mesh.MeshRegionList[0], len(window.messages)
    open_again(zone)
    zone.ViewObject.doubleClicked()
    assert len(window.messages) == count, window.messages
    mesh.ViewObject.doubleClicked()
    assert window.messages[count:] == ["FeatureMesh cannot be opened while a panel is open; close that first"], window.messages
    assert panel("ZonePanel").zone is zone
    click_in_panel("Cancel")


def menu_over(point):
    """The texts of the menu that the right button opens in the 3D view there; it is closed again."""
    from freecad.featuremesh.commands import OF_A_MESH, made
    seen = []

    def look():
        menu = QtGui.QApplication.activePopupWidget()
        if menu is not None:
            seen.extend(action.text() for action in menu.actions())
            menu.close()
    timer = QtCore.QTimer()
    timer.timeout.connect(look)
    timer.start(100)
    window.click_in_view(point)
    widget, place = window.place_in_view(point)
    for kind, pressed in ((QtCore.QEvent.MouseButtonPress, QtCore.Qt.RightButton), (QtCore.QEvent.MouseButtonRelease, QtCore.Qt.NoButton)):
        QtGui.QApplication.postEvent(widget, QtGui.QMouseEvent(kind, QtCore.QPointF(place), QtCore.QPointF(widget.mapToGlobal(place)), QtCore.Qt.RightButton,
                                                               pressed, QtCore.Qt.NoModifier))
        spin(0.1)
    spin(0.5)
    timer.stop()
    return [name for name in OF_A_MESH if made(name).title in seen], seen


def check_right_click(mesh):
    """Over a mesh in the 3D view the menu has what the tree's has, since FreeCAD 1.0 in FEM, too."""
    from freecad.featuremesh import versions
    from freecad.featuremesh.commands import OF_A_MESH
    box = mesh.FemMesh.BoundBox
    for workbench in ("FemWorkbench", "FeatureMeshWorkbench"):
        Gui.activateWorkbench(workbench)
        spin()
        if workbench == "FeatureMeshWorkbench":
            window.open_dialog().close()
        Gui.Selection.clearSelection()
        settle_view()
        found, seen = menu_over(FreeCAD.Vector(box.XMax - 5, box.YMin + 5, box.ZMax))
        wanted = [] if workbench == "FemWorkbench" and not versions.asks_manipulators() else list(OF_A_MESH)
        assert Gui.Selection.getSelection() == [mesh] and sorted(found) == sorted(wanted), (workbench, Gui.Selection.getSelection(), seen)
        found, seen = menu_over(FreeCAD.Vector(box.XMax + 15, box.YMax + 15, box.ZMax))
        assert seen and not found, (workbench, seen)


def check_beside_a_live_result(document, body, mesh):
    """The panel shows the part to click on, and no result in its place; that is seen again when the panel is closed."""
    from freecad.featuremesh import api, engine
    if engine.load().statics_missing():
        return
    analysis = held_and_pushed(document, body)
    analysis.addObject(mesh)
    live = api.live_result(analysis)
    live.ViewObject.Proxy.show_alone(live)
    wait_for(lambda: not mesh.ViewObject.Visibility, 60)   # as soon as there is a result
    seen = [(obj, obj.ViewObject.Visibility) for obj in (body, mesh, live)]
    assert seen == [(body, False), (mesh, False), (live, True)], seen
    open_with((mesh,))
    assert [obj.ViewObject.Visibility for obj in (body, mesh, live)] == [True, False, False]
    picture("zone_beside_a_live_result")
    click_in_panel("Cancel")
    assert [(obj, obj.ViewObject.Visibility) for obj in (body, mesh, live)] == seen
    check_meshed_beside(document, analysis, mesh, live)


def check_meshed_beside(document, analysis, mesh, live):
    """*Apply* shows the mesh alone, where it was drawn through the result; that is seen again when the panel is closed. A pipeline, which is old then, is not."""
    pipeline = document.addObject("Fem::FemPostPipeline", "Pipeline")
    analysis.addObject(pipeline)
    check_load_beside(document, mesh, live, pipeline)
    for size, shown, left in (("5 mm", live, live), ("4 mm", pipeline, mesh)):
        mesh.ViewObject.Visibility, shown.ViewObject.Visibility = False, True
        mesh.ViewObject.doubleClicked()
        spin()
        type_into(panel("MeshPanel").size, size)
        click_in_panel("Apply")
        wait_for(lambda: mesh.ViewObject.Visibility, 60)
        assert not shown.ViewObject.Visibility, shown.Name
        click_in_panel("Ok")
        wait_for(lambda: not Gui.Control.activeDialog(), 60)
        assert [obj for obj in (mesh, live, pipeline) if obj.ViewObject.Visibility] == [left], size


def check_load_beside(document, mesh, live, pipeline):
    """A load's panel shows the part in place of the pipeline, which is seen alone again when the panel is closed: the mesh was, too."""
    assert not any(obj.ViewObject.Visibility for obj in (mesh, live))
    Gui.activeDocument().setEdit("Force")
    spin()
    assert [obj for obj in (mesh, live, pipeline) if obj.ViewObject.Visibility] == []
    click_in_panel("Cancel")
    spin(0.5)
    assert [obj for obj in (mesh, live, pipeline) if obj.ViewObject.Visibility] == [pipeline]


def drive():
    from freecad.featuremesh import api
    document = new_document("Zones")
    body = plate_with_hole(document)
    mesh = api.add_mesh(body, 4.0, order=1)
    document.recompute()
    document.UndoMode = 1
    Gui.activateWorkbench("FemWorkbench")
    spin(1)
    settle_view()
    check_local_size(document, body, mesh)
    check_nothing_selected(body, mesh)
    check_kinds(mesh)
    check_cancel(document, mesh)
    check_sphere(document, mesh)
    check_double_click(document, mesh)
    check_deleted(document, mesh)
    check_distance(document, body, mesh)
    check_expression(mesh)
    check_panel_is_open(document, mesh)
    check_dragged(document, body, mesh)
    check_right_click(mesh)
    check_beside_a_live_result(document, body, mesh)
    assert FreeCAD.ActiveDocument is document
    check_distance_in_a_container()


window.run(drive)

# SPDX-License-Identifier: GPL-3.0-or-later
"""The first use by hand, in a fresh FreeCAD: FEM's toolbar, a load on a clicked face, a mesh, an edit of the sketch, a solution, overlays.

Clicks and keys go to the real widgets and the real 3D view. Run by test_window.py with the bracket of the examples. Its pictures are the
film of the user's guide:

    FEATUREMESH_FILM=docs/pictures/first_use /usr/bin/python3 tests/python/test_window.py drive_first_use.py 1920x1080 resources/examples/bracket.FCStd

FreeCAD 0.20 draws all of them but 10_freecad_1_1, which FreeCAD 1.1 draws.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FemGui  # noqa: E402
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import Part  # noqa: E402
import window  # noqa: E402
from PySide import QtCore, QtGui  # noqa: E402
from window import click, click_button_of, click_in_panel, click_in_view, double_click, figures, item_of_tree, panel, spin, type_into, wait_for  # noqa: E402

FILM = os.environ.get("FEATUREMESH_FILM")
WIDTH = 1100
LOADED = FreeCAD.Vector(88, 36, 35)   # on the top of the rib


def film(name, version="0.20"):
    """A picture of the film, by that version of FreeCAD."""
    if FILM and ".".join(FreeCAD.Version()[:2]) == version:
        spin(1)
        shot = QtGui.QGuiApplication.primaryScreen().grabWindow(0)
        shot.scaledToWidth(WIDTH, QtCore.Qt.SmoothTransformation).save(os.path.join(FILM, name + ".jpg"), "JPG", 80)


def choose_workbench(name):
    """In the list of workbenches of FreeCAD's own toolbar."""
    selector, = [box for box in Gui.getMainWindow().findChildren(QtGui.QComboBox) if box.metaObject().className().endswith("WorkbenchComboBox") and box.isVisible()]
    click(selector)
    shown = selector.view()
    wait_for(shown.isVisible)
    for letter in name:
        window.send_key(shown, 0, text=letter)
    window.send_key(shown, QtCore.Qt.Key_Return)
    wait_for(lambda: Gui.activeWorkbench().name() == "FemWorkbench")
    spin(0.5)


def close_toolbars():
    """Toolbars that were opened at their end close when the mouse goes."""
    for bar in Gui.getMainWindow().findChildren(QtGui.QToolBar):
        QtGui.QApplication.postEvent(bar, QtCore.QEvent(QtCore.QEvent.Leave))
    spin(1)


def load_by_hand(document):
    """FEM's own pressure on the face that is clicked: the reference is what a click gives, and becomes the part's when the panel is closed."""
    before = set(document.Objects)
    click_in_view(LOADED)
    chosen, = Gui.Selection.getSelectionEx("", 0)
    assert (chosen.Object.Name, chosen.SubElementNames) == ("Body", ("Fillet.Face19",)), chosen.SubElementNames
    film("2_face")
    click_button_of("FEM_ConstraintPressure")
    close_toolbars()
    main = Gui.getMainWindow()
    shown = main.findChild(QtGui.QListWidget, "lw_references")
    click(main.findChild(QtGui.QToolButton, "btnAdd"))
    click_in_view(LOADED)
    wait_for(shown.count)
    load, = set(document.Objects) - before
    assert shown.item(0).text() == "Fillet:Face19", shown.item(0).text()
    type_into(main.findChild(QtGui.QWidget, "if_pressure"), "5 MPa")
    film("3_load")
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    return load


def mesh_by_hand(document):
    """Our button in FEM's toolbar, a size in the panel, OK."""
    from freecad.featuremesh import api, mesh_object
    window.button_of("FeatureMesh_MeshPart")
    film("4_toolbar")
    click_button_of("FeatureMesh_MeshPart")
    close_toolbars()
    settings = panel("MeshPanel")
    type_into(settings.size, "8 mm")
    wait_for(lambda: "elements" in settings.estimate.text())
    film("5_mesh_panel")
    click_in_panel("Ok")
    mesh, = api.meshes_of(document)
    wait_for(lambda: not Gui.Control.activeDialog())
    assert mesh.Size.Value == 8 and mesh.Status == mesh_object.UP_TO_DATE and mesh.FemMesh.VolumeCount > 1000, mesh.Status
    film("6_meshed")
    return mesh


def edit_by_hand(document, mesh):
    """A dimension of the sketch, double-clicked in the list of constraints; the mesh follows when the sketch is closed."""
    from freecad.featuremesh import mesh_object
    double_click(*item_of_tree("HoleSketch"))
    wait_for(lambda: Gui.activeDocument().getInEdit() is not None)
    constraints, = [w for w in Gui.getMainWindow().findChildren(QtGui.QListWidget) if w.isVisible() and w.metaObject().className() == "SketcherGui::ConstraintView"]
    item, = [constraints.item(row) for row in range(constraints.count()) if constraints.item(row).text().startswith("Hole6X")]
    constraints.scrollToItem(item)
    spin()
    timer = answer_datum("100 mm")
    double_click(constraints.viewport(), constraints.visualItemRect(item).center())
    wait_for(lambda: not timer.isActive())
    assert abs(document.getObject("HoleSketch").getDatum("Hole6X").Value - 100) < 1e-9
    click_in_panel("Close")
    wait_for(lambda: Gui.activeDocument().getInEdit() is None and mesh.Status == mesh_object.UP_TO_DATE and mesh.KeptNodes)
    assert mesh.KeptNodes > 50, mesh.KeptNodes   # per cent


def answer_datum(text):
    """Types a length into the next dialog that asks for one, and presses its OK. Keep what it returns until then."""
    def look():
        dialog = QtGui.QApplication.activeModalWidget()
        if dialog is None or not dialog.isVisible():
            return
        timer.stop()
        field = next(w for w in dialog.findChildren(QtGui.QAbstractSpinBox) if w.isVisible())
        type_into(field, text)
        film("7_sketch")
        click(dialog.findChild(QtGui.QDialogButtonBox).button(QtGui.QDialogButtonBox.Ok))
    timer = QtCore.QTimer()
    timer.timeout.connect(look)
    timer.start(200)
    return timer


def look_at_kept(mesh):
    """Our overlay, by its button."""
    click_button_of("FeatureMesh_ShowKept")
    close_toolbars()
    assert "%d" % mesh.KeptTets in panel("KeptPanel").labels[0].text()
    film("8_kept")
    film("10_freecad_1_1", "1.1")
    click_in_panel("Close")
    wait_for(lambda: not Gui.Control.activeDialog())


def solve_by_hand(document):
    """FEM's own button, and FEM's own panel of results."""
    tree, place = item_of_tree("Solver")
    window.send_mouse(tree, place, QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonRelease)
    click_button_of("FEM_SolverRun")
    close_toolbars()
    wait_for(lambda: results_of(document))
    result, = results_of(document)
    figures.append("CalculiX: displacement up to %.4f mm" % max(result.DisplacementLengths))
    in_one_place = [obj for obj in document.Objects if obj.isDerivedFrom("Fem::FemMeshObject") or obj.isDerivedFrom("Fem::FemPostPipeline")]
    assert [obj.Visibility for obj in in_one_place].count(True) == 1, [(obj.Label, obj.Visibility) for obj in in_one_place]
    double_click(*item_of_tree(result.Label))
    wait_for(Gui.Control.activeDialog)
    click(next(w for w in Gui.getMainWindow().findChildren(QtGui.QRadioButton) if w.objectName() == "rb_vm_stress"))
    film("9_result")
    click_in_panel("Close")


def look_at(label):
    """FEM's own panel of an object of the example, which was made without a window."""
    double_click(*item_of_tree(label))
    wait_for(Gui.Control.activeDialog, 20)
    window.picture(label)
    click(window.button_in_panel("Cancel") or window.button_in_panel("Close"))
    wait_for(lambda: not Gui.Control.activeDialog())


def results_of(document):
    return [obj for obj in document.Objects if obj.isDerivedFrom("Fem::FemResultObject") and len(obj.DisplacementLengths)]


def check_load(document, load, mesh):
    """The load is on the face that was clicked, by the part's name, and has its nodes in the mesh."""
    body = document.getObject("Body")
    (part, names), = load.References
    assert part is body, load.References
    face, = [body.getSubObject(name) for name in names]
    assert face.distToShape(Part.Vertex(LOADED))[0] < 1e-6, load.References
    found = [mesh.FemMesh.getGroupElements(group) for group in mesh.FemMesh.Groups if mesh.FemMesh.getGroupName(group) == load.Name + "_Nodes"]
    assert len(found) == 1 and all(face.distToShape(Part.Vertex(mesh.FemMesh.Nodes[number]))[0] < 1e-6 for number in list(found[0])[::10])


def drive():
    main = Gui.getMainWindow()
    main.setGeometry(0, 0, 1920, 1080)
    spin(1)
    combo = next(dock for dock in main.findChildren(QtGui.QDockWidget) if dock.isVisible())
    main.resizeDocks([combo], [430], QtCore.Qt.Horizontal)
    document = FreeCAD.ActiveDocument
    window.choose_tab(document.Label)
    assert not Gui.activeDocument().Modified
    choose_workbench("FEM")
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    film("1_start")
    double_click(*item_of_tree("Analysis"))
    wait_for(FemGui.getActiveAnalysis)
    load = load_by_hand(document)
    mesh = mesh_by_hand(document)
    check_load(document, load, mesh)
    edit_by_hand(document, mesh)
    check_load(document, load, mesh)
    look_at_kept(mesh)
    solve_by_hand(document)
    for label in ("Steel", "Solver"):
        look_at(label)


window.run(drive)

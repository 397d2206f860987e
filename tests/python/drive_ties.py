# SPDX-License-Identifier: GPL-3.0-or-later
"""Two parts that touch, tied by two faces that are clicked in FEM's own panel, meshed and solved, before and after an edit. Run by test_window.py."""
import os
import shutil
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FemGui  # noqa: E402
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import ObjectsFem  # noqa: E402
import window  # noqa: E402
from PySide import QtGui  # noqa: E402
from window import click, click_button_of, click_in_panel, click_in_view, double_click, figures, item_of_tree, panel, picture, spin, type_into, wait_for  # noqa: E402

HEIGHT = 20
JOINT = FreeCAD.Vector(10, 10, HEIGHT)   # where the parts touch


def tower(document):
    """A container with one box on another, held below and pressed from above, not yet tied."""
    from analyses import add_material, add_solver, quantity
    from statics_cases import STEEL, faces_at
    boxes = []
    made = document.addObject("App::Part", "Tower")
    for index, name in enumerate(("Lower", "Upper")):
        box = document.addObject("Part::Box", name)
        box.Length = box.Width = box.Height = HEIGHT
        box.Placement.Base.z = index * HEIGHT
        made.addObject(box)
        boxes.append(box)
    document.recompute()
    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    add_solver(document, analysis)
    add_material(document, analysis, "Steel", STEEL)
    fixed, force = ObjectsFem.makeConstraintFixed(document, "Fixed"), ObjectsFem.makeConstraintForce(document, "Force")
    fixed.References = [(boxes[0], faces_at(boxes[0], 2, 0))]
    top, = faces_at(boxes[1], 2, 2 * HEIGHT)
    force.References, force.Direction, force.Reversed = [(boxes[1], [top])], (boxes[1], [top]), True
    force.Force = quantity(1000, "N")
    for load in (fixed, force):
        analysis.addObject(load)
        load.ViewObject.Visibility = False
    document.recompute()
    return made, *boxes, analysis


def tie_by_hand(document, lower, upper):
    """Each face is clicked while the other part is hidden; FEM's panel wants its *Add* pressed for each."""
    view, before = Gui.activeDocument().activeView(), set(document.Objects)
    click_button_of("FEM_ConstraintTie")
    wait_for(Gui.Control.activeDialog)
    spin(1)
    add, = [button for button in Gui.getMainWindow().findChildren(QtGui.QPushButton) if button.isVisible() and button.text() == "Add"]
    chosen, = [shown for shown in Gui.getMainWindow().findChildren(QtGui.QListWidget) if shown.isVisible() and shown.window() is add.window()]
    for part, hidden, look in ((lower, upper, view.viewTop), (upper, lower, view.viewBottom)):
        click(add)
        part.ViewObject.Visibility, hidden.ViewObject.Visibility = True, False
        look()
        Gui.SendMsgToActiveView("ViewFit")
        spin(1)
        count = chosen.count()
        click_in_view(JOINT)
        wait_for(lambda: chosen.count() > count, 20)
    assert [chosen.item(row).text().split(":")[0] for row in range(chosen.count())] == ["Lower", "Upper"]
    picture("ties_panel")
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    lower.ViewObject.Visibility = True
    tie, = set(document.Objects) - before
    return tie


def mesh_by_hand(document, made):
    from freecad.featuremesh import api, mesh_object
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(made)
    click_button_of("FeatureMesh_MeshPart")
    spin()
    type_into(panel("MeshPanel").size, "5 mm")
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    mesh, = api.meshes_of(document)
    assert mesh.Status == mesh_object.UP_TO_DATE, mesh.Status
    return mesh


def is_on_both(tie):
    """Does it know one face of each part, at the joint?"""
    faces = [obj.Shape.getElement(name) for obj, names in tie.References for name in names]
    return len(faces) == 2 and all(abs(face.CenterOfMass.z - HEIGHT) < 1e-6 for face in faces)


def check_seen_after_panel(tie, mesh, made):
    """FEM's panel shows what its list refers to, and we the parts to click on; after it that is seen which was before."""
    from freecad.featuremesh import versions
    places = versions.part_of(mesh), made, mesh
    for seen in (mesh, made):
        for obj in places:
            obj.ViewObject.Visibility = obj is seen
        for button in ("Cancel", "Ok"):
            tie.ViewObject.doubleClicked()
            wait_for(Gui.Control.activeDialog)
            spin(1)
            click_in_panel(button)
            wait_for(lambda: not Gui.Control.activeDialog())
            spin()
            assert [obj for obj in places if obj.ViewObject.Visibility] == [seen], (button, seen.Label, [obj.Label for obj in places if obj.ViewObject.Visibility])


def check_not_moved(mesh):
    """A double click on the parts of a container opens no *Transform*, which would take them away from the parts."""
    from freecad.featuremesh import versions
    double_click(*item_of_tree(versions.part_of(mesh).Label))
    spin(1)
    assert not Gui.Control.activeDialog() and Gui.activeDocument().getInEdit() is None


def check_stiffness(analysis, upper):
    """The tower is as stiff as two columns, one on the other."""
    from freecad.featuremesh import api
    from statics_cases import STEEL
    found = api.solve(analysis).figures["displacement"]
    young = FreeCAD.Units.Quantity(STEEL["YoungsModulus"]).getValueAs("MPa").Value
    wanted = 1000 * (HEIGHT + upper.Height.Value) / young / HEIGHT**2
    figures.append("shortened by %.3e mm, two columns by %.3e" % (found, wanted))
    assert 0.85 < found / wanted < 1.15, (found, wanted)


def drive():
    Gui.getMainWindow().setGeometry(0, 0, 1280, 800)
    Gui.activateWorkbench("FemWorkbench")
    spin()
    document = FreeCAD.newDocument("Ties")
    document.UndoMode = 1
    made, lower, upper, analysis = tower(document)
    FemGui.setActiveAnalysis(analysis)
    tie = tie_by_hand(document, lower, upper)
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    mesh = mesh_by_hand(document, made)
    assert is_on_both(tie), tie.References
    picture("ties_meshed")
    check_seen_after_panel(tie, mesh, made)
    check_not_moved(mesh)
    for height in (HEIGHT, 30):
        upper.Height = height
        document.recompute()
        assert is_on_both(tie), tie.References
        if shutil.which("ccx"):
            check_stiffness(analysis, upper)
    assert mesh.KeptNodes > 30, mesh.KeptNodes   # the lower part's, at least


window.run(drive)

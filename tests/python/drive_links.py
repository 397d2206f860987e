# SPDX-License-Identifier: GPL-3.0-or-later
"""Faces clicked in the 3D view on what containers and links show, each placed: loads by FEM's own panels, local sizes, edits. Run by test_window.py."""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FemGui  # noqa: E402
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import ObjectsFem  # noqa: E402
import Part  # noqa: E402
import window  # noqa: E402
from parts import placement, plate_with_hole  # noqa: E402
from PySide import QtGui  # noqa: E402
from window import click, click_in_panel, click_in_view, figures, panel, picture, report_view, spin, type_into, wait_for  # noqa: E402

TOP = FreeCAD.Vector(52, 33, 10)   # of the plate
SKEW, TURNED = placement(100, 20, 30, 40, (1, 2, 3)), placement(10, 0, 5, 30)


def container(document, *members):
    made = document.addObject("App::Part", "Machine")
    for member in members:
        made.addObject(member)
    made.Placement = SKEW
    return made


def link_to(document, obj, name="Link", placed=TURNED):
    link = document.addObject("App::Link", name)
    link.LinkedObject, link.Placement = obj, placed
    return link


# Scenes: (what is chosen to be meshed, None for what is clicked; what shows the clicked face; the placement of that; is the mesh where it is?)


def body_in_container(document, body):
    from freecad.featuremesh import versions
    made = container(document, body)
    return None, body, made.Placement, versions.version() >= (1, 0)   # 0.20 has FEM's nodes in the frame of the body alone


def placed_link(document, body):
    link = link_to(document, body)
    return None, link, link.Placement, True


def link_in_container(document, body):
    link = link_to(document, body)
    made = container(document, link)
    return None, link, made.Placement.multiply(link.Placement), True


def second_link_in_container(document, body):
    links = [link_to(document, body, "One", placement(-80, 0, 0)), link_to(document, body, "Two")]
    made = container(document, *links)
    return made, links[1], made.Placement.multiply(links[1].Placement), True


def link_to_container(document, body):
    link = link_to(document, container(document, body))
    return None, link, link.Placement, True


def load_by_hand(document, command, spot):
    """FEM's own panel, its *Add*, a click on the face, OK."""
    before = set(document.Objects)
    Gui.Selection.clearSelection()
    Gui.runCommand(command)
    spin(0.5)
    main = Gui.getMainWindow()
    click(next(button for button in main.findChildren(QtGui.QToolButton) if button.objectName() == "btnAdd" and button.isVisible()))
    click_in_view(spot)
    shown, = [box for box in main.findChildren(QtGui.QListWidget) if box.objectName() in ("lw_references", "listReferences") and box.isVisible()]
    wait_for(shown.count)
    load, = set(document.Objects) - before
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    return load


def mesh_by_hand(chosen, spot):
    """*Mesh a part* for what is chosen or for the face that is clicked; a size, OK."""
    Gui.Selection.clearSelection()
    if chosen is not None:
        Gui.Selection.addSelection(chosen)
    else:
        click_in_view(spot)
    Gui.runCommand("FeatureMesh_MeshPart")
    spin()
    settings = panel("MeshPanel")
    type_into(settings.size, "8 mm")
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    assert settings.mesh.Status == "up to date", settings.mesh.Status
    return settings.mesh


def nodes_of(mesh, name):
    """Numbers of the nodes in the group of that name."""
    return next((set(mesh.FemMesh.getGroupElements(group)) for group in mesh.FemMesh.Groups if mesh.FemMesh.getGroupName(group) == name), set())


def nodes_on(mesh, face):
    """Numbers of the nodes that lie on a plane face."""
    place, normal = face.CenterOfMass, face.normalAt(0, 0)
    near = {number: point for number, point in mesh.FemMesh.Nodes.items() if abs((point - place).dot(normal)) < 1e-6}
    return {number for number, point in near.items() if face.distToShape(Part.Vertex(point))[0] < 1e-6}


def top_of(body, place):
    """The plate's upper face where it is to be seen."""
    face, = [face for face in body.Tip.Shape.Faces if face.distToShape(Part.Vertex(TOP))[0] < 1e-6]
    shown = face.copy()
    shown.Placement = place.multiply(shown.Placement)
    return shown


def check_loads(mesh, loads, body, place, when):
    wanted = nodes_on(mesh, top_of(body, place))
    assert len(wanted) > 20, (when, len(wanted))
    for load in loads:
        found = nodes_of(mesh, load.Name + "_Nodes")
        assert found == wanted, (when, load.Name, load.References, len(found), len(wanted), len(found & wanted))


def show_again(shown, mesh):
    """As the Space key does in the tree."""
    mesh.ViewObject.Visibility, shown.ViewObject.Visibility = False, True
    spin()


def refine_by_hand(mesh, spot):
    """*Add a local size* for the face that is clicked, OK in FEM's own panel."""
    Gui.Selection.clearSelection()
    click_in_view(spot)
    Gui.runCommand("FeatureMesh_AddLocalSize")
    wait_for(Gui.Control.activeDialog)
    spin(0.5)
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    mesh.Document.recompute()


def check_scene(scene):
    document = FreeCAD.newDocument(scene.__name__)
    document.UndoMode = 1
    body = plate_with_hole(document)
    chosen, shown, place, is_in_place = scene(document, body)
    if shown is not body:
        shown.LinkedObject.ViewObject.Visibility = False   # the original
    document.recompute()
    FemGui.setActiveAnalysis(ObjectsFem.makeAnalysis(document, "Analysis"))
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    spin(1)
    spot, in_mesh = place.multVec(TOP), place if is_in_place else FreeCAD.Placement()
    before = load_by_hand(document, "FEM_ConstraintPressure", spot)
    mesh = mesh_by_hand(chosen, spot)
    picture("links_" + scene.__name__)
    check_loads(mesh, [before], body, in_mesh, "load, then mesh")
    show_again(chosen or shown, mesh)
    after = load_by_hand(document, "FEM_ConstraintFixed", spot)
    check_loads(mesh, [before, after], body, in_mesh, "mesh, then load")
    document.getObject("HoleSketch").addGeometry(Part.Circle(FreeCAD.Vector(42, 12, 0), FreeCAD.Vector(0, 0, 1), 4))
    document.recompute()
    assert mesh.Status == "up to date", mesh.Status
    check_loads(mesh, [before, after], body, in_mesh, "after an edit")
    count = len(nodes_on(mesh, top_of(body, in_mesh)))
    refine_by_hand(mesh, spot)
    assert len(mesh.MeshRegionList) == 1 and mesh.MeshRegionList[0].References, mesh.MeshRegionList
    finer = len(nodes_on(mesh, top_of(body, in_mesh)))
    assert finer > 1.2 * count, (count, finer)
    check_loads(mesh, [before, after], body, in_mesh, "refined")
    assert "allowed scope 'AssembledParts'" not in report_view(), report_view()   # FreeCAD warns so of FEM's own refinements, too
    figures.append("%s: %d nodes under %d loads, %d refined" % (scene.__name__, count, 2, finer))
    FreeCAD.closeDocument(document.Name)
    spin()


def check_link_to_feature():
    """FEM's panels refuse a face of a link to anything but a body, so that the assembled parts are seen while faces are clicked, and the container again then."""
    from freecad.featuremesh import api, versions
    document = FreeCAD.newDocument("Feature")
    box = document.addObject("Part::Box", "Box")
    made = container(document, link_to(document, box))
    box.ViewObject.Visibility = False
    document.recompute()
    mesh, analysis = api.add_mesh(made, 4), ObjectsFem.makeAnalysis(document, "Analysis")
    analysis.addObject(mesh)
    document.recompute()
    FemGui.setActiveAnalysis(analysis)
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    show_again(made, mesh)
    spin(1)
    load = load_by_hand(document, "FEM_ConstraintFixed", made.Placement.multiply(TURNED).multVec(FreeCAD.Vector(4, 6, 10)))
    assert load.References == [(versions.part_of(mesh), ("Face6",))] and nodes_of(mesh, load.Name + "_Nodes"), load.References
    assert made.Visibility and not versions.part_of(mesh).Visibility
    FreeCAD.closeDocument(document.Name)


def check_active_assembly():
    """An assembly of FreeCAD 1.x is being edited from its making on; the mesh follows an edit of a part all the same."""
    from freecad.featuremesh import api, versions
    if "AssemblyWorkbench" not in Gui.listWorkbenches():
        return
    document = FreeCAD.newDocument("Assembled")
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    Gui.activateWorkbench("AssemblyWorkbench")
    Gui.runCommand("Assembly_CreateAssembly")
    assembly, = [obj for obj in document.Objects if obj.TypeId == "Assembly::AssemblyObject"]
    assembly.newObject("App::Link", "Link").LinkedObject = box
    Gui.activateWorkbench("FemWorkbench")
    mesh, analysis = api.add_mesh(assembly, 4), ObjectsFem.makeAnalysis(document, "Analysis")
    load = ObjectsFem.makeConstraintFixed(document, "Fixed")
    load.References = [(assembly, "Link.Face3") if versions.version() >= (1, 1) else (box, "Face3")]   # FreeCAD 1.0 ends by the first
    analysis.addObject(mesh)
    analysis.addObject(load)
    document.recompute()
    assert Gui.activeDocument().getInEdit() is not None
    box.Height = 14
    document.recompute()
    assert mesh.Status == "up to date" and mesh.FemMesh.BoundBox.ZLength == 14 and nodes_of(mesh, "Fixed_Nodes"), mesh.Status
    FreeCAD.closeDocument(document.Name)


def drive():
    Gui.getMainWindow().setGeometry(0, 0, 1280, 800)
    Gui.activateWorkbench("FemWorkbench")
    spin(1)
    for scene in (body_in_container, placed_link, link_in_container, second_link_in_container, link_to_container):
        check_scene(scene)
    check_link_to_feature()
    check_active_assembly()


window.run(drive)

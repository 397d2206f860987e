# SPDX-License-Identifier: GPL-3.0-or-later
"""Files and other makers' meshes by hand: a STEP file meshed, a mesh saved by FreeCAD's own File > Export, a mesh of FEM's panel of Gmsh adopted, a
live result opened again.

Run by test_window.py with the bracket of the examples; see drive_window.py for the result and the pictures.
"""
import os
import shutil
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import Fem  # noqa: E402
import FemGui  # noqa: E402
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import ImportGui  # noqa: E402
import ObjectsFem  # noqa: E402
import window  # noqa: E402
from PySide import QtCore, QtGui  # noqa: E402
from window import click_button_of, click_in_panel, figures, panel, picture, spin, type_into, wait_for  # noqa: E402

EXAMPLE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "resources", "examples", "bracket.FCStd")


def select(obj):
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(obj)


def mesh_by_hand(part, size):
    """Our button in FEM's toolbar, a size in the panel, OK."""
    from freecad.featuremesh import api, mesh_object
    select(part)
    click_button_of("FeatureMesh_MeshPart")
    type_into(panel("MeshPanel").size, size)
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    mesh = api.meshes_of(part.Document)[-1]
    assert mesh.Status == mesh_object.UP_TO_DATE and mesh.FemMesh.VolumeCount > 100, mesh.Status
    return mesh


def answer_file_dialog(path):
    """Types the path into the next dialog for files, chooses the kind of file, and accepts. Keep what it returns until then."""
    def look():
        dialog = QtGui.QApplication.activeModalWidget()
        if isinstance(dialog, QtGui.QFileDialog) and dialog.isVisible():
            timer.stop()
            dialog.selectNameFilter(next(kind for kind in dialog.nameFilters() if kind.startswith("FEM mesh formats")))
            dialog.findChild(QtGui.QLineEdit).setText(path)
            dialog.accept()
    timer = QtCore.QTimer()
    timer.timeout.connect(look)
    timer.start(100)
    return timer


def check_export(mesh, folder, *endings):
    """FreeCAD's own export has all nodes, elements and groups of ours."""
    for ending in endings:
        path = os.path.join(folder, "mesh." + ending)
        select(mesh)
        answering = answer_file_dialog(path)
        Gui.runCommand("Std_Export", 0)
        wait_for(lambda: os.path.exists(path))
        assert not answering.isActive()
        back = Fem.read(path)
        assert (back.NodeCount, back.VolumeCount) == (mesh.FemMesh.NodeCount, mesh.FemMesh.VolumeCount), ending
        assert ending == "inp" or back.GroupCount == mesh.FemMesh.GroupCount, ending


def check_step(shape, folder):
    """A STEP file has no features; its solid is meshed as it is. FreeCAD 1.1 takes minutes for CalculiX's format of a large mesh."""
    path = os.path.join(folder, "part.step")
    shape.exportStep(path)
    document = FreeCAD.newDocument("Imported")
    ImportGui.insert(path, document.Name)
    spin(1)
    part = next(obj for obj in document.Objects if getattr(obj, "Shape", None) and obj.Shape.Solids)
    mesh = mesh_by_hand(part, "10 mm")
    picture("step")
    figures.append("STEP: %d elements" % mesh.FemMesh.VolumeCount)
    check_export(mesh, folder, "inp")
    FreeCAD.closeDocument(document.Name)


def check_adopted(document):
    """FEM's own panel of Gmsh makes a mesh; our button takes it over, and it is updated locally from then on. Returns it."""
    from freecad.featuremesh import api, mesh_object
    before = set(document.Objects)
    select(document.getObject("Body"))
    Gui.runCommand("FEM_MeshGmshFromShape", 0)
    spin(1)   # until its panel is there
    foreign, = set(document.Objects) - before
    click_in_panel("Apply")
    wait_for(lambda: foreign.FemMesh.VolumeCount)
    click_in_panel("Ok")
    wait_for(lambda: not Gui.Control.activeDialog())
    select(foreign)
    click_button_of("FeatureMesh_Adopt")
    wait_for(lambda: set(api.meshes_of(document)) - before)
    mesh, = set(api.meshes_of(document)) - before
    assert mesh.FemMesh.NodeCount == foreign.FemMesh.NodeCount and not foreign.ViewObject.Visibility
    document.HoleSketch.setDatum("Hole6X", FreeCAD.Units.Quantity("105 mm"))
    document.recompute()
    wait_for(lambda: mesh.Status == mesh_object.UP_TO_DATE)
    picture("adopted")
    assert 50 < mesh.KeptNodes < 100, mesh.KeptNodes
    figures.append("adopted: %d %% of the nodes kept after an edit" % mesh.KeptNodes)
    return mesh


def check_opened_result(path):
    """The mesh of a result does not lie over the live result, or the pipeline in its place, in a document that is opened, where FreeCAD 1.1 shows it."""
    from freecad.featuremesh import api, mesh_object
    document = FreeCAD.openDocument(path)
    api.add_mesh(document.Body, 15.0, order=1)
    document.recompute()
    live = api.live_result(document.Analysis)
    wait_for(lambda: live.Status == mesh_object.UP_TO_DATE and live.Result is not None)
    document.Analysis.addObject(document.addObject("Fem::FemPostPipeline", "Pipeline"))
    names = live.Name, live.Result.Mesh.Name, "Pipeline"
    for seen in ("Pipeline", names[0]):
        document.getObject(names[1]).ViewObject.Visibility = document.getObject(seen).ViewObject.Visibility = True
        document.save()
        FreeCAD.closeDocument(document.Name)
        document = FreeCAD.openDocument(path)
        spin(1)
        picture("opened_result")
        assert [name for name in names if document.getObject(name).Visibility] == [seen], seen
    check_filter_deleted(document, document.getObject("Pipeline"))
    document.removeObject("Pipeline")
    check_purged(document, document.getObject(names[0]))
    FreeCAD.closeDocument(document.Name)


def check_filter_deleted(document, pipeline):
    """What it was shown in place of is seen again."""
    from freecad.featuremesh import api
    pipeline.ViewObject.Visibility = True
    warped = ObjectsFem.makePostVtkFilterWarp(document, pipeline)
    for hidden in (pipeline, document.Body, *api.meshes_of(document)):
        hidden.ViewObject.Visibility = False
    document.removeObject(warped.Name)
    wait_for(lambda: pipeline.ViewObject.Visibility, 5)


def check_purged(document, live):
    """FEM removes results before it solves; undo and redo of that leave no error. Where there is no mesh it is no step of undo, and an edit before that,
    which changed what is seen of the results, can be undone."""
    from femresult import resulttools
    from freecad.featuremesh import api
    document.UndoMode = 1
    edit(document, "104 mm")
    wait_for(lambda: live.Status == "up to date" and live.Result.Label == "LiveResult")   # FreeCAD 1.1 would number it
    FemGui.setActiveAnalysis(document.Analysis)
    for _ in range(2 if shutil.which("ccx") else 0):   # the second one removes the results of the first
        select(document.Solver)
        Gui.runCommand("FEM_SolverRun", 0)
        wait_for(lambda: live.Status == "up to date" and live.Result is not None)
        spin(1)
        results = [obj for obj in document.Analysis.Group if obj.isDerivedFrom("Fem::FemResultObject")]
        drawn = [obj for obj in document.Analysis.Group if obj is live or obj.isDerivedFrom("Fem::FemPostPipeline")]   # FreeCAD 1.1 makes one
        assert len(results) == 2 and [obj.Visibility for obj in drawn].count(True) == 1, drawn
        assert not any(result.Mesh.Visibility for result in results), [result.Mesh.Label for result in results if result.Mesh.Visibility]
        undo_and_redo(1)
    window.delete(*api.meshes_of(document))
    wait_for(lambda: live.Status.startswith("failed"))
    document.clearUndos()
    edit(document, "106 mm")
    spin(1)
    resulttools.purge_results(document.Analysis)
    undo_and_redo(len(document.UndoNames))
    assert abs(document.HoleSketch.getDatum("Hole6X").Value - 106) < 1e-9
    errors = [line for line in window.report_view().splitlines() if "part of a document" in line or "removed from document" in line]
    assert not errors, errors


def edit(document, place):
    document.openTransaction("Edit")
    document.HoleSketch.setDatum("Hole6X", FreeCAD.Units.Quantity(place))
    document.recompute()
    document.commitTransaction()


def undo_and_redo(steps):
    for command in ("Std_Undo", "Std_Redo"):
        for _ in range(steps):
            Gui.runCommand(command)
            spin(0.5)


def drive():
    from freecad.featuremesh import engine
    document = FreeCAD.ActiveDocument
    window.choose_tab(document.Label)
    Gui.activateWorkbench("FemWorkbench")
    spin(0.5)
    body = document.getObject("Body")
    mesh = check_adopted(document) if shutil.which("gmsh") else mesh_by_hand(body, "10 mm")
    with tempfile.TemporaryDirectory() as folder:
        check_export(mesh, folder, "unv", "med")
        check_step(document.Boss.Shape, folder)
        if not engine.load().statics_missing():
            check_opened_result(shutil.copy(EXAMPLE, os.path.join(folder, "solved.FCStd")))


window.run(drive)

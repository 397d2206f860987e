# SPDX-License-Identifier: GPL-3.0-or-later
"""Refines by error in FreeCAD's real window: the panel of the live result says what the mesh is off, its button refines, undo takes that back. Run by test_window.py."""
import os
import sys
import unittest
from unittest import mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import window  # noqa: E402
from analyses import held_and_pushed  # noqa: E402
from window import click, panel, picture, spin, type_into, wait_for  # noqa: E402


def solved(live):
    from freecad.featuremesh import live_result
    from freecad.featuremesh.gui import live_runner
    wait_for(lambda: live.Status == live_result.UP_TO_DATE and live_runner.run_of(live) is None, 100)
    spin()


def percent(shown):
    """What the panel says the mesh is off."""
    words = shown.error.text()
    assert words.startswith("about ") and words.endswith(" %"), words
    return float(words[len("about "):-len(" %")])


def refine(shown, live):
    """The button, pressed once; what the mesh is off then."""
    click(shown.finer)
    solved(live)
    return percent(shown)


def check_memory(shown, mesh):
    """Who wants no mesh for which there is no memory has all as it was."""
    from freecad.featuremesh.gui import message_box
    from freecad.featuremesh.study import memory
    steps = list(mesh.Document.UndoNames)
    with mock.patch.object(memory, "available_bytes", lambda: 1e6), mock.patch.object(message_box, "answer", return_value=None) as asked:
        click(shown.finer)
        spin()
    assert "million elements need about" in asked.call_args.args[1], asked.call_args
    assert not mesh.MeshRegionList and mesh.Document.UndoNames == steps and shown.finer.isEnabled(), (mesh.MeshRegionList, mesh.Document.UndoNames)


def check_material(live, mesh):
    """A double click on the material, whose panel is FEM's own in Python, opens it in place of ours that show something; *Cancel* there takes back nothing of them."""
    from freecad.featuremesh import versions
    material, = [obj for obj in mesh.Document.Objects if hasattr(obj, "Material")]
    for command in ("LiveResult", "ShowQuality"):
        Gui.runCommand("FeatureMesh_" + command)
        spin()
        FreeCAD.setActiveTransaction("Edit")   # as FreeCAD does for a double click
        material.ViewObject.doubleClicked()
        spin(1)
        assert Gui.activeDocument().getInEdit().Object is material
        assert [obj.Label for obj in (versions.part_of(mesh), mesh, live) if obj.ViewObject.Visibility] == [versions.part_of(mesh).Label]
        window.click_in_panel("Cancel")
        wait_for(lambda: not Gui.Control.activeDialog())
        FreeCAD.closeActiveTransaction(True)
        spin()
        assert live.ViewObject.Visibility and not mesh.ViewObject.Visibility, command


def drive():
    from freecad.featuremesh import api, engine, error_sizes
    from parts import plate_with_hole
    if engine.load().statics_missing():
        raise unittest.SkipTest("needs an engine with PETSc")
    window.choose_workbench()
    document = FreeCAD.newDocument("Accuracy")
    document.UndoMode = 1
    body = plate_with_hole(document)
    held_and_pushed(document, body)
    mesh = api.add_mesh(body, 5)
    document.recompute()
    coarse = mesh.TetCount
    Gui.runCommand("FeatureMesh_LiveResult")
    spin()
    shown = panel("LivePanel")
    live = shown.live
    solved(live)
    before = percent(shown)
    type_into(shown.accuracy, "90")
    spin()
    assert not shown.finer.isEnabled()   # it is good enough
    type_into(shown.accuracy, "%.1f" % (before / 2))
    spin()
    assert shown.finer.isEnabled()
    check_memory(shown, mesh)
    picture("accuracy_before")
    after = refine(shown, live)
    assert after < 0.85 * before and mesh.TetCount > coarse, (before, after, coarse, mesh.TetCount)
    assert error_sizes.is_error_sizes(mesh.MeshRegionList[0])
    assert shown.difference.isEnabled()
    picture("accuracy_after")
    assert document.UndoNames[0] == "Refine where it is off", document.UndoNames
    shown.reject()
    Gui.runCommand("Std_Undo")
    spin(1)
    solved(live)
    assert mesh.TetCount == coarse and not mesh.MeshRegionList, (mesh.TetCount, mesh.MeshRegionList)
    assert not error_sizes.in_document(document)
    Gui.runCommand("Std_Redo")
    spin(1)
    solved(live)
    assert mesh.TetCount > coarse and mesh.MeshRegionList == error_sizes.in_document(document)
    Gui.runCommand("FeatureMesh_LiveResult")
    spin()
    assert abs(panel("LivePanel").accuracy.value() - before / 2) < 0.06   # as it was typed
    mesh.ViewObject.doubleClicked()   # whose panel takes the other's place
    spin(1)
    assert panel("MeshPanel").mesh is mesh
    window.click_in_panel("Cancel")
    wait_for(lambda: not Gui.Control.activeDialog())
    check_material(live, mesh)


window.run(drive)

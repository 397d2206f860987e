# SPDX-License-Identifier: GPL-3.0-or-later
"""Every panel in German, whose words are longer, in FreeCAD's dock as it is at first: nothing is cut off.

Run by test_window.py; see drive_window.py for the result and the pictures.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import window  # noqa: E402
from window import figures, is_whole, panel, picture, spin  # noqa: E402


def check_panel(kind, command=None, edited=None):
    """Opens it by its command, or by the object that is edited in it."""
    if edited is None:
        Gui.runCommand(command)
    else:
        Gui.activeDocument().setEdit(edited.Name)
    spin()
    shown = panel(kind)
    picture("german_" + kind)
    assert is_whole(shown.form), (kind, shown.form.width(), shown.form.visibleRegion().boundingRect().width())
    figures.append("%s %d" % (kind, shown.form.width()))
    Gui.Control.closeDialog()
    Gui.activeDocument().resetEdit()
    spin()


def select(obj):
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(obj)


def drive():
    from freecad.featuremesh import api
    from parts import plate_with_hole
    from test_document_solving import STEEL, analysis_of
    Gui.getMainWindow().setGeometry(0, 0, 1280, 800)
    Gui.setLocale("de")
    Gui.activateWorkbench("FeatureMeshWorkbench")
    spin()
    window.open_dialog().close()
    document = FreeCAD.newDocument("Deutsch")
    body = plate_with_hole(document)
    analysis = analysis_of(document, body, [("Steel", STEEL, [])])
    mesh = api.add_mesh(body, 4.0, order=1)
    document.recompute()
    zone = api.add_size_zone(mesh, inner=2.0)
    study = api.add_study(body, analysis)
    document.recompute()
    select(mesh)
    check_panel("MeshPanel", edited=mesh)
    check_panel("ZonePanel", edited=zone)
    check_panel("QualityPanel", "FeatureMesh_ShowQuality")
    check_panel("KeptPanel", "FeatureMesh_ShowKept")
    check_panel("StudyPanel", edited=study)
    if not engine_lacks_statics():
        check_panel("LivePanel", "FeatureMesh_LiveResult")


def engine_lacks_statics():
    from freecad.featuremesh import engine
    return engine.load().statics_missing()


window.run(drive)

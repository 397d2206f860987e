# SPDX-License-Identifier: GPL-3.0-or-later
"""Drives the overlays in FreeCAD's real window: many elements, measures, limits, the cut, edits under an open panel, the end of the mesh.

Run by test_window.py; see drive_window.py for the result and the pictures.
"""
import gc
import os
import sys
import tempfile
import time
from unittest import mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import numpy as np  # noqa: E402
import ObjectsFem  # noqa: E402
import window  # noqa: E402
from pivy import coin  # noqa: E402
from PySide import QtCore, QtGui  # noqa: E402
from window import figures, panel, picture, pixels, send_key, spin, wait_for  # noqa: E402


def count_of(colour, seen, spread=0.18):
    """How many pixels have about the hue of a colour, whatever light falls on it."""
    wanted = np.array(colour) / np.linalg.norm(colour)
    lengths = np.linalg.norm(seen, axis=2)
    hues = seen / np.maximum(lengths, 1)[:, :, None]
    return int(((np.abs(hues - wanted).max(axis=2) < spread / 2) & (lengths > 60)).sum())


def show(command, kind):
    Gui.runCommand(command)
    spin()
    return panel(kind)


def close(shown):
    shown.reject()
    spin()
    assert not Gui.Control.activeDialog()


def move_hole(document, x):
    document.getObject("HoleSketch").setDatum("X", FreeCAD.Units.Quantity("%g mm" % x))
    document.recompute()
    spin()


def check_kept(document, mesh):
    """Both colours are on the screen, and after an edit under the open panel those of the new mesh."""
    from freecad.featuremesh import overlays
    mesh.ViewObject.ShapeColor = (0.6, 0.6, 0.6)   # of 1.1 it is that of new elements
    plain = pixels()
    shown = show("FeatureMesh_ShowKept", "KeptPanel")
    kept_colour, new_colour, active_colour = overlays.kept_legend()
    seen = pixels()
    picture("overlay_kept")
    for colour in (kept_colour, new_colour):
        assert count_of(colour, seen) > 1000 + count_of(colour, plain), (colour, count_of(colour, seen), count_of(colour, plain))
    check_kept_numbers(shown, mesh)
    before = [label.text() for label in shown.labels]
    move_hole(document, 30)
    check_kept_numbers(shown, mesh)
    assert [label.text() for label in shown.labels] != before, before
    assert set(shown.overlay.numbers.tolist()) == set(mesh.FemMesh.Volumes)
    assert mesh.ViewObject.Proxy.elements(mesh).overlay is shown.overlay
    assert np.abs(pixels() - seen).sum() > 0
    seen = pixels()
    shown.cut.setChecked(True)
    assert np.abs(pixels() - seen).sum() > 1000
    picture("overlay_kept_cut")
    document.undo()
    spin()
    check_kept_numbers(shown, mesh, is_known=False)
    close(shown)
    assert np.abs(pixels() - plain).max(axis=2).astype(bool).mean() < 0.2
    assert mesh.ViewObject.Proxy.elements(mesh).overlay is None


def check_kept_numbers(shown, mesh, is_known=True):
    """The legend tells of the mesh as it is, or says why it cannot."""
    if shown.overlay is None:
        assert "brought back by undo" in shown.note.text() and not is_known and not shown.labels[0].text(), shown.note.text()
    else:
        count = int(shown.overlay.kept.sum())
        assert len(shown.overlay.kept) == mesh.TetCount and str(count) in shown.labels[0].text(), \
            (shown.labels[0].text(), count, len(shown.overlay.kept), mesh.TetCount, mesh.Status)


def check_quality(document, mesh):
    """Each measure has its histogram, limits and worst elements; the mesh is followed."""
    from freecad.featuremesh import overlays
    from freecad.featuremesh.quality import MEASURES
    shown = show("FeatureMesh_ShowQuality", "QualityPanel")
    assert shown.note.text() == ""
    if FreeCAD.Version()[:2] == ["0", "20"]:   # later ones lay the panel over a part of the view
        assert shown.cut.visibleRegion().boundingRect().size() == shown.cut.size(), shown.cut.visibleRegion().boundingRect()   # without scrolling
    pictures = []
    for index, name in enumerate(MEASURES):
        shown.measure.setCurrentIndex(index)
        spin()
        assert sum(shown.histogram.counts) == mesh.TetCount and shown.worst.count() == 20, name
        number, value = overlays.worst_tets(mesh, 1, name)[0]
        assert shown.worst.item(0).text() == "%d:  %s" % (number, MEASURES[name].in_words(value)), shown.worst.item(0).text()
        pictures.append(pixels())
        picture("overlay_" + name)
    assert all(np.abs(one - other).sum() > 0 for one, other in zip(pictures, pictures[1:]))
    shown.measure.setCurrentIndex(1)
    assert ";\n0 of " in shown.summary.text(), shown.summary.text()
    shown.bad.setValue(0.6)   # limits of one's own
    values = shown.overlay.values
    assert ";\n%d of %d " % ((values < 0.6).sum(), len(values)) in shown.summary.text() and (values < 0.6).any(), shown.summary.text()
    red = count_of(MEASURES["radius_ratio"].colours(np.zeros(1))[0], pixels())
    shown.bad.setValue(0.0)
    assert red > 100 + count_of(MEASURES["radius_ratio"].colours(np.zeros(1))[0], pixels())
    shown.worst.setCurrentRow(0)
    picture("overlay_worst")
    number = int(shown.worst.item(0).text().split(":")[0])
    move_hole(document, 24)
    assert sum(shown.histogram.counts) == mesh.TetCount and (number not in mesh.FemMesh.Volumes or shown.worst.count() == 20)
    assert all(int(shown.worst.item(i).text().split(":")[0]) in mesh.FemMesh.Volumes for i in range(20))
    mesh.Automatic = False
    move_hole(document, 25)
    wait_for(lambda: "last mesh" in shown.note.text())
    picture("overlay_out_of_date")
    mesh.Automatic = True
    document.recompute()
    wait_for(lambda: shown.note.text() == "")
    assert sum(shown.histogram.counts) == mesh.TetCount
    return shown


def check_cut(shown, mesh):
    """The slider drags the plane: whole elements, or the cut filled; the axis, the other side and the number do likewise."""
    whole = pixels()
    cut = shown.cut
    cut.setChecked(True)
    seen = [pixels()]
    cut.slider.setValue(100)
    seen.append(pixels())
    assert abs(cut.at() - 2.5) < 0.1, cut.at()   # a quarter of the plate's 10 mm
    picture("overlay_cut_whole")
    cut.axis.setCurrentIndex(1)
    cut.place.setProperty("rawValue", 20)
    seen.append(pixels())
    cut.filled.setChecked(True)
    seen.append(pixels())
    picture("overlay_cut_filled")
    cut.above.setChecked(True)
    seen.append(pixels())
    picture("overlay_cut_other_side")
    assert all(np.abs(one - other).sum() > 1000 for one, other in zip([whole, *seen], seen))
    mesh.ViewObject.Visibility = False
    hidden = pixels()
    mesh.ViewObject.Visibility = True
    assert np.abs(pixels() - seen[-1]).sum() < np.abs(hidden - seen[-1]).sum() / 20   # hidden with the mesh, and there again
    cut.setChecked(False)
    assert np.abs(pixels() - whole).max(axis=2).astype(bool).mean() < 0.02


def check_ends(document, mesh):
    """The panel closes with the mesh, which undo brings back without colours, and with the document."""
    document.openTransaction("Delete")
    document.removeObject(mesh.Name)
    document.commitTransaction()
    wait_for(lambda: not Gui.Control.activeDialog())
    document.undo()
    spin()
    mesh, = [obj for obj in document.Objects if obj.Name == "FeatureMesh"]
    assert mesh.ViewObject.Proxy.elements(mesh).overlay is None
    picture("overlay_mesh_back")
    show("FeatureMesh_ShowQuality", "QualityPanel")
    FreeCAD.closeDocument(document.Name)
    wait_for(lambda: not Gui.Control.activeDialog())


def check_load_double_clicked(document, mesh):
    """Its panel takes the place of ours, with or without a question: the mesh has its own colour then."""
    load = ObjectsFem.makeConstraintForce(document, "Force")
    load.References = [(document.Body, "Face1")]
    ObjectsFem.makeAnalysis(document, "Analysis").addObject(load)
    document.recompute()
    timer = window.answer_with("Yes", [])   # since 1.0 FreeCAD does not ask
    load.ViewObject.doubleClicked()
    spin()
    timer.stop()
    assert Gui.Control.activeDialog() and not [obj for obj in gc.get_objects() if type(obj).__name__ == "QualityPanel" and window.is_shown(obj.form)]
    assert mesh.ViewObject.Proxy.elements(mesh).overlay is None
    Gui.activeDocument().resetEdit()
    Gui.Control.closeDialog()
    spin()
    show("FeatureMesh_ShowQuality", "QualityPanel")


def check_theme(shown):
    """Since FreeCAD 1.1 lists have a style sheet of their own, which it does not read again for another theme: dark on dark."""
    from freecad.featuremesh import versions
    settings = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/MainWindow")
    names = "OverlayActiveStyleSheet", "Theme", "StyleSheet"
    before = [settings.GetString(name) for name in names]
    for theme, is_dark in (("FreeCAD Light", False), ("FreeCAD Dark", True)) if versions.version() >= (1, 1) else ():
        for name, value in zip(names, ("Freecad Overlay.qss", theme, "FreeCAD.qss")):
            settings.SetString(name, value)
        wait_for(lambda is_dark=is_dark: (shown.summary.palette().windowText().color().lightness() > 128) == is_dark, 10)
        wait_for(lambda: shown.worst.palette().text().color() == shown.summary.palette().windowText().color(), 10)
        picture("overlay_%s" % theme.replace(" ", "_"))
    for name, value in zip(names, before):
        settings.SetString(name, value)
    spin(1)


def drawn_triangles(mesh):
    search = coin.SoSearchAction()
    search.setType(coin.SoIndexedFaceSet.getClassTypeId())
    search.setSearchingAll(True)
    search.apply(mesh.ViewObject.RootNode)
    return search.getPath().getTail().coordIndex.getNum() // 4


def check_large(document, mesh):
    """Of a large mesh FreeCAD's view is given the surface, which it draws as what it finds of a small one; the object has all elements."""
    from freecad.featuremesh import hand_over
    seen, counts = [], []
    for few in (hand_over._LARGE, 1):   # by FreeCAD itself, by the surface
        with mock.patch.object(hand_over, "_LARGE", few):
            move_hole(document, 23)
            move_hole(document, 24)
        seen.append(pixels())
        counts.append(drawn_triangles(mesh))
        arrays = mesh.Proxy.arrays(mesh)
        assert counts[-1] == len(arrays["triangles"]), counts
        assert set(mesh.FemMesh.Volumes) == set(arrays["tet_numbers"].tolist())
    picture("overlay_large")
    same = (seen[0] == seen[1]).all(axis=2).mean()
    assert same > 0.99, same   # lines of the two sides of a face may change places
    assert mesh.ViewObject.MaxFacesShowInner == 0   # else FreeCAD compares all faces with one another, in each undo, too
    mesh.ViewObject.ShowInner = True
    spin()
    assert drawn_triangles(mesh) > 2 * counts[-1], (drawn_triangles(mesh), counts)
    with mock.patch.object(hand_over, "_LARGE", 1):
        move_hole(document, 23)
    assert drawn_triangles(mesh) > 2 * counts[-1], (drawn_triangles(mesh), counts)
    mesh.ViewObject.ShowInner = False
    assert drawn_triangles(mesh) == len(mesh.Proxy.arrays(mesh)["triangles"]) and mesh.ViewObject.MaxFacesShowInner == 0


def check_opened(document, mesh):
    """A mesh of an opened document, and its copy, are there with all elements, and drawn, whether or not FreeCAD saved it."""
    for is_saved in ("Never", "Always"):
        mesh.SavedForFreeCAD = is_saved
        check_copy_of_document(document, mesh)
    assert "Touched" not in mesh.State


def check_copy_of_document(document, mesh):
    from freecad.featuremesh import api, given_mesh
    numbers, count = set(mesh.FemMesh.Volumes), drawn_triangles(mesh)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "opened.FCStd")
        document.saveCopy(path)
        opened = FreeCAD.openDocument(path)
        there, = api.meshes_of(opened)
        copy = opened.copyObject(there)
        for obj in (there, copy):
            assert len(obj.FemMesh.Volumes) == len(numbers) and drawn_triangles(obj) == count, (obj.Name, obj.FemMesh, drawn_triangles(obj), count)
        assert set(there.FemMesh.Volumes) == numbers
        assert not given_mesh._aside
        FreeCAD.closeDocument(opened.Name)
    FreeCAD.setActiveDocument(document.Name)
    Gui.setActiveDocument(document.Name)
    spin()


def check_keyboard():
    """A panel has the keyboard as soon as it is open, so that Escape closes it."""
    Gui.getMainWindow().activateWindow()
    wait_for(Gui.getMainWindow().isActiveWindow)
    for command, kind in (("ShowKept", "KeptPanel"), ("ShowQuality", "QualityPanel"), ("AddSizeZone", "ZonePanel"), ("Study", "StudyPanel")):
        shown = show("FeatureMesh_" + command, kind)
        field = QtGui.QApplication.focusWidget()
        assert field is not None and shown.form.isAncestorOf(field), (command, field)
        send_key(field, QtCore.Qt.Key_Escape)
        wait_for(lambda: not Gui.Control.activeDialog(), 10)


def check_many(path):
    """Seconds of the processor until many elements are shown in colours, and for each step of a drag, against the number of them."""
    document = FreeCAD.openDocument(path)
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    mesh, = [obj for obj in document.Objects if obj.Name == "FeatureMesh"]
    mesh.Proxy.arrays(mesh)
    spin(2)
    start, wall = time.process_time(), time.monotonic()
    Gui.runCommand("FeatureMesh_ShowQuality")
    QtGui.QApplication.processEvents()
    Gui.updateGui()
    figures.append("quality of %d elements: %.2f s of the processor, %.2f s" % (mesh.TetCount, time.process_time() - start, time.monotonic() - wall))
    shown = panel("QualityPanel")
    Gui.SendMsgToActiveView("ViewFit")   # only now is the mesh shown
    picture("many")
    for filled in (False, True):
        shown.cut.filled.setChecked(filled)
        shown.cut.setChecked(True)
        start = time.process_time()
        for step in range(50, 350, 30):
            shown.cut.slider.setValue(step)
            QtGui.QApplication.processEvents()
        figures.append("a step of a drag%s: %.2f s" % (", filled" if filled else "", (time.process_time() - start) / 10))
        picture("many_cut_%d" % filled)
        shown.cut.setChecked(False)
    close(shown)


def drive():
    from freecad.featuremesh import api
    from parts import plate_with_hole
    window.choose_workbench()
    document = FreeCAD.newDocument("Overlays")
    document.UndoMode = 1
    body = plate_with_hole(document)
    mesh = api.add_mesh(body, 2.5, order=1)
    document.recompute()
    body.ViewObject.Visibility = False
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    check_large(document, mesh)
    check_opened(document, mesh)
    move_hole(document, 24)
    document.openTransaction("Move the hole")
    move_hole(document, 26)
    document.commitTransaction()
    check_keyboard()
    check_kept(document, mesh)
    shown = check_quality(document, mesh)
    check_cut(shown, mesh)
    check_load_double_clicked(document, mesh)
    check_theme(panel("QualityPanel"))
    check_ends(document, mesh)
    if os.environ.get("FEATUREMESH_MANY"):
        check_many(os.environ["FEATUREMESH_MANY"])


window.run(drive)

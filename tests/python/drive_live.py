# SPDX-License-Identifier: GPL-3.0-or-later
"""Drives the live result in FreeCAD's real window: the command, solving beside the window, edits and Cancel on the way, what is seen. Run by test_window.py."""
import contextlib
import os
import sys
import tempfile
import threading
import time
import unittest
from unittest import mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import numpy as np  # noqa: E402
import ObjectsFem  # noqa: E402
import window  # noqa: E402
from analyses import held_and_pushed, quantity  # noqa: E402
from PySide import QtGui  # noqa: E402
from window import (click, click_button_of, click_in_panel, figures, greens, hues, is_whole, on_the_screen, panel, picture, pixels, report_view,  # noqa: E402
                    spin, type_into, wait_for)


@contextlib.contextmanager
def runs_of(document):
    """For each solution that is begun within: was the document being recomputed then?"""
    from freecad.featuremesh import statics
    found, as_it_is = [], statics.SolveJob.run

    def run(job, progress=None):
        found.append(document.Recomputing)
        return as_it_is(job, progress)
    with mock.patch.object(statics.SolveJob, "run", run):
        yield found


@contextlib.contextmanager
def no_solution_ends():
    """However fast the solver is, a solution that is begun within ends after that."""
    from freecad.featuremesh import statics
    may_end, as_it_is = threading.Event(), statics.SolveJob.run

    def run(job, progress=None):
        may_end.wait()
        return as_it_is(job, progress)
    with mock.patch.object(statics.SolveJob, "run", run):
        try:
            yield
        finally:
            may_end.set()


def check_command(document, live_panel, mesh):
    """The command adds the object, solves beside the window, and shows the result in colours with its largest value."""
    from freecad.featuremesh import live_result, statics
    live = live_panel.live
    wait_for(lambda: live.Status == live_result.UP_TO_DATE, 60)
    spin()
    _, report = statics.solve(live.Proxy.analysis(live))
    largest = report["responses"]["max_mises_mpa"]
    assert abs(live.MaxMises / largest - 1) < 1e-6, (live.MaxMises, largest)
    words = live_panel.largest.text()
    assert "%.4g MPa" % largest in words and report["responses"]["max_mises_at"]["on"] in words, words
    assert live_panel.legend.labels[-1] == "%.3g MPa" % largest, live_panel.legend.labels
    assert not live_panel.button.isEnabled() and not live_panel.bar.isVisible()
    assert not mesh.ViewObject.Visibility
    seen = pixels()
    picture("live_mises")
    assert is_whole(live_panel.form), (live_panel.form.width(), live_panel.form.visibleRegion().boundingRect().width())
    assert hues(seen) > 3000, hues(seen)
    return live


def check_first_solution(live_panel):
    """While there is no result yet, it is being solved: nothing is out of date."""
    from freecad.featuremesh import live_result
    wait_for(lambda: live_panel.status.text().startswith("first solution: "), 20)
    assert live_panel.live.Status == live_result.FIRST_SOLVING, live_panel.live.Status
    assert not live_panel.legend.labels and not live_panel.grey.isVisible()


def check_settings(live_panel, live):
    """Each widget changes the picture, and what it says."""
    seen = [pixels()]

    def is_another():
        seen.append(pixels())
        return np.abs(seen[-1] - seen[-2]).sum() > 10000

    def check_is_drawn():
        wait_for(is_another, 20)
    live_panel.field.setCurrentIndex(1)
    check_is_drawn()
    assert "%.4g mm" % live.MaxDisplacement in live_panel.largest.text(), live_panel.largest.text()
    picture("live_displacement")
    live_panel.scale.setValue(1)
    assert "drawn 1 times" in live_panel.largest.text(), live_panel.largest.text()
    check_is_drawn()
    live_panel.scale.setValue(0)
    live_panel.field.setCurrentIndex(0)
    live_panel.top.setValue(live.MaxMises / 3)
    assert live_panel.legend.labels[-1] == "%.3g MPa" % (live.MaxMises / 3)
    check_is_drawn()
    live_panel.cut.setChecked(True)
    check_is_drawn()
    picture("live_cut")
    live_panel.cut.setChecked(False)
    live_panel.top.setValue(0)


def check_small_values(document, live_panel, live):
    """Of displacements near a millionth of a mm the legend has all numbers, and where its colours end can be typed."""
    from freecad.featuremesh import live_result
    force = document.Force.Force
    for newtons in (0.01, 1000):
        document.Force.Force = quantity(newtons, "N")
        document.recompute()
        wait_for(lambda: live.Status == live_result.UP_TO_DATE, 60)
        spin()
        if newtons < 1:
            live_panel.field.setCurrentIndex(1)
            spin()
            picture("live_small")
            assert live.MaxDisplacement < 2e-5, live.MaxDisplacement
            labels = [label for _, label in live_panel.legend.placed_labels()]
            assert len(labels) == 4 and labels[-1] == "0" and "e-" in labels[1], (labels, live_panel.legend.width())
            assert "drawn 5000000 times" in live_panel.largest.text(), live_panel.largest.text()
            QtGui.QApplication.setActiveWindow(Gui.getMainWindow())   # there is no window manager
            live_panel.top.setFocus()
            spin()
            type_into(live_panel.top, "0.000002")
            assert abs(live_panel.view.settings.top - 2e-6) < 1e-12, live_panel.view.settings
            assert live_panel.legend.labels[-1] == "2e-6 mm", live_panel.legend.labels
            live_panel.field.setCurrentIndex(0)
    assert document.Force.Force == force, (force, document.Force.Force)


def check_edit(document, live_panel, live):
    """After an edit the old picture is grey until the new one is there; then the change since the last result is at a click."""
    from freecad.featuremesh import live_overlay, live_result, statics_result
    before, largest = live.Proxy.solution, live.MaxMises
    seen, show = [], statics_result.show

    def looked_at(*words, **options):
        seen.append(hues(on_the_screen()))
        return show(*words, **options)
    statics_result.show = looked_at
    with runs_of(document) as runs:
        document.getObject("HoleSketch").setDatum("X", FreeCAD.Units.Quantity("26 mm"))
        document.recompute()
    assert runs == [True], runs   # begun before FreeCAD had the mesh
    assert live.Status != live_result.UP_TO_DATE and live.MaxMises == largest
    live_panel.refresh()
    assert live_panel.legend.labels == ["out of date"] and not live_panel.largest.text()
    drawn = live.ViewObject.Proxy.drawn
    assert np.ptp(drawn.node_colours, axis=1).max() < 1e-12   # grey
    wait_for(lambda: live.Status == live_result.UP_TO_DATE, 60)
    statics_result.show = show
    assert runs == [True], runs   # and not once more
    assert seen[-1] > 3000, seen   # in colours before FreeCAD's own result object is made
    spin()
    assert live.MaxMises != largest and live.Result.Label == "LiveResult", live.Result.Label
    wait_for(lambda: hues(pixels()) > 3000, 20)
    assert live.Proxy.before is before
    assert live_panel.difference.isEnabled()
    click(live_panel.difference)
    assert live_panel.difference.isChecked()
    values = live.ViewObject.Proxy.drawn.values
    new = live.Proxy.solution
    old_row = {number: row for row, number in enumerate(before.arrays["node_numbers"].tolist())}
    known = 0
    for row, number in enumerate(new.arrays["node_numbers"].tolist()):
        if number in old_row:
            known += 1
            assert values[row] == new.von_mises[row] - before.von_mises[old_row[number]]
        else:
            assert np.isnan(values[row])
    assert 0.5 < known / len(values) < 1, known / len(values)
    assert live_panel.grey.isVisible()   # it says what grey nodes are
    spin()
    picture("live_difference")
    click(live_panel.difference)
    assert not live_panel.grey.isVisible()
    assert live_overlay.FIELDS[live_panel.field.currentIndex()] == "von_mises"


def check_load_after_mesh(document, live, mesh):
    """A load that the recompute changes after the mesh is not that of the solution which was begun; it is solved again."""
    from freecad.featuremesh import live_result, statics
    force, unit = document.Force.Force, "" if isinstance(document.Force.Force, float) else " * 1 N"
    document.Force.setExpression("Force", mesh.Name + ".NodeCount" + unit)
    document.recompute()
    wait_for(lambda: live.Status == live_result.UP_TO_DATE, 60)
    count = mesh.NodeCount
    with runs_of(document) as runs:
        document.getObject("HoleSketch").setDatum("X", FreeCAD.Units.Quantity("30 mm"))
        document.recompute()
        wait_for(lambda: live.Status == live_result.UP_TO_DATE, 60)
    assert mesh.NodeCount != count and runs == [True, False], (count, mesh.NodeCount, runs)
    _, report = statics.solve(live.Proxy.analysis(live))
    assert abs(live.MaxMises / report["responses"]["max_mises_mpa"] - 1) < 1e-6, live.MaxMises
    document.Force.setExpression("Force", None)
    document.Force.Force = force
    document.recompute()
    document.getObject("HoleSketch").touch()   # as some of FreeCAD's panels leave what they edit
    wait_for(lambda: live.Status == live_result.UP_TO_DATE, 60)


def check_edits_on_the_way(document, live, mesh):
    """A finer mesh takes longer: edits come while it is solved, the window lives, Cancel cancels, and the last edit wins."""
    from freecad.featuremesh import live_result
    from freecad.featuremesh.gui import live_runner
    mesh.Size = 1.2
    with mock.patch.object(live_result, "solve_early", None):   # else it may be solved when the recompute ends
        document.recompute()
    wait_for(lambda: live_runner.run_of(live) is not None and live_runner.run_of(live).running is not None, 60)
    first = live_runner.run_of(live).running
    wait_for(lambda: first.is_done() or Gui.getMainWindow().statusBar().findChildren(QtGui.QWidget, "FeatureMeshLiveBar"), 20)
    picture("live_solving")
    for x in (24, 23, 22):
        document.getObject("HoleSketch").setDatum("X", FreeCAD.Units.Quantity("%g mm" % x))
        start = time.monotonic()
        document.recompute()
        figures.append("recompute while a solution is under way: %.2f s" % (time.monotonic() - start))
        spin(0.1)
    steps, gap, longest = [], 0.0, time.monotonic()
    while live.Status != live_result.UP_TO_DATE:
        QtGui.QApplication.processEvents()
        now = time.monotonic()
        gap, longest = max(gap, now - longest), now
        run = live_runner.run_of(live)
        if run is not None and run.running is not None and run.running.step not in steps:
            steps.append(run.running.step)
        assert now - start < 100
        time.sleep(0.005)
    figures.append("%d tets: from the last edit to the picture %.2f s, longest stop of the window %.2f s, steps %s; %s" % (
        mesh.TetCount, time.monotonic() - start, gap, ", ".join(filter(None, steps)), live.Report[live.Report.index('"seconds"'):]))
    assert not [w for w in Gui.getMainWindow().statusBar().findChildren(QtGui.QWidget) if w.objectName() == "FeatureMeshLiveBar"]
    solution = live.Proxy.solution
    assert np.array_equal(solution.arrays["points"], mesh.Proxy.arrays(mesh)["points"])


def check_waiting_for_the_engine(live):
    """While FreeCAD's own thread waits for the engine, nothing begins that may have to wait for that."""
    from freecad.featuremesh import live_result, waiting
    from freecad.featuremesh.gui import live_runner
    with mock.patch.object(live_runner._Run, "_begin") as begin:
        live_runner.solve(live)
        for _ in range(5):
            time.sleep(0.05)   # longer than between two looks
            waiting.let_the_window_live()
        assert not begin.called and not waiting.is_waiting()
        wait_for(lambda: begin.called)
    wait_for(lambda: live.Status == live_result.UP_TO_DATE, 100)


def check_cancel(document, live_panel, live):
    """Cancel in the panel ends the solution and says so; the same button solves again."""
    from freecad.featuremesh import live_result
    from freecad.featuremesh.gui import live_runner
    document.Force.Force = document.Force.Force * 2
    assert live.Status == live_result.OUT_OF_DATE
    with no_solution_ends():
        document.recompute()
        wait_for(lambda: live_runner.run_of(live) is not None, 20)
        live_panel.refresh()
        assert live_panel.button.isEnabled() and live_panel.bar.isVisible()
        click(live_panel.button)
        assert live.Status == live_result.CANCELLED, live.Status
        assert live_runner.run_of(live) is None
    spin(0.5)
    picture("live_cancelled")
    assert live_panel.legend.labels == ["out of date"]
    before = live.MaxMises
    click(live_panel.button)
    wait_for(lambda: live.Status == live_result.UP_TO_DATE, 100)
    assert abs(live.MaxMises / before - 2) < 1e-3, (live.MaxMises, before)


def check_analysis_deleted(document, live):
    """Deleted while it is solved: that is said, and undo solves again."""
    from freecad.featuremesh import live_result
    from freecad.featuremesh.gui import live_runner
    document.Force.Force = document.Force.Force * 0.5
    with no_solution_ends():
        document.recompute()
        wait_for(lambda: live_runner.run_of(live) is not None and live_runner.run_of(live).running is not None, 20)
        document.openTransaction("Delete")
        document.removeObject("Analysis")
        document.commitTransaction()
    wait_for(lambda: live.Status.startswith("failed"), 60)
    assert "belongs to no analysis" in live.Status, live.Status
    Gui.runCommand("Std_Undo")
    wait_for(lambda: live.Status == live_result.UP_TO_DATE, 60)
    assert live.Result in document.Analysis.Group, [obj.Name for obj in document.Analysis.Group]


def check_copy(document, live):
    """A copy with all that it needs is in no analysis, which it says; undo takes all of it away."""
    count = len(document.Objects)
    document.openTransaction("Paste")
    document.copyObject(live, True)
    document.commitTransaction()
    spin()
    copy, = [obj for obj in document.Objects[count:] if obj.Name.startswith("Live") and hasattr(obj, "MaxMises")]
    assert "belongs to no analysis" in copy.Status, copy.Status
    Gui.runCommand("Std_Undo")
    spin()
    assert len(document.Objects) == count and "Traceback" not in report_view(), report_view()


def check_free_motion(document, live_panel, live):
    """A support that is missing is said with the motion, and the motion is drawn."""
    from freecad.featuremesh import live_result
    analysis, fixed = document.Analysis, document.Fixed
    analysis.removeObject(fixed)
    document.recompute()
    wait_for(lambda: live.Status.startswith("failed"), 60)
    spin(0.5)
    assert "can still move along x, y and z and turn about x, y and z: add a support" in live_panel.status.text(), live_panel.status.text()
    drawn = live.ViewObject.Proxy.drawn
    assert np.abs(drawn.points - drawn.arrays["points"]).max() > 1
    picture("live_motion")
    analysis.addObject(fixed)
    document.recompute()
    wait_for(lambda: live.Status == live_result.UP_TO_DATE and hues(pixels()) > 3000, 100)


def check_ten_nodes(document, live_panel, live, mesh):
    """The remark on 4-node tets comes with a button."""
    from freecad.featuremesh import live_result
    mesh.Size = 2.5
    document.recompute()
    wait_for(lambda: live.Status == live_result.UP_TO_DATE, 100)
    live_panel.refresh()
    assert "too stiff in bending" in live_panel.remarks.text(), live_panel.remarks.text()
    stiff = live.MaxDisplacement
    click(live_panel.ten_nodes)
    wait_for(lambda: mesh.Order == "2nd" and live.Status == live_result.UP_TO_DATE, 100)
    spin()
    assert live.MaxDisplacement > stiff
    assert not live_panel.remarks.text() and not live_panel.ten_nodes.isVisible(), live_panel.remarks.text()
    drawn = live.ViewObject.Proxy.drawn
    corners, _ = drawn.drawn()
    assert len(corners) == 4 * len(drawn.arrays["triangles"])
    picture("live_ten_nodes")


def check_freecads_own(document, live_panel, live):
    """FreeCAD's result panel opens the result object, and colours its mesh; that is taken away when it is out of date."""
    from freecad.featuremesh import live_result
    live_panel.reject()
    spin()
    Gui.activeDocument().setEdit(live.Result.Name)
    spin()
    assert live.Result.Mesh.ViewObject.Visibility and not live.ViewObject.Visibility   # one of two things in one place is seen
    shown, = [widget for widget in Gui.getMainWindow().findChildren(QtGui.QRadioButton) if widget.objectName() == "rb_vm_stress"]
    shown.click()
    spin(0.5)
    picture("live_freecads_panel")
    green = greens(pixels())
    assert green > 1000, green
    Gui.activeDocument().resetEdit()
    Gui.Control.closeDialog()
    assert live.ViewObject.Visibility and not live.Result.Mesh.ViewObject.Visibility
    live.Result.Mesh.ViewObject.Visibility, live.ViewObject.Visibility = True, False
    document.Force.Force = document.Force.Force * 1.5
    assert live.Status == live_result.OUT_OF_DATE
    spin()
    picture("live_freecads_panel_out_of_date")
    wait_for(lambda: greens(pixels()) < green / 10, 20)
    live.Result.Mesh.ViewObject.Visibility = False
    document.recompute()
    wait_for(lambda: live.Status == live_result.UP_TO_DATE, 100)
    live.ViewObject.Visibility = True


def check_beside_a_pipeline(document, analysis, live):
    """Of the live result and FreeCAD's pipeline, in one place with the mesh, that is seen which was shown last; the other when it is deleted. Another analysis is elsewhere."""
    mesh, pipeline = live.Proxy.mesh(live), document.addObject("Fem::FemPostPipeline", "Pipeline")
    mesh.ViewObject.Visibility = True
    analysis.addObject(pipeline)
    assert pipeline.ViewObject.Visibility and not live.ViewObject.Visibility and not mesh.ViewObject.Visibility
    for shown, hidden in ((live, pipeline), (pipeline, live)):
        shown.ViewObject.Visibility = True
        assert shown.ViewObject.Visibility and not hidden.ViewObject.Visibility, (shown.Name, hidden.Name)
    elsewhere = ObjectsFem.makeAnalysis(document)
    elsewhere.addObject(document.addObject("Fem::FemPostPipeline", "Elsewhere"))
    assert pipeline.ViewObject.Visibility and elsewhere.Group[0].ViewObject.Visibility
    for obj in (pipeline, elsewhere.Group[0], elsewhere):
        document.removeObject(obj.Name)
    wait_for(lambda: live.ViewObject.Visibility, 5)


def check_ends(document, live):
    """The drawing is there without the panel, is hidden with the eye in the tree, and the panel closes with the object."""
    spin()
    seen = pixels()
    assert hues(seen) > 3000
    live.ViewObject.Visibility = False
    wait_for(lambda: hues(pixels()) < 300, 20)
    live.ViewObject.Visibility = True
    wait_for(lambda: abs(hues(pixels()) - hues(seen)) < 0.1 * hues(seen), 20)
    live.ViewObject.Proxy.doubleClicked(live.ViewObject)
    spin()
    panel("LivePanel")
    document.removeObject(live.Name)
    wait_for(lambda: not Gui.Control.activeDialog(), 5)


def is_seen(live, mesh):
    """Is the live result seen and the mesh hidden, or the other way round? Waits until one of them is."""
    wait_for(lambda: live() is None or live().ViewObject.Visibility != mesh.ViewObject.Visibility, 20)
    spin(0.5)
    return live() is not None and live().ViewObject.Visibility and not mesh.ViewObject.Visibility


def check_undone(document, analysis, mesh):
    """Undone or deleted, it leaves the mesh in the view and its result in the analysis; redo and undo bring it back in the mesh's place."""
    from freecad.featuremesh import live_result
    click_button_of("FeatureMesh_LiveResult")
    wait_for(Gui.Control.activeDialog, 20)
    live = panel("LivePanel").live
    name = live.Name
    wait_for(lambda: live.Status == live_result.UP_TO_DATE, 60)
    panel("LivePanel").reject()
    known = document.UndoNames
    for open_again in (lambda: click_button_of("FeatureMesh_LiveResult"), lambda: window.double_click(*window.item_of_tree(live.Label))):
        live.ViewObject.hide()
        open_again()
        wait_for(Gui.Control.activeDialog, 20)
        panel("LivePanel").reject()
        assert document.UndoNames == known, document.UndoNames   # to look at it again is nothing to undo
    result = live.Result
    for take_away, bring_back in (("Std_Undo", "Std_Redo"), ("Std_Delete", "Std_Undo")):
        assert is_seen(lambda: document.getObject(name), mesh), take_away
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(document.getObject(name))
        Gui.runCommand(take_away)
        wait_for(lambda: document.getObject(name) is None and mesh.ViewObject.Visibility, 20)
        wait_for(lambda: hues(pixels()) > 3000, 20)   # FreeCAD's own colour of a mesh
        picture("live_gone_" + take_away)
        assert result in analysis.Group, (take_away, [obj.Name for obj in analysis.Group])
        Gui.runCommand(bring_back)
        wait_for(lambda: document.getObject(name) is not None, 20)
    assert is_seen(lambda: document.getObject(name), mesh)
    wait_for(lambda: document.getObject(name).Status == live_result.UP_TO_DATE, 60)   # undo brings it back as it was, or it is solved again
    assert [obj for obj in document.Objects if obj.isDerivedFrom("Fem::FemResultObject")] == [result]


def check_mesh_deleted(document, mesh):
    """Behind its live result: FreeCAD asks nothing, the part is seen, and after undo the live result again."""
    from freecad.featuremesh import live_result
    live, part, name = document.Live, document.Body, mesh.Name
    assert live.ViewObject.Visibility and not mesh.ViewObject.Visibility and not part.ViewObject.Visibility
    asked = window.delete(mesh)
    assert not asked, asked
    wait_for(lambda: part.ViewObject.Visibility, 20)
    picture("live_mesh_gone")
    Gui.runCommand("Std_Undo")
    wait_for(lambda: document.getObject(name) is not None and not part.ViewObject.Visibility, 20)
    wait_for(lambda: live.Status == live_result.UP_TO_DATE, 60)
    wait_for(lambda: hues(pixels()) > 3000, 20)
    assert live.ViewObject.Visibility and not document.getObject(name).ViewObject.Visibility
    return document.getObject(name)


def check_load_in_its_panel(document, mesh):
    """The part is seen alone while a load is edited; then the live result is, with the new load, until undo brings the old one."""
    from freecad.featuremesh import live_result
    live, part = document.Live, document.Body
    wait_for(lambda: live.Status == live_result.UP_TO_DATE, 60)
    seen = live.MaxMises
    Gui.activeDocument().setEdit("Force")
    spin()
    assert part.ViewObject.Visibility and not live.ViewObject.Visibility and not mesh.ViewObject.Visibility
    picture("live_load_panel")
    box = next(widget for widget in Gui.getMainWindow().findChildren(QtGui.QWidget, "spinForce") if widget.isVisible())
    box.setProperty("rawValue", 2 * box.property("rawValue"))
    click_in_panel("Ok")
    wait_for(lambda: live.Status == live_result.UP_TO_DATE and abs(live.MaxMises / seen - 2) < 1e-3, 60)
    assert is_seen(lambda: live, mesh) and not part.ViewObject.Visibility
    Gui.runCommand("Std_Undo")
    wait_for(lambda: live.Status == live_result.UP_TO_DATE and abs(live.MaxMises / seen - 1) < 1e-3, 60)
    document.removeObject(live.Name)


def check_another_of_its_name(document, analysis):
    """After the first is deleted, and after its document was closed and opened again."""
    from freecad.featuremesh import api, documents, live_result
    live = api.live_result(analysis)
    wait_for(lambda: live.Status == live_result.UP_TO_DATE, 60)
    name, of_analysis = live.Name, analysis.Name
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, document.Name + ".FCStd")
        documents.save_document(document, path)
        FreeCAD.closeDocument(document.Name)
        document = FreeCAD.openDocument(path)
    assert document.Name == "Live"
    live = document.getObject(name)
    assert live.Proxy.analysis(live).Name == of_analysis
    document.Force.Force = document.Force.Force * 1.5
    assert live.Status == live_result.OUT_OF_DATE
    document.recompute()
    wait_for(lambda: live.Status == live_result.UP_TO_DATE, 60)


def check_result_deleted(document, live):
    """FEM's mesh of the result, then the result itself, is deleted, another one is made by an edit, and both are undone: one of each is seen in the tree, and redo and undo
    come back to them."""
    from freecad.featuremesh.gui import live_runner

    def there():
        return sorted(obj.TypeId for obj in document.Objects if obj.Name.startswith(("LiveResult", "ResultMesh")) and obj.ViewObject.ShowInTree)

    def edit(length):
        document.openTransaction("Edit")
        document.Plate.Length = length
        document.recompute()
        document.commitTransaction()
        wait_for(lambda: is_solved() and live.Result is not None and live.Result.Mesh is not None, 60)

    def is_solved():
        return live.Status == "up to date" and live_runner.run_of(live) is None

    wanted, length = there(), document.Plate.Length.Value
    assert len(wanted) == 2, wanted
    warning = QtGui.QMessageBox.warning
    QtGui.QMessageBox.warning = staticmethod(lambda *words: QtGui.QMessageBox.Yes)   # FEM's question
    for of_live in (lambda: live.Result.Mesh, lambda: live.Result, lambda: live.Result):
        name = of_live().Name
        window.delete(of_live())
        assert document.UndoNames[0] == "Delete", (name, document.UndoNames)
        edit(length + 1)
        assert there() == wanted, there()
        for step in range(2):
            Gui.runCommand("Std_Undo")
            spin()
        spin(1)
        wait_for(is_solved, 60)
        assert there() == wanted and live.Result is not None and live.Result.Mesh is not None, there()
        for command in 2 * ["Std_Redo"] + 2 * ["Std_Undo"]:
            Gui.runCommand(command)
            spin()
        spin(1)
        wait_for(is_solved, 60)
        assert there() == wanted and live.Result is not None and live.Result.Mesh is not None, there()
    QtGui.QMessageBox.warning = warning
    Gui.Selection.clearSelection()


def drive():
    from freecad.featuremesh import api, engine, live_result
    from parts import plate_with_hole
    if engine.load().statics_missing():
        raise unittest.SkipTest("needs an engine with PETSc")
    window.choose_workbench()
    document = FreeCAD.newDocument("Live")
    document.UndoMode = 1
    body = plate_with_hole(document)
    analysis = held_and_pushed(document, body)
    mesh = api.add_mesh(body, 2.5, order=1)
    document.recompute()
    assert mesh in analysis.Group
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    old = document.addObject("Fem::FemMeshObject", "OldResultMesh")   # as of a solution before
    old.FemMesh = mesh.FemMesh
    with no_solution_ends():
        Gui.runCommand("FeatureMesh_LiveResult")
        spin()
        check_first_solution(panel("LivePanel"))
    spin()
    shown = panel("LivePanel")
    assert mesh.ViewObject.Visibility != bool(shown.view.drawn)   # there is something to see until there is a result
    live = check_command(document, shown, mesh)
    assert not old.ViewObject.Visibility
    document.removeObject(old.Name)
    check_settings(shown, live)
    check_small_values(document, shown, live)
    check_edit(document, shown, live)
    check_load_after_mesh(document, live, mesh)
    check_edits_on_the_way(document, live, mesh)
    check_waiting_for_the_engine(live)
    check_cancel(document, shown, live)
    check_analysis_deleted(document, live)
    check_copy(document, live)
    check_free_motion(document, shown, live)
    check_ten_nodes(document, shown, live, mesh)
    check_freecads_own(document, shown, live)
    check_beside_a_pipeline(document, analysis, live)
    check_ends(document, live)
    check_undone(document, analysis, mesh)
    check_result_deleted(document, next(obj for obj in analysis.Group if live_result.is_live_result(obj)))
    mesh = check_mesh_deleted(document, mesh)
    check_load_in_its_panel(document, mesh)
    check_another_of_its_name(document, analysis)


window.run(drive)

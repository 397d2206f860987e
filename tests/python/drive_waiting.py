# SPDX-License-Identifier: GPL-3.0-or-later
"""For how long FreeCAD's window does not answer while a mesh is made, shown, edited, saved and opened again.

Run by test_window.py; see drive_window.py for the result. FEATUREMESH_MANY_SIZE is the size in mm (default 4; 0.63 are five million elements of
4 nodes). With FEATUREMESH_WAIT=SECONDS the document is saved so long after the edit. Asserts no time:
what is told is the longest time without a turn of the window's loop in each step, and what ran in it.
"""
import os
import sys
import threading
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import window  # noqa: E402
from PySide import QtCore  # noqa: E402
from window import click_in_panel, figures, picture, spin, wait_for  # noqa: E402

SIZE = float(os.environ.get("FEATUREMESH_MANY_SIZE", "4"))
WAIT = float(os.environ.get("FEATUREMESH_WAIT", "0"))
WORTH_TELLING = 0.5   # seconds
HOURS = 3600.0


class Pulse:
    """Turns of the window's loop; a thread looks what runs while none comes."""

    def __init__(self):
        self.last, self.processor = time.monotonic(), time.process_time()
        self.longest, self.of_processor, self.where = 0.0, 0.0, ""
        self.timer = QtCore.QTimer()
        self.timer.timeout.connect(self.beat)
        self.timer.start(20)
        threading.Thread(target=self.look, daemon=True).start()

    def beat(self):
        now, processor = time.monotonic(), time.process_time()
        self.longest, self.of_processor = max(self.longest, now - self.last), max(self.of_processor, processor - self.processor)
        self.last, self.processor = now, processor

    def look(self):
        main = threading.main_thread().ident
        while True:
            time.sleep(0.1)
            waited = time.monotonic() - self.last
            if waited > max(self.longest, WORTH_TELLING):
                self.longest, self.where = waited, where_is(sys._current_frames()[main])

    def take(self):
        """(seconds, of the processor, what ran) of the longest time since it was asked last."""
        self.beat()
        found = self.longest, self.of_processor, self.where
        self.longest, self.of_processor, self.where = 0.0, 0.0, ""
        return found


def where_is(frame):
    """The function that runs, and the lines of FeatureMesh and of this file above it."""
    names = []
    while frame is not None:
        code = frame.f_code
        if "featuremesh" in code.co_filename or os.path.basename(__file__) in code.co_filename:
            names.append("%s:%d %s" % (os.path.basename(code.co_filename), frame.f_lineno, code.co_name))
        frame = frame.f_back
    return " < ".join(names[:4])


def step(pulse, name, work, is_done=lambda: True):
    pulse.take()
    start, processor = time.monotonic(), time.process_time()
    work()
    wait_for(is_done, HOURS)
    spin(0.3)
    seconds, of_processor, where = pulse.take()
    figures.append("%-5s %.2f s (%.2f s of the processor), without an answer at most %.2f s (%.2f)%s"
                   % (name, time.monotonic() - start, time.process_time() - processor, seconds, of_processor, " in " + where if where else ""))


def start_mesh(mesh):
    Gui.activeDocument().setEdit(mesh.Name)
    spin()
    click_in_panel("Ok")


def is_up_to_date(mesh):
    return lambda: mesh.Status == "up to date" and not Gui.Control.activeDialog()


def drive():
    from freecad.featuremesh import api
    window.choose_workbench()
    document = FreeCAD.ActiveDocument
    path = document.FileName
    mesh = api.add_mesh(document.Body, SIZE, order=1, automatic=False)
    Gui.activeDocument().activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    pulse = Pulse()
    step(pulse, "mesh", lambda: start_mesh(mesh), is_up_to_date(mesh))
    assert mesh.TetCount > 0
    picture("waiting_mesh")
    step(pulse, "edit", lambda: move_hole(document, mesh), is_up_to_date(mesh))
    spin(WAIT)
    step(pulse, "save", document.save)
    figures.append("%d elements" % mesh.TetCount)
    FreeCAD.closeDocument(document.Name)
    step(pulse, "open", lambda: FreeCAD.openDocument(path))
    mesh, = api.meshes_of(FreeCAD.ActiveDocument)
    assert mesh.Status == "up to date" and mesh.FemMesh.VolumeCount == mesh.TetCount, mesh.Status
    picture("waiting_opened")


def move_hole(document, mesh):
    document.HoleSketch.setDatum("Hole6X", FreeCAD.Units.Quantity("105 mm"))
    document.recompute()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(mesh)
    Gui.runCommand("FeatureMesh_UpdateNow")


window.run(drive)

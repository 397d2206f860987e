# SPDX-License-Identifier: GPL-3.0-or-later
"""What scripts share that drive FreeCAD's real window: waiting, finding panels and dialogs, pictures, and how they end."""
import gc
import os
import time
import traceback

import FreeCADGui as Gui
from PySide import QtGui

PICTURES = os.environ.get("FEATUREMESH_PICTURES")
messages = []
figures = []   # what was measured on the way, told with the result


def spin(seconds=0.2):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtGui.QApplication.processEvents()
        time.sleep(0.01)


def picture(name):
    if PICTURES:
        spin(0.8)
        QtGui.QGuiApplication.primaryScreen().grabWindow(0).save(os.path.join(PICTURES, name + ".png"))


def panel(kind):
    """The open panel of that class."""
    shown, = [obj for obj in gc.get_objects() if type(obj).__name__ == kind and is_shown(obj.form)]
    return shown


def is_shown(widget):
    try:
        return widget.isVisible()
    except (AttributeError, RuntimeError):   # FreeCAD or Qt has let go of it
        return False


def wait_for(condition, seconds=120):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "waited %d s in vain" % seconds
        spin(0.05)


def texts_of(action):
    """The texts in the menu of an action."""
    menu = action.menu()
    return [entry.text() for entry in menu.actions()] if menu is not None else []


def open_dialog():
    """The one dialog that is open."""
    dialog, = [w for w in QtGui.QApplication.topLevelWidgets() if isinstance(w, QtGui.QDialog) and w.isVisible()]
    return dialog


def run(drive):
    """Ends FreeCAD after `drive`, with its result in the file FEATUREMESH_RESULT: "ok" and what was measured, or what went wrong."""
    QtGui.QMessageBox.warning = staticmethod(lambda *words: messages.append(words[2]))
    try:
        drive()
        result = "\n".join(["ok", *figures])
    except BaseException:
        result = traceback.format_exc() + "\nmessages: %s" % messages
    with open(os.environ["FEATUREMESH_RESULT"], "w", encoding="utf-8") as stream:
        stream.write(result)
    os._exit(0)

# SPDX-License-Identifier: GPL-3.0-or-later
"""An addon beside FeatureMesh that stands for the user: once FreeCAD's window waits for input, it runs the script FEATUREMESH_DRIVER."""
import importlib
import os
import sys

import FreeCAD
from PySide import QtCore


def named_documents():
    """Those that FreeCAD was started with."""
    return [word for word in sys.argv if word.endswith(".FCStd")]


def keep_start_page_away():
    """As "Don't show this Start page again" does: FreeCAD 1.x shows its start page over the document that it was started with, again and again, and crashes
    when the page is closed while it still looks for examples."""
    FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/Start").SetBool("ShowOnStartup", False)


def is_ready():
    """Does FreeCAD wait for its user, with all that it was started with open?"""
    documents = list(FreeCAD.listDocuments().values())
    return (QtCore.QThread.currentThread().loopLevel() > 0 and len(documents) >= len(named_documents())
            and not any(document.Restoring for document in documents))


def start_when_ready():
    global seen
    seen = seen + 1 if is_ready() else 0
    if seen > 3:   # it looks at events while it opens a document, too
        timer.stop()
        folder, script = os.path.split(os.environ["FEATUREMESH_DRIVER"])
        sys.path.insert(0, folder)
        importlib.import_module(script[:-len(".py")])


if named_documents():
    keep_start_page_away()
seen = 0
timer = QtCore.QTimer()
timer.timeout.connect(start_when_ready)
timer.start(100)

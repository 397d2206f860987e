# SPDX-License-Identifier: GPL-3.0-or-later
"""Drives FreeCAD's real window: About FeatureMesh, its button, and the log that it names. Run by test_window.py."""
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCADGui as Gui  # noqa: E402
import window  # noqa: E402
from PySide import QtGui  # noqa: E402
from window import open_dialog, picture, spin  # noqa: E402


def drive():
    Gui.activateWorkbench("FeatureMeshWorkbench")
    spin()
    for dialog in QtGui.QApplication.topLevelWidgets():   # the welcome of a first start
        if isinstance(dialog, QtGui.QDialog) and dialog.isVisible():
            dialog.close()
    spin()
    Gui.runCommand("FeatureMesh_About")
    spin()
    about = open_dialog()
    assert about.objectName() == "FeatureMesh_About", about.objectName()
    picture("about")
    text = about.text.toPlainText()
    for pattern in (r"FeatureMesh: +\d+\.\d+\.\d+, installed as an addon",
                    r"Engine: +\d+\.\d+\.\d+, protocol \d+, .* in a process of its own", r"OCCT \d+\.\d+.*, CGAL 6\.\d+.*, oneTBB 20",
                    r"FreeCAD: +\d+\.\d+\.\d+ with OCCT", r"Python: +3\.\d+\.\d+, numpy \d"):
        assert re.search(pattern, text), (pattern, text)
    about.copy.click()
    assert QtGui.QApplication.clipboard().text() == text
    log = re.search(r"^Log: +(.*)$", text, re.MULTILINE).group(1)
    with open(log, encoding="utf-8") as lines:
        assert re.search(r"INFO engine .* in ", lines.read())
    about.close()
    spin()


window.run(drive)

# SPDX-License-Identifier: GPL-3.0-or-later
"""What somebody sees who comes to the workbench for the first time."""

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import preferences
from ..view_provider import drawn_icon

translate = FreeCAD.Qt.translate


def show_once():
    """Shows the welcome unless the user has seen it."""
    if not preferences.get("WelcomeSeen"):
        preferences.put("WelcomeSeen", True)
        show()


def show():
    """Shows the welcome beside the work, which goes on. Returns its window."""
    dialog = QtGui.QDialog(Gui.getMainWindow())
    dialog.setWindowTitle(translate("FeatureMesh", "Welcome to FeatureMesh"))
    dialog.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    layout = QtGui.QVBoxLayout(dialog)
    heading = QtGui.QLabel(translate("FeatureMesh", "A mesh that follows your part"))
    font = heading.font()
    font.setPointSize(font.pointSize() + 5)
    font.setBold(True)
    heading.setFont(font)
    layout.addWidget(heading)
    layout.addLayout(_steps())
    buttons = QtGui.QDialogButtonBox(QtGui.QDialogButtonBox.Close)
    buttons.rejected.connect(dialog.reject)
    layout.addWidget(buttons)
    dialog.show()
    return dialog


def _steps():
    steps = QtGui.QGridLayout()
    steps.setVerticalSpacing(14)
    steps.setHorizontalSpacing(14)
    for row, (name, text) in enumerate((
            ("FeatureMesh_MeshPart", translate("FeatureMesh", "Open a part, select its body and press <b>Mesh a part</b>. Choose a size; the "
                                                              "panel tells how many elements it gives. Press <b>OK</b>.")),
            ("FeatureMesh_UpdateNow", translate("FeatureMesh", "Edit the part: move a hole, change a thickness. The mesh follows, and only "
                                                               "around the edit; loads and supports stay where they are.")),
            ("FeatureMesh_ShowKept", translate("FeatureMesh", "<b>Show what was kept</b> colours what stayed and what is new; <b>Show the "
                                                              "quality</b> finds the worst elements.")),
            ("FeatureMesh_AddLocalSize", translate("FeatureMesh", "Select a face and press <b>Add a local size</b> where the mesh shall be "
                                                                  "finer. All of this is in FEM's Mesh menu, too.")))):
        picture = QtGui.QLabel()
        picture.setPixmap(drawn_icon(name).pixmap(40, 40))
        label = QtGui.QLabel(text)
        label.setWordWrap(True)
        label.setMinimumWidth(380)
        steps.addWidget(picture, row, 0, QtCore.Qt.AlignTop)
        steps.addWidget(label, row, 1)
    return steps

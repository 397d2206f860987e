# SPDX-License-Identifier: GPL-3.0-or-later
"""The window of About FeatureMesh: what a bug report needs to know, with a button that copies it."""

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import about
from ..user_words import in_words

translate = FreeCAD.Qt.translate


def show():
    """Shows the window; gives it."""
    window = _About(about.text(in_words))
    window.show()
    return window


class _About(QtGui.QDialog):

    def __init__(self, text):
        super().__init__(Gui.getMainWindow())
        self.setObjectName("FeatureMesh_About")
        self.setWindowTitle(translate("FeatureMesh", "About FeatureMesh"))
        self.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        self.text = QtGui.QPlainTextEdit(text)
        self.text.setReadOnly(True)
        self.text.setFont(QtGui.QFontDatabase.systemFont(QtGui.QFontDatabase.FixedFont))
        buttons = QtGui.QDialogButtonBox(QtGui.QDialogButtonBox.Close)
        self.copy = buttons.addButton(translate("FeatureMesh", "Copy for a bug report"), QtGui.QDialogButtonBox.ActionRole)
        self.copy.clicked.connect(lambda: QtGui.QApplication.clipboard().setText(about.text()))   # in English, for whoever reads it
        buttons.rejected.connect(self.close)
        layout = QtGui.QVBoxLayout(self)
        layout.addWidget(self.text)
        layout.addWidget(buttons)
        self.resize(900, 260)

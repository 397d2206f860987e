# SPDX-License-Identifier: GPL-3.0-or-later
"""Message boxes over FreeCAD's window. Qt's own would read a label that looks like HTML as that."""

import FreeCADGui as Gui
from PySide import QtCore, QtGui


def of_text(title, text, icon=QtGui.QMessageBox.NoIcon, parent=None):
    """A box that shows the text as it is; it has no buttons yet."""
    box = QtGui.QMessageBox(parent or Gui.getMainWindow())
    box.setWindowTitle(title)
    box.setIcon(icon)
    box.setTextFormat(QtCore.Qt.PlainText)
    box.setText(text)
    return box


def warn(text):
    """Tells what went wrong, and waits until it was read."""
    of_text("FeatureMesh", text, QtGui.QMessageBox.Warning).exec_()


def is_agreed(title, question, parent):
    """Is Yes clicked, not No?"""
    box = of_text(title, question, QtGui.QMessageBox.Question, parent)
    yes, no = box.addButton(QtGui.QMessageBox.Yes), box.addButton(QtGui.QMessageBox.No)
    box.setDefaultButton(no)
    box.exec_()
    return box.clickedButton() is yes


def answer(title, text, more, choices, is_risky=False):
    """The key of the choice that was clicked in a message box, the first by default unless that is risky; None for Cancel, or then by default."""
    box = of_text(title, text)
    box.setInformativeText(more)
    roles = [QtGui.QMessageBox.AcceptRole, QtGui.QMessageBox.ActionRole]
    buttons = {key: box.addButton(choice, role) for (key, choice), role in zip(choices.items(), roles)}
    cancel = box.addButton(QtGui.QMessageBox.Cancel)
    box.setDefaultButton(cancel if is_risky else next(iter(buttons.values())))
    box.exec_()
    return next((key for key, button in buttons.items() if box.clickedButton() is button), None)

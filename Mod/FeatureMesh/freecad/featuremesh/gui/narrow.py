# SPDX-License-Identifier: GPL-3.0-or-later
"""Lets task panels fit into FreeCAD's dock as it is at first, about 215 pixels between its margins."""

import FreeCADGui as Gui
from PySide import QtCore, QtGui

_LETTERS = 8       # a box is never narrower
_MARGIN = 4
_TITLE = 180       # pixels of a panel's title beside its picture and its arrow
_AROUND_TEXT = 12  # pixels that a button, or the list of a box, needs beside its text


def box(chooser):
    """A combo box that has all its entries: it may become narrower than they are; its list and its tool tip show them whole."""
    chooser.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
    chooser.setMinimumContentsLength(_LETTERS)
    shown = chooser.view()
    shown.setTextElideMode(QtCore.Qt.ElideNone)
    shown.setMinimumWidth(max(shown.sizeHintForColumn(0), 0) + _AROUND_TEXT)
    about = chooser.toolTip()

    def tell(text):
        chooser.setToolTip("\n".join(filter(None, (text, about))))
    tell(chooser.currentText())
    chooser.currentTextChanged.connect(tell)


class Words(QtGui.QLabel):
    """A label of as many lines as its words need."""

    def __init__(self, words=""):
        super().__init__(words)
        self.setTextFormat(QtCore.Qt.PlainText)   # an object's label in it may look like HTML
        self.setWordWrap(True)


class OneLine(QtGui.QLabel):
    """A label of one line, however narrow; what has no room in its middle is in its tool tip."""

    def __init__(self, words):
        super().__init__(words)
        self._words = words
        self.setTextFormat(QtCore.Qt.PlainText)   # a label may look like HTML
        self.setToolTip(words)
        self.setSizePolicy(QtGui.QSizePolicy.Ignored, QtGui.QSizePolicy.Fixed)

    def resizeEvent(self, event):
        super().resizeEvent(event)
        self.setText(self.fontMetrics().elidedText(self._words, QtCore.Qt.ElideMiddle, self.width()))


def title(form, words):
    """The title of a panel, which FreeCAD makes as wide as that."""
    font = form.font()
    font.setBold(True)
    form.setWindowTitle(QtGui.QFontMetrics(font).elidedText(words, QtCore.Qt.ElideMiddle, _TITLE))


def margins(layout):
    """FreeCAD puts margins of its own around a panel."""
    layout.setContentsMargins(_MARGIN, layout.contentsMargins().top(), _MARGIN, layout.contentsMargins().bottom())


class Form(QtGui.QWidget):
    """The form of a panel with OK, Cancel and Apply above it, which FreeCAD shows with it."""

    def showEvent(self, event):
        super().showEvent(event)
        QtCore.QTimer.singleShot(0, buttons)


def buttons():
    """OK, Cancel and Apply above the open panel, side by side: without pictures, and no wider than their texts where there is no more room.

    They are looked for: FreeCAD's hook modifyStandardButtons leaves PySide 2 with a box that is gone when the next panel opens.
    """
    for above in Gui.getMainWindow().findChildren(QtGui.QDialogButtonBox):
        for kind in (QtGui.QDialogButtonBox.Ok, QtGui.QDialogButtonBox.Cancel, QtGui.QDialogButtonBox.Apply):
            button = above.button(kind) if above.isVisible() else None
            if button is not None:
                button.setIcon(QtGui.QIcon())
                button.setMinimumWidth(button.fontMetrics().boundingRect(button.text()).width() + _AROUND_TEXT)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Lets the mouse's wheel scroll a task panel and change nothing on the way: only a field that was clicked takes it."""

from PySide import QtCore

_TAKE_IT = ("QAbstractSpinBox", "QComboBox", "QSlider")


def scrolls(form):
    """To be called when all widgets of the panel are there."""
    ignoring = _Ignoring(form)
    for widget in form.findChildren(QtCore.QObject):
        if any(widget.inherits(kind) for kind in _TAKE_IT):
            widget.setFocusPolicy(QtCore.Qt.StrongFocus)   # with Qt's own a turn of the wheel is as good as a click
            widget.installEventFilter(ignoring)


class _Ignoring(QtCore.QObject):

    def eventFilter(self, widget, event):
        if event.type() != QtCore.QEvent.Wheel or widget.hasFocus():
            return False
        event.ignore()   # Qt asks what the widget is in, down to the panel's scroll bar
        return True

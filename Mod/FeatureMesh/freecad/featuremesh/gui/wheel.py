# SPDX-License-Identifier: GPL-3.0-or-later
"""Lets the mouse's wheel scroll a task panel and change nothing on the way: only a field that was clicked, or reached by a key, takes it."""

from PySide import QtCore, QtGui

from .freecad_widget import widgets_in


def scrolls(form):
    """To be called when all widgets of the panel are there. Returns what gives one of them the keyboard."""
    keeper = _Keeper(form)
    for widget in widgets_in(form, QtGui.QAbstractSpinBox, QtGui.QComboBox, QtGui.QSlider):
        widget.setFocusPolicy(QtCore.Qt.StrongFocus)   # with Qt's own a turn of the wheel is as good as a click
        for part in (widget, *widgets_in(widget, QtGui.QLineEdit)):
            part.installEventFilter(keeper)
    return keeper


class _Keeper(QtCore.QObject):
    """Of the wheel."""

    _is_given = False   # has a field the keyboard that nobody asked for, and no use was made of it?

    def give_keyboard(self, field):
        """Lets what is typed go into a field, as the Tab key does, but not the wheel."""
        field.setFocus(QtCore.Qt.TabFocusReason)
        self._is_given = True

    def eventFilter(self, widget, event):
        if event.type() in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.KeyPress):
            self._is_given = False
        if event.type() != QtCore.QEvent.Wheel or widget.inherits("QLineEdit") or widget.hasFocus() and not self._is_given:
            return False
        event.ignore()   # Qt asks what the widget is in, down to the panel's scroll bar
        return True

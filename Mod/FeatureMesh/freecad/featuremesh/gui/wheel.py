# SPDX-License-Identifier: GPL-3.0-or-later
"""Gives the keyboard to a task panel that opens, and lets the mouse's wheel scroll it and change nothing on the way: only a field that was clicked, or reached by
a key, takes it."""

from PySide import QtCore, QtGui

from .freecad_widget import widgets_in


def scrolls(form, *first_fields):
    """To be called when all widgets of the panel are there. Of `first_fields` the first that can be used has the keyboard when the panel is shown first, so
    that keys are for the panel, Escape too."""
    keeper = _Keeper(form, first_fields)
    form.installEventFilter(keeper)
    for widget in widgets_in(form, QtGui.QAbstractSpinBox, QtGui.QComboBox, QtGui.QSlider):
        widget.setFocusPolicy(QtCore.Qt.StrongFocus)   # with Qt's own a turn of the wheel is as good as a click
        for part in (widget, *widgets_in(widget, QtGui.QLineEdit)):
            part.installEventFilter(keeper)


class _Keeper(QtCore.QObject):
    """Of the wheel."""

    def __init__(self, form, first_fields):
        super().__init__(form)
        self._first_fields = first_fields
        self._is_given = False   # has a field the keyboard that nobody asked for, and no use was made of it?

    def give_keyboard(self):
        """Lets what is typed go into the panel, as the Tab key does, but not the wheel."""
        for field in [field for field in self._first_fields if field.isEnabled()][:1]:
            field.setFocus(QtCore.Qt.TabFocusReason)
            self._is_given = True
        self._first_fields = ()

    def eventFilter(self, widget, event):
        if event.type() == QtCore.QEvent.Show:
            QtCore.QTimer.singleShot(0, self.give_keyboard)   # when FreeCAD has shown all of the panel
        if event.type() in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.KeyPress):
            self._is_given = False
        if event.type() != QtCore.QEvent.Wheel or widget.inherits("QLineEdit") or widget.hasFocus() and not self._is_given:
            return False
        event.ignore()   # Qt asks what the widget is in, down to the panel's scroll bar
        return True

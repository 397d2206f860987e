# SPDX-License-Identifier: GPL-3.0-or-later
"""Widgets of FreeCAD's own, such as its fields for quantities, and what their forms share."""

import FreeCADGui as Gui
from PySide import QtCore, QtGui


def made(kind):
    """A new one, of a class such as "Gui::QuantitySpinBox".

    FreeCAD 0.20, and PySide 6 where other code looked for all fields of the window, do not forget by what Python knew such a widget. Where a new one comes to
    lie at the place in memory of one that is gone, they give that, of which no use can be made any more, or whose signals are gone. The new one then stays
    there, unused, so that the next lies elsewhere.
    """
    loader = Gui.UiLoader()
    while True:
        widget = loader.createWidget(kind)
        try:
            widget.objectName()
        except RuntimeError:
            continue
        if not vars(widget):   # else the signals that somebody asked the one that is gone for
            return widget


def length_field():
    """A field for a length: a bare number is one in the user's unit, `rawValue` is in mm."""
    field = made("Gui::QuantitySpinBox")
    field.setProperty("unit", "mm")
    field.editingFinished.connect(lambda: _show_what_was_read(field))
    return field


def _show_what_was_read(field):
    """FreeCAD reads "3,5" as 35 where it counts in English, and 0.20 shows what was typed even when the field is left."""
    if QtCore.QLocale().groupSeparator() in field.property("text"):
        was_blocked = field.blockSignals(True)
        field.setProperty("rawValue", field.property("rawValue"))
        field.blockSignals(was_blocked)


def widgets_in(form, *kinds):
    """Those of these classes; what Python takes for one that is gone (see `made`) is left out."""
    for kind in kinds:
        for widget in form.findChildren(kind):
            try:
                widget.objectName()
            except RuntimeError:
                continue
            yield widget


def silence(form):
    """Before what a form changes is deleted: a field in which somebody still types tells of its value when the form closes."""
    for widget in widgets_in(form, QtGui.QAbstractSpinBox, QtGui.QLineEdit, QtGui.QComboBox, QtGui.QAbstractButton, QtGui.QAbstractItemView):
        widget.blockSignals(True)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Widgets of FreeCAD's own, such as its fields for quantities."""

import FreeCADGui as Gui


def made(kind):
    """A new one, of a class such as "Gui::QuantitySpinBox".

    FreeCAD 0.20 never forgets by what Python knew such a widget. Where a new one comes to lie at the place in memory of one that is gone, it gives that, of
    which no use can be made any more. The new one then stays there, unused, so that the next lies elsewhere.
    """
    loader = Gui.UiLoader()
    while True:
        widget = loader.createWidget(kind)
        try:
            widget.objectName()
        except RuntimeError:
            continue
        return widget

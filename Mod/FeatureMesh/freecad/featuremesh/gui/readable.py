# SPDX-License-Identifier: GPL-3.0-or-later
"""Colours of texts that can be read in light themes and in dark ones."""

from PySide import QtGui

_PALER = 0.45   # how far on the way to white
_BRIGHT = 127


def colour_on(widget, name):
    """A colour, by its name such as "#c62828", as the widget's texts can have it: paler where the theme gives the widget bright texts on what is dark."""
    widget.ensurePolished()
    colour, text = QtGui.QColor(name), widget.palette().color(QtGui.QPalette.WindowText)
    if text.lightness() <= _BRIGHT:
        return colour
    return QtGui.QColor(*(round(one + _PALER * (255 - one)) for one in colour.getRgb()[:3]))

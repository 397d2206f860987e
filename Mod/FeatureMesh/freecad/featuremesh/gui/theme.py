# SPDX-License-Identifier: GPL-3.0-or-later
"""Another theme for lists in docks: FreeCAD 1.1 gives them colours by a style sheet of their own, which it reads again only when another one is chosen."""

import FreeCAD
from PySide import QtCore

_SHEET = "OverlayActiveStyleSheet"
_LATER = 1000   # ms: FreeCAD has taken the new theme by then
_observer = None   # FreeCAD keeps no reference to it


def install():
    """To be called once."""
    global _observer
    _observer = _Observer(FreeCAD.ParamGet("User parameter:BaseApp/Preferences/MainWindow"))


class _Observer:

    def __init__(self, settings):
        self._settings = settings
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._read_again)
        settings.Attach(self)

    def onChange(self, _, name):
        """Called by FreeCAD."""
        if name in ("Theme", "StyleSheet"):
            self._timer.start(_LATER)

    def _read_again(self):
        sheet = self._settings.GetString(_SHEET)
        if sheet:
            self._settings.SetString(_SHEET, "")
            self._settings.SetString(_SHEET, sheet)

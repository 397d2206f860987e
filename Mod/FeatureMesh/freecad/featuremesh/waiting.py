# SPDX-License-Identifier: GPL-3.0-or-later
"""Lets FreeCAD's window redraw itself while FreeCAD's own thread is busy or waits."""

import threading

# What the window's side does for that; None where there is no window.
repaint = None
_is_repainting = False


def let_the_window_live():
    """To be called now and then in long work, from any thread."""
    global _is_repainting
    if repaint is None or threading.current_thread() is not threading.main_thread():
        return
    was, _is_repainting = _is_repainting, True
    try:
        repaint()
    finally:
        _is_repainting = was


def is_waiting():
    """Does FreeCAD's own thread wait for the engine? What a timer begins meanwhile may have to wait for what that wait keeps, for ever."""
    return _is_repainting

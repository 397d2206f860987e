# SPDX-License-Identifier: GPL-3.0-or-later
"""Lets FreeCAD's window redraw itself while FreeCAD's own thread is busy or waits."""

import threading

# What the window's side does for that; None where there is no window.
repaint = None


def let_the_window_live():
    """To be called now and then in long work, from any thread."""
    if repaint is not None and threading.current_thread() is threading.main_thread():
        repaint()

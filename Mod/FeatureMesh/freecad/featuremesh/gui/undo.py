# SPDX-License-Identifier: GPL-3.0-or-later
"""What a command or a panel changes in a document, as one undo step or not at all."""
import contextlib

import FreeCAD


@contextlib.contextmanager
def undo_step(document, title):
    """What is changed within is one step of the document's undo; an exception takes it back and goes on."""
    document.openTransaction(title)
    try:
        yield
    except Exception:
        FreeCAD.closeActiveTransaction(True)   # abortTransaction would leave one open in which nothing was changed yet
        raise
    document.commitTransaction()

# SPDX-License-Identifier: GPL-3.0-or-later
"""What task panels share that show an object and stay open."""

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import versions
from . import freecad_widget


_open = []   # the panel of this kind that is


def close_open():
    """Closes the panel that only shows something, if one is open, so that another one can be opened. What is shown and hidden by it is not in the step of undo
    that FreeCAD has begun for the other one, whose *Cancel* would take it back."""
    step = FreeCAD.getActiveTransaction()
    if _open and step:
        end_empty_step()
    for panel in list(_open):
        panel.reject()
        if step:
            FreeCAD.setActiveTransaction(step[0])


def end_empty_step():
    """Ends FreeCAD's own step of undo, in which nothing is yet; what was done before may be in one that FreeCAD had left open."""
    FreeCAD.closeActiveTransaction(not any(opened.HasPendingTransaction for opened in FreeCAD.listDocuments().values()))


class ClosesWithObject:
    """A document observer that closes its task panel when the object that it shows is deleted, or the object's document is closed."""

    def end(self):
        """Leaves everything that the panel follows; may be called twice, also when the form is gone."""
        raise NotImplementedError

    def watch(self, obj):
        self._watched, self._document = obj, obj.Document
        FreeCAD.addDocumentObserver(self)
        _open.append(self)
        self.form.destroyed.connect(lambda: self.end())   # others close panels, too, without a word to them

    def unwatch(self):
        FreeCAD.removeDocumentObserver(self)
        _open.remove(self)

    # FreeCAD's side

    def getStandardButtons(self):
        return versions.number_of(QtGui.QDialogButtonBox.Close)

    def slotDeletedObject(self, obj):
        if obj is self._watched:
            self._close()

    def slotDeletedDocument(self, document):
        if document is self._document:
            self._close()

    def _close(self):
        self.end()
        freecad_widget.silence(self.form)
        QtCore.QTimer.singleShot(0, Gui.Control.closeDialog)

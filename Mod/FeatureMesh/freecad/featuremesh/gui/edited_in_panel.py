# SPDX-License-Identifier: GPL-3.0-or-later
"""What view providers share whose object is edited in a task panel."""

import FreeCADGui as Gui

from ..errors import UserError
from ..messages import said
from ..proxies import View
from . import closes_with_object, errors, recording


class EditedInPanel(View):
    """A double click opens the panel that `panel_of` gives, in place of one that only shows something, or says that another one is open."""

    def panel_of(self, obj):
        raise NotImplementedError

    def setEdit(self, view, mode=0):
        if Gui.Control.activeDialog():
            return False
        recording.watch(view.Object)
        Gui.Control.showDialog(self.panel_of(view.Object))
        return True

    def unsetEdit(self, view, mode=0):
        Gui.Control.closeDialog()
        return True

    def doubleClicked(self, view):
        document = Gui.getDocument(view.Object.Document)
        if Gui.Control.activeDialog() and getattr(document.getInEdit(), "Object", None) is view.Object:
            return True
        closes_with_object.close_open()
        if not Gui.Control.activeDialog():
            closes_with_object.end_empty_step()   # of what the panel only shows or hides
            document.setEdit(view.Object.Name)
        else:
            errors.show(UserError(said("{object:text} cannot be opened while a panel is open; close that first", object=view.Object.Label)))
        return True


class DrawnByUs(EditedInPanel):
    """What it draws is its only display mode."""

    mode = ""   # its name, which is stored in documents and never changes

    def getDisplayModes(self, view):
        return [self.mode]

    def getDefaultDisplayMode(self):
        return self.mode

    def setDisplayMode(self, mode):
        return mode

# SPDX-License-Identifier: GPL-3.0-or-later
"""What view providers share whose object is edited in a task panel."""

import FreeCADGui as Gui

from ..proxies import View


class EditedInPanel(View):
    """A double click opens the panel that `panel_of` gives, unless another one is open."""

    def panel_of(self, obj):
        raise NotImplementedError

    def setEdit(self, view, mode=0):
        if Gui.Control.activeDialog():
            return False
        Gui.Control.showDialog(self.panel_of(view.Object))
        return True

    def unsetEdit(self, view, mode=0):
        Gui.Control.closeDialog()
        return True

    def doubleClicked(self, view):
        document = Gui.getDocument(view.Object.Document)
        if not document.getInEdit():
            document.setEdit(view.Object.Name)
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

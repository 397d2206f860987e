# SPDX-License-Identifier: GPL-3.0-or-later
"""What the panels share that show a mesh's elements in colours: the cut, following the mesh, and an end with the mesh."""

import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import view_provider
from ..errors import UserError
from ..mesh_properties import what_it_is_of
from ..messages import of_error
from ..user_words import as_sentence
from . import narrow, showing, wheel
from .closes_with_object import ClosesWithObject
from .cut_box import CutBox


class OverlayPanel(ClosesWithObject):
    """Colours the elements while it is open, and those of the new mesh after an edit."""

    def __init__(self, mesh, title, icon):
        self.mesh = mesh
        self.overlay = None
        self.form = QtGui.QWidget()
        narrow.title(self.form, title)
        self.form.setWindowIcon(view_provider.drawn_icon(icon))
        self.layout = QtGui.QVBoxLayout(self.form)
        narrow.margins(self.layout)
        self.note = narrow.Words()
        self.cut = CutBox(self.draw)
        self._later = QtCore.QTimer()
        self._later.setSingleShot(True)
        self._later.timeout.connect(self.refresh)

    def start(self, first_field):
        """To be called when the panel's own widgets are there; that one has the keyboard first. Throws UserError when there is nothing to show."""
        self.layout.addWidget(self.cut)
        self.layout.addWidget(self.note)
        wheel.scrolls(self.form, first_field)
        self.overlay = self.make_overlay()
        Gui.Selection.clearSelection()   # what is selected is drawn in one colour
        self._seen_before = showing.show_elements(self.mesh)
        self._show()
        view_provider.followers.append(self._follow)
        self.form.destroyed.connect(lambda: self._closed_by_others())
        self.watch(self.mesh)

    def make_overlay(self):
        """The overlays.Overlay of the mesh as it is. Throws UserError when there is none."""
        raise NotImplementedError

    def fill(self):
        """Brings the widgets up to date with the overlay, which may be None."""
        raise NotImplementedError

    def marked(self):
        """Draws what is marked over the elements."""

    def refresh(self):
        """After the mesh or what is asked for has changed."""
        said = ""
        try:
            self.overlay = self.make_overlay()
        except (UserError, RuntimeError) as error:   # ours and the engine's; nothing of what was is shown any longer
            self.overlay, said = None, as_sentence(of_error(error))
        self._show(said)

    def draw(self):
        """The elements, cut open as the widget says."""
        if self.overlay is None:
            self.mesh.ViewObject.Proxy.show(self.mesh, None)
        else:
            self.mesh.ViewObject.Proxy.show(self.mesh, self.overlay, self.cut.plane(), self.cut.filled.isChecked())

    def reject(self):
        self.end()
        self.mesh.ViewObject.Proxy.show(self.mesh, None)
        showing.restore(self._seen_before)
        Gui.Control.closeDialog()
        return True

    def _show(self, said=""):
        self.note.setText(said or what_it_is_of(self.mesh))
        if self.overlay is not None:
            self.cut.set_box(self.overlay.points)
        self.fill()
        self.draw()
        self.marked()

    def slotDeletedObject(self, obj):
        if obj is self.mesh:
            obj.ViewObject.Proxy.show(obj, None)   # undo would bring it back with its colours, and no panel that explains them
        super().slotDeletedObject(obj)

    def _closed_by_others(self):
        """Without a word to it, as by FreeCAD 1.1 when a load is double-clicked; its end comes after that."""
        if self._follow in view_provider.followers:
            self.mesh.ViewObject.Proxy.show(self.mesh, None)

    def _follow(self, mesh, name):
        if mesh is self.mesh and name in ("FemMesh", "Status"):
            self._later.start(0)   # when all of the mesh is stored

    def end(self):
        if self._follow in view_provider.followers:
            view_provider.followers.remove(self._follow)
            self.unwatch()
            self._later.stop()

# SPDX-License-Identifier: GPL-3.0-or-later
"""What the last update kept: the elements in two colours while the panel is open, with a legend."""

import FreeCAD
import FreeCADGui as Gui
from PySide import QtGui

from .. import overlays
from ..view_provider import icon

translate = FreeCAD.Qt.translate


class KeptPanel:
    """Colours the elements while it is open."""

    def __init__(self, mesh):
        self.mesh = mesh
        colours = overlays.kept_colours(mesh)
        kept = sum(colour == overlays.KEPT for colour in colours.values())
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(translate("FeatureMesh", "Kept in %s") % mesh.Label)
        self.form.setWindowIcon(QtGui.QIcon(icon("FeatureMesh_ShowKept")))
        layout = QtGui.QGridLayout(self.form)
        for row, (colour, text) in enumerate((
                (overlays.KEPT, translate("FeatureMesh", "kept: %d tets (%.1f %%)") % (kept, 100 * kept / len(colours))),
                (overlays.NEW, translate("FeatureMesh", "new: %d tets") % (len(colours) - kept)))):
            swatch = QtGui.QLabel()
            swatch.setFixedSize(22, 14)
            swatch.setStyleSheet("background-color: %s; border: 1px solid #404040" % QtGui.QColor.fromRgbF(*colour).name())
            layout.addWidget(swatch, row, 0)
            layout.addWidget(QtGui.QLabel(text), row, 1)
        note = QtGui.QLabel(translate("FeatureMesh", "%d nodes survived as start positions only.") % overlays.active_count(mesh))
        note.setWordWrap(True)
        layout.addWidget(note, 2, 0, 1, 2)
        layout.setColumnStretch(1, 1)
        mesh.ViewObject.Proxy.colour(mesh, colours)

    def getStandardButtons(self):
        return int(QtGui.QDialogButtonBox.Close)

    def reject(self):
        self.mesh.ViewObject.Proxy.colour(self.mesh, {})
        Gui.Control.closeDialog()
        return True

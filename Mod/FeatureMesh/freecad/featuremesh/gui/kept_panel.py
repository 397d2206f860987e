# SPDX-License-Identifier: GPL-3.0-or-later
"""What the last update kept: elements and nodes in colours while the panel is open, with a legend."""

import FreeCAD
import FreeCADGui as Gui
from PySide import QtGui

from .. import api, overlays, versions
from ..view_provider import drawn_icon

translate = FreeCAD.Qt.translate


class KeptPanel:
    """Colours the elements while it is open."""

    def __init__(self, mesh):
        self.mesh = mesh
        colours = api.show_kept(mesh)
        active = overlays.active_points(mesh)
        kept_colour, new_colour, active_colour = overlays.kept_legend()
        kept = sum(colour == kept_colour for colour in colours.values())
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(translate("FeatureMesh", "Kept in %s") % mesh.Label)
        self.form.setWindowIcon(drawn_icon("FeatureMesh_ShowKept"))
        layout = QtGui.QGridLayout(self.form)
        for row, (colour, text) in enumerate((
                (kept_colour, translate("FeatureMesh", "kept: %d tets (%.1f %%)") % (kept, 100 * kept / len(colours))),
                (new_colour, translate("FeatureMesh", "new: %d tets") % (len(colours) - kept)),
                (active_colour, translate("FeatureMesh", "active: %d nodes kept as start positions, free to move") % len(active)))):
            layout.addWidget(_swatch(colour), row, 0)
            label = QtGui.QLabel(text)
            label.setWordWrap(True)
            layout.addWidget(label, row, 1)
        layout.setColumnStretch(1, 1)
        mesh.ViewObject.Proxy.mark_points(mesh, active, active_colour)

    def getStandardButtons(self):
        return versions.number_of(QtGui.QDialogButtonBox.Close)

    def reject(self):
        api.show_plain(self.mesh)
        self.mesh.ViewObject.Proxy.mark_points(self.mesh, (), None)
        Gui.Control.closeDialog()
        return True


def _swatch(colour):
    swatch = QtGui.QLabel()
    swatch.setFixedSize(22, 14)
    swatch.setStyleSheet("background-color: %s; border: 1px solid #404040" % QtGui.QColor.fromRgbF(*colour).name())
    return swatch

# SPDX-License-Identifier: GPL-3.0-or-later
"""What the last update kept: elements and nodes in colours while the panel is open, with a legend."""

import FreeCAD
from PySide import QtGui

from .. import overlays
from ..messages import said
from ..user_words import as_shown, in_words
from .overlay_panel import OverlayPanel

translate = FreeCAD.Qt.translate


class KeptPanel(OverlayPanel):
    """Colours the elements while it is open."""

    def __init__(self, mesh):
        super().__init__(mesh, translate("FeatureMesh", "Kept in %s") % mesh.Label, "FeatureMesh_ShowKept")
        legend = QtGui.QGridLayout()
        self.labels = []
        for row, colour in enumerate(overlays.kept_legend()):
            legend.addWidget(_swatch(colour), row, 0)
            self.labels.append(QtGui.QLabel())
            self.labels[-1].setWordWrap(True)
            legend.addWidget(self.labels[-1], row, 1)
        legend.setColumnStretch(1, 1)
        self.layout.addLayout(legend)
        self.start(self.cut)

    def make_overlay(self):
        return overlays.kept(self.mesh)

    def fill(self):
        texts = ["", "", ""]
        if self.overlay is not None:
            count, kept = len(self.overlay.kept), int(self.overlay.kept.sum())
            texts = [in_words(message) for message in (
                said("kept: {elements:count} {elements:element|elements} ({share:text} %)", elements=kept, share=as_shown("%.1f" % (100 * kept / count))),
                said("new: {elements:count} {elements:element|elements}", elements=count - kept),
                said("active: {nodes:count} {nodes:node kept as start position|nodes kept as start positions}, free to move", nodes=len(self.overlay.active)))]
        for label, text in zip(self.labels, texts):
            label.setText(text)

    def marked(self):
        points = self.overlay.active if self.overlay is not None else ()
        self.mesh.ViewObject.Proxy.mark_points(self.mesh, points, overlays.kept_legend()[2])


def _swatch(colour):
    swatch = QtGui.QLabel()
    swatch.setFixedSize(22, 14)
    swatch.setStyleSheet("background-color: %s; border: 1px solid #404040" % QtGui.QColor.fromRgbF(*colour).name())
    return swatch

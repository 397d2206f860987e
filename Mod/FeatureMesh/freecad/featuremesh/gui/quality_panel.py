# SPDX-License-Identifier: GPL-3.0-or-later
"""The quality of a mesh: a histogram of the smallest dihedral angles, a legend, and the worst elements to look at."""

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import api, overlays, versions
from ..view_provider import drawn_icon

translate = FreeCAD.Qt.translate
_BIN = 5            # degrees
_MARK = (0.8, 0.0, 0.8)


class QualityPanel:
    """Colours the elements while it is open."""

    def __init__(self, mesh):
        self.mesh = mesh
        self.form = QtGui.QWidget()
        self.form.setWindowIcon(drawn_icon("FeatureMesh_ShowQuality"))
        self.form.setWindowTitle(translate("FeatureMesh", "Quality of %s") % mesh.Label)
        layout = QtGui.QVBoxLayout(self.form)
        layout.addWidget(Histogram(overlays.smallest_angles(mesh.Proxy.arrays(mesh))))
        layout.addWidget(QtGui.QLabel(translate("FeatureMesh", "Smallest angle %.2f deg,\nmean radius ratio %.3f")
                                      % (mesh.MinDihedral.Value, mesh.MeanRadiusRatio)))
        layout.addWidget(QtGui.QLabel(translate("FeatureMesh", "The worst elements, click to see:")))
        self.worst = QtGui.QListWidget()
        self._places = []
        for number, angle, centre in overlays.worst_tets(mesh, 20):
            self.worst.addItem("%d:  %.2f deg" % (number, angle))
            self._places.append((number, centre))
        self.worst.setSelectionMode(QtGui.QAbstractItemView.ExtendedSelection)
        self.worst.itemSelectionChanged.connect(self._show_selected)
        layout.addWidget(self.worst)
        api.show_quality(mesh)

    def getStandardButtons(self):
        return versions.number_of(QtGui.QDialogButtonBox.Close)

    def reject(self):
        api.show_plain(self.mesh)
        self.mesh.ViewObject.Proxy.mark_tets(self.mesh, (), None)
        Gui.Control.closeDialog()
        return True

    def _show_selected(self):
        """Draws the selected elements over the part and turns the camera to the last one."""
        rows = sorted(self.worst.row(item) for item in self.worst.selectedItems())
        self.mesh.ViewObject.Proxy.mark_tets(self.mesh, [self._places[row][0] for row in rows], _MARK)
        if self.worst.currentRow() in rows:
            self._look_at(self._places[self.worst.currentRow()][1])

    def _look_at(self, centre):
        view = Gui.getDocument(self.mesh.Document).activeView()
        if hasattr(view, "getCameraNode"):
            camera = view.getCameraNode()
            direction = view.getViewDirection()
            distance = camera.focalDistance.getValue()
            camera.position.setValue(*[c - distance * d for c, d in zip(centre, direction)])


class Histogram(QtGui.QWidget):
    """Counts of values in bins of five degrees."""

    def __init__(self, angles):
        super().__init__()
        self.setObjectName("histogram")
        self.setMinimumHeight(160)
        self.counts = [0] * (75 // _BIN)
        for angle in angles:
            self.counts[min(int(angle // _BIN), len(self.counts) - 1)] += 1
        self.setToolTip(translate("FeatureMesh", "How many elements have which smallest dihedral angle (degrees)"))

    def paintEvent(self, event):
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        width, height = self.width(), self.height() - 18
        step, most = width / len(self.counts), max(self.counts) or 1
        for index, count in enumerate(self.counts):
            colour = [c for limit, c in overlays.QUALITY_STEPS if limit <= index * _BIN][-1]
            bar = height * count / most
            box = QtCore.QRectF(index * step + 1, height - bar, step - 2, bar)
            painter.fillRect(box, QtGui.QColor.fromRgbF(*colour))
            if 0 < count < most / 100:
                painter.fillRect(QtCore.QRectF(index * step + 1, height - 2, step - 2, 2), QtGui.QColor.fromRgbF(*colour))
            if index % 4 == 0:
                painter.drawText(QtCore.QRectF(index * step, height + 2, 3 * step, 16), QtCore.Qt.AlignLeft, str(index * _BIN))
        painter.end()

# SPDX-License-Identifier: GPL-3.0-or-later
"""The quality of a mesh: elements coloured by a measure, its histogram and limits, and the worst elements to look at."""

import FreeCAD
import FreeCADGui as Gui
import numpy as np
from PySide import QtCore, QtGui

from .. import overlays
from ..messages import said
from ..quality import MEASURES
from ..user_words import as_shown, in_words
from . import narrow
from .overlay_panel import OverlayPanel

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
_LIMITS = QT_TRANSLATE_NOOP("FeatureMesh", "bad"), QT_TRANSLATE_NOOP("FeatureMesh", "good")
_LIMITS_OF_SIZE = QT_TRANSLATE_NOOP("FeatureMesh", "too short"), QT_TRANSLATE_NOOP("FeatureMesh", "too long")
_DEGREES = QT_TRANSLATE_NOOP("FeatureMesh", " deg")   # the only unit of a measure
_BINS = 15
_WORST = 20
_MARK = (0.8, 0.0, 0.8)
_TITLES = {
    "dihedral_angle": QT_TRANSLATE_NOOP("FeatureMesh", "smallest dihedral angle"),
    "radius_ratio": QT_TRANSLATE_NOOP("FeatureMesh", "radius ratio"),
    "aspect_ratio": QT_TRANSLATE_NOOP("FeatureMesh", "aspect ratio"),
    "scaled_jacobian": QT_TRANSLATE_NOOP("FeatureMesh", "scaled Jacobian"),
    "skewness": QT_TRANSLATE_NOOP("FeatureMesh", "skewness"),
    "size_ratio": QT_TRANSLATE_NOOP("FeatureMesh", "edge length over wanted length"),
}


class QualityPanel(OverlayPanel):
    """Colours the elements while it is open."""

    def __init__(self, mesh):
        super().__init__(mesh, translate("FeatureMesh", "Quality of %s") % mesh.Label, "FeatureMesh_ShowQuality")
        self.measure = QtGui.QComboBox()
        for name in MEASURES:
            self.measure.addItem(translate("FeatureMesh", _TITLES[name]), name)
        narrow.box(self.measure)
        self.bad, self.good = QtGui.QDoubleSpinBox(), QtGui.QDoubleSpinBox()
        self.histogram, self.summary, self.worst = Histogram(), QtGui.QLabel(), QtGui.QListWidget()
        hint = QtGui.QLabel(translate("FeatureMesh", "The worst elements, click to see:"))
        for label in (self.summary, hint):
            label.setWordWrap(True)
        self.worst.setMaximumHeight(100)   # all of the panel is seen in a window of 1280 x 800
        self.worst.setSelectionMode(QtGui.QAbstractItemView.ExtendedSelection)
        limits = QtGui.QFormLayout()
        limits.addRow(self.measure)
        self._limit_names = QtGui.QLabel(), QtGui.QLabel()
        for name, box in zip(self._limit_names, (self.bad, self.good)):
            limits.addRow(name, box)
        self.layout.addLayout(limits)
        for widget in (self.histogram, self.summary, hint, self.worst):
            self.layout.addWidget(widget)
        for box in (self.bad, self.good):
            box.setRange(-1e6, 1e6)
            box.setKeyboardTracking(False)
        self._set_limits()
        self.start(self.measure)
        self.measure.currentIndexChanged.connect(lambda _: self._take_measure())
        self.bad.valueChanged.connect(lambda _: self.refresh())
        self.good.valueChanged.connect(lambda _: self.refresh())
        self.worst.itemSelectionChanged.connect(self._show_selected)

    def make_overlay(self):
        return overlays.quality(self.mesh, self._name(), self._limits())

    def fill(self):
        numbers = self._selected_numbers()
        self.worst.blockSignals(True)
        self.worst.clear()
        self._rows = np.zeros(0, dtype=int)
        if self.overlay is None:
            self.histogram.show_values(np.zeros(0), self._measure(), self._limits())
            self.summary.setText("")
        else:
            values, measure = self.overlay.values, self._measure()
            self._rows = measure.worst(values, _WORST)
            for row in self._rows.tolist():
                self.worst.addItem("%d:  %s" % (self.overlay.numbers[row], self._in_words(values[row])))
                self.worst.item(self.worst.count() - 1).setSelected(int(self.overlay.numbers[row]) in numbers)
            self.histogram.show_values(values, measure, self._limits())
            least, mean, greatest = (self._in_words(value) for value in (values.min(), values.mean(), values.max()))
            self.summary.setText(in_words(said("least {least:text}, mean {mean:text}, greatest {greatest:text};\n{bad:count} of {all:count} {all:element|elements} "
                                               "{bad:is|are} beyond the limit", least=least, mean=mean, greatest=greatest,
                                               bad=measure.count_bad(values, self._limits()), all=len(values))))
        self.worst.blockSignals(False)

    def marked(self):
        """Draws the selected elements over the part."""
        rows = self._rows[[self.worst.row(item) for item in self.worst.selectedItems()]] if self.worst.selectedItems() else []
        if self.overlay is not None:
            self.mesh.ViewObject.Proxy.mark_tets(self.mesh, self.overlay, rows, _MARK)

    def _name(self):
        return self.measure.itemData(self.measure.currentIndex())

    def _measure(self):
        return MEASURES[self._name()]

    def _unit(self):
        return translate("FeatureMesh", _DEGREES) if self._measure().unit else ""

    def _in_words(self, value):
        return as_shown("%.*f%s" % (self._measure().digits, value, self._unit()))

    def _limits(self):
        return self.bad.value(), self.good.value()

    def _set_limits(self):
        """The measure's own."""
        names = _LIMITS_OF_SIZE if self._measure().is_centred else _LIMITS
        for label, name in zip(self._limit_names, names):
            label.setText(translate("FeatureMesh", name))
        for box, value in zip((self.bad, self.good), self._measure().limits):
            box.blockSignals(True)
            box.setDecimals(self._measure().digits)
            box.setSingleStep(abs(self._measure().limits[1] - self._measure().limits[0]) / 20)
            box.setSuffix(self._unit())
            box.setValue(value)
            box.blockSignals(False)

    def _take_measure(self):
        self._set_limits()
        self.worst.clearSelection()
        self.refresh()

    def _selected_numbers(self):
        return {int(item.text().split(":")[0]) for item in self.worst.selectedItems()}

    def _show_selected(self):
        """Marks the selected elements and turns the camera to the one clicked last."""
        self.marked()
        rows = [self.worst.row(item) for item in self.worst.selectedItems()]
        if self.worst.currentRow() in rows:
            row = self._rows[self.worst.currentRow()]
            self._look_at(self.overlay.points[self.overlay.elements[row]].mean(axis=0).tolist())

    def _look_at(self, centre):
        view = Gui.getDocument(self.mesh.Document).activeView()
        if hasattr(view, "getCameraNode"):
            camera = view.getCameraNode()
            direction = view.getViewDirection()
            distance = camera.focalDistance.getValue()
            camera.position.setValue(*[c - distance * d for c, d in zip(centre, direction)])


class Histogram(QtGui.QWidget):
    """Counts of values in bins, each in the colour that its values have."""

    def __init__(self):
        super().__init__()
        self.setObjectName("histogram")
        self.setMinimumHeight(90)
        self.counts, self._colours, self._edges, self._digits = [], [], np.zeros(1), 0
        self.setToolTip(translate("FeatureMesh", "How many elements have which value of the measure"))

    def show_values(self, values, measure, limits):
        """(m,) values between, or around, the limits of what is bad and good."""
        low, high = sorted(limits)
        if len(values):
            low, high = min(*limits, values.min()), max(*limits, values.max())
        high = high if high > low else low + 1
        counts, self._edges = np.histogram(values, bins=_BINS, range=(low, high))
        self.counts = counts.tolist()
        self._colours = measure.colours((self._edges[1:] + self._edges[:-1]) / 2, limits).tolist() if limits[0] != limits[1] else []
        self._digits = measure.digits if high - low < 10 else 0
        self.update()

    def paintEvent(self, event):
        if not self._colours:
            return
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        width, height = self.width(), self.height() - 18
        step, most = width / len(self.counts), max(self.counts) or 1
        for index, (count, colour) in enumerate(zip(self.counts, self._colours)):
            bar = max(height * count / most, 2 if count else 0)
            painter.fillRect(QtCore.QRectF(index * step + 1, height - bar, step - 2, bar), QtGui.QColor.fromRgbF(*colour))
            if index % 4 == 0:
                painter.drawText(QtCore.QRectF(index * step, height + 2, 3 * step, 16), QtCore.Qt.AlignLeft, as_shown("%.*f" % (self._digits, self._edges[index])))
        painter.end()

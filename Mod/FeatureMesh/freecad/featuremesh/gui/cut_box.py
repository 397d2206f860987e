# SPDX-License-Identifier: GPL-3.0-or-later
"""The widget that cuts a mesh open: by a plane across an axis that a slider drags, showing whole elements or the cut filled."""

import FreeCAD
from PySide import QtCore, QtGui

from ..section import AXES, plane_across
from . import freecad_widget, narrow

translate = FreeCAD.Qt.translate
_STEPS = 400


class CutBox(QtGui.QGroupBox):
    """Calls `changed` whenever another cut is asked for."""

    def __init__(self, changed):
        super().__init__(translate("FeatureMesh", "Cut open"))
        self._changed = changed
        self._low, self._high = (0.0, 0.0, 0.0), (1.0, 1.0, 1.0)
        self.setCheckable(True)
        self.setChecked(False)
        self.axis = QtGui.QComboBox()
        self.axis.addItems([name.upper() for name in AXES])
        self.axis.setCurrentIndex(2)
        self.slider = QtGui.QSlider(QtCore.Qt.Horizontal)
        self.slider.setRange(0, _STEPS)
        self.place = freecad_widget.length_field()
        self.place.setProperty("keyboardTracking", False)
        self.place.setMinimumWidth(60)   # the panel may be narrow
        self.above = QtGui.QCheckBox(translate("FeatureMesh", "keep the other side"))
        self.filled = QtGui.QCheckBox(translate("FeatureMesh", "cut through the elements"))
        layout = QtGui.QGridLayout(self)
        narrow.margins(layout)
        layout.addWidget(self.axis, 0, 0)
        layout.addWidget(self.place, 0, 1)
        layout.addWidget(self.slider, 1, 0, 1, 2)
        layout.addWidget(self.above, 2, 0, 1, 2)
        layout.addWidget(self.filled, 3, 0, 1, 2)
        self.toggled.connect(lambda _: self._changed())
        self.axis.currentIndexChanged.connect(lambda _: self._take_axis())
        self.slider.valueChanged.connect(self._take_slider)
        self.place.valueChanged.connect(self._take_place)
        self.above.toggled.connect(lambda _: self._changed())
        self.filled.toggled.connect(lambda _: self._changed())

    def set_box(self, points):
        """The mesh to cut, (n,3) mm; the cut stays where it is when it can."""
        self._low, self._high = points.min(axis=0).tolist(), points.max(axis=0).tolist()
        low, high = self._range()
        stays = self.isChecked() and low < self.at() < high
        self._set(self.at() if stays else (low + high) / 2)

    def at(self):
        """Where the plane crosses the axis, mm."""
        return self.place.property("rawValue")

    def plane(self):
        """The section.Plane, None while nothing is cut."""
        return plane_across("xyz"[self.axis.currentIndex()], self.at(), self.above.isChecked()) if self.isChecked() else None

    def _range(self):
        index = self.axis.currentIndex()
        return self._low[index], self._high[index]

    def _set(self, place):
        """Puts both widgets to that place without a call."""
        low, high = self._range()
        for widget in (self.slider, self.place):
            widget.blockSignals(True)
        # No limits of the field: FreeCAD refuses a key at once that goes beyond them for a moment, such as the m of "30 mm", which would be metres.
        for name, value in (("singleStep", (high - low) / 50), ("rawValue", min(max(place, low), high))):
            self.place.setProperty(name, value)
        self.slider.setValue(round(_STEPS * (place - low) / ((high - low) or 1.0)))
        for widget in (self.slider, self.place):
            widget.blockSignals(False)

    def _take_axis(self):
        self._set(sum(self._range()) / 2)
        self._changed()

    def _take_slider(self, step):
        low, high = self._range()
        self._set(low + (high - low) * step / _STEPS)
        self._changed()

    def _take_place(self, *_):
        self._set(self.at())
        self._changed()

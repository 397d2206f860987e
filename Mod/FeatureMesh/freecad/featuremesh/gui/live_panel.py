# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel of a live result: which field is shown and how, the largest value and where it is, and the solution under way."""

import json
import math

import FreeCAD
import FreeCADGui as Gui
import numpy as np
from PySide import QtCore, QtGui

from .. import api, live_overlay, live_result, live_view, messages, user_words, view_provider
from ..errors import UserError
from ..mesh_properties import status_in_words
from ..messages import said
from ..user_words import figure, in_words
from . import enough_memory, live_runner, narrow, recording, wheel
from .closes_with_object import ClosesWithObject
from .cut_box import CutBox
from .undo import undo_step

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
_FIELDS = {"von_mises": QT_TRANSLATE_NOOP("FeatureMesh", "von Mises stress"), "displacement": QT_TRANSLATE_NOOP("FeatureMesh", "displacement")}
_DECIMALS = 4
_MARKS, _GAP = 4, 6   # of the legend, and pixels between them at least
_DIGITS = 3, 2        # of its numbers, and where there is no room for these


class LivePanel(ClosesWithObject):
    """Shows and changes what is seen of a live result; that stays in the view when the panel is closed."""

    def __init__(self, live):
        self.live = live
        self.view = live.ViewObject.Proxy
        self.form = QtGui.QWidget()
        narrow.title(self.form, live.Label)
        self.form.setWindowIcon(view_provider.drawn_icon("FeatureMesh_LiveResult"))
        self.status, self.largest, self.remarks = narrow.Words(), narrow.Words(), narrow.Words()
        self.legend, self.grey = Legend(), narrow.Words(translate("FeatureMesh", "grey: new nodes, which have no value from before"))
        self._make_fields()
        self.bar, self.button = QtGui.QProgressBar(), QtGui.QPushButton()
        self.bar.setRange(0, 100)
        self.cut = CutBox(self._take)
        self.cut.filled.hide()   # colours go from node to node
        layout = QtGui.QVBoxLayout(self.form)
        narrow.margins(layout)
        self.ten_nodes = QtGui.QPushButton(translate("FeatureMesh", "Use 10-node tetrahedra"))
        self.ten_nodes.clicked.connect(self._take_ten_nodes)
        for widget in (self.status, self.remarks, self.ten_nodes, self.bar, self.button):
            layout.addWidget(widget)
        layout.addLayout(self._accuracy_in_a_form())
        layout.addLayout(self._fields_in_a_form())
        for widget in (self.legend, self.grey, self.largest, self.cut):
            layout.addWidget(widget)
        wheel.scrolls(self.form, self.field, self.accuracy)
        self._set_fields()
        self._later = QtCore.QTimer()
        self._later.setSingleShot(True)
        self._later.timeout.connect(self.refresh)
        self.button.clicked.connect(self._press)
        self.view.show_alone(live)
        live_view.followers.append(self._follow)
        live_runner.followers.append(self._follow_run)
        self.watch(self.live)
        self.refresh()

    def refresh(self):
        """Brings the widgets up to date with the live result."""
        live, drawn = self.live, self.view.drawn
        self.status.setText(status_in_words(live))
        self._show_run()
        self.difference.setEnabled(live.Proxy.before is not None)
        report = json.loads(live.Report or "{}")
        is_fresh = live.Proxy.is_fresh
        self.remarks.setText("\n".join(user_words.in_words(line) for line in report.get("warnings", [])) if is_fresh else "")
        self.remarks.setVisible(bool(self.remarks.text()))
        mesh = live.Proxy.mesh(live)
        self.ten_nodes.setVisible(mesh is not None and mesh.Order == "1st")
        self._show_error(report.get("mesh_error") if is_fresh else None)
        if not self.top.hasFocus():   # while it is being typed
            self._show_top()
        self.legend.show_range(drawn, *self._unit(), is_fresh)
        self.grey.setVisible(is_fresh and drawn is not None and not np.isfinite(drawn.values).all())
        self.largest.setText(self._largest_in_words(drawn) if is_fresh else "")
        if drawn is not None:
            self.cut.set_box(drawn.points)

    def reject(self):
        self.end()
        Gui.getDocument(self._document).resetEdit()
        Gui.Control.closeDialog()
        return True

    def _make_fields(self):
        self.field, self.difference = QtGui.QComboBox(), QtGui.QCheckBox(translate("FeatureMesh", "change since the last result"))
        for name, title in _FIELDS.items():
            self.field.addItem(translate("FeatureMesh", title), name)
        narrow.box(self.field)
        self.scale, self.top = QtGui.QDoubleSpinBox(), QtGui.QDoubleSpinBox()
        for box, largest in ((self.scale, 1e9), (self.top, 1e12)):
            box.setRange(0, largest)
            box.setDecimals(_DECIMALS)
            box.setKeyboardTracking(False)
            box.setMinimumWidth(60)   # the panel may be narrow
            box.setSpecialValueText(translate("FeatureMesh", "automatic"))
        self.scale.setToolTip(translate("FeatureMesh", "By how much displacements are drawn larger than they are"))
        self.top.setToolTip(translate("FeatureMesh", "The value at which the colours end"))

    def _fields_in_a_form(self):
        form = QtGui.QFormLayout()
        form.addRow(self.field)
        form.addRow(self.difference)
        form.addRow(translate("FeatureMesh", "Scale"), self.scale)
        form.addRow(translate("FeatureMesh", "Colours up to"), self.top)
        return form

    def _take_accuracy(self, percent):
        self.view.accuracy = percent   # for the next panel, too
        self.refresh()

    def _accuracy_in_a_form(self):
        self.error, self.accuracy = narrow.Words(), QtGui.QDoubleSpinBox()
        self.accuracy.setRange(0.1, 99.0)
        self.accuracy.setDecimals(1)
        self.accuracy.setSuffix(" %")
        self.accuracy.setValue(self.view.accuracy)
        self.accuracy.setToolTip(translate("FeatureMesh", "Of the energy norm: how far stresses may be off in the mean, because the elements are not smaller"))
        self.accuracy.valueChanged.connect(self._take_accuracy)
        self.finer = QtGui.QPushButton(translate("FeatureMesh", "Refine where it is off"))
        self.finer.clicked.connect(self._refine)
        form = QtGui.QFormLayout()
        form.addRow(translate("FeatureMesh", "Error of the mesh"), self.error)
        form.addRow(translate("FeatureMesh", "Wanted"), self.accuracy)
        form.addRow(self.finer)
        return form

    def _show_error(self, error):
        """`error` is a share, None where there is none of the mesh as it is."""
        self.error.setText(translate("FeatureMesh", "about %s %%") % figure(100 * error, 2) if error is not None else translate("FeatureMesh", "not known yet"))
        self.finer.setEnabled(error is not None and 100 * error > self.accuracy.value())

    def _set_fields(self):
        """As the view has it, before anything is connected."""
        settings = self.view.settings
        self.field.setCurrentIndex(live_overlay.FIELDS.index(settings.field))
        self.difference.setChecked(settings.is_difference)
        self.scale.setValue(settings.scale)
        self._show_top()
        self.field.currentIndexChanged.connect(lambda _: self._take_field())
        self.difference.toggled.connect(lambda _: self._take_field())
        self.scale.valueChanged.connect(lambda _: self._take())
        self.top.valueChanged.connect(lambda _: self._take())

    def _take_field(self):
        """Another field has another range, and another unit."""
        self._draw(0.0)
        self._show_top()

    def _show_top(self):
        """Where the colours end, in the user's unit, with the settings of the view; with decimals enough for the values that are drawn."""
        one, unit = self._unit()
        known = np.abs(np.nan_to_num(self.view.drawn.values)) if self.view.drawn is not None else np.zeros(1)
        self.top.blockSignals(True)
        self.top.setDecimals(max(_DECIMALS if one <= 1 else _DECIMALS + 2, _decimals_of(known.max(initial=0.0) / one)))
        self.top.setSuffix(" " + unit)
        self.top.setValue(self.view.settings.top / one)
        self.top.blockSignals(False)

    def _take(self):
        """Draws as the widgets say."""
        one, _ = self._unit()
        self._draw(self.top.value() * one)

    def _draw(self, top):
        self.view.settings = live_overlay.Settings(self.field.itemData(self.field.currentIndex()), self.difference.isChecked(), self.scale.value(),
                                                   top, self.cut.plane())
        self.view.draw(self.live)
        self.refresh()

    def _unit(self):
        """(how many MPa or mm is one of the user's unit, what that is called)."""
        return user_words.unit_of(live_overlay.UNITS[self.view.settings.field])

    def _largest_in_words(self, drawn):
        row = drawn.largest() if drawn is not None else None
        if row is None:
            return ""
        where = api.statics.place(drawn.arrays, row)
        times = live_overlay.scale_of(self.live.Proxy.solution, self.view.settings)
        one, unit = self._unit()
        return in_words(said("largest: {value:text} on {place:text}, node {node:count} at {point:point}; displacements drawn {times:number} times",
                             value="%s %s" % (figure(drawn.values[row] / one, 4), unit), place=where["on"], node=where["node"], point=where["mm"], times=times))

    def _show_run(self):
        run = live_runner.run_of(self.live)
        self.bar.setVisible(run is not None)
        self.button.setText(translate("FeatureMesh", "Cancel") if run is not None else translate("FeatureMesh", "Solve"))
        self.button.setEnabled(run is not None or self.live.Status != live_result.UP_TO_DATE)
        if run is not None:
            step, share = run.words()
            said_first = translate("FeatureMesh", "out of date: %s") if live_result.has_result(self.live) else translate("FeatureMesh", "first solution: %s")
            self.status.setText(said_first % step)
            self.bar.setValue(round(100 * share))

    def _press(self):
        if live_runner.run_of(self.live) is not None:
            live_runner.cancel(self.live)
        else:
            try:
                recording.run(api.solve_live, self.live)
            except (UserError, RuntimeError) as error:
                self.status.setText(user_words.as_sentence(messages.of_error(error)))
        self._show_run()

    def _take_ten_nodes(self):
        """What the remark on 4-node tets offers."""
        with undo_step(self._document, self.ten_nodes.text()):
            mesh = self.live.Proxy.mesh(self.live)
            recording.watch(mesh)
            mesh.Order = "2nd"
            self._document.recompute()
        recording.forget(mesh)
        recording.recomputed(self._document)
        self.refresh()

    def _refine(self):
        asked = self.live.Proxy.analysis(self.live), self.accuracy.value() / 100
        try:
            with undo_step(self._document, self.finer.text()):
                tets = api.refine_by_error(*asked)["tets"]
                if not enough_memory.for_tets(self.live.Proxy.mesh(self.live), tets):
                    raise _NotWanted
                self._document.recompute()
        except _NotWanted:
            return
        except (UserError, RuntimeError) as error:
            self.status.setText(user_words.as_sentence(messages.of_error(error)))
            return
        recording.tell(api.refine_by_error, *asked)
        recording.recomputed(self._document)
        self.refresh()

    def _follow(self, live, name):
        if live is self.live and name in ("Status", "Report"):
            self._later.start(0)

    def _follow_run(self, live):
        if live is self.live:
            self._show_run()

    def end(self):
        if self._follow in live_view.followers:
            live_view.followers.remove(self._follow)
            live_runner.followers.remove(self._follow_run)
            self.unwatch()
            self._later.stop()


class _NotWanted(Exception):
    """A mesh that there is no memory for."""


def _decimals_of(value):
    """Those that show two digits of it."""
    return 1 - math.floor(math.log10(value)) if value > 0 else 0


class Legend(QtGui.QWidget):
    """The colours with their values."""

    def __init__(self):
        super().__init__()
        self.setObjectName("legend")
        self.setMinimumHeight(44)
        self._choices, self._table = [[]], np.zeros((0, 3))

    @property
    def labels(self):
        """The values with all their digits, the last one with its unit."""
        return self._choices[0]

    def show_range(self, drawn, one, unit, is_fresh):
        """In `unit`, of which one is `one` of the field's own."""
        self._choices, self._table = [[]], np.zeros((0, 3))
        if drawn is not None and np.isfinite(drawn.values).any():
            self._table = drawn.table
            values = np.linspace(*drawn.limits, _MARKS) / one
            self._choices = [_labels(values, digits, unit) for digits in _DIGITS] if is_fresh else [[translate("FeatureMesh", "out of date")]]
        self.update()

    def placed_labels(self):
        """(x, label) from the largest down: at their values where there is room, else side by side or with fewer digits, else without some of them."""
        for labels in self._choices:
            for may_move in (False, True):
                placed = self._placed(labels, may_move)
                if len(placed) == len(labels):
                    return placed
        return self._placed(self.labels, False)

    def _placed(self, labels, may_move):
        placed, end = [], self.width() + _GAP
        for index in reversed(range(len(labels))):
            room = QtGui.QFontMetrics(self.font()).boundingRect(labels[index]).width() + 2
            place = int((self.width() - room) * index / max(len(labels) - 1, 1))
            if may_move:
                place = min(place, end - _GAP - room)
            if 0 <= place <= end - _GAP - room:
                placed.append((place, labels[index]))
                end = place
        return placed

    def paintEvent(self, event):
        painter = QtGui.QPainter(self)
        if len(self._table):
            colours = QtGui.QLinearGradient(0, 0, self.width(), 0)
            for place, colour in zip(np.linspace(0, 1, len(self._table)), self._table):
                colours.setColorAt(place, QtGui.QColor.fromRgbF(*colour))
            painter.fillRect(QtCore.QRectF(0, 2, self.width(), 18), colours)
            for place, label in self.placed_labels():
                painter.drawText(place, 38, label)
        painter.end()


def _labels(values, digits, unit):
    labels = [figure(value, digits).replace("e-0", "e-") for value in values]
    return [*labels[:-1], "%s %s" % (labels[-1], unit)]

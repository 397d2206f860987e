# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel of a mesh object: sizes, an estimate, mesh and cancel, and what came out."""

import json
import threading

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import api, versions
from ..mesh_object import UP_TO_DATE, is_cancelled, one_line, remarks_of, status_in_words
from ..messages import in_words
from ..view_provider import drawn_icon
from .errors import select_named
from .running import RunningJob, step_in_words

translate = FreeCAD.Qt.translate
_POLL_MS, _ESTIMATE_MS = 50, 400
_REMARKS = 3   # shown in the panel


class MeshPanel:
    """Shows and sets the properties of one mesh object."""

    def __init__(self, mesh):
        self.mesh = mesh
        self.running = None
        self.job = None
        self._estimate = None
        self._raw = None   # the part as it was read for the last estimate; it stays the same while the panel is open
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(mesh.Label)
        self.form.setWindowIcon(drawn_icon("FeatureMesh"))
        self.form.destroyed.connect(lambda: self.cancel())   # FreeCAD closes the panel with its document
        self._build()
        self._timer = QtCore.QTimer(self.form)
        self._timer.timeout.connect(self._poll)
        self._estimate_timer = QtCore.QTimer(self.form)
        self._estimate_timer.setSingleShot(True)
        self._estimate_timer.timeout.connect(self._start_estimate)
        self._show_result()
        self._settings_changed()

    # Widgets

    def _build(self):
        layout = QtGui.QVBoxLayout(self.form)
        settings = QtGui.QFormLayout()
        layout.addLayout(settings)
        part = versions.part_of(self.mesh)
        settings.addRow(translate("FeatureMesh", "Part"), QtGui.QLabel(part.Label if part is not None else "-"))
        self.size = self._length("Size")
        self.min_size = self._length("MinSize")
        self.order = QtGui.QComboBox()
        self.order.addItems([translate("FeatureMesh", "4-node tets"), translate("FeatureMesh", "10-node tets")])
        self.order.setToolTip(self._tooltip("Order"))
        self.order.setCurrentIndex(1 if self.mesh.Order == "2nd" else 0)
        self.order.currentIndexChanged.connect(self._settings_changed)
        self.per_circle = self._number("ElementsPerCircle", 0, 200)
        self.across_gap = self._number("ElementsAcrossGap", 0, 20)
        self.growth = self._number("Growth", 1.05, 5.0, 0.05)
        self.automatic = QtGui.QCheckBox(translate("FeatureMesh", "Update automatically"))
        self.automatic.setChecked(self.mesh.Automatic)
        self.automatic.setToolTip(self._tooltip("Automatic"))
        for label, widget in ((translate("FeatureMesh", "Size"), self.size),
                              (translate("FeatureMesh", "Smallest"), self.min_size),
                              (translate("FeatureMesh", "Element"), self.order),
                              (translate("FeatureMesh", "Per circle"), self.per_circle),
                              (translate("FeatureMesh", "Across gaps"), self.across_gap),
                              (translate("FeatureMesh", "Growth"), self.growth)):
            widget.setMinimumWidth(70)
            settings.addRow(label, widget)
        layout.addWidget(self.automatic)
        self.estimate = QtGui.QLabel("")
        self.estimate.setWordWrap(True)
        layout.addWidget(self.estimate)
        layout.addLayout(self._buttons())
        self.progress = QtGui.QProgressBar()
        self.progress.setRange(0, 100)
        self.progress.setFormat("")
        layout.addWidget(self.progress)
        self.result = QtGui.QLabel("")
        self.result.setWordWrap(True)
        self.result.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        layout.addWidget(self.result)
        layout.addStretch()

    def _buttons(self):
        buttons = QtGui.QGridLayout()
        self.mesh_button = QtGui.QPushButton(translate("FeatureMesh", "Mesh"))
        self.full_button = QtGui.QPushButton(translate("FeatureMesh", "From scratch"))
        self.cancel_button = QtGui.QPushButton(translate("FeatureMesh", "Cancel"))
        self.mesh_button.setToolTip(translate("FeatureMesh", "Meshes the part, or updates its mesh where it changed"))
        self.full_button.setToolTip(translate("FeatureMesh", "Throws the mesh away and meshes the whole part"))
        self.mesh_button.clicked.connect(lambda: self.start(False))
        self.full_button.clicked.connect(lambda: self.start(True))
        self.cancel_button.clicked.connect(self.cancel)
        self.cancel_button.setEnabled(False)
        buttons.addWidget(self.mesh_button, 0, 0)
        buttons.addWidget(self.cancel_button, 0, 1)
        buttons.addWidget(self.full_button, 1, 0, 1, 2)
        return buttons

    def _tooltip(self, name):
        """The property's description in the user's language, as the property editor shows it."""
        return translate("App::Property", self.mesh.getDocumentationOfProperty(name))

    def _length(self, name):
        widget = Gui.UiLoader().createWidget("Gui::QuantitySpinBox")
        widget.setProperty("unit", "mm")
        widget.setProperty("minimum", 0.0)
        widget.setProperty("rawValue", getattr(self.mesh, name).Value)
        widget.setToolTip(self._tooltip(name))
        widget.valueChanged.connect(self._settings_changed)
        return widget

    def _number(self, name, least, most, step=1.0):
        widget = QtGui.QDoubleSpinBox()
        widget.setRange(least, most)
        widget.setSingleStep(step)
        widget.setDecimals(2 if step < 1 else 0)
        widget.setValue(getattr(self.mesh, name))
        widget.setToolTip(self._tooltip(name))
        widget.valueChanged.connect(self._settings_changed)
        return widget

    # What FreeCAD calls

    def getStandardButtons(self):
        return versions.number_of(QtGui.QDialogButtonBox.Close)

    def reject(self):
        """Close: a running job ends first, and nothing of it remains."""
        self.cancel()
        while self.running is not None and not self.running.is_done(0.05):
            QtGui.QApplication.processEvents()
        self._timer.stop()
        self.running = None
        self.apply_settings()
        Gui.getDocument(self.mesh.Document).resetEdit()
        return True

    # Work

    def apply_settings(self):
        """The panel's values into the object's properties, those that differ, as one undo step."""
        wanted = {"Size": self.size.property("rawValue"), "MinSize": self.min_size.property("rawValue"),
                  "ElementsPerCircle": self.per_circle.value(), "ElementsAcrossGap": self.across_gap.value(),
                  "Growth": self.growth.value(), "Order": "2nd" if self.order.currentIndex() else "1st",
                  "Automatic": self.automatic.isChecked()}
        changed = {name: value for name, value in wanted.items()
                   if getattr(getattr(self.mesh, name), "Value", getattr(self.mesh, name)) != value}
        if changed:
            self.mesh.Document.openTransaction(translate("FeatureMesh", "Mesh settings"))
            for name, value in changed.items():
                setattr(self.mesh, name, value)
            self.mesh.Document.commitTransaction()

    def start(self, full):
        """Starts meshing; the window stays alive."""
        self.apply_settings()
        try:
            api.check_size(self.mesh.Size.Value, versions.part_of(self.mesh))
            self.job = self.mesh.Proxy.prepare(self.mesh, full)
        except Exception as error:
            self._failed(error)
            return
        self.running = RunningJob(self.job)
        self._set_running(True)
        self._timer.start(_POLL_MS)

    def cancel(self):
        """Asks the running job to end."""
        if self.running is not None:
            self.running.cancel()

    def _poll(self):
        self.progress.setValue(round(100 * self.running.share))
        self.progress.setFormat("%s: %%p %%" % step_in_words(self.running.step))
        if not self.running.is_done():
            return
        self._timer.stop()
        self.progress.setFormat(translate("FeatureMesh", "handing over to FreeCAD"))
        error, self.running = self.running.error, None
        try:
            if error is not None:
                raise error
            self.mesh.Document.openTransaction(translate("FeatureMesh", "Mesh of %s") % self.mesh.Label)
            self.mesh.Proxy.finish(self.mesh, self.job)
            self.mesh.Document.commitTransaction()
            self.mesh.purgeTouched()
            self._show_mesh()
            self._show_result()
        except Exception as problem:
            self._failed(problem)
        self.job = None
        self._set_running(False)

    def _show_mesh(self):
        """Mesh and part at the same place would flicker, so the part is hidden."""
        versions.part_of(self.mesh).ViewObject.Visibility = False
        self.mesh.ViewObject.Visibility = True

    def _set_running(self, running):
        for widget in (self.mesh_button, self.full_button):
            widget.setEnabled(not running)
        self.cancel_button.setEnabled(running)
        if not running:
            self.progress.setValue(0)
            self.progress.setFormat("")

    def _failed(self, error):
        if is_cancelled(error):
            self.result.setText(translate("FeatureMesh", "Cancelled; the mesh is as it was."))
            return
        self.mesh.Proxy.fail(self.mesh, error)
        self.result.setText('<span style="color:#c62828">%s</span>' % in_words(one_line(error)).replace("<", "&lt;"))
        select_named(error, versions.part_of(self.mesh))

    def _show_result(self):
        mesh = self.mesh
        if not mesh.TetCount:
            self.result.setText(status_in_words(mesh.Status))
            return
        lines = ["%s: %s" % (translate("FeatureMesh", "Status"), status_in_words(mesh.Status)),
                 translate("FeatureMesh", "%d nodes, %d tets in %.2f s") % (mesh.NodeCount, mesh.TetCount, mesh.Seconds),
                 translate("FeatureMesh", "smallest angle %.1f deg, mean radius ratio %.3f")
                 % (mesh.MinDihedral.Value, mesh.MeanRadiusRatio)]
        if mesh.KeptNodes:
            lines.append(translate("FeatureMesh", "kept by the last update: %d %% of the nodes, %d %% of the tets")
                         % (mesh.KeptNodes, mesh.KeptTets))
        lines += _remarks(json.loads(mesh.Report or "{}"))
        self.result.setText("<br>".join(line.replace("<", "&lt;") for line in lines))
        self.mesh_button.setText(translate("FeatureMesh", "Update") if mesh.Status == UP_TO_DATE
                                 else translate("FeatureMesh", "Mesh"))

    # Estimate

    def _settings_changed(self, *_):
        self._estimate_timer.start(_ESTIMATE_MS)

    def _start_estimate(self):
        if self._estimate is not None and self._estimate.is_alive():
            self._estimate_timer.start(_ESTIMATE_MS)
            return
        try:
            raw, options = api.estimate_input(self.mesh, self._raw, size=self.size.property("rawValue"),
                                              min_size=self.min_size.property("rawValue") or None,
                                              elements_per_circle=self.per_circle.value(),
                                              elements_across_gap=self.across_gap.value(), growth=self.growth.value())
        except Exception as error:
            self.estimate.setText(in_words(one_line(error)))
            return
        self._raw = raw
        self._estimate = _Estimate(raw, options)
        self._wait_for_estimate()

    def _wait_for_estimate(self):
        if self._estimate.is_alive():
            QtCore.QTimer.singleShot(_POLL_MS, self._wait_for_estimate)
            return
        try:
            self.estimate.setText(self._estimate.text)
        except RuntimeError:
            pass  # the panel was closed meanwhile, and Qt has deleted the label


def _remarks(report):
    """The first of what the user should know, in the user's language."""
    remarks = remarks_of(report)
    lines = [translate("FeatureMesh", "note: ") + in_words(remark) for remark in remarks[:_REMARKS]]
    return lines + ([translate("FeatureMesh", "and %d more, see the property Report") % (len(remarks) - _REMARKS)] if len(remarks) > _REMARKS else [])


class _Estimate(threading.Thread):

    def __init__(self, raw, options):
        super().__init__(daemon=True)
        self.raw, self.options, self.text = raw, options, ""
        self.start()

    def run(self):
        try:
            count = api.estimated_tets(self.raw, self.options)
            self.text = translate("FeatureMesh", "about %s tets") % format(int(float("%.2g" % count)), ",d").replace(",", " ")
        except Exception as error:
            self.text = in_words(one_line(error))

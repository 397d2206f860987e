# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel of a mesh object: sizes, an estimate, what came out; OK, Apply and Cancel as in other panels of FreeCAD."""

import contextlib
import json
import threading

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import analyses, api, log, overtaken, reading, versions, view_provider
from ..mesh_object import is_cancelled
from ..refusals import part_to_mesh
from ..reports import remarks_of
from ..mesh_properties import AUTOMATIC_SHARE, DIMENSIONS, FAILED, NOT_MESHED, SETTINGS_CHANGED, UP_TO_DATE, differ_from_mesh, settings_of, status_in_words
from ..messages import of_error, said
from . import driven, enough_memory, freecad_widget, narrow, readable, recording, wheel
from .errors import select_named
from ..user_words import as_sentence, as_shown, in_words
from .running import RunningJob, step_in_words
from .showing import show_mesh
from .undo import undo_step

translate = FreeCAD.Qt.translate
_POLL_MS, _ESTIMATE_MS = 50, 400
_REMARKS = 3   # shown in the panel
_AUTOMATIC, _A_LENGTH, _OFF = range(3)   # rows of what details are ignored
_RED = "#c62828"
_IGNORED_SHARE = 0.01   # of Size, where a length is asked for first


class MeshPanel:
    """Shows and sets the properties of one mesh object.

    Apply meshes with what is set; OK does, too, where the mesh is not of that yet, and closes; Cancel forgets what was set since the last
    Apply. A new object comes with the open transaction that made it: the first mesh ends that, Cancel takes the object back.
    """

    def __init__(self, mesh):
        self.mesh = mesh
        # Without undo (a preference of FreeCAD's) nothing is ever pending.
        self.is_new = mesh.Status == NOT_MESHED and (mesh.Document.HasPendingTransaction or not mesh.Document.UndoMode)
        self._unmeshed_settings = {}
        self._is_taking_back = False
        self._close_when_done = False
        self._is_full = False
        self.running = None
        self.job = None
        self._hidden = []   # names of the live results that were seen in place of the mesh; the panel shows that
        self._estimate = None
        self._written = {}   # field -> (its Qt property, what was written into that, the text that it shows for it)
        self._typed = {}   # field -> what was typed in place of that
        self._raw = None   # the part as it was read for the last estimate, until it is edited
        self._told_of = None   # the settings that the object's status is about
        self.form = narrow.Form()
        narrow.title(self.form, mesh.Label)
        self.form.setWindowIcon(view_provider.drawn_icon("FeatureMesh"))
        self.form.destroyed.connect(lambda: self._leave())   # FreeCAD closes the panel with its document
        self._build()
        self._timer = QtCore.QTimer(self.form)
        self._timer.timeout.connect(self._poll)
        self._estimate_timer = QtCore.QTimer(self.form)
        self._estimate_timer.setSingleShot(True)
        self._estimate_timer.timeout.connect(self._start_estimate)
        self._follow_timer = QtCore.QTimer(self.form)
        self._follow_timer.setSingleShot(True)
        self._follow_timer.timeout.connect(self._part_changed)
        self._fields = self._setting_fields()
        view_provider.followers.append(self._follow)
        self._show_result()
        self._settings_changed()

    # Widgets

    def _build(self):
        layout = QtGui.QVBoxLayout(self.form)
        narrow.margins(layout)
        settings = QtGui.QFormLayout()
        layout.addLayout(settings)
        part, holding = versions.part_of(self.mesh), analyses.holding(self.mesh)
        settings.addRow(translate("FeatureMesh", "Part"), narrow.OneLine(part.Label if part is not None else "-"))
        settings.addRow(translate("FeatureMesh", "Analysis"), narrow.OneLine(", ".join(analysis.Label for analysis in holding) or "-"))
        self.size = self._length("Size")
        self.min_size = self._length("MinSize")
        self.min_automatic = QtGui.QCheckBox(translate("FeatureMesh", "automatic"))
        self.min_automatic.setToolTip(self._tooltip("MinSize"))
        self.min_automatic.setChecked(not self.mesh.MinSize.Value)
        self.min_automatic.toggled.connect(self._settings_changed)
        self.dimension = QtGui.QComboBox()
        self.dimension.addItems([translate("FeatureMesh", "From the shape"), translate("FeatureMesh", "Solids"),
                                 translate("FeatureMesh", "Faces (shells)"), translate("FeatureMesh", "Edges (beams)")])
        self.dimension.setToolTip(self._tooltip("Dimension"))
        self.dimension.setCurrentIndex(DIMENSIONS.index(self.mesh.Dimension))
        self.dimension.currentIndexChanged.connect(self._dimension_changed)
        self.order = QtGui.QComboBox()
        self.order.addItems(["", ""])
        self._name_orders()
        self.order.setToolTip(self._tooltip("Order"))
        self.order.setCurrentIndex(1 if self.mesh.Order == "2nd" else 0)
        self.order.currentIndexChanged.connect(self._settings_changed)
        self.per_circle = self._number("ElementsPerCircle", 0, 200)
        self.across_gap = self._number("ElementsAcrossGap", 0, 20)
        self.growth = self._number("Growth", 1.05, 5.0, 0.05)
        self.automatic = QtGui.QCheckBox(translate("FeatureMesh", "Update automatically"))
        self.automatic.setChecked(self.mesh.Automatic)
        self.automatic.setToolTip(self._tooltip("Automatic"))
        self._choose_details()
        self.estimate, self.status, self.result = narrow.Words(), narrow.Words(), narrow.Words()
        for label, widget in ((translate("FeatureMesh", "Size"), self.size),
                              (translate("FeatureMesh", "Smallest"), self.min_automatic),
                              ("", self.min_size),
                              (translate("FeatureMesh", "Mesh of"), self.dimension),
                              (None, self.order),   # its words need all the width
                              (None, self.estimate), (None, self._progress_bar()), (None, self.status),   # seen without scrolling where there is little room
                              (translate("FeatureMesh", "Per circle"), self.per_circle),
                              (translate("FeatureMesh", "Across walls"), self.across_gap),
                              (translate("FeatureMesh", "Growth"), self.growth),
                              (translate("FeatureMesh", "Ignore below"), self.details),
                              ("", self.ignore_below)):
            settings.addRow(*((widget,) if label is None else (label, widget)))
        for chooser in (self.dimension, self.order, self.details):
            narrow.box(chooser)
        self._close_driven_fields()
        layout.addWidget(self.automatic)
        self.full_button = QtGui.QPushButton(translate("FeatureMesh", "From scratch"))
        self.full_button.setToolTip(translate("FeatureMesh", "Throws the mesh away and meshes the whole part"))
        self.full_button.clicked.connect(lambda: self.start(True))
        layout.addWidget(self.full_button)
        layout.addWidget(self.result)
        for label in (self.estimate, self.status, self.result):
            label.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        layout.addStretch()
        wheel.scrolls(self.form, self.size, self.min_automatic, self.dimension)

    def _close_driven_fields(self):
        driven.close(self.mesh, {
            "Size": (self.size,), "MinSize": (self.min_size, self.min_automatic), "ElementsPerCircle": (self.per_circle,),
            "ElementsAcrossGap": (self.across_gap,), "Growth": (self.growth,), "Order": (self.order,), "Dimension": (self.dimension,),
            "IgnoreBelow": (self.details, self.ignore_below), "Automatic": (self.automatic,)})

    def _choose_details(self):
        """Which details get no elements of their own; a length has a field of its own below."""
        self.details = QtGui.QComboBox()
        self.details.addItems([translate("FeatureMesh", "automatic"), translate("FeatureMesh", "a length"), translate("FeatureMesh", "off")])
        self.details.setToolTip(self._tooltip("IgnoreBelow"))
        length = self.mesh.IgnoreBelow.Value
        self.details.setCurrentIndex(_row_of_details(length))
        self.details.currentIndexChanged.connect(self._settings_changed)
        self.ignore_below = self._length("IgnoreBelow", length if length > 0 else self.mesh.Size.Value * _IGNORED_SHARE)

    def _ignored(self):
        """IgnoreBelow as the panel has it."""
        known = self.mesh.IgnoreBelow.Value
        return {_AUTOMATIC: 0.0, _A_LENGTH: self._value_in(self.ignore_below), _OFF: known if known < 0 else -1.0}[self.details.currentIndex()]

    def _dimension_changed(self):
        self._name_orders()
        self._settings_changed()

    def _name_orders(self):
        """What the two orders are with what is meshed."""
        part = versions.part_of(self.mesh)
        kind = reading.filled_with(part, DIMENSIONS[self.dimension.currentIndex()])
        for index, name in enumerate({
                "Solids": (translate("FeatureMesh", "4-node tetrahedra"), translate("FeatureMesh", "10-node tetrahedra")),
                "Faces": (translate("FeatureMesh", "3-node triangles"), translate("FeatureMesh", "6-node triangles")),
                "Edges": (translate("FeatureMesh", "2-node segments"), translate("FeatureMesh", "3-node segments"))}[kind]):
            self.order.setItemText(index, name)

    def _progress_bar(self):
        """Shown while there is progress, with a button that ends the work."""
        self.working = QtGui.QWidget()
        rows = QtGui.QGridLayout(self.working)
        rows.setContentsMargins(0, 0, 0, 0)
        self.step = narrow.Words()
        self.progress = QtGui.QProgressBar()
        self.progress.setRange(0, 100)
        self.stop_button = QtGui.QPushButton(translate("FeatureMesh", "Stop"))
        self.stop_button.clicked.connect(self.cancel)
        rows.addWidget(self.step, 0, 0, 1, 2)
        rows.addWidget(self.progress, 1, 0)
        rows.addWidget(self.stop_button, 1, 1)
        self.working.hide()
        return self.working

    def _tooltip(self, name):
        """The property's description in the user's language, as the property editor shows it."""
        return translate("App::Property", self.mesh.getDocumentationOfProperty(name))

    def _length(self, name, length=None):
        """The field of a property, with its value or that length in mm."""
        widget = freecad_widget.length_field()
        widget.setProperty("minimum", 0.0)
        self._write(widget, getattr(self.mesh, name).Value if length is None else length)
        widget.setMinimumWidth(70)
        widget.setToolTip(self._tooltip(name))
        widget.valueChanged.connect(lambda _: self._type(widget))
        return widget

    def _write(self, widget, value, kind="rawValue"):
        widget.blockSignals(True)
        widget.setProperty(kind, value)
        widget.blockSignals(False)
        self._written[widget] = kind, value, widget.property("text")
        self._typed.pop(widget, None)

    def _type(self, widget):
        kind, value, text = self._written[widget]
        self._typed[widget] = value if widget.property("text") == text else widget.property(kind)
        self._settings_changed()

    def _value_in(self, widget):
        """Lengths are in mm. A field rounds to what it shows, 8 mm to 0.31 in, also, in FreeCAD 1.1, what was typed when it is left."""
        return self._typed.get(widget, self._written[widget][1])

    def _number(self, name, least, most, step=1.0):
        widget = QtGui.QDoubleSpinBox()
        widget.setRange(least, most)
        widget.setSingleStep(step)
        widget.setDecimals(2 if step < 1 else 0)
        self._write(widget, getattr(self.mesh, name), "value")
        widget.setMinimumWidth(70)
        widget.setToolTip(self._tooltip(name))
        widget.valueChanged.connect(lambda _: self._type(widget))
        return widget

    # What FreeCAD calls

    def getStandardButtons(self):
        return sum(versions.number_of(button) for button in (QtGui.QDialogButtonBox.Ok, QtGui.QDialogButtonBox.Apply, QtGui.QDialogButtonBox.Cancel))

    def clicked(self, button):
        """Apply."""
        if versions.number_of(button) == versions.number_of(QtGui.QDialogButtonBox.Apply) and self.running is None:
            self.start(False)

    def accept(self):
        """OK: meshes where that is needed, and closes when that is done."""
        if self.running is not None:
            self._close_when_done = True
            return False
        self.apply_settings()
        is_to_be_meshed = not self.mesh.SavedState or self.mesh.Automatic and self.mesh.Status != UP_TO_DATE
        if not is_to_be_meshed:
            self._close()
            return True
        self._close_when_done = True
        self.start(False)
        return False

    def reject(self):
        """Cancel: a running job ends first, and nothing remains of it, nor of an object that has no mesh yet."""
        self.cancel()
        while self.running is not None and not self.running.is_done(0.05):
            QtGui.QApplication.processEvents()
        self._timer.stop()
        self.running = None
        if self.is_new:
            document, name = self.mesh.Document, self.mesh.Name
            document.abortTransaction()   # first, for the end of editing commits what is open
            if document.getObject(name) is not None:   # another command has ended our transaction meanwhile
                document.removeObject(name)
            Gui.getDocument(document).resetEdit()
        else:
            self._close()
        return True

    def _close(self):
        if self.is_new:
            self.mesh.Document.commitTransaction()
        for live in filter(None, map(self.mesh.Document.getObject, self._hidden)):
            live.ViewObject.Proxy.show_alone(live)
        Gui.getDocument(self.mesh.Document).resetEdit()

    # Work

    def settings(self):
        """The panel's values by the names of the object's properties."""
        return {"Size": self._value_in(self.size), "MinSize": 0.0 if self.min_automatic.isChecked() else self._value_in(self.min_size),
                "ElementsPerCircle": self._value_in(self.per_circle), "ElementsAcrossGap": self._value_in(self.across_gap),
                "Growth": self._value_in(self.growth), "Order": "2nd" if self.order.currentIndex() else "1st",
                "Dimension": DIMENSIONS[self.dimension.currentIndex()],
                "IgnoreBelow": self._ignored()}

    def _wanted(self):
        return {**self.settings(), "Automatic": self.automatic.isChecked()}

    def _differs(self, name, value):
        """Has the object another value?"""
        return getattr(getattr(self.mesh, name), "Value", getattr(self.mesh, name)) != value

    def apply_settings(self):
        """The panel's values into the object's properties, those that differ, as one undo step."""
        closed = driven.expressions_of(self.mesh)
        changed = {name: value for name, value in self._wanted().items() if name not in closed and self._differs(name, value)}
        if not changed:
            return
        with self._undo_step(translate("FeatureMesh", "Mesh settings")):
            self._set(changed)
        self._unmeshed_settings = changed

    def _set(self, values):
        for name, value in values.items():
            setattr(self.mesh, name, value)

    def _undo_step(self, title):
        """What changes the mesh; a new one is within the step that adds it."""
        return contextlib.nullcontext() if self.is_new else undo_step(self.mesh.Document, title)

    def start(self, full):
        """Starts meshing with what is set; the window stays alive."""
        self.apply_settings()
        self._begin(full)

    def _begin(self, full):
        self._is_full = full
        self._compute_part()
        try:
            api.check_size(self.mesh.Size.Value, part_to_mesh(self.mesh))
            self.job = self.mesh.Proxy.prepare(self.mesh, full) if enough_memory.or_all_the_same(self.mesh) else None
        except Exception as error:
            self._failed(error)
            return
        if self.job is None:
            self._close_when_done = False
            return
        overtaken.note(self.mesh, self.job)
        self.running = RunningJob(self.job)
        self._set_running(True)
        self._timer.start(_POLL_MS)

    def _compute_part(self):
        """FreeCAD does not recompute what is edited while a new mesh waits in its transaction."""
        part = versions.part_of(self.mesh)
        if part is not None and any("Touched" in obj.State for obj in (part, *reading.dependencies(part))):
            self.mesh.Document.recompute([part])

    def _leave(self):
        view_provider.followers.remove(self._follow)
        self.cancel()

    def _follow(self, mesh, name):
        if mesh is not self.mesh:
            return
        if name in ("Status", "Report"):
            self._follow_timer.start(0)
        elif name in self._fields and not self._is_taking_back and self._differs(name, self._wanted()[name]):
            self._fields[name](getattr(getattr(mesh, name), "Value", getattr(mesh, name)))
            self._settings_changed()

    def _setting_fields(self):
        """{name: what shows another value of that setting}, for undo, the property editor and scripts while the panel is open."""
        return {"Size": lambda value: self._write(self.size, value), "MinSize": self._show_min_size,
                "ElementsPerCircle": lambda value: self._write(self.per_circle, value, "value"),
                "ElementsAcrossGap": lambda value: self._write(self.across_gap, value, "value"),
                "Growth": lambda value: self._write(self.growth, value, "value"),
                "Order": lambda value: self.order.setCurrentIndex(1 if value == "2nd" else 0),
                "Dimension": lambda value: self.dimension.setCurrentIndex(DIMENSIONS.index(value)),
                "IgnoreBelow": self._show_ignored, "Automatic": self.automatic.setChecked}

    def _show_min_size(self, length):
        if length:
            self._write(self.min_size, length)
        self.min_automatic.setChecked(not length)

    def _show_ignored(self, length):
        if length > 0:
            self._write(self.ignore_below, length)
        self.details.setCurrentIndex(_row_of_details(length))

    def _part_changed(self):
        """The part was edited, or an edit undone, while the panel is open."""
        if self.running is None:
            self._raw = None
            self._show_result()
            self._estimate_timer.start(_ESTIMATE_MS)

    def cancel(self):
        """Asks the running job to end."""
        if self.running is not None:
            self.running.cancel()

    def _poll(self):
        self.progress.setValue(round(100 * self.running.share))
        self.step.setText(step_in_words(self.running.step))
        if not self.running.is_done():
            return
        self._timer.stop()
        self.step.setText(translate("FeatureMesh", "handing over to FreeCAD"))
        error, self.running = self.running.error, None
        try:
            if error is not None:
                raise error
            if not overtaken.is_overtaken(self.mesh, self.job):
                self._finish()
            elif self.mesh.Status != UP_TO_DATE:
                self._begin(self._is_full)
                if self.running is not None:
                    return
            else:   # a recompute has made it
                self._keep()
                self._hidden += show_mesh(self.mesh)
                self._show_result()
        except Exception as problem:
            self._failed(problem)
        self.job = None
        self._set_running(False)
        if self._close_when_done:
            self._close()

    def _finish(self):
        """The new mesh into the document, as one undo step; that of a new object holds the object, too."""
        self._is_taking_back = True   # what is typed meanwhile stays
        settings = self._take_back_settings()
        with self._undo_step(translate("FeatureMesh", "Mesh of %s") % self.mesh.Label):
            self._set(settings)
            self._is_taking_back = False
            self.mesh.Proxy.finish(self.mesh, self.job)
        self._keep()
        recording.tell(api.update_mesh, self.mesh, *[True] * self._is_full)
        self.mesh.purgeTouched()
        self._hidden += show_mesh(self.mesh)
        self._show_result()

    def _keep(self):
        """A new object has its mesh, so Cancel leaves it there."""
        if self.is_new:
            self.mesh.Document.commitTransaction()
        self.is_new = False

    def _take_back_settings(self):
        """The settings that were not meshed with yet, if setting them was the last step of undo: they go into that of their mesh."""
        settings, self._unmeshed_settings = self._unmeshed_settings, {}
        document = self.mesh.Document
        is_last = settings and not document.HasPendingTransaction and document.UndoNames[:1] == [translate("FeatureMesh", "Mesh settings")]
        if not is_last or any(self._differs(name, value) for name, value in settings.items()):
            return {}
        document.undo()
        return settings

    def _set_running(self, running):
        self.full_button.setEnabled(not running)
        self.working.setVisible(running)
        self.progress.setValue(0)
        self.step.setText("")

    def _failed(self, error):
        self._close_when_done = False
        if is_cancelled(error):
            self.result.setText(translate("FeatureMesh", "Cancelled; the mesh is as it was."))
            return
        log.write_error(error)
        self.mesh.Proxy.fail(self.mesh, error)
        self._show_result()
        select_named(error, versions.part_of(self.mesh))

    def _show_result(self):
        mesh, lines, remarks = self.mesh, [], []
        self._told_of = settings_of(mesh)
        self._show_status()
        if mesh.TetCount:
            lines = [in_words(said("{nodes:count} {nodes:node|nodes}, {elements:count} {elements:element|elements} in {seconds:text}\u00a0s",
                                   nodes=mesh.NodeCount, elements=mesh.TetCount, seconds=as_shown("%.2f" % mesh.Seconds))), *_angles_in_words(mesh)]
            if mesh.KeptNodes:
                lines.append(translate("FeatureMesh", "kept by the last update: %d %% of the nodes, %d %% of the elements")
                             % (mesh.KeptNodes, mesh.KeptTets))
            remarks = [in_words(remark) for remark in remarks_of(json.loads(mesh.Report or "{}"))]
            lines += _first(remarks)
        self.result.setText("\n".join(lines))
        self.result.setToolTip(_rest(remarks))

    def _show_status(self):
        status, settings = self.mesh.Status, {**settings_of(self.mesh), **self.settings()}
        is_failed = status.startswith(FAILED)
        if is_failed and settings != self._told_of or status == UP_TO_DATE and differ_from_mesh(self.mesh, settings):
            status, is_failed = SETTINGS_CHANGED, False
        line = "%s: %s" % (translate("FeatureMesh", "Status"), status_in_words(self.mesh, status))
        self.status.setText(line)
        self.status.setStyleSheet("color: %s" % readable.colour_on(self.estimate, _RED).name() if is_failed else "")

    # Estimate

    def _settings_changed(self, *_):
        self.min_size.setVisible(not self.min_automatic.isChecked())
        self.ignore_below.setVisible(self.details.currentIndex() == _A_LENGTH)
        if self.min_automatic.isChecked():
            self._write(self.min_size, round(self._value_in(self.size) * AUTOMATIC_SHARE, 9))   # what it starts with when it is asked for
        self._show_status()
        self._estimate_timer.start(_ESTIMATE_MS)

    def _start_estimate(self):
        if self._estimate is not None and self._estimate.is_alive():
            self._estimate_timer.start(_ESTIMATE_MS)
            return
        try:
            raw, options = api.estimate_input(self.mesh, self._raw, self.settings())
        except Exception as error:
            self.estimate.setText(as_sentence(of_error(error)))
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


def _row_of_details(length):
    """Of an IgnoreBelow."""
    return _OFF if length < 0 else _A_LENGTH if length else _AUTOMATIC


def _angles_in_words(mesh):
    """A line on how good the elements are, and where no others could be; none of segments, which have no angles."""
    report = json.loads(mesh.Report or "{}")
    if report.get("dimension") == "edges":
        return []
    quality = report.get("quality", {})
    forced, smallest, ratio = quality.get("forced_by_cad", 0), mesh.MinDihedral.Value, mesh.MeanRadiusRatio
    if not forced:
        return [as_shown(translate("FeatureMesh", "smallest angle %.1f deg, mean radius ratio %.3f") % (smallest, ratio))]
    if forced == mesh.TetCount:
        return [as_shown(translate("FeatureMesh", "smallest angle %.1f deg, as the part's own angles everywhere force; mean radius ratio %.3f") % (smallest, ratio))]
    return [as_shown(translate("FeatureMesh", "smallest angle %.1f deg, %.1f deg where the part's own angles do not force less; mean radius ratio %.3f")
                     % (smallest, quality["min_dihedral_unforced"], ratio))]


def _first(remarks):
    """The first of what the user should know, in the user's language."""
    lines = [translate("FeatureMesh", "note: ") + remark for remark in remarks[:_REMARKS]]
    return lines + ([translate("FeatureMesh", "and %d more: let the mouse rest here") % (len(remarks) - _REMARKS)] if len(remarks) > _REMARKS else [])


def _rest(remarks):
    """A tool tip with those for which the panel has no room."""
    return "<br>".join(remark.replace("<", "&lt;") for remark in remarks[_REMARKS:])


class _Estimate(threading.Thread):

    def __init__(self, raw, options):
        super().__init__(daemon=True)
        self.raw, self.options, self.text = raw, options, ""
        self.start()

    def run(self):
        try:
            count = api.estimated_tets(self.raw, self.options)
            self.text = translate("FeatureMesh", "about %s elements") % format(int(float("%.2g" % count)), ",d").replace(",", " ")
        except Exception as error:
            self.text = as_sentence(of_error(error))

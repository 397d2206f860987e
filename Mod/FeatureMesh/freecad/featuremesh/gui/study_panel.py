# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel of a study: which dimensions vary, what is asked for, how many cases; it runs, and how far it is."""

import contextlib

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import user_words, view_provider
from ..errors import UserError
from ..messages import of_error
from ..study import design, progress, response_words, study_object, window_run
from . import errors, narrow, recording, study_runs, wheel
from .closes_with_object import ClosesWithObject
from .dimension_list import DimensionList
from .running import step_in_words
from .undo import undo_step

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
_SAMPLINGS = {
    "lhs": QT_TRANSLATE_NOOP("FeatureMesh", "evenly, at random (Latin hypercube)"),
    "sobol": QT_TRANSLATE_NOOP("FeatureMesh", "evenly (Sobol)"),
    "halton": QT_TRANSLATE_NOOP("FeatureMesh", "evenly (Halton)"),
    "grid": QT_TRANSLATE_NOOP("FeatureMesh", "every combination (grid of 3)"),
    "one_at_a_time": QT_TRANSLATE_NOOP("FeatureMesh", "one at a time"),
    "box_behnken": QT_TRANSLATE_NOOP("FeatureMesh", "curved, no corners (Box-Behnken)"),
    "central_composite": QT_TRANSLATE_NOOP("FeatureMesh", "curved (central composite)"),
}
_STATICS = ("max_mises", "max_principal", "max_displacement", "strain_energy", "reaction")
_GIVEN_BY = {None: (), "static": ("mass", *_STATICS), "thermomech": ("mass", "max_temperature", *_STATICS),
             "frequency": ("mass", "frequency_1"), "buckling": ("mass", "buckling_factor_1")}   # beside how much of the part there is
_AT_A_PLACE = ("max_mises", "max_principal", "max_displacement")
_LOOK_EVERY = 500   # ms
_STATUS_LINES = 3


class StudyPanel(ClosesWithObject):
    """Changes what a study asks for and runs it. What runs goes on when the panel is closed; a new study that was only looked at goes with it."""

    def __init__(self, study, is_new=False):
        self.study = study
        self._new_settings = study_object.settings_of(study) if is_new else None
        self.form = QtGui.QWidget()
        narrow.title(self.form, study.Label)
        self.form.setWindowIcon(view_provider.drawn_icon("FeatureMesh_Study"))
        self._kind = study_object.kind_of(study.Analysis)
        self._running_since = {}   # of window_run.how_far
        self._wrong = ""   # what of the settings makes no sense
        self.dimensions = DimensionList(study_object.dimensions_of(study), study.Parameters, self._take)
        self.responses = QtGui.QListWidget()
        self.responses.setMaximumHeight(130)
        self._fill_responses()
        self._make_settings()
        self.status, self.bar = narrow.Words(), QtGui.QProgressBar()
        self.run_button, self.go_on_button = QtGui.QPushButton(), QtGui.QPushButton(translate("FeatureMesh", "Go on"))
        self.results_button = QtGui.QPushButton(translate("FeatureMesh", "Results"))
        self._lay_out()
        wheel.scrolls(self.form, self.dimensions)
        self.responses.itemChanged.connect(lambda _: self._take())
        self.run_button.clicked.connect(self._press)
        self.go_on_button.clicked.connect(self._go_on)
        self.results_button.clicked.connect(self.show_results)
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self.refresh)
        self._timer.start(_LOOK_EVERY)
        Gui.Selection.addObserver(self)
        self.watch(self.study)
        self.refresh()

    def refresh(self):
        """Brings the status up to date with what runs, and the responses with the faces that an edit gave other numbers."""
        if self._asked != list(self.study.Responses):
            self._fill_responses()
        run = study_runs.run_of(self.study)
        running = run is not None and run.is_running()
        unreadable = ""
        try:
            done, total, left, words = window_run.how_far(study_object.existing_folder_of(self.study), run.jobs if run else 1, self._running_since)
        except UserError as error:
            (done, total, left, words), unreadable = (0, 0, None, ""), user_words.as_sentence(of_error(error))
        self.run_button.setText(translate("FeatureMesh", "Stop") if running else translate("FeatureMesh", "Run"))
        can_add = bool(total) and done == total and self.study.Sampling in design.COUNTED and study_object.is_as_run(self.study)
        self.go_on_button.setVisible(not running and (done < total or can_add))
        self.go_on_button.setText(translate("FeatureMesh", "Add cases") if can_add else translate("FeatureMesh", "Go on"))
        self.results_button.setEnabled(done > 0)
        self.bar.setVisible(running)
        self.bar.setRange(0, total)
        self.bar.setValue(done)
        self.status.setText(self._wrong or unreadable or self._in_words(run, running, words, left))

    def show_results(self):
        """Opens the window with the cases and the plots."""
        from .study_window import show
        return show(self.study)

    def reject(self):
        self.end()
        Gui.getDocument(self._document).resetEdit()
        Gui.Control.closeDialog()
        if self._new_settings is not None and study_object.settings_of(self.study) == self._new_settings:
            recording.forget(self.study)
            self._take_back()
        else:
            recording.write(self.study)
            recording.forget(self.study)
        return True

    def _take_back(self):
        """Takes the study out of the document as if it had never been added."""
        document, title = self._document, translate("FeatureMesh_Study", "Parameter study")
        if document.UndoNames[:1] == [title]:
            document.undo()
        else:   # something else was done meanwhile
            with undo_step(document, title):
                document.removeObject(self.study.Name)

    # FreeCAD's observer of the selection: a clicked sketch, feature or face shows its dimensions

    def addSelection(self, document, name, element, _):
        if document != self._document.Name:
            return
        path = element.split(".")
        for step in [name, *path[:-1]]:
            self.dimensions.show_object(step)
        self.at_button.setEnabled(path[-1].startswith(("Face", "Edge", "Vertex")))

    def clearSelection(self, _):
        self.at_button.setEnabled(False)

    def _fill_responses(self):
        """Those that the analysis gives, and whatever else is asked for already."""
        self.responses.blockSignals(True)
        self.responses.clear()
        known = _GIVEN_BY.get(self._kind, _GIVEN_BY["static"])
        for text in dict.fromkeys([*known[:1], study_object.extent_of(self.study.Part), *known[1:], *self.study.Responses]):
            self._add_response(text, text in self.study.Responses)
        self.responses.blockSignals(False)
        self._asked = list(self.study.Responses)

    def _add_response(self, text, ticked):
        try:
            words = user_words.in_words(response_words.parse_response(text).words)
        except UserError:   # told when it runs
            words = text
        item = QtGui.QListWidgetItem(words)
        item.setFlags(QtCore.Qt.ItemIsEnabled | QtCore.Qt.ItemIsUserCheckable)
        item.setData(QtCore.Qt.UserRole, text)
        item.setCheckState(QtCore.Qt.Checked if ticked else QtCore.Qt.Unchecked)
        self.responses.addItem(item)

    def _make_settings(self):
        study = self.study
        self.at, self.at_button = QtGui.QComboBox(), QtGui.QPushButton(translate("FeatureMesh", "Add at the selection"))
        for kind in _AT_A_PLACE:
            self.at.addItem(user_words.in_words(response_words.WORDS[kind]), kind)
        self.at_button.setEnabled(False)
        self.at_button.clicked.connect(self._add_at_selection)
        self.sampling, self.cases, self.solver, self.jobs = QtGui.QComboBox(), QtGui.QSpinBox(), QtGui.QComboBox(), QtGui.QSpinBox()
        for name, title in _SAMPLINGS.items():
            self.sampling.addItem(translate("FeatureMesh", title), name)
        self.sampling.setCurrentIndex(list(_SAMPLINGS).index(study.Sampling))
        self.cases.setRange(1, 100000)
        self.cases.setValue(study.Cases)
        for name, title in (("automatic", translate("FeatureMesh", "automatic")), ("live", translate("FeatureMesh", "live")), ("ccx", "CalculiX")):
            self.solver.addItem(title, name)
        self.solver.setCurrentIndex(self.solver.findData(study.Solver))
        for box in (self.at, self.sampling, self.solver):
            narrow.box(box)
        self.jobs.setRange(0, 1024)
        self.jobs.setSpecialValueText(translate("FeatureMesh", "automatic"))
        self.jobs.setValue(study.Jobs)
        for box in (self.sampling, self.solver):
            box.currentIndexChanged.connect(lambda _: self._take())
        for box in (self.cases, self.jobs):
            box.valueChanged.connect(lambda _: self._take())

    def _lay_out(self):
        layout = QtGui.QVBoxLayout(self.form)
        narrow.margins(layout)
        self._lay_out_run(layout)
        hint = QtGui.QLabel(translate("FeatureMesh", "Tick what is to vary. A click on a sketch, a feature or a face shows its dimensions."))
        hint.setWordWrap(True)
        for widget in (hint, self.dimensions, QtGui.QLabel(translate("FeatureMesh", "What each case is to tell:")), self.responses):
            layout.addWidget(widget)
        form = QtGui.QFormLayout()
        form.addRow(translate("FeatureMesh", "Cases"), self.cases)
        form.addRow(translate("FeatureMesh", "Sampling"), self.sampling)
        form.addRow(translate("FeatureMesh", "Solver"), self.solver)
        form.addRow(translate("FeatureMesh", "At once"), self.jobs)
        for widget in (self.at, self.at_button):
            layout.addWidget(widget)
            widget.setVisible(self._kind in ("static", "thermomech"))
        layout.addLayout(form)

    def _lay_out_run(self, layout):
        """On top, where it is seen in a small window, too; nothing below moves when parts of it come and go."""
        for widgets in ((self.run_button, self.results_button), (self.go_on_button, self.bar)):
            row = QtGui.QHBoxLayout()
            for widget in widgets:
                policy = widget.sizePolicy()
                policy.setRetainSizeWhenHidden(True)
                widget.setSizePolicy(policy)
                row.addWidget(widget)
            layout.addLayout(row)
        self.status.setMinimumHeight(_STATUS_LINES * self.status.fontMetrics().lineSpacing())
        self.status.setAlignment(QtCore.Qt.AlignTop)
        layout.addWidget(self.status)

    def _in_words(self, run, running, words, left):
        self.cases.setEnabled(self.sampling.itemData(self.sampling.currentIndex()) in design.COUNTED)
        if running and not words:
            return translate("FeatureMesh", "making the mesh that all cases start from")
        words = user_words.in_words(words) or translate("FeatureMesh", "not run yet")
        if running:
            return ", ".join(filter(None, (words, user_words.in_words(progress.time_left(left)))))
        problem = run.problem() if run is not None else ""
        return words + (": " + user_words.in_words(problem) if problem else "")

    def _take(self):
        """The widgets' settings into the object, as far as they make sense; what does not is told when it runs."""
        study = self.study
        try:
            study.Parameters = self.dimensions.parameters()
            self._wrong = ""
        except UserError as error:
            self._wrong = user_words.as_sentence(of_error(error))
            self.refresh()
            return
        rows = [self.responses.item(row) for row in range(self.responses.count())]
        study.Responses = [item.data(QtCore.Qt.UserRole) for item in rows if item.checkState() == QtCore.Qt.Checked]
        self._asked = list(study.Responses)
        study.Sampling, study.Cases = self.sampling.itemData(self.sampling.currentIndex()), self.cases.value()
        study.Solver, study.Jobs = self.solver.itemData(self.solver.currentIndex()), self.jobs.value()
        self.cases.setEnabled(study.Sampling in design.COUNTED)

    def _add_at_selection(self):
        """The response of the box at the face, edge or vertex that is selected."""
        kind = self.at.itemData(self.at.currentIndex())
        for entry in Gui.Selection.getSelectionEx(self._document.Name):
            for name in entry.SubElementNames:
                text = response_words.at_place(kind, study_object.place_on_part(self.study, entry.Object, name))
                if text not in [self.responses.item(row).data(QtCore.Qt.UserRole) for row in range(self.responses.count())]:
                    self._add_response(text, True)
        self._take()

    def _press(self):
        """Run, or Stop."""
        run = study_runs.run_of(self.study)
        if run is not None and run.is_running():
            run.stop()
            return
        self._start(translate("FeatureMesh", "saving a copy of the document, from which all cases start"), study_object.start)

    def _go_on(self):
        """Runs what waits, or as many cases more as the box says."""
        done, total, *_ = window_run.how_far(study_object.folder_of(self.study))
        self._start(step_in_words(""), study_object.go_on, self.cases.value() if done == total else 0)

    def _start(self, doing, begin, *words):
        try:
            self.study.Parameters = self.dimensions.parameters()
            with self._told_to_wait(doing):
                begin(self.study, *words)
            recording.write(self.study)
            recording.tell(begin, self.study, *words, wait=True)   # what follows in a macro may be about the cases
        except (UserError, OSError) as error:
            errors.show(error, self.study.Part)
        self.refresh()

    @contextlib.contextmanager
    def _told_to_wait(self, words):
        """The window draws nothing more until that is done."""
        self.status.setText(words)
        self.form.repaint()
        QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
        try:
            yield
        finally:
            QtGui.QApplication.restoreOverrideCursor()

    def end(self):
        if self._timer.isActive():
            self._timer.stop()
            Gui.Selection.removeObserver(self)
            self.unwatch()

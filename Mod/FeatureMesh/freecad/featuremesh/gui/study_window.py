# SPDX-License-Identifier: GPL-3.0-or-later
"""The window with a study's cases and plots; a row opens its case in the document."""

import os
import time

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import api, view_provider
from ..errors import UserError
from ..messages import of_error, said
from ..study import answers, report, response_words, study_object, table
from ..study.folder import StudyFolder, has_study
from ..user_words import as_sentence, as_shown, figure, in_words
from . import errors, narrow, recording
from .save_dialog import ask_for_file
from .study_plots import PlotTab
from .undo import undo_step

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
_LOOK_EVERY = 1000   # ms
_REST = 10   # times as long as it took to show what was new, until it looks again
_STATES = {
    "waiting": QT_TRANSLATE_NOOP("FeatureMesh", "waiting"),
    "running": QT_TRANSLATE_NOOP("FeatureMesh", "running"),
    "done": QT_TRANSLATE_NOOP("FeatureMesh", "done"),
    "infeasible": QT_TRANSLATE_NOOP("FeatureMesh", "cannot be made"),
    "failed": QT_TRANSLATE_NOOP("FeatureMesh", "failed"),
}
_open = []


def show(study):
    """Opens the study's window, or brings it to the front. Returns it."""
    for window in _open:
        if window.study is study:
            window.raise_()
            return window
    window = StudyWindow(study)
    _open.append(window)
    window.show()
    return window


class StudyWindow(QtGui.QDialog):
    """Follows the study while it runs."""

    def __init__(self, study):
        super().__init__(Gui.getMainWindow())
        self.study, self._document = study, study.Document
        self._seen = None   # what the database had when it was looked at last
        self.setWindowTitle(study.Label)
        self.setWindowIcon(view_provider.drawn_icon("FeatureMesh_Study"))
        self.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        self.resize(900, 560)
        self.table = QtGui.QTableWidget()
        self.table.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
        self.table.setSelectionBehavior(QtGui.QAbstractItemView.SelectRows)
        self.table.setSelectionMode(QtGui.QAbstractItemView.SingleSelection)
        self.table.cellDoubleClicked.connect(lambda row, _: self.open_row(row))
        self.table.itemSelectionChanged.connect(self._tell_selected)
        self.table.sortByColumn(0, QtCore.Qt.AscendingOrder)
        self.tabs = QtGui.QTabWidget()
        self.plots = [PlotTab(kind, self.select_case) for kind in ("scatter", "parallel", "tornado")]
        for tab in self.plots:
            self.tabs.addTab(tab, tab.title)
        self.tabs.addTab(self.table, translate("FeatureMesh", "Cases"))
        self.note = narrow.Words(translate("FeatureMesh", "A double click on a case shows it: part, mesh and result. Undo takes it back."))
        self.open_button, self.back_button = QtGui.QPushButton(translate("FeatureMesh", "Show the case")), QtGui.QPushButton(translate("FeatureMesh", "As it was"))
        self.report_button, self.export_button = QtGui.QPushButton(translate("FeatureMesh", "Report")), QtGui.QPushButton(translate("FeatureMesh", "Save table"))
        self._lay_out()
        self._timer = QtCore.QTimer(self)
        self._timer.timeout.connect(self.refresh)
        self._timer.start(_LOOK_EVERY)
        self.finished.connect(lambda _: self._end())
        FreeCAD.addDocumentObserver(self)
        self.refresh()

    def refresh(self):
        """Brings table and plots up to date with the study's database, or says why it cannot be read."""
        begun = time.monotonic()
        try:
            path = study_object.existing_folder_of(self.study)
            if has_study(path):
                self._take(StudyFolder(path))
        except UserError as error:
            self.note.setText(as_sentence(of_error(error)))
        QtCore.QTimer.singleShot(0, lambda: self._rest(begun))   # when all is drawn

    def _rest(self, begun):
        """A study whose cases take a second is no reason for a window that only draws."""
        if self in _open:
            self._timer.start(max(_LOOK_EVERY, round(1000 * _REST * (time.monotonic() - begun))))

    def _take(self, folder):
        """What is in it, unless it is shown already; closes it."""
        try:
            seen = folder.path, tuple(folder.database.counts().items())
            if seen == self._seen:
                return
            self._seen = seen
            self._design, self._base = folder.study(), folder.facts()["base_values"]
            self._cases = {case.id: case for case in folder.database.cases()}
            self._fill()
            if any(case.state == "done" for case in self._cases.values()):
                data = answers.data_of(folder)
                for tab in self.plots:
                    tab.take(data)
        finally:
            folder.database.close()

    def select_case(self, case_id):
        """Marks the case's row."""
        self.table.selectRow(next(row for row in range(self.table.rowCount()) if self._case_in(row).id == case_id))

    def open_row(self, row):
        """Gives the document the values of the case in that row; part, mesh and result follow."""
        case = self._case_in(row)
        self._show_values(case.parameters, translate("FeatureMesh", "Show case %d") % case.id, case.state == "done")

    def go_back(self):
        """Gives the document the values that it had when the study began."""
        self._show_values(self._base, translate("FeatureMesh", "Show the part as it was"), True)

    # FreeCAD's document observer

    def slotDeletedObject(self, obj):
        if obj is self.study:
            self.close()

    def slotDeletedDocument(self, document):
        if document is self._document:
            self.close()

    def _lay_out(self):
        layout = QtGui.QVBoxLayout(self)
        layout.addWidget(self.tabs)
        layout.addWidget(self.note)
        row = QtGui.QHBoxLayout()
        for button, press in ((self.open_button, self._open_selected), (self.back_button, self.go_back), (self.report_button, self._report),
                              (self.export_button, self._export)):
            button.setAutoDefault(False)
            button.clicked.connect(lambda _=False, press=press: press())
            row.addWidget(button)
        row.addStretch()
        layout.addLayout(row)

    def _fill(self):
        """The case that is selected stays so."""
        selected = [self._case_in(row).id for row in self._selected_rows()]
        names = [entry.name for entry in (*self._design.parameters, *self._design.responses)]
        titles = [*(entry.title for entry in self._design.parameters), *(in_words(entry.title) for entry in self._design.responses)]
        self.table.setSortingEnabled(False)   # while rows are filled
        self.table.setColumnCount(len(names) + 3)
        self.table.setHorizontalHeaderLabels([translate("FeatureMesh", "case"), translate("FeatureMesh", "state"), *titles, translate("FeatureMesh", "message")])
        self.table.horizontalHeader().setStretchLastSection(True)
        self.table.verticalHeader().hide()
        self.table.setRowCount(len(self._cases))
        for row, case in enumerate(self._cases.values()):
            values = {**case.parameters, **case.responses}
            cells = [case.id, translate("FeatureMesh", _STATES[case.state]), *(values.get(name, "") for name in names), in_words(case.message)]
            for column, value in enumerate(cells):
                self.table.setItem(row, column, _Cell(value))
        self.table.setSortingEnabled(True)
        self.table.resizeColumnsToContents()
        for case_id in selected:
            self.select_case(case_id)

    def _case_in(self, row):
        return self._cases[self.table.item(row, 0).value]

    def _in_words(self, case):
        values = {**case.parameters, **case.responses}
        known = [(entry.name, entry.title, "") for entry in self._design.parameters]
        known += [(entry.name, in_words(entry.words), " " + entry.unit if entry.unit else "") for entry in self._design.responses]
        words = ", ".join("%s %s%s" % (word, _shown(values[name]), unit) for name, word, unit in known if name in values)
        return translate("FeatureMesh", "Case %d: %s") % (case.id, in_words(case.message) if case.state in ("failed", "infeasible") else words)

    def _tell_selected(self):
        for row in self._selected_rows():
            self.note.setText(self._in_words(self._case_in(row)))

    def _selected_rows(self):
        """One or none."""
        return [index.row() for index in self.table.selectionModel().selectedRows()]

    def _open_selected(self):
        rows = self._selected_rows()
        if rows:
            self.open_row(rows[0])
        else:
            self.note.setText(translate("FeatureMesh", "Select a case in the table, or click a point of a plot."))

    def _show_values(self, values, title, is_solvable):
        """One step of undo."""
        try:
            self._close_panel()
        except UserError as error:
            errors.show(error)
            return
        try:
            with undo_step(self._document, title):
                assignments = [parameter.assignment(values[parameter.name]) for parameter in self._design.parameters]
                recording.run(study_object.show_values, self.study, assignments)
                if is_solvable and self.study.Analysis is not None and response_words.needs_solution(self._design.responses):
                    self._show_result()
        except Exception as error:
            self._document.recompute()   # FreeCAD takes the values back, but not its marks on what it could not make
            errors.show(error, self.study.Part)

    def _close_panel(self):
        """That of the study, whose dimensions change. Throws UserError where something else is edited in one, a sketch or a load."""
        document = Gui.editDocument()
        edited = document.getInEdit() if document is not None else None
        if Gui.Control.activeDialog():
            if edited is not None and edited.Object is not self.study:
                raise UserError(said("{object:text} is being edited; close its panel first", object=edited.Object.Label))
            Gui.Control.closeDialog()

    def _show_result(self):
        """The live result where that knows the analysis, else CalculiX's."""
        analysis = self.study.Analysis
        if study_object.is_for_live(analysis):
            live = recording.run(api.live_result, analysis)
            live.ViewObject.Proxy.show_alone(live)
        else:
            recording.run(api.solve, analysis)

    def _report(self):
        """Writes the page and opens it."""
        path = os.path.join(study_object.folder_of(self.study), "report.html")
        if self._written(lambda folder: report.write(folder, path, say=in_words, as_shown=as_shown)):
            QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(path))
            self.note.setText(translate("FeatureMesh", "The report is %s") % path)

    def _export(self):
        proposed = os.path.join(study_object.folder_of(self.study), "cases.csv")
        path = ask_for_file(self, translate("FeatureMesh", "Save table"), proposed, "CSV (*.csv);;JSON (*.json)", ("csv", "json"))
        if path is not None:
            self._written(lambda folder: table.write(folder, path))

    def _written(self, write):
        """Calls it with the study's folder. Did that work? Else it is said why."""
        try:
            folder = StudyFolder(study_object.existing_folder_of(self.study))
            try:
                write(folder)
            finally:
                folder.database.close()
        except UserError as error:
            errors.show(error)
            return False
        return True

    def _end(self):
        self._timer.stop()
        FreeCAD.removeDocumentObserver(self)
        if self in _open:
            _open.remove(self)


class _Cell(QtGui.QTableWidgetItem):
    """Sorted by its value; those without one are last, whichever way."""

    def __init__(self, value):
        super().__init__(_shown(value))
        self.value = value

    def __lt__(self, other):
        if "" in (self.value, other.value):
            is_rising = self.tableWidget().horizontalHeader().sortIndicatorOrder() == QtCore.Qt.AscendingOrder
            return (self.value != "") == is_rising and self.value != other.value
        return self.value < other.value


def _shown(value):
    return figure(value, 5) if isinstance(value, float) else str(value)

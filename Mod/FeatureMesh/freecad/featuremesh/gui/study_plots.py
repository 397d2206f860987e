# SPDX-License-Identifier: GPL-3.0-or-later
"""One plot of a study in a tab; a click on a point or line names its case."""

import FreeCAD
from PySide import QtCore, QtGui

from ..study import answers
from ..user_words import as_shown, in_words

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
_TITLES = {"scatter": QT_TRANSLATE_NOOP("FeatureMesh", "Scatter"), "parallel": QT_TRANSLATE_NOOP("FeatureMesh", "Parallel coordinates"),
           "tornado": QT_TRANSLATE_NOOP("FeatureMesh", "Tornado")}


class PlotTab(QtGui.QScrollArea):
    """Draws itself when it is seen and the cases have changed."""

    def __init__(self, kind, pick):
        """`pick(case_id)` is called when a case is clicked."""
        super().__init__()
        self.kind, self.title = kind, translate("FeatureMesh", _TITLES[kind])
        self._pick, self._data, self._drawn = pick, None, None
        self.setWidgetResizable(True)
        self.viewport().setAutoFillBackground(False)   # a theme colours what is behind it
        self.canvas = None
        self._say(translate("FeatureMesh", "No case is done yet."))

    def take(self, data):
        """The answers.Data to draw."""
        self._data = data
        if self.isVisible():
            self._draw()

    def showEvent(self, event):
        super().showEvent(event)
        QtCore.QTimer.singleShot(0, self._draw)

    def _draw(self):
        if self._data is None or self._data is self._drawn:
            return
        self._drawn = self._data
        try:
            from matplotlib.backends.backend_qtagg import FigureCanvasQTAgg
            from matplotlib.figure import Figure
            from ..study import plots
        except ImportError as error:
            self._say(translate("FeatureMesh", "Plots need matplotlib (Debian: python3-matplotlib): %s") % error)
            return
        words = self._words()
        if words is None:
            return
        figure = Figure()
        getattr(plots, self.kind)(figure, *words)
        plots.show_numbers(figure, as_shown)
        self.canvas = FigureCanvasQTAgg(figure)
        width, height = figure.get_size_inches() * figure.dpi
        self.canvas.setMinimumSize(min(int(width), 800), int(height))
        figure.set_tight_layout(True)
        self.canvas.mpl_connect("pick_event", self._picked)
        self.setWidget(self.canvas)

    def _words(self):
        """What the plot is drawn from, None where there is too little; that is said then."""
        data, responses = self._data, self._data.study.responses
        if not data.names:
            self._say(translate("FeatureMesh", "The cases that are done do not differ yet."))
            return None
        if self.kind != "tornado":
            return data, responses, in_words
        found = [effects for effects in (answers.effects(data, response.name) for response in responses) if effects]
        if not found:
            self._say(translate("FeatureMesh", "There are too few cases to tell what matters; add some."))
            return None
        return data, responses, found, in_words

    def _say(self, text):
        label = QtGui.QLabel(text)
        label.setAlignment(QtCore.Qt.AlignCenter)
        self.canvas = None
        self.setWidget(label)
        label.setAutoFillBackground(False)

    def _picked(self, event):
        """A point of the scatter, or a line of the parallel coordinates; both are in the order of the cases."""
        lines = list(event.artist.axes.lines)
        place = event.ind[0] if self.kind == "scatter" else lines.index(event.artist)
        self._pick(self._drawn.cases[int(place)].id)

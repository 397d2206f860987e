# SPDX-License-Identifier: GPL-3.0-or-later
"""A tree of a part's dimensions, each with a tick and a range."""

import math

import FreeCAD
from PySide import QtCore, QtGui

from ..errors import UserError
from ..messages import said
from ..study import design
from ..user_words import are_lengths_in_mm, as_shown

translate = FreeCAD.Qt.translate
_NAME, _RANGE = range(2)
_VALUE = QtCore.Qt.UserRole + 1   # of a row: its value in words, which its text ends with
_PARAMETER = QtCore.Qt.UserRole + 2   # of a row of no dimension: the parameter as it was written


class DimensionList(QtGui.QTreeWidget):
    """The dimensions by their sketch or feature; `changed` is called when the user ticked one or typed a range."""

    def __init__(self, dimensions, parameters, changed):
        """`parameters` as the study object has them."""
        super().__init__()
        self._changed = changed
        self.setColumnCount(2)
        self.setHeaderLabels([translate("FeatureMesh", "dimension, as it is"), translate("FeatureMesh", "from : to")])
        self.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
        self.setMinimumHeight(200)
        self._items, self._groups = {}, {}   # target -> item, name of an object -> item
        ranges = {text: parameter for text, parameter in ((text, _parsed(text)) for text in parameters)
                  if parameter is not None and parameter.bounds and parameter.target in {entry.target for entry in dimensions}}
        bounds = {parameter.target: parameter.bounds for parameter in ranges.values()}
        for dimension in dimensions:
            self._add(dimension, bounds.get(dimension.target))
        self._others = [self._add_other(text) for text in parameters if text not in ranges]
        self.setRootIsDecorated(False)   # the panel may be narrow
        self.setIndentation(8)
        self.setItemDelegateForColumn(_NAME, _Names(self))
        self.header().setStretchLastSection(False)
        self.header().setSectionResizeMode(_NAME, QtGui.QHeaderView.Stretch)
        self.header().setSectionResizeMode(_RANGE, QtGui.QHeaderView.ResizeToContents)
        self._give_room()
        self.itemChanged.connect(self._took)
        self.itemDoubleClicked.connect(lambda item, column: self.editItem(item, column) if column == _RANGE else None)

    def item_of(self, target):
        """The row of a dimension, such as Fillet.Radius."""
        return self._items[target]

    def parameters(self):
        """What is ticked, as the study object has it. Throws UserError for a range that is none."""
        found = [item.data(_NAME, _PARAMETER) for item in self._others if item.checkState(_NAME) == QtCore.Qt.Checked]
        for target, item in self._items.items():
            if item.checkState(_NAME) == QtCore.Qt.Checked:
                try:
                    low, high = self._range_of(item)
                except ValueError:
                    raise UserError(said("the range of {target:text} has to be two numbers, such as 3 : 5", target=target)) from None
                if not low < high:
                    raise UserError(said("the range of {target:text} has to rise", target=target))
                found.append("%s=%r:%r" % (target, low, high))
        return found

    def show_object(self, name):
        """Opens the dimensions of a sketch or feature and scrolls to them."""
        group = self._groups.get(name)
        if group is not None:
            group.setExpanded(True)
            self.scrollToItem(group, QtGui.QAbstractItemView.PositionAtTop)

    def _give_room(self):
        """The names get all the width as long as there is no range."""
        self.setColumnHidden(_RANGE, not any(item.text(_RANGE) for item in self._items.values()))

    def _add(self, dimension, bounds):
        owner = dimension.owner
        if owner.Name not in self._groups:
            group = self._groups[owner.Name] = QtGui.QTreeWidgetItem([owner.Label])
            self.addTopLevelItem(group)
            group.setFirstColumnSpanned(True)
            group.setExpanded(True)
        number = as_shown("%.6g" % dimension.value)
        value = "  " + number + _unit_to_tell(dimension.unit)
        item = QtGui.QTreeWidgetItem([dimension.name + value])
        item.setData(_NAME, _VALUE, value)
        item.setToolTip(_NAME, ("%s  %s %s" % (dimension.name, number, dimension.unit)).strip())
        item.setFlags(QtCore.Qt.ItemIsEnabled | QtCore.Qt.ItemIsSelectable | QtCore.Qt.ItemIsUserCheckable | QtCore.Qt.ItemIsEditable)
        item.setData(_NAME, QtCore.Qt.UserRole, [float(value) for value in dimension.usual_range()])
        item.setCheckState(_NAME, QtCore.Qt.Checked if bounds else QtCore.Qt.Unchecked)
        if bounds:
            self._show_range(item, bounds)
        self._items[dimension.target] = item
        self._groups[owner.Name].addChild(item)

    def _add_other(self, text):
        """A row for a list of values, for what was written by hand, and for what the part has no more: as it is, until it is not ticked any more."""
        item = QtGui.QTreeWidgetItem([text])
        item.setToolTip(_NAME, text)
        item.setFlags(QtCore.Qt.ItemIsEnabled | QtCore.Qt.ItemIsSelectable | QtCore.Qt.ItemIsUserCheckable)
        item.setCheckState(_NAME, QtCore.Qt.Checked)
        item.setData(_NAME, _PARAMETER, text)
        self.addTopLevelItem(item)
        item.setFirstColumnSpanned(True)
        return item

    @staticmethod
    def _range_of(item):
        """What was shown counts as long as nothing else is typed: the text is rounded. Throws ValueError."""
        shown = item.data(_RANGE, QtCore.Qt.UserRole)
        if shown and item.text(_RANGE) == _range_in_words(shown):
            return shown
        low, high = map(float, item.text(_RANGE).replace(",", ".").split(":"))
        if not math.isfinite(high - low):
            raise ValueError(item.text(_RANGE))
        return low, high

    @staticmethod
    def _show_range(item, bounds):
        item.setData(_RANGE, QtCore.Qt.UserRole, [float(bound) for bound in bounds])
        item.setText(_RANGE, _range_in_words(bounds))
        item.setToolTip(_RANGE, item.text(_RANGE))

    def _took(self, item, column):
        if column == _NAME and item.data(_NAME, _PARAMETER) is None:
            self.blockSignals(True)
            if item.checkState(_NAME) != QtCore.Qt.Checked:
                item.setText(_RANGE, "")
            elif not item.text(_RANGE):
                self._show_range(item, item.data(_NAME, QtCore.Qt.UserRole))
            self.blockSignals(False)
            self._give_room()
        elif column == _RANGE:
            self.blockSignals(True)
            item.setToolTip(_RANGE, item.text(_RANGE))
            self.blockSignals(False)
        self._changed()


def _parsed(text):
    """The design.Parameter, None for what cannot be read, which is told when the study runs."""
    try:
        return design.parse_parameter(text)
    except UserError:
        return None


class _Names(QtGui.QStyledItemDelegate):
    """Where there is no room for all of a row the name is shortened, never the value: "Hole4X  110 mm" would look like a 10 otherwise."""

    def initStyleOption(self, option, index):
        super().initStyleOption(option, index)
        value = index.data(_VALUE)
        if value:
            style = option.widget.style()
            frame = style.pixelMetric(QtGui.QStyle.PM_FocusFrameHMargin, option, option.widget) + 1
            room = style.subElementRect(QtGui.QStyle.SE_ItemViewItemText, option, option.widget).width() - 2 * frame
            name = option.text[:-len(value)]
            option.text = option.fontMetrics.elidedText(name, QtCore.Qt.ElideMiddle, room - _width(option.fontMetrics, value)) + value


def _width(metrics, text):
    return metrics.size(QtCore.Qt.TextSingleLine, text).width()


def _range_in_words(bounds):
    return as_shown("%.6g : %.6g" % tuple(bounds))


def _unit_to_tell(unit):
    """Lengths are in mm here whatever the user sees elsewhere, which need not be told where that is mm, too."""
    return "°" if unit == "deg" else " mm" if unit == "mm" and not are_lengths_in_mm() else ""

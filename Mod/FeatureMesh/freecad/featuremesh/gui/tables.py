# SPDX-License-Identifier: GPL-3.0-or-later
"""Windows with a table: the feature tree and the feature difference. A click on a row selects its faces."""

import FreeCADGui as Gui
from PySide import QtCore, QtGui

_COLOURS = {"added": "#2e9e3f", "removed": "#c62828", "reshaped": "#c77700", "moved": "#1f6fb2", "interaction_changed": "#7a5aa8",
            "interaction changed": "#7a5aa8", "suppressed": "#808080"}


def show_table(title, header, rows, note, part=None):
    """Shows rows of (cells, colour key, face names of `part` or None) in a window of its own."""
    dialog = QtGui.QDialog(Gui.getMainWindow())
    dialog.setWindowTitle(title)
    dialog.resize(820, 460)
    layout = QtGui.QVBoxLayout(dialog)
    tree = QtGui.QTreeWidget()
    tree.setColumnCount(len(header))
    tree.setHeaderLabels(header)
    tree.setRootIsDecorated(False)
    tree.setAlternatingRowColors(True)
    for cells, key, faces in rows:
        item = QtGui.QTreeWidgetItem([str(cell) for cell in cells])
        item.setData(0, QtCore.Qt.UserRole, list(faces or ()))
        if key in _COLOURS:
            item.setForeground(1, QtGui.QBrush(QtGui.QColor(_COLOURS[key])))
        tree.addTopLevelItem(item)
    for column in range(len(header)):
        tree.resizeColumnToContents(column)
    tree.itemSelectionChanged.connect(lambda: _select(tree, part))
    layout.addWidget(tree)
    label = QtGui.QLabel(note)
    label.setWordWrap(True)
    layout.addWidget(label)
    dialog.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    dialog.show()
    return dialog


def _select(tree, part):
    if part is None:
        return
    Gui.Selection.clearSelection()
    for item in tree.selectedItems():
        for name in item.data(0, QtCore.Qt.UserRole) or ():
            Gui.Selection.addSelection(part, name)

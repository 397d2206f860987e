# SPDX-License-Identifier: GPL-3.0-or-later
"""Windows with a tree of rows: the feature tree and the feature difference. A click on a row selects its faces."""

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import tables
from ..user_words import as_shown, in_users_units, in_words
from ..view_provider import drawn_icon
from . import narrow, readable
from .showing import restore, show_part

translate = FreeCAD.Qt.translate
_COLOURS = {"added": "#2e9e3f", "appeared": "#2e9e3f", "removed": "#c62828", "vanished": "#c62828", "reshaped": "#c77700",
            "trimmed differently": "#c77700", "moved": "#1f6fb2", "interaction changed": "#8a63b8", "suppressed": "#808080"}
_ICONS = {"added": "Added", "appeared": "Added", "removed": "Removed", "vanished": "Removed", "reshaped": "Reshaped",
          "trimmed differently": "Reshaped", "moved": "Moved", "interaction changed": "Interaction", "suppressed": "Suppressed",
          "same": "Same", "kept": "Same"}


def show_tree(part, found):
    """Shows the features of `part` as the engine reads them."""
    header, rows = tables.rows_of_tree(found)
    header = [*header[:4], translate("FeatureMesh", "volume"), *header[5:]]   # in the user's units
    window = _Window("%s: %s" % (translate("FeatureMesh", "Feature tree"), part.Label), header, tables.tree_note(found), part)
    for row in rows:
        window.tree.addTopLevelItem(window.item((*row[:4], _volume(row[4]), *row[5:])))
    return window.shown()


def show_difference(part, found):
    """Shows what changed, feature by feature and below them face by face; `part` is the new state."""
    header, rows = tables.rows_of_difference(found)
    header = [*header[:3], translate("FeatureMesh", "volume"), *header[4:]]   # in the user's units
    title = "%s: %s" % (translate("FeatureMesh", "What changed"), part.Label)
    window = _Window(title, header, tables.difference_note(found), part)
    for row, feature in zip(rows, found["features"]):
        row = (*row[:2], in_words(feature["detail"]), _volume(row[3]), *row[4:])
        item = window.item(row, tables.face_names(feature["new_faces"]), feature["verdict"])
        for change in _faces_of(feature, found["faces"]):
            item.addChild(_face_item(window, change))
        window.tree.addTopLevelItem(item)
        if feature["verdict"] != "same" and window.first_changed is None:
            window.first_changed = item
    return window.shown()


class _Window(QtGui.QDialog):
    """Closes with its part."""

    def __init__(self, title, header, note, part):
        super().__init__(Gui.getMainWindow())
        self._part, self._document = part, part.Document
        self._before = []   # what was visible before the part was shown for a selection
        FreeCAD.addDocumentObserver(self)
        self.finished.connect(lambda _: self._end())
        self.first_changed = None
        self.setWindowTitle(title)
        self.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        self.resize(1000, 460)
        self.tree = QtGui.QTreeWidget()
        self.tree.setColumnCount(len(header))
        self.tree.setHeaderLabels(header)
        self.tree.setAlternatingRowColors(True)
        self.tree.setSelectionMode(QtGui.QAbstractItemView.ExtendedSelection)
        self.tree.itemSelectionChanged.connect(self._select)
        layout = QtGui.QVBoxLayout(self)
        layout.addWidget(self.tree)
        layout.addWidget(narrow.Words(note))

    def shown(self):
        """Opens the window and returns it."""
        for column in range(self.tree.columnCount()):
            self.tree.resizeColumnToContents(column)
            self.tree.setColumnWidth(column, min(self.tree.columnWidth(column), 420))
        if self.first_changed is not None:
            self.tree.scrollToItem(self.first_changed)
        self.show()
        return self

    def item(self, cells, faces=(), verdict=None):
        """A row that selects these faces."""
        item = QtGui.QTreeWidgetItem([str(cell) for cell in cells])
        item.setData(0, QtCore.Qt.UserRole, list(faces))
        for column, cell in enumerate(cells):
            if len(str(cell)) > 40:
                item.setToolTip(column, str(cell))
        if verdict:
            item.setText(1, tables.verdict_in_words(verdict))
            if verdict in _ICONS:
                item.setIcon(0, drawn_icon("FeatureMesh_Verdict" + _ICONS[verdict]))
            if verdict in _COLOURS:
                item.setForeground(1, QtGui.QBrush(readable.colour_on(self.tree, _COLOURS[verdict])))
        return item

    # FreeCAD's document observer

    def slotDeletedObject(self, obj):
        if obj is self._part:
            self.close()

    def slotDeletedDocument(self, document):
        if document is self._document:
            self._before = []   # nothing of it can be seen any more
            self.close()

    def _end(self):
        FreeCAD.removeDocumentObserver(self)
        restore(self._before)

    def _select(self):
        Gui.Selection.clearSelection()
        names = [name for item in self.tree.selectedItems() for name in item.data(0, QtCore.Qt.UserRole) or ()]
        if names and not self._before:
            self._before = show_part(self._part)
        for name in dict.fromkeys(names):
            Gui.Selection.addSelection(self._part, name)


def _volume(cell):
    return as_shown(in_users_units(cell + " mm^3")) if cell else ""


def _face_item(window, change):
    old, new = change["old_face"] or "", change["new_face"] or ""
    name = old if old == new or not new else new if not old else "%s → %s" % (old, new)
    areas = " → ".join("%.6g" % area for area in (change["old_area"], change["new_area"]) if area is not None)
    detail = "" if change["verdict"] == "kept" else as_shown(in_users_units(translate("FeatureMesh", "area %s mm^2") % areas))
    item = window.item((name, "", detail, "", old, new), [new] if new else (), change["verdict"])
    item.setText(1, tables.verdict_in_words(change["verdict"], change.get("inner", False)))
    return item


def _faces_of(feature, changes):
    """The changes of the feature's faces, those that are no change last."""
    old, new = set(tables.face_names(feature["old_faces"])), set(tables.face_names(feature["new_faces"]))
    mine = [change for change in changes if change["old_face"] in old or change["new_face"] in new]
    return sorted(mine, key=lambda change: change["verdict"] == "kept")

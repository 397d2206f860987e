# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel of a refinement zone: its kind, place, measures and sizes; the 3D view shows each change at once."""

import FreeCAD
import FreeCADGui as Gui
from PySide import QtGui

from .. import api, size_zone, versions
from ..messages import said
from ..user_words import in_words
from ..view_provider import drawn_icon
from . import driven, errors, freecad_widget, narrow, recording, showing, wheel

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
_ROWS = {"Length": QT_TRANSLATE_NOOP("FeatureMesh", "Length"), "Width": QT_TRANSLATE_NOOP("FeatureMesh", "Width"),
         "Height": QT_TRANSLATE_NOOP("FeatureMesh", "Height"), "Radius": QT_TRANSLATE_NOOP("FeatureMesh", "Radius"),
         "Distance": QT_TRANSLATE_NOOP("FeatureMesh", "Distance"), "InnerSize": QT_TRANSLATE_NOOP("FeatureMesh", "Size inside"),
         "OuterSize": QT_TRANSLATE_NOOP("FeatureMesh", "Size outside"), "Transition": QT_TRANSLATE_NOOP("FeatureMesh", "Grows over")}


class ZonePanel:
    """Changes the zone as its widgets are changed, within one step of undo: OK ends it and updates the mesh, Cancel takes all of it back."""

    def __init__(self, zone):
        self.zone, self.document = zone, zone.Document
        self.mesh = next((obj for obj in zone.InList if obj in api.meshes_of(self.document)), None)
        if not self.document.HasPendingTransaction:   # else that of the command that made the zone
            self.document.openTransaction(translate("FeatureMesh", "Refinement zone"))
        part = versions.part_of(self.mesh) if self.mesh is not None else None
        self._shown_before = showing.show_part(part) if part is not None else []
        self.form = QtGui.QWidget()
        narrow.title(self.form, zone.Label)
        self.form.setWindowIcon(drawn_icon("FeatureMesh_AddSizeZone"))
        self._build()
        self._close_driven_fields()
        wheel.scrolls(self.form, self.kind, *self.lengths.values())
        self._show_rows()

    def _build(self):
        self.rows = QtGui.QFormLayout(self.form)
        narrow.margins(self.rows)
        if self.mesh is None:
            self.rows.addRow(narrow.Words(translate("FeatureMesh", "This is in no mesh. Drag it to one in the tree.")))
        self.kind = QtGui.QComboBox()
        self.kind.addItems([translate("FeatureMesh", kind) for kind in size_zone.KINDS])
        self.kind.setCurrentIndex(size_zone.KINDS.index(self.zone.Kind))
        self.kind.currentIndexChanged.connect(self._take_kind)
        self.rows.addRow(translate("FeatureMesh", "Kind"), self.kind)
        self.place = [self._spin(self.zone.Placement.Base[axis], lambda _, axis=axis: self._move(axis)) for axis in range(3)]
        for axis, widget in zip("XYZ", self.place):
            self.rows.addRow(axis, widget)
        self.references, choose = narrow.Words(), QtGui.QPushButton(translate("FeatureMesh", "Take what is selected"))
        choose.clicked.connect(self._take_selection)
        self.choose = choose
        choose.setEnabled(self.mesh is not None)
        self.rows.addRow(translate("FeatureMesh", "From"), self.references)
        self.rows.addRow(choose)
        self.lengths = {}
        for name, label in _ROWS.items():
            widget = self._spin(getattr(self.zone, name).Value, lambda _, name=name: self._take_length(name))
            widget.setProperty("minimum", 0.0)
            widget.setToolTip(translate("App::Property", self.zone.getDocumentationOfProperty(name)))
            self.lengths[name] = widget
            self.rows.addRow(translate("FeatureMesh", label), widget)
        self.suppressed = QtGui.QCheckBox(translate("FeatureMesh", "Leave it out"))
        self.suppressed.setChecked(self.zone.Suppressed)
        self.suppressed.toggled.connect(lambda checked: setattr(self.zone, "Suppressed", checked))
        self.rows.addRow("", self.suppressed)

    def _close_driven_fields(self):
        driven.close(self.zone, {
            "Kind": (self.kind,), "Suppressed": (self.suppressed,), "Placement": self.place, "Placement.Base": self.place,
            **{"Placement.Base." + axis: (widget,) for axis, widget in zip("xyz", self.place)}, **{name: (widget,) for name, widget in self.lengths.items()}})

    def _spin(self, value, changed):
        widget = freecad_widget.length_field()
        widget.setProperty("rawValue", value)
        widget.setMinimumWidth(70)
        widget.valueChanged.connect(changed)
        return widget

    # What FreeCAD calls

    def getStandardButtons(self):
        return sum(versions.number_of(button) for button in (QtGui.QDialogButtonBox.Ok, QtGui.QDialogButtonBox.Cancel))

    def accept(self):
        """OK: the mesh follows, as with FEM's own refinements."""
        self.document.recompute()
        self.document.commitTransaction()
        recording.recomputed(self.document)
        self._close()
        return True

    def reject(self):
        """Cancel: nothing of what was changed remains, nor a zone that is new."""
        freecad_widget.silence(self.form)
        self.document.abortTransaction()
        self._close()
        return True

    def _close(self):
        showing.restore(self._shown_before)
        Gui.getDocument(self.document).resetEdit()

    # Changes

    def _show_rows(self):
        """Shows what the kind has."""
        kind = self.zone.Kind
        visible = {widget: kind != size_zone.DISTANCE for widget in self.place}
        visible.update({self.references: kind == size_zone.DISTANCE, self.choose: kind == size_zone.DISTANCE})
        visible.update({widget: name in size_zone.MEASURES[kind] or name in ("InnerSize", "OuterSize", "Transition") for name, widget in self.lengths.items()})
        for widget, is_visible in visible.items():
            widget.setVisible(is_visible)
            label = self.rows.labelForField(widget)
            if label is not None:
                label.setVisible(is_visible)
        names = [name for _, subs in self.zone.References or () for name in subs]
        self.references.setText(in_words(said("{places:entities}", places=names)) if names else translate("FeatureMesh", "nothing yet: select faces, edges or vertices"))

    def _take_kind(self, index):
        size_zone.change_kind(self.zone, size_zone.KINDS[index])
        for axis, widget in enumerate(self.place):
            widget.blockSignals(True)
            widget.setProperty("rawValue", self.zone.Placement.Base[axis])
            widget.blockSignals(False)
        self._show_rows()

    def _take_length(self, name):
        setattr(self.zone, name, self.lengths[name].property("rawValue"))

    def _move(self, axis):
        placement = self.zone.Placement
        base = placement.Base
        base[axis] = self.place[axis].property("rawValue")
        self.zone.Placement = FreeCAD.Placement(base, placement.Rotation)

    def _take_selection(self):
        selected = [(entry.Object, name) for entry in Gui.Selection.getSelectionEx(self.document.Name) for name in entry.SubElementNames]
        try:
            api.refer_size_zone(self.zone, self.mesh, selected)
        except Exception as error:
            errors.show(error)
        self._show_rows()

# SPDX-License-Identifier: GPL-3.0-or-later
"""The page FeatureMesh in FreeCAD's preferences."""

import FreeCAD
from PySide import QtGui

from .. import engine, preferences
from . import freecad_widget

translate = FreeCAD.Qt.translate


def choose_place():
    """Makes the engine run where the user prefers."""
    if preferences.get("InWorker"):
        engine.run_in_worker()
    else:
        engine.run_here()


class PreferencesPage:
    """FreeCAD makes one when its preferences are opened, and calls loadSettings and saveSettings. What its Reset is to forget it reads from the fields."""

    def __init__(self, parent=None):
        self.form = QtGui.QWidget()
        self.form.setWindowTitle("FeatureMesh")
        layout = QtGui.QVBoxLayout(self.form)
        layout.addWidget(self._new_meshes())
        layout.addWidget(self._engine())
        layout.addWidget(self._colours())
        layout.addStretch()
        for name, field in {"ElementsAlongDiagonal": self.elements, "SecondOrder": self.order, "Automatic": self.automatic, "Threads": self.threads,
                            "InWorker": self.in_worker, **self.colours}.items():
            field.setProperty("prefPath", preferences.GROUP.partition("Preferences/")[2])
            field.setProperty("prefEntry", name)

    def loadSettings(self):
        self.elements.setValue(preferences.get("ElementsAlongDiagonal"))
        self.order.setCurrentIndex(1 if preferences.get("SecondOrder") else 0)
        self.automatic.setChecked(preferences.get("Automatic"))
        self.threads.setValue(preferences.get("Threads"))
        self.in_worker.setChecked(preferences.get("InWorker"))
        for name, button in self.colours.items():
            button.setProperty("color", QtGui.QColor.fromRgbF(*preferences.colour(name)))

    def saveSettings(self):
        preferences.put("ElementsAlongDiagonal", self.elements.value())
        preferences.put("SecondOrder", self.order.currentIndex() == 1)
        preferences.put("Automatic", self.automatic.isChecked())
        preferences.put("Threads", self.threads.value())
        preferences.put("InWorker", self.in_worker.isChecked())
        for name, button in self.colours.items():
            preferences.put_colour(name, button.property("color").getRgbF()[:3])
        choose_place()

    def _new_meshes(self):
        group = QtGui.QGroupBox(translate("FeatureMesh", "New meshes"))
        form = QtGui.QFormLayout(group)
        self.elements = QtGui.QSpinBox()
        self.elements.setRange(3, 500)
        self.elements.setToolTip(translate("FeatureMesh", "The size of a new mesh is the diagonal of the part divided by this number"))
        self.order = QtGui.QComboBox()
        self.order.addItems([translate("FeatureMesh", "4-node tetrahedra"), translate("FeatureMesh", "10-node tetrahedra")])
        self.order.setToolTip(translate("FeatureMesh", "10-node tetrahedra have mid-side nodes on the surface; 4-node ones are too stiff in bending"))
        self.automatic = QtGui.QCheckBox(translate("FeatureMesh", "Update automatically"))
        self.automatic.setToolTip(translate("FeatureMesh", "The mesh follows every recompute of the document"))
        form.addRow(translate("FeatureMesh", "Elements along the diagonal"), self.elements)
        form.addRow(translate("FeatureMesh", "Element"), self.order)
        form.addRow(self.automatic)
        return group

    def _engine(self):
        group = QtGui.QGroupBox(translate("FeatureMesh", "Work"))
        form = QtGui.QFormLayout(group)
        self.threads = QtGui.QSpinBox()
        self.threads.setRange(0, 256)
        self.threads.setSpecialValueText(translate("FeatureMesh", "all"))
        self.threads.setToolTip(translate("FeatureMesh", "Processor threads of a new mesh; the mesh is the same for any number"))
        self.in_worker = QtGui.QCheckBox(translate("FeatureMesh", "Mesh in a process of its own"))
        self.in_worker.setToolTip(translate("FeatureMesh", "A crash of the geometry kernel then ends that process only; "
                                                           "FreeCAD and the document stay as they are"))
        form.addRow(translate("FeatureMesh", "Threads"), self.threads)
        form.addRow(self.in_worker)
        return group

    def _colours(self):
        group = QtGui.QGroupBox(translate("FeatureMesh", "Colours"))
        form = QtGui.QFormLayout(group)
        self.colours = {}
        for name, text in (("KeptColour", translate("FeatureMesh", "Kept elements")),
                           ("NewColour", translate("FeatureMesh", "New elements")),
                           ("ActiveColour", translate("FeatureMesh", "Nodes kept as start positions"))):
            self.colours[name] = freecad_widget.made("Gui::ColorButton")
            self.colours[name].setToolTip(translate("FeatureMesh", "What the colours over the mesh mean when the last update is shown"))
            form.addRow(text, self.colours[name])
        return group

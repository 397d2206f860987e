# SPDX-License-Identifier: GPL-3.0-or-later
"""Tells the model's side which object's task panel is open, and when it is closed; shows the part while its faces are asked for, and why an analysis is not
solved."""

import FreeCADGui as Gui

from .. import disk_room, history, references, solve_guard
from ..mesh_object import is_feature_mesh
from ..wrapping import wrap
from . import closes_with_object, errors, recording, showing


def install():
    """To be called once."""
    references.is_in_edit = _is_in_edit
    solve_guard.tell, disk_room.tell = errors.show, errors.show_half_saved
    Gui.addDocumentObserver(_Observer())
    wrap("femviewprovider.view_base_femobject", "VPBaseFemObject", "doubleClicked", _of_fem)


def _is_in_edit(obj):
    document = Gui.getDocument(obj.Document.Name)
    view = document.getInEdit() if document is not None else None
    return getattr(view, "Object", None) is obj   # an assembly that is being edited has a view without one


def _of_fem(original, provider, view):
    """FEM's panels that are written in Python take no other's place, as those of its loads do: beside one of ours they hid the mesh, and were not opened."""
    closes_with_object.close_open()
    return original(provider, view)


class _Observer:

    def __init__(self):
        self._before = []   # what was seen before the panel was opened

    def slotInEdit(self, view):
        obj = getattr(view, "Object", None)
        if obj is not None and hasattr(obj, "References"):
            self._before = showing.show_to_click(obj)
        elif obj is not None and obj.isDerivedFrom("Fem::FemResultObject"):
            self._before = showing.show_result_mesh(obj)

    def slotResetEdit(self, view):
        obj = getattr(view, "Object", None)
        if obj is not None and hasattr(obj, "References"):
            history.settle(obj)
            if obj.Document.HasPendingTransaction and any(is_feature_mesh(user) for user in obj.InList):
                obj.Document.commitTransaction()   # that of our command; FreeCAD 0.20 leaves it open
                if recording.is_told(obj):
                    recording.recomputed(obj.Document)
        showing.restore(self._before)
        self._before = []
        if obj is not None and hasattr(obj, "References"):
            showing.show_unless_seen(obj)
        if obj is not None:
            recording.forget(obj)

# SPDX-License-Identifier: GPL-3.0-or-later
"""How the window shows an error: a message, and the faces, edges or vertices that it is about selected in the view."""

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore

from .. import api, log
from ..mesh_object import is_cancelled
from ..messages import entities_in, of_error
from ..user_words import as_sentence
from . import message_box
from .showing import show_part

translate = FreeCAD.Qt.translate


def show(error, part=None):
    """Shows an error of some work on `part`; that the user cancelled needs no answer."""
    if is_cancelled(error):
        Gui.getMainWindow().statusBar().showMessage(translate("FeatureMesh", "Cancelled; the mesh is as it was."), 5000)
        return
    message = as_sentence(of_error(error))
    log.write_error(error)
    FreeCAD.Console.PrintError("FeatureMesh: %s\n" % message)
    select_named(error, part)
    message_box.warn(message)


def show_half_saved(document, error):
    """Shows the error once FreeCAD takes the document for saved, and marks it as changed again: FreeCAD asks before it is closed then."""
    name = document.Name

    def tell():
        if name in FreeCAD.listDocuments():
            _mark_as_changed(FreeCAD.getDocument(name))
        show(error)
    QtCore.QTimer.singleShot(0, tell)


def _mark_as_changed(document):
    try:
        Gui.getDocument(document.Name).Modified = True
    except AttributeError:   # FreeCAD 0.20 takes it for changed when something is touched
        for mesh in (mesh for mesh in api.meshes_of(document) if "Touched" not in mesh.State):
            mesh.touch()
            mesh.purgeTouched()


def select_named(error, part):
    """Selects the faces, edges and vertices of `part` that the message is about, and shows the part with them."""
    names = [name for name in entities_in(of_error(error)) if _has(part, name)]
    if not names:
        return
    show_part(part)
    Gui.Selection.clearSelection()
    for name in names:
        Gui.Selection.addSelection(part, name)


def _has(part, name):
    try:
        return part is not None and not part.Shape.getElement(name).isNull()
    except Exception:   # FreeCAD's exception for an unknown element differs between its versions
        return False

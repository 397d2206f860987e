# SPDX-License-Identifier: GPL-3.0-or-later
"""Remembers through which link something was clicked: FEM's panels keep the feature alone, which every link to it shows."""

import FreeCAD
import FreeCADGui as Gui

from .. import history, references, resolving

_UNRESOLVED = 0   # paths as they were clicked, down from the outermost object
_through = {}     # (document, object, sub-element) as FEM's panels keep it -> "Link.Fillet.Face19", of the last click on it


def install():
    """To be called once."""
    history.watch()   # loads may come before the first mesh
    references.clicked_through = clicked_through
    Gui.Selection.addObserver(_Observer(), _UNRESOLVED)


def clicked_through(obj):
    """The paths of those references of an FEM object that were last clicked through a link."""
    keys = [(target.Document.Name, target.Name, sub) for target, sub in resolving.plain_pairs_of(obj)]
    return [_through[key] for key in keys if key in _through]


class _Observer:

    def addSelection(self, document, name, sub, _):
        root = FreeCAD.getDocument(document).getObject(name)
        if root is None:
            return
        path, element = resolving.path_of(root, sub)
        key = path[-1].Document.Name, path[-1].Name, element
        _through.pop(key, None)
        if any(step.isDerivedFrom("App::Link") for step in path):
            _through[key] = "%s.%s" % (name, resolving.plain(sub))

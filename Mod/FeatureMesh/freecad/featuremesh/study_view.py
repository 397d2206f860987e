# SPDX-License-Identifier: GPL-3.0-or-later
"""How a study looks in the tree and what a double click does."""

import FreeCADGui as Gui

from . import view_provider


def attach(study):
    """Gives a study its view, if it has none of ours yet."""
    view = study.ViewObject
    if view is not None and not isinstance(getattr(view, "Proxy", None), ViewStudy):
        ViewStudy(view)


class ViewStudy:
    """Proxy of the view. Its class path is stored in documents and never changes."""

    def __init__(self, view):
        view.Proxy = self

    def attach(self, view):
        self.Object = view.Object

    def getIcon(self):
        view_provider.drawn_icon("FeatureMesh_Study")   # FreeCAD keeps it; without a Qt plugin for SVG it could not load it from the path
        return view_provider.icon("FeatureMesh_Study")

    def isShow(self):
        """There is nothing to hide, so the tree does not draw it as hidden."""
        return True

    def setEdit(self, view, mode=0):
        from .gui.study_panel import StudyPanel
        if Gui.Control.activeDialog():
            return False
        Gui.Control.showDialog(StudyPanel(view.Object))
        return True

    def unsetEdit(self, view, mode=0):
        Gui.Control.closeDialog()
        return True

    def doubleClicked(self, view):
        document = Gui.getDocument(view.Object.Document)
        if not document.getInEdit():
            document.setEdit(view.Object.Name)
        return True

    def dumps(self):
        return None

    def loads(self, saved):
        return None

    __getstate__ = dumps
    __setstate__ = loads

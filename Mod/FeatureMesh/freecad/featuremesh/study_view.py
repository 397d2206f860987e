# SPDX-License-Identifier: GPL-3.0-or-later
"""How a study looks in the tree and what a double click does."""

from . import view_provider
from .gui.edited_in_panel import EditedInPanel


def attach(study):
    """Gives a study its view, if it has none of ours yet."""
    view = study.ViewObject
    if view is not None and not isinstance(getattr(view, "Proxy", None), ViewStudy):
        ViewStudy(view)


class ViewStudy(EditedInPanel):
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

    def panel_of(self, obj):
        from .gui.study_panel import StudyPanel
        return StudyPanel(obj)

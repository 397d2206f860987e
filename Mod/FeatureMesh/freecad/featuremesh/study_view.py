# SPDX-License-Identifier: GPL-3.0-or-later
"""How a study looks in the tree and what a double click does."""

from . import view_provider
from .gui.edited_in_panel import EditedInPanel


class ViewStudy(EditedInPanel):
    """Proxy of the view. Its class path is stored in documents and never changes."""

    def getIcon(self):
        return view_provider.kept_icon("FeatureMesh_Study")

    def isShow(self):
        """There is nothing to hide, so the tree does not draw it as hidden."""
        return True

    def panel_of(self, obj):
        from .gui.study_panel import StudyPanel
        return StudyPanel(obj)

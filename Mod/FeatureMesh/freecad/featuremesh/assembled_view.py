# SPDX-License-Identifier: GPL-3.0-or-later
"""How the shape of a container's parts looks: as any shape, with our icon. It is hidden at first, since the parts are there themselves."""

from . import view_provider
from .proxies import View


def attach(obj):
    """Gives the object its view, if it has none of ours yet."""
    if ViewAssembledParts.attach_to(obj):
        obj.ViewObject.Visibility = False


class ViewAssembledParts(View):
    """Proxy of the view. Its class path is stored in documents and never changes."""

    def getIcon(self):
        return view_provider.kept_icon("FeatureMesh_ShowTree")

    def setEdit(self, view, mode=0):
        """FreeCAD's Transform, which a double click opens, too, would move it away from the parts."""
        return False

# SPDX-License-Identifier: GPL-3.0-or-later
"""How the shape of a container's parts looks: as any shape, with our icon. It is hidden at first, since the parts are there themselves."""

from . import view_provider
from .proxies import Stateless

_ICON = "FeatureMesh_ShowTree"


def attach(obj):
    """Gives the object its view, if it has none of ours yet."""
    view = obj.ViewObject
    if view is not None and not isinstance(getattr(view, "Proxy", None), ViewAssembledParts):
        ViewAssembledParts(view)
        view.Visibility = False


class ViewAssembledParts(Stateless):
    """Proxy of the view. Its class path is stored in documents and never changes."""

    def __init__(self, view):
        view.Proxy = self

    def getIcon(self):
        view_provider.drawn_icon(_ICON)   # FreeCAD keeps it; without a Qt plugin for SVG it could not load it from the path
        return view_provider.icon(_ICON)

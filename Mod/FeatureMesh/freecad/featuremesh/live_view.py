# SPDX-License-Identifier: GPL-3.0-or-later
"""How a live result looks: the deformed part in colours, grey while it is out of date."""

import operator

from pivy import coin

from . import live_overlay, live_result, view_provider
from .element_view import ElementView
from .gui import showing
from .gui.edited_in_panel import DrawnByUs
from .waiting import let_the_window_live

_TURNS = 3   # of the window's loop: the view asks for a picture in one and has it in a later one
_MARK = (0.8, 0.0, 0.8)
# Called as (live result, property) when one of its properties has changed.
followers = []


def show_solution(live):
    """Draws a new solution, at once: FreeCAD's result object, which is filled next, takes a while."""
    live.ViewObject.Proxy.draw(live)
    for follow in list(followers):
        follow(live, "Status")
    for _ in range(_TURNS):
        let_the_window_live()


class ViewLiveResult(DrawnByUs):
    """Proxy of the view. Its class path is stored in documents and never changes."""

    mode = "Field"

    # FreeCAD's side

    def attach(self, view):
        super().attach(view)
        self.settings = live_overlay.Settings()
        self.accuracy = 5.0     # percent that are wanted
        self._elements = None
        self._drawn = None
        self._drawn_from = ()   # what was drawn last
        self._is_to_be_alone = False
        self._mesh_name = ""    # of what was drawn last
        view.addDisplayMode(coin.SoGroup(), self.mode)

    def getIcon(self):
        return view_provider.status_icon(self, "FeatureMesh_LiveResult", "FeatureMesh_LiveResultStale")

    def canDelete(self, obj):
        """Nothing of its analysis breaks it: it says itself what it lacks then, and undo solves it again."""
        return True

    def updateData(self, live, name):
        if name == "Status":
            live.ViewObject.signalChangeIcon()
            if not self._is_drawn(live):
                self.draw(live)
            if live.Status != live_result.UP_TO_DATE and not live.Document.Transacting:   # an undo may be taking the result away
                _uncolour(live.Result)
        for follow in list(followers):
            follow(live, name)

    def onChanged(self, view, name):
        if name == "Visibility" and view.Visibility and getattr(self, "_drawn", None) is None and hasattr(self, "Object"):
            self.draw(self.Object)

    def panel_of(self, obj):
        from .gui.live_panel import LivePanel
        return LivePanel(obj)

    # Drawing

    @property
    def drawn(self):
        """The live_overlay.FieldOverlay on the screen, None where there is nothing to draw."""
        return self._drawn

    def show_alone(self, live):
        """Hides what covers it as soon as there is something to see of it; until then the mesh is better than nothing."""
        live.ViewObject.Visibility = self._is_to_be_alone = True
        self._uncover(live)

    def _uncover(self, live):
        if self._is_to_be_alone and self._drawn is not None and live.ViewObject.Visibility:
            self._is_to_be_alone = False
            showing.show_result(live)

    def draw(self, live):
        """Draws the solution as the settings say, or how the part can move where that is why there is none."""
        if not hasattr(live.Proxy, "solution"):
            return   # the document is being opened
        before, self._drawn, self._drawn_from = self._drawn, self._overlay(live), self._to_draw(live)
        if self._elements is None:
            self._elements = ElementView(live.ViewObject.RootNode)
        if self._drawn is None:
            self._elements.end()
            if before is not None:
                self._give_way(live)
            return
        self._mesh_name = live.Proxy.mesh(live).Name
        self._elements.show(self._drawn, self.settings.plane)
        self._uncover(live)
        row = self._drawn.largest()
        self._elements.mark(self._drawn.points[[row]] if row is not None else (), (), _MARK)

    def _give_way(self, live):
        """Until there is something to see of it again the mesh may be shown; where that was taken out of the analysis it is."""
        self._is_to_be_alone = True
        mesh = live.Document.getObject(self._mesh_name)
        if mesh is not None and live.Proxy.mesh(live) is None and live.ViewObject.Visibility:
            showing.show_where_nothing_is_seen(mesh)

    def _to_draw(self, live):
        return live.Proxy.solution, live.Proxy.before, live.Proxy.motion, live.Proxy.is_fresh, live.Proxy.mesh(live) is None, self.settings

    def _is_drawn(self, live):
        """Would drawing it again show the same?"""
        return self._drawn is not None and hasattr(live.Proxy, "solution") and all(map(operator.is_, self._drawn_from, self._to_draw(live)))

    def _overlay(self, live):
        solution, mesh = live.Proxy.shown(live), live.Proxy.mesh(live)
        if live.Proxy.motion is not None and mesh is not None:
            arrays = mesh.Proxy.arrays(mesh)
            if len(arrays["points"]) == len(live.Proxy.motion):
                return live_overlay.motion_overlay(arrays, live.Proxy.motion)
        if solution is None:
            return None
        return live_overlay.overlay(solution, live.Proxy.before, self.settings, live.Proxy.is_fresh)


def _uncolour(result):
    """Takes away the colours that FreeCAD's own result panel gave an old result."""
    view = getattr(getattr(result, "Mesh", None), "ViewObject", None)
    if view is not None and hasattr(view, "resetNodeColor"):
        view.resetNodeColor()
        view.ShapeColor = view.ShapeColor   # FreeCAD 1.0 keeps the colours of nodes until the mesh gets its own
        view.resetNodeDisplacement()
        # This object, too, belongs to the step of undo then, which FreeCAD looks for when it is deleted; of a view alone it does not, and undo would crash.
        result.Mesh.Visibility = result.Mesh.Visibility

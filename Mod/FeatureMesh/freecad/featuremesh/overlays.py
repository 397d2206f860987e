# SPDX-License-Identifier: GPL-3.0-or-later
"""Colours for the elements of a mesh: what the last update kept, and how good the elements are."""

from dataclasses import dataclass, field

import numpy as np

from . import preferences
from .errors import UserError
from .messages import said
from .formats import connectivity, filling_of
from .quality import MEASURES, mean_edge_length
from .section import seen_of


@dataclass
class Overlay:
    """A colour for each element of a mesh, as it is now."""
    numbers: np.ndarray            # (m,) of the elements
    colours: np.ndarray            # (m,3) shares of red, green and blue
    points: np.ndarray             # (n,3) mm
    elements: np.ndarray           # (m,4) corners of tets, or (m,3) of triangles
    on_surface: np.ndarray         # (n,) bool
    values: np.ndarray = None      # (m,) of the measure
    kept: np.ndarray = None        # (m,) bool
    has_edges = True   # drawn with the edges of the elements
    _seen = None
    active: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))   # (k,3) mm: where nodes were that served as start positions only

    def drawn(self, plane=None, is_filled=False):
        """(k,3,3) corners of the triangles to draw, mm, and (k,3) their colours; cut open by a section.Plane: whole elements, or with the cut filled."""
        if self._seen is None:
            self._seen = seen_of(self.points, self.elements)
        corners, owners = self._seen.cut_open(self.on_surface, plane, is_filled)
        return corners, self.colours[owners]


def show(mesh, overlay, plane=None):
    """Draws it in place of the mesh in the window, if there is one, cut open by a section.Plane. Returns the overlay."""
    if mesh.ViewObject is not None:
        mesh.ViewObject.Proxy.show(mesh, overlay, plane)
        mesh.ViewObject.Visibility = True
    return overlay


def hide(mesh):
    """Draws the mesh as usual again."""
    if mesh.ViewObject is not None:
        mesh.ViewObject.Proxy.show(mesh, None)


def kept(mesh):
    """The elements that the last update kept, and new ones. Throws UserError when there was no update since the document was opened."""
    part_mesh = mesh.Proxy.last_part_mesh(mesh)
    origin = np.asarray(part_mesh.tet_origin())
    if not len(origin) or not (origin >= 0).any():
        raise UserError(said("no element of {mesh:text} is known to be kept: it was meshed from scratch, or brought back by undo or from a file. Edit the part first",
                             mesh=mesh.Label))
    kept_colour, new_colour, _ = kept_legend()
    is_kept = origin >= 0
    return Overlay(colours=np.where(is_kept[:, None], [kept_colour], [new_colour]), kept=is_kept,
                   active=np.asarray(part_mesh.active_points()).reshape(-1, 3), **_mesh_of(part_mesh.arrays()))


def kept_legend():
    """The user's colours for kept elements, new elements, and active nodes."""
    return tuple(preferences.colour(name) for name in ("KeptColour", "NewColour", "ActiveColour"))


def quality(mesh, measure="dihedral_angle", limits=None):
    """The elements by one of quality.MEASURES; `limits` (what is bad, what is good) are by default the measure's own. Throws UserError."""
    if measure not in MEASURES:
        raise UserError(said("there is no measure {measure:text}, only {measures:text}", measure=measure, measures=", ".join(MEASURES)))
    if limits is not None and not _are_limits(limits):
        raise UserError(said("the limits of {measure:text} are two numbers that differ, not {limits:text}", measure=measure, limits=str(limits)))
    arrays = mesh.Proxy.arrays(mesh)
    values = values_of(mesh, measure, arrays)
    return Overlay(colours=MEASURES[measure].colours(values, limits), values=values, **_mesh_of(arrays))


def _are_limits(limits):
    try:
        bad, good = map(float, limits)
    except (TypeError, ValueError):
        return False
    return bool(np.isfinite((bad, good)).all()) and bad != good


def worst_tets(mesh, count=10, measure="dihedral_angle"):
    """(number, value) of the worst tets by a measure, worst first."""
    overlay = quality(mesh, measure)
    rows = MEASURES[measure].worst(overlay.values, count)
    return list(zip(overlay.numbers[rows].tolist(), overlay.values[rows].tolist()))


def values_of(mesh, measure, arrays):
    """(m,) the measure of each element. Throws UserError where only edges are meshed."""
    kind, mids, _, _ = _filling_to_look_at(arrays)
    if MEASURES[measure].values is not None:
        return MEASURES[measure].values(arrays["points"], connectivity(arrays, kind, mids))
    return size_ratio(mesh, arrays["points"], arrays[kind])


def size_ratio(mesh, points, elements):
    """(m,) mean edge length over the length that is wanted in the middle of each element."""
    wanted = mesh.Proxy.last_part_mesh(mesh).wanted_sizes(points[elements].mean(axis=1))
    return mean_edge_length(points, elements) / np.maximum(wanted, np.finfo(float).tiny)


def _filling_to_look_at(arrays):
    names = filling_of(arrays)
    if names[0] == "segments":
        raise UserError(said("the mesh of edges has segments only, which have no shape to judge and nothing to colour"))
    return names


def _mesh_of(arrays):
    on_surface = np.zeros(len(arrays["points"]), dtype=bool)
    on_surface[arrays["triangles"]] = True
    kind, _, numbers, _ = _filling_to_look_at(arrays)
    return {"numbers": arrays[numbers], "points": arrays["points"], "elements": arrays[kind], "on_surface": on_surface}

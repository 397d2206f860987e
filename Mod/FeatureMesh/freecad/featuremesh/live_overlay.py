# SPDX-License-Identifier: GPL-3.0-or-later
"""What is seen of a live result: the deformed surface in the colours of a field, straight from the solution's arrays."""

from dataclasses import dataclass

import numpy as np

from .formats import flat_triangles
from .section import SeenMesh

FIELDS = ("von_mises", "displacement")
UNITS = {"von_mises": "MPa", "displacement": "mm"}
# From small to large, and from less through the same to more.
COLOURS = np.array(((0.19, 0.30, 0.70), (0.25, 0.65, 0.85), (0.35, 0.73, 0.40), (0.95, 0.85, 0.30), (0.80, 0.15, 0.12)))
DIFFERENCE_COLOURS = np.array(((0.15, 0.30, 0.70), (0.55, 0.70, 0.88), (0.93, 0.93, 0.90), (0.93, 0.62, 0.48), (0.72, 0.10, 0.12)))
_NOT_KNOWN = (0.60, 0.62, 0.64)
_MOTION = (0.95, 0.60, 0.25)
_TO_GREY = np.array((0.30, 0.59, 0.11))
_SEEN_SHARE = 0.08   # of the part's size that the largest displacement is drawn as, where the user says nothing


@dataclass
class Settings:
    """What of a solution is shown."""
    field: str = "von_mises"
    is_difference: bool = False
    scale: float = 0.0   # of the displacements; 0: so that they are seen
    top: float = 0.0     # where the colours end; 0: at the largest value
    plane: object = None


class FieldOverlay:
    """A colour for each node of the deformed mesh, for element_view."""

    has_edges = False

    def __init__(self, arrays, points, colours, values, limits):
        self.arrays, self.points, self.node_colours = arrays, points, colours
        self.values = values      # (n,), not a number where none is known
        self.limits = limits      # of the colours
        self.table = COLOURS

    def drawn(self, plane=None, is_filled=False):
        """(k,3,3) corners of the triangles to draw, mm, and (k,3,3) the colours of each of their corners; cut open by whole elements."""
        if plane is None:
            triangles = flat_triangles(self.arrays)
        else:
            triangles, _ = SeenMesh(self.points, self.arrays["tets"]).whole(plane)
        return self.points[triangles], self.node_colours[triangles]

    def largest(self):
        """The row of the node with the largest value in size, None where none is known."""
        known = np.abs(np.nan_to_num(self.values))
        return int(known.argmax()) if np.isfinite(self.values).any() else None


def overlay(solution, before, settings, is_fresh):
    """The FieldOverlay of a live_result.Solution as the settings say; in greys where it is out of date. `before` is the Solution before it, or None."""
    values = values_of(solution, settings.field)
    if settings.is_difference:
        values = difference(solution, before, settings.field) if before is not None else np.full(len(values), np.nan)
    found = np.abs(values[np.isfinite(values)]).max(initial=0.0)
    top = settings.top or found or 1.0
    low, table = (-top, DIFFERENCE_COLOURS) if settings.is_difference else (0.0, COLOURS)
    colours = colours_of(values, low, top, table)
    made = FieldOverlay(solution.arrays, solution.arrays["points"] + scale_of(solution, settings) * solution.displacements,
                        colours if is_fresh else in_grey(colours), values, (low, top))
    made.table = table if is_fresh else in_grey(table)
    return made


def motion_overlay(arrays, motion):
    """The mesh as it can still move, in one colour."""
    count = len(arrays["points"])
    return FieldOverlay(arrays, arrays["points"] + motion, np.tile(_MOTION, (count, 1)), np.full(count, np.nan), (0.0, 1.0))


def values_of(solution, field):
    """(n,) the field at the nodes."""
    return solution.von_mises if field == "von_mises" else np.linalg.norm(solution.displacements, axis=1)


def difference(solution, before, field):
    """(n,) new less old at the nodes that were kept, whose numbers are the same; not a number elsewhere."""
    numbers, old = solution.arrays["node_numbers"], before.arrays["node_numbers"]
    _, rows, old_rows = np.intersect1d(numbers, old, assume_unique=True, return_indices=True)
    found = np.full(len(numbers), np.nan)
    found[rows] = values_of(solution, field)[rows] - values_of(before, field)[old_rows]
    return found


def scale_of(solution, settings):
    """By how much displacements are drawn larger than they are."""
    if settings.scale:
        return settings.scale
    largest = np.linalg.norm(solution.displacements, axis=1).max(initial=0.0)
    size = np.linalg.norm(np.ptp(solution.arrays["points"], axis=0))
    return _rounded(_SEEN_SHARE * size / largest) if largest > 0 else 1.0


def colours_of(values, low, top, table):
    """(n,3) colours between those of the table, which are evenly spread from `low` to `top`."""
    share = np.clip((np.nan_to_num(values) - low) / (top - low), 0, 1) * (len(table) - 1)
    known = np.stack([np.interp(share, np.arange(len(table)), table[:, c]) for c in range(3)], axis=1)
    return np.where(np.isfinite(values)[:, None], known, _NOT_KNOWN)


def in_grey(colours):
    """The same colours without hue."""
    return np.repeat((0.25 + 0.6 * (colours @ _TO_GREY))[:, None], 3, axis=1)


def _rounded(value):
    """To one digit of 1, 2 and 5."""
    power = 10.0 ** np.floor(np.log10(value))
    return float(power * max(step for step in (1, 2, 5) if step * power <= value * (1 + 1e-9)))

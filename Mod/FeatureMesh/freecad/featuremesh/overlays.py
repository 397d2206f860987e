# SPDX-License-Identifier: GPL-3.0-or-later
"""Colours for the elements of a mesh: what the last update kept, and how good the elements are."""

import FreeCAD
import numpy as np

from . import preferences
from .errors import UserError
from .pictures import tet_quality

translate = FreeCAD.Qt.translate
# Colour from the smallest dihedral angle on (degrees): red is bad, green is good.
QUALITY_STEPS = ((0, (0.75, 0.10, 0.10)), (10, (0.88, 0.35, 0.13)), (20, (0.97, 0.65, 0.20)), (30, (0.95, 0.85, 0.35)),
                 (40, (0.60, 0.80, 0.40)), (50, (0.25, 0.62, 0.30)))


def smallest_angles(arrays):
    """Smallest dihedral angle of each tet, degrees, (m,)."""
    return tet_quality(arrays["points"], arrays["tets"])[0]


def kept_colours(mesh):
    """{tet number: colour} after an update in this session. Throws UserError when there was none."""
    part_mesh = mesh.Proxy.last_part_mesh(mesh)
    origin = np.asarray(part_mesh.tet_origin())
    if not len(origin) or not (origin >= 0).any():
        raise UserError(translate("FeatureMesh", "%s was not updated since the document was opened, all its elements are as they were") % mesh.Label)
    numbers = part_mesh.arrays()["tet_numbers"].tolist()
    kept_colour, new_colour, _ = kept_legend()
    return {number: kept_colour if kept else new_colour for number, kept in zip(numbers, (origin >= 0).tolist())}


def kept_legend():
    """The user's colours for kept elements, new elements, and active nodes."""
    return tuple(preferences.colour(name) for name in ("KeptColour", "NewColour", "ActiveColour"))


def active_points(mesh):
    """(k,3) mm: where the nodes were that the last update took as start positions without keeping them."""
    return np.asarray(mesh.Proxy.last_part_mesh(mesh).active_points())


def quality_colours(mesh):
    """{tet number: colour} by the smallest dihedral angle."""
    arrays = mesh.Proxy.arrays(mesh)
    limits = np.array([limit for limit, _ in QUALITY_STEPS[1:]])
    steps = np.searchsorted(limits, smallest_angles(arrays), side="right")
    return {number: QUALITY_STEPS[step][1] for number, step in zip(arrays["tet_numbers"].tolist(), steps.tolist())}


def worst_tets(mesh, count=10):
    """(number, smallest dihedral angle in degrees, centre) of the worst tets, worst first."""
    arrays = mesh.Proxy.arrays(mesh)
    angles = smallest_angles(arrays)
    rows = np.argsort(angles, kind="stable")[:count]
    centres = arrays["points"][arrays["tets"][rows]].mean(axis=1)
    return [(int(arrays["tet_numbers"][row]), float(angles[row]), tuple(centre))
            for row, centre in zip(rows, centres.tolist())]

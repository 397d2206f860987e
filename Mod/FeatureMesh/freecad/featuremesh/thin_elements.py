# SPDX-License-Identifier: GPL-3.0-or-later
"""What is to be said of small angles that the part does not force. Of those below 2 degrees the engine tells (src/update/thin_tets.h)."""

import numpy as np

from .formats import connectivity, entity_name, filling_of
from .messages import said
from .quality import dihedral_angle

_SMALL, _TOLD_BY_ENGINE = 10.0, 2.0   # degrees
_MANY = 0.1   # of all elements: those between the two sides of walls, and of these finer elements at one place mend few


def remarks(arrays, quality):
    """A message, or none, of a mesh's arrays and the quality of its report."""
    angle = quality["min_dihedral_unforced"]
    if not _TOLD_BY_ENGINE <= angle < _SMALL:
        return []
    kind, mids, _, _ = filling_of(arrays)
    elements = connectivity(arrays, kind, mids)
    angles = dihedral_angle(arrays["points"], elements)
    worst = elements[np.abs(angles - angle).argmin()]   # the part's own angles may force smaller ones elsewhere
    place = entity_name(*min(map(tuple, arrays["entities"][worst].tolist())))
    if quality["below_10"] > _MANY * len(elements):
        return [said("{share:number} % of the elements have angles below 10 degrees, the smallest is {angle:number} degrees, at {place:entities}: stresses are poor there. "
                     "Where walls are far thinner than the elements are long, ask for one or two elements across them (Across walls), or mesh a sheet as a shell; "
                     "else mesh finer.", share=_rounded(100.0 * quality["below_10"] / len(elements)), angle=_rounded(angle), place=[place])]
    if quality["forced_by_cad"]:
        return [said("The smallest angle that the part does not force is {angle:number} degrees, at {place:entities}: stresses are poor there. Mesh finer there, by a "
                     "local size or a refinement zone, or take details out that are much smaller than the edge length.", angle=_rounded(angle), place=[place])]
    return [said("{count:count} {count:element has an angle|elements have angles} below 10 degrees, the smallest is {angle:number} degrees, at {place:entities}: stresses are "
                 "poor there. Mesh finer there, by a local size or a refinement zone, or take details out that are much smaller than the edge length.",
                 count=int(quality["below_10"]), angle=_rounded(angle), place=[place])]


def _rounded(angle):
    return float("%.2g" % angle)

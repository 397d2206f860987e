# SPDX-License-Identifier: GPL-3.0-or-later
"""The refinement by error: a document object that asks for smaller elements where a result is off the most, and how small these are to be.

It is in the MeshRegionList of its mesh, beside zones and FEM's own refinements. Its places go with the part as a whole.
"""

from typing import NamedTuple

import FreeCAD
import numpy as np

from . import versions
from .proxies import GetsReady, add_missing

translate = FreeCAD.Qt.translate

_TYPE = "App::FeaturePython"   # of the object
# (type, name, group, default, read-only, tooltip)
PROPERTIES = [
    ("App::PropertyInteger", "Places", "Error", 0, True, "In how many places smaller elements are asked for"),
    ("App::PropertyLength", "SmallestSize", "Error", 0.0, True, "The smallest edge length that is asked for"),
    ("App::PropertyVectorList", "Centres", "Error", None, True, "The places, in the part's own frame"),
    ("App::PropertyFloatList", "Radii", "Error", None, True, "How far around them, mm"),
    ("App::PropertyFloatList", "Sizes", "Error", None, True, "Edge lengths there, mm"),
    ("App::PropertyBool", "Suppressed", "Error", False, False, "Leaves the refinement out"),
]
_HIDDEN = ("Centres", "Radii", "Sizes")
_WORTH_IT = 0.8          # of the present edge length; an update leaves edges alone that are to be a little shorter
_SHORTEST = 0.25         # of the present edge length, in one step: beside a corner the error tells too little of shorter ones
_MOST_TETS = 10          # times those that there are, in one step
_AIM = 0.8               # of the error that is asked for, as neighbours of places are of the size between
_HALVINGS = 60           # of the interval in which the answer is looked for
# Called with every refinement that was made or opened; the window's side adds its view there.
on_ready = []


class ErrorSizes(GetsReady):
    """Proxy of the object. Its class path is stored in documents and never changes."""

    Type = "Fem::FeatureMeshErrorSizes"

    def execute(self, obj):
        """The mesh reads it."""

    def _get_ready(self, obj):
        add_missing(obj, PROPERTIES, hidden=_HIDDEN)
        for hook in on_ready:
            hook(obj)


def is_error_sizes(obj):
    """Is this one of our refinements by error?"""
    return isinstance(getattr(obj, "Proxy", None), ErrorSizes)


def in_document(document):
    """All of the document."""
    return list(filter(is_error_sizes, document.findObjects(_TYPE)))


def add_balls(mesh, balls):
    """Asks for these, as `wanted` gives them, in the refinement by error of the mesh object, made where it has none of its own. Returns it."""
    obj = next((one for one in mesh.MeshRegionList if is_error_sizes(one) and _meshes_of(one) == [mesh]), None)
    if obj is None:
        obj = mesh.Document.addObject(_TYPE, "ErrorSizes")
        ErrorSizes(obj)
        obj.Label = translate("FeatureMesh", "Refinement by error")
        mesh.MeshRegionList = mesh.MeshRegionList + [obj]
    if obj.Suppressed:   # the mesh is without what it asked for
        obj.Centres, obj.Radii, obj.Sizes, obj.Suppressed = [], [], [], False
    back = versions.frame_of(versions.part_of(mesh)).inverse()
    obj.Centres = obj.Centres + [back.multVec(FreeCAD.Vector(*ball[:3])) for ball in balls.tolist()]
    obj.Radii, obj.Sizes = list(obj.Radii) + balls[:, 3].tolist(), list(obj.Sizes) + balls[:, 4].tolist()
    obj.Places, obj.SmallestSize = len(obj.Sizes), min(obj.Sizes)
    return obj


def _meshes_of(obj):
    """A copy of a mesh has the refinements of that."""
    return [mesh for mesh in dict.fromkeys(obj.InList) if obj in getattr(mesh, "MeshRegionList", ())]


def balls_of(obj, part):
    """What the object asks of the engine: (x, y, z, radius, size) in mm for each place, where the part is now."""
    place = versions.frame_of(part)
    return [(*place.multVec(centre), radius, size) for centre, radius, size in zip(obj.Centres, obj.Radii, obj.Sizes)]


class Wanted(NamedTuple):
    """What a smaller error asks for."""
    balls: np.ndarray   # (k,5): x, y, z, radius, size in mm
    tets: int           # about how many the mesh will have


def wanted(arrays, error_of_tets, accuracy):
    """The elements that bring the error, of which (m,) are the parts of the tets, down to `accuracy`, or ten times as many as there are.

    The squared error of a place goes with h^(2p), p being the order of the elements. Of all sizes h that leave the same error those with the fewest elements have
    the same C h^(2p+3) everywhere, where C h^(2p) is the squared error by volume (docs/design/accuracy.md).
    """
    order = 2 if len(arrays["tet_mids"]) else 1
    nodes, volume, squared, tets, length = _by_node(arrays, error_of_tets)
    urgency = np.maximum(squared / volume * length ** 3, np.finfo(float).tiny)

    def shares(limit):
        """Of the present edge lengths, by node."""
        share = np.clip((limit / urgency) ** (1 / (2 * order + 3)), _SHORTEST, 1)
        return np.where(share < _WORTH_IT, share, 1)

    def is_enough(share):
        return np.sum(squared * share ** (2 * order)) <= (_AIM * accuracy) ** 2 or np.sum(tets / share ** 3) > _MOST_TETS * tets.sum()

    low, high = np.log(urgency.min()) - 1, np.log(urgency.max()) + 1   # everything, and nothing
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if is_enough(shares(np.exp(middle))) else (low, middle)
    share = shares(np.exp(low))
    smaller = share < 1
    balls = np.column_stack([arrays["points"][nodes], length / 2, length * share])[smaller]
    return Wanted(balls, int(np.sum(tets / share ** 3)))


def _by_node(arrays, error_of_tets):
    """Of the nodes at tets' corners: their rows, and of the quarters of the tets around each the volume, the squared error, how many, and the mean edge length."""
    tets, points = arrays["tets"], arrays["points"]
    corners = points[tets]
    sides = [np.linalg.norm(corners[:, i] - corners[:, j], axis=1) for i in range(4) for j in range(i)]
    edges = corners[:, 1:] - corners[:, :1]
    volumes = np.abs(np.einsum("ti,ti->t", edges[:, 0], np.cross(edges[:, 1], edges[:, 2]))) / 6

    def gathered(of_tets):
        return np.bincount(tets.ravel(), np.repeat(of_tets / 4, 4), len(points))

    volume, count = gathered(volumes), gathered(np.ones(len(tets)))
    nodes = np.flatnonzero(volume)
    lengths = gathered(np.mean(sides, axis=0))
    return nodes, volume[nodes], gathered(np.square(error_of_tets))[nodes], count[nodes], lengths[nodes] / count[nodes]

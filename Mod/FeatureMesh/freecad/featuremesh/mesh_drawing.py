# SPDX-License-Identifier: GPL-3.0-or-later
"""Has a picture of a mesh, coloured by a measure of quality and perhaps cut open, drawn by a process of its own."""

import json

import numpy as np

from . import overlays, picture_process
from .errors import UserError
from .messages import said
from .quality import MEASURES

_FROM_ABOVE = np.array((-0.45, 0.75, -0.6))   # the direction that a part is looked at along
_BINS = 6


def draw(mesh, path, measure, limits=None, plane=None, is_filled=False):
    """Writes the picture, and returns the overlays.Overlay. Throws UserError."""
    overlay = overlays.quality(mesh, measure, limits)
    corners, colours = overlay.drawn(plane, is_filled)
    if not len(corners):
        raise UserError(said("the cut leaves nothing of {mesh:text}; its nodes are from {low:point} to {high:point}",
                             mesh=mesh.Label, low=tuple(overlay.points.min(axis=0)), high=tuple(overlay.points.max(axis=0))))
    kind, bounds = MEASURES[measure], np.linspace(*(limits or MEASURES[measure].limits), _BINS + 1)
    legend = [(kind.colours(np.array([(low + high) / 2]), limits)[0].tolist(), _range(kind, low, high, index))
              for index, (low, high) in enumerate(zip(bounds[:-1], bounds[1:]))]
    words = {"title": "%s: %s, from %s to %s" % (mesh.Label, kind.title, kind.in_words(overlay.values.min()), kind.in_words(overlay.values.max())),
             "legend": legend}
    picture_process.draw("mesh_picture.py", {"corners": corners, "colours": colours, "direction": _direction(plane),
                                             "words": json.dumps(words)}, path)
    return overlay


def _range(kind, low, high, index):
    """What one colour stands for; the first and the last have all beyond, too."""
    if index == 0:
        return "%s %.*f" % ("<" if high > low else ">", kind.digits, high)
    if index == _BINS - 1:
        return "%s %.*f" % (">" if high > low else "<", kind.digits, low)
    return "%.*f to %.*f" % (kind.digits, low, kind.digits, high)


def _direction(plane):
    """So that the cut is seen."""
    if plane is None:
        return _FROM_ABOVE
    normal = np.asarray(plane.normal) / np.linalg.norm(plane.normal)
    return _FROM_ABOVE - (_FROM_ABOVE @ normal) * normal - 0.9 * normal

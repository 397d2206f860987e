# SPDX-License-Identifier: GPL-3.0-or-later
"""Has the picture of a difference drawn by a process of its own."""

import json

import numpy

from . import picture_process, reading


def draw(old_part, new_part, changes, path):
    """Writes the picture. Throws UserError when no interpreter with VTK and Matplotlib can draw it."""
    arrays = {"changes": json.dumps(changes), **_packed("old", reading.outline_of(old_part)),
              **_packed("new", reading.outline_of(new_part))}
    picture_process.draw("difference_picture.py", arrays, path)


def _packed(name, side):
    packed = {}
    for kind, shape in (("faces", (0, 3, 3)), ("edges", (0, 3))):
        packed["%s_%s" % (name, kind)] = numpy.concatenate([numpy.zeros(shape), *side[kind]])
        packed["%s_%s_sizes" % (name, kind)] = numpy.array([len(part) for part in side[kind]], dtype=int)
    return packed

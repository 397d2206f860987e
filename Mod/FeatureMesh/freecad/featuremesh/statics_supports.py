# SPDX-License-Identifier: GPL-3.0-or-later
"""Which rigid motions the supports of a part leave free.

A linear elastic body resists everything but rigid motions, so the null space of its constrained stiffness matrix is known: the motions,
six for each body, that are nothing at held components and the same where bodies share a node.
"""

import FreeCAD
import numpy as np

from . import engine
from .formats import connectivity
from .messages import said

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
_MOVE = QT_TRANSLATE_NOOP("FeatureMesh", "move along {directions:messages}")
_TURN = QT_TRANSLATE_NOOP("FeatureMesh", "turn about {axes:messages}")
_BOTH = QT_TRANSLATE_NOOP("FeatureMesh", "{first:messages} and {last:messages}")
_AXES = "xyz"
_FREE = 1e-12          # of the largest eigenvalue: what is below is no resistance
_MOST_BODIES = 300     # beyond, a dense matrix of all their motions is too large
_STRAIGHT = 1e-6


def free_motions(arrays, held):
    """(by body the six numbers of each free motion, (bodies, 6, k); centre, scale).

    A motion moves a point x by t + w x (x - centre) / scale, with t the first three numbers and w the others.
    """
    points = arrays["points"]
    centre, scale = points.mean(axis=0), max(np.ptp(points, axis=0).max() / 2, 1e-300)
    bodies = engine.load().statics_bodies(arrays)
    count = int(bodies.max(initial=0)) + 1
    if count > _MOST_BODIES:
        return None, centre, scale
    nodes = connectivity(arrays, "tets", "tet_mids")
    owner = np.zeros(len(points), dtype=np.int64)
    owner[nodes] = bodies[:, None]
    elsewhere = owner[nodes] != bodies[:, None]   # corners at nodes of several bodies, of which one is the owner
    shared = np.unique(np.column_stack([nodes[elsewhere], np.broadcast_to(bodies[:, None], nodes.shape)[elsewhere]]), axis=0)
    gram = np.zeros((6 * count, 6 * count))
    for axis in range(3):
        rows = np.flatnonzero(held[:, axis])
        for body in np.unique(owner[rows]):
            _add(gram, [(int(body), 1.0)], _row(points[rows[owner[rows] == body]], centre, scale, axis))
    for node, other in shared.tolist():
        for axis in range(3):
            _add(gram, [(int(owner[node]), 1.0), (other, -1.0)], _row(points[[node]], centre, scale, axis))
    values, vectors = np.linalg.eigh(gram)
    free = vectors[:, values <= _FREE * max(values[-1], 1e-300)]
    return free.reshape(count, 6, -1), centre, scale


def held_by_faces(arrays, held):
    """(n,3) which of the held components are those of faces that are held as a whole, not of points and edges."""
    triangles, faces = connectivity(arrays, "triangles", "triangle_mids"), arrays["triangle_faces"]
    found = np.zeros_like(held)
    for axis in range(3):
        free = faces[~held[triangles, axis].all(axis=1)]
        found[triangles[~np.isin(faces, free)], axis] = True
    return found


def moved(arrays, motions, centre, scale):
    """(n,3) mm how the nodes move along the first of some free motions, a tenth of the part at most; turns are as small turns are."""
    bodies = engine.load().statics_bodies(arrays)
    of_node = np.zeros(len(arrays["points"]), dtype=np.int64)
    nodes = connectivity(arrays, "tets", "tet_mids")
    of_node[nodes] = bodies[:, None]
    motion = motions[of_node, :, 0]
    shift = motion[:, :3] + np.cross(motion[:, 3:], (arrays["points"] - centre) / scale)
    return shift * (0.2 * scale / max(np.linalg.norm(shift, axis=1).max(), 1e-300))


def in_words(motions):
    """What is free of the body that is so most, as a message, a sentence's part: "move along x and turn about z"; None when nothing is."""
    if motions is None or motions.shape[2] == 0:
        return None
    return _of_body(max(motions, key=np.linalg.norm))


def solids_as_free(arrays, motions):
    """The names of the solids of all bodies that are as free as that one."""
    how, bodies = in_words(motions), engine.load().statics_bodies(arrays)
    as_free = np.array([_of_body(own) == how for own in motions])
    return ["Solid%d" % (solid + 1) for solid in np.unique(arrays["tet_solids"][as_free[bodies]])]


def _of_body(own):
    shifts = own @ _null_space(own[3:])          # those without a turn
    turns = own[3:] if own[3:].size else np.zeros((3, 0))
    free = []
    if np.linalg.norm(shifts) > _STRAIGHT:
        free.append(said(_MOVE, directions=_directions(shifts[:3])))
    if np.linalg.norm(turns) > _STRAIGHT:
        free.append(said(_TURN, axes=_directions(turns)))
    return _both(*free) if free else None


def _row(points, centre, scale, axis):
    """(n,6) what each of the six motions gives at the points along the axis."""
    arm = (points - centre) / scale
    rows = np.zeros((len(points), 6))
    rows[:, axis] = 1
    after, before = (axis + 1) % 3, (axis + 2) % 3
    rows[:, 3 + after], rows[:, 3 + before] = arm[:, before], -arm[:, after]
    return rows


def _add(gram, parts, rows):
    product = rows.T @ rows
    for a, sign_a in parts:
        for b, sign_b in parts:
            gram[6 * a:6 * a + 6, 6 * b:6 * b + 6] += sign_a * sign_b * product


def _null_space(matrix):
    if not matrix.size:
        return np.eye(matrix.shape[1])
    _, values, rows = np.linalg.svd(matrix)
    return rows[(values > _STRAIGHT).sum():].T


def _both(first, last=None):
    return first if last is None else said(_BOTH, first=first, last=last)


def _directions(vectors):
    """The space of some vectors by its axes, "x and z", or by directions where it holds no axes."""
    left, values, _ = np.linalg.svd(vectors)
    space = left[:, :(values > _STRAIGHT).sum()]
    axes = [letter for letter, axis in zip(_AXES, np.eye(3)) if np.linalg.norm(space.T @ axis) > 1 - _STRAIGHT]
    if len(axes) == space.shape[1]:
        return _both(*filter(None, (", ".join(axes[:-1]), axes[-1])))
    return ", ".join("(%s)" % ", ".join("%.3g" % (value if abs(value) > _STRAIGHT else 0.0) for value in column) for column in space.T)

# SPDX-License-Identifier: GPL-3.0-or-later
"""The formats that meshes are written to, one per file: write(path, arrays, groups), with the mesh's arrays as PartMesh.arrays
gives them and groups as (name, kind, numbers)."""

import re
from itertools import chain, combinations, count

import numpy as np


def connectivity(arrays, elements, mids):
    """(k, nodes per element) indices of the nodes of segments, triangles or tets; corners first, then mid-side nodes 01, 12, 02, 03, 13, 23."""
    corners = arrays[elements]
    if not len(arrays[mids]):
        return corners
    return np.hstack([corners, arrays[mids].reshape(len(corners), -1)])


def flat_triangles(arrays):
    """(k,3) indices of the nodes of the triangles; a 6-node one is four, so that curved faces stay as round as the mesh has them."""
    triangles = connectivity(arrays, "triangles", "triangle_mids")
    return triangles[:, _FOUR].reshape(-1, 3) if triangles.shape[1] == 6 else triangles


_FOUR = ((0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5))   # corners 0 1 2, mid-side nodes 01, 12, 20

# Arrays of the elements that fill a part, the highest first: nodes, mid-side nodes, numbers, and the solid, face or edge of each.
FILLING = (("tets", "tet_mids", "tet_numbers", "tet_solids"), ("triangles", "triangle_mids", "triangle_numbers", "triangle_faces"),
           ("segments", "segment_mids", "segment_numbers", "segment_edges"))


def filling_of(arrays):
    """The names of the arrays of what fills the part of a mesh: tets, else triangles, else segments."""
    return next((names for names in FILLING if len(arrays[names[0]])), FILLING[0])


def fillings_of(arrays):
    """[(names as in FILLING, rows)] of all elements of the part: what fills it, the triangles beside tets, which are shells, and the segments
    beside both, which are beams."""
    kind = filling_of(arrays)[0]
    fillings = [(filling_of(arrays), np.arange(len(arrays[kind])))]
    taken = [arrays[kind]]
    for names in FILLING[FILLING.index(fillings[0][0]) + 1:]:
        rows = _rows_beside(arrays[names[0]], taken)
        if len(rows):
            fillings.append((names, rows))
        taken.append(arrays[names[0]])
    return fillings


def _rows_beside(elements, larger):
    """Rows of the elements that are no side of a larger one."""
    corners = elements.shape[1]
    sides = np.vstack([large[:, side] for large in larger for side in combinations(range(large.shape[1]), corners)] or [elements[:0]])
    _, keys = np.unique(np.sort(np.vstack([sides, elements]), axis=1), axis=0, return_inverse=True)
    keys = keys.reshape(-1)
    return np.flatnonzero(~np.isin(keys[len(sides):], keys[:len(sides)]))


def entity_name(dimension, index):
    """What FreeCAD calls an entity, such as Face12, which counts from 1."""
    return "%s%d" % (("Vertex", "Edge", "Face", "Solid")[dimension], index + 1)


def is_single_entity(name):
    """Is it the name of a group of one edge, face or solid, which every mesh has?"""
    return re.fullmatch(r"(Solid|Face|Edge)[0-9]+(_Nodes)?", name) is not None


def is_of_that_entity(group, arrays):
    """Has the group just the elements, or the nodes, of the edge, face or solid that it is called by? One of the user's may have that name, too."""
    name, kind, members = group
    if not is_single_entity(name):
        return False
    stem, number = re.match(r"([A-Za-z]+)([0-9]+)", name).groups()
    elements, mids, numbers, owners = FILLING[("Solid", "Face", "Edge").index(stem)]
    rows = arrays[owners] == int(number) - 1
    own = np.unique(arrays["node_numbers"][connectivity(arrays, elements, mids)[rows]]) if kind == "Node" else np.sort(arrays[numbers][rows])
    return np.array_equal(np.sort(members), own)


def not_taken(name, taken):
    """The name, or with a number behind it where it is taken."""
    choices = chain([name], ("%s_%d" % (name, number) for number in count(2)))
    return next(choice for choice in choices if choice not in taken)

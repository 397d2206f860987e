# SPDX-License-Identifier: GPL-3.0-or-later
"""The formats that meshes are written to, one per file: write(path, arrays, groups), with the mesh's arrays as PartMesh.arrays
gives them and groups as (name, kind, numbers)."""

import re

import numpy as np


def connectivity(arrays, elements, mids):
    """(k, nodes per element) indices of the nodes of segments, triangles or tets; corners first, then mid-side nodes 01, 12, 02, 03, 13, 23."""
    corners = arrays[elements]
    if not len(arrays[mids]):
        return corners
    return np.hstack([corners, arrays[mids].reshape(len(corners), -1)])


# Arrays of the elements that fill a part, the highest first: nodes, mid-side nodes, numbers, and the solid, face or edge of each.
FILLING = (("tets", "tet_mids", "tet_numbers", "tet_solids"), ("triangles", "triangle_mids", "triangle_numbers", "triangle_faces"),
           ("segments", "segment_mids", "segment_numbers", "segment_edges"))


def filling_of(arrays):
    """The names of the arrays of what fills the part of a mesh: tets, else triangles, else segments."""
    return next((names for names in FILLING if len(arrays[names[0]])), FILLING[0])


def is_single_entity(name):
    """Is it the name of a group of one edge, face or solid, which every mesh has?"""
    return re.fullmatch(r"(Solid|Face|Edge)[0-9]+(_Nodes)?", name) is not None

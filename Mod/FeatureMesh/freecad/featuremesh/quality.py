# SPDX-License-Identifier: GPL-3.0-or-later
"""Angles of tets as arrays, for pictures."""

import numpy as np

_OPPOSITE = ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))


def min_dihedral_angles(points, tets):
    """Smallest of the six dihedral angles of each tet, degrees, (m,)."""
    corners = points[tets]
    normals = []
    for a, b, c in _OPPOSITE:
        normal = np.cross(corners[:, b] - corners[:, a], corners[:, c] - corners[:, a])
        normals.append(normal / np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None])
    smallest = np.full(len(tets), 180.0)
    for i in range(4):
        for j in range(i + 1, 4):
            cosine = -np.einsum("ij,ij->i", normals[i], normals[j])
            smallest = np.minimum(smallest, np.degrees(np.arccos(np.clip(cosine, -1, 1))))
    return smallest

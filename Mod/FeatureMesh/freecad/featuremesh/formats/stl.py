# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface as triangles, binary STL; a 6-node triangle becomes four, so that curved faces stay as round as the mesh has them."""

import numpy as np

from . import connectivity

_FOUR = ((0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5))   # corners 0 1 2, mid-side nodes 3 4 5
_RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def write(path, arrays, groups):
    """STL knows neither nodes nor groups; its figures are single precision."""
    triangles = connectivity(arrays, "triangles", "triangle_mids")
    if triangles.shape[1] == 6:
        triangles = triangles[:, _FOUR].reshape(-1, 3)
    corners = arrays["points"][triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    records = np.zeros(len(triangles), dtype=_RECORD)
    records["normal"], records["corners"] = normals / np.where(lengths > 0, lengths, 1), corners
    with open(path, "wb") as stream:
        stream.write(b"FeatureMesh, lengths in mm".ljust(80))
        stream.write(np.uint32(len(triangles)).astype("<u4").tobytes())
        stream.write(records.tobytes())

# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface as triangles, binary STL."""

import numpy as np

from . import flat_triangles

_RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def write(path, arrays, groups):
    """STL knows neither nodes nor groups; its figures are single precision."""
    corners = arrays["points"][flat_triangles(arrays)]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    records = np.zeros(len(corners), dtype=_RECORD)
    records["normal"], records["corners"] = normals / np.where(lengths > 0, lengths, 1), corners
    with open(path, "wb") as stream:
        stream.write(b"FeatureMesh, lengths in mm".ljust(80))
        stream.write(np.uint32(len(corners)).astype("<u4").tobytes())
        stream.write(records.tobytes())

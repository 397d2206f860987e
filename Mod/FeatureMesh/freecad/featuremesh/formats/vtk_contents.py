# SPDX-License-Identifier: GPL-3.0-or-later
"""What both of VTK's formats say of a mesh."""

from dataclasses import dataclass

import numpy as np

from . import connectivity, is_of_that_entity, not_taken

_TYPES = ({2: 3, 3: 21}, {3: 5, 6: 22}, {4: 10, 10: 24})   # by dimension and nodes per element


@dataclass
class VtkContents:
    """Cells one kind after the other, segments first, and values on cells and points."""
    blocks: list          # (k, nodes per element) of each kind
    types: np.ndarray     # uint8, of each cell
    point_data: list      # (name, values)
    cell_data: list


def contents_of(arrays, groups):
    """Segments, triangles and tets; groups as 0/1 arrays on cells and points.

    The groups of single edges, faces and solids are one integer array `Entity` instead (with `Dimension`). No two arrays have one name.
    """
    blocks = [connectivity(arrays, "segments", "segment_mids"), connectivity(arrays, "triangles", "triangle_mids"),
              connectivity(arrays, "tets", "tet_mids")]
    counts = [len(block) for block in blocks]
    types = np.repeat(np.array([of.get(block.shape[1], 0) for of, block in zip(_TYPES, blocks)], dtype=np.uint8), counts)
    numbers = np.concatenate([arrays[kind + "_numbers"] for kind in ("segment", "triangle", "tet")])
    dimension = np.repeat(np.array([1, 2, 3], dtype=np.uint8), counts)
    entity = np.concatenate([arrays["segment_edges"], arrays["triangle_faces"], arrays["tet_solids"]]) + 1
    cell_data = [("Number", numbers), ("Dimension", dimension), ("Entity", entity.astype(np.int32))]
    point_data = [("Number", arrays["node_numbers"])]
    for name, kind, members in (group for group in groups if not is_of_that_entity(group, arrays)):
        target, known = (point_data, arrays["node_numbers"]) if kind == "Node" else (cell_data, numbers)
        target.append((not_taken(name, dict(target)), np.isin(known, members).astype(np.uint8)))
    return VtkContents(blocks, types, point_data, cell_data)

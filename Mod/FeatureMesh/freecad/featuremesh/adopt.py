# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the mesh of another maker (Gmsh, Netgen, any FEM mesh object) so that the engine can make it ours."""

import numpy as np

from . import engine
from .errors import UserError
from .messages import said
from .hand_over import SMESH_TET
from .job import MeshJob
from .quality import contents, mean_edge_length
from .reading import describe

_IN_WORDS = {"tets": said("tetrahedra"), "triangles": said("triangles"), "segments": said("segments")}


class AdoptJob(MeshJob):
    """As a MeshJob, from the arrays of a foreign mesh instead of an old mesh of ours."""

    def __init__(self, raw, options, arrays):
        super().__init__(raw, options, None, None, [])
        self.arrays = arrays

    def _mesh(self, progress):
        return engine.load().adopt_part(self.raw, self.options, self.arrays, progress)


def part_of(obj):
    """The part that a mesh object of FreeCAD's own was made of, or None."""
    part = getattr(obj, "Part", None) or getattr(obj, "Shape", None)
    return part if hasattr(part, "TypeId") else None


def arrays_of(obj):
    """The mesh of an FEM mesh object as the engine takes it (see PartMesh.arrays), CAD entities left blank. Throws UserError."""
    fem_mesh = obj.FemMesh
    tets = _elements(fem_mesh, fem_mesh.Volumes, obj, (4, 10), "tets")
    if not len(tets[0]):
        raise UserError(said("{object:text} has no tetrahedra; it has to be a volume mesh", object=describe(obj)))
    order = 2 if tets[1].shape[1] == 10 else 1
    triangles = _elements(fem_mesh, fem_mesh.Faces, obj, (3, 6), "triangles")
    segments = _elements(fem_mesh, fem_mesh.Edges, obj, (2, 3), "segments")
    corners = np.unique(tets[1][:, :4])
    mids = np.setdiff1d(tets[1][:, 4:], corners)
    used = np.concatenate([corners, mids])
    rank = dict(zip(used.tolist(), range(len(used))))
    nodes = fem_mesh.Nodes
    arrays = {
        "points": np.array([tuple(nodes[number]) for number in used.tolist()]),
        "entities": np.tile(np.array([3, -1], dtype=np.int32), (len(used), 1)),
        "parameters": np.zeros((len(used), 2)),
        "node_numbers": used.astype(np.int64),
        "counters": np.array([order, len(corners), max(nodes) + 1, 1 + max(
            int(numbers.max()) for numbers, _ in (tets, triangles, segments) if len(numbers))], dtype=np.int64),
    }
    for name, (numbers, rows), width, owner in (("segment", segments, 2, "segment_edges"), ("triangle", triangles, 3, "triangle_faces"),
                                                ("tet", tets, 4, "tet_solids")):
        known = np.array([[rank.get(number, -1) for number in row] for row in rows.tolist()], dtype=np.int32).reshape(-1, rows.shape[1])
        fits = (known >= 0).all(axis=1) & (known.shape[1] == (width if order == 1 else {2: 3, 3: 6, 4: 10}[width]))
        known = known[fits]
        arrays[name + "s"], arrays[name + "_numbers"] = known[:, :width], numbers[fits]
        arrays[name + "_mids"] = known[:, width:].reshape((-1,) if width == 2 else (-1, {3: 3, 4: 6}[width]))
        arrays[owner] = np.full(len(known), -1, dtype=np.int32)
    return arrays


def asked_size(obj):
    """The largest size (mm) that Gmsh's or Netgen's mesh object was given, None without one (Netgen's own default is 1000 mm)."""
    given = [getattr(obj, name, None) for name in ("CharacteristicLengthMax", "MaxSize")]
    lengths = [getattr(value, "Value", value) for value in given if value is not None]
    return next((length for length in lengths if 0 < length < 1000), None)


def asked_order(obj):
    """The order of the elements that Gmsh's or Netgen's mesh object was given, of another mesh that of its elements; 2 where nothing tells it."""
    if hasattr(obj, "SecondOrder"):   # Netgen's; its ElementOrder of FreeCAD 1.1 is a number that Netgen does not use for this
        return 2 if obj.SecondOrder else 1
    nodes = [obj.FemMesh.getElementNodes(number) for number in obj.FemMesh.Volumes[:1]] if obj is not None else []
    return 1 if getattr(obj, "ElementOrder", None) == "1st" or not hasattr(obj, "ElementOrder") and list(map(len, nodes)) == [4] else 2


def typical_size(arrays):
    """The edge length that most of the mesh's surface has (of its inside where it has no triangles), mm, rounded to three digits."""
    kind = "triangles" if len(arrays["triangles"]) else "tets"
    lengths, weights = mean_edge_length(arrays["points"], arrays[kind]), np.abs(contents(arrays["points"], arrays[kind]))
    return float("%.3g" % np.average(lengths, weights=weights if weights.sum() > 0 else None))


def _elements(fem_mesh, numbers, obj, counts, what):
    """(numbers, node numbers) of the elements, in our order of nodes."""
    rows = [fem_mesh.getElementNodes(number) for number in numbers]
    lengths = {len(row) for row in rows}
    if len(lengths) > 1 or not lengths <= set(counts):
        raise UserError(said("{object:text} has other elements than 4-node or 10-node tetrahedra ({kind:messages} with {counts:text} nodes); only "
                             "tetrahedra can be adopted",
                             object=describe(obj), kind=_IN_WORDS[what], counts=", ".join(map(str, sorted(lengths)))))
    if not rows:
        return np.empty(0, dtype=np.int64), np.empty((0, counts[0]), dtype=np.int64)
    table = np.array(rows, dtype=np.int64)
    if what == "tets":
        # SMESH's order swaps pairs of ours, so the same list leads back
        table = table[:, SMESH_TET[:table.shape[1]]]
    return np.array(numbers, dtype=np.int64), table

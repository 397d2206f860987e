# SPDX-License-Identifier: GPL-3.0-or-later
"""Gmsh as a peer: meshes a BREP file in a process of its own and measures the result."""
import sys
import tempfile
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).resolve().parents[2] / "Mod" / "FeatureMesh" / "freecad" / "featuremesh"))

from measured_process import run_measured  # noqa: E402
from quality import tet_quality  # noqa: E402

ALGORITHMS = {"gmsh-delaunay": "del3d", "gmsh-hxt": "hxt"}
TET, NODES_OF = 4, {1: 2, 2: 3, 4: 4, 15: 1}


def mesh_with_gmsh(name, brep, size, threads, limit_seconds=600):
    """What the whole process used (reading, meshing, writing), and the mesh: (Used, points, tets)."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "mesh.msh"
        command = ["gmsh", str(brep), "-3", "-algo", ALGORITHMS[name], "-clmin", str(size), "-clmax", str(size), "-nt", str(threads),
                   "-format", "msh22", "-bin", "-o", str(out), "-v", "1"]
        return run_measured(command, out, limit_seconds), *read_msh(out)


def read_msh(path):
    """Points (n,3) and tets (m,4) of a binary file in Gmsh's format 2.2. RuntimeError where it has no tet."""
    data = path.read_bytes()
    at = data.index(b"$Nodes\n") + len(b"$Nodes\n")
    end = data.index(b"\n", at)
    count = int(data[at:end])
    node = np.dtype([("number", "<i4"), ("point", "<f8", 3)])
    nodes = np.frombuffer(data, node, count, end + 1)
    row_of = np.zeros(int(nodes["number"].max()) + 1, dtype=np.int64)
    row_of[nodes["number"]] = np.arange(count)
    at = data.index(b"$Elements\n", end + 1 + count * node.itemsize) + len(b"$Elements\n")
    end = data.index(b"\n", at)
    left, at, tets = int(data[at:end]), end + 1, []
    while left:
        kind, block, tags = np.frombuffer(data, "<i4", 3, at)
        width = 1 + tags + NODES_OF[int(kind)]
        rows = np.frombuffer(data, "<i4", block * width, at + 12).reshape(block, width)
        if kind == TET:
            tets.append(rows[:, 1 + tags:])
        at += 12 + 4 * block * width
        left -= int(block)
    if not tets:
        raise RuntimeError("Gmsh made no tets")
    return nodes["point"], row_of[np.concatenate(tets)]


def quality_of(points, tets):
    """The figures that the engine's report has too."""
    smallest, largest, ratios = tet_quality(points, tets)
    return {"min_dihedral": float(smallest.min()), "max_dihedral": float(largest.max()), "mean_radius_ratio": float(ratios.mean()),
            "below_25": int((smallest < 25).sum())}

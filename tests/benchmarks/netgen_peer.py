# SPDX-License-Identifier: GPL-3.0-or-later
"""Netgen as a peer: meshes a STEP file in a process of its own. About fifteen times slower than Gmsh's HXT, so it is run on request."""
import sys
import tempfile
from pathlib import Path

import numpy as np

from measured_process import run_measured

PROGRAM = """
import sys
import numpy as np
try:
    from netgen.occ import OCCGeometry
    mesh = OCCGeometry(sys.argv[1]).GenerateMesh(maxh=float(sys.argv[2]))
except ImportError:
    from netgen.NgOCC import LoadOCCGeometry
    mesh = LoadOCCGeometry(sys.argv[1]).GenerateMesh(maxh=float(sys.argv[2]))
points = np.array([p.p for p in mesh.Points()])
tets = np.array([[v.nr - 1 for v in element.vertices] for element in mesh.Elements3D()])
np.savez(sys.argv[3], points=points, tets=tets)
"""


def mesh_with_netgen(step, size, limit_seconds=1800):
    """What the whole process used (reading, meshing, writing), and the mesh: (Used, points, tets)."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "mesh.npz"
        used = run_measured([sys.executable, "-c", PROGRAM, str(step), str(size), str(out)], out, limit_seconds)
        with np.load(out) as mesh:
            return used, mesh["points"], mesh["tets"]

# SPDX-License-Identifier: GPL-3.0-or-later
"""Netgen as a peer: meshes a STEP file in a process of its own. About fifteen times slower than Gmsh's HXT, so it is run on request."""
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

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
    """Wall seconds of the whole process (reading, meshing, writing) and the mesh: (seconds, points, tets)."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "mesh.npz"
        start = time.perf_counter()
        done = subprocess.run([sys.executable, "-c", PROGRAM, str(step), str(size), str(out)], cwd=folder, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=limit_seconds)
        seconds = time.perf_counter() - start
        if done.returncode or not out.is_file():
            raise RuntimeError(f"netgen failed: {done.stdout[-300:]}")
        with np.load(out) as mesh:
            return seconds, mesh["points"], mesh["tets"]

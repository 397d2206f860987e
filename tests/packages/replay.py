# SPDX-License-Identifier: GPL-3.0-or-later
"""Asks the engine on the Python path what an installed engine was asked, as mesh_example.py wrote it down; both must answer with the same nodes.

    python replay.py FILE

The very bytes of the part are the same here and there, whatever FreeCAD made them.
"""
import pickle
import sys

import featuremesh_engine as engine

with open(sys.argv[1], "rb") as file:
    (part, options, meshed), (edited, edited_options, updated) = pickle.load(file)
mesh, _ = engine.mesh_part(part, options)
assert mesh.arrays()["points"].tobytes() == meshed, "the mesh has other nodes"
updated_mesh, report = engine.update_part(mesh, edited, edited_options)
assert updated_mesh.arrays()["points"].tobytes() == updated, "the updated mesh has other nodes"
print("the nodes of mesh and update (%d) are those of the engine built from source" % len(updated_mesh.arrays()["points"]))

# SPDX-License-Identifier: GPL-3.0-or-later
"""Has FreeCAD's writer of CalculiX input number the reference nodes of rigid bodies beyond all nodes of the mesh.

FreeCAD (1.0 and 1.1) counts on from the number of nodes. The numbers of a mesh that was updated have gaps, so that its reference nodes would be nodes
of the part, which CalculiX then moves or refuses.
"""

from types import SimpleNamespace

from .wrapping import wrap


def install():
    """To be called once one of our meshes is there; further calls do nothing."""
    for module in ("write_constraint_rigidbody", "write_constraint_rigidbody_step"):
        wrap("femsolver.calculix." + module, None, "write_constraint", _of_rigid_body)


def _of_rigid_body(original, stream, entry, body, writer):
    """FreeCAD asks the writer's mesh for nothing but the number of its nodes."""
    largest = max(writer.mesh_object.FemMesh.Nodes)
    counted = SimpleNamespace(FemMesh=SimpleNamespace(NodeCount=largest))
    return original(stream, entry, body, SimpleNamespace(**{**vars(writer), "mesh_object": counted}))

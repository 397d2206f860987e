# SPDX-License-Identifier: GPL-3.0-or-later
"""Has FreeCAD's writer of CalculiX input take the group of the mesh that is an object's own.

FreeCAD (0.20 to 1.1) takes the first whose name begins with that of the object and _. So a support Fixed was given the nodes of a support, or of a mesh
group, Fixed_left.
"""

from . import analyses
from .wrapping import wrap


def install():
    """To be called once one of our meshes is there; further calls do nothing."""
    wrap("femmesh.meshtools", None, "get_femmesh_groupdata_sets_by_name", _of_object)


def _of_object(original, fem_mesh, entry, kind):
    obj = entry["Object"]
    if analyses.mesh_of_member(obj) is None:
        return original(fem_mesh, entry, kind)
    name = "%s_%ss" % (obj.Name, kind)   # Fixed_Nodes
    found = next((group for group in fem_mesh.Groups if fem_mesh.getGroupName(group) == name and fem_mesh.getGroupElementType(group) == kind), None)
    return () if found is None else fem_mesh.getGroupElements(found)

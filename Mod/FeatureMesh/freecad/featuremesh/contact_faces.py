# SPDX-License-Identifier: GPL-3.0-or-later
"""Gives FEM's tie and contact constraints (and pressures, in 1.1) the element faces of the part that they name, where two parts touch.

FreeCAD looks for the nodes of a face by their places. Where parts lie on one another it finds those of both, so that each side of the constraint would
be both parts. The mesh knows better: a part's nodes are its own, and the mesh has a group of those of each face. So what FreeCAD finds is reduced to the
elements whose corners on the face are in that group. This wraps the functions that FreeCAD's writer of CalculiX input asks.
"""

from .wrapping import wrap

_MODULE = "femmesh.meshtools"
_FUNCTIONS = ("get_contact_obj_faces", "get_tie_obj_faces")   # 0.20 and 1.0
_FUNCTION_OF_ONE = "get_ccx_subelements_by_references"         # 1.1: one reference at a time, those of pressures, too
_CORNERS = 3


def install():
    """To be called once one of our meshes is there; further calls do nothing."""
    for name in _FUNCTIONS:
        wrap(_MODULE, None, name, _of_both)
    wrap(_MODULE, None, _FUNCTION_OF_ONE, _of_one)


def of_face(fem_mesh, name, elements):
    """Those of [element number, number of its face] that are on the part that the face of that name belongs to; all where the mesh has no such group."""
    group = next((group for group in fem_mesh.Groups if fem_mesh.getGroupName(group) == name + "_Nodes"), None)
    if group is None:
        return elements
    nodes = set(fem_mesh.getGroupElements(group))
    return [pair for pair in elements if len(nodes.intersection(fem_mesh.getElementNodes(pair[0]))) >= _CORNERS]


def _of_both(original, fem_mesh, elements_table, nodes_table, member):
    sides = original(fem_mesh, elements_table, nodes_table, member)
    names = [sub for _, subs in member["Object"].References for sub in ((subs,) if isinstance(subs, str) else subs)]
    return [of_face(fem_mesh, name, side) for name, side in zip(names, sides)] if len(names) == len(sides) else sides


def _of_one(original, getter, pair):
    found = original(getter, pair)
    name = pair[1]
    return (found[0], of_face(getter.femmesh, name, found[1])) if name.startswith("Face") and len(found) == 2 else found

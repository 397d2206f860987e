# SPDX-License-Identifier: GPL-3.0-or-later
"""Gives FEM's tie and contact constraints, its fluxes of heat and section prints (and pressures, in 1.1), the element faces of the part that they name, where two parts touch.

FreeCAD looks for the nodes of a face by their places. Where parts lie on one another it finds those of both, so that each side of a tie would
be both parts. The mesh knows better: a part's nodes are its own, and the mesh has a group of those of each face. So what FreeCAD finds is reduced to the
elements whose corners on the face are in that group. This wraps the functions that FreeCAD's writer of CalculiX input asks.
"""

import itertools

from . import analyses, versions
from .messages import said
from .proxies import type_of
from .resolving import plain_pairs_of
from .wrapping import wrap

_MODULE = "femmesh.meshtools"
_FUNCTIONS = ("get_contact_obj_faces", "get_tie_obj_faces")   # 0.20 and 1.0
_FUNCTION_OF_ONE = "get_ccx_subelements_by_references"         # 1.1: one reference at a time, those of pressures, too
_CORNERS = 3
_TIE = "Fem::ConstraintTie"
_SHARE = 0.1   # of the size of the elements: as far as CalculiX at most ties without a tolerance, and as far as the elements of a curved face may be off it


def install():
    """To be called once one of our meshes is there; further calls do nothing."""
    for name in _FUNCTIONS:
        wrap(_MODULE, None, name, _of_both)
    wrap(_MODULE, None, _FUNCTION_OF_ONE, _of_one)
    wrap("femmesh.meshsetsgetter", "MeshSetsGetter", "get_constraints_heatflux_faces", _of_heat)
    wrap("femmesh.meshsetsgetter", "MeshSetsGetter", "get_constraints_sectionprint_faces", _of_print)


def of_face(fem_mesh, name, elements):
    """Those of [element number, number of its face] that are on the part that the face of that name belongs to; all where the mesh has no such group."""
    group = next((group for group in fem_mesh.Groups if fem_mesh.getGroupName(group) == name + "_Nodes"), None)
    if group is None:
        return elements
    nodes = set(fem_mesh.getGroupElements(group))
    return [pair for pair in elements if len(nodes.intersection(fem_mesh.getElementNodes(pair[0]))) >= _CORNERS]


def out_of_reach(members, resolver, size):
    """That a tie ties nothing, since its faces are farther apart than its tolerance, as a message; None where there is none. `size` (mm) is that of the elements."""
    for tie in members:
        if type_of(tie) != _TIE or getattr(tie, "CyclicSymmetry", False):   # the sectors of which are apart
            continue
        *dependent, to = [resolver.names(*pair) or [] for pair in plain_pairs_of(tie)] or [[]]
        faces = [[(name, resolver.part.Shape.getElement(name)) for name in names] for names in (itertools.chain(*dependent), to)]
        gap, name, other = min(((one.distToShape(other)[0], name, of_other) for (name, one), (of_other, other) in itertools.product(*faces)), default=(0, "", ""))
        is_curved = any(face.findPlane() is None for _, face in itertools.chain(*faces))
        if gap > (tie.Tolerance.Value or _SHARE * size) + is_curved * _SHARE * size:
            return said("{tie:text} ties nothing: {faces:entities} are {gap:length} apart, and its tolerance is {tolerance:length}. Give it a tolerance that is larger "
                        "than the gap", tie=tie.Label, faces=[name, other], gap=gap, tolerance=tie.Tolerance.Value)
    return None


def _own(fem_mesh, member, pairs, elements):
    """The same for each (object, name) of a member; what is not on the meshed part is found by its place alone."""
    mesh = analyses.mesh_of_member(member)
    return [of_face(fem_mesh, name, found) if mesh is not None and obj == versions.part_of(mesh) else found for (obj, name), found in zip(pairs, elements)]


def _of_both(original, fem_mesh, elements_table, nodes_table, entry):
    sides, pairs = original(fem_mesh, elements_table, nodes_table, entry), plain_pairs_of(entry["Object"])
    return _own(fem_mesh, entry["Object"], pairs, sides) if len(pairs) == len(sides) else sides


def _of_one(original, getter, pair):
    found = original(getter, pair)
    source = analyses.source_of(getter.mesh_object)
    is_own = source is not None and pair[0] == versions.part_of(source) and pair[1].startswith("Face") and len(found) == 2
    return (found[0], of_face(getter.femmesh, pair[1], found[1])) if is_own else found


def _of_heat(original, getter):
    """In 1.1 it asks for one reference at a time."""
    original(getter)
    for entry in getter.member.cons_heatflux:
        table, pairs = entry.get("HeatFluxFaceTable", ()), [pair for pair in plain_pairs_of(entry["Object"]) if pair[1].startswith("Face")]
        if len(table) == len(pairs):
            found = _own(getter.femmesh, entry["Object"], pairs, [elements for _, elements in table])
            entry["HeatFluxFaceTable"] = [(place, elements) for (place, _), elements in zip(table, found)]


def _of_print(original, getter):
    original(getter)
    for entry in getter.member.cons_sectionprint:
        if "SectionPrintFaces" in entry:
            pairs = plain_pairs_of(entry["Object"])[-1:]   # FreeCAD prints one
            entry["SectionPrintFaces"], = _own(getter.femmesh, entry["Object"], pairs, [entry["SectionPrintFaces"]])

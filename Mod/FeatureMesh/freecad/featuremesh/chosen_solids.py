# SPDX-License-Identifier: GPL-3.0-or-later
"""Gives FreeCAD's writer of CalculiX input the elements of loads on chosen solids (centrifugal ones, in 1.1 body heat sources, too) from the mesh's groups.

FreeCAD asks for the distance of every node from the solid, which takes 12 s for 2500 elements.
"""

import importlib

from . import analyses, versions
from .wrapping import wrap

_MODULE = "femmesh.meshtools"
_FUNCTION_OF_ONE = "get_ccx_elements_by_references"   # since 1.1: one reference at a time


def install():
    """To be called once one of our meshes is there; further calls do nothing."""
    if hasattr(importlib.import_module(_MODULE), _FUNCTION_OF_ONE):
        wrap(_MODULE, None, _FUNCTION_OF_ONE, _of_one)
    else:
        wrap("femmesh.meshsetsgetter", "MeshSetsGetter", "get_constraints_centrif_elements", _of_centrifugal)


def _elements_of(getter, obj, name):
    """None where that is no solid of the meshed part, or the mesh has no group of it."""
    source = analyses.source_of(getter.mesh_object)
    if source is None or obj != versions.part_of(source) or not name.startswith("Solid"):
        return None
    fem_mesh = getter.femmesh
    group = next((group for group in fem_mesh.Groups if fem_mesh.getGroupName(group) == name), None)
    return None if group is None else list(fem_mesh.getGroupElements(group))


def _of_one(original, getter, pair):
    obj, name = pair
    found = _elements_of(getter, obj, name)
    return original(getter, pair) if found is None else ((obj, (name,)), found)


def _of_centrifugal(original, getter):
    loads = getter.member.cons_centrif
    found = [[_elements_of(getter, obj, name) for obj, names in load["Object"].References for name in names] for load in loads]
    if not all(found) or any(None in elements for elements in found):
        original(getter)
        return
    for load, elements in zip(loads, found):
        load["FEMElements"] = sum(elements, [])

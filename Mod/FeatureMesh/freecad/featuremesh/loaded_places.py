# SPDX-License-Identifier: GPL-3.0-or-later
"""Gives FreeCAD's writer of CalculiX input the triangles and nodes of the faces, edges and vertices that a force is on, the sides of elements that a pressure
is on, and the shells and beams that a thickness, a section or a material is for, as the mesh knows them.

FreeCAD looks for them by their places. Where two parts touch it finds those of both: a force on a face on which another part lies became larger by that
part's share, one on an edge ended in an error of Python, one on a vertex was left out.
"""

import importlib

from . import analyses, versions
from .hand_over import EntityGroups
from .resolving import Resolver, plain_pairs_of
from .wrapping import wrap

_SIDES = {1: (0, 1, 2), 2: (0, 1, 3), 3: (0, 2, 3), 4: (1, 2, 3)}   # corners of a tet's sides, as FreeCAD counts both


def install():
    """To be called once one of our meshes is there; further calls do nothing."""
    for kind in ("face", "edge", "vertex"):
        wrap("femmesh.meshtools", None, "get_force_obj_%s_nodeload_table" % kind, _of_force)
    wrap("femmesh.meshtools", None, "get_pressure_obj_faces", _of_pressure)
    wrap("femmesh.meshtools", None, "get_femelement_sets", _of_sets)


def _of_force(original, fem_mesh, *rest):
    force, mesh = rest[-1], analyses.mesh_of_member(rest[-1])
    return original(fem_mesh if mesh is None else _Asked(fem_mesh, mesh, force), *rest)


def _of_pressure(original, fem_mesh, elements_table, nodes_table, entry):
    """FreeCAD (0.20, 1.0) takes each side whose nodes are on the faces, though not on one and the same: also the sides between two faces that are one element apart."""
    found, mesh = original(fem_mesh, elements_table, nodes_table, entry), analyses.mesh_of_member(entry["Object"])
    if mesh is None or not fem_mesh.VolumeCount:
        return found
    names, foreign = Resolver(versions.part_of(mesh)).of_object(entry["Object"])
    entities = EntityGroups(mesh.Proxy.arrays(mesh))
    triangles = {frozenset(fem_mesh.getElementNodes(number)[:3]) for name in names for number in entities.elements(name).tolist()}
    return found if foreign else [[element, side] for element, side in found
                                  if frozenset(elements_table[element][corner] for corner in _SIDES[side]) in triangles]


def _of_sets(original, fem_mesh, table, entries, *rest):
    """FreeCAD takes each shell or beam whose nodes are on what is named, though not on one face or edge: also those between two that are one element apart."""
    known = [_elements_of(entry["Object"], table) for entry in entries]
    if not entries or None in known:
        return original(fem_mesh, table, entries, *rest)
    meshtools = importlib.import_module("femmesh.meshtools")
    others = sorted(set(table).difference(*known))   # for what names nothing
    for index, (entry, found) in enumerate(zip(entries, known)):
        entry["ShortName"] = meshtools.get_elset_short_name(entry["Object"], index)
        entry["FEMElements"] = sorted(found) if entry["Object"].References else others
    return meshtools.femelements_count_ok(len(table), sum(len(entry["FEMElements"]) for entry in entries))


def _elements_of(obj, table):
    """Which elements of the table are on what an object of ours refers to; None where that is not for us to say, as of solids."""
    mesh = analyses.mesh_of_member(obj)
    names, foreign = Resolver(versions.part_of(mesh)).of_object(obj) if mesh is not None else ([], True)
    if foreign or any(not name.startswith(("Face", "Edge")) for name in names):
        return None
    entities = EntityGroups(mesh.Proxy.arrays(mesh))
    return {number for name in names for number in entities.elements(name).tolist() if number in table}


class _Asked:
    """A FemMesh that is asked once for each reference of an object, in their order, what lies there; for all else it is the one of the mesh."""

    def __init__(self, fem_mesh, mesh, member):
        resolver = Resolver(versions.part_of(mesh))
        self._fem_mesh, self._entities = fem_mesh, EntityGroups(mesh.Proxy.arrays(mesh))
        self._names = iter([resolver.names(obj, sub) for obj, sub in plain_pairs_of(member)])

    def __getattr__(self, name):
        return getattr(self._fem_mesh, name)

    def getFacesByFace(self, face):
        return self._numbers(self._entities.elements, self._fem_mesh.getFacesByFace, face)

    def getNodesByFace(self, face):
        return self._numbers(self._entities.nodes, self._fem_mesh.getNodesByFace, face)

    def getNodesByEdge(self, edge):
        return self._numbers(self._entities.nodes, self._fem_mesh.getNodesByEdge, edge)

    def getNodesByVertex(self, vertex):
        return self._numbers(self._entities.nodes, self._fem_mesh.getNodesByVertex, vertex)

    def _numbers(self, numbers_of, by_place, shape):
        """What is not on the part is found by its place alone. FreeCAD 0.20 asks once more to tell that the chords of a curved edge are shorter than that, and fails at
        whatever it gets."""
        names = next(self._names, ())
        return by_place(shape) if names is None else sorted({number for name in names for number in numbers_of(name).tolist()})

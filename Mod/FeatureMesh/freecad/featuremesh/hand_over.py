# SPDX-License-Identifier: GPL-3.0-or-later
"""Hands an engine mesh over to FreeCAD, with its numbers and groups.

A mesh whose numbers have no gaps (a first one, a result's) goes through a file of VTK's, which FreeCAD reads up to twice as fast as it takes elements
one by one; a large one does not while there is a window, which would wait for the whole file. Its readers close gaps, so an updated mesh is handed over
element by element. FreeCAD closes gaps when it opens a document, too; there an updated mesh is built again.
"""

import functools
import os
import re
import tempfile
from collections import deque

import Fem
import FreeCAD
import numpy as np

from . import analyses, versions
from .formats import FILLING, connectivity, entity_name, is_single_entity, not_taken, vtk
from .given_mesh import empty
from .materials import material_groups
from .messages import said
from .reading import has_shape
from .resolving import Resolver
from .waiting import let_the_window_live

# SMESH wants tets oriented the other way round than Abaqus and VTK; the corners in the order its UNV reader gives them.
SMESH_TET = [0, 2, 1, 3, 6, 5, 4, 7, 9, 8]
_SAME_PLACE = 1e-6   # of the part's diagonal
_KINDS = {"Solid": "Volume", "Face": "Face", "Edge": "Edge", "Vertex": "Node"}
_CHUNK = 20000   # rows between two looks at the window
_FEW_GROUPS = 400   # FreeCAD looks through all elements for each; with more than these that costs more than reading a file saves
_LARGE = 100000      # elements; in so many FreeCAD looks for the surface for a quarter of a second
_LONG_RUN = 6        # elements with consecutive numbers; of shorter runs each is told its number
# By FreeCAD's kind, in the order in which a first mesh numbers them.
_ARRAYS = {"Face": FILLING[1], "Volume": FILLING[0], "Edge": FILLING[2]}
NO_SEGMENTS = {"segments": np.zeros((0, 2), np.int32), "segment_mids": np.zeros(0, np.int32), "segment_edges": np.zeros(0, np.int32),
               "segment_numbers": np.zeros(0, np.int64)}
NO_TRIANGLES = {"triangles": np.zeros((0, 3), np.int32), "triangle_mids": np.zeros((0, 3), np.int32), "triangle_faces": np.zeros(0, np.int32),
                "triangle_numbers": np.zeros(0, np.int64)}


def skin(obj, arrays):
    """A FemMesh of the triangles alone, for the view of an object that is given a large mesh; None where FreeCAD may look for the surface itself, since
    the mesh is small, or has to draw what is inside, too."""
    if getattr(getattr(obj, "ViewObject", None), "ShowInner", True) or len(arrays["tets"]) < _LARGE:
        return None
    mesh, nodes = empty(), connectivity(arrays, "triangles", "triangle_mids")
    used, numbers = np.unique(nodes), arrays["node_numbers"]
    _for_each(mesh.addNode, *arrays["points"][used].T, numbers[used])
    _for_each(mesh.addFace, numbers[nodes], arrays["triangle_numbers"])
    return mesh


def has_gaps(arrays):
    """Are there numbers between 1 and the largest that no node, or no element, has?"""
    elements = _element_numbers(arrays)
    nodes = arrays["node_numbers"]
    return bool(len(nodes) and nodes.max() != len(nodes) or len(elements) and elements.max() != len(elements))


def build(arrays, groups):
    """The Fem.FemMesh with these arrays, numbers and groups (name, kind, numbers)."""
    window_would_wait = FreeCAD.GuiUp and len(arrays["tets"]) >= _LARGE
    mesh = _read_back(arrays) if _is_counted(arrays) and len(groups) <= _FEW_GROUPS and not window_would_wait else None
    if mesh is None:
        return _Building(arrays, groups).mesh
    _add_groups(mesh, groups)
    return mesh


def _is_counted(arrays):
    """Are nodes and elements numbered from 1 in the order of the arrays?"""
    return all(np.array_equal(numbers, np.arange(1, len(numbers) + 1)) for numbers in (arrays["node_numbers"], _element_numbers(arrays)))


def _read_back(arrays):
    """The mesh without groups by a file, from which FreeCAD 0.20 reads no segments; None where it cannot be written."""
    tets = connectivity(arrays, "tets", "tet_mids")
    try:
        if not _reader_turns_tets():
            tets = _smesh_tets(tets)
        mesh = _read({**arrays, "tets": tets[:, :4], "tet_mids": tets[:, 4:], **NO_SEGMENTS})
    except OSError:
        return None
    _for_each(mesh.addEdge, arrays["node_numbers"][connectivity(arrays, "segments", "segment_mids")], arrays["segment_numbers"])
    return mesh


def _read(arrays):
    with tempfile.TemporaryDirectory(prefix="featuremesh-") as folder:
        path = os.path.join(folder, "mesh.vtk")
        vtk.write(path, arrays, [])
        mesh = empty()
        mesh.read(path)
        return mesh


@functools.cache
def _reader_turns_tets():
    """Does FreeCAD's reader of VTK's files turn tets to SMESH's orientation? That of 0.20 does not, that of 1.1 does."""
    one = {"points": np.eye(4, 3), "node_numbers": np.arange(1, 5), "tets": np.array([[0, 1, 2, 3]]), "tet_mids": np.zeros((0, 6), np.int32),
           "tet_solids": np.zeros(1, np.int32), "tet_numbers": np.array([1])}
    return _read({**one, **NO_SEGMENTS, **NO_TRIANGLES}).getElementNodes(1) != (1, 2, 3, 4)


class _Building:
    """A FemMesh made node by node and element by element, each group as soon as all its members are there, because FreeCAD looks through all that is
    there for each group: nodes on edges and faces, nodes inside, then elements in the order of their numbers."""

    def __init__(self, arrays, groups):
        self.mesh, self._largest = empty(), 0
        self._add_nodes(arrays, [group for group in groups if group[1] == "Node"])
        self._add_elements(arrays, [group for group in groups if group[1] != "Node"])

    def _add_nodes(self, arrays, groups):
        numbers, is_inside = arrays["node_numbers"], arrays["entities"][:, 0] == 3
        inside = np.zeros(int(numbers.max(initial=0)) + 1, dtype=bool)
        inside[numbers[is_inside]] = True
        for which in (False, True):
            rows = np.flatnonzero(is_inside == which)
            _for_each(self.mesh.addNode, *arrays["points"][rows].T, numbers[rows])
            _add_groups(self.mesh, [group for group in groups if inside[group[2]].any() == which])

    def _add_elements(self, arrays, groups):
        adds = {"Edge": self.mesh.addEdge, "Face": self.mesh.addFace, "Volume": self.mesh.addVolume}
        last = [int(np.max(members)) for _, _, members in groups]
        done = 0
        for kind, rows in _by_number(arrays):
            elements, mids, own, _ = _ARRAYS[kind]
            nodes, numbers = arrays["node_numbers"][connectivity(arrays, elements, mids)[rows]], arrays[own][rows]
            self._add_in_order(adds[kind], _smesh_tets(nodes) if kind == "Volume" else nodes, numbers, may_count=_counts_on() and not len(arrays[mids]))
            _add_groups(self.mesh, [group for group, number in zip(groups, last) if done < number <= numbers[-1]])
            done = numbers[-1]

    def _add_in_order(self, add, nodes, numbers, may_count):
        """Adds elements whose numbers rise. With `may_count`, where they follow one another, FreeCAD counts by itself, which takes half the time."""
        for start in range(0, len(numbers), _CHUNK):
            rows, known = nodes[start:start + _CHUNK], numbers[start:start + _CHUNK]
            firsts = np.flatnonzero(np.diff(known, prepend=-1) != 1)
            if may_count and known[0] > self._largest and len(firsts) * _LONG_RUN <= len(known):
                for first, end in zip(firsts, [*firsts[1:], len(known)]):
                    add(rows[first].tolist(), int(known[first]))
                    deque(map(add, *rows[first + 1:end].T.tolist()), maxlen=0)
                let_the_window_live()
            else:
                _for_each(add, rows, known)
            self._largest = max(self._largest, int(known[-1]))


def _by_number(arrays):
    """(kind, rows of its arrays) of all elements in the order of their numbers, as long as one kind goes."""
    numbers = _element_numbers(arrays)
    counts = [len(arrays[own]) for _, _, own, _ in _ARRAYS.values()]
    kinds, rows = np.repeat(np.arange(len(counts)), counts), np.concatenate([np.arange(count) for count in counts])
    order = np.argsort(numbers, kind="stable")
    for part in np.split(order, np.flatnonzero(np.diff(kinds[order])) + 1):
        if len(part):
            yield list(_ARRAYS)[kinds[part[0]]], rows[part]


@functools.cache
def _counts_on():
    """Does this FreeCAD give an element without a number the one after the largest?"""
    mesh = Fem.FemMesh()
    nodes = [mesh.addNode(*place) for place in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))]
    mesh.addVolume(nodes, 7)
    return [mesh.addVolume(*nodes) for _ in range(2)] == [8, 9]


def _smesh_tets(nodes):
    return nodes[:, SMESH_TET[:nodes.shape[1]]]


def _add_groups(mesh, groups):
    for name, kind, members in groups:
        mesh.addGroupElements(mesh.addGroup(name, kind), np.asarray(members).tolist())


def _for_each(function, *columns):
    """Calls the function with each row of the arrays, without a Python loop's cost and with the lists of few rows at a time."""
    for start in range(0, len(columns[0]), _CHUNK):
        deque(map(function, *(column[start:start + _CHUNK].tolist() for column in columns)), maxlen=0)
        let_the_window_live()


def reopened(fem_mesh, arrays, groups_anew):
    """The mesh as it was saved, from what FreeCAD made of it when it opened the document (numbers without gaps), or where FreeCAD did not save all of it,
    or found no room to read all of it, from the arrays and `groups_anew()`. None when nothing has to be done.
    """
    if not has_as_many(fem_mesh, arrays):
        return build(arrays, groups_anew())
    if not has_gaps(arrays):
        return None
    elements = _element_numbers(arrays)
    nodes, elements = np.sort(arrays["node_numbers"]), np.sort(elements)
    groups = []
    for group in fem_mesh.Groups:
        kind = fem_mesh.getGroupElementType(group)
        ranks = np.array(fem_mesh.getGroupElements(group), dtype=np.int64) - 1
        known = nodes if kind == "Node" else elements
        if len(ranks) and ranks.max() >= len(known):
            return None
        groups.append((fem_mesh.getGroupName(group), kind, known[ranks]))
    return build(arrays, groups)


def has_as_many(fem_mesh, arrays):
    """Has a FemMesh as many nodes and elements as the arrays, whose it is then?"""
    counts = fem_mesh.NodeCount, fem_mesh.FaceCount, fem_mesh.VolumeCount
    return counts == tuple(len(arrays[name]) for name in ("node_numbers", "triangles", "tets"))


def lies_on(arrays, shape):
    """Are most nodes of vertices where these are, as of no part that was moved since? Some may be elsewhere, where details are ignored."""
    nodes, vertices = np.flatnonzero(arrays["entities"][:, 0] == 0), shape.Vertexes
    near = _SAME_PLACE * shape.BoundBox.DiagonalLength
    far = [np.linalg.norm(arrays["points"][node] - np.array(vertices[number].Point)) > near
           for node, number in zip(nodes, arrays["entities"][nodes, 1]) if number < len(vertices)]
    return 2 * sum(far) <= len(far)


def groups_of(arrays, owners_of_tets, mesh, raw=None, analysis_of=None):
    """The groups that the mesh object `mesh` has in FreeCAD: per group object and per member of its analysis, or of that of the object
    `analysis_of`, and with its property AllGroups everything_in_groups; none where its part is gone. `raw` is the part as it was read for the mesh."""
    part = versions.part_of(mesh)
    if part is None or not has_shape(part):
        return []
    resolver = Resolver(part, raw)
    entities = EntityGroups(arrays)
    groups = everything_in_groups(entities, owners_of_tets) if mesh.AllGroups else []
    return [group for group in _with_those_of_objects(groups, mesh, analysis_of or mesh, resolver, entities) if len(group[2])]


def everything_in_groups(entities, owners_of_tets):
    """The groups of every CAD entity and every feature. FreeCAD itself needs none of them, and would take as long for them as for the elements."""
    return entities.of_all_entities() + [("Feature_" + name, "Volume", numbers) for name, numbers in owners_of_tets() if len(numbers)]


def analysis_groups(mesh, resolver, entities):
    """The groups by which the solver's writer finds the nodes of constraints, those of each face and the elements of each solid that these refer to (see
    contact_faces and chosen_solids), and the elements of materials."""
    groups, faces, solids = [], {}, {}
    members = [member for analysis in analyses.directly_holding(mesh) for member in analysis.Group]
    materials = [member for member in members if is_material(member)]
    for member in members:
        if member in materials or not hasattr(member, "References"):
            continue
        names, foreign = resolver.of_object(member)
        if foreign or not names or resolver.without_trace(member):
            continue   # not all of it is on the part
        groups.append((member.Name + "_Nodes", "Node", _union([entities.nodes(name) for name in names])))
        if member.isDerivedFrom("Fem::ConstraintPressure") and not entities.solids():   # of shells FreeCAD 0.20 takes them from nowhere else
            groups.append((member.Name + "_Faces", "Face", _union([entities.elements(name) for name in names if name.startswith("Face")])))
        faces.update((name + "_Nodes", entities.nodes(name)) for name in names if name.startswith("Face"))
        solids.update((name, entities.elements(name)) for name in names if name.startswith("Solid"))
    used = [material for material in materials if not getattr(material, "Suppressed", False)]
    if len(used) > 1:
        groups += material_groups(used, resolver, entities)
    return groups + [(name, "Node", nodes) for name, nodes in faces.items()] + [(name, "Volume", elements) for name, elements in solids.items()]


def renew_groups(mesh, resolver, arrays):
    """Makes the groups of mesh group objects and of analysis members in the mesh what they are to be. Those that are so already stay: FreeCAD takes
    milliseconds for one."""
    source = analyses.source_of(mesh)
    fem_mesh, entities, state = mesh.FemMesh, EntityGroups(arrays), source.StateName
    groups = _with_those_of_objects([], source, mesh, resolver, entities)
    if source.StateName != state:   # while the engine was asked what is meant another mesh came, with its own groups
        return
    missing = {name: (kind, members) for name, kind, members in groups if len(members)}
    for group in fem_mesh.Groups:
        name = fem_mesh.getGroupName(group)
        if source.AllGroups and (is_single_entity(name) or name.startswith("Feature_")) or name in missing and _has_members(fem_mesh, group, *missing[name]):
            missing.pop(name, None)
        else:
            fem_mesh.removeGroup(group)   # that of an object, which may be gone or have another name
    _add_groups(fem_mesh, [(name, *rest) for name, rest in missing.items()])


def _has_members(fem_mesh, group, kind, members):
    if fem_mesh.getGroupElementType(group) != kind:
        return False
    return np.array_equal(np.sort(np.array(fem_mesh.getGroupElements(group), dtype=np.int64)), np.sort(members))


class EntityGroups:
    """Node and element numbers by CAD entity name ("Face3")."""

    def __init__(self, arrays):
        self._arrays = arrays
        self._elements = {}        # name -> element numbers
        self._rows = {}            # name -> rows of its elements in _connectivity
        self._connectivity = {}    # kind -> nodes of all elements of that kind
        self._nodes = {}           # name -> node numbers, filled when asked for
        for kind in ("Edge", "Face", "Solid"):
            elements, mids, numbers, owners = _ARRAYS[_KINDS[kind]]
            self._collect(kind, connectivity(arrays, elements, mids), arrays[owners], arrays[numbers])
        numbers = arrays["node_numbers"]
        for node in np.flatnonzero(arrays["entities"][:, 0] == 0):   # on vertices
            self._nodes[entity_name(*arrays["entities"][node])] = numbers[[node]]
        self._shared = self._share_nodes(arrays["shared_nodes"])

    def elements(self, name):
        """Numbers of the elements of that entity (empty for a vertex or an unknown name)."""
        return self._elements.get(name, np.empty(0, dtype=np.int64))

    def nodes(self, name):
        """Numbers of the nodes on that entity, mid-side ones and those on its border included."""
        if name not in self._nodes and name in self._elements:
            rows, kind = self._rows[name], re.sub(r"\d+$", "", name)
            used = np.unique(self._connectivity[kind][rows])
            self._nodes[name] = self._arrays["node_numbers"][used]
        return self._nodes.get(name, np.empty(0, dtype=np.int64))

    def names_without_elements(self):
        """Of the edges and faces that share all their nodes with others."""
        return {name for name in self._shared if name not in self._elements and not name.startswith("Vertex")}

    def all_elements(self):
        """Numbers of all tets."""
        return self._arrays["tet_numbers"]

    def solids(self):
        """Names of the solids that have tets."""
        return self.of_kind("Solid")

    def of_kind(self, kind):
        """Names of the solids, faces or edges that have elements."""
        return [name for name in self._elements if name.startswith(kind)]

    def points_inside(self, name, count):
        """At most `count` points inside that solid, spread over it: centroids of tets, (n,3) mm."""
        rows = self._rows[name]
        chosen = self._arrays["tets"][rows[np.linspace(0, len(rows) - 1, min(count, len(rows))).astype(int)]]
        return self._arrays["points"][chosen].mean(axis=1)

    def of_all_entities(self):
        """(name, kind, numbers) for every edge, face and solid, and their nodes where constraints may sit. An only solid has none: they would hold
        all that there is, at a fifth of what the hand-over costs."""
        groups = []
        only_solid = self.solids() if len(self.solids()) == 1 else ()
        for name, numbers in self._elements.items():
            if name in only_solid:
                continue
            kind = re.sub(r"\d+$", "", name)
            groups.append((name, _KINDS[kind], numbers))
            groups.append((name + "_Nodes", "Node", self.nodes(name)))
        return groups

    def _share_nodes(self, shared):
        """What has no elements of its own has the nodes of what stands in its place. The names of all such."""
        names = []
        for dimension, index in np.unique(shared[:, :2], axis=0):
            name = entity_name(dimension, index)
            nodes = shared[(shared[:, 0] == dimension) & (shared[:, 1] == index), 2]
            self._nodes[name] = np.union1d(self.nodes(name), self._arrays["node_numbers"][nodes])
            names.append(name)
        return names

    def _collect(self, kind, connected, owners, numbers):
        if not len(connected):
            return
        self._connectivity[kind] = connected
        order = np.argsort(owners, kind="stable")
        present, starts = np.unique(owners[order], return_index=True)
        for owner, rows in zip(present, np.split(order, starts[1:])):
            name = "%s%d" % (kind, owner + 1)
            self._elements[name] = numbers[rows]
            self._rows[name] = rows


def _element_numbers(arrays):
    return np.concatenate([arrays[own] for _, _, own, _ in _ARRAYS.values()])


def _with_those_of_objects(groups, mesh, shown_by, resolver, entities):
    """These groups, with those of the analysis of what the mesh is shown by, and those of its group objects. Loads and supports find
    their groups by name, so where one of these objects has such a name its group gets a number behind it."""
    known = {name for name, _, _ in groups}
    groups = groups + [group for group in analysis_groups(shown_by, resolver, entities) if group[0] not in known]
    taken = {name.removesuffix("_Nodes") for name, _, _ in groups}
    for group in getattr(mesh, "MeshGroupList", []):
        name = not_taken(_name_of(group), taken)
        taken.add(name)
        groups += _groups_of_references(name, group, resolver, entities)
    return groups


def _groups_of_references(name, group, resolver, entities):
    names, _ = resolver.of_object(group)
    result = []
    for prefix in ("Solid", "Face", "Edge"):
        numbers = _union([entities.elements(sub) for sub in names if sub.startswith(prefix)])
        result.append((name, _KINDS[prefix], numbers))
    result = [entry for entry in result if len(entry[2])]
    result.append((name + "_Nodes", "Node", _union([entities.nodes(sub) for sub in names])))
    return result


def remarks_on_groups(part_mesh, mesh, raw):
    """Which mesh group objects have nodes and no elements, as messages."""
    groups, arrays = getattr(mesh, "MeshGroupList", []), part_mesh.arrays()
    if not groups or not len(arrays["shared_nodes"]):
        return []
    small, resolver = EntityGroups(arrays).names_without_elements(), Resolver(versions.part_of(mesh), raw)
    named = [(group, resolver.of_object(group)[0]) for group in groups]
    return [said("{group:text} has nodes and no elements: {places:entities} is too small for them, or lies on another face; choose another face, or set Ignore below to off",
                 group=group.Label, places=names) for group, names in named if names and small.issuperset(names)]


def _name_of(group):
    """What a mesh group object calls its groups, in one line: FreeCAD would read a document with two for ever."""
    return getattr(group, "UseLabel", False) and " ".join(group.Label.splitlines()) or group.Name


def renumbered(arrays):
    """The same mesh with numbers without gaps, as a first mesh has them: in the order of the arrays, triangles, tets, segments."""
    new, first = dict(arrays), 1
    new["node_numbers"] = np.arange(1, len(arrays["node_numbers"]) + 1)
    for name in ("triangle_numbers", "tet_numbers", "segment_numbers"):
        new[name] = np.arange(first, first + len(arrays[name]))
        first += len(arrays[name])
    new["counters"] = np.array([*arrays["counters"][:2], len(new["node_numbers"]) + 1, first], dtype=np.int64)
    return new


def is_material(member):
    """Is it a material that may be one of several?"""
    return member.isDerivedFrom("App::MaterialObject") and hasattr(member, "References")


def _union(arrays):
    arrays = [values for values in arrays if len(values)]
    return np.unique(np.concatenate(arrays)) if arrays else np.empty(0, dtype=np.int64)

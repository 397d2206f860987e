# SPDX-License-Identifier: GPL-3.0-or-later
"""Gmsh's format, 4.1 in ASCII, with the groups as physical groups.

A mesh there is a set of entities with elements, and a physical group is a set of entities; so the elements of an edge, face or solid
become one entity for each set of groups that they are in together.
"""

from dataclasses import dataclass, field

import numpy as np

from . import connectivity, is_of_that_entity, not_taken

_POINT = 15
_TYPES = {(1, 2): 1, (1, 3): 8, (2, 3): 2, (2, 6): 9, (3, 4): 4, (3, 10): 11}
_MIDS_OF_TET = [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]   # Gmsh has the middle of 23 before that of 13


@dataclass
class Entity:
    """Elements that are in the same groups."""
    cad: int                    # index of the CAD entity
    tag: int
    rows: np.ndarray            # of its elements among those of its dimension
    names: list = field(default_factory=list)   # of its groups


def write(path, arrays, groups):
    """A group of nodes becomes the group of the edges, faces, solids or vertices that it has all nodes of."""
    elements = {1: connectivity(arrays, "segments", "segment_mids"), 2: connectivity(arrays, "triangles", "triangle_mids"),
                3: connectivity(arrays, "tets", "tet_mids")}
    numbers = {1: arrays["segment_numbers"], 2: arrays["triangle_numbers"], 3: arrays["tet_numbers"]}
    owners = {1: arrays["segment_edges"], 2: arrays["triangle_faces"], 3: arrays["tet_solids"]}
    entities = {0: _points_of(arrays)}
    groups = [group for group in groups if not is_of_that_entity(group, arrays)]   # the entities have these names
    for dimension, (kind, stem) in {1: ("Edge", "Edge"), 2: ("Face", "Face"), 3: ("Volume", "Solid")}.items():
        entities[dimension] = _entities_of(owners[dimension], numbers[dimension], stem,
                                           [group for group in groups if group[1] == kind])
    for name, kind, members in groups:
        if kind == "Node":
            _name_where_the_nodes_are(name, np.isin(arrays["node_numbers"], members), elements, entities)
    with open(path, "w", encoding="utf-8") as stream:
        stream.write("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n")
        tags = _write_names(stream, entities)
        _write_entities(stream, arrays["points"], elements, entities, tags)
        _write_nodes(stream, arrays, entities)
        elements[3] = elements[3][:, _MIDS_OF_TET[:elements[3].shape[1]]]
        _write_elements(stream, arrays["node_numbers"], elements, numbers, entities)


def _points_of(arrays):
    """One entity for each node on a vertex of the part."""
    nodes = np.flatnonzero(arrays["entities"][:, 0] == 0)
    return [Entity(int(arrays["entities"][node, 1]), int(arrays["entities"][node, 1]) + 1, np.array([node])) for node in nodes]


def _entities_of(owners, numbers, stem, groups):
    """The elements of one dimension; the first part of a CAD entity has its number, the others those behind."""
    if not len(owners):
        return []
    keys = np.column_stack([owners] + [~np.isin(numbers, members) for _, _, members in groups])
    kinds, kind_of = np.unique(keys, axis=0, return_inverse=True)
    order = np.argsort(kind_of.reshape(-1), kind="stable")
    parts = np.split(order, np.cumsum(np.bincount(kind_of.reshape(-1)))[:-1])
    entities, used, next_tag, taken = [], set(), int(owners.max()) + 2, {name for name, _, _ in groups}
    for key, rows in zip(kinds, parts):
        tag = int(key[0]) + 1
        if tag in used:
            tag, next_tag = next_tag, next_tag + 1
        used.add(tag)
        names = [not_taken("%s%d" % (stem, key[0] + 1), taken)] + [group[0] for group, is_out in zip(groups, key[1:]) if not is_out]
        entities.append(Entity(int(key[0]), tag, rows, names))
    return entities


def _name_where_the_nodes_are(name, is_in, elements, entities):
    """Names the entities all of whose nodes are in the group, of the highest dimension that has them."""
    missing = is_in.copy()
    for dimension in (3, 2, 1, 0):
        for entity in entities[dimension]:
            nodes = elements[dimension][entity.rows].reshape(-1) if dimension else entity.rows
            if is_in[nodes].all() and missing[nodes].any():
                entity.names.append(name)
        for entity in entities[dimension]:
            if name in entity.names:
                missing[elements[dimension][entity.rows].reshape(-1) if dimension else entity.rows] = False


def _write_names(stream, entities):
    """Returns {(dimension, name): tag of the physical group}."""
    tags = {}
    for dimension in range(4):
        for entity in entities[dimension]:
            for name in entity.names:
                tags.setdefault((dimension, name), len(tags) + 1)
    stream.write("$PhysicalNames\n%d\n" % len(tags))
    for (dimension, name), tag in tags.items():
        stream.write('%d %d "%s"\n' % (dimension, tag, name.replace('"', "'")))
    stream.write("$EndPhysicalNames\n")
    return tags


def _write_entities(stream, points, elements, entities, tags):
    stream.write("$Entities\n%d %d %d %d\n" % tuple(len(entities[dimension]) for dimension in range(4)))
    for dimension in range(4):
        for entity in entities[dimension]:
            places = points[elements[dimension][entity.rows].reshape(-1)] if dimension else points[entity.rows]
            box = [*places.min(axis=0), *places.max(axis=0)] if dimension else places[0]
            groups = [tags[dimension, name] for name in entity.names]
            figures = [str(entity.tag), *("%.17g" % value for value in box), str(len(groups)), *map(str, groups)]
            stream.write(" ".join(figures) + (" 0\n" if dimension else "\n"))
    stream.write("$EndEntities\n")


def _write_nodes(stream, arrays, entities):
    """Each node with the CAD entity that it lies on."""
    numbers, places = arrays["node_numbers"], arrays["entities"]
    blocks = []
    for dimension in range(4):
        for entity in {entity.cad: entity for entity in reversed(entities[dimension])}.values():
            rows = np.flatnonzero((places[:, 0] == dimension) & (places[:, 1] == entity.cad))
            if len(rows):
                blocks.append((dimension, entity.tag, rows))
    stream.write("$Nodes\n%d %d %d %d\n" % (len(blocks), sum(len(rows) for _, _, rows in blocks), numbers.min(), numbers.max()))
    for dimension, tag, rows in blocks:
        stream.write("%d %d 0 %d\n" % (dimension, tag, len(rows)))
        np.savetxt(stream, numbers[rows], fmt="%d")
        np.savetxt(stream, arrays["points"][rows], fmt="%.17g")
    stream.write("$EndNodes\n")


def _write_elements(stream, node_numbers, elements, numbers, entities):
    """Points that are in a group become elements, too, with numbers behind all others."""
    named = [entity for entity in entities[0] if entity.names]
    last = max(int(numbers[dimension].max()) for dimension in (1, 2, 3) if len(numbers[dimension]))
    blocks = [(0, entity.tag, _POINT, np.array([[last + 1 + index, node_numbers[entity.rows[0]]]])) for index, entity in enumerate(named)]
    for dimension in (1, 2, 3):
        kind = _TYPES.get((dimension, elements[dimension].shape[1]))
        blocks += [(dimension, entity.tag, kind, np.column_stack([numbers[dimension][entity.rows], node_numbers[elements[dimension][entity.rows]]]))
                   for entity in entities[dimension]]
    first = min(int(table[:, 0].min()) for *_, table in blocks)
    stream.write("$Elements\n%d %d %d %d\n" % (len(blocks), sum(len(table) for *_, table in blocks), first, last + len(named)))
    for dimension, tag, kind, table in blocks:
        stream.write("%d %d %d %d\n" % (dimension, tag, kind, len(table)))
        np.savetxt(stream, table, fmt="%d")
    stream.write("$EndElements\n")

# SPDX-License-Identifier: GPL-3.0-or-later
"""Abaqus and CalculiX: nodes, tets, node and element sets, and each face as an element surface; shells and beams, with sets."""

import itertools
import re

import numpy as np

from . import connectivity, fillings_of

# Corners of the faces S1 to S4 of a tet. Mid-side nodes are in the order of `connectivity`.
_TYPES = {"tets": ("C3D4", "C3D10"), "triangles": ("S3", "S6"), "segments": ("B31", "B32")}
_CORNERS = {"tets": 4, "triangles": 3, "segments": 2}
_KINDS = {"tets": "Volume", "triangles": "Face", "segments": "Edge"}
_LONGEST_NAME = 80
_MIDDLE_LAST = [0, 2, 1]   # a beam's nodes are in the order of its length
_FACES = ((0, 1, 2), (0, 1, 3), (1, 2, 3), (0, 2, 3))


def write(path, arrays, groups):
    """Sets have the groups' names, as far as sets may be called so; of groups of faces the element surfaces tell."""
    nodes, fillings = arrays["node_numbers"], fillings_of(arrays)
    kinds = ("Node", *(_KINDS[names[0]] for names, _ in fillings))
    elements = np.concatenate([arrays[own][rows] for (_, _, own, _), rows in fillings])
    with open(path, "w", encoding="ascii", errors="replace") as stream:
        stream.write("** FeatureMesh, lengths in mm\n*NODE, NSET=Nall\n")
        np.savetxt(stream, np.column_stack([nodes, arrays["points"]]), fmt="%d, %.17g, %.17g, %.17g")
        for (kind, mids, own, _), rows in fillings:
            _write_elements(stream, kind, arrays[own][rows], nodes[connectivity(arrays, kind, mids)[rows]])
        for name, (_, of, members) in zip(_distinct([name for name, _, _ in groups]), groups):
            members = members if of == "Node" else np.intersect1d(members, elements)
            if of in kinds and len(members):
                keyword = "*NSET, NSET=" if of == "Node" else "*ELSET, ELSET="
                stream.write("%s%s\n" % (keyword, name))
                _write_numbers(stream, members)
        if "Volume" in kinds:
            _write_surfaces(stream, arrays)


def _distinct(names):
    """The names with nothing but letters of ASCII, digits, - and _, at most 80 of them; none twice: what has the name of another set joins that, and
    small letters are no others."""
    taken, found = {"NALL", "EALL"}, []
    for name in names:
        plain = re.sub(r"[^A-Za-z0-9_-]", "_", name)[:_LONGEST_NAME]
        choices = itertools.chain([plain], ("%s_%d" % (plain[:_LONGEST_NAME - 6], number) for number in itertools.count(2)))
        found.append(next(choice for choice in choices if choice.upper() not in taken))
        taken.add(found[-1].upper())
    return found


def _write_elements(stream, kind, numbers, nodes):
    stream.write("*ELEMENT, TYPE=%s, ELSET=Eall\n" % _TYPES[kind][1 if nodes.shape[1] > _CORNERS[kind] else 0])
    if kind == "segments" and nodes.shape[1] == 3:
        nodes = nodes[:, _MIDDLE_LAST]
    np.savetxt(stream, np.column_stack([numbers, nodes]), fmt=", ".join(["%d"] * (nodes.shape[1] + 1)))


def _write_surfaces(stream, arrays):
    corners = np.sort(np.vstack([arrays["tets"][:, list(face)] for face in _FACES]), axis=1)
    sides = np.repeat(np.arange(1, 5), len(arrays["tets"]))
    owners = np.tile(arrays["tet_numbers"], 4)
    triangles = np.sort(arrays["triangles"], axis=1)
    # Each triangle gets one whole number that it has among the tets' sides too.
    _, keys = np.unique(np.vstack([corners, triangles]), axis=0, return_inverse=True)
    row_of = np.zeros(len(keys), dtype=np.int64)
    row_of[keys[:len(corners)]] = np.arange(len(corners))
    rows = row_of[keys[len(corners):].reshape(-1)]
    is_side = np.isin(keys[len(corners):].reshape(-1), keys[:len(corners)])   # shells beside the tets are not
    for face in np.unique(arrays["triangle_faces"][is_side]):
        stream.write("*SURFACE, NAME=Face%d, TYPE=ELEMENT\n" % (face + 1))
        for row in rows[(arrays["triangle_faces"] == face) & is_side]:
            stream.write("%d, S%d\n" % (owners[row], sides[row]))


def _write_numbers(stream, numbers):
    for start in range(0, len(numbers), 16):
        stream.write(", ".join(str(number) for number in numbers[start:start + 16]) + ",\n")

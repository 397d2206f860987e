# SPDX-License-Identifier: GPL-3.0-or-later
"""NASTRAN bulk data: nodes in the large form (ten digits), tets with the solid's number as property and shells with the face's, groups as SET1."""

import numpy as np

from . import connectivity, fillings_of

_KINDS = {"tets": "Volume", "triangles": "Face"}
_CARDS = {4: "CTETRA", 10: "CTETRA", 3: "CTRIA3", 6: "CTRIA6"}
_PER_LINE = 8   # fields of eight characters


def write(path, arrays, groups):
    """Groups of nodes and of elements; a comment before each set has the group's name."""
    nodes, fillings = arrays["node_numbers"], fillings_of(arrays)
    kinds = ("Node", *(_KINDS[names[0]] for names, _ in fillings))
    written = np.concatenate([arrays[own][rows] for (_, _, own, _), rows in fillings])
    behind = int(arrays["tet_solids"].max(initial=-1)) + 1 if len(fillings) > 1 else 0   # properties of shells come after those of solids
    with open(path, "w", encoding="ascii", errors="replace") as stream:
        # without a comma: FreeCAD takes a file that has one for free form
        stream.write("$ FeatureMesh: lengths in mm and the property of an element is the number of its solid or face; those of shells beside solids are behind\nBEGIN BULK\n")
        np.savetxt(stream, np.column_stack([nodes, arrays["points"]]), fmt="GRID*   %16d                %16.9E%16.9E\n*       %16.9E")
        for (kind, mids, own, owners), rows in fillings:
            elements = nodes[connectivity(arrays, kind, mids)[rows]]
            properties = arrays[owners][rows] + 1 + (behind if kind == "triangles" else 0)
            np.savetxt(stream, np.column_stack([arrays[own][rows], properties, elements]), fmt=_form(elements.shape[1]))
        sets = [(name, members if kind == "Node" else np.intersect1d(members, written)) for name, kind, members in groups if kind in kinds]
        for number, (name, members) in enumerate([entry for entry in sets if len(entry[1])], 1):
            stream.write("$ %s\n" % name.replace(",", " "))
            _write_fields(stream, "SET1", [number, *members.tolist()])
        stream.write("ENDDATA\n")


def _form(nodes):
    """The card of one element: its number, property and nodes, in as many lines as that takes."""
    fields = 2 + nodes
    lines = ["%8d" * min(_PER_LINE, fields - start) for start in range(0, fields, _PER_LINE)]
    return _CARDS[nodes].ljust(8) + "+\n+       ".join(lines)


def _write_fields(stream, card, values):
    lines = ["".join("%8d" % value for value in values[start:start + _PER_LINE]) for start in range(0, len(values), _PER_LINE)]
    stream.write(card.ljust(8) + "+\n+       ".join(lines) + "\n")

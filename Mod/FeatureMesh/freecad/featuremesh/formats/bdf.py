# SPDX-License-Identifier: GPL-3.0-or-later
"""NASTRAN bulk data: nodes in the large form (ten digits), tets with the solid's number as property (or triangles with the face's), groups as SET1."""

import numpy as np

from . import connectivity, filling_of

_KINDS = {"tets": "Volume", "triangles": "Face"}
_CARDS = {4: "CTETRA", 10: "CTETRA", 3: "CTRIA3", 6: "CTRIA6"}
_PER_LINE = 8   # fields of eight characters


def write(path, arrays, groups):
    """Groups of nodes and of what fills the part; a comment before each set has the group's name."""
    kind, mids, own, owners = filling_of(arrays)
    nodes, numbers = arrays["node_numbers"], arrays[own]
    elements = nodes[connectivity(arrays, kind, mids)]
    with open(path, "w", encoding="ascii", errors="replace") as stream:
        # without a comma: FreeCAD takes a file that has one for free form
        stream.write("$ FeatureMesh: lengths in mm and the property of an element is the number of its solid or face\nBEGIN BULK\n")
        np.savetxt(stream, np.column_stack([nodes, arrays["points"]]), fmt="GRID*   %16d                %16.9E%16.9E\n*       %16.9E")
        np.savetxt(stream, np.column_stack([numbers, arrays[owners] + 1, elements]), fmt=_form(elements.shape[1]))
        for number, (name, _, members) in enumerate([group for group in groups if group[1] in ("Node", _KINDS[kind])], 1):
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

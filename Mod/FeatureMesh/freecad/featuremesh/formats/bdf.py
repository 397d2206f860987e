# SPDX-License-Identifier: GPL-3.0-or-later
"""NASTRAN bulk data: nodes in the large form (ten digits), tets with the solid's number as property, groups as SET1."""

import numpy as np

from . import connectivity

_KINDS = ("Node", "Volume")
_PER_LINE = 8   # fields of eight characters


def write(path, arrays, groups):
    """Groups of nodes and of tets; a comment before each set has the group's name."""
    nodes, numbers = arrays["node_numbers"], arrays["tet_numbers"]
    tets = nodes[connectivity(arrays, "tets", "tet_mids")]
    with open(path, "w", encoding="ascii", errors="replace") as stream:
        # without a comma: FreeCAD takes a file that has one for free form
        stream.write("$ FeatureMesh: lengths in mm and the property of an element is the number of its solid\nBEGIN BULK\n")
        np.savetxt(stream, np.column_stack([nodes, arrays["points"]]), fmt="GRID*   %16d                %16.9E%16.9E\n*       %16.9E")
        np.savetxt(stream, np.column_stack([numbers, arrays["tet_solids"] + 1, tets]), fmt=_tet_form(tets.shape[1]))
        for number, (name, _, members) in enumerate([group for group in groups if group[1] in _KINDS], 1):
            stream.write("$ %s\n" % name.replace(",", " "))
            _write_fields(stream, "SET1", [number, *members.tolist()])
        stream.write("ENDDATA\n")


def _tet_form(nodes):
    """The card of one tet: its number, property and nodes, in as many lines as that takes."""
    fields = 2 + nodes
    lines = ["%8d" * min(_PER_LINE, fields - start) for start in range(0, fields, _PER_LINE)]
    return "CTETRA  " + "+\n+       ".join(lines)


def _write_fields(stream, card, values):
    lines = ["".join("%8d" % value for value in values[start:start + _PER_LINE]) for start in range(0, len(values), _PER_LINE)]
    stream.write(card.ljust(8) + "+\n+       ".join(lines) + "\n")

# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether two shapes are the same where FreeCAD has copied one, as undo does, or has made it again by a recompute that changed nothing."""

_KINDS = "Solid", "Face", "Edge", "Vertex"
_DIGITS = 1e-9   # of the diagonal


def are_the_same(one, other):
    """Have they the same solids, faces, edges and vertices, as far as their numbers, places, lengths and areas tell?"""
    if one.isSame(other):
        return True
    if any(one.countElement(kind) != other.countElement(kind) for kind in _KINDS):
        return False
    near = _DIGITS * one.BoundBox.DiagonalLength
    return (all((a.Point - b.Point).Length <= near for a, b in zip(one.Vertexes, other.Vertexes))
            and all(abs(a.Length - b.Length) <= near for a, b in zip(one.Edges, other.Edges))
            and all(abs(a.Area - b.Area) <= near * (1 + a.Length) for a, b in zip(one.Faces, other.Faces)))

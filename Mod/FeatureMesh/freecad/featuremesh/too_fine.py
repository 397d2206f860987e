# SPDX-License-Identifier: GPL-3.0-or-later
"""Refuses sizes that are far too small before the engine makes a sizing field for them, which would take minutes.

About how many elements a size asks for is told from lengths, areas and volumes alone: the layers around a face or an edge in which the size
grows back to that of the part, as deep as the part is thick at most.
"""

import math

from .errors import UserError
from .messages import said
from .reading import describe

MOST = 50e6             # elements; the engine refuses more, too
MOST_AROUND = 10e6      # elements around one face or edge: far below what takes the sizing field minutes
_MARGIN = 1.5           # of this estimate
_PER_CUBE = 7.1         # elements per cube of the edge length, as the engine's own estimate has it
_PER_FINER = 8.9        # where sizes grow, likewise
_COUNTLESS = 1e12
_ENDLESS = 1e99         # mm^2


def refuse_too_fine(shape, size, growth, refinements):
    """Throws UserError that names the size, or the refinement, which asks for far too many elements.

    `refinements` are (entity such as "Face12", size in mm, name of the refinement).
    """
    countless = _COUNTLESS * size * size * size   # infinite for the largest numbers
    if _PER_CUBE * _box_volume(shape) > countless > 0 and _PER_CUBE * shape.Volume > countless:
        raise UserError(said("a size of {size:length} would make more than a million million elements; at most {most:count} million are made. Choose a "
                             "larger size",
                             size=size, most=round(MOST / 1e6)))
    asked = [(entity, local, name) for entity, (local, name) in _smallest(refinements).items() if 0 < local < size]
    if not asked:
        return
    measured = _measured(shape)
    counts = {(entity, local, name): _elements_around(measured, entity, local, size, growth - 1) for entity, local, name in asked}
    total, (entity, local, name) = sum(counts.values()), max(counts, key=counts.get)
    if counts[entity, local, name] > MOST_AROUND and not entity.startswith("Solid"):
        _refuse(counts[entity, local, name], entity, local, name,
                said("around one face or edge at most {most:count} million are made", most=round(MOST_AROUND / 1e6)))
    if total > _MARGIN * MOST:
        _refuse(total, entity, local, name, said("at most {most:count} million are made", most=round(MOST / 1e6)))


def refuse_endless(part, dimension):
    """Throws UserError for a face beside the solids that is meshed and has no end: what Boolean Fragments leave of a datum plane around the part that it cuts."""
    shape = part.Shape
    if dimension != "Solids" and any(piece.ShapeType in ("Face", "Shell") for piece in shape.SubShapes):
        endless = ["Face%d" % number for number, face in enumerate(shape.Faces, 1) if not 0 < face.Area < _ENDLESS]
        if endless:
            raise UserError(said("{faces:entities} of {part:text} has no end, as a piece of a datum plane: set the Mode of the Boolean Fragments to CompSolid, or mesh Solids",
                                 faces=endless, part=describe(part)))


def least_tets(shape, size):
    """About how many elements that size asks for in the solids, without refinements and curved faces."""
    return _PER_CUBE * shape.Volume / size ** 3


def _refuse(count, entity, local, name, limit):
    many = said("about {millions:count} million", millions=round(count / 1e6)) if count < _COUNTLESS else said("more than a million million")
    raise UserError(said("the refinement {refinement:text} with {size:length} at {place:text} would make {many:messages} elements; {limit:messages}. "
                         "Choose a larger size there",
                         refinement=name, size=local, place=entity, many=many, limit=limit))


def _smallest(refinements):
    """{entity: (size, name)}: of several sizes in one place the smallest counts."""
    found = {}
    for entity, local, name in refinements:
        if entity not in found or local < found[entity][0]:
            found[entity] = local, name
    return found


def _measured(shape):
    """({kind: edges, faces or solids}, the volume of all), which take FreeCAD 15 ms of a shape with 200 faces."""
    return {"Edge": shape.Edges, "Face": shape.Faces, "Solid": shape.Solids}, shape.Volume


def _elements_around(measured, entity, local, size, slope):
    """About how many elements a local size adds; a vertex adds next to none."""
    kind, index = entity.rstrip("0123456789"), int(entity[len(entity.rstrip("0123456789")):] or 0) - 1
    depth = (size - local) / slope if slope > 0 else math.inf   # to where the size is that of the part
    parts, volume = measured
    of_kind = parts.get(kind, [])
    if not 0 <= index < len(of_kind):
        return 0.0
    if kind == "Solid":
        return _PER_FINER * of_kind[index].Volume / local ** 3
    if kind == "Face":
        area = of_kind[index].Area
        return _PER_FINER * area * _over_layer(local, slope, min(depth, volume / area)) if area > 0 else 0.0
    length = of_kind[index].Length
    return _PER_FINER * length * _over_quarter(local, slope, min(depth, math.sqrt(4 * volume / (math.pi * length)))) if length > 0 else 0.0


def _over_layer(local, slope, depth):
    """The integral of 1 / h^3 over a layer of that depth, per area; h grows from `local` by `slope`."""
    if slope <= 0:
        return depth / local ** 3
    return (1 / local ** 2 - 1 / (local + slope * depth) ** 2) / (2 * slope)


def _over_quarter(local, slope, radius):
    """The same over a quarter of a disc, per length: what is around an edge at a right angle."""
    return math.pi / 4 * radius ** 2 / (local * (local + slope * radius) ** 2)


def _box_volume(shape):
    box = shape.BoundBox
    return box.XLength * box.YLength * box.ZLength

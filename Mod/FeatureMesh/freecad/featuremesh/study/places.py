# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a response is taken: faces, edges and vertices of the base part are followed through edits, as loads and supports are.

Each such place is a mesh group of the base document, which the mesh object moves along with its faces.
"""

import re

import numpy as np
import ObjectsFem

from .. import formats, resolving
from ..errors import UserError
from ..messages import said
from ..hand_over import EntityGroups
from ..section import EDGES

_ELEMENT = re.compile(r"(Face|Edge|Vertex|Solid)\d+$")
_GROUP = "StudyPlace%d"
_OUTSIDE = -0.05   # barycentric coordinate of a point that is taken to lie on a curved boundary still


def of_nodes(responses):
    """The places of the responses that are sub-elements of the part, sorted: number n is kept by the group named for n + 1."""
    return sorted({response.at for response in responses if response.at and _ELEMENT.match(response.at)})


def add_groups(mesh, part, responses):
    """Puts every such place on record in the base document. Throws UserError for one that the part has not."""
    groups = []
    for number, place in enumerate(of_nodes(responses), 1):
        resolver = resolving.Resolver(part)
        if not resolving.is_element_of(part.Shape, place):
            raise UserError(said("the part has no {place:text}, where a response is asked for", place=place))
        if part.Document.getObject(_GROUP % number) is not None:   # of a study whose base this document was
            part.Document.removeObject(_GROUP % number)
        group = ObjectsFem.makeMeshGroup(part.Document, mesh, False, _GROUP % number)
        group.Label = "Place of a response: " + place
        group.References = [(resolver.bearer or part, place)]
        groups.append(group)
    return groups


class Places:
    """Rows of nodes by place, on one mesh."""

    def __init__(self, mesh, part, arrays, part_mesh, responses):
        self._mesh, self._part, self._arrays, self._part_mesh = mesh, part, arrays, part_mesh
        self._elements = of_nodes(responses)
        self._entities = EntityGroups(arrays)
        self._filling = formats.filling_of(arrays)
        self._row_of = np.full(int(arrays["node_numbers"].max(initial=0)) + 1, -1)
        self._row_of[arrays["node_numbers"]] = np.arange(len(arrays["node_numbers"]))

    def values(self, at, values, rows):
        """Those of a field, (n,) or (n,k), that a place has: (m,) or (m,k), with a single row for a point. `rows` (n,) are the rows of the mesh that they belong to.
        Throws UserError for a place that is gone."""
        point = point_of(at) if at else None
        if point is not None:
            return np.asarray(_interpolated(self._arrays, values, point))[None]
        if not at:
            there = self._rows_of_elements(self._arrays[self._filling[2]])   # a node without an element has no solution
        else:
            there = self._of_element(at) if at in self._elements else self._of_feature(at)
        return values[np.isin(rows, there)]

    def _of_element(self, at):
        group = self._part.Document.getObject(_GROUP % (self._elements.index(at) + 1))
        names, _ = resolving.Resolver(self._part).of_object(group)
        rows = self._rows_of_names(names)
        if not len(rows):
            raise UserError(said("{place:text}, where a response is asked for, is gone", place=at))
        return rows

    def _of_feature(self, at):
        obj = feature(self._part, at)
        faces = ["Face%d" % number for number, owners in enumerate(self._part_mesh.owners_of_faces(), 1) if obj.Name in owners]
        tets = [self._rows_of_elements(numbers) for name, numbers in self._part_mesh.owners_of_tets() if name == obj.Name]
        rows = np.unique(np.concatenate([self._rows_of_names(faces), *tets]))
        if not len(rows):
            raise UserError(said("{place:text}, where a response is asked for, has no face and no element of the part", place=at))
        return rows

    def _rows_of_names(self, names):
        numbers = [self._entities.nodes(name) for name in names]
        return np.unique(self._row_of[np.concatenate(numbers)]) if numbers else np.empty(0, dtype=np.int64)

    def _rows_of_elements(self, numbers):
        kind, mids, own, _ = self._filling
        return np.unique(formats.connectivity(self._arrays, kind, mids)[np.isin(self._arrays[own], numbers)])


def feature(part, name):
    """The feature of that name or label. Throws UserError."""
    obj = part.Document.getObject(name) or next(iter(part.Document.getObjectsByLabel(name)), None)
    if obj is None:
        raise UserError(said("there is no face, edge, vertex, point or feature {place:text}, where a response is asked for", place=name))
    return obj


def point_of(at):
    """The (3,) mm of "x,y,z", None for another place."""
    words = at.replace(" ", "").split(",")
    try:
        return np.array([float(word) for word in words]) if len(words) == 3 else None
    except ValueError:
        return None


def refuse_points_outside(arrays, responses):
    """Throws UserError where a response is asked for at a point that is not in the part."""
    for response in responses:
        point = point_of(response.at) if response.at else None
        if point is not None:
            _interpolated(arrays, arrays["points"], point)


def _interpolated(arrays, values, point):
    """The field at a point, by the shape functions of the tet it lies in. Throws UserError for a point outside of the part."""
    if not len(arrays["tets"]):
        raise UserError(said("the part has no solid that the point {point:point} could be in; ask at a face, edge or vertex", point=point.tolist()))
    corners = arrays["points"][arrays["tets"]]
    matrix = np.moveaxis(corners[:, 1:] - corners[:, :1], 1, 2)
    inner = np.linalg.solve(matrix, (point - corners[:, 0])[..., None])[..., 0]
    shares = np.column_stack([1 - inner.sum(axis=1), inner])
    tet = int(shares.min(axis=1).argmax())
    if shares[tet].min() < _OUTSIDE:
        raise UserError(said("the point {point:point}, where a response is asked for, is not in the part", point=point.tolist()))
    share = shares[tet]
    if not len(arrays["tet_mids"]):
        return share @ values[arrays["tets"][tet]]
    weights = np.concatenate([share * (2 * share - 1), [4 * share[a] * share[b] for a, b in EDGES]])
    return weights @ values[np.concatenate([arrays["tets"][tet], arrays["tet_mids"][tet]])]

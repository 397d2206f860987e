# SPDX-License-Identifier: GPL-3.0-or-later
"""Old results on a new mesh: nodal fields are carried over, and a result object with them."""

import Fem
import FreeCAD
import numpy as np
import ObjectsFem

from . import adopt, analyses, engine, results
from .errors import UserError
from .given_mesh import give
from .messages import said
from .reading import called, describe
from .statics_result import NODES

SAME_NODE, INSIDE, OUTSIDE = 0, 1, 2
# CalculiX writes coordinates with six digits: nodes of a result's mesh are this close to those that were solved, in diagonals.
_RESULT_DIGITS = 2e-5
# Not fields, or per node already known
_NO_FIELDS = {"NodeNumbers", NODES, "Stats", "Eigenmode", "EigenmodeFrequency", "Time"}


def field(old_arrays, new_arrays, values, same_place=0.0):
    """`values` (n,) or (n,k), a row per node of the old mesh, on the new mesh's nodes (see featuremesh_engine.transfer_field).

    Returns a dict: values, errors (an estimate, in the field's unit), sources (per node), and figures for a report.
    """
    values = np.asarray(values, dtype=float)
    carried, errors, sources = engine.load().transfer_field(old_arrays, new_arrays, values, float(same_place))
    return {"values": carried, "errors": errors, "sources": sources, "figures": figures(carried, errors, sources)}


def figures(values, errors, sources):
    """How many nodes got their value in which way, and how large the estimated error is beside the field."""
    size = np.linalg.norm(np.atleast_2d(values.T).T, axis=1)
    error = np.linalg.norm(np.atleast_2d(errors.T).T, axis=1)
    largest = float(size.max()) if len(size) else 0.0
    return {
        "nodes": int(len(sources)), "same": int((sources == SAME_NODE).sum()), "interpolated": int((sources == INSIDE).sum()),
        "outside": int((sources == OUTSIDE).sum()), "largest_value": largest,
        "largest_error": float(error.max()) if len(error) else 0.0,
        "mean_error": float(error[sources != SAME_NODE].mean()) if (sources != SAME_NODE).any() else 0.0,
    }


def result(old, mesh, name=None):
    """A result object for the mesh object `mesh` with the fields of the result object `old`. Returns it and a report.

    `old` may be of another document. Vectors and scalars per node are carried; the report tells the error of each field.
    """
    new_arrays = mesh.Proxy.arrays(mesh)
    if not len(new_arrays["tets"]):
        raise UserError(said("old results are carried over between meshes of solids only, not to {mesh:text}", mesh=describe(mesh)))
    old_arrays, order = _mesh_of(old)
    diagonal = float(np.linalg.norm(np.ptp(old_arrays["points"], axis=0)))
    fields = _fields_of(old)
    if not fields:
        raise UserError(said("{result:text} has no values per node", result=describe(old)))
    columns = np.column_stack([np.asarray(values, dtype=float).reshape(len(order), -1) for values in fields.values()])[order]
    found = field(old_arrays, new_arrays, columns, _RESULT_DIGITS * diagonal)
    new = _add_result(mesh, name or old.Name + "_transferred")
    new.NodeNumbers = new_arrays["node_numbers"].tolist()
    report = {"result": new.Name, "fields": {}}
    at = 0
    for title, values in fields.items():
        width = 3 if isinstance(values[0], FreeCAD.Vector) else 1
        part = slice(at, at + width)
        at += width
        carried = found["values"][:, part]
        if title not in new.PropertiesList:   # one of the user's own
            new.addProperty(old.getTypeIdOfProperty(title), title)
        setattr(new, title, [FreeCAD.Vector(*row) for row in carried.tolist()] if width == 3 else carried[:, 0].tolist())
        report["fields"][title] = figures(carried, found["errors"][:, part], found["sources"])
    for title in ("Time", "EigenmodeFrequency"):
        if title in old.PropertiesList and title in new.PropertiesList:
            setattr(new, title, getattr(old, title))
    return new, report


def find_result(document, name=None):
    """The document's result object with values, the one called `name` where there are several. Throws UserError."""
    results = [obj for obj in document.Objects if obj.isDerivedFrom("Fem::FemResultObject") and len(obj.NodeNumbers)]
    if name:
        results = called(results, name)
    if not results:
        raise UserError(said("the document {document:text} has no result{name:text} with values per node; solve first",
                             document=document.Label, name=" " + name if name else ""))
    if len(results) > 1:
        raise UserError(said("the document has several results, name one with --result: {results:text}", results=", ".join(describe(obj) for obj in results)))
    return results[0]


def _mesh_of(old):
    """The arrays of a result's mesh with the numbers that were solved, and the row of the result for each of its nodes."""
    if old.Mesh is None:
        raise UserError(said("{result:text} has no mesh", result=describe(old)))
    arrays = adopt.arrays_of(old.Mesh)
    solved = np.array(old.NodeNumbers, dtype=np.int64)
    rows = np.argsort(solved, kind="stable")
    by_number = np.argsort(arrays["node_numbers"], kind="stable")
    if len(solved) != len(by_number):
        raise UserError(said("{result:text} has values for {values:count} {values:node|nodes}, its mesh {mesh:text} has {nodes:count}",
                             result=describe(old), values=len(solved), mesh=describe(old.Mesh), nodes=len(by_number)))
    # FreeCAD closes the gaps between the numbers of a mesh when it opens a document; the result still knows the true ones, one of ours beside its own.
    order = np.empty(len(solved), dtype=np.int64)
    order[by_number] = rows
    arrays["node_numbers"] = np.array(getattr(old, NODES, solved)).astype(np.int64)[order]
    return arrays, order


def _fields_of(old):
    """Property -> list of numbers or vectors, one per node."""
    count, fields = len(old.NodeNumbers), {}
    for title in old.PropertiesList:
        if title in _NO_FIELDS:
            continue
        kind = old.getTypeIdOfProperty(title)
        if kind in ("App::PropertyVectorList", "App::PropertyFloatList"):
            values = getattr(old, title)
            if len(values) == count:
                fields[title] = values
    return fields


def _add_result(mesh, name):
    """A mechanical result object that shows its values on a copy of the mesh, as FreeCAD's own do."""
    document = mesh.Document
    new = ObjectsFem.makeResultMechanical(document, name)
    shown = document.addObject("Fem::FemMeshObject", name + "_Mesh")
    give(shown, Fem.FemMesh(mesh.FemMesh))
    new.Mesh = shown
    for analysis in analyses.directly_holding(mesh)[:1]:
        analysis.addObject(new)
        results.note_again(new)
    return new

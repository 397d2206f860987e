# SPDX-License-Identifier: GPL-3.0-or-later
"""FreeCAD's own result object from arrays, without a text file between."""

import FreeCAD
import numpy as np
import ObjectsFem
from femtools import femutils

from . import hand_over, history, results
from .given_mesh import give
from .proxies import HIDDEN, NO_TOUCH

_TENSOR = (("XX", 0), ("YY", 1), ("ZZ", 2), ("XY", 3), ("YZ", 4), ("XZ", 5))   # FreeCAD's names of the columns
NODES = "MeshNodes"   # a property of results: the mesh's own numbers of their nodes, row by row, as no edit changes them
_MASS_FLOW_AND_REST = 8   # figures of FreeCAD's table that are of no concern here: plastic strain, temperature, flow
_made = {}   # (document's name, object's name) of results and their meshes: the name of their analysis


def show(analysis, arrays, fields, name="LiveResult", same_mesh=False):
    """Puts the solution into the analysis's result object of that name, made where it is not there. Returns it.

    Node numbers run from 1 without gaps, as in every result that FreeCAD reads; row by row they are the nodes of the arrays. With
    `same_mesh` the object has the mesh of the arrays already.
    """
    document = analysis.Document
    result = of_analysis(analysis, name)
    if result is None or result.Mesh is None:
        same_mesh = False
    if result is None:
        result = _left_over(analysis, name) or _note_made(ObjectsFem.makeResultMechanical(document, history.new_name(document, name)), analysis)
        _set_in_tree(result, True)
        analysis.addObject(result)
    if result.Mesh is None:
        left = [obj for obj in document.Objects if not obj.InList and femutils.is_of_type(obj, "Fem::MeshResult")]   # of a result that was deleted
        left.sort(key=_is_in_tree, reverse=True)
        result.Mesh = left[0] if left else _note_made(ObjectsFem.makeMeshResult(document, history.new_name(document, "ResultMesh")), analysis)
        _set_in_tree(result.Mesh, True)
        if result.Mesh.ViewObject is not None:
            result.Mesh.ViewObject.Visibility = False   # FEM's result panel shows it
    if not same_mesh:
        put_mesh(result, arrays)
    fill(result, fields)
    _note_nodes(result, arrays["node_numbers"])
    results.note_again(result)
    result.purgeTouched()
    result.Mesh.purgeTouched()
    return result


def put_mesh(result, arrays):
    """Gives a result the mesh of the arrays, as `result_mesh` has it."""
    by_row = {**arrays, "node_numbers": np.arange(1, len(arrays["points"]) + 1)}
    give(result.Mesh, result_mesh(arrays), hand_over.skin(result.Mesh, by_row))


def set_aside_left_over(document):
    """Undo may give back a result, or the mesh of one, in whose place another one was made meanwhile: the tree does not show it, and the next result that is to
    be made is that one. It is not deleted: nothing that happens while FreeCAD tells of an undo or of a step that was cancelled belongs to a step, and what
    redo or undo comes back to would be no more. Any other result goes back into its analysis, as redo gives that the members that it had."""
    left = []
    for result in filter(_is_result, _made_in(document)):
        analysis = document.getObject(_made[document.Name, result.Name])
        if result.InList or analysis is None:
            continue
        if of_analysis(analysis, _stem(result)) is None:
            analysis.addObject(result)
        else:
            left.append(result)
    left += [mesh for mesh in _made_in(document) if mesh.isDerivedFrom("Fem::FemMeshObject") and set(mesh.InList) <= set(left)]
    for obj in _made_in(document):
        _set_in_tree(obj, obj not in left)


def forget(document):
    """To be called when a document was closed: another one may get its name."""
    for place in [place for place in _made if place[0] == document.Name]:
        del _made[place]


def _left_over(analysis, name):
    """A result of the analysis, of that name, that was set aside, or None."""
    document = analysis.Document
    return next((result for result in filter(_is_result, _made_in(document))
                 if _stem(result) == name and not result.InList and _made[document.Name, result.Name] == analysis.Name), None)


def _stem(obj):
    """Its name without the number that FreeCAD has given it: what `transfer` made of a result has that one's name with more words."""
    return obj.Name.rstrip("0123456789")


def _is_result(obj):
    return obj.isDerivedFrom("Fem::FemResultObject")


def _is_in_tree(obj):
    return obj.ViewObject is None or obj.ViewObject.ShowInTree


def _set_in_tree(obj, is_shown):
    """What the tree does not show is not seen either."""
    if _is_in_tree(obj) != is_shown and obj.ViewObject is not None:
        obj.ViewObject.ShowInTree = is_shown
        obj.ViewObject.Visibility = False


def _note_made(obj, analysis):
    _made[obj.Document.Name, obj.Name] = analysis.Name
    return obj


def _made_in(document):
    """What was made there and is there still."""
    return [obj for obj in (document.getObject(name) for owner, name in sorted(_made) if owner == document.Name) if obj is not None]


def _note_nodes(result, numbers):
    if NODES not in result.PropertiesList:
        result.addProperty("App::PropertyFloatList", NODES, "FeatureMesh", "The mesh's numbers of the nodes", NO_TOUCH)
        result.setEditorMode(NODES, HIDDEN)
    setattr(result, NODES, numbers.astype(float).tolist())


def of_analysis(analysis, name="LiveResult"):
    """The result object of that name in an analysis, None where it has none."""
    return next((member for member in analysis.Group if _is_result(member) and _stem(member) == name), None)


def last_displacements(analysis):
    """(node_numbers (n,), displacements (n,3) mm) of the last solution that a result of the analysis shows, on whichever mesh; None where there is none."""
    for result in reversed(analysis.Group):
        if NODES in result.PropertiesList and len(getattr(result, NODES)) == len(result.DisplacementVectors):
            return np.array(getattr(result, NODES)).astype(np.int64), fields_of(result)["displacements"]
    return None


def result_mesh(arrays):
    """The tets alone, numbered from 1 in the order of the arrays."""
    alone = hand_over.renumbered({**arrays, **hand_over.NO_SEGMENTS, **hand_over.NO_TRIANGLES})
    alone["entities"] = np.tile(np.array([[3, 0]], dtype=np.int32), (len(alone["points"]), 1))
    return hand_over.build(alone, [])


def fill(result, fields):
    """The values by node, as FreeCAD's reader of CalculiX results sets them."""
    displacements, stresses = fields["displacements"], fields["stresses"]
    result.NodeNumbers = list(range(1, len(displacements) + 1))
    lengths = np.linalg.norm(displacements, axis=1)
    result.DisplacementVectors = list(map(FreeCAD.Vector, *displacements.T.tolist()))
    result.DisplacementLengths = lengths.tolist()
    for title, column in _TENSOR:
        setattr(result, "NodeStress" + title, stresses[:, column].tolist())
    for title, column in _TENSOR if "strains" in fields else ():
        setattr(result, "NodeStrain" + title, fields["strains"][:, column].tolist())
    result.vonMises = fields["von_mises"].tolist()
    low, middle, high = principal(stresses).T
    shear = (high - low) / 2
    result.PrincipalMax, result.PrincipalMed, result.PrincipalMin = high.tolist(), middle.tolist(), low.tolist()
    result.MaxShear = shear.tolist()
    columns = [*displacements.T, lengths, fields["von_mises"], high, middle, low, shear]
    result.Stats = [float(value) for column in columns for value in (column.min(), column.max())] + [0.0] * _MASS_FLOW_AND_REST


def fields_of(result):
    """What `fill` put there, as far as it is drawn."""
    return {"displacements": np.array([tuple(vector) for vector in result.DisplacementVectors]).reshape(-1, 3),
            "von_mises": np.array(result.vonMises)}


def von_mises(stresses):
    """(n,) of (n,6)."""
    xx, yy, zz, xy, yz, zx = stresses.T
    return np.sqrt(((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * (xy ** 2 + yz ** 2 + zx ** 2))


def principal(stresses):
    """(n,3) principal stresses, ascending."""
    xx, yy, zz, xy, yz, zx = stresses.T
    return np.linalg.eigvalsh(np.stack([np.stack([xx, xy, zx], 1), np.stack([xy, yy, yz], 1), np.stack([zx, yz, zz], 1)], 1))

# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a mesh finer where its result is off, as far as is asked for."""

import numbers
import os

import numpy as np

from . import analyses, engine, error_sizes, statics, statics_model, statics_result
from .errors import UserError
from .messages import said
from .reading import describe
from .refusals import all_or_nothing

MOST_ROUNDS = 6   # of solve_to
# Beside a load on a point the error is not less with smaller elements: a round with so many times the elements that leaves more than so much of it is the last.
_MANY, _LITTLE = 2.0, 0.8


def refine_by_error(analysis, accuracy=0.05):
    """Asks for smaller elements where the analysis's live result is off the most, so that about `accuracy` of it is left: the energy norm of the error over that of
    the solution, as the result's `mesh_error` has it (ZienkiewiczZhu1987). Recompute the document, or call update_mesh, to mesh; what is fine enough is kept.

    Returns {"mesh_error": the present one, "places": how many were added, "tets": about how many the mesh will have}; where the error is small enough nothing is
    asked for. It is a document object, to be suppressed or deleted. Throws UserError where there is no live result of the mesh as it is.
    """
    _refuse(analysis, accuracy)
    mesh = statics.mesh_of(analysis)
    arrays = mesh.Proxy.arrays(mesh)
    nodes, displacements = statics_result.last_displacements(analysis) or ((), None)
    if not np.array_equal(nodes, arrays["node_numbers"]):
        raise UserError(said("there is no live result of {mesh:text} as it is; solve first", mesh=describe(mesh)))
    model = statics_model.prepared(analysis, mesh, arrays)
    of_tets = engine.load().statics_error(arrays, model.materials, model.tet_materials, displacements, mesh.Threads or os.cpu_count() or 1)
    error = float(np.linalg.norm(of_tets))
    if error <= accuracy:
        return {"mesh_error": error, "places": 0, "tets": len(of_tets)}
    asked = error_sizes.wanted(arrays, of_tets, accuracy)
    with all_or_nothing(mesh.Document):
        error_sizes.add_balls(mesh, asked.balls)
    return {"mesh_error": error, "places": len(asked.balls), "tets": asked.tets}


def solve_to(analysis, accuracy=0.05, threads=0, progress=None):
    """Solves live, refines by error, updates the mesh and solves again, until the estimate of the error is no more than `accuracy`, six times at most. Returns the report of
    the last solution as solve_analysis gives it, with `rounds`: of each mesh its elements, its mesh_error and the share of its nodes that were kept. Throws UserError.
    """
    from . import api   # which has this function, too
    _refuse(analysis, accuracy)
    mesh = statics.mesh_of(analysis)
    rounds, kept = [], None
    while True:
        report = api.solve_analysis(analysis, "live", threads, "", progress)
        rounds.append({"elements": len(mesh.Proxy.arrays(mesh)["tets"]), "mesh_error": report["mesh_error"], "kept": kept})
        if report["mesh_error"] <= accuracy or len(rounds) == MOST_ROUNDS or _is_in_vain(*rounds[-2:]):
            break
        refine_by_error(analysis, accuracy)
        kept = api.update_mesh(mesh, progress=progress)["kept"]["nodes_share"]
    report["rounds"] = rounds
    if report["mesh_error"] > accuracy:
        report["warnings"].append(said("the stresses are still off by about {percent:number} % in the mean of the energy, more than the {wanted:number} % that were asked for: "
                                       "beside sharp corners, and loads on points or edges, finer meshes gain little",
                                       percent=round(100 * report["mesh_error"], 1), wanted=round(100 * accuracy, 3)))
    return report


def _is_in_vain(before, after=None):
    return after is not None and after["elements"] > _MANY * before["elements"] and after["mesh_error"] > _LITTLE * before["mesh_error"]


def _refuse(analysis, accuracy):
    analyses.refuse_other(analysis)
    if not isinstance(accuracy, numbers.Real) or not 0 < accuracy < 1:
        raise UserError(said("the accuracy is a share between 0 and 1, such as 0.05, not {accuracy:text}", accuracy=str(accuracy)))

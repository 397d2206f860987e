# SPDX-License-Identifier: GPL-3.0-or-later
"""The cases of a study without us: each is meshed anew by FreeCAD's Gmsh object and solved by CalculiX, in a copy of a process that has the document open.

FEATUREMESH_CASE is JSON: base (a study's base document), size (mm), threads, folder, cases (each with id and set). CalculiX
has the solver that our studies choose for large models. The result's data are the cases that are done (seconds by step, nodes, the largest von Mises stress)
and the numbers of those that failed: Gmsh's mesh may have folded elements.
"""
import os
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import ObjectsFem
from femmesh.gmshtools import GmshTools

sys.path.insert(0, str(Path(__file__).parent))

from in_freecad import tell  # noqa: E402

SECONDS_LIMIT = 3600


@dataclass
class Peer:
    """A study's base document with Gmsh's mesh object in place of ours."""
    document: object
    part: object
    analysis: object
    mesh: object


def open_peer(path, size):
    from freecad.featuremesh import api, calculix, documents, versions
    document = documents.open_document(path)
    ours, analysis = api.find_mesh(document, None), api.find_analysis(document, None)
    part = versions.part_of(ours)
    document.removeObject(ours.Name)
    mesh = ObjectsFem.makeMeshGmsh(document, "Gmsh")
    setattr(mesh, versions.part_property(mesh), part)
    mesh.CharacteristicLengthMax, mesh.ElementOrder = size, "2nd"
    analysis.addObject(mesh)
    calculix.solver_of(analysis).MatrixSolverType = "iterativecholesky"
    return Peer(document, part, analysis, mesh)


def run(peer, case, threads):
    from freecad.featuremesh import statics_result
    from freecad.featuremesh.study import case_run, case_solver
    from freecad.featuremesh.study.steps import step
    seconds = {}
    with step(seconds, "recompute"):
        case_run.edit(peer, case)
    with step(seconds, "mesh"):
        problem = GmshTools(peer.mesh).create_mesh()
    if problem:
        raise RuntimeError("Gmsh: %s" % problem)
    numbers = np.array(sorted(peer.mesh.FemMesh.Nodes))
    fields = case_solver.solve_ccx(peer.analysis, {"node_numbers": numbers}, case["folder"], threads, seconds)
    with step(seconds, "responses"):
        worst = float(statics_result.von_mises(fields.stresses).max())
    return {"seconds": seconds, "nodes": len(numbers), "max_mises": worst, "id": case["id"]}


def measure(task):
    from freecad.featuremesh.study import worker_main
    from freecad.featuremesh.study.steps import PROCESSORS
    import feminout.importCcxFrdResults  # noqa: F401  what FreeCAD's writer loads, loaded once, as a study's workers do
    peer, found, failed = open_peer(task["base"], task["size"]), [], []
    for case in task["cases"]:
        case["folder"] = os.path.join(task["folder"], "peer-%d" % case["id"])
        os.makedirs(case["folder"])
        result = worker_main.run_in_copy(lambda: run(peer, case, task["threads"]), case["folder"], SECONDS_LIMIT, None)
        if "nodes" in result:
            result["seconds"][PROCESSORS]["total"] = result[PROCESSORS]
            found.append(result)
        else:
            failed.append(case["id"])
    return {"done": found, "failed": failed}


if __name__ == "study_peer":
    tell(measure)

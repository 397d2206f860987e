# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs in FreeCAD: meshes the example bracket with the FeatureMesh that this FreeCAD finds, edits it, updates, and tells about it.

Writes JSON to FEATUREMESH_RESULT: hashes of the nodes after mesh and update, the kept share, where addon and engine are, or the error.
With FEATUREMESH_ASKED, also what the engine was asked and what it answered, for replay.py.
"""
import hashlib
import json
import os
import pickle
import time

import FreeCAD


def points_hash(mesh):
    nodes = mesh.FemMesh.Nodes
    digest = hashlib.sha256()
    for number in sorted(nodes):
        digest.update(("%d %r\n" % (number, tuple(nodes[number]))).encode())
    return digest.hexdigest()


def remember_jobs():
    """From now on the list that this gives gets (raw part, options, nodes of the mesh) of each run of the engine."""
    from freecad.featuremesh.job import MeshJob
    asked, run = [], MeshJob.run

    def remembering(job, progress=None):
        run(job, progress)
        asked.append((job.raw, job.options, job.part_mesh.arrays()["points"].tobytes()))

    MeshJob.run = remembering
    return asked


def mesh_and_update(said):
    from freecad.featuremesh import about, api, documents, engine, reading
    asked = remember_jobs()
    said["addon"] = os.path.realpath(api.__file__)
    said["user"] = FreeCAD.getUserAppDataDir()
    said["about"] = about.text()
    said["engine"] = engine.folder()
    document = documents.open_document(os.environ["FEATUREMESH_EXAMPLE"])
    part = reading.find_meshable(document)
    mesh = api.add_mesh(part, 6.0, 1)
    api.update_mesh(mesh, full=True)
    said["seconds_until_first_mesh"] = time.time() - float(os.environ.get("FEATUREMESH_STARTED", time.time()))
    said["mesh"] = points_hash(mesh)
    mesh.Automatic = False
    api.set_parameters(document, ["HoleSketch.Hole6X=105"])
    api.recompute(document)
    said["kept"] = api.update_mesh(mesh)["kept"]["nodes_share"]
    said["update"] = points_hash(mesh)
    said["in_worker"] = engine.runs_in_worker()
    if "FEATUREMESH_ASKED" in os.environ:
        with open(os.environ["FEATUREMESH_ASKED"], "wb") as file:
            pickle.dump(asked, file)


def main():
    said = {"user": FreeCAD.getUserAppDataDir()}
    try:
        mesh_and_update(said)
    except Exception as error:
        said["error"] = "%s: %s" % (type(error).__name__, error)
    with open(os.environ["FEATUREMESH_RESULT"], "w", encoding="utf-8") as result:
        json.dump(said, result)
    os._exit(0)


main()

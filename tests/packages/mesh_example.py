# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs in FreeCAD: meshes the example bracket with the FeatureMesh that this FreeCAD finds, edits it, updates, and tells about it.

Writes JSON to FEATUREMESH_RESULT: hashes of the nodes after mesh and update, the kept share, where addon and engine are, or the error.
"""
import hashlib
import json
import os
import time

import FreeCAD


def points_hash(mesh):
    nodes = mesh.FemMesh.Nodes
    digest = hashlib.sha256()
    for number in sorted(nodes):
        digest.update(("%d %r\n" % (number, tuple(nodes[number]))).encode())
    return digest.hexdigest()


def mesh_and_update(said):
    from freecad.featuremesh import about, api, documents, engine, reading
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

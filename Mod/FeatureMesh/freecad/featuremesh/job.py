# SPDX-License-Identifier: GPL-3.0-or-later
"""The engine's share of one mesh or update, cut out so that a window can run it beside FreeCAD's own thread."""

import time

import numpy as np

from . import engine, log, thin_elements
from .messages import english, of_error, with_owners, with_parts
from .reports import with_details_in_one, without_errors_told
from .worker import WorkerDied

_ELEMENTS = "tets", "tet_mids", "triangles", "triangle_mids", "segments"


class MeshJob:
    """Made and finished by the mesh object in FreeCAD's thread.

    `run` touches no FreeCAD object and may be called in any thread.
    """

    def __init__(self, raw, options, old, problem, remarks):
        self.raw, self.options = raw, options
        self.remarks = remarks    # lines about refinements: references that were put right, and what is left out
        self.old = old            # the engine's mesh to start from, or None
        self.saved = None         # the state.State that it is to be made from first, or None
        self.problem = problem    # why there is none although there should be, or None
        self.part_mesh = None
        self.report = None
        self.shape = None         # the part's, as FreeCAD has it
        self.part_of = {}         # label of the part by the name of the solid, of several parts
        self.frame = None         # and where what it is in puts it
        self.settings = None      # the mesh object's when the job was made
        self.begun_at = None      # which saved state it had then, see overtaken.py
        self.seconds = {}
        self.next_numbers = (1, 1)   # of nodes and elements, for a mesh from scratch

    def run(self, progress=None):
        """Meshes or updates. `progress(step, share)` returns False to cancel, which raises the engine's Cancelled."""
        if self.saved is not None:
            self._restore(progress)
        start = time.perf_counter()
        self.part_mesh, self.report = run_engine(self._mesh, self.raw, self.options, progress)
        self.report["warnings"] = with_parts(without_errors_told(self.report["warnings"], self.remarks), self.part_of)
        self.seconds["engine"] = time.perf_counter() - start
        log.write("%s %s in %.1f s", "meshed" if self.old is None else "updated", self.raw["final_object"], self.seconds["engine"])

    def kept_all(self, arrays):
        """Are the nodes and elements, of which these are the arrays, those of the old mesh, as when a group was added?"""
        if self.old is None:
            return False
        return all(map(np.array_equal, _nodes_and_elements(self.old.arrays()), _nodes_and_elements(arrays)))

    def _mesh(self, progress):
        if self.old is None:
            return engine.load().mesh_part(self.raw, self.options, progress=progress, next_numbers=self.next_numbers)
        return engine.load().update_part(self.old, self.raw, self.options, progress)

    def _restore(self, progress):
        """Makes the engine's mesh of the saved state, or leaves it to a mesh from scratch and says why."""
        start, saved = time.perf_counter(), self.saved
        try:
            self.old = engine.load().restore_part(saved.raw, saved.options, saved.arrays, progress)
        except (engine.load().StateError, WorkerDied) as error:
            self.problem = of_error(error)
        self.seconds["restore"] = time.perf_counter() - start


def run_engine(mesh, raw, options, progress):
    """What `mesh(progress)` makes, (PartMesh, report), or raises; in either case what is said tells of faces and edges whose features' they are."""
    try:
        part_mesh, report = mesh(progress)
    except (engine.load().MeshError, engine.load().InputError) as error:
        error.message = with_owners(of_error(error), lambda names: _owners_in(raw, options, names))
        error.args = (english(error.message),)
        raise
    thin = thin_elements.remarks(part_mesh.arrays(), report["quality"])
    said = {"warnings": with_details_in_one(report["warnings"]) + thin, "fallback": report["fallback"], "rounds": report["rounds"]}
    return part_mesh, {**report, **with_owners(said, part_mesh.labels_of_owners)}


def _owners_in(raw, options, names):
    try:
        return engine.load().labels_of_owners(raw, options, names)
    except engine.load().Error:   # it was refused before anything of it was known
        return [[] for _ in names]


def _nodes_and_elements(arrays):
    """Those of a mesh by the nodes' numbers, for an update puts nodes into another order."""
    numbers = arrays["node_numbers"]
    rows = np.argsort(numbers)
    yield numbers[rows]
    yield arrays["points"][rows]
    yield arrays["tet_numbers"]
    for name in _ELEMENTS:
        yield numbers[arrays[name]]

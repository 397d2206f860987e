# SPDX-License-Identifier: GPL-3.0-or-later
"""Linear statics of an analysis with a mesh of ours, solved by the engine (PETSc) from the mesh's arrays."""

import os
import time

import FreeCAD
import numpy as np

from . import analyses, engine, solvers, statics_model, statics_supports
from .errors import UserError
from .formats import entity_name
from .messages import said, with_parts
from .reading import describe
from .statics_model import NotUnderstood

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
TONNE = 1000.0   # kg
_TOO_STIFF = QT_TRANSLATE_NOOP("FeatureMesh", "4-node tetrahedra are too stiff in bending and show too little stress; 10-node tetrahedra (Order: 2nd) are far closer on "
                               "the same mesh")
_TOO_STIFF_BY = QT_TRANSLATE_NOOP("FeatureMesh", "4-node tetrahedra are too stiff in bending and show too little stress (here the stresses are off by about "
                                  "{percent:count} % in the mean of the energy); 10-node tetrahedra (Order: 2nd) are far closer on the same mesh")

_CAN_MOVE = QT_TRANSLATE_NOOP("FeatureMesh", "the part can still {how:messages}: add a support")
_PIECES_CAN_MOVE = QT_TRANSLATE_NOOP("FeatureMesh", "{solids:entities} can still {how:messages}: add a support. "
                                     "What shares no faces with the rest of the part needs one of its own")
_kept = {}   # name of a document -> the names under which the engine keeps solutions of its analyses for scripts


def mesh_of(analysis):
    """The mesh object of an analysis. Throws NotUnderstood where it is not ours, or not one."""
    meshes = analyses.meshes_of(analysis)
    if suppressed := analyses.suppressed_mesh_of(analysis):
        raise NotUnderstood(said(analyses.MESH_IS_SUPPRESSED, mesh=describe(suppressed), analysis=describe(analysis)))
    if len(meshes) != 1 or analyses.source_of(meshes[0]) is None:
        raise NotUnderstood(said("the live solver needs one mesh of FeatureMesh in the analysis {analysis:text}: select its part, and Mesh a part, or drag its mesh there",
                                  analysis=describe(analysis)))
    return analyses.source_of(meshes[0])


def arrays_of(analysis):
    """The arrays of the analysis's mesh."""
    mesh = mesh_of(analysis)
    return mesh.Proxy.arrays(mesh)


def solve(analysis, keep="", threads=0, progress=None, start=None):
    """Solves the analysis. Returns (fields, report).

    `fields` has a row per node of the mesh's arrays: displacements (n,3) mm, stresses (n,6) MPa (xx, yy, zz, xy, yz, zx), von_mises (n,)
    MPa, reactions (n,3) N. The report is what --json writes. What is kept under the name `keep`, until the document is closed, makes the next solution of that
    name faster; the first starts from `start`, as statics_result.last_displacements gives it.
    Throws NotUnderstood for what only CalculiX can, UserError for what cannot be solved at all.
    """
    job = SolveJob(analysis, keep, threads, start=start)
    if keep:
        _kept.setdefault(analysis.Document.Name, set()).add(keep)
    job.run(progress)
    return job.fields, job.report


def forget(document):
    """To be called when a document was closed."""
    for name in _kept.pop(document.Name, ()):
        engine.load().forget_statics(name)


class CanMove(UserError):
    """The supports leave a rigid motion free; `motion` is (n,3) a displacement of the nodes by it, of about the part's size."""

    def __init__(self, message, motion):
        super().__init__(message)
        self.motion = motion


class SolveJob:
    """One solution. Made in FreeCAD's thread; `run` touches no FreeCAD object and may be called in any thread.

    Throws as `solve` does, when it is made or when it runs. Then `fields` and `report` are what `solve` gives.
    """

    def __init__(self, analysis, keep="", threads=0, arrays=None, start=None):
        """`arrays` are those of the mesh that the analysis's mesh object is about to get, if it is; `start` is an earlier solution."""
        began = time.perf_counter()
        self.statics = statics_model.prepared(analysis, mesh_of(analysis), arrays)
        self.keep, self.threads = keep, threads or os.cpu_count() or 1
        self.start = start
        self.fields = self.report = None
        self._remarks = solvers.remarks(analysis, solvers.for_linear_statics(analysis))
        self._read = time.perf_counter() - began

    def run(self, progress=None):
        """Solves. `progress(step, share)` returns False to cancel, which raises the engine's Cancelled."""
        start, statics = time.perf_counter(), self.statics
        missing = engine.load().statics_missing()
        if missing:
            raise NotUnderstood(said("the live solver needs PETSc: install Debian's package libpetsc-real-dev, then any command of "
                                                       "./featuremesh in a clone builds the solver with it"))
        statics.add_up()
        refuse_free_motions(statics)
        read = self._read + time.perf_counter() - start
        fields = self.fields = engine.load().solve_statics(statics.arrays, statics.model(), self.keep, self.threads, progress, start=self.start)
        seconds = {name: fields["seconds"].get(name, 0.0) for name in ("assemble", "setup", "solve", "stresses")}
        self.report = {
            "solver": "live",
            "matrix_solver": {"name": "cg", "preconditioner": fields["preconditioner"], "why": "conjugate gradients (PETSc), the live solver's only one"},
            "responses": responses(statics, fields), "iterations": fields["iterations"], "residual": fields["residual"],
            "energy_error": fields["energy_error"], "mesh_error": fields["discretisation_error"],
            "warnings": self._remarks + statics.warnings + (remarks(statics.arrays, fields["discretisation_error"]) if fields["displacements"].any() else without_load(statics)),
            "reused": {"preconditioner": fields["kept_preconditioner"], "start_share": fields["kept_start_share"]},
            "seconds": {"read": read, **seconds, "total": self._read + time.perf_counter() - start}}


def is_for_calculix(error):
    """May CalculiX solve what the live solver could not? It knows more, and factors matrices on which iterations do not converge."""
    return isinstance(error, NotUnderstood) or error.message["code"] == "not_converged"


def refuse_free_motions(statics):
    """Throws CanMove when the part can move as a rigid body."""
    motions, centre, scale = statics_supports.free_motions(statics.arrays, statics.held)
    if motions is None:
        raise NotUnderstood(said("the mesh falls into more pieces than the live solver looks at"))
    how = statics_supports.in_words(motions)
    if not how:
        return
    moved = statics_supports.moved(statics.arrays, motions, centre, scale)
    if len(motions) == 1:
        raise CanMove(said(_CAN_MOVE, how=how), moved)
    pieces = said(_PIECES_CAN_MOVE, how=how, solids=statics_supports.solids_as_free(statics.arrays, motions))
    raise CanMove(with_parts(pieces, statics.part_of), moved)


def responses(statics, fields):
    """The figures of a solution."""
    worst = int(np.argmax(fields["von_mises"]))
    lengths = np.linalg.norm(fields["displacements"], axis=1)
    farthest = int(np.argmax(lengths))
    return {
        "mass_kg": mass(statics) if statics.has_density else None,
        "max_mises_mpa": float(fields["von_mises"][worst]), "max_mises_at": place(statics.arrays, worst),
        "max_displacement_mm": float(lengths[farthest]), "max_displacement_at": place(statics.arrays, farthest),
        "reactions_n": reactions(statics, fields["reactions"]),
        "strain_energy_mj": float(fields["strain_energy"]),   # N mm
    }


def reactions(statics, by_node):
    """By support the sum of (n,3) reactions; a component that several supports hold counts with the first."""
    return {name: np.where(held, by_node, 0.0).sum(axis=0).tolist() for name, held in statics.supports.items()}


def place(arrays, row):
    """Where a node is: its number, its coordinates, and the face, edge or vertex that it lies on."""
    return {"node": int(arrays["node_numbers"][row]), "mm": arrays["points"][row].tolist(),
            "on": entity_name(*arrays["entities"][row])}


def mass(statics):
    """kg, of the elements as they are curved: what they weigh in an acceleration of 1 mm/s^2."""
    return float(engine.load().statics_weight(statics.arrays, statics.materials, statics.tet_materials, [1.0, 0.0, 0.0])[:, 0].sum() * TONNE)


def without_load(statics):
    """Where nothing moves: what does not load the part is named already, but there may be no load at all, or none on what is free to move."""
    if statics.loads.any():
        return [said("all loads act on what the supports hold, so nothing moves; look at the faces, edges and vertices that they are on")]
    return [] if statics.warnings else [said("nothing loads the part: add a force, a pressure or another load to the analysis")]


def remarks(arrays, error=None):
    """What the user should know of the figures; `error` is the estimate of what the mesh is off, where there is one."""
    if len(arrays["tet_mids"]):
        return []
    return [said(_TOO_STIFF) if error is None else said(_TOO_STIFF_BY, percent=round(100 * error))]

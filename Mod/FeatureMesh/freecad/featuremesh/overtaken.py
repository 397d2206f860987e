# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh that is made beside FreeCAD's own thread may be overtaken: by an edit of the part or of a refinement, by undo, or by an update of the same mesh."""

from . import mesh_object, state, versions
from .refusals import part_to_mesh


def note(mesh, job):
    """To be called before the job runs."""
    job.begun_at = state.checksum_of(mesh.SavedState)


def is_overtaken(mesh, job):
    """Would the job be another one if it was prepared now? Throws UserError where the mesh has no part any longer."""
    part = part_to_mesh(mesh)
    return (job.begun_at != state.checksum_of(mesh.SavedState) or not part.Shape.isSame(job.shape)
            or not versions.are_same_place(versions.parent_frame(part), job.frame) or mesh_object.options_of(mesh, part) != job.options)

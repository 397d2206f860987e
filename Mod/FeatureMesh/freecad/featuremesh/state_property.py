# SPDX-License-Identifier: GPL-3.0-or-later
"""The file of a mesh's saved state within its document: FreeCAD copies, renames and loses it, and a mesh must have its own all the same."""

import contextlib
import glob
import os
import shutil
import tempfile
import threading

import FreeCAD

from . import state
from .mesh_properties import choose_form

_NAMED_BY = 16   # digits of its checksum that name a state's file
_LARGE = 10_000_000   # bytes, of 250 000 tets; FreeCAD copies them one by one into a document and compresses them, while the window waits
_WHEN_NOBODY_WAITS = 1.0   # seconds after it was stored a large one is compressed


def put(mesh, saved):
    """Stores a State with the mesh object. Returns its checksum. Throws OSError and what FreeCAD does."""
    with tempfile.TemporaryDirectory(prefix="featuremesh-") as folder:
        path = os.path.join(folder, mesh.Name + ".npz")
        checksum = state.save(path, saved)
        os.makedirs(mesh.Document.TransientDir, exist_ok=True)   # somebody may have emptied FreeCAD's cache folder
        mesh.SavedState = path, _file_name(mesh, checksum)
    mesh.StateName = checksum
    if FreeCAD.GuiUp and os.path.getsize(mesh.SavedState) > _LARGE:
        later = threading.Timer(_WHEN_NOBODY_WAITS, state.compress, args=(mesh.SavedState,))
        later.daemon = True
        later.start()
    return checksum


def have_own(mesh):
    """Gives a copied mesh a state file of its own: FreeCAD lets it have that of the original, and an edit or undo of one would take the other's state."""
    path = mesh.SavedState
    if not path or not any(other is not mesh and getattr(other, "SavedState", "") == path for other in mesh.Document.Objects):
        return
    with tempfile.TemporaryDirectory(prefix="featuremesh-") as folder:
        own = shutil.copy(path, folder)
        mesh.SavedState = own, _file_name(mesh, state.checksum_of(own))
        if not os.path.exists(path):   # FreeCAD takes the file that it replaces away
            shutil.copy(own, path)


def bring_back(mesh):
    """To be called after undo or redo: FreeCAD looks for the state where it was before *Save As*, which gives the document's folder another name."""
    wanted = mesh.StateName
    if not wanted or state.checksum_of(mesh.SavedState) == wanted:
        return
    kept = glob.glob("%s/*%s*" % (glob.escape(mesh.Document.TransientDir), wanted[:_NAMED_BY]))
    found = next((path for path in kept if state.checksum_of(path) == wanted), None)
    if found is not None:
        with tempfile.TemporaryDirectory(prefix="featuremesh-") as own:
            mesh.SavedState = shutil.copy(found, own), _file_name(mesh, wanted)


def keep(mesh, saved):
    """Where the file of the state is gone, as with a cache folder that was emptied, it is written again from `saved`; without that (None) the next mesh is one
    from scratch, and FreeCAD's form of this one is saved in any case."""
    path = os.path.join(mesh.Document.TransientDir, os.path.basename(mesh.SavedState))   # SavedState still names the folder from before *Save As*
    if not mesh.SavedState or os.path.exists(mesh.SavedState) or os.path.exists(path):
        return
    with contextlib.suppress(OSError):   # FreeCAD says that it cannot save
        os.makedirs(os.path.dirname(path), exist_ok=True)
        if saved is None:
            open(path, "wb").close()
            choose_form(mesh, is_saved=True)
        else:
            state.save(path, saved)


def next_numbers(mesh, state_is_sound):
    """What a mesh from scratch has to number on from, so that no number is ever given to another node or element."""
    known = (mesh.SavedState and state.next_numbers_of(mesh.SavedState)) or (1, 1)
    fem_mesh = mesh.FemMesh
    if state_is_sound or not fem_mesh.NodeCount:
        return known
    elements = [max(numbers) for numbers in (fem_mesh.Edges, fem_mesh.Faces, fem_mesh.Volumes) if numbers]
    return max(known[0], 1 + max(fem_mesh.Nodes)), max(known[1], 1 + max(elements, default=0))


def _file_name(mesh, checksum):
    """A name that no other state's file has: FreeCAD puts a pasted file over another one of its name."""
    return "%s-%s.npz" % (mesh.Name, checksum[:_NAMED_BY])

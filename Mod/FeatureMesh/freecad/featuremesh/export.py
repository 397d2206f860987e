# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a mesh with its groups to a file.

UNV, MED and Z88 go through FreeCAD's writers, which keep what these formats can hold; FreeCAD's other writers drop surface elements
and groups, so the other formats are written here from the saved state.
"""

import os
import shutil
import tempfile

import numpy as np

from . import hand_over, state
from .errors import UserError
from .messages import of_error, said
from .formats import bdf, fillings_of, inp, msh, stl, vtk, vtu

# Names of formats and of their files -> the module that writes them; None: FreeCAD does.
FORMATS = {"vtu": vtu, "vtk": vtk, "inp": inp, "bdf": bdf, "msh": msh, "stl": stl, "unv": None, "med": None, "z88": None}
WITHOUT_GROUPS = ("stl", "z88")
_LONGEST_MED_NAME = 64
_BLOCK = 65536   # bytes, more than a disk that was full has left
_MED_BYTES = 60   # of a node or element in a MED file at most, and
_MED_HEAD = 200000   # of the rest
# NASTRAN wants to know how the section lies, of which a mesh knows nothing; FreeCAD writes bars for Z88, without their middles.
_WITHOUT_BEAMS = ("bdf", "stl", "z88")


def write(mesh, path, file_format):
    """Writes `mesh` to `path`, whole or not at all. Returns the number of its groups in the file. Throws UserError for an unknown format or a mesh
    object without a mesh."""
    file_format = file_format.lower()
    if file_format not in FORMATS:
        raise UserError(said("cannot export to {format:text}, only to {formats:text}", format=file_format or path, formats=", ".join(FORMATS)))
    ending = os.path.splitext(path)[1].lstrip(".").lower()
    if ending in FORMATS and ending != file_format:
        raise UserError(said("{path:text} is the name of a {ending:text} file and would hold {format:text}; give it another name, or ask for {ending:text}",
                             path=os.path.basename(path), ending=ending, format=file_format))
    if not mesh.FemMesh.NodeCount:
        raise UserError(said("{mesh:text} has no mesh yet; recompute the document first", mesh=mesh.Label))
    if file_format in _WITHOUT_BEAMS and not mesh.FemMesh.FaceCount:
        raise UserError(said("{format:text} has no form for a mesh of edges; export it as inp, vtu, vtk, msh, unv or med", format=file_format))
    if file_format == "z88" and not mesh.FemMesh.VolumeCount and mesh.Order == "1st" and mesh.FemMesh.FaceCount:
        raise UserError(said("z88 has no 3-node triangles; mesh with 6-node triangles, or export it as inp, vtu, vtk, msh, unv or med"))
    _refuse_beside_others(mesh, file_format)
    target = os.path.realpath(path)   # a link stays one
    name = os.path.splitext(os.path.basename(target))[0]
    if file_format == "med" and len(name.encode()) > _LONGEST_MED_NAME:
        raise UserError(said("a MED file keeps its mesh under the file's own name, which may have {most:count} characters at most; choose a shorter one "
                             "than {name:text}",
                             most=_LONGEST_MED_NAME, name=name))
    groups = groups_of(mesh) if file_format not in WITHOUT_GROUPS else []
    try:
        with tempfile.TemporaryDirectory(prefix=".featuremesh-", dir=os.path.dirname(target)) as folder:
            temporary = os.path.join(folder, name + "." + file_format)   # FreeCAD reads a MED mesh by its file's name only
            writer = FORMATS[file_format]
            if writer is None:
                _write_by_freecad(hand_over.build(mesh.Proxy.arrays(mesh), groups) if groups else mesh.FemMesh, temporary)
            else:
                writer.write(temporary, state.load(mesh.SavedState).arrays, groups)
            if os.path.exists(target):
                shutil.copymode(target, temporary)
            os.replace(temporary, target)
    except OSError as error:
        raise UserError(said("cannot write {path:text}: {why:messages}", path=path, why=error.strerror or of_error(error))) from error
    return len(groups)


def _write_by_freecad(fem_mesh, path):
    """FreeCAD's writers say nothing of a full disk, or name a line of their sources; that of MED may end FreeCAD, so that it is looked before. Throws
    OSError."""
    if path.endswith(".med") and hasattr(os, "posix_fallocate"):   # which macOS and Windows have not
        _see_room(path, _MED_HEAD + _MED_BYTES * (fem_mesh.NodeCount + fem_mesh.EdgeCount + fem_mesh.FaceCount + fem_mesh.VolumeCount))
    try:
        fem_mesh.write(path)
    finally:
        _try_to_go_on(path)


def _see_room(path, size):
    """Throws OSError where a file of that many bytes has no room."""
    with open(path, "wb") as stream:
        os.posix_fallocate(stream.fileno(), 0, size)
    os.unlink(path)


def _try_to_go_on(path):
    """Throws OSError where the file has no room to grow, so that its end may be missing."""
    size = os.path.getsize(path)
    with open(path, "ab") as stream:
        stream.write(bytes(_BLOCK))
        stream.flush()
        os.fsync(stream.fileno())
    os.truncate(path, size)


def _refuse_beside_others(mesh, file_format):
    """Shells beside solids, and beams beside both, in a format that would lose them."""
    if file_format not in ("bdf", "z88"):
        return
    kinds = [names[0] for names, _ in fillings_of(state.load(mesh.SavedState).arrays)]
    if len(kinds) > 1 and (file_format == "z88" or "segments" in kinds):
        raise UserError(said("{format:text} would lose the beams of this mesh; export it as inp, vtu, vtk, msh, unv or med", format=file_format)
                        if kinds[-1] == "segments" else
                        said("{format:text} would lose the shells of this mesh; export it as inp, vtu, vtk, msh, unv or med", format=file_format))


def groups_of(mesh):
    """(name, kind, numbers) of every group of a mesh object: of every entity and feature, and those that it has in FreeCAD."""
    known = groups_in(mesh.FemMesh)
    names = {name for name, _, _ in known}
    part_mesh = mesh.Proxy.last_part_mesh(mesh)
    everything = hand_over.everything_in_groups(hand_over.EntityGroups(part_mesh.arrays()), part_mesh.owners_of_tets)
    return [group for group in everything if group[0] not in names] + known


def groups_in(fem_mesh):
    """(name, kind, numbers) of every group of a Fem.FemMesh."""
    return [(fem_mesh.getGroupName(group), fem_mesh.getGroupElementType(group),
             np.array(sorted(fem_mesh.getGroupElements(group)), dtype=np.int64)) for group in fem_mesh.Groups]

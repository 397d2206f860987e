# SPDX-License-Identifier: GPL-3.0-or-later
"""Room on the disk for a document, and in the folder for temporary files for the text by way of which FreeCAD reads and writes each mesh of it. Where there is
none it reads a part of a mesh, or saves a part of the document in place of the old one, without a word, and to write a mesh says "Output file not good"."""

import os
import re
import shutil
import zipfile

import FreeCAD

from .errors import UserError
from .messages import said
from .user_words import in_words

_MESH = re.compile(rb'<FemMesh file="([^"]+)"')
# How the window tells of a document that was not saved as a whole; None: in the report view.
tell = None
_NODE, _VOLUME, _FACE = 118, 100, 90   # bytes of one in that text, or less


def refuse_to_read(archive, path):
    """Throws UserError where there is no room for the meshes of the document in that archive."""
    meshes = [name.decode() for name in _MESH.findall(archive.read("Document.xml"))]
    needed = max((archive.getinfo(name).file_size for name in meshes if name in archive.namelist()), default=0)
    if needed > _room():
        raise UserError(said("FreeCAD cannot read the meshes of {path:text}: that takes {needed:number} MB in the folder for temporary files, {folder:text}, where "
                             "{room:number} MB can be written; make room, or set TMPDIR to another folder", path=path, needed=_megabytes(needed),
                             folder=FreeCAD.getTempPath(), room=_megabytes(_room())))


def tell_before_saving(document):
    """To be called before FreeCAD saves the document: says in the report view for which of its meshes there is no room."""
    for obj in document.Objects:
        if obj.isDerivedFrom("Fem::FemMeshObject") and "Transient" not in obj.getPropertyStatus("FemMesh"):
            mesh = obj.FemMesh
            needed = _NODE * mesh.NodeCount + _VOLUME * mesh.VolumeCount + _FACE * mesh.FaceCount
            if needed > _room():
                FreeCAD.Console.PrintError(in_words(said(
                    "{object:text} cannot be saved: that takes {needed:number} MB in the folder for temporary files, {folder:text}, where {room:number} MB can be "
                    "written; make room and save again", object=obj.Label, needed=_megabytes(needed), folder=FreeCAD.getTempPath(), room=_megabytes(_room()))) + "\n")


def look_at_saved(document, path):
    """To be called when FreeCAD has saved the document there: the end of the file is missing where the disk is full."""
    if zipfile.is_zipfile(path):
        return
    error = UserError(said("{path:text} was not saved as a whole; is the disk full? Make room before you save it again, or save it elsewhere: FreeCAD would overwrite the "
                           "copy that it keeps of the document as it was before", path=path))
    if tell is not None:
        tell(document, error)
    else:
        FreeCAD.Console.PrintError(in_words(error.message) + "\n")


def _room():
    folder = FreeCAD.getTempPath()
    return shutil.disk_usage(folder).free if os.access(folder, os.W_OK) else 0


def _megabytes(count):
    return round(count / 1e6, 1)

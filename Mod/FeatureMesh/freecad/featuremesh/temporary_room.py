# SPDX-License-Identifier: GPL-3.0-or-later
"""Room for the text by way of which FreeCAD reads and writes each mesh of a document, in the folder for temporary files. Where there is none it reads a part of the
mesh without a word, and to write says "Output file not good"."""

import os
import re
import shutil

import FreeCAD

from .errors import UserError
from .messages import said
from .user_words import in_words

_MESH = re.compile(rb'<FemMesh file="([^"]+)"')
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


def _room():
    folder = FreeCAD.getTempPath()
    return shutil.disk_usage(folder).free if os.access(folder, os.W_OK) else 0


def _megabytes(count):
    return round(count / 1e6, 1)

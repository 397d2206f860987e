# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens and saves documents so that a bad file gets a clear message and a good one is never left half written."""

import os
import re
import shutil
import zipfile
import zlib
from dataclasses import dataclass
from xml.parsers import expat
from xml.sax.saxutils import escape, unescape

import FreeCAD

from . import disk_room, document_view, orphans, versions
from .errors import UserError
from .messages import of_error, said

_LINK = re.compile(rb'(<XLink file=")([^"]+)')   # to another document, as seen from the folder of this one
_OBJECT = re.compile(r'<Object type="([^"]*)" name="([^"]*)"')   # in the list of a document's objects
_QUOTES = {"&quot;": '"', "&apos;": "'"}
# By the name of each document that was opened.
_opened = {}


@dataclass
class _Opened:
    """What is known of the file of a document from when it was opened."""
    path: str
    stamp: tuple
    left_out: list   # "Name (Type)" of the objects that FreeCAD did not make


def open_document(path):
    """Opens the .FCStd file hidden. Throws UserError: missing, not a document, damaged."""
    if not os.path.isfile(path):
        raise UserError(said("there is no file {path:text}", path=path))
    if not zipfile.is_zipfile(path):
        raise UserError(said("{path:text} is not a FreeCAD document (or its end is cut off)", path=path))
    try:
        with zipfile.ZipFile(path) as archive:
            written = archive.read("Document.xml") if "Document.xml" in archive.namelist() else None
            damaged = archive.testzip()
    except (zipfile.BadZipFile, zlib.error, OSError, EOFError, ValueError, RuntimeError) as error:   # the last for an unknown method, or a password
        raise UserError(said("{path:text} is damaged: {why:messages}", path=path, why=of_error(error))) from error
    if written is None:
        raise UserError(said("{path:text} is not a FreeCAD document: it has no Document.xml", path=path))
    if damaged:
        raise UserError(said("{path:text} is damaged: {member:text} in it cannot be read", path=path, member=damaged))
    with zipfile.ZipFile(path) as archive:
        disk_room.refuse_to_read(archive, path)
    stamp = _stamp_of(path)
    try:
        document = FreeCAD.openDocument(path, True)
        orphans.adopt_all(document)
        _opened[document.Name] = _Opened(path, stamp, _left_out(document, written))
        return document
    except Exception as error:
        raise UserError(said("FreeCAD cannot open {path:text}: {why:messages}", path=path, why=of_error(error))) from error


def save_document(document, path):
    """Saves a copy to `path`, whole or not at all.

    What the document shows (colours, views) is taken from its file; where that has none, the meshes are shown, or the parts. A link
    stays one, and a file that is there keeps who may read it. Throws UserError, also where the file would be replaced and FreeCAD could
    not read all of it.
    """
    _refuse_to_lose(document, path)
    file = os.path.realpath(path)
    folder, name = os.path.split(file)
    if not os.path.isdir(folder):
        raise UserError(said("cannot write {path:text}: there is no folder {folder:text}", path=path, folder=folder))
    _sweep(folder, name)
    temporary = document_view.temporary_beside(file)
    try:
        _save_copy(document, temporary)
        if document.FileName:
            _keep_links(temporary, os.path.dirname(os.path.realpath(document.FileName)), folder)
        if not FreeCAD.GuiUp:
            with document_view.open_file(document.FileName) as old:
                document_view.add(document, temporary, old)
        _refuse_half_written(temporary)
        if os.path.exists(file):
            shutil.copymode(file, temporary)
        _to_disk(temporary)
        os.replace(temporary, file)
        _to_disk(folder)
        if document.Name in _opened and _opened[document.Name].path == path:
            _opened[document.Name].stamp = _stamp_of(path)
    except Exception as error:
        if isinstance(error, (OSError, zipfile.BadZipFile, RuntimeError, UserError)):
            raise UserError(said("cannot write {path:text}: {why:messages}", path=path, why=of_error(error))) from error
        raise
    finally:
        _remove([name for name in os.listdir(folder) if name.startswith(os.path.basename(temporary))], folder)


def _save_copy(document, path):
    try:
        document.saveCopy(path)
    except Exception as error:
        if "UNV" not in str(error):
            raise
        raise UserError(said("FreeCAD cannot write a mesh to the folder for temporary files, {folder:text}; is it full?", folder=FreeCAD.getTempPath())) from error


def _refuse_to_lose(document, path):
    """FreeCAD leaves out what it does not know, and says nothing where a file ends too soon; and somebody else may have saved the file meanwhile."""
    source = document.FileName
    if not (os.path.isfile(path) and os.path.isfile(source) and os.path.samefile(path, source)):
        return
    known = _opened.get(document.Name)
    if known is None or known.path != source:
        return
    if known.stamp != _stamp_of(source):
        raise UserError(said("{path:text} was saved by another program meanwhile, which writing it would undo; do this again, or write another file with --out",
                             path=path))
    with zipfile.ZipFile(source) as archive:
        is_whole = _is_whole(archive.read("Document.xml"))
    if known.left_out or not is_whole:
        raise UserError(said("FreeCAD {version:text} cannot read all of {path:text}{objects:messages}, and writing it would lose that; write another file with "
                             "--out, or take the FreeCAD that it was made with",
                             version=versions.text(), path=path, objects=said(": not {objects:text}", objects=", ".join(known.left_out)) if known.left_out else ""))


def _left_out(document, xml):
    return ["%s (%s)" % (name, kind) for kind, name in _OBJECT.findall(xml.decode("utf-8", "replace")) if document.getObject(name) is None]


def _stamp_of(path):
    """Changes when the file is written, or another one takes its place."""
    status = os.stat(path)
    return status.st_ino, status.st_size, status.st_mtime_ns


def _is_whole(xml):
    try:
        expat.ParserCreate().Parse(xml, True)
    except expat.ExpatError:
        return False
    return True


def _refuse_half_written(path):
    """FreeCAD says nothing when the disk is full: every member is read back, with its checksum."""
    try:
        with zipfile.ZipFile(path) as archive:
            if "Document.xml" not in archive.namelist():
                raise UserError(said("FreeCAD wrote no document"))
            damaged = archive.testzip()
    except zipfile.BadZipFile:
        damaged = os.path.basename(path)
    if damaged:
        raise UserError(said("{member:text} did not arrive on the disk whole; is it full?", member=damaged))


def _to_disk(path):
    handle = os.open(path, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def _sweep(folder, name):
    """Removes what a process that was killed while it saved this document left behind."""
    ours = re.compile(r"\.%s\.(\d+)\.FCStd(\.[0-9a-f-]{36})?" % re.escape(name))   # FreeCAD itself writes NAME.UUID first
    left = [(other, ours.fullmatch(other)) for other in os.listdir(folder)]
    _remove([other for other, found in left if found and not os.path.exists("/proc/" + found.group(1))], folder)


def _remove(names, folder):
    for name in names:
        try:
            os.unlink(os.path.join(folder, name))
        except OSError:
            pass  # another user's: it does no harm


def _keep_links(path, source, folder):
    """Lets the links to other documents of a copy lead where they led from the folder `source`; FreeCAD writes the same words in each folder."""
    with zipfile.ZipFile(path) as archive:
        written = archive.read("Document.xml")
        members = [] if source == folder or not _LINK.search(written) else [(member, archive.read(member)) for member in archive.infolist()]
    if members:
        def moved(found):
            place = os.path.relpath(os.path.join(source, unescape(found[2].decode(), _QUOTES)), folder)
            return found[1] + escape(place, {value: name for name, value in _QUOTES.items()}).encode()
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
            for member, content in members:
                archive.writestr(member, _LINK.sub(moved, written) if member.filename == "Document.xml" else content, zipfile.ZIP_DEFLATED)

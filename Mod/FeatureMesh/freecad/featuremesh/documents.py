# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens and saves documents so that a bad file gets a clear message and a good one is never left half written."""

import os
import re
import zipfile

import FreeCAD

from .errors import UserError


def open_document(path):
    """Opens the .FCStd file hidden. Throws UserError: missing, not a document, damaged."""
    if not os.path.isfile(path):
        raise UserError("there is no file %s" % path)
    if not zipfile.is_zipfile(path):
        raise UserError("%s is not a FreeCAD document (or its end is cut off)" % path)
    try:
        with zipfile.ZipFile(path) as archive:
            if "Document.xml" not in archive.namelist():
                raise UserError("%s is not a FreeCAD document: it has no Document.xml" % path)
            damaged = archive.testzip()
    except (zipfile.BadZipFile, OSError, EOFError, ValueError, NotImplementedError) as error:
        raise UserError("%s is damaged: %s" % (path, error)) from error
    except Exception as error:
        if type(error).__name__ == "error" and type(error).__module__ == "zlib":
            raise UserError("%s is damaged: %s" % (path, error)) from error
        raise
    if damaged:
        raise UserError("%s is damaged: %s in it cannot be read" % (path, damaged))
    try:
        return FreeCAD.openDocument(path, True)
    except Exception as error:
        raise UserError("FreeCAD cannot open %s: %s" % (path, error)) from error


def save_document(document, path):
    """Saves a copy to `path`, whole or not at all; what the document shows (colours, views) is taken from its file."""
    folder = os.path.dirname(os.path.abspath(path))
    if not os.path.isdir(folder):
        raise UserError("cannot write %s: there is no folder %s" % (path, folder))
    temporary = os.path.join(folder, ".%s.%d.FCStd" % (os.path.basename(path), os.getpid()))
    try:
        document.saveCopy(temporary)
        if not FreeCAD.GuiUp and document.FileName and os.path.isfile(document.FileName):
            _take_over_view(document.FileName, temporary)
        with zipfile.ZipFile(temporary) as archive:
            if "Document.xml" not in archive.namelist():
                raise OSError("FreeCAD wrote no document")
        with open(temporary, "rb") as stream:
            os.fsync(stream.fileno())
        os.replace(temporary, path)
    except Exception as error:
        if isinstance(error, (OSError, zipfile.BadZipFile, RuntimeError)):
            raise UserError("cannot write %s: %s" % (path, error)) from error
        raise
    finally:
        if os.path.exists(temporary):
            os.unlink(temporary)


def _take_over_view(source, target):
    """Copies the view's part of the document, which FreeCAD without a window leaves out, into `target`."""
    with zipfile.ZipFile(source) as old, zipfile.ZipFile(target, "a", zipfile.ZIP_DEFLATED) as new:
        present = set(new.namelist())
        if "GuiDocument.xml" in present or "GuiDocument.xml" not in old.namelist():
            return
        view = old.read("GuiDocument.xml")
        wanted = [name for name in re.findall(r'file="([^"]+)"', view.decode("utf-8", "replace")) if name]
        if any(name in present for name in wanted):
            return  # a file of the model took the name; colours are worth less than a document that opens
        new.writestr("GuiDocument.xml", view)
        for name in dict.fromkeys(wanted + ["thumbnails/Thumbnail.png"]):
            if name in old.namelist():
                new.writestr(name, old.read(name))

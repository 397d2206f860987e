# SPDX-License-Identifier: GPL-3.0-or-later
"""What a document shows (colours, views), which FreeCAD without a window leaves out when it saves: it opens such a document with everything hidden."""

import contextlib
import importlib.util
import os
import re
import shutil
import zipfile
from xml.etree import ElementTree
from xml.sax.saxutils import quoteattr

import FreeCAD

from . import analyses, reading, versions

_FROM_THE_CORNER = 1, -1, 1
_OTHER_VIEWS = {"MeshResult": "VPFemMeshResult", "ConstraintElectrostaticPotential": "VPConstraintElectroStaticPotential"}   # than "VP" and the object's class
_TURNED_TO_IT = "0.742906 0.307722 0.594473 1.21713"   # axis and angle of FreeCAD's isometric view
_files = {}   # name of a document -> the file that it was opened from or saved in last
_before = {}   # name of a document that is being saved -> that file, open


def note_file(document):
    """To be called when the document was opened or saved, before *Save As* gives it another file."""
    _files[document.Name] = document.FileName


def keep(document):
    """To be called before FreeCAD saves the document. Windows lets nobody replace a file that is open, so there the colours are lost."""
    if not FreeCAD.GuiUp and os.name != "nt":
        _before[document.Name] = open_file(_files.get(document.Name, ""))


def put_back(document, path):
    """To be called when FreeCAD has saved the document there: the file is replaced by one that has what it shows. Where a disk is full, or the old file damaged, it
    stays."""
    with _before.pop(document.Name, contextlib.nullcontext()) as old, contextlib.suppress(OSError, zipfile.BadZipFile):
        if FreeCAD.GuiUp or path != document.FileName or not zipfile.is_zipfile(path):
            return
        note_file(document)
        file = os.path.realpath(path)
        temporary = temporary_beside(file)
        try:
            shutil.copy(file, temporary)
            add(document, temporary, old)
            os.replace(temporary, file)
        finally:
            with contextlib.suppress(FileNotFoundError):
                os.unlink(temporary)


def temporary_beside(file):
    """The path of what is to take that file's place. What a process leaves there that is killed is swept by documents.save_document."""
    folder, name = os.path.split(file)
    return os.path.join(folder, ".%s.%d.FCStd" % (name, os.getpid()))


def open_file(path):
    """A document's file as it is now, whatever takes its place, as a context; None where there is none."""
    return zipfile.ZipFile(path) if zipfile.is_zipfile(path) else contextlib.nullcontext()


def add(document, path, old):
    """Adds to the document in the file `path` what it shows, where that is missing: as in `old`, which open_file gave, else the meshes, or the parts."""
    with zipfile.ZipFile(path, "a", zipfile.ZIP_DEFLATED) as new:
        if "GuiDocument.xml" in new.namelist():
            return
        if old is not None and "GuiDocument.xml" in old.namelist():
            _copy_view(old, new, document)
        else:
            new.writestr("GuiDocument.xml", _plain_view(document))


def _shown(document):
    """Names of what a person wants to see first: the meshes, or without one the finished parts; loads and supports."""
    shown = [obj for obj in document.Objects if obj.isDerivedFrom("Fem::FemMeshObject")]
    if not shown:
        shown = reading.final_parts(document)
        shown += [part.Tip for part in shown if getattr(part, "Tip", None) is not None]   # a body is drawn through its tip
    shown += [obj for obj in document.Objects if analyses.is_analysis(obj) or obj.isDerivedFrom("Fem::Constraint")]
    return [obj.Name for obj in shown]


def _copy_view(old, new, document):
    view = old.read("GuiDocument.xml")
    wanted = [name for name in re.findall(r'file="([^"]+)"', view.decode("utf-8", "replace")) if name]
    if any(name in new.namelist() for name in wanted):
        return  # a file of the model took the name; colours are worth less than a document that opens
    new.writestr("GuiDocument.xml", _with_new_meshes(view, document))
    for name in dict.fromkeys(wanted + ["thumbnails/Thumbnail.png"]):
        if name in old.namelist():
            new.writestr(name, old.read(name))


def _with_new_meshes(view, document):
    """The view, in which meshes that it does not know are shown and their parts hidden, as two things in one place flicker; and with FEM's new objects."""
    known = set(re.findall(r'<ViewProvider name="([^"]+)"', view.decode("utf-8", "replace")))
    fresh = [obj for obj in document.Objects if (obj.isDerivedFrom("Fem::FemMeshObject") or _view_of_fem(obj)) and obj.Name not in known]
    if not fresh:
        return view
    root = ElementTree.fromstring(view)
    providers = root.find("ViewProviderData")
    for obj in fresh:
        is_mesh = obj.isDerivedFrom("Fem::FemMeshObject")
        part = versions.part_of(obj) if is_mesh else None
        for value in root.findall("ViewProviderData/ViewProvider[@name='%s']/Properties/Property[@name='Visibility']/Bool"
                                  % (part.Name if part is not None else "")):
            value.set("value", "false")
        providers.append(ElementTree.fromstring(_provider(obj, is_mesh)))
    providers.set("Count", str(len(providers)))
    return ElementTree.tostring(root, encoding="utf-8", xml_declaration=True)


def _provider(obj, is_visible):
    properties = ['<Property name="Visibility" type="App::PropertyBool"><Bool value="%s"/></Property>' % str(is_visible).lower()]
    if _view_of_fem(obj):
        properties.append('<Property name="Proxy" type="App::PropertyPythonObject"><Python value="bnVsbA==" encoded="yes" module="%s" class="%s"/></Property>'
                          % _view_of_fem(obj))
    return '<ViewProvider name="%s" expanded="0"><Properties Count="%d">%s</Properties></ViewProvider>' % (obj.Name, len(properties), "".join(properties))


def _view_of_fem(obj):
    """(module, class) of the view that FEM gives an object of its own that it makes in a window, and which opens its panel; None for other objects."""
    kind = type(getattr(obj, "Proxy", None))
    package, _, name = kind.__module__.partition(".")
    module = "femviewprovider.view_" + name
    if package != "femobjects" or importlib.util.find_spec(module) is None:
        return None
    return module, _OTHER_VIEWS.get(kind.__name__, "VP" + kind.__name__)


def _camera(document):
    """The settings of FreeCAD's camera that look at all parts from the corner in front, on the right and above; "" without a part."""
    box = FreeCAD.BoundBox()
    for part in reading.final_parts(document):
        box.add(part.Shape.BoundBox)
    if not box.isValid() or box.DiagonalLength == 0:
        return ""
    distance = box.DiagonalLength
    place = box.Center + FreeCAD.Vector(*_FROM_THE_CORNER) * (distance / 3 ** 0.5)
    return ("OrthographicCamera {\n  viewportMapping ADJUST_CAMERA\n  position %.9g %.9g %.9g\n  orientation %s\n  nearDistance 0\n  farDistance %.9g\n"
            "  aspectRatio 1\n  focalDistance %.9g\n  height %.9g\n}\n" % (*place, _TURNED_TO_IT, 2 * distance, distance, distance))


def _plain_view(document):
    """A view in which what a person wants to see first is shown, and nothing else."""
    visible = _shown(document)
    providers = [_provider(obj, obj.Name in visible) for obj in document.Objects if obj.Name in visible or _view_of_fem(obj)]
    return ('<?xml version="1.0" encoding="utf-8"?>\n<Document SchemaVersion="1"><ViewProviderData Count="%d">%s'
            '</ViewProviderData><Camera settings=%s/></Document>\n' % (len(providers), "".join(providers), quoteattr(_camera(document))))

# SPDX-License-Identifier: GPL-3.0-or-later
"""Shows a part in place of its meshes, or the other way round: in one place they would flicker, and hide the faces that are selected."""

import FreeCAD
from PySide import QtCore

from .. import analyses, api, assembled, versions
from ..live_result import is_live_result
from ..mesh_object import is_feature_mesh

_DRAWN_BY_FEM = ("Fem::FemMeshObject", "Fem::FemPostObject")   # meshes, those of results too, and pipelines


def show_part(part):
    """Shows the part and hides its meshes. Returns what `restore` needs to take that back."""
    shown = {part: True}
    shown.update((mesh, False) for mesh in api.meshes_of(part.Document) if versions.part_of(mesh) is part)
    before = [(obj.Document.Name, obj.Name, obj.ViewObject.Visibility) for obj in shown]
    for obj, visible in shown.items():
        obj.ViewObject.Visibility = visible
    return before


def show_to_click(obj):
    """Shows the parts whose faces the panel of an FEM object asks for where their meshes are seen in their place, or nothing: some panels of FEM hide all
    meshes. Returns what `restore` needs to show the meshes again."""
    before = []
    for mesh in api.meshes_of(obj.Document):
        for shown in _meshed(mesh)[-1:]:   # of assembled parts what they are in
            if not shown.ViewObject.Visibility and _is_about(obj, mesh):
                shown.ViewObject.Visibility, mesh.ViewObject.Visibility = True, False
                before += [(obj.Document.Name, shown.Name, False), (obj.Document.Name, mesh.Name, True)]
    return before


def show_elements(mesh):
    """Shows the mesh, and hides what would cover its elements. Returns what `restore` needs."""
    covers = what_covers(mesh)
    before = [(obj.Document.Name, obj.Name, obj.ViewObject.Visibility) for obj in (*covers, mesh)]
    _set_visible(covers, False)
    mesh.ViewObject.Visibility = True
    return before


def what_covers(mesh):
    """What lies where the mesh does: what it is of, other meshes of that, and results."""
    return [*_meshed(mesh), *(obj for obj in mesh.Document.Objects if _may_cover(obj, mesh))]


def restore(before):
    """Makes visible and hides what was so before, as far as it is still there."""
    for document_name, name, visible in before:
        document = FreeCAD.listDocuments().get(document_name)
        obj = document.getObject(name) if document is not None else None
        if obj is not None:
            obj.ViewObject.Visibility = visible


def show_mesh(mesh):
    """Shows the mesh and hides what it is of."""
    _set_visible(_meshed(mesh), False)
    mesh.ViewObject.Visibility = True


def show_result(live):
    """Shows a live result and hides what would cover it."""
    mesh = live.Proxy.mesh(live)
    if mesh is not None:
        _set_visible([mesh, *what_covers(mesh)], False)
    live.ViewObject.Visibility = True


def install():
    """Lets parts be seen again whose mesh is gone."""
    FreeCAD.addDocumentObserver(_Observer())


class _Observer:
    """Undo and deletion take a mesh away and leave its part hidden, so that nothing would be seen; when the mesh is back, the part is hidden again."""

    def __init__(self):
        self._shown = {}   # (name of a document, name of a mesh that is gone) -> names of what is shown in its place

    def slotDeletedObject(self, obj):
        if is_feature_mesh(obj) and obj.Visibility:
            names = [part.Name for part in _meshed(obj) if not part.Visibility]
            place = obj.Document.Name, obj.Name
            QtCore.QTimer.singleShot(0, lambda: self._show(place, names))   # what is shown belongs to no step of undo

    def slotUndoDocument(self, document):
        name = document.Name   # it may be closed at once
        QtCore.QTimer.singleShot(0, lambda: self._hide(name))

    slotRedoDocument = slotUndoDocument

    def slotDeletedDocument(self, document):
        self._shown = {place: names for place, names in self._shown.items() if place[0] != document.Name}

    def _show(self, place, names):
        document = FreeCAD.listDocuments().get(place[0])
        if document is None or document.getObject(place[1]) is not None:
            return
        parts = [part for part in map(document.getObject, names) if part is not None]
        if not any(mesh.Visibility and set(_meshed(mesh)) & set(parts) for mesh in api.meshes_of(document)):
            _set_visible(parts, True)
            self._shown[place] = names

    def _hide(self, name):
        document = FreeCAD.listDocuments().get(name)
        for place in [place for place in self._shown if place[0] == name and document is not None]:
            if document.getObject(place[1]) is not None:
                _set_visible([part for part in map(document.getObject, self._shown.pop(place)) if part is not None], False)


def _is_about(obj, mesh):
    """Has an FEM object to do with the mesh: a load, a support, a material of its analysis, one of its groups or refinements?"""
    return obj in mesh.MeshRegionList or obj in mesh.MeshGroupList or any(obj in analysis.Group for analysis in analyses.holding(mesh))


def _may_cover(obj, mesh):
    is_of_another = is_feature_mesh(obj) and versions.part_of(obj) is not versions.part_of(mesh)
    return obj is not mesh and not is_of_another and (is_live_result(obj) or any(obj.isDerivedFrom(kind) for kind in _DRAWN_BY_FEM))


def _meshed(mesh):
    """The part of a mesh, and what that shows."""
    part = versions.part_of(mesh)
    shown = [part, part.Container] if part is not None and assembled.is_assembled(part) else [part]
    return [obj for obj in shown if obj is not None]


def _set_visible(objects, visible):
    for obj in objects:
        obj.ViewObject.Visibility = visible

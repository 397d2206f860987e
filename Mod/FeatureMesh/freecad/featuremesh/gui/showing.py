# SPDX-License-Identifier: GPL-3.0-or-later
"""Shows a part in place of its meshes, or the other way round: in one place they would flicker, and hide the faces that are selected."""

import FreeCAD
from PySide import QtCore

from .. import analyses, api, assembled, versions
from ..live_result import has_result, in_document, is_live_result
from ..mesh_object import is_feature_mesh

_POST = "Fem::FemPostObject"   # pipelines and their filters
_DRAWN_BY_FEM = ("Fem::FemMeshObject", _POST)   # meshes, those of results too


def show_part(part):
    """Shows the part and hides its meshes, and results in their place. Returns what `restore` needs to take that back."""
    shown = {part: True}
    for mesh in api.meshes_of(part.Document):
        if versions.part_of(mesh) is part:
            shown.update((obj, False) for obj in (mesh, *_results_over(mesh)))
    before = _as_seen(shown)
    for obj, visible in shown.items():
        obj.ViewObject.Visibility = visible
    return before


def show_to_click(obj):
    """Shows the parts whose faces the panel of an FEM object asks for where their meshes are seen in their place, or nothing: some panels of FEM hide all
    meshes. Returns what `restore` needs to show the meshes again, or the results that were seen in place of them."""
    before = []
    for mesh in api.meshes_of(obj.Document):
        for shown in _to_click_on(mesh):
            covering = [other for other in (*_live_results_of(mesh), *_drawn_of_results(mesh), *_meshed(mesh)) if other is not shown]
            seen = [other for other in covering if other.ViewObject.Visibility]
            is_hidden = not shown.ViewObject.Visibility
            if (is_hidden or seen) and _is_about(obj, mesh):
                back = [other for other in seen if not assembled.is_assembled(other)]   # that was shown by FEM's panel for its time
                if not any(map(_is_seen, back)) and (back or is_hidden):
                    back.append(mesh)
                _set_visible([shown], True)
                _set_visible([mesh, *seen], False)
                before += [(obj.Document.Name, other.Name, other is not shown) for other in ([shown] if is_hidden else []) + back]
    return before


def show_result_mesh(result):
    """Hides what is drawn of results in the place of the mesh that FEM's panel of a result colours. Returns what `restore` needs to show that again, and to hide
    this mesh, which FreeCAD 1.0 and later leave there."""
    above = _analyses_above(result)
    seen = [obj for obj in result.Document.Objects if obj.ViewObject.Visibility and (is_live_result(obj) or obj.isDerivedFrom(_POST)) and above & _analyses_above(obj)]
    before = _as_seen(seen)
    _set_visible(seen, False)
    return before + [(result.Document.Name, result.Mesh.Name, False)] if seen and result.Mesh is not None else before


def show_unless_seen(obj):
    """Shows the mesh that an FEM object belongs to where FEM's panel, which hides meshes and shows parts for its time, has left nothing to see in its place."""
    for mesh in api.meshes_of(obj.Document):
        if _is_about(obj, mesh):
            show_where_nothing_is_seen(mesh)


def show_where_nothing_is_seen(mesh):
    """Shows the mesh where neither it nor anything in its place is seen."""
    if not any(map(_is_seen, (mesh, *what_covers(mesh)))):
        mesh.ViewObject.Visibility = True


def show_elements(mesh):
    """Shows the mesh, and hides what would cover its elements. Returns what `restore` needs."""
    covers = what_covers(mesh)
    before = _as_seen([*covers, mesh])
    _set_visible(covers, False)
    mesh.ViewObject.Visibility = True
    return before


def what_covers(mesh):
    """What lies where the mesh does: what it is of, other meshes of that, and results."""
    return [*_meshed(mesh), *_results_over(mesh)]


def restore(before):
    """Makes visible and hides what was so before, as far as it is still there."""
    for document_name, name, visible in before:
        document = FreeCAD.listDocuments().get(document_name)
        obj = document.getObject(name) if document is not None else None
        if obj is not None:
            obj.ViewObject.Visibility = visible


def show_mesh(mesh):
    """Shows the mesh and hides what it is of, and the results in its place. Returns the names of the live results that were seen."""
    holding = set(analyses.holding(mesh))
    results = [obj for obj in _results_over(mesh) if obj.ViewObject.Visibility and holding & _analyses_above(obj)]
    _set_visible([*_meshed(mesh), *results], False)
    mesh.ViewObject.Visibility = True
    return [live.Name for live in filter(is_live_result, results)]


def show_result(live):
    """Shows a live result and hides what would cover it."""
    mesh = live.Proxy.mesh(live)
    if mesh is not None:
        _set_visible([mesh, *what_covers(mesh)], False)
    live.ViewObject.Visibility = True


def install():
    """Lets parts be seen again whose mesh is gone, and meshes whose live result is gone."""
    FreeCAD.addDocumentObserver(_Observer())


def uncover(live):
    """To be called when a document with a live result was opened: FreeCAD 1.1 shows the mesh of a result with the result then, also where it was hidden, over what
    is seen in its place."""
    mesh, covering = live.Proxy.mesh(live), getattr(live.Result, "Mesh", None)
    seen = [live] if mesh is None else [live, mesh, *what_covers(mesh)]
    if covering is not None and any(obj.Visibility for obj in seen if obj is not covering):
        _set_visible([covering], False)


class _Observer:
    """Undo and deletion take a mesh, a live result or a pipeline away and leave hidden what it was shown in place of, so that nothing would be seen; when it is
    back, that is hidden again."""

    def __init__(self):
        self._shown = {}   # (name of a document, name of what is gone) -> names of what is shown in its place

    def slotDeletedObject(self, obj):
        if obj.Visibility and _mesh_of(obj) is not None or any(live.Visibility for live in _live_results_of(obj)):
            # Undo may have taken away some of these before, and they have no name then.
            choices = [[there.Name for there in obj.Document.Objects if there in hidden] for hidden in _hidden_behind(obj)]
            place = obj.Document.Name, obj.Name
            QtCore.QTimer.singleShot(0, lambda: self._show(place, choices))   # what is shown belongs to no step of undo

    def slotChangedObject(self, obj, name):
        if name not in ("Visibility", "Group") or FreeCAD.isRestoring() or obj.Document.Transacting:
            return
        if name == "Visibility":
            _hide_what_it_covers(obj)
            _show_tip(obj)
        elif analyses.is_analysis(obj) and obj.Group:
            added = obj.Group[-1]
            _hide_what_it_covers(added)
            if added.Visibility and added.isDerivedFrom(_POST):
                _set_visible(filter(is_feature_mesh, obj.Group), False)

    def slotUndoDocument(self, document):
        name = document.Name   # it may be closed at once
        QtCore.QTimer.singleShot(0, lambda: self._hide(name))

    slotRedoDocument = slotUndoDocument

    def slotDeletedDocument(self, document):
        self._shown = {place: names for place, names in self._shown.items() if place[0] != document.Name}

    def _show(self, place, choices):
        document = FreeCAD.listDocuments().get(place[0])
        if document is None or document.getObject(place[1]) is not None:
            return
        hidden = next(filter(None, (_there(document, names) for names in choices)), [])
        covered = set().union(*map(_in_place_of, hidden))
        if not any(obj.Visibility and covered & _in_place_of(obj) for obj in document.Objects):
            _set_visible(hidden, True)
            self._shown[place] = [obj.Name for obj in hidden]

    def _hide(self, name):
        document = FreeCAD.listDocuments().get(name)
        for place in [place for place in self._shown if place[0] == name and document is not None]:
            if document.getObject(place[1]) is not None:
                _set_visible(_there(document, self._shown.pop(place)), False)


def _hide_what_it_covers(obj):
    """Of the live results of an analysis and what FreeCAD draws of its results, in the same place, that is seen which was shown last; of a new result of
    CalculiX there is its bare mesh alone, which FEM's panel of results colours: it would be seen through the next mesh."""
    if obj.isDerivedFrom("Fem::FemResultObject"):
        above = _analyses_above(obj)
        if obj.Mesh is not None and any(other.Visibility and above & _analyses_above(other) for other in obj.Document.Objects
                                        if is_live_result(other) or is_feature_mesh(other)):
            _set_visible([obj.Mesh], False)
        return
    is_drawn = obj.isDerivedFrom(_POST)
    if obj.Visibility and (is_drawn or is_live_result(obj)):
        holding = _analyses_above(obj)
        others = [other for other in obj.Document.Objects if other.Visibility and (is_live_result(other) if is_drawn else other.isDerivedFrom(_POST))]
        _set_visible([other for other in others if holding & _analyses_above(other)], False)


def _show_tip(obj):
    """FreeCAD's panels of patterns leave the tip of a body hidden that was hidden itself, as it is in place of its mesh: nothing of it would be seen."""
    if obj.Visibility and obj.isDerivedFrom("PartDesign::Body") and obj.Tip is not None and any(versions.part_of(mesh) is obj for mesh in api.meshes_of(obj.Document)) \
            and not any(member.Visibility for member in obj.Group if member.isDerivedFrom("PartDesign::Feature")):
        _set_visible([obj.Tip], True)


def _analyses_above(obj):
    return set(filter(analyses.is_analysis, obj.InListRecursive))


def _hidden_behind(obj):
    """What a mesh, a live result, a pipeline or a filter is seen in place of: lists of objects, the one to show first if it is still there."""
    mesh = _mesh_of(obj)
    if mesh is None:
        return []
    parts = [part for part in _meshed(mesh) if not part.Visibility]
    if mesh is obj:
        return [parts]
    results = [[above] for above in obj.InList if above.isDerivedFrom(_POST)] + [[live] for live in _live_results_of(mesh) if has_result(live)]
    return [*(results if obj.isDerivedFrom(_POST) else []), [mesh], parts]


def _live_results_of(mesh):
    """None where it is no mesh of ours."""
    return [live for live in in_document(mesh.Document) if live.Proxy.mesh(live) is mesh]


def _drawn_of_results(mesh):
    """What FreeCAD draws of results of the mesh's analyses: pipelines and their filters."""
    holding = set(analyses.holding(mesh))
    return [obj for obj in mesh.Document.Objects if obj.isDerivedFrom(_POST) and holding & _analyses_above(obj)]


def _mesh_of(obj):
    """The mesh itself, or that of a live result or of a pipeline's analysis; of anything else None."""
    if obj.isDerivedFrom(_POST):
        return next((member for analysis in _analyses_above(obj) for member in analysis.Group if is_feature_mesh(member)), None)
    return obj if is_feature_mesh(obj) else obj.Proxy.mesh(obj) if is_live_result(obj) else None


def _in_place_of(obj):
    """What is drawn in one place with an object."""
    mesh = _mesh_of(obj)
    return {obj} if mesh is None else {obj, mesh, *_meshed(mesh)}


def _there(document, names):
    return [obj for obj in map(document.getObject, names) if obj is not None]


def _is_about(obj, mesh):
    """Has an FEM object to do with the mesh: a load, a support, a material of its analysis, one of its groups or refinements?"""
    return obj in mesh.MeshRegionList or obj in mesh.MeshGroupList or any(obj in analysis.Group for analysis in analyses.holding(mesh))


def _results_over(mesh):
    """And other meshes of what the mesh is of."""
    return [obj for obj in mesh.Document.Objects if _may_cover(obj, mesh)]


def _may_cover(obj, mesh):
    is_of_another = is_feature_mesh(obj) and versions.part_of(obj) is not versions.part_of(mesh)
    return obj is not mesh and not is_of_another and (is_live_result(obj) or any(obj.isDerivedFrom(kind) for kind in _DRAWN_BY_FEM))


def _meshed(mesh):
    """The part of a mesh, and what that shows."""
    part = versions.part_of(mesh)
    shown = [part, part.Container] if part is not None and assembled.is_assembled(part) else [part]
    return [obj for obj in shown if obj is not None]


def _to_click_on(mesh):
    """Of assembled parts what they are in, unless FEM's panels would refuse a click there: "Selected object is not a part!"."""
    meshed = _meshed(mesh)
    return meshed[:1] if any(map(assembled.is_refused_by_fem, meshed)) else meshed[-1:]


def _is_seen(obj):
    """A live result that was never solved shows nothing."""
    return obj.ViewObject.Visibility and (not is_live_result(obj) or obj.ViewObject.Proxy.drawn is not None)


def _as_seen(objects):
    """What `restore` needs to show and hide them as they are now."""
    return [(obj.Document.Name, obj.Name, obj.ViewObject.Visibility) for obj in objects]


def _set_visible(objects, visible):
    for obj in objects:
        obj.ViewObject.Visibility = visible

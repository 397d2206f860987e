# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps mesh objects true to what happens around them: undo and redo, and edits of the analysis they belong to.

FreeCAD's undo does not bring back an old FemMesh, but it does bring back the saved state; so the mesh is made from that. The
groups by which a solver finds the nodes of constraints are renewed when the references of a constraint change.
"""

import itertools

import FreeCAD
import Part

from . import analyses, assembled, disk_room, document_view, error_sizes, hand_over, recompute_errors, references, results, size_zone, statics, versions
from .mesh_properties import EDITED_ELSEWHERE, OUT_OF_DATE, UP_TO_DATE, is_of_its_part
from .reading import dependencies, has_shape

_NAMES = ("Label", "UseLabel")   # by which a mesh group object may call its groups
_WATCHED = ("References", "Suppressed", *references.ALONG, "Group", "MeshGroupList", "MeshRegionList", "Automatic", *_NAMES)
_PLACES = ("Placement", "PlacementList")   # of an object, and of a link with several elements
_observer = None
_deleted = {}   # name of a document -> names of the objects deleted from it
_recomputed = set()   # names of the documents that were recomputed since they were opened
_undone = {}   # name of a document -> names of the objects that undo and redo brought back, and that were neither edited nor recomputed since
_untouched = {}   # name of a document -> names of the meshes and zones that were not touched when its last transaction began
_getting_shape = set()   # (name of a document, name) of the objects that are being given another shape just now
_left_touched = {}   # name of a document -> names of the objects that recomputes left touched, or have come to so far


def watch():
    """Starts watching all documents; further calls do nothing."""
    global _observer
    if _observer is None:
        _observer = _Observer()
        FreeCAD.addDocumentObserver(_observer)
        recompute_errors.watch(_fail_meshes)


def settle(obj):
    """To be called when the task panel of an FEM object was closed: it may have been given other references."""
    for mesh in _meshes_in(obj.Document):
        mesh.Proxy.references_changed(mesh, obj, in_panel=True)


def deleted_of(document):
    """Names of objects that were deleted from the document while it was open."""
    return _deleted.get(document.Name, set())


def new_name(document, wanted):
    """A name like that for an object that is made outside of any step of undo: no object has it, nor had one that undo may bring back. FreeCAD would give both the
    same name, and crash when one of them is deleted."""
    names = itertools.chain([wanted], (wanted + "%03d" % number for number in itertools.count(1)))
    return next(name for name in names if document.getObject(name) is None and name not in deleted_of(document))


def edited_of(document, objects):
    """Those of `objects` that were edited and not recomputed since. What another FreeCAD saved, and what an undo brought back with its shape, counts as
    edited for FreeCAD, though nobody did; where it skips recomputes it is not known who did. What a recompute itself left touched, as it does the joints
    of an assembly that refer to that, was not edited until somebody does."""
    if document.Name not in _recomputed and not versions.wrote(document) and not document.RecomputesFrozen:
        return []
    undone = _undone.get(document.Name, ())
    return [obj for obj in objects if "Touched" in obj.State and obj.Name not in _left_touched.get(obj.Document.Name, ())
            and not (obj.Document is document and obj.Name in undone)]


def edited_behind(mesh):
    """What the part of one of our meshes comes from and was edited since the last recompute."""
    part = versions.part_of(mesh)
    return edited_of(mesh.Document, _all_behind(dependencies(part))) if part is not None else []


def _all_behind(objects):
    """These, and whatever they refer to, such as a spreadsheet by an expression."""
    found = dict.fromkeys(objects)
    waiting = list(found)
    while waiting:
        new = [obj for obj in _directly_behind(waiting.pop()) if obj not in found]
        found.update(dict.fromkeys(new))
        waiting += new
    return found


def _directly_behind(obj):
    """Of what a container holds the joints move its parts; what else is beside these does not change them."""
    return [one for one in obj.OutList if assembled.is_container(one) or hasattr(one, "JointType")] if assembled.is_container(obj) else obj.OutList


class _Observer:

    def slotUndoDocument(self, document):
        _show_states(document)

    slotRedoDocument = slotUndoDocument

    def slotOpenTransaction(self, document, _):
        _getting_shape.clear()
        ours = [*_meshes_in(document), *filter(size_zone.is_zone, document.findObjects("App::GeometryPython")), *error_sizes.in_document(document),
                *filter(assembled.is_assembled, document.findObjects("Part::FeaturePython"))]
        _untouched[document.Name] = [obj.Name for obj in ours if "Touched" not in obj.State]

    def slotAbortTransaction(self, document):
        """FreeCAD takes back what was set, but not its mark that something was."""
        _show_states(document)
        for obj in filter(None, map(document.getObject, _untouched.get(document.Name, ()))):
            obj.purgeTouched()

    def slotStartSaveDocument(self, document, _):
        for mesh in _meshes_in(document):
            if mesh.Proxy.is_behind(mesh) and not edited_behind(mesh):   # of which nothing else is saved
                mesh.Status = OUT_OF_DATE
            mesh.Proxy.keep_state(mesh)
        disk_room.tell_before_saving(document)
        if _meshes_in(document):
            document_view.keep(document)

    def slotFinishSaveDocument(self, document, path):
        if _meshes_in(document):
            disk_room.look_at_saved(document, path)
            document_view.put_back(document, path)

    def slotRecomputedObject(self, obj):
        if obj.Document.Recomputing or any(versions.part_of(mesh) is obj for mesh in _meshes_in(obj.Document)):   # what is recomputed alone tells nobody
            _left_touched.setdefault(obj.Document.Name, set()).add(obj.Name)

    def slotRecomputedDocument(self, document):
        for mesh in _missed_an_edit(document):
            if versions.is_frozen(mesh):
                mesh.Status = OUT_OF_DATE
            else:
                mesh.recompute()
        references.look_again(document)
        for mesh in _meshes_in(document):
            results.mark(mesh)   # an expression may have changed a load
            if not mesh.Automatic:
                mesh.Proxy.members_changed(mesh)   # another mesh of its part has moved its loads
        recomputed = filter(None, map(document.getObject, _left_touched.get(document.Name, ())))
        _left_touched[document.Name] = {obj.Name for obj in recomputed if "Touched" in obj.State}
        _recomputed.add(document.Name)
        _undone.pop(document.Name, None)
        _outdate_in_others(document)

    def slotCreatedObject(self, obj):
        if obj.Name in deleted_of(obj.Document) and not obj.Document.Transacting:
            for mesh in _meshes_in(obj.Document):
                mesh.Proxy.forget_references(mesh, obj.Name)
        _deleted.get(obj.Document.Name, set()).discard(obj.Name)
        _note_if_undone(obj)

    def slotDeletedObject(self, obj):
        _deleted.setdefault(obj.Document.Name, set()).add(obj.Name)

    def slotDeletedDocument(self, document):
        _deleted.pop(document.Name, None)
        _recomputed.discard(document.Name)
        _undone.pop(document.Name, None)
        _left_touched.pop(document.Name, None)
        _untouched.pop(document.Name, None)
        results.forget(document)
        statics.forget(document)

    def slotBeforeChangeObject(self, obj, name):
        if name == "Shape" and obj.isDerivedFrom("Part::Feature"):
            _getting_shape.add((obj.Document.Name, _name_of(obj)))

    def slotChangedObject(self, obj, name):
        if name == "Shape":
            _getting_shape.discard((obj.Document.Name, _name_of(obj)))
        if name == "Data" and results.is_result(obj) and not (FreeCAD.isRestoring() or obj.Document.Recomputing or obj.Document.Transacting):
            results.note_again(obj, from_input=True)   # since 1.1 a solver fills its pipeline anew
        if FreeCAD.isRestoring() or obj.Document.Recomputing:
            return
        for known in (_left_touched, _undone):
            known.get(obj.Document.Name, set()).discard(_name_of(obj))
        _note_if_undone(obj)
        if obj.Document.Transacting or _getting_shape and name in ("References", *references.ALONG):
            return   # since 1.0 FreeCAD lets references follow a shape that a script sets
        results.member_changed(obj, name)
        if name in _PLACES:
            _touch_what_moved_with(obj)
        if name not in _WATCHED:
            return
        if name == "Group" and analyses.is_analysis(obj):
            results.note(obj)
        if name == "References":
            references.note_clicks(obj)
        if name in references.ALONG:
            references.mend_direction(obj)
        for mesh in _meshes_in(obj.Document):
            if name == "References" or name in references.ALONG:
                mesh.Proxy.references_changed(mesh, obj)
            elif name not in _NAMES and (mesh is obj or obj in mesh.InList or analyses.is_analysis(obj) or name == "Automatic"):
                mesh.Proxy.members_changed(mesh)
            if name in ("References", "Suppressed") or name == "Group" and obj in analyses.holding(mesh) or name in _NAMES and obj in mesh.MeshGroupList:
                mesh.Proxy.renew_groups(mesh)


def _note_if_undone(obj):
    """FreeCAD marks what undo and redo bring back as edited, though it comes with its shape, unless recomputes were skipped."""
    if obj.Document.Transacting and not obj.Document.RecomputesFrozen:
        _undone.setdefault(obj.Document.Name, set()).add(_name_of(obj))


def _fail_meshes(document, objects):
    """The mesh of a part that FreeCAD could not recompute is that of the part before the edit."""
    for mesh in _meshes_in(document):
        error = recompute_errors.error_of_part(versions.part_of(mesh), objects)
        if error is not None:
            mesh.Proxy.fail(mesh, error)


def _missed_an_edit(document):
    return [mesh for mesh in _meshes_in(document) if mesh.Proxy.missed_an_edit(mesh)]


def _outdate_in_others(document):
    """FreeCAD tells nobody that what is linked from another document has changed, and recomputes that later."""
    for other in FreeCAD.listDocuments().values():
        for mesh in _meshes_in(other) if other is not document else ():
            if is_of_its_part(mesh) and edited_behind(mesh):
                mesh.Status = EDITED_ELSEWHERE


def _touch_what_moved_with(obj):
    """FreeCAD's Assembly takes its mark that it moved something away, and what is in a container gets none in any case."""
    assembled.touch_if_moved(obj.InListRecursive)
    for mesh in _missed_an_edit(obj.Document) if assembled.is_container(obj) else ():
        mesh.touch()


def _show_states(document):
    assembled.touch_if_moved(document.findObjects("Part::FeaturePython"))
    for mesh in _meshes_in(document):
        mesh.Proxy.show_state(mesh)
        mesh.Proxy.members_changed(mesh, after_undo=True)
        mesh.Proxy.renew_groups(mesh)
        if mesh.Status == UP_TO_DATE and _is_beside_its_part(mesh):
            mesh.Status = OUT_OF_DATE
            mesh.touch()
        results.mark(mesh)
    _outdate_in_others(document)


def _is_beside_its_part(mesh):
    """Was the part, or one of several, or what it is in, moved, which needs no recompute, before something else that is undone now?"""
    part = versions.part_of(mesh)
    if part is None or not has_shape(part):
        return False
    shape = Part.Shape(part.Shape)
    shape.Placement = versions.parent_frame(part).multiply(shape.Placement)
    return assembled.was_moved(part) or not hand_over.lies_on(mesh.Proxy.arrays(mesh), shape)


def _name_of(obj):
    """None of what an undo takes away."""
    try:
        return obj.Name
    except RuntimeError:
        return None


def _meshes_in(document):
    """Those that have all their properties."""
    return [mesh for mesh in analyses.meshes_in(document) if "ReferredTo" in mesh.PropertiesList]

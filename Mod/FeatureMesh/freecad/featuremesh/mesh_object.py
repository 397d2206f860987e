# SPDX-License-Identifier: GPL-3.0-or-later
"""The document object: a FEM mesh that depends on a part and follows its edits."""

import json
import os
import time

import FreeCAD
import Fem

from . import adopt, analyses, assembled, chosen_solids, contact_faces, copied_part, document_view, engine, given_mesh, groups_by_name, hand_over, history, loaded_places
from . import log, mesh_properties, messages, mixed_elements, recompute_errors, references, refinements, results, rigid_bodies, shell_fluxes, solve_guard, state
from . import state_property, too_fine, versions
from .errors import EngineMissing, FailedUpdate, StateError, UserError
from .given_mesh import give
from .job import MeshJob
from .lost_references import LostReferences
from .messages import said
from .mesh_properties import (AUTOMATIC_SHARE, CANCELLED, FAILED, FROM_SHAPE, NOT_MESHED, OPTION_OF, OUT_OF_DATE, SETTINGS_CHANGED, UP_TO_DATE, as_in_documents, choose_form,
                              differ_from_mesh, failed, failure_of, has_all_elements, is_of_its_part, is_saved_for_freecad, remarks_on_form, settings_of,
                              show_report, status_after, status_in_words)
from .noted_parts import NotedParts
from .numbering import Numbering
from .proxies import Stateless
from .reading import describe, elements_of_today, has_shape, read_document, refuse_gone, shape_of_record, with_elements
from .refusals import no_part, part_to_mesh, refuse_no_size
from .reports import add_fallback, news_of, plain, remarks_of
from .resolving import CLICKED, Resolver
from .same_shape import are_the_same
from .user_words import in_words

translate = FreeCAD.Qt.translate
# Called with every mesh object that was made or opened; the window's side adds its view there.
on_ready = []
# Runs a MeshJob while FreeCAD recomputes, where the window's side wants to show progress; None: just run it.
run_job = None
# Called with a mesh object and the PartMesh that it is about to show, when references were moved to it: what needs no FemMesh can begin.
on_new_mesh = []

_HIGHEST_TARGET = 45   # degrees; no mesh reaches more


class FeatureMesh(Stateless):
    """Proxy of the mesh object. Its class path is stored in documents and never changes."""

    Type = "Fem::FeatureMesh"
    _is_opened = False   # not before all of its document, or of what is pasted, is there

    def __init__(self, mesh):
        self._is_opened, mesh.Proxy = True, self
        self._forget()
        self._get_ready(mesh)

    def execute(self, mesh):
        """Called by recompute: updates the mesh, or in manual mode only says that it is out of date."""
        if not mesh.Automatic:
            mesh.Status = OUT_OF_DATE if mesh.SavedState else NOT_MESHED
            return
        try:
            self.update(mesh)
        except Exception as error:
            message = translate("FeatureMesh", CANCELLED) if is_cancelled(error) else in_words(messages.of_error(error))
            log.write_error(error)
            raise FailedUpdate(mesh.Label, message) from None

    def onChanged(self, mesh, name):
        """Called by FreeCAD when a property was set: keeps Status true to the settings."""
        is_set = not FreeCAD.isRestoring() and not mesh.Document.Transacting
        if is_set and "Status" in mesh.PropertiesList and status_after(mesh, name) != mesh.Status:
            mesh.Status = status_after(mesh, name)
        if is_set and name == "Automatic" and mesh.Automatic and getattr(mesh, "Status", UP_TO_DATE) != UP_TO_DATE:
            mesh.touch()
        if is_set and name in ("Status", "SavedState") and "SavedState" in mesh.PropertiesList:
            results.mark(mesh)
        if name in ("SavedForFreeCAD", "TetCount") and "TetCount" in mesh.PropertiesList:
            for shown in [mesh, *analyses.shares_of(mesh)]:
                choose_form(shown, is_saved_for_freecad(mesh))
        if not self._is_opened:
            given_mesh.set_aside(mesh)

    def onDocumentRestored(self, mesh):
        self._is_opened = True
        with given_mesh.Opened(mesh) as opened:
            self._forget()
            self._get_ready(mesh)
            self._miss_the_engine(mesh)
            state_property.have_own(mesh)
            self._shown = state.checksum_of(mesh.SavedState)
            if mesh.SavedState:
                self._restore(mesh, opened)
        if mesh.Automatic and mesh.Status == OUT_OF_DATE:
            mesh.touch()   # it was saved behind its part

    def loads(self, saved):
        self._forget()

    def update(self, mesh, full=False, progress=None):
        """Meshes the part, locally where the last state allows it (never with `full`). Returns the report. When that fails the old mesh stays, Status says why,
        and the error is raised."""
        return self._carry_out(mesh, lambda: self.prepare(mesh, full), progress)

    def _carry_out(self, mesh, prepare, progress):
        try:
            job = prepare()
            if progress is None and run_job is not None:
                run_job(job)
            else:
                job.run(progress)
            return self.finish(mesh, job)
        except BaseException as error:   # after Ctrl-C, too, it is not the mesh of the part as it is
            self.fail(mesh, error)
            raise

    def renumber(self, mesh):
        """Gives nodes and elements the numbers 1, 2, 3 ... without changing anything else. Returns the largest numbers before. Throws StateError."""
        part_mesh = self.last_part_mesh(mesh)
        saved = state.load(mesh.SavedState)
        before = saved.arrays["counters"][2:4] - 1
        arrays = hand_over.renumbered(part_mesh.arrays())
        job = MeshJob(saved.raw if self._raw is None else self._raw, saved.options, None, None, [])
        job.part_mesh = engine.load().restore_part(saved.raw, saved.options, arrays)
        self._show(mesh, job.part_mesh)
        self._store(mesh, job)
        _show_in_other_analyses(mesh)
        return tuple(before.tolist())

    def adopt(self, mesh, arrays, progress=None):
        """Takes over the mesh of another FEM mesh object, read by adopt.arrays_of, and meshes anew what of it does not fit. Returns the report."""
        def prepare():
            start = time.perf_counter()
            part = versions.part_of(mesh)
            job = adopt.AdoptJob(read_document(part), options_of(mesh, part), arrays)
            job.shape, job.frame, job.settings = part.Shape, versions.parent_frame(part), settings_of(mesh)
            job.seconds = {"document": time.perf_counter() - start, "restore": 0.0}
            return job

        return self._carry_out(mesh, prepare, progress)

    def prepare(self, mesh, full=False):
        """Reads what the engine needs from the document. Throws UserError."""
        start = time.perf_counter()
        part = part_to_mesh(mesh)
        raw = read_document(part)
        old, saved, problem = self._old(mesh)
        if full:
            old = saved = problem = None   # but what it was made from is known now, so that references can be followed
        self._lost.keep(self._shown)
        moved = []
        if mesh.MeshRegionList and self._raw is not None:
            with references.not_touched(mesh.MeshRegionList):
                moved = self._follow(mesh, mesh.MeshRegionList, raw, lambda: engine.load().followed_faces(self._raw, raw))
            self.note_references(mesh, mesh.MeshRegionList, raw)
        refined = refinements.read(mesh, part, raw)
        job = MeshJob(raw, options_of(mesh, part, raw, refined), old, problem, [*recompute_errors.remarks(part), *moved, *refined.notes])
        job.saved, job.shape, job.frame, job.settings = saved, part.Shape, versions.parent_frame(part), settings_of(mesh)
        job.part_of = assembled.part_of_solids(part)
        if old is None:
            job.next_numbers = state_property.next_numbers(mesh, state_is_sound=problem is None and (
                saved is None or hand_over.has_as_many(mesh.FemMesh, saved.arrays)))
        job.seconds = {"document": time.perf_counter() - start, "restore": 0.0}
        return job

    def finish(self, mesh, job):
        """Hands a job's mesh over to FreeCAD and saves its state. Returns the report."""
        start = time.perf_counter()
        report = self._report_with_references(mesh, job)
        known = remarks_of(json.loads(mesh.Report or "{}")) + list(self._elsewhere.values())
        for line in news_of(report, known):
            FreeCAD.Console.PrintWarning("%s: %s\n" % (mesh.Label, in_words(line)))
        for analysis in analyses.holding(mesh):
            results.note(analysis)   # of a document from before results were noted: on the mesh as it was
        for hook in on_new_mesh:
            hook(mesh, job.part_mesh)
        fem_mesh = self._fem_mesh(mesh, job.part_mesh, job.raw)
        handed_over = time.perf_counter()
        self._store(mesh, job)   # first, so that a full disk leaves the old mesh with its old state
        give(mesh, fem_mesh, hand_over.skin(mesh, job.part_mesh.arrays()))
        self._shape, self._frame = job.shape, job.frame
        self.note_references(mesh, self._referring(mesh), job.raw, anew=True)
        job.seconds.update(hand_over=handed_over - start, state=time.perf_counter() - handed_over)
        job.seconds["total"] = sum(job.seconds.values())
        del job.seconds["engine"]
        report["seconds"] = {**report.get("seconds", {}), **job.seconds}
        report["settings"] = job.settings
        show_report(mesh, report)
        mesh.Status = SETTINGS_CHANGED if differ_from_mesh(mesh, settings_of(mesh)) else UP_TO_DATE
        _show_in_other_analyses(mesh)
        return report

    def take_over(self, mesh, job, shown_by):
        """Like finish, for a document that is never saved: no state is written, and FemMesh is that of the objects `shown_by` alone. Returns the report."""
        report = self._report_with_references(mesh, job)
        for shown in shown_by:
            give(shown, self._fem_mesh(mesh, job.part_mesh, job.raw, shown))
        self._part_mesh, self._raw, self._shape, self._frame = job.part_mesh, job.raw, job.shape, job.frame
        mesh.Status = UP_TO_DATE
        return report

    def _report_with_references(self, mesh, job):
        """The job's report, after references were moved with their faces."""
        report = plain(job.report)
        if job.problem:
            add_fallback(report, said("meshed from scratch: {why:messages}", why=job.problem))
        with references.not_touched([*mesh.MeshRegionList, *mesh.MeshGroupList]):
            behind = analyses.left_behind(mesh) if self._raw is None else []
            moved = job.remarks + [line for other in behind for line in other.Proxy.catch_up(other, job.raw)]
            moved += self._follow(mesh, analyses.followed_by(mesh), job.raw, lambda: self._followed_faces(job))
            report["warnings"] = report.get("warnings", []) + moved
            self.settle(mesh, self._referring(mesh), job.raw)
        report["warnings"] += self._what_is_elsewhere(mesh, analyses.dependents_of(mesh), job.raw).values()
        report["warnings"] += hand_over.remarks_on_groups(job.part_mesh, mesh, job.raw) + remarks_on_form(mesh, report)
        return report

    def catch_up(self, mesh, raw):
        """Lets references go with edits that the mesh has not followed, to `raw`: another mesh of the part begins with that. Returns what was done."""
        try:
            self._load(mesh)
        except StateError:
            return []
        objects = [obj for obj in map(mesh.Document.getObject, self._record(mesh)) if obj is not None and references.is_left_behind(obj)]
        lines = self._follow(mesh, objects, raw, lambda: engine.load().followed_faces(self._raw, raw))
        self.note_references(mesh, objects, raw)
        return lines

    def fail(self, mesh, error):
        """Says why there is no new mesh; the old one stays."""
        mesh.Status = CANCELLED if is_cancelled(error) else failed(mesh, error)

    def why_not_to_solve(self, mesh):
        """Why no analysis must be solved on the mesh as it is, as a sentence; "" when it may."""
        if versions.part_of(mesh) is None:
            return in_words(no_part(mesh))
        status = OUT_OF_DATE if self.is_behind(mesh) else mesh.Status
        if status == UP_TO_DATE:
            return ""
        if status.startswith(FAILED):
            return translate("FeatureMesh", "%s is not that of the part as it is, its last update failed: %s") % (describe(mesh), in_words(failure_of(mesh)))
        return translate("FeatureMesh", "%s is %s; update it before solving") % (describe(mesh), status_in_words(mesh, status))

    def is_behind(self, mesh):
        """Is the mesh not that of its part as it is, without a word from FreeCAD? It recomputes a part alone, too."""
        part = versions.part_of(mesh) if is_of_its_part(mesh) and self._shape is not None else None
        if part is not None and are_the_same(part.Shape, self._shape):
            self._shape = part.Shape   # to look no further the next time
        return part is not None and not (part.Shape.isSame(self._shape) and versions.are_same_place(versions.parent_frame(part), self._frame))

    def missed_an_edit(self, mesh):
        """The same where no recompute tells it: one of them is frozen, or what the part is in was moved."""
        part = versions.part_of(mesh)
        return self.is_behind(mesh) and (part.Shape.isSame(self._shape) or any(map(versions.is_frozen, (part, mesh))))

    def clicked_elsewhere(self, mesh, members):
        """Which member of an analysis was clicked on another copy than the meshed one, as a sentence; "" when none was. FreeCAD's writer of CalculiX input
        goes by the original's place and would load whichever copy lies there."""
        clicked = [obj for obj in members if getattr(obj, CLICKED, None)]
        return next((in_words(line) for line in self._what_is_elsewhere(mesh, clicked, self._raw).values()), "") if clicked else ""

    def state_of_mesh(self, mesh):
        """What tells the mesh from others, whether or not it is that of its part; "" where there is none."""
        return state.checksum_of(mesh.SavedState) if mesh.SavedState else ""

    def state_of_part(self, mesh):
        """The same when the mesh is that of its part as it is, else ""."""
        return self.state_of_mesh(mesh) if is_of_its_part(mesh) and not self.is_behind(mesh) else ""

    def keep_state(self, mesh):
        """To be called before the document is saved: FreeCAD saves nothing of it where the file of the state is gone."""
        is_at_hand = self._part_mesh is not None and self._checksum == mesh.StateName
        state_property.keep(mesh, state.State(self._raw, self._options, self._part_mesh.arrays()) if is_at_hand else None)

    def last_part_mesh(self, mesh):
        """The engine's mesh as it is now, from memory or from the saved state. Throws StateError."""
        checksum = state.checksum_of(mesh.SavedState)
        if not self._has_in_memory(checksum):
            saved = self._load(mesh)
            self._part_mesh = engine.load().restore_part(saved.raw, saved.options, saved.arrays)
            self._checksum, self._options = checksum, saved.options
        return self._part_mesh

    def arrays(self, mesh):
        """The arrays of the mesh as it is now (see PartMesh.arrays). Throws StateError."""
        if self._part_mesh is not None and state.checksum_of(mesh.SavedState) == self._checksum:
            return self._part_mesh.arrays()
        return state.load(mesh.SavedState).arrays

    def show_state(self, mesh):
        """Makes FemMesh what the saved state says, after undo or redo brought back another one."""
        state_property.bring_back(mesh)
        checksum = state.checksum_of(mesh.SavedState)
        if checksum == self._shown:
            return
        self._lost.go_back(self._shown, checksum)
        if not checksum:
            give(mesh, Fem.FemMesh())
            if mesh.StateName:
                mesh.Status = failed(mesh, StateError(said("the document holds no mesh state")))
        else:
            try:
                self._show(mesh, self.last_part_mesh(mesh))
            except (RuntimeError, UserError) as error:
                mesh.Status = failed(mesh, error)
                FreeCAD.Console.PrintError("%s: %s\n" % (mesh.Label, messages.english(messages.of_error(error))))
                return
        self._shown = checksum
        _show_in_other_analyses(mesh)
        part = versions.part_of(mesh) if is_of_its_part(mesh) else None
        self._shape, self._frame = (part.Shape, versions.parent_frame(part)) if part is not None else (None, None)

    def settle(self, mesh, objects, raw=None):
        """Lets those of `objects` that have to do with this mesh refer to its part, not to what the part is made of. `raw` is the part as it was
        read, if it was."""
        part, referring = versions.part_of(mesh), self._referring(mesh)
        if part is None or self._following:
            return
        self._following = True
        try:
            references.settle([obj for obj in objects if obj in referring], Resolver(part, raw))
        finally:
            self._following = False

    def references_changed(self, mesh, obj, in_panel=False):
        """To be called when an object was given other references, with `in_panel` when its panel was closed."""
        known = self._record(mesh).get(obj.Name)
        if self._following or obj not in self._referring(mesh) or not mesh.SavedState:
            return
        deleted = history.deleted_of(mesh.Document)
        if known and (not in_panel and references.are_set_again(obj, known, deleted)
                      or references.lost_by_deletion(known, deleted) and not references.was_changed_by_hand(obj, known, deleted)):
            return
        self._lost.chosen_anew(obj)
        references.mend(obj)
        self.settle(mesh, [obj])
        self.note_references(mesh, [obj])
        self._tell_what_is_elsewhere(mesh, [obj])

    def members_changed(self, mesh, after_undo=False):
        """To be called when other objects belong to the mesh or its analysis, or when an undo or redo may have changed what they refer to."""
        if self._following or not mesh.SavedState or versions.part_of(mesh) is None:
            return
        record, deleted, differs = self._record(mesh), history.deleted_of(mesh.Document), references.differs if after_undo else references.was_changed_by_hand
        new = [obj for obj in self._referring(mesh) if obj.References and (obj.Name not in record or differs(obj, record[obj.Name], deleted))]
        if left := self._noted.left_by_undo(mesh, record, new) if after_undo and has_shape(versions.part_of(mesh)) else {}:
            new += [obj for obj in self._referring(mesh) if obj.Name in left and obj not in new]
            mesh.ReferredTo, raw = json.dumps({**record, **left}, sort_keys=True), read_document(versions.part_of(mesh))
            self._follow(mesh, [obj for obj in new if obj.Name in left], raw, lambda: engine.load().followed_faces(self._raw, raw))
        if new:
            self.settle(mesh, new)
            self.note_references(mesh, new)
            self._tell_what_is_elsewhere(mesh, new)

    def _tell_what_is_elsewhere(self, mesh, objects):
        """Says once which of the objects refer to something else than the part; those in a task panel when it is closed."""
        lines = self._what_is_elsewhere(mesh, objects, self._raw)
        for name, line in lines.items():
            if self._elsewhere.get(name) != line:
                FreeCAD.Console.PrintWarning("%s: %s\n" % (mesh.Label, in_words(line)))
        names = [obj.Name for obj in objects]
        self._elsewhere = {**{name: line for name, line in self._elsewhere.items() if name not in names}, **lines}

    def _what_is_elsewhere(self, mesh, objects, raw):
        """references.elsewhere of those objects that are no refinements, which are refused, and in no task panel."""
        own = analyses.dependents_of(mesh)
        known = [obj for obj in objects if obj in own and hasattr(obj, "References") and obj not in mesh.MeshRegionList and not references.is_being_edited(obj)]
        return references.elsewhere(known, Resolver(versions.part_of(mesh), raw))

    def forget_references(self, mesh, name):
        """To be called when another object got the name of one that was deleted."""
        record = self._record(mesh)
        self._lost.forget(name)
        if record.pop(name, None):
            mesh.ReferredTo = json.dumps(record, sort_keys=True)

    def note_references(self, mesh, objects, raw=None, anew=False):
        """Puts on record what objects refer to now; `raw` is the part as it is now, if it was read. With `anew` nothing else stays on record."""
        part = versions.part_of(mesh)
        is_as_meshed = self._shape is not None and part.Shape.isPartner(self._shape)
        if not is_as_meshed and raw is None:
            if not has_shape(part):
                return   # there is nothing to refer to
            raw = read_document(part)
        found = references.record_of([obj for obj in objects if hasattr(obj, "References")], Resolver(part, raw or self._raw))
        if not is_as_meshed:
            found = {name: {**known, "of": self._noted.name_of(raw)} for name, known in found.items()}
        record = {} if anew else {name: known for name, known in self._record(mesh).items() if name not in [obj.Name for obj in objects]}
        mesh.ReferredTo = json.dumps({**record, **found}, sort_keys=True)
        self._noted.store(mesh, {**record, **found}, self._raw)

    def groups_as_saved(self, mesh, arrays, shown_by):
        """The groups of the saved mesh with those arrays, for itself or another object that it is `shown_by`; those of features only where the engine is."""
        try:
            return hand_over.groups_of(arrays, lambda: self.last_part_mesh(mesh).owners_of_tets(), mesh, analysis_of=shown_by)
        except EngineMissing:   # which was said
            return hand_over.groups_of(arrays, list, mesh, analysis_of=shown_by)

    def renew_groups(self, mesh):
        """Makes the groups of constraints, materials and mesh group objects anew, without touching the mesh."""
        part = versions.part_of(mesh)
        if part is None or not mesh.FemMesh.NodeCount or not self._shown or self._following:
            return
        try:
            arrays = self.arrays(mesh)
        except StateError as error:
            FreeCAD.Console.PrintWarning("%s: %s\n" % (mesh.Label, error))
            return
        hand_over.renew_groups(mesh, Resolver(part, self._raw), arrays)
        for shared in analyses.shares_of(mesh):
            shared.Proxy.renew_groups(shared)

    def _old(self, mesh):
        """What to start from: (the engine's mesh, the saved state to make it from, the reason why there is neither), one of the three, none for a first mesh."""
        if self._part_mesh is None and not mesh.SavedState:
            return None, None, (None if not mesh.FemMesh.NodeCount else said("the document holds no mesh state"))
        if self._has_in_memory(state.checksum_of(mesh.SavedState)):
            return self._part_mesh, None, None
        try:
            return None, self._load(mesh), None
        except StateError as error:
            return None, None, messages.of_error(error)

    def _has_in_memory(self, checksum):
        """Is the engine's mesh of the saved state with that checksum at hand?"""
        return checksum == self._checksum and isinstance(self._part_mesh, engine.load().PartMesh)

    def _load(self, mesh):
        """The saved state. Throws StateError."""
        saved, part = state.load(mesh.SavedState), versions.part_of(mesh)
        copied_part.take_todays_names(saved, part)
        if part is not None and saved.part_name != part.Name:
            raise StateError(said("the saved mesh state belongs to {other:text}, not to {part:text}", other=saved.part_name, part=part.Name))
        if self._elements is not None:
            saved.raw = with_elements(saved.raw, self._elements)
        self._raw = saved.raw
        return saved

    def _miss_the_engine(self, mesh):
        """Says when a document is opened that its mesh can only be looked at."""
        try:
            engine.folder()
        except EngineMissing as error:
            FreeCAD.Console.PrintWarning("%s: %s\n" % (mesh.Label, error))

    def _restore(self, mesh, opened):
        """FreeCAD closes the gaps between numbers when it opens a document; the saved state knows the true ones. Sketch elements have other ids."""
        try:
            saved = state.load(mesh.SavedState)
        except StateError as error:
            FreeCAD.Console.PrintWarning("%s: %s\n" % (mesh.Label, error))
            mesh.Status = mesh.Status if has_all_elements(mesh) else failed(mesh, error)
            return
        part = versions.part_of(mesh)
        copied_part.take_todays_names(saved, part)
        self._noted.load(mesh)
        self._elements = elements_of_today(saved.raw, mesh.Document)
        if is_of_its_part(mesh) and part is not None:
            self._shape, self._frame = part.Shape, versions.parent_frame(part)
        if not mesh.ReferredTo:
            mesh.ReferredTo = json.dumps(saved.references)
        if part is not None and has_shape(part):
            self._note_what_is_not_known(mesh)
        mesh.StateName = self._shown
        opened.fem_mesh = hand_over.reopened(mesh.FemMesh, saved.arrays, lambda: self.groups_as_saved(mesh, saved.arrays, mesh))
        opened.skin = hand_over.skin(mesh, saved.arrays)
        mesh.purgeTouched()

    def _note_what_is_not_known(self, mesh):
        """What was pasted or merged is on record with other names; older documents know of no directions."""
        is_copy, record = mesh.Document.Importing, self._record(mesh)
        objects = [obj for obj in self._referring(mesh) if is_copy or references.has_unknown_direction(obj, record.get(obj.Name))]
        if objects or is_copy:
            self.note_references(mesh, objects, anew=is_copy)

    def _show(self, mesh, part_mesh):
        give(mesh, self._fem_mesh(mesh, part_mesh), hand_over.skin(mesh, part_mesh.arrays()))

    def _fem_mesh(self, mesh, part_mesh, raw=None, shown_by=None):
        return hand_over.build(part_mesh.arrays(), hand_over.groups_of(part_mesh.arrays(), part_mesh.owners_of_tets, mesh, raw, shown_by))

    def _referring(self, mesh):
        """Everything whose references are of this mesh's part."""
        return [obj for obj in analyses.followed_by(mesh) + list(mesh.MeshRegionList) if hasattr(obj, "References")]

    def _follow(self, mesh, objects, raw, faces):
        """Moves references with their faces, which `faces()` follows from the last mesh to `raw`. Returns what was done."""
        part, record, lines = versions.part_of(mesh), self._record(mesh), []
        resolver, numberings = Resolver(part, raw), {}

        def numbering_from(then, is_return=True):
            key = id(then), is_return
            if key not in numberings:
                numberings[key] = Numbering(faces() if then is self._raw else engine.load().followed_faces(then, raw),
                                            lambda: shape_of_record(then), part.Shape, is_return)
            return numberings[key]
        self._following = True
        try:
            for obj in objects:
                known = record.get(obj.Name)
                if not known or references.was_changed_by_hand(obj, known, history.deleted_of(mesh.Document)):
                    lines += self._lost.bring_back(obj, resolver, numbering_from)
                    continue
                then = self._noted.part(known["of"]) if "of" in known else self._raw
                if then is None:
                    lines.append(said("{object:text} could not be followed from the last mesh, whose state is gone; check what it refers to",
                                      object=obj.Label))
                    continue
                said_of_it, lost = references.follow(obj, known, resolver, numbering_from(then, is_return=False))
                lines += said_of_it + self._lost.bring_back(obj, resolver, numbering_from)
                self._lost.note(obj, then, lost)
        finally:
            self._following = False
        return lines

    def _followed_faces(self, job):
        """The engine's word for what became of each face since the last mesh."""
        if job.old is None:
            return engine.load().followed_faces(self._raw, job.raw)
        return engine.load().followed_faces(job.old, self._raw, job.part_mesh, job.raw)

    def _record(self, mesh):
        """What references.record_of said at the last mesh, or when references changed since; older documents have names only."""
        return {name: known if isinstance(known, dict) else {"pairs": [[versions.part_of(mesh).Name, sub] for sub in known], "names": known}
                for name, known in json.loads(mesh.ReferredTo or "{}").items()}

    def _store(self, mesh, job):
        saved, before = state.State(job.raw, job.options, job.part_mesh.arrays()), state.checksum_of(mesh.SavedState)
        try:
            checksum = state_property.put(mesh, saved)
            if state.checksum_of(mesh.SavedState) != checksum:
                raise UserError(said("the copy in {folder:text} is not whole", folder=os.path.dirname(mesh.SavedState)))
        except (OSError, RuntimeError, UserError) as error:
            self.note_references(mesh, self._referring(mesh), job.raw)   # they are where the part is, the mesh is not
            raise UserError(said("the new mesh's state cannot be stored ({why:messages}), the old mesh stays; is the disk full?",
                                 why=messages.of_error(error))) from error
        if job.kept_all(saved.arrays):
            results.mesh_is_as_before(mesh, before, checksum)
        self._checksum = self._shown = checksum
        self._part_mesh, self._raw, self._options = job.part_mesh, job.raw, job.options

    def _forget(self):
        self._part_mesh = self._raw = self._options = None   # the engine's mesh, while it is in memory, and what it was made from
        self._shape = self._frame = None   # the part's shape then, and the frame of what it is in
        self._elements = None    # sketch elements of a saved state, with today's ids
        self._noted = NotedParts()   # by which is followed what was chosen after the last mesh
        self._lost = LostReferences()
        self._elsewhere = {}     # by name of an object: what was said of its references that are not on the part
        self._following = False  # references are being moved just now
        self._checksum = ""      # of the saved state that it belongs to
        self._shown = ""         # of the saved state that FemMesh was made from

    def _get_ready(self, mesh):
        mesh_properties.add(mesh)
        history.watch()
        document_view.note_file(mesh.Document)
        for part in (solve_guard, groups_by_name, loaded_places, contact_faces, chosen_solids, mixed_elements, rigid_bodies, shell_fluxes):
            part.install()
        for hook in on_ready:
            hook(mesh)


def _show_in_other_analyses(mesh):
    for shared in analyses.shares_of(mesh):
        shared.Proxy.show(shared)


def is_feature_mesh(obj):
    """Is this one of our mesh objects?"""
    return isinstance(getattr(obj, "Proxy", None), FeatureMesh)


def refuse_other(obj):
    """Throws UserError for what is no mesh object of ours."""
    refuse_gone(obj, said("a mesh of FeatureMesh"))
    if not is_feature_mesh(obj):
        source = analyses.source_of(obj)
        raise UserError(said("{object:text} is no mesh of FeatureMesh", object=describe(obj)) if source is None else
                        said("{object:text} shows the mesh of {mesh:text}; give that one", object=describe(obj), mesh=describe(source)))


def options_of(mesh, part, raw=None, refined=None, settings=None):
    """The engine's options from the object's properties and its refinements, which are read where they are not given; `raw` is the part as it
    was read, if it was, `settings` are values of SETTINGS that count instead of the object's. Throws UserError."""
    values = {**settings_of(mesh), **(settings or {}), "Threads": mesh.Threads}
    options = {option: float(values[name]) for name, option in OPTION_OF.items()}
    if not 0 <= values["QualityTarget"] <= _HIGHEST_TARGET:
        raise UserError(said("the property QualityTarget of {mesh:text} has to lie between 0 and {highest:number} degrees, not {target:number}",
                             mesh=describe(mesh), highest=_HIGHEST_TARGET, target=values["QualityTarget"]))
    refuse_no_size(values["Size"])
    options["threads"] = int(options["threads"]) or os.cpu_count() or 1
    options["order"] = 2 if values["Order"] == "2nd" else 1
    options.update({} if values["Dimension"] == FROM_SHAPE else {"dimension": values["Dimension"].lower()})
    too_fine.refuse_endless(part, values["Dimension"])
    options["min_size"] = options["min_size"] or AUTOMATIC_SHARE * options["size"]
    refined = refined or refinements.read(mesh, part, raw)
    too_fine.refuse_too_fine(part.Shape, options["size"], options["growth"], refined.at_entities())
    return as_in_documents({**options, **refined.options()})


def is_cancelled(error):
    """Did the user end the work? The class of that error is the engine's, which need not be loaded."""
    return type(error).__name__ == "Cancelled" or isinstance(error, KeyboardInterrupt)

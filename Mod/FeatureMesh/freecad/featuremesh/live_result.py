# SPDX-License-Identifier: GPL-3.0-or-later
"""The document object that keeps an analysis solved: after each recompute its result is that of the part as it is."""

import json
import threading
import time

import FreeCAD

from . import analyses, engine, mesh_object, messages, recompute_errors, references, results, solve_guard, state, statics, statics_model, statics_result, user_words
from .errors import StateError, UserError
from .messages import said
from .mesh_properties import UP_TO_DATE, choose_form, failed, is_saved_for_freecad
from .proxies import Stateless, add_missing
from .reading import describe
from .wrapping import wrap

translate = FreeCAD.Qt.translate
# Kept in documents as they are; shown in the user's language by status_in_words.
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
OUT_OF_DATE = QT_TRANSLATE_NOOP("FeatureMesh", "out of date: the part, its mesh or the analysis changed")
SOLVING = QT_TRANSLATE_NOOP("FeatureMesh", "out of date: solving")
CANCELLED = QT_TRANSLATE_NOOP("FeatureMesh", "out of date: solving was cancelled")
# What these are called as long as there is no result that could be out of date.
NOT_SOLVED = QT_TRANSLATE_NOOP("FeatureMesh", "not solved yet")
FIRST_SOLVING = QT_TRANSLATE_NOOP("FeatureMesh", "being solved for the first time")
FIRST_CANCELLED = QT_TRANSLATE_NOOP("FeatureMesh", "not solved: solving was cancelled")
_AT_FIRST = {OUT_OF_DATE: NOT_SOLVED, SOLVING: FIRST_SOLVING, CANCELLED: FIRST_CANCELLED}

_BASE = "Fem::FeaturePython"   # the type of the object
# (type, name, group, default, read-only, tooltip)
PROPERTIES = [
    ("App::PropertyBool", "Automatic", "Live result", True, False, "Solve whenever the document was recomputed"),
    ("App::PropertyInteger", "Threads", "Live result", 0, False, "Processor threads to use; 0: all. The result is the same for any number"),
    ("App::PropertyLinkList", "Members", "Live result", [], True, "What of the analysis is solved: mesh, materials, supports, loads"),
    ("App::PropertyString", "Status", "Result", NOT_SOLVED, True, "Whether the result is that of the part as it is, and if not, why"),
    ("App::PropertyLinkHidden", "Result", "Result", None, True, "FreeCAD's own result object, for FEM's result panel, filters and pipeline"),
    ("App::PropertyFloat", "MaxMises", "Result", 0.0, True, "Largest von Mises stress, MPa"),
    ("App::PropertyFloat", "MaxDisplacement", "Result", 0.0, True, "Largest displacement, mm"),
    ("App::PropertyFloat", "Seconds", "Result", 0.0, True, "Time the last solution took"),
    ("App::PropertyString", "Report", "Result", "", True, "Everything about the last solution, as JSON"),
    ("App::PropertyString", "Failure", "Result", "", True, "Why the last solution failed, as JSON"),
    ("App::PropertyString", "SolvedState", "Result", "", True, "Which state of the mesh the result is of"),
]
_HIDDEN = ("Members", "Report", "Failure", "SolvedState")
_WITHOUT_TOUCH = [name for _, name, *_ in PROPERTIES if name not in ("Members", "Automatic")]
# Changes that alter no result.
_OF_NO_CONCERN = {"Visibility", "Label", "Label2", "ExpressionEngine", "Report", "Failure", "ReferredTo", "Proxy"}
_OF_THE_MESH = {"SavedState", "Status", "Suppressed"}

# Called with every live result that was made or opened; the window's side adds its view there.
on_ready = []
# Called with a live result that has a new solution, before that is in its result object.
on_solution = []
# Called with a live result that is to be solved beside FreeCAD's own thread; None: solved at once.
solve_later = None
# Called with a live result and the arrays of a mesh that FreeCAD is about to take, which takes it longer than solving.
solve_early = None
# Called with a live result whose solution under way, if there is one, is of no use any longer.
cancel = None


class LiveResult(Stateless):
    """Proxy of the object. Its class path is stored in documents and never changes."""

    Type = statics_model.LIVE_RESULT

    def __init__(self, live):
        live.Proxy = self
        self._forget()
        self._get_ready(live)

    # FreeCAD's side

    def execute(self, live):
        """Called by recompute, when the mesh or anything of the analysis changed."""
        if self.analysis(live) is None:
            self._tell_of_no_analysis(live)
            return
        self.set_status(live, OUT_OF_DATE)
        if not live.Automatic:
            return
        if solve_later is not None:
            solve_later(live)
            return
        try:
            self.solve(live)
        except (UserError, RuntimeError) as error:
            self.tell(live, error)

    def onDocumentRestored(self, live):
        self._forget()
        self._get_ready(live)
        if live.Status in (SOLVING, FIRST_SOLVING) or live.Status == UP_TO_DATE and self.mesh(live) is None:   # an older FreeCAD could not read the mesh
            self.set_status(live, OUT_OF_DATE)
        self._tell_of_no_analysis(live)   # a copy is in none
        self._bring_mesh_back(live)

    def loads(self, saved):
        self._forget()

    # Solving

    def analysis(self, live):
        """The analysis that it belongs to, or None."""
        return next(iter(analyses.directly_holding(live)), None)

    def solve(self, live, progress=None):
        """Solves, and waits for that. Returns the report. Throws what statics.solve throws; Status says why then."""
        try:
            job = self.prepare(live)
            job.run(progress)
            return self.finish(live, job)
        except Exception as error:
            self.fail(live, error)
            raise

    def prepare(self, live):
        """Reads what is to be solved. Returns a statics.SolveJob."""
        analysis = self._own_analysis(live)
        mesh = statics.mesh_of(analysis)
        solve_guard.refuse(analysis)
        self.set_status(live, SOLVING)
        self.motion = None
        job = statics.SolveJob(analysis, self.key(live), live.Threads, start=self._start(analysis))
        job.state = state.checksum_of(mesh.SavedState)
        return job

    def prepare_early(self, live, arrays):
        """Likewise, for the arrays that its mesh is about to get. What `prepare` gives later tells whether that was to be solved."""
        analysis = self.analysis(live)
        return statics.SolveJob(analysis, self.key(live), live.Threads, arrays, self._start(analysis))

    def _start(self, analysis):
        """What a solution starts from where the engine knows of none: in a document that was just opened, or after its process has died."""
        if self.solution is None:
            return statics_result.last_displacements(analysis)
        return self.solution.arrays["node_numbers"], self.solution.displacements

    def finish(self, live, job):
        """Shows the solution, then fills the result object, which takes FreeCAD longer. Returns the report. Throws UserError."""
        analysis = self._own_analysis(live)
        if self.solution is not None:
            self.before = self.solution
        self.solution, self.is_fresh = Solution(job.statics.arrays, job.fields), True
        for hook in on_solution:
            hook(live)
        was_touched, start = "Touched" in analysis.State, time.perf_counter()
        live.Result = statics_result.show(analysis, job.statics.arrays, job.fields, same_mesh=self.of_state == job.state)
        job.report["seconds"]["result"] = time.perf_counter() - start
        job.report["seconds"]["total"] += job.report["seconds"]["result"]
        self.of_state, self.is_changed = job.state, False
        found = job.report["responses"]
        live.MaxMises, live.MaxDisplacement, live.Seconds = found["max_mises_mpa"], found["max_displacement_mm"], job.report["seconds"]["total"]
        live.Report, live.SolvedState = json.dumps(job.report, sort_keys=True), job.state
        self.set_status(live, UP_TO_DATE)
        self._say(live, "" if live.MaxDisplacement else "\n".join(map(user_words.in_words, job.report["warnings"])))   # nothing moves, and why
        live.purgeTouched()
        if not was_touched:
            analysis.purgeTouched()
        return job.report

    def fail(self, live, error):
        """Says why there is no result of the part as it is; the last one stays, out of date."""
        self.motion = getattr(error, "motion", None)
        self.set_status(live, CANCELLED if mesh_object.is_cancelled(error) else failed(live, error))

    def tell(self, live, error):
        """Says in the report view why there is no result, once until there is one again: each recompute tries anew. A load is without faces as long as its panel
        asks for them."""
        if any(map(references.is_being_edited, live.Members)):
            return
        self._say(live, user_words.in_words(messages.of_error(error)))

    def _say(self, live, words):
        if words and words != self.told:
            FreeCAD.Console.PrintWarning("%s: %s\n" % (live.Label, words))
        self.told = words

    def set_status(self, live, status):
        if not has_result(live):
            status = _AT_FIRST.get(status, status)
        self.is_fresh = status == UP_TO_DATE
        if live.Status != status:
            live.Status = status
        if live.Result is not None and status != UP_TO_DATE:
            results.outdate(live.Result)

    def shown(self, live):
        """The Solution to draw, None where there is none of the mesh as it is. After opening a document it is read from the result object."""
        mesh = self.mesh(live)
        if mesh is None:
            return None
        if self.solution is None and live.Result is not None and live.SolvedState and live.SolvedState == state.checksum_of(mesh.SavedState):
            try:
                arrays = mesh.Proxy.arrays(mesh)
            except StateError:
                return None
            fields = statics_result.fields_of(live.Result)
            if len(fields["von_mises"]) == len(arrays["points"]):
                self.solution, self.is_fresh = Solution(arrays, fields), live.Status == UP_TO_DATE
        return self.solution

    def choose_form(self, live):
        """To be called before the document is saved: where that leaves out FreeCAD's form of the mesh, so it does of the result's, if that can be made of the mesh."""
        mesh, result = self.mesh(live), live.Result
        if result is not None and result.Mesh is not None:
            may_be_made = mesh is not None and live.Status == UP_TO_DATE and live.SolvedState == mesh.StateName   # its file is being moved
            choose_form(result.Mesh, is_saved=not may_be_made or is_saved_for_freecad(mesh))

    def _bring_mesh_back(self, live):
        """Gives the result the mesh that was not saved with it, or of which FreeCAD had no room to read all."""
        mesh, result = self.mesh(live), live.Result
        if result is None or result.Mesh is None or mesh is None or live.SolvedState != mesh.Proxy.state_of_mesh(mesh):
            return
        if (result.Mesh.FemMesh.NodeCount, result.Mesh.FemMesh.VolumeCount) == (mesh.NodeCount, mesh.TetCount):
            self.of_state = live.SolvedState
            return
        untouched = [obj for obj in (result.Mesh, result, self.analysis(live)) if obj is not None and "Touched" not in obj.State]
        try:
            statics_result.put_mesh(result, mesh.Proxy.arrays(mesh))
        except StateError:
            return   # the mesh's own object says so
        self.of_state = live.SolvedState
        for obj in untouched:
            obj.purgeTouched()
        choose_form(result.Mesh, is_saved=True)

    def mesh(self, live):
        """The mesh of ours in the analysis, of several one that is not suppressed, or None."""
        found = sorted(filter(analyses.is_ours, live.Members), key=lambda mesh: getattr(mesh, "Suppressed", False))
        return analyses.source_of(found[0]) if found else None

    def take_members(self, live):
        """What of the analysis asks for a new solution when it changes."""
        analysis = self.analysis(live)
        members = [obj for obj in analysis.Group if not statics_model.is_result(obj)] if analysis is not None else []
        members += [analyses.source_of(obj) for obj in members if analyses.is_ours(obj) and analyses.source_of(obj) not in (obj, None)]
        if members != live.Members:
            live.Members = members
            self.is_changed = True
            _outdate(live)
            self._tell_of_no_analysis(live)

    def _tell_of_no_analysis(self, live):
        try:
            self._own_analysis(live)
        except UserError as error:
            self.fail(live, error)

    def _own_analysis(self, live):
        analysis = self.analysis(live)
        if analysis is None:
            raise UserError(said("{live:text} belongs to no analysis; drag it into one", live=describe(live)))
        return analysis

    def key(self, live):
        """The name under which the engine keeps what makes the next solution faster."""
        return "live %s %s %d" % (live.Document.Name, live.Name, id(self))

    def _forget(self):
        self.of_state = ""        # which state of the mesh the result's mesh is of; undo brings back properties, but no mesh
        self.is_changed = False   # did undo, redo or a new member change what was solved?
        self.solution = None   # the last Solution
        self.before = None     # the one before
        self.is_fresh = False  # is it that of the part as it is?
        self.told = ""         # why there is no result, or why nothing moves, as it was said last
        self.motion = None     # (n,3) how the part can move, where the last attempt found that

    def _get_ready(self, live):
        add_missing(live, PROPERTIES, _WITHOUT_TOUCH, _HIDDEN)
        _watch()
        for hook in on_ready:
            hook(live)


class Solution:
    """Displacements (n,3) mm and von Mises stresses (n,) MPa at the nodes of the mesh as it was solved."""

    def __init__(self, arrays, fields):
        self.arrays = arrays
        self.displacements, self.von_mises = fields["displacements"], fields["von_mises"]


def is_live_result(obj):
    """Is this one of our live results?"""
    return isinstance(getattr(obj, "Proxy", None), LiveResult)


def in_document(document):
    """All live results of the document."""
    return list(filter(is_live_result, document.findObjects(_BASE)))


def has_result(live):
    """Was it ever solved?"""
    return live.Result is not None or live.Proxy.solution is not None


def of_analysis(analysis):
    """The live result of an analysis, None where it has none."""
    return next(filter(is_live_result, analysis.Group), None)


def add(analysis):
    """The live result of an analysis, made where it has none."""
    known = of_analysis(analysis)
    if known is not None:
        return known
    live = analysis.Document.addObject(_BASE, "Live")
    live.Label = translate("FeatureMesh", "Live result")
    LiveResult(live)
    analyses.take_in(analysis, live)
    live.Proxy.take_members(live)
    return live


def _begin_early(mesh, part_mesh):
    """Lets what depends on a mesh that is about to be shown be solved meanwhile, where a recompute will ask for that."""
    if solve_early is None or not mesh.Document.Recomputing:
        return
    for live in filter(is_live_result, dict.fromkeys(mesh.InList)):
        if live.Automatic and mesh in live.Members and live.Proxy.analysis(live) is not None:
            solve_early(live, part_mesh.arrays())


def _outdate(live):
    """Something of it changed, and no recompute calls execute for that."""
    if cancel is not None:
        cancel(live)
    if live.Status in (UP_TO_DATE, SOLVING, FIRST_SOLVING):
        live.Proxy.set_status(live, OUT_OF_DATE)


def _fail(document, objects):
    """The result of an analysis with a member that FreeCAD could not recompute is that of before the edit. What lost its faces is in error for that reason."""
    for live in in_document(document):
        error = recompute_errors.first_error(live.Document, [member for member in live.Members if not mesh_object.is_feature_mesh(member)], objects)
        if error is not None:
            analysis = live.Proxy.analysis(live)
            lost = next((sentence for member, sentence in references.unmended(analysis) if member in objects), "") if analysis is not None else ""
            _outdate(live)
            live.Proxy.fail(live, UserError(lost) if lost else error)


_observer = None


def _watch():
    global _observer
    if _observer is None:
        _observer = _Observer()
        FreeCAD.addDocumentObserver(_observer)
        mesh_object.on_new_mesh.append(_begin_early)
        recompute_errors.watch(_fail)
        for purge in ("purge_results", "purge_result_objects"):   # the second before FEM solves, in 1.1
            wrap("femresult.resulttools", None, purge, _keep_from_purge)


def _keep_from_purge(purge, analysis):
    """FEM removes the results of an analysis before it solves; that of a live result is none of those."""
    kept = [live.Result for live in filter(is_live_result, analysis.Group) if live.Result is not None]
    for result in kept:
        analysis.removeObject(result)
    try:
        purge(analysis)
    finally:
        for result in kept:
            analysis.addObject(result)


class _Observer:
    """Sees changes before a recompute does, and those that none follows: undo, a mesh updated by hand, a new member of the analysis."""

    def __init__(self):
        self._left = []   # (analysis, result), by name, of live results that the undo under way takes away

    def slotChangedObject(self, obj, name):
        if FreeCAD.isRestoring() or name in _OF_NO_CONCERN:
            return
        if name == "Group" and analyses.is_analysis(obj):
            for live in in_document(obj.Document):
                if live in obj.Group or live.Proxy.analysis(live) is None:   # it may have left this one
                    live.Proxy.take_members(live)
            return
        is_mesh = mesh_object.is_feature_mesh(obj)
        if is_mesh and name not in _OF_THE_MESH or statics_model.is_result(obj):
            return
        if obj.Document.Recomputing and not (is_mesh and obj.Status != mesh_object.UP_TO_DATE):
            return   # execute follows, unless the mesh failed
        for live in filter(is_live_result, obj.InList):
            if obj in live.Members:
                live.Proxy.is_changed = True
                _outdate(live)
                if is_mesh and live.Automatic and solve_later is not None and obj.Status == mesh_object.UP_TO_DATE:
                    solve_later(live)

    def slotStartSaveDocument(self, document, _):
        for live in in_document(document):
            live.Proxy.choose_form(live)

    def slotFinishSaveDocument(self, document, _):
        """What FreeCAD keeps for a recovery, or copies, has the mesh of a result in any case: by then it may no more be that of the part's mesh."""
        for live in in_document(document):
            if live.Result is not None and live.Result.Mesh is not None:
                choose_form(live.Result.Mesh, is_saved=True)

    def slotUndoDocument(self, document):
        self._keep_results(document)
        statics_result.set_aside_left_over(document)
        _take_results(document)
        _solve_again(document)

    slotRedoDocument = slotAbortTransaction = slotUndoDocument

    def _keep_results(self, document):
        """Undo gives an analysis the members that it had before it had a result of ours, which would be left beside it."""
        left, self._left = self._left, []
        for names in left:
            analysis, result = map(document.getObject, names)
            if analysis is not None and result is not None and result not in analysis.Group:
                analysis.addObject(result)

    def slotDeletedObject(self, obj):
        if is_live_result(obj):
            analysis = obj.Proxy.analysis(obj)
            if obj.Document.Transacting and analysis is not None and obj.Result is not None:
                self._left.append((analysis.Name, obj.Result.Name))
            _let_go(obj)

    def slotDeletedDocument(self, document):
        for live in in_document(document):
            _let_go(live)
        statics_result.forget(document)


def _let_go(live):
    """Of a live result that is about to be gone: ends its solution, and frees what would have made the next one faster."""
    if cancel is not None:
        cancel(live)
    if live.Proxy.solution is None:
        return
    key = live.Proxy.key(live)
    if solve_later is None:
        engine.load().forget_statics(key)
    else:   # it may wait for a solution under way
        threading.Thread(target=lambda: engine.load().forget_statics(key), daemon=True).start()


def _take_results(document):
    """Undo gives a live result the result object that it had; another one may be in its place now."""
    for live in in_document(document):
        analysis = live.Proxy.analysis(live)
        result = statics_result.of_analysis(analysis) if analysis is not None else None
        if result is not None and result is not live.Result:
            live.Result, live.Proxy.of_state = result, ""


def _solve_again(document):
    for live in in_document(document):
        mesh = live.Proxy.mesh(live)
        if mesh is not None and (live.Proxy.is_changed or live.Proxy.of_state != state.checksum_of(mesh.SavedState)):
            _outdate(live)
            if live.Automatic and solve_later is not None:
                solve_later(live)

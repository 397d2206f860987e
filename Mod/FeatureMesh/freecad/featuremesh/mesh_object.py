# SPDX-License-Identifier: GPL-3.0-or-later
"""The document object: a FEM mesh that depends on a part and follows its edits."""

import json
import os
import tempfile
import time

import FreeCAD
import Fem
import numpy as np

from . import adopt, engine, hand_over, history, messages, references, state, versions
from .errors import EngineMissing, StateError, UserError
from .job import MeshJob
from .reading import describe, read_document, shape_of_record

translate = FreeCAD.Qt.translate
# Kept in documents as they are; shown in the user's language by status_in_words.
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
NOT_MESHED = QT_TRANSLATE_NOOP("FeatureMesh", "not meshed yet")
UP_TO_DATE = QT_TRANSLATE_NOOP("FeatureMesh", "up to date")
OUT_OF_DATE = QT_TRANSLATE_NOOP("FeatureMesh", "out of date: the part or a setting changed, update by hand or switch Automatic on")
CANCELLED = QT_TRANSLATE_NOOP("FeatureMesh", "out of date: the last update was cancelled")

# (type, name, group, default, read-only, tooltip)
PROPERTIES = [
    ("App::PropertyLength", "Size", "Mesh size", 0.0, False, "Wanted edge length of the tets"),
    ("App::PropertyLength", "MinSize", "Mesh size", 0.0, False,
     "Smallest edge length that curvature, thin gaps and growth may ask for; 0: a tenth of Size"),
    ("App::PropertyFloat", "ElementsPerCircle", "Mesh size", 12.0, False,
     "Edges along a full circle of any curved face or edge; 0: sizes do not follow curvature"),
    ("App::PropertyFloat", "ElementsAcrossGap", "Mesh size", 0.0, False,
     "Elements across thin walls and slots; 0: sizes do not follow thickness"),
    ("App::PropertyFloat", "Growth", "Mesh size", 1.3, False,
     "By how much neighbouring elements may differ in size at most"),
    ("App::PropertyFloat", "QualityTarget", "Mesh", 30.0, False,
     "Smallest angle in degrees that new elements are improved towards; below 30 is faster, above 35 is rarely reached"),
    ("App::PropertyEnumeration", "Order", "Mesh", ["1st", "2nd"], False,
     "1st: 4-node tets; 2nd: 10-node tets with their mid-side nodes on the surface"),
    ("App::PropertyInteger", "Threads", "Mesh", 0, False,
     "Processor threads to use; 0: all. The mesh is the same for any number"),
    ("App::PropertyBool", "Automatic", "Mesh", True, False, "Update the mesh whenever the document is recomputed"),
    ("App::PropertyLinkList", "MeshRegionList", "Mesh", [], False, "Local sizes: FEM mesh refinements"),
    ("App::PropertyLinkList", "MeshGroupList", "Mesh", [], False, "FEM mesh groups"),
    ("App::PropertyString", "Status", "Result", NOT_MESHED, True, "Whether the mesh fits the part, and if not, why"),
    ("App::PropertyInteger", "NodeCount", "Result", 0, True, "Nodes of the mesh"),
    ("App::PropertyInteger", "TetCount", "Result", 0, True, "Tets of the mesh"),
    ("App::PropertyPercent", "KeptNodes", "Result", 0, True, "Share of the nodes kept bit for bit by the last update"),
    ("App::PropertyPercent", "KeptTets", "Result", 0, True, "Share of the tets kept by the last update"),
    ("App::PropertyAngle", "MinDihedral", "Result", 0.0, True, "Smallest angle between two faces of a tet"),
    ("App::PropertyFloat", "MeanRadiusRatio", "Result", 0.0, True,
     "Mean of three times the inscribed over the circumscribed radius; 1 for regular tets"),
    ("App::PropertyFloat", "Seconds", "Result", 0.0, True, "Time the last mesh or update took"),
    ("App::PropertyString", "Report", "Result", "", True, "Everything about the last mesh or update, as JSON"),
    ("App::PropertyFileIncluded", "SavedState", "Result", None, True, "What the next update needs"),
]
# Called with every mesh object that was made or opened; the window's side adds its view there.
on_ready = []
# Runs a MeshJob while FreeCAD recomputes, where the window's side wants to show progress; None: just run it.
run_job = None

_HIGHEST_TARGET = 45   # degrees; no mesh reaches more
_OPTION_OF = {"Size": "size", "MinSize": "min_size", "ElementsPerCircle": "elements_per_circle",
              "ElementsAcrossGap": "elements_across_gap", "Growth": "growth", "QualityTarget": "target_dihedral_deg",
              "Threads": "threads"}


class FeatureMesh:
    """Proxy of the mesh object. Its class path is stored in documents and never changes."""

    Type = "Fem::FeatureMesh"

    def __init__(self, mesh):
        self.Type = FeatureMesh.Type
        mesh.Proxy = self
        self._forget()
        self._get_ready(mesh)

    # FreeCAD's side

    def execute(self, mesh):
        """Called by recompute: updates the mesh, or in manual mode only says that it is out of date."""
        if not mesh.Automatic:
            mesh.Status = OUT_OF_DATE
            return
        try:
            self.update(mesh)
        except (UserError, RuntimeError) as error:
            message = status_in_words(CANCELLED) if is_cancelled(error) else messages.in_words(one_line(error))
            raise UserError(message) from None  # FreeCAD prints the way to it, which says nothing to a user

    def onDocumentRestored(self, mesh):
        self._forget()
        self._get_ready(mesh)
        self._miss_the_engine(mesh)
        self._shown = state.checksum_of(mesh.SavedState)
        if self._shown:
            self._restore_numbers(mesh)

    def dumps(self):
        return {"Type": self.Type}

    def loads(self, saved):
        self.Type = FeatureMesh.Type
        self._forget()

    __getstate__ = dumps
    __setstate__ = loads

    # Meshing

    def update(self, mesh, full=False, progress=None):
        """Meshes the part, locally where the last state allows it (never with `full`). Returns the report.

        When that fails the old mesh stays, Status says why, and the error is raised.
        """
        return self._carry_out(mesh, lambda: self.prepare(mesh, full), progress)

    def _carry_out(self, mesh, prepare, progress):
        try:
            job = prepare()
            if progress is None and run_job is not None:
                run_job(job)
            else:
                job.run(progress)
            return self.finish(mesh, job)
        except Exception as error:
            self.fail(mesh, error)
            raise

    def renumber(self, mesh):
        """Gives nodes and elements the numbers 1, 2, 3 ... without changing anything else. Returns the largest numbers before. Throws StateError."""
        part_mesh = self.last_part_mesh(mesh)
        saved = state.load(mesh.SavedState)
        before = saved.arrays["counters"][2:4] - 1
        arrays = renumbered(part_mesh.arrays())
        job = MeshJob(saved.raw, saved.options, None, None, [])
        job.part_mesh = engine.load().restore_part(saved.raw, saved.options, arrays)
        self._show(mesh, job.part_mesh)
        self._store(mesh, job)
        return tuple(before.tolist())

    def adopt(self, mesh, arrays, progress=None):
        """Takes over the mesh of another FEM mesh object, read by adopt.arrays_of, and meshes anew what of it does not fit. Returns the report."""
        def prepare():
            start = time.perf_counter()
            part = versions.part_of(mesh)
            job = adopt.AdoptJob(read_document(part), options_of(mesh, part), arrays)
            job.seconds = {"document": time.perf_counter() - start, "restore": 0.0}
            return job

        return self._carry_out(mesh, prepare, progress)

    def prepare(self, mesh, full=False):
        """Reads what the engine needs from the document. Throws UserError."""
        start = time.perf_counter()
        part = versions.part_of(mesh)
        if part is None:
            raise UserError(translate("FeatureMesh", "%s has no part to mesh, set its property %s")
                            % (describe(mesh), versions.part_property(mesh)))
        raw = read_document(part)
        old, saved, problem = (None, None, None) if full else self._old(mesh)
        moved = []
        if mesh.MeshRegionList and not (old is None and saved is None):
            moved = self._follow(mesh.MeshRegionList, mesh,
                                 lambda: engine.load().compare(self._raw, raw, fuse=False)["faces"])
        job = MeshJob(raw, options_of(mesh, part), old, problem, moved)
        job.saved = saved
        if old is None:
            job.next_numbers = _next_numbers(mesh, state_is_sound=problem is None and saved is None)
        job.seconds = {"document": time.perf_counter() - start, "restore": 0.0}
        return job

    def finish(self, mesh, job):
        """Hands a job's mesh over to FreeCAD and saves its state. Returns the report."""
        start = time.perf_counter()
        report = plain(job.report)
        if job.problem:
            add_fallback(report, "meshed from scratch: " + job.problem)
        moved = job.moved_references
        if job.old is not None:
            moved = moved + self._follow(self._dependents(mesh), mesh, lambda: report["difference"]["faces"])
        report["warnings"] = report.get("warnings", []) + moved
        for line in remarks_of(report):
            FreeCAD.Console.PrintWarning("%s: %s\n" % (mesh.Label, messages.in_words(line)))
        fem_mesh = self._fem_mesh(mesh, job.part_mesh)
        handed_over = time.perf_counter()
        self._store(mesh, job)   # first, so that a full disk leaves the old mesh with its old state
        mesh.FemMesh = fem_mesh
        job.seconds.update(hand_over=handed_over - start, state=time.perf_counter() - handed_over)
        job.seconds["total"] = sum(job.seconds.values())
        del job.seconds["engine"]
        report["seconds"] = {**report.get("seconds", {}), **job.seconds}
        _show_report(mesh, report)
        mesh.Status = UP_TO_DATE
        return report

    def fail(self, mesh, error):
        """Says why there is no new mesh; the old one stays."""
        mesh.Status = CANCELLED if is_cancelled(error) else "failed: " + one_line(error)

    def last_part_mesh(self, mesh):
        """The engine's mesh as it is now, from memory or from the saved state. Throws StateError."""
        checksum = state.checksum_of(mesh.SavedState)
        if not self._has_in_memory(checksum):
            saved = self._load(mesh)
            self._part_mesh = engine.load().restore_part(saved.raw, saved.options, saved.arrays)
            self._checksum = checksum
        return self._part_mesh

    def arrays(self, mesh):
        """The arrays of the mesh as it is now (see PartMesh.arrays). Throws StateError."""
        if self._part_mesh is not None and state.checksum_of(mesh.SavedState) == self._checksum:
            return self._part_mesh.arrays()
        return state.load(mesh.SavedState).arrays

    def show_state(self, mesh):
        """Makes FemMesh what the saved state says, after undo or redo brought back another one."""
        checksum = state.checksum_of(mesh.SavedState)
        if checksum == self._shown:
            return
        if not checksum:
            mesh.FemMesh = Fem.FemMesh()
        else:
            try:
                self._show(mesh, self.last_part_mesh(mesh))
            except (RuntimeError, UserError) as error:
                mesh.Status = "failed: " + one_line(error)
                FreeCAD.Console.PrintError("%s: %s\n" % (mesh.Label, one_line(error)))
                return
        self._shown = checksum

    def renew_analysis_groups(self, mesh):
        """Makes the groups of constraints and materials anew, without touching the mesh."""
        part = versions.part_of(mesh)
        if part is None or not mesh.FemMesh.VolumeCount or not self._shown or self._following:
            return
        try:
            arrays = self.arrays(mesh)
        except StateError as error:
            FreeCAD.Console.PrintWarning("%s: %s\n" % (mesh.Label, error))
            return
        hand_over.renew_analysis_groups(mesh, part, arrays)

    def _old(self, mesh):
        """What to start from: (the engine's mesh, the saved state to make it from, the reason why there is neither).

        At most one of the three is not None, none for a first mesh.
        """
        if self._part_mesh is None and not mesh.SavedState:
            return None, None, (None if not mesh.FemMesh.VolumeCount else "the document holds no mesh state")
        if self._has_in_memory(state.checksum_of(mesh.SavedState)):
            return self._part_mesh, None, None
        try:
            return None, self._load(mesh), None
        except StateError as error:
            return None, None, one_line(error)

    def _has_in_memory(self, checksum):
        """Is the engine's mesh of the saved state with that checksum at hand?"""
        return checksum == self._checksum and isinstance(self._part_mesh, engine.load().PartMesh)

    def _load(self, mesh):
        """The saved state. Throws StateError."""
        saved, part = state.load(mesh.SavedState), versions.part_of(mesh)
        if part is not None and saved.part_name != part.Name:
            raise StateError("the saved mesh state belongs to %s, not to %s" % (saved.part_name, part.Name))
        self._raw, self._references = saved.raw, saved.references
        return saved

    def _miss_the_engine(self, mesh):
        """Says when a document is opened that its mesh can only be looked at."""
        try:
            engine.folder()
        except EngineMissing as error:
            FreeCAD.Console.PrintWarning("%s: %s\n" % (mesh.Label, error))

    def _restore_numbers(self, mesh):
        """FreeCAD closes the gaps between numbers when it opens a document; the saved state knows the true ones."""
        try:
            fem_mesh = hand_over.reopened(mesh.FemMesh, state.load(mesh.SavedState).arrays)
        except StateError as error:
            FreeCAD.Console.PrintWarning("%s: %s\n" % (mesh.Label, error))
            return
        if fem_mesh is not None:
            mesh.FemMesh = fem_mesh
            mesh.purgeTouched()

    def _show(self, mesh, part_mesh):
        mesh.FemMesh = self._fem_mesh(mesh, part_mesh)

    def _fem_mesh(self, mesh, part_mesh):
        return hand_over.to_fem_mesh(part_mesh, hand_over.groups_of(part_mesh, mesh, versions.part_of(mesh)))

    def _dependents(self, mesh):
        """Constraints and materials of the analyses with this mesh, and its group objects."""
        members = [member for analysis in mesh.InList if analysis.isDerivedFrom("Fem::FemAnalysis")
                   for member in analysis.Group]
        return members + list(mesh.MeshGroupList)

    def _follow(self, objects, mesh, faces):
        """Moves references with their faces where FreeCAD does not or could not. Returns what was done."""
        part, raw = versions.part_of(mesh), self._raw
        if not (references.are_lost(objects, part) if versions.follows_faces() else self._references):
            return []
        self._following = True
        try:
            return references.follow(objects, part, self._references, faces(), lambda: shape_of_record(raw))
        finally:
            self._following = False

    def _store(self, mesh, job):
        objects = self._dependents(mesh) + list(mesh.MeshRegionList)
        refers = references.references_of(objects, versions.part_of(mesh))
        saved = state.State(job.raw, job.options, job.part_mesh.arrays(), refers)
        try:
            with tempfile.TemporaryDirectory(prefix="featuremesh-") as folder:
                path = os.path.join(folder, mesh.Name + ".npz")
                checksum = state.save(path, saved)
                mesh.SavedState = path
            if state.checksum_of(mesh.SavedState) != checksum:
                raise OSError("the copy in %s is not whole" % os.path.dirname(mesh.SavedState))
        except (OSError, RuntimeError) as error:
            raise UserError("the new mesh's state cannot be stored (%s), the old mesh stays; is the disk full?" % one_line(error)) from error
        self._references = refers
        self._checksum = self._shown = checksum
        self._part_mesh, self._raw = job.part_mesh, job.raw

    def _forget(self):
        self._part_mesh = None   # the engine's mesh, while it is in memory
        self._raw = None         # what it was made from
        self._references = {}    # what constraints referred to then
        self._following = False  # references are being moved just now
        self._checksum = ""      # of the saved state that it belongs to
        self._shown = ""         # of the saved state that FemMesh was made from

    def _get_ready(self, mesh):
        self._add_properties(mesh)
        history.watch()
        for hook in on_ready:
            hook(mesh)

    def _add_properties(self, mesh):
        """Adds what the object lacks: all of it when new, what came later when from an older document."""
        if "Shape" not in mesh.PropertiesList and "Part" not in mesh.PropertiesList:
            mesh.addProperty("App::PropertyLink", "Part", "Mesh", "The part to mesh")
        for kind, name, group, default, read_only, tooltip in PROPERTIES:
            if name not in mesh.PropertiesList:
                mesh.addProperty(kind, name, group, tooltip)
                if default is not None:
                    setattr(mesh, name, default)
            if read_only:
                mesh.setEditorMode(name, 2 if name in ("Report", "SavedState") else 1)


def _next_numbers(mesh, state_is_sound):
    """What a mesh from scratch has to number on from, so that no number is ever given to another node or element."""
    known = (mesh.SavedState and state.next_numbers_of(mesh.SavedState)) or (1, 1)
    fem_mesh = mesh.FemMesh
    if state_is_sound or not fem_mesh.NodeCount:
        return known
    elements = [max(numbers) for numbers in (fem_mesh.Edges, fem_mesh.Faces, fem_mesh.Volumes) if numbers]
    return max(known[0], 1 + max(fem_mesh.Nodes)), max(known[1], 1 + max(elements, default=0))


def is_feature_mesh(obj):
    """Is this one of our mesh objects?"""
    return isinstance(getattr(obj, "Proxy", None), FeatureMesh)


def options_of(mesh, part):
    """The engine's options from the object's properties and its mesh refinements. Throws UserError."""
    options = {option: float(getattr(getattr(mesh, name), "Value", getattr(mesh, name)))
               for name, option in _OPTION_OF.items()}
    if not 0 <= mesh.QualityTarget <= _HIGHEST_TARGET:
        raise UserError(translate("FeatureMesh", "the property QualityTarget of %s has to lie between 0 and %g degrees, not %g")
                        % (describe(mesh), _HIGHEST_TARGET, mesh.QualityTarget))
    options["threads"] = int(options["threads"]) or os.cpu_count() or 1
    options["order"] = 2 if mesh.Order == "2nd" else 1
    options["min_size"] = options["min_size"] or options["size"] / 10
    options["local"] = local_sizes(mesh, part)
    return options


def local_sizes(mesh, part):
    """("Face12", size) for every reference of every mesh refinement. Throws UserError for one that is not on the part."""
    sizes = []
    for region in mesh.MeshRegionList:
        size = float(region.CharacteristicLength.Value)
        names, foreign = hand_over.references_to(region, part)
        if foreign:
            raise UserError(translate("FeatureMesh", "the refinement %s refers to another object than %s; refer to faces of that one")
                            % (describe(region), describe(part)))
        if size > 0:
            sizes += [(name, size) for name in names]
    return sizes


def renumbered(arrays):
    """The same mesh with numbers without gaps, in the order in which nodes and elements lie in the arrays."""
    new, first = dict(arrays), 1
    new["node_numbers"] = np.arange(1, len(arrays["node_numbers"]) + 1)
    for name in ("segment_numbers", "triangle_numbers", "tet_numbers"):
        new[name] = np.arange(first, first + len(arrays[name]))
        first += len(arrays[name])
    new["counters"] = np.array([*arrays["counters"][:2], len(new["node_numbers"]) + 1, first], dtype=np.int64)
    return new


def add_fallback(report, text):
    """Adds a line to the report's list of what could not be kept or done."""
    report["fallback"] = "; ".join(part for part in (text, report.get("fallback")) if part)


def remarks_of(report):
    """What a report says that the user should know: the fallback, then the warnings."""
    return ([report["fallback"]] if report.get("fallback") else []) + report.get("warnings", [])


def plain(value):
    """The same with lists in place of arrays, and triangles (of no use in a report) counted only."""
    if isinstance(value, dict):
        short = {key: plain(entry) for key, entry in value.items() if key != "changed_boundary"}
        if "changed_boundary" in value:
            short["changed_triangles"] = len(value["changed_boundary"])
        return short
    if isinstance(value, (list, tuple)):
        return [plain(entry) for entry in value]
    return value.tolist() if hasattr(value, "tolist") else value


def status_in_words(status):
    """The Status of a mesh object in the user's language."""
    if status.startswith("failed: "):
        return FreeCAD.Qt.translate("FeatureMesh", "failed: %s") % messages.in_words(status[len("failed: "):])
    return FreeCAD.Qt.translate("FeatureMesh", status)


def is_cancelled(error):
    """Did the user end the work? The class of that error is the engine's, which need not be loaded."""
    return type(error).__name__ == "Cancelled"


def one_line(error):
    """An error's message without line breaks."""
    return " ".join(str(error).split()) or type(error).__name__


def _show_report(mesh, report):
    report.setdefault("fallback", None)
    quality, kept = report.get("quality", {}), report.get("kept") or {}
    mesh.NodeCount, mesh.TetCount = int(report["nodes"]), int(report["tets"])
    mesh.KeptNodes = int(100 * kept.get("nodes_share", 0.0))
    mesh.KeptTets = int(100 * kept.get("tets_share", 0.0))
    mesh.MinDihedral = float(quality.get("min_dihedral", 0.0))
    mesh.MeanRadiusRatio = float(quality.get("mean_radius_ratio", 0.0))
    mesh.Seconds = report["seconds"]["total"]
    mesh.Report = json.dumps(report, sort_keys=True)

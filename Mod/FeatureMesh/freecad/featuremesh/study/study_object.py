# SPDX-License-Identifier: GPL-3.0-or-later
"""The study in a document's tree: what is varied and asked for, and the folder with what came out."""

import os
import re
import shutil

import FreeCAD

from .. import api, documents, edits, engine, preferences, resolving, solvers, statics, statics_model, versions
from ..errors import UserError
from ..messages import said
from ..proxies import GetsReady, add_missing
from ..reading import describe, refuse_unmeshable
from . import dimensions, places, study_file, window_run
from .design import COUNTED, SAMPLINGS, Study, check, parse_parameter, read_toml
from .folder import is_same_study
from .response_words import parse_response

translate = FreeCAD.Qt.translate

_SAMPLINGS = [name for name in SAMPLINGS if name != "csv"]
_PLACE = re.compile(r"(?<=@)\w+")   # in the text of a response
_ANY_SOLVER = "automatic"
# What is asked for where the user says nothing, by FreeCAD's kind of analysis.
USUAL_RESPONSES = {"static": ["mass", "max_mises", "max_displacement"], "thermomech": ["max_temperature", "max_mises", "max_displacement"],
                   "frequency": ["mass", "frequency_1"], "buckling": ["mass", "buckling_factor_1"]}
# (type, name, group, default, read-only, tooltip)
PROPERTIES = [
    ("App::PropertyLinkHidden", "Part", "Study", None, False, "The part that is varied"),
    ("App::PropertyLinkHidden", "Analysis", "Study", None, False, "The analysis that is solved for each case"),
    ("App::PropertyStringList", "Parameters", "Study", [], False, "What is varied, such as Fillet.Radius=2:6"),
    ("App::PropertyStringList", "Responses", "Study", [], False, "What is asked of each case, such as max_mises@Face3"),
    ("App::PropertyStringList", "Constraints", "Study", [], False, "What the parameters have to keep, such as Fillet.Radius < 5"),
    ("App::PropertyEnumeration", "Sampling", "Study", _SAMPLINGS, False, "How the cases are chosen"),
    ("App::PropertyInteger", "Cases", "Study", 16, False, "Number of cases, where the sampling takes any number"),
    ("App::PropertyInteger", "Seed", "Study", 1, False, "Another number gives other cases"),
    ("App::PropertyEnumeration", "Solver", "Study", [_ANY_SOLVER, "live", "ccx"], False, "Solves the cases; automatic: live where that is enough"),
    ("App::PropertyInteger", "Jobs", "Study", 0, False, "Cases at once; 0: as many as the processors"),
    ("App::PropertyFloat", "SecondsLimit", "Study", 3600.0, False, "A case that takes longer is ended"),
    ("App::PropertyStringList", "Keep", "Study", [], False, "Files to keep of each case: mesh, inp, frd"),
    ("App::PropertyLinkSubListHidden", "References", "Study", None, True, "The faces, edges and vertices of the responses, which are followed through edits"),
    ("App::PropertyString", "Folder", "Result", "", False, "Where the cases are kept"),
]


class StudyObject(GetsReady):
    """Proxy of the object. Its class path is stored in documents and never changes."""

    Type = "FeatureMesh::Study"

    def execute(self, obj):
        """Nothing follows a study."""

    def onChanged(self, obj, name):
        if name in ("Part", "Responses") and not (FreeCAD.isRestoring() or obj.Document.Transacting):
            self._refer(obj)

    def places_moved(self, obj, moved):
        """What is asked for at faces, edges and vertices goes with them: `moved` has the names of what each became."""
        responses = []
        for text in obj.Responses:
            place = _PLACE.search(text)
            pieces = moved.get(place[0]) if place else None
            responses += [text] if pieces is None else [text[:place.start()] + piece + text[place.end():] for piece in pieces]
        obj.Responses = list(dict.fromkeys(responses))

    @staticmethod
    def _refer(obj):
        """The mesh moves references along with what they mean."""
        if "References" in obj.PropertiesList:
            names = sorted({name for text in obj.Responses for name in _places_of(text)})
            obj.References = [(obj.Part, names)] if names and obj.Part is not None else []

    def _get_ready(self, obj):
        added = add_missing(obj, PROPERTIES, [name for _, name, *_ in PROPERTIES], hidden=("References",))
        if "Sampling" in added:
            obj.Sampling = "lhs"
        elif "References" in added:
            self._refer(obj)
        for hook in on_ready:
            hook(obj)


def _places_of(text):
    try:
        return places.of_nodes([parse_response(text)])
    except UserError:   # told when it runs
        return []


# Called with every study object that was made or opened; the window's side adds its view there.
on_ready = []
# Called with a study object and what runs for it; the window's side keeps that, so that its panel can stop it.
on_run = []


def is_study(obj):
    """Is this one of our studies?"""
    return isinstance(getattr(obj, "Proxy", None), StudyObject)


def settings_of(obj):
    """What the study varies and asks for, and where it was run."""
    return [getattr(obj, name) for _, name, *_ in PROPERTIES]


def add(part, analysis=None):
    """A new study of the part, which asks for what is usual."""
    obj = part.Document.addObject("App::FeaturePython", "Study")
    obj.Label = translate("FeatureMesh", "Study")
    StudyObject(obj)
    obj.Part, obj.Analysis = part, analysis
    obj.Responses = USUAL_RESPONSES.get(kind_of(analysis), [extent_of(part)])
    obj.purgeTouched()
    return obj


def extent_of(part):
    """The response that tells how much of the part there is."""
    return "volume" if part is None or part.Shape.Solids else "area"


def kind_of(analysis):
    """FreeCAD's word for what is solved; static where a live result or nothing solves it, None without an analysis."""
    if analysis is None:
        return None
    found = solvers.of_calculix(analysis)
    return "static" if not found or any(solver.AnalysisType == "static" for solver in found) else found[0].AnalysisType


def study_of(obj, document_path):
    """The design.Study that the object asks for, of the document in that file. Throws UserError."""
    if obj.Part is None:
        raise UserError(said("{study:text} has no part", study=describe(obj)))
    refuse_unmeshable(obj.Part)
    if not obj.Parameters:
        raise UserError(said("nothing is varied: tick a dimension and give it a range"))
    if not obj.Responses:
        raise UserError(said("nothing is asked for: tick what each case is to tell"))
    parameters = [_labelled(parse_parameter(text), obj.Document) for text in obj.Parameters]
    study = Study(document_path, parameters, [parse_response(text) for text in obj.Responses], object=obj.Part.Name,
                  analysis=obj.Analysis.Name if obj.Analysis else None, solver=None if obj.Solver == _ANY_SOLVER else obj.Solver,
                  sampling=obj.Sampling, cases=obj.Cases if obj.Sampling in COUNTED else 0, seed=obj.Seed, constraints=list(obj.Constraints),
                  keep=list(obj.Keep), seconds_limit=obj.SecondsLimit)
    if not meshes_of(obj):   # as the window meshes it
        wanted = preferences.for_new_mesh()
        study.mesh_size, study.mesh_order = api.default_size(obj.Part, wanted["elements"]), wanted["order"]
    check(study)
    return study


def _labelled(parameter, document):
    """It is shown by the label that its object has in the tree."""
    name, _, path = parameter.target.partition(".")
    owner = document.getObject(name)
    if owner is not None and owner.Label != name:
        parameter.label = "%s.%s" % (owner.Label, path)
    return parameter


def start(obj, wait=False):
    """Writes the document as it is and the study into a new folder, and runs it there; with `wait` it returns when that has ended. Returns the
    window_run.WindowRun. Throws UserError, and leaves no folder where nothing was begun."""
    for parameter in study_of(obj, "").parameters:   # whatever is wrong is told before anything is written
        edits.value_to_vary(obj.Document, parameter.target, parameter.unit)
    folder = window_run.new_folder(obj.Document.FileName, obj.Name)
    try:
        os.makedirs(folder)
    except OSError as error:
        raise UserError(said("the study's folder {path:text} cannot be made ({why:text}); save the document where you may write, the study is kept beside it",
                             path=folder, why=error.strerror)) from error
    path = os.path.join(folder, _name_of_copy(obj.Document.FileName))
    try:
        documents.save_document(obj.Document, path)
        study_file.write(study_of(obj, path), os.path.join(folder, "study.toml"))
        run = window_run.WindowRun(folder, obj.Jobs)
    except BaseException:
        shutil.rmtree(folder, ignore_errors=True)
        raise
    obj.Folder = folder
    return _told(obj, run, wait)


def _name_of_copy(path):
    """That of the document, which the report is named after; not that of the study's own base.FCStd."""
    name = os.path.basename(path)
    return name if name.endswith(".FCStd") and name != "base.FCStd" else "part.FCStd"


def go_on(obj, more=0, wait=False):
    """Runs what waits in the study's folder, with so many cases more; with `wait` as for `start`. Returns the window_run.WindowRun. Throws UserError."""
    return _told(obj, window_run.WindowRun(folder_of(obj), obj.Jobs, more), wait)


def folder_of(obj):
    """Where the study's cases are: the folder of its name beside the document, where that is the study, moved or copied with the document; else the folder that
    it was run in. "" before it was run."""
    beside = os.path.join(os.path.dirname(obj.Document.FileName), os.path.basename(obj.Folder))
    is_study_there = obj.Folder and os.path.isdir(beside) and (not os.path.isdir(obj.Folder) or is_same_study(beside, obj.Folder))
    return beside if is_study_there else obj.Folder


def existing_folder_of(obj):
    """The same. Throws UserError where the study was run and its folder is gone."""
    path = folder_of(obj)
    if path and not os.path.isdir(path):
        raise UserError(said("the study's folder {path:text} is gone: bring it back, or run the study again", path=path))
    return path


def _told(obj, run, wait):
    for hook in on_run:
        hook(obj, run)
    if wait:
        run.wait()
    return run


def meshes_of(obj):
    """The meshes of ours that the part has."""
    return [mesh for mesh in api.meshes_of(obj.Document) if versions.part_of(mesh) is obj.Part]


def is_as_run(obj):
    """Does the object ask for what its folder's study asks for, but for the number of cases?"""
    try:
        kept = read_toml(os.path.join(folder_of(obj), "study.toml"))
        asked = study_of(obj, kept.document)
    except (UserError, OSError):
        return False
    same = {"cases": 0, "mesh_size": None, "mesh_order": None}   # the mesh may have been made since
    return {**asked.to_plain(), **same} == {**kept.to_plain(), **same}


def show_values(obj, assignments):
    """Gives the document the values of a case, or those that it had, as for api.edit: the part and its mesh follow, made where there is none. Throws
    UserError."""
    if not meshes_of(obj):
        api.add_mesh(obj.Part, **preferences.for_new_mesh())
        api.recompute(obj.Document)   # by that of the part as it is, loads and supports find their faces again
    api.edit(obj.Document, assignments)
    for mesh in meshes_of(obj):
        if not mesh.Automatic:
            api.update_mesh(mesh)


def dimensions_of(obj):
    """Every dimensions.Dimension of the study's part."""
    return dimensions.of_part(obj.Part) if obj.Part is not None else []


def place_on_part(obj, clicked, element):
    """Name on the study's part of what was clicked: an element of an object. Throws UserError for what is not on the part."""
    names = resolving.Resolver(obj.Part).names(clicked, element)
    if not names:
        raise UserError(said("select faces, edges or vertices of {part:text}", part=describe(obj.Part)))
    return names[0]


def is_for_live(analysis):
    """Is there a live solver that knows all that the analysis holds, and is it statics?"""
    if kind_of(analysis) != "static" or engine.load().statics_missing():
        return False
    try:
        statics_model.read(analysis, statics.mesh_of(analysis))
    except UserError:
        return False
    return True

# SPDX-License-Identifier: GPL-3.0-or-later
"""Results say by their labels when they are from before the last edit of the part."""

import FreeCAD

from . import analyses

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
# A property of results: which state of the mesh they were solved on.
SOLVED_ON = "SolvedOn"
_OF_NO_MESH = "-"
_SUFFIX = QT_TRANSLATE_NOOP("FeatureMesh", " (before the last edit)")
_KINDS = ("Fem::FemResultObject", "Fem::FemPostPipeline")
_states = {}   # (document, analysis) -> the state of its mesh when input for a solver was last written


def input_is_written(analysis):
    """To be called when a solver's input is written: its results belong to the mesh as it is now, however long they take."""
    state = _state_of_mesh(analysis)
    if state:
        _states[analysis.Document.Name, analysis.Name] = state


def forget(document):
    """To be called when a document was closed."""
    for key in [key for key in _states if key[0] == document.Name]:
        del _states[key]


def note(analysis):
    """To be called when an analysis has new members: notes on which mesh new results were solved."""
    new = [member for member in analysis.Group if is_result(member) and SOLVED_ON not in member.PropertiesList]
    if new:
        for result in new:
            _set_state(result, _states.get((analysis.Document.Name, analysis.Name)) or _state_of_mesh(analysis))
            _mark(result, _state_of_part(analysis))


def note_again(result, from_input=False):
    """To be called when a result was given other values: solved on the mesh as it is now, or as it was when the input was written."""
    for analysis in analyses.holding(result):
        written = _states.get((analysis.Document.Name, analysis.Name)) if from_input else None
        _set_state(result, written or _state_of_mesh(analysis))
        _mark(result, _state_of_part(analysis))


def mark(mesh):
    """To be called when the mesh has changed or no longer fits its part: the label of each result says whether it is from before that."""
    state = mesh.Proxy.state_of_part(mesh)
    for analysis in analyses.holding(mesh):
        for member in analysis.Group:
            if is_result(member):
                _mark(member, state)


def outdate(result):
    """To be called when something else of its analysis than the mesh was changed: the result is from before that."""
    if SOLVED_ON in result.PropertiesList:
        setattr(result, SOLVED_ON, _OF_NO_MESH)
        _mark(result, "")


def is_result(obj):
    """Does the object show what a solver found?"""
    return any(obj.isDerivedFrom(kind) for kind in _KINDS)


def is_old(result):
    """Is the result marked as one from before the last edit?"""
    return any(result.Label.endswith(suffix) for suffix in _suffixes())


def _mark(result, state):
    if not getattr(result, SOLVED_ON, ""):
        return
    label = result.Label
    for suffix in _suffixes():
        label = label[:-len(suffix)] if label.endswith(suffix) else label
    if getattr(result, SOLVED_ON) != state:
        label += translate("FeatureMesh", _SUFFIX)
    if label != result.Label:
        result.Label = label


def _suffixes():
    return _SUFFIX, translate("FeatureMesh", _SUFFIX)


def _state_of_mesh(analysis):
    """The state of our mesh in the analysis, which a solver takes as it is; "" where there is none."""
    mesh = _mesh_of(analysis)
    return mesh.Proxy.state_of_mesh(mesh) if mesh is not None else ""


def _state_of_part(analysis):
    """The same, but "" also where the mesh is not that of its part as it is."""
    mesh = _mesh_of(analysis)
    return mesh.Proxy.state_of_part(mesh) if mesh is not None else ""


def _mesh_of(analysis):
    """Our mesh in the analysis, None where there is none."""
    return next((mesh for mesh in analyses.meshes_of(analysis) if analyses.is_ours(mesh)), None) if analysis is not None else None


def _set_state(result, state):
    if not state:
        return
    if SOLVED_ON not in result.PropertiesList:
        result.addProperty("App::PropertyString", SOLVED_ON, "FeatureMesh", "The state of the mesh that was solved", 8 | 16)   # asks for no recompute
        result.setEditorMode(SOLVED_ON, 2)
    setattr(result, SOLVED_ON, state)

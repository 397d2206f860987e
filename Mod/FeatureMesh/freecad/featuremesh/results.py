# SPDX-License-Identifier: GPL-3.0-or-later
"""Results say by their labels when they are from before the last edit of the part, or of a load, support, material or section of their analysis."""

import hashlib

import FreeCAD

from . import analyses
from .proxies import HIDDEN, NO_TOUCH, type_of

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
# A property of results: which state of the mesh they were solved on and of what is in the analysis beside it.
SOLVED_ON = "SolvedOn"
_MARK = "OldMark"   # another one: what marks its label while it is old, in the language of who had it marked
_BESIDE = " with "   # between the two
_OF_NO_MESH = "-"
_SUFFIX = QT_TRANSLATE_NOOP("FeatureMesh", " (before the last edit)")
_DUPLICATES = "DuplicateLabels"   # a preference of FreeCAD's: several objects may have one label
_KINDS = ("Fem::FemResultObject", "Fem::FemPostPipeline")
_MEMBERS = ("Fem::Constraint", "Fem::Element", "Fem::Material")   # how the types of FEM's objects in Python begin
# Properties that FreeCAD computes for what it draws or lists in a panel, or that say nothing of what is solved.
_DRAWN = {"Label", "Label2", "Visibility", "Proxy", "ExpressionEngine", "Scale", "Points", "Normals", "NormalDirection", "DirectionVector", "BasePoint", "Axis",
          "RefDispl", "NameDispl"}
_states = {}   # (document, analysis) -> the state of its mesh and its members when input for a solver was last written


def input_is_written(analysis):
    """To be called when a solver's input is written: its results belong to the mesh and the loads as they are now, however long they take."""
    state = _state_as_solved(analysis)
    if state:
        _states[analysis.Document.Name, analysis.Name] = state


def forget(document):
    """To be called when a document was closed."""
    for key in [key for key in _states if key[0] == document.Name]:
        del _states[key]


def note(analysis):
    """To be called when an analysis has other members: notes on which mesh new results were solved."""
    for result in analysis.Group:
        if is_result(result) and SOLVED_ON not in result.PropertiesList:
            _set_state(result, _states.get((analysis.Document.Name, analysis.Name)) or _state_as_solved(analysis))
    _mark_all(analysis)


def note_again(result, from_input=False):
    """To be called when a result was given other values: solved on the mesh as it is now, or as it was when the input was written."""
    for analysis in analyses.holding(result):
        written = _states.get((analysis.Document.Name, analysis.Name)) if from_input else None
        _set_state(result, written or _state_as_solved(analysis))
        _mark(result, _state_as_it_is(analysis))


def mark(mesh):
    """To be called when the mesh has changed or no longer fits its part: the label of each result says whether it is from before that."""
    for analysis in analyses.holding(mesh):
        _mark_all(analysis)


def mesh_is_as_before(mesh, before, now):
    """To be called when a mesh with the same nodes and elements has another state: what was solved on it is solved on that."""
    for analysis in analyses.holding(mesh):
        key = analysis.Document.Name, analysis.Name
        if key in _states:
            _states[key] = _on(_states[key], before, now)
        for result in analysis.Group:
            if is_result(result) and SOLVED_ON in result.PropertiesList:
                setattr(result, SOLVED_ON, _on(getattr(result, SOLVED_ON), before, now))
        _mark_all(analysis)


def _on(state, before, now):
    return now + state[len(before):] if state.split(_BESIDE)[0] == before else state


def member_changed(obj, name):
    """To be called when a property of an object has another value: that may be a load of results."""
    if name not in _DRAWN and _is_solved_with(obj):
        for analysis in analyses.holding(obj):
            _mark_all(analysis)


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
    return any(result.Label.endswith(suffix) for suffix in _suffixes(result))


def _mark_all(analysis):
    solved = [member for member in analysis.Group if is_result(member)]
    state = _state_as_it_is(analysis) if solved else ""
    for result in solved:
        _mark(result, state)


def _mark(result, state):
    if not getattr(result, SOLVED_ON, ""):
        return
    label = result.Label
    for suffix in _suffixes(result):
        label = label.replace(suffix, "")   # of a copy that FreeCAD has numbered it is not the end
    solved_on = getattr(result, SOLVED_ON)
    if solved_on != (state if _BESIDE in solved_on else state.split(_BESIDE)[0]):
        label += translate("FeatureMesh", _SUFFIX)
        _note(result, _MARK, translate("FeatureMesh", _SUFFIX))
    if label != result.Label:
        _set_label(result, label)


def _set_label(result, label):
    """FreeCAD 1.1 counts the label of an object whose view is in Python twice, and would not give it back to the only one that had it."""
    result.Label = label
    if result.Label != label and not result.Document.getObjectsByLabel(label):
        settings = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Document")
        settings.SetBool(_DUPLICATES, True)
        try:
            result.Label = label
        finally:
            settings.SetBool(_DUPLICATES, False)


def _suffixes(result):
    return _SUFFIX, translate("FeatureMesh", _SUFFIX), getattr(result, _MARK, _SUFFIX)


def _state_as_solved(analysis):
    """The state of our mesh in the analysis, which a solver takes as it is, and of the members; "" where there is no mesh of ours."""
    mesh = _mesh_of(analysis)
    return _with_members(analysis, mesh.Proxy.state_of_mesh(mesh)) if mesh is not None else ""


def _state_as_it_is(analysis):
    """The same, but "" also where the mesh is not that of its part as it is."""
    mesh = _mesh_of(analysis)
    return _with_members(analysis, mesh.Proxy.state_of_part(mesh)) if mesh is not None else ""


def _with_members(analysis, state):
    values = {member.Name: _values_of(member) for member in analysis.Group if _is_solved_with(member)} if state else None
    return state + _BESIDE + hashlib.sha256(repr(sorted(values.items())).encode()).hexdigest()[:16] if state else ""


def _values_of(member):
    """Name and value, as text, of what of a member a solver may look at."""
    return [(name, _as_text(getattr(member, name))) for name in sorted(member.PropertiesList) if name not in _DRAWN]


def _as_text(value):
    """Objects by name, numbers to twelve digits; what else has no text but its place in memory is no value."""
    if isinstance(value, FreeCAD.DocumentObject):
        return value.Name
    if isinstance(value, FreeCAD.Units.Quantity):
        value = value.Value
    elif isinstance(value, FreeCAD.Placement):
        value = *value.Base, *value.Rotation.Q
    if isinstance(value, float):
        return "%.12g" % value
    if isinstance(value, dict):
        return sorted(value.items())
    if isinstance(value, (list, tuple, FreeCAD.Vector)):
        return [_as_text(one) for one in value]
    return str(value) if isinstance(value, (int, str)) else ""


def _is_solved_with(obj):
    """Is it a load, a support, a material or a section, or what else FEM has of that kind?"""
    return obj.isDerivedFrom("Fem::Constraint") or obj.isDerivedFrom("App::MaterialObject") or \
        type_of(obj).startswith(_MEMBERS)


def _mesh_of(analysis):
    """Our mesh in the analysis, None where there is none."""
    return next((mesh for mesh in analyses.meshes_of(analysis) if analyses.is_ours(mesh)), None) if analysis is not None else None


def _set_state(result, state):
    if state:
        _note(result, SOLVED_ON, state)


def _note(result, name, text):
    """In a property that nobody sees."""
    if name not in result.PropertiesList:
        result.addProperty("App::PropertyString", name, "FeatureMesh", "", NO_TOUCH)
        result.setEditorMode(name, HIDDEN)
    if getattr(result, name) != text:
        setattr(result, name, text)

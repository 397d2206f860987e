# SPDX-License-Identifier: GPL-3.0-or-later
"""What our commands and panels did, as FreeCAD's own tell it: lines in the Python console, and in a macro while one is recorded, that do the same in a script."""

import importlib
import keyword
import re
import sys
import types

import FreeCAD
import FreeCADGui as Gui

from .. import versions

# (document's name, object's name) -> the call that made the object, and its line, until that is told; {property: its text}, as far as that was told;
# what the line that was told calls it.
_made, _watched, _variables = {}, {}, {}
_NOT_TOLD = {"ExpressionEngine", "FemMesh", "Group", "Label", "Label2", "Proxy", "Shape", "Visibility"}
_WORD = re.compile(r"[A-Za-z_]\w*")


def install():
    """To be called once."""
    FreeCAD.addDocumentObserver(_Observer())


def run(call, *words, **named):
    """Calls a function of the model's side, and tells that. Returns what it returns."""
    result = call(*words, **named)
    tell(call, *words, **named)
    return result


def tell(call, *words, **named):
    """Tells a call that was made already."""
    _tell_import(call)
    _tell(_in_words(call, words, named))


def make(call, *words, **named):
    """Calls a function that adds an object, and returns that. It is told when its transaction ends, with what was set meanwhile, and never if that is aborted."""
    return made(call(*words, **named), call, *words, **named)


def made(obj, call, *words, **named):
    """The object was added by this call, which is told by the next `write`, or at the end of a transaction."""
    _made[_key(obj)] = call, "%s = %s" % (_variable(call), _in_words(call, words, named))
    watch(obj)
    return obj


def watch(obj):
    """From now on a panel changes the object: what has another value at the end of a transaction is told."""
    _watched[_key(obj)] = _settings_of(obj)


def write(obj):
    """Tells what is not told yet of an object that is watched."""
    before = _watched.get(_key(obj))
    if before is None:
        return
    if _key(obj) in _made:
        call, line = _made.pop(_key(obj))
        _tell_import(call)
        _tell(line, {_variable(call): obj})
        _variables[_key(obj)] = _variable(call)
    now = _watched[_key(obj)] = _settings_of(obj)
    for name, text in now.items():
        if before.get(name) != text:
            _tell("%s.%s = %s" % (_text(obj), name, text))


def recomputed(document):
    """Tells that the document was recomputed."""
    _tell(_text(document) + ".recompute()")


def is_told(obj):
    """Was it told that the object was made, by a command whose panel is still open?"""
    return _key(obj) in _variables


def forget(obj):
    """The object's panel is closed."""
    for known in (_made, _watched, _variables):
        known.pop(_key(obj), None)


class _Observer:

    def slotCommitTransaction(self, document):
        for name in [name for owner, name in _watched if owner == document.Name]:
            obj = document.getObject(name)
            if obj is not None:
                write(obj)

    def slotDeletedObject(self, obj):
        forget(obj)

    def slotDeletedDocument(self, document):
        for known in (_made, _watched, _variables):
            for key in [key for key in known if key[0] == document.Name]:
                del known[key]


def _key(obj):
    return obj.Document.Name, obj.Name


def _variable(call):
    """add_size_zone -> size_zone"""
    return call.__name__.partition("_")[2]


def _in_words(call, words, named):
    texts = [_text(value) for value in words] + ["%s=%s" % (name, _text(value)) for name, value in named.items() if value is not None]
    return "%s.%s(%s)" % (call.__module__.rpartition(".")[2], call.__name__, ", ".join(texts))


def _settings_of(obj):
    """{property: the text of its value} of what is set, not found."""
    found = {name: getattr(obj, name) for name in obj.PropertiesList
             if name not in _NOT_TOLD and obj.getGroupOfProperty(name) != "Result" and "Hidden" not in obj.getEditorMode(name)}
    return {name: _text(value) for name, value in found.items() if _has_text(value)}


def _has_text(value):
    if isinstance(value, (list, tuple)):
        return all(map(_has_text, value))
    return value is None or isinstance(value, (bool, int, float, str, FreeCAD.Units.Quantity, FreeCAD.Vector, FreeCAD.Placement, FreeCAD.DocumentObject))


def _text(value):
    """As a script has it; lengths are in mm."""
    if isinstance(value, FreeCAD.Units.Quantity):
        return repr(value.Value)
    if isinstance(value, FreeCAD.Vector):
        return "App.Vector(%r, %r, %r)" % tuple(value)
    if isinstance(value, FreeCAD.Placement):
        return "App.Placement(%s, App.Rotation(%r, %r, %r, %r))" % (_text(value.Base), *value.Rotation.Q)
    if isinstance(value, FreeCAD.Document):
        return _text_of_document(value)
    if isinstance(value, FreeCAD.DocumentObject):
        return _variables.get(_key(value)) or "%s.getObject(%r)" % (_text_of_document(value.Document), value.Name)
    if isinstance(value, list):
        return "[%s]" % ", ".join(map(_text, value))
    if isinstance(value, tuple):
        return "(%s)" % "".join(_text(entry) + ", " for entry in value).rstrip(" " if len(value) == 1 else ", ")
    return repr(value)


def _text_of_document(document):
    return "App.ActiveDocument" if document is FreeCAD.ActiveDocument else "App.getDocument(%r)" % document.Name


def _tell_import(call):
    package, _, name = call.__module__.rpartition(".")
    _tell("from %s import %s" % (package, name), {name: importlib.import_module(call.__module__)})


def _tell(line, names=None):
    """Into the console, and the macro; `names` are what the line would give a value there. FreeCAD before 1.1 runs what it is told, so it is given names that do
    nothing."""
    main = sys.modules["__main__"]
    if versions.tells_without_running():
        Gui.doCommandSkip(line)
    else:
        stage = types.ModuleType("__main__")
        if names is None or not line.startswith("from "):
            stage.__dict__.update({word: _Nothing() for word in _WORD.findall(line) if not keyword.iskeyword(word)})
        sys.modules["__main__"] = stage
        try:
            Gui.doCommand(line)
        finally:
            sys.modules["__main__"] = main
    main.__dict__.update(names or {})


class _Nothing:
    """Whatever is done with it, nothing happens."""

    def __getattr__(self, name):
        return self

    def __setattr__(self, name, value):
        pass

    def __call__(self, *words, **named):
        return self

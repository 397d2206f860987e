# SPDX-License-Identifier: GPL-3.0-or-later
"""What FreeCAD could not recompute. It leaves everything that depends on such an object as it was, without a word to it."""

import FreeCAD

from .errors import UserError
from .messages import said
from .reading import dependencies, describe, error_of


class NotRecomputed(UserError):
    """FreeCAD could not; it says which object, and why."""


# Called after a recompute with the document and the objects that are in error and were not before.
on_errors = []
_observer = None


def in_error(document):
    """The objects of the document that are in error."""
    return {obj for obj in document.Objects if error_of(obj)}


def first_error(depends_on, objects):
    """The NotRecomputed of the first that is among the objects in error, with FreeCAD's message; None where none is."""
    failed = next((obj for obj in depends_on if obj in objects), None)
    return failed and NotRecomputed(said("FreeCAD cannot recompute {object:text}: {error:text}", object=describe(failed), error=error_of(failed)))


def error_of_part(part, objects):
    """The same of what the part's shape comes from, and of whatever else FreeCAD recomputes before the part, such as a datum line in its body."""
    return first_error([*dependencies(part), *part.OutListRecursive], objects) if part is not None and objects else None


def watch(hook):
    """Calls the hook from now on, see on_errors."""
    global _observer
    on_errors.append(hook)
    if _observer is None:
        _observer = _Observer()
        FreeCAD.addDocumentObserver(_observer)


class _Observer:
    """FreeCAD 1.1 has no word before a recompute; so what was in error is known from the one before."""

    def __init__(self):
        self._known = {}   # by the name of a document: the names of its objects that were in error when its last recompute ended

    def slotRecomputedDocument(self, document):
        found = in_error(document)
        known = self._known.get(document.Name, ())
        self._known[document.Name] = {obj.Name for obj in found}
        new = {obj for obj in found if obj.Name not in known}
        for hook in on_errors if new else ():
            hook(document, new)

    def forget(self, document):
        """All errors that the next recompute finds are new ones."""
        self._known.pop(document.Name, None)

    slotUndoDocument = slotRedoDocument = slotAbortTransaction = slotDeletedDocument = forget

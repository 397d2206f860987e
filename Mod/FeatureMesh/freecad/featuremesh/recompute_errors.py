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
    """The objects of the document, and of those that it links to and FreeCAD recomputes with it, that are in error."""
    return {obj for one in document.getDependentDocuments(False) for obj in one.Objects if error_of(obj)}


def first_error(document, depends_on, objects):
    """For who looks from `document`: the NotRecomputed of the first that is among the objects in error, with FreeCAD's message; None where none is."""
    failed = next((obj for obj in depends_on if obj in objects), None)
    if failed is None:
        return None
    where = "" if failed.Document == document else failed.Document.Label + "#"   # as expressions name it
    return NotRecomputed(said("FreeCAD cannot recompute {object:text}: {error:text}", object=where + describe(failed), error=error_of(failed)))


def error_of_part(part, objects):
    """The same of what the part's shape comes from, and of whatever else FreeCAD recomputes before the part, such as a datum line in its body."""
    return first_error(part.Document, [*dependencies(part), *part.OutListRecursive], objects) if part is not None and objects else None


def remarks(part):
    """What is to be known of a mesh of the part as it is while FreeCAD cannot recompute it."""
    error = error_of_part(part, in_error(part.Document))
    return [said("{why:messages}; the mesh is that of {part:text} as it was before", why=error.message, part=describe(part))] if error is not None else []


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
        self._known = {}   # by the name of a document: what was in error when its last recompute ended, as the names of documents and objects

    def slotRecomputedDocument(self, document):
        found = in_error(document)
        known = self._known.get(document.Name, ())
        self._known[document.Name] = {(obj.Document.Name, obj.Name) for obj in found}
        new = {obj for obj in found if (obj.Document.Name, obj.Name) not in known}
        for hook in on_errors if new else ():
            hook(document, new)

    def forget(self, document):
        """All errors that the next recompute finds are new ones."""
        self._known.pop(document.Name, None)

    slotUndoDocument = slotRedoDocument = slotAbortTransaction = slotDeletedDocument = forget

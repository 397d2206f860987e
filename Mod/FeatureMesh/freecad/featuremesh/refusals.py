# SPDX-License-Identifier: GPL-3.0-or-later
"""What scripts give by mistake is refused in a sentence, and leaves nothing behind: documents, references, lengths."""

import contextlib
import math

import FreeCAD

from . import versions
from .errors import UserError
from .messages import said
from .reading import describe, refuse_gone


@contextlib.contextmanager
def all_or_nothing(document):
    """Takes the objects that were added to the document meanwhile out again when an error, or Ctrl-C, ends that."""
    before = set(document.Objects)
    try:
        yield
    except BaseException:
        for name in [obj.Name for obj in document.Objects if obj not in before]:
            if document.getObject(name) is not None:   # it may have gone with another one
                document.removeObject(name)
        raise


def refuse_no_document(document):
    """Throws UserError for what is no open document."""
    try:
        document.Objects
    except ReferenceError:
        raise UserError(said("the document was closed")) from None
    except AttributeError:
        raise UserError(said("{document:text} is no open document", document=str(document))) from None


def part_to_mesh(mesh):
    """The part of a mesh object. Throws UserError where it has none."""
    part = versions.part_of(mesh)
    if part is None:
        raise UserError(no_part(mesh))
    return part


def no_part(mesh):
    """That a mesh object has none."""
    return said("{mesh:text} has no part to mesh, set its property {property:text}", mesh=describe(mesh), property=versions.part_property(mesh))


def pairs_given(references, part):
    """(object, name) pairs of what a script gives: a name of the part or an object, such a pair, one with several names as FreeCAD's own References have
    them, or a list of any of these. Throws UserError."""
    if isinstance(references, list) or isinstance(references, tuple) and not _is_pair(references):
        return [pair for reference in references for pair in pairs_given(reference, part)]
    if isinstance(references, FreeCAD.DocumentObject):
        return [(references, "")]
    if isinstance(references, str):
        return [(part, references)]
    if not _is_pair(references):
        raise UserError(said('a reference is an object and a name, such as (part, "Face3"), not {reference:text}', reference=str(references)))
    obj, names = references
    refuse_gone(obj)
    return [(obj, name) for name in ([names] if isinstance(names, str) else names)]


def _is_pair(reference):
    """An object and a name, or several: names alone are none."""
    if not isinstance(reference, tuple) or len(reference) != 2 or isinstance(reference[0], (str, tuple, list)):
        return False
    names = reference[1]
    return isinstance(names, str) or isinstance(names, (tuple, list)) and all(isinstance(name, str) for name in names)


def length_of(value):
    """A number, a quantity or a text such as "0.5 in" in mm. Throws UserError."""
    bare = FreeCAD.Units.Unit()
    with contextlib.suppress(TypeError, ValueError):
        if getattr(value, "Unit", bare) == bare:   # a quantity is a number, too, such as 5 of 5 degrees
            return float(value)
    with contextlib.suppress(TypeError, ValueError, ArithmeticError, OSError):
        quantity = FreeCAD.Units.Quantity(value)
        if quantity.Unit == FreeCAD.Units.Length:
            return quantity.Value
    raise UserError(said("{value:text} is no length", value=str(value)))


def finite_length(value):
    """As length_of, but no infinity. Throws UserError."""
    length = length_of(value)
    if not math.isfinite(length):
        raise UserError(said("{value:text} is no length", value=str(value)))
    return length


def measure_of(name, value):
    """A measure of that name, mm, 0 or more. Throws UserError."""
    length = finite_length(value)
    if length < 0:
        raise UserError(said("{property:text} has to be 0 mm or more, not {value:number}", property=name, value=length))
    return length


def refuse_no_size(size):
    """Throws UserError for what is no edge length, mm."""
    if not size > 0 or math.isinf(size):
        raise UserError(said("the size has to be greater than 0 mm, not {size:number}", size=size))

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
        raise UserError(said("{mesh:text} has no part to mesh, set its property {property:text}", mesh=describe(mesh), property=versions.part_property(mesh)))
    return part


def refuse_no_references(references):
    """Throws UserError for what are no (object, "Face3") pairs."""
    for pair in references:
        if not (isinstance(pair, (tuple, list)) and len(pair) == 2 and isinstance(pair[1], str)):
            raise UserError(said('a reference is an object and a name, such as (part, "Face3"), not {reference:text}', reference=str(pair)))
        refuse_gone(pair[0])


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

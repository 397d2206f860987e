# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps loads, supports, materials and refinements where they were when an edit gives faces, edges and solids other numbers.

FreeCAD 0.20 knows them by number only: a constraint on Face11 stays on Face11 when that number comes to mean another face. Since 1.0
FreeCAD follows them itself, and marks with a question mark ("?Face11") what it lost. The feature difference knows which face became
which: references that are still as they were at the last mesh are put right, and every change and every loss is reported.
"""

import re

from . import versions
from .numbering import Numbering

_LOST = "?"
_SUB_ELEMENT = re.compile(r"(Face|Edge|Vertex|Solid)\d+$")


def references_of(objects, part):
    """{object name: sub-elements of `part` that it refers to}, to be compared later."""
    return {obj.Name: names for obj, names in ((obj, _names(obj, part)) for obj in objects) if names}


def are_lost(objects, part):
    """Has FreeCAD itself lost what one of the objects refers to?"""
    return any(name.startswith(_LOST) for obj in objects for name in _names(obj, part))


def follow(objects, part, before, faces, old_shape):
    """Moves the references of `objects` to what theirs became. Returns a line for each thing to know.

    `before` is what references_of said at the last mesh, `faces` the face changes of the feature difference since then, `old_shape` a
    function that gives the part's shape at the last mesh.
    """
    numbering = Numbering(faces, old_shape, part.Shape)
    lines = []
    for obj in objects:
        names = _names(obj, part)
        if not names or not versions.follows_faces() and names != before.get(obj.Name):
            continue
        moved = {}
        for name in names:
            if not _is_to_be_followed(name):
                continue
            now = numbering.now(name.lstrip(_LOST))
            if not now:
                lines.append(_what_was_lost(obj, name.lstrip(_LOST)))
            elif now != [name]:
                moved[name] = now
        if moved:
            obj.References = [(target, tuple(_moved(subs, moved) if target is part else subs))
                              for target, subs in _pairs(obj)]
            lines += ["%s: %s is now %s, its reference was changed" % (obj.Label, old.lstrip(_LOST), ", ".join(new))
                      for old, new in moved.items()]
    return lines


def _is_to_be_followed(name):
    """On 0.20 every number may have got another meaning, since 1.0 only what FreeCAD lost."""
    if versions.follows_faces() and not name.startswith(_LOST):
        return False
    return bool(_SUB_ELEMENT.match(name.lstrip(_LOST)))


def _what_was_lost(obj, name):
    kind = name.rstrip("0123456789").lower()
    return "%s refers to %s, which is gone; choose another %s" % (obj.Label, name, kind)


def _names(obj, part):
    return [name for target, subs in _pairs(obj) if target is part for name in subs]


def _pairs(obj):
    return [(target, (subs,) if isinstance(subs, str) else tuple(subs))
            for target, subs in getattr(obj, "References", None) or []]


def _moved(subs, moved):
    result = []
    for name in subs:
        result += [new for new in moved.get(name, [name]) if new not in result]
    return result

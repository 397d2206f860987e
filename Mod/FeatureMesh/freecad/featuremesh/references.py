# SPDX-License-Identifier: GPL-3.0-or-later
"""Follows faces through an edit for FreeCAD versions that know them by number only.

On 0.20 a constraint on Face11 stays on Face11 when an edit makes that number mean another face. The feature difference knows
which face became which; references that are still as they were at the last mesh are put right, and every change is reported.
"""

import re


def references_of(objects, part):
    """{object name: sub-elements of `part` that it refers to}, to be compared later."""
    found = {}
    for obj in objects:
        names = [name for target, subs in _pairs(obj) if target is part for name in subs]
        if names:
            found[obj.Name] = names
    return found


def follow(objects, part, before, faces):
    """Moves the references of `objects` to the faces that theirs became. Returns a line for each thing to know.

    `before` is what references_of said at the last mesh, `faces` the face changes of the feature difference since then.
    """
    became, new_names = _mapping(faces)
    renumbered = any(new != [old] for old, new in became.items())
    lines = []
    for obj in objects:
        names = [name for target, subs in _pairs(obj) if target is part for name in subs]
        if not names or names != before.get(obj.Name):
            continue
        moved = {}
        for name in names:
            if name in became:
                if became[name] != [name]:
                    moved[name] = became[name]
            elif name.startswith("Face") and name not in new_names:
                lines.append("%s refers to %s, which is gone; choose another face" % (obj.Label, name))
            elif renumbered and re.match(r"(Edge|Vertex)\d", name):
                lines.append("%s refers to %s, and the edit renumbered faces; check it" % (obj.Label, name))
        if moved:
            obj.References = [(target, tuple(_moved(subs, moved) if target is part else subs))
                              for target, subs in _pairs(obj)]
            lines += ["%s: %s is now %s, its reference was changed" % (obj.Label, old, ", ".join(new))
                      for old, new in moved.items()]
    return lines


def _pairs(obj):
    return [(target, (subs,) if isinstance(subs, str) else tuple(subs))
            for target, subs in getattr(obj, "References", None) or []]


def _mapping(faces):
    """Old face -> sorted new faces that it became; and the new faces that came from nowhere."""
    became, new = {}, set()
    for change in faces:
        if change["old_face"] and change["new_face"]:
            became.setdefault(change["old_face"], set()).add(change["new_face"])
        elif change["new_face"]:
            new.add(change["new_face"])
    return {old: sorted(names, key=lambda name: int(name[4:])) for old, names in became.items()}, new


def _moved(subs, moved):
    result = []
    for name in subs:
        result += [new for new in moved.get(name, [name]) if new not in result]
    return result

# SPDX-License-Identifier: GPL-3.0-or-later
"""What loads, supports and refinements have lost while their document is open comes back with its feature: a body's tip is moved up to put another feature
in between, or a feature is suppressed for a while."""

import FreeCAD

from . import references
from .copied_part import renamed
from .messages import said

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
_DELETED = " (deleted)"
_STATES = 30   # more than FreeCAD has steps of undo
_THERE_AGAIN = QT_TRANSLATE_NOOP("FeatureMesh", "{object:text}: there again, and referred to as before: {now:entities}")


class LostReferences:
    """Of one mesh object."""

    def __init__(self):
        self._entries = {}   # name of an object -> [(the part as it was read when it had them, property, names of sub-elements, was it marked for that?)]
        self._of_states = {}   # the same of states of the mesh that undo may bring back, by their checksums

    def keep(self, checksum):
        """To be called before the mesh of that state gets another one."""
        self._of_states.pop(checksum, None)
        self._of_states[checksum] = {name: list(entries) for name, entries in self._entries.items()}
        if len(self._of_states) > _STATES:
            self._of_states.pop(next(iter(self._of_states)))

    def go_back(self, before, now):
        """To be called when undo or redo gave the mesh the state with the checksum `now` in place of that `before`."""
        self.keep(before)
        self._entries.update({name: list(entries) for name, entries in self._of_states.get(now, {}).items()})

    def note(self, obj, raw, lost):
        """`lost` is what references.follow gives."""
        entries = self._entries.setdefault(obj.Name, [])
        for prop, names in lost.items():
            if names and references.is_marked(obj, prop):
                entries[:] = [entry for entry in entries if entry[1] != prop or not entry[3]]   # somebody chose anew since
            if names:
                entries.append((raw, prop, names, references.is_marked(obj, prop)))

    def chosen_anew(self, obj):
        """To be called when somebody has chosen anew for an object. What it was marked for does not count without the mark, which undo and Cancel bring back."""
        self._entries[obj.Name] = [entry for entry in self._entries.get(obj.Name, []) if entry[3]]

    def forget(self, name):
        """To be called when another object got the name of one that was deleted: what is lost of that does not come back with this one."""
        self._entries.pop(name, None)
        parts = {id(raw): raw for entries in self._entries.values() for raw, *_ in entries}
        parts = {key: renamed(raw, {name: name + _DELETED}) for key, raw in parts.items()}
        self._entries = {obj: [(parts[id(raw)], *rest) for raw, *rest in entries] for obj, entries in self._entries.items()}

    def bring_back(self, obj, resolver, numbering_from):
        """Gives an object what the part has again. Returns a line for each thing to know. `numbering_from` gives the Numbering from a part to today's."""
        lines, gone, entries = [], [], self._entries.pop(obj.Name, [])
        inert = [entry for entry in entries if entry[3] and not references.is_marked(obj, entry[1])]
        for raw, prop, names, _ in (entry for entry in entries if entry not in inert):
            numbering = numbering_from(raw)
            now = [new for name in names for new in numbering.now(name)]
            if now and references.take_back(obj, resolver, prop, now):
                lines.append(said(_THERE_AGAIN, object=obj.Label, now=now))
            left = [name for name in names if not numbering.now(name)] if references.may_change(obj, resolver) else names
            gone += [(raw, prop, left)] if left else []
        if gone or inert:
            self._entries[obj.Name] = inert + [(*entry, references.is_marked(obj, entry[1])) for entry in gone]
        return lines

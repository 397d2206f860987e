# SPDX-License-Identifier: GPL-3.0-or-later
"""The part as it was when an object was given references after the last mesh: these mean its faces, not those of the part that was meshed. The mesh object
keeps it beside its record of references for as long as that names it."""

import base64
import json
import zlib

import numpy as np

from . import state
from .reading import elements_of_today, with_elements
from .references import differs

_STATES = 20   # as many as FreeCAD has steps of undo


class NotedParts:
    """Of one mesh object."""

    def __init__(self):
        self._parts = {}    # by what the record calls it: the part as reading.read_document gives it
        self._packed = {}   # the same as text
        self._last = {}, None   # the record that was stored last, which an undo does not bring back, and the part that was meshed then
        self._stored = {}   # by a record and the checksum of the mesh's state when it was stored: the part that was meshed then, of the last ones

    def name_of(self, raw):
        """What the record is to call the part as it was read."""
        bits = {"records": json.dumps(raw["records"], sort_keys=True).encode(), "shapes": raw["shapes"]}
        name = state.digest({key: np.frombuffer(data, dtype=np.uint8) for key, data in bits.items()}).hex()
        if name not in self._parts:
            self._parts[name], self._packed[name] = raw, _packed(raw)
        return name

    def part(self, name):
        """The part that the record calls so; None where it is gone."""
        return self._parts.get(name)

    def left_by_undo(self, mesh, record, objects):
        """{name: entry of the record}, each with its part, of those of the objects whose references an undo or redo has left as they were, and of all in a `record` of another
        mesh than it has left: FreeCAD takes back what a step set, and no more."""
        last, meshed = self._last
        left = {obj.Name: (last[obj.Name], meshed) for obj in objects if meshed is not None and obj.Name in last and not differs(obj, last[obj.Name], ())}
        text, checksum = _key(mesh)
        parts = [part for (stored, _), part in self._stored.items() if stored == text and part is not None]
        if parts and (text, checksum) not in self._stored and any(checksum == known for _, known in self._stored):
            left = {**{name: (known, parts[-1]) for name, known in record.items() if "of" not in known}, **left}
        return {name: {"of": self.name_of(part), **known} for name, (known, part) in left.items()}

    def store(self, mesh, record, meshed):
        """To be called with each new record, which the mesh has already, and the part as it was meshed last."""
        self._last = record, meshed
        self._stored.pop(_key(mesh), None)
        self._stored[_key(mesh)] = meshed
        self._stored.update(dict.fromkeys(list(self._stored)[:-_STATES]))
        names = {known["of"] for known in record.values() if "of" in known}
        text = json.dumps({name: self._packed[name] for name in sorted(names) if name in self._packed}) if names else ""
        if mesh.NotedParts != text:
            mesh.NotedParts = text

    def load(self, mesh):
        """To be called when the document was opened, with the sketch elements that it has now."""
        self._packed = json.loads(mesh.NotedParts or "{}")
        for name, text in self._packed.items():
            raw = _unpacked(text)
            self._parts[name] = with_elements(raw, elements_of_today(raw, mesh.Document))
        self._stored[_key(mesh)] = None


def _key(mesh):
    return hash(mesh.ReferredTo), state.checksum_of(mesh.SavedState)


def _packed(raw):
    words = json.dumps({**raw, "shapes": base64.b64encode(raw["shapes"]).decode()})
    return base64.b64encode(zlib.compress(words.encode())).decode()


def _unpacked(text):
    raw = json.loads(zlib.decompress(base64.b64decode(text)))
    return {**raw, "shapes": base64.b64decode(raw["shapes"])}

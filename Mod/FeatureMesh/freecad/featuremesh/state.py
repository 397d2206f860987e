# SPDX-License-Identifier: GPL-3.0-or-later
"""The saved state of a mesh: everything a later update needs, in one .npz file.

Members: `meta` (JSON: schema, program versions, options, the raw records), `shapes` (binary BREP), `array.<name>` (the mesh
as PartMesh.arrays gives it) and `checksum` over all of these. Never a pickle.
"""

import contextlib
import hashlib
import json
import os
import shutil
import zipfile
from dataclasses import dataclass, field

import FreeCAD
import numpy as np

from . import __version__, whole_file
from .errors import StateError
from .messages import said

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
_DAMAGED = QT_TRANSLATE_NOOP("FeatureMesh", "the saved mesh state is damaged ({why:messages})")
SCHEMA = 3
_NO_ROOM = 1 << 16   # bytes; a disk with less is full
_PIECE = 1 << 22   # bytes that are compressed at a time


def _with_all_arrays(meta, members):
    """1 to 2: arrays with nothing in them were left out, and that narrow faces were refined was told by an empty array being there."""
    left_out = {"made_for_nodes": np.zeros(0, np.int32), "made_for_sizes": np.zeros(0), "adopted_sizes": np.zeros((0, 4)), "ignored_below": np.zeros(1)}
    refined = {"array.refined_narrow_faces": np.array(["array.refined_narrow_faces" in members])}
    return meta, {**{"array." + name: values for name, values in left_out.items()}, **members, **refined}


def _with_shared_nodes(meta, members):
    """2 to 3: which nodes stand for merged entities was not told; the next mesh does."""
    return meta, {"array.shared_nodes": np.zeros((0, 3), np.int32), **members}


# Schema n -> function that turns the (meta, members) of a file of schema n into those of n + 1.
MIGRATIONS = {1: _with_all_arrays, 2: _with_shared_nodes}


@dataclass
class State:
    """What a mesh was made of, and the mesh."""
    raw: dict                                       # as reading.read_document gives it
    options: dict                                   # as the engine takes them
    arrays: dict = field(default_factory=dict)      # as PartMesh.arrays gives them
    references: dict = field(default_factory=dict)  # what constraints referred to, in states from before mesh objects knew it themselves

    @property
    def part_name(self):
        """Name of the object that was meshed."""
        return self.raw["final_object"]


def save(path, state):
    """Writes the state to `path`, whole or not at all. Returns its checksum as a hex string."""
    meta = {
        "schema": SCHEMA,
        "program": __version__,
        "options": state.options,
        "final_object": state.raw["final_object"],
        "records": state.raw["records"],
        "references": state.references,
    }
    members = {"meta": _bytes_to_array(json.dumps(meta, sort_keys=True).encode()),
               "shapes": _bytes_to_array(state.raw["shapes"])}
    members.update(("array." + name, np.ascontiguousarray(values)) for name, values in state.arrays.items())
    if any(values.dtype.hasobject for values in members.values()):
        raise TypeError("a state holds plain numbers only")
    checksum = digest(members)
    members["checksum"] = _bytes_to_array(checksum)
    with whole_file.replaced(path) as place, open(place, "wb") as stream:
        np.savez(stream, **members)
    return checksum.hex()


def compress(path):
    """Rewrites the file of a state so that it takes less space, in any thread. It is the same state at any time; a file that is gone meanwhile stays gone."""
    beside = path + ".less"
    try:
        with zipfile.ZipFile(path) as whole, zipfile.ZipFile(beside, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as less:
            for name in whole.namelist():
                with whole.open(name) as source, less.open(name, "w", force_zip64=True) as target:
                    shutil.copyfileobj(source, target, _PIECE)
        if os.path.exists(path):
            os.replace(beside, path)
    except (OSError, zipfile.BadZipFile):   # a full disk, say
        pass
    finally:
        with contextlib.suppress(OSError):
            os.unlink(beside)


def load(path):
    """The state in `path`, brought to today's schema. Throws StateError: missing, damaged, newer."""
    members = _read_members(path)
    checksum = members.pop("checksum", None)
    if checksum is None or checksum.tobytes() != digest(members):
        raise StateError(said(_DAMAGED, why=said("its checksum is wrong")))
    meta = json.loads(members.pop("meta").tobytes())
    if meta["schema"] > SCHEMA:
        raise StateError(said("the saved mesh state is from a newer FeatureMesh ({program:text}, schema {schema:count}; this one reads up "
                              "to {newest:count})", program=meta["program"], schema=meta["schema"], newest=SCHEMA))
    for schema in range(meta["schema"], SCHEMA):
        meta, members = MIGRATIONS[schema](meta, members)
    arrays = {name[len("array."):]: values for name, values in members.items() if name.startswith("array.")}
    try:
        raw = {"final_object": meta["final_object"], "records": meta["records"], "shapes": members["shapes"].tobytes()}
        return State(raw, meta["options"], arrays, meta["references"])
    except KeyError as error:
        raise StateError(said(_DAMAGED, why=said("it lacks its {part:text}", part=error.args[0]))) from error


def checksum_of(path):
    """The checksum a state file carries, as a hex string, without reading the rest. "" when it cannot be read."""
    try:
        with np.load(path, allow_pickle=False) as archive:
            return archive["checksum"].tobytes().hex()
    except Exception:   # as in _read_members
        return ""


def next_numbers_of(path):
    """The first node and element numbers the state's history has not given away, without reading the rest; None when it cannot be read."""
    try:
        with np.load(path, allow_pickle=False) as archive:
            return tuple(int(number) for number in archive["array.counters"][2:4])
    except Exception:   # as in _read_members
        return None


def _read_members(path):
    if not path or not os.path.isfile(path) or not os.path.getsize(path):
        raise StateError(said("the document holds no mesh state"))
    try:
        with np.load(path, allow_pickle=False) as archive:
            if "meta" not in archive.files or "shapes" not in archive.files:
                raise StateError(said("the file is not a FeatureMesh state"))
            return {name: archive[name] for name in archive.files}
    except StateError:
        raise
    except Exception as error:  # a damaged zip or array header shows in a dozen exception types
        folder = os.path.dirname(path)
        if shutil.disk_usage(folder).free < _NO_ROOM:
            raise StateError(said("there was no room in {folder:text} for all of the saved mesh state; make room and open the document again", folder=folder)) from error
        raise StateError(said(_DAMAGED, why=str(error))) from error


def _bytes_to_array(data):
    return np.frombuffer(data, dtype=np.uint8)


def digest(arrays):
    """The SHA-256 of every bit of some arrays, and of their names."""
    found = hashlib.sha256()
    for name in sorted(arrays):
        values = arrays[name]
        found.update(("%s %s %s\n" % (name, values.dtype.str, values.shape)).encode())
        found.update(np.ascontiguousarray(values).data)
    return found.digest()

# SPDX-License-Identifier: GPL-3.0-or-later
"""The engine's answers as tables that a person reads."""

import FreeCAD

from .messages import english, said
from .user_words import in_users_units, in_words

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


def of_difference(found):
    """The feature difference as text, one line per feature that changed."""
    header, rows = rows_of_difference(found)
    rows = [row for row, feature in zip(rows, found["features"]) if feature["verdict"] != "same"]
    return "\n".join((_table(header, rows) if rows else []) + [difference_note(found)])


def rows_of_difference(found):
    """(header, one row per feature)."""
    rows = []
    for feature in found["features"]:
        old, new = _volume(feature["old_volume"]), _volume(feature["new_volume"])
        volumes = old if old == new else "%s -> %s" % (old or "0", new or "0")
        rows.append((feature_name(feature), verdict_in_words(feature["verdict"]), english(feature["detail"]), volumes,
                     _faces(feature["old_faces"]), _faces(feature["new_faces"])))
    return tuple(translate("FeatureMesh", title) for title in _OF_DIFFERENCE), rows


# The columns.
_OF_DIFFERENCE = (QT_TRANSLATE_NOOP("FeatureMesh", "feature"), QT_TRANSLATE_NOOP("FeatureMesh", "what happened"), QT_TRANSLATE_NOOP("FeatureMesh", "by how much"),
                  QT_TRANSLATE_NOOP("FeatureMesh", "volume mm^3"), QT_TRANSLATE_NOOP("FeatureMesh", "old faces"), QT_TRANSLATE_NOOP("FeatureMesh", "new faces"))
_OF_TREE = (QT_TRANSLATE_NOOP("FeatureMesh", "feature"), QT_TRANSLATE_NOOP("FeatureMesh", "type"), QT_TRANSLATE_NOOP("FeatureMesh", "role"),
            QT_TRANSLATE_NOOP("FeatureMesh", "volumes"), "mm^3", QT_TRANSLATE_NOOP("FeatureMesh", "from"), QT_TRANSLATE_NOOP("FeatureMesh", "depends on"),
            QT_TRANSLATE_NOOP("FeatureMesh", "remark"))
_VERDICTS = {
    "same": QT_TRANSLATE_NOOP("FeatureMesh", "same"),
    "moved": QT_TRANSLATE_NOOP("FeatureMesh", "moved"),
    "reshaped": QT_TRANSLATE_NOOP("FeatureMesh", "reshaped"),
    "added": QT_TRANSLATE_NOOP("FeatureMesh", "added"),
    "removed": QT_TRANSLATE_NOOP("FeatureMesh", "removed"),
    "suppressed": QT_TRANSLATE_NOOP("FeatureMesh", "suppressed"),
    "interaction changed": QT_TRANSLATE_NOOP("FeatureMesh", "cut differently"),
    "kept": QT_TRANSLATE_NOOP("FeatureMesh", "kept"),
    "vanished": QT_TRANSLATE_NOOP("FeatureMesh", "vanished"),
    "appeared": QT_TRANSLATE_NOOP("FeatureMesh", "appeared"),
    "trimmed differently": QT_TRANSLATE_NOOP("FeatureMesh", "trimmed differently"),
}


# Verdicts on faces that lie in the material of the other state.
_INNER_VERDICTS = {
    "vanished": QT_TRANSLATE_NOOP("FeatureMesh", "became inner"),
    "appeared": QT_TRANSLATE_NOOP("FeatureMesh", "became boundary"),
}


# How many of the faces and edges with a verdict do.
_INNER_COUNTS = {
    "vanished": QT_TRANSLATE_NOOP("FeatureMesh", " (%d now inside the part)"),
    "appeared": QT_TRANSLATE_NOOP("FeatureMesh", " (%d inside the part before)"),
}


# What the engine calls features, and where it has their volumes from.
_ROLES = {
    "additive": QT_TRANSLATE_NOOP("FeatureMesh", "additive"),
    "subtractive": QT_TRANSLATE_NOOP("FeatureMesh", "subtractive"),
    "common": QT_TRANSLATE_NOOP("FeatureMesh", "common"),
    "dress-up": QT_TRANSLATE_NOOP("FeatureMesh", "dress-up"),
    "pattern": QT_TRANSLATE_NOOP("FeatureMesh", "pattern"),
    "boolean": QT_TRANSLATE_NOOP("FeatureMesh", "boolean"),
    "transform": QT_TRANSLATE_NOOP("FeatureMesh", "transform"),
    "base": QT_TRANSLATE_NOOP("FeatureMesh", "base"),
    "reference": QT_TRANSLATE_NOOP("FeatureMesh", "reference"),
    "opaque": QT_TRANSLATE_NOOP("FeatureMesh", "opaque"),
    "unknown": QT_TRANSLATE_NOOP("FeatureMesh", "unknown"),
}
_SOURCES = {
    "own": QT_TRANSLATE_NOOP("FeatureMesh", "own"),
    "before and after": QT_TRANSLATE_NOOP("FeatureMesh", "before and after"),
    "instances": QT_TRANSLATE_NOOP("FeatureMesh", "instances"),
    "copies": QT_TRANSLATE_NOOP("FeatureMesh", "copies"),
    "shape": QT_TRANSLATE_NOOP("FeatureMesh", "shape"),
}


def verdict_in_words(verdict, inner=False):
    """The engine's verdict on a feature or a face in the user's language; `inner`: it lies in the material of the other state."""
    words = _INNER_VERDICTS if inner and verdict in _INNER_VERDICTS else _VERDICTS
    return translate("FeatureMesh", words.get(verdict, verdict))


def difference_note(found):
    """How many features and faces changed, and the engine's notes."""
    changed = sum(feature["verdict"] != "same" for feature in found["features"])
    line = in_words(said("{changed:count} {changed:feature|features} changed, {others:count} did not; faces: {faces:text}",
                         changed=changed, others=len(found["features"]) - changed, faces=_counts(found["faces"])))
    if "edges" in found:
        line += translate("FeatureMesh", "; edges: %s") % _counts(found["edges"])
    return "\n".join([line] + [translate("FeatureMesh", "note: ") + in_words(note) for note in found.get("notes", [])])


def _counts(changes):
    """"2 appeared (1 inside the part before), 17 kept" of faces or edges."""
    counts, inner = {}, {}
    for change in changes:
        counts[change["verdict"]] = counts.get(change["verdict"], 0) + 1
        inner[change["verdict"]] = inner.get(change["verdict"], 0) + bool(change.get("inner"))
    return ", ".join("%d %s" % (counts[verdict], verdict_in_words(verdict))
                     + (translate("FeatureMesh", _INNER_COUNTS.get(verdict, " (%d)")) % inner[verdict] if inner[verdict] else "")
                     for verdict in sorted(counts)) or translate("FeatureMesh", "none")


def of_tree(found):
    """The feature tree as text, one line per feature."""
    return "\n".join(_table(*rows_of_tree(found)) + [tree_note(found)])


def rows_of_tree(found):
    """(header, one row per feature)."""
    rows = []
    for feature in found["features"]:
        volume = sum(entry["volume"] for entry in feature["volumes"])
        rows.append((feature_name(feature), feature["type"], translate("FeatureMesh", _ROLES.get(feature["role"], feature["role"])),
                     "%d" % len(feature["volumes"]), _volume(volume), translate("FeatureMesh", _SOURCES.get(feature["volume_source"], "")),
                     ", ".join(feature["depends_on"]), translate("FeatureMesh", "suppressed") if feature["suppressed"] else feature["error"]))
    return tuple(translate("FeatureMesh", title) for title in _OF_TREE), rows


def tree_note(found):
    """The books: cells and material against FreeCAD's volume, and the engine's notes."""
    line = said("{object:text}: {features:count} {features:feature|features} in {pieces:count} {pieces:piece|pieces}, volume {volume:text} (FreeCAD: {other:text})",
                object=found["object"], features=len(found["features"]), pieces=found["cells"], volume=_exactly(found["material_volume"]),
                other=_exactly(found["final_volume"]))
    return "\n".join([in_words(line)] + [translate("FeatureMesh", "note: ") + in_words(note) for note in found.get("notes", [])])


def face_names(faces):
    """Names as FreeCAD's, from names or from indices that count from 0."""
    return [face if isinstance(face, str) else "Face%d" % (face + 1) for face in faces]


def feature_name(feature):
    """Name, and label where it differs."""
    name, label = feature["name"], feature["label"]
    return name if name == label else "%s (%s)" % (name, label)


def _exactly(volume):
    return in_users_units("%.10g mm^3" % volume)


def _volume(value):
    return "%.6g" % value if value else ""


def _faces(faces):
    names = face_names(faces)
    return in_words(said("{faces:entities}", faces=names)) if names else ""


def _table(header, rows):
    widths = [max(len(row[column]) for row in [header, *rows]) for column in range(len(header))]
    lines = ["  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in [header, *rows]]
    return [lines[0], "-" * len(lines[0]), *lines[1:]]

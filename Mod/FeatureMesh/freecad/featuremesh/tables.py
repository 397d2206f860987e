# SPDX-License-Identifier: GPL-3.0-or-later
"""The engine's answers as tables that a person reads."""


def of_difference(found):
    """The feature difference, one line per feature, unchanged ones counted."""
    rows = []
    changed = [feature for feature in found["features"] if feature["verdict"] != "same"]
    for feature in changed:
        volumes = "%s -> %s" % (_volume(feature["old_volume"]), _volume(feature["new_volume"]))
        rows.append((feature_name(feature), feature["verdict"], feature["detail"], volumes,
                     _faces(feature["old_faces"]), _faces(feature["new_faces"])))
    lines = _table(("feature", "what happened", "by how much", "volume mm^3", "old faces", "new faces"), rows) if rows else []
    same = len(found["features"]) - len(changed)
    counts = {}
    for face in found["faces"]:
        counts[face["verdict"]] = counts.get(face["verdict"], 0) + 1
    faces = ", ".join("%d %s" % (counts[verdict], verdict.replace("_", " ")) for verdict in sorted(counts))
    lines.append("%d features changed, %d did not; faces: %s" % (len(changed), same, faces or "none"))
    return "\n".join(lines + ["note: " + note for note in found.get("notes", [])])


def of_tree(found):
    """The feature tree, one line per feature."""
    rows = []
    for feature in found["features"]:
        volume = sum(entry["volume"] for entry in feature["volumes"])
        rows.append((feature_name(feature), feature["type"], feature["role"],
                     "%d" % len(feature["volumes"]), _volume(volume) if feature["volumes"] else "", feature["volume_source"],
                     ", ".join(feature["depends_on"]), "suppressed" if feature["suppressed"] else feature["error"]))
    lines = _table(("feature", "type", "role", "volumes", "mm^3", "from", "depends on", "remark"), rows)
    lines.append("%s: %d features, %d cells, %.10g mm^3 of material (FreeCAD: %.10g)" % (
        found["object"], len(found["features"]), found["cells"], found["material_volume"], found["final_volume"]))
    return "\n".join(lines + ["note: " + note for note in found.get("notes", [])])


def feature_name(feature):
    """Name, and label where it differs."""
    name, label = feature["name"], feature["label"]
    return name if name == label else "%s (%s)" % (name, label)


def _volume(value):
    return "%.6g" % value


def _faces(faces):
    names = [face if isinstance(face, str) else "Face%d" % (face + 1) for face in faces]
    return ", ".join(names[:6]) + (" and %d more" % (len(names) - 6) if len(names) > 6 else "")


def _table(header, rows):
    widths = [max(len(row[column]) for row in [header, *rows]) for column in range(len(header))]
    lines = ["  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in [header, *rows]]
    return [lines[0], "-" * len(lines[0]), *lines[1:]]

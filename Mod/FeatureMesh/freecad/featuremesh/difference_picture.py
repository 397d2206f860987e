# SPDX-License-Identifier: GPL-3.0-or-later
"""The feature difference as a picture: the part before and after, its faces coloured by what became of them.

A program of its own: difference_picture.py TASK.npz PICTURE.png, started by difference_drawing.py, for a screen that
fails takes the process with it. Needs VTK and Matplotlib, neither FreeCAD nor the engine. A side of the picture is
{"faces": one (k,3,3) array of triangles per face, in mm, "edges": (n,3) polylines}.
"""

import json
import sys

import numpy as np

import pictures

COLOURS = {"kept": "#a9bfd1", "vanished": "#d9605a", "appeared": "#3f9d6d", "trimmed differently": "#f2994a"}
# Kept faces are glass, so that the walls of a hole can be seen from outside.
KEPT_OPACITY = 0.35
# Through glass everything is seen paler, or greyer, than the legend has it.
_LABELS = {"kept": "kept, drawn as glass"}
_DIRECTIONS = [(x, y, z) for z in (-0.75, 0.75) for x, y in ((-0.45, -1), (0.45, -1), (-0.45, 1), (0.45, 1), (-1, -0.45), (1, 0.45))]


def write(path, old, new, changes):
    """Writes the picture of a difference. `changes` are the entries of the difference's "faces"."""
    verdicts = verdicts_by_face(old, changes, "old_face"), verdicts_by_face(new, changes, "new_face")
    direction = best_direction(zip((old, new), verdicts))
    with pictures.off_screen():
        panels = [(title, _draw(side, faces, direction)) for title, side, faces in
                  zip(("before", "after"), (old, new), verdicts)]
    pictures.write_panels(path, panels, legend=legend_of(verdicts))


def legend_of(verdicts):
    """(colour, label) of each verdict that a face of either side has."""
    return [(colour, _LABELS.get(verdict, verdict)) for verdict, colour in COLOURS.items() if any(verdict in faces for faces in verdicts)]


def verdicts_by_face(side, changes, key):
    """One verdict per face of a side; a face that several changes name counts as changed."""
    verdicts = ["kept"] * len(side["faces"])
    for change in changes:
        if change[key] is not None and change["verdict"] != "kept":
            verdicts[int(change[key][len("Face"):]) - 1] = change["verdict"]
    return verdicts


def best_direction(sides):
    """Of a few oblique views that which shows most of the changed faces from the front, rather from above than from below."""
    seen = np.zeros(len(_DIRECTIONS))
    for side, verdicts in sides:
        for triangles, verdict in zip(side["faces"], verdicts):
            if verdict != "kept":
                areas = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]) / 2
                seen += [_facing(areas, d) * (0.6 if d[2] > 0 else 1.0) for d in _DIRECTIONS]
    return _DIRECTIONS[int(np.argmax(np.round(seen, 6)))]


def _facing(areas, direction):
    return np.maximum(-areas @ np.asarray(direction) / np.linalg.norm(direction), 0).sum()


def _draw(side, verdicts, direction):
    scene = pictures.Scene()
    for verdict, colour in COLOURS.items():
        faces = [triangles for triangles, v in zip(side["faces"], verdicts) if v == verdict and len(triangles)]
        if faces:
            scene.add_surface(np.concatenate(faces), colour, KEPT_OPACITY if verdict == "kept" else 1.0)
    scene.add_lines(side["edges"])
    return scene.render(direction)


def read_side(arrays, name):
    """A side as difference_drawing.py packed it."""
    def unpacked(kind):
        return np.split(arrays[name + kind], np.cumsum(arrays[name + kind + "_sizes"])[:-1])
    return {"faces": unpacked("_faces"), "edges": unpacked("_edges")}


if __name__ == "__main__":
    with np.load(sys.argv[1]) as task:
        write(sys.argv[2], read_side(task, "old"), read_side(task, "new"), json.loads(str(task["changes"])))

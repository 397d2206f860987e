# SPDX-License-Identifier: GPL-3.0-or-later
"""The elements of a mesh in colours as a picture.

A program of its own: mesh_picture.py TASK.npz PICTURE.png, started by mesh_drawing.py, for a screen that fails takes the process with it.
Needs VTK and Matplotlib, neither FreeCAD nor the engine. The task: "corners" (k,3,3) mm, "colours" (k,3), "direction" to look along, and
"words", JSON of {"title": text, "legend": [[colour, label], ...]}.
"""

import json
import sys

import numpy as np

import pictures


def write(path, task):
    """Writes the picture."""
    words = json.loads(str(task["words"]))
    corners = task["corners"].reshape(-1, 3)
    with pictures.off_screen():
        scene = pictures.Scene()
        scene.add_triangles(corners, np.arange(len(corners)).reshape(-1, 3), task["colours"])
        image = scene.render(task["direction"])
    pictures.write_panels(path, [(words["title"], image)], legend=[(tuple(colour), label) for colour, label in words["legend"]])


if __name__ == "__main__":
    write(sys.argv[2], dict(np.load(sys.argv[1])))

# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the example documents; runs in FreeCAD, the folder is named by FEATUREMESH_EXAMPLES (default: this one).

    freecadcmd resources/examples/make_examples.py
"""
import os
import sys

FOLDER = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, FOLDER)

import FreeCAD as App  # noqa: E402
import block_and_cylinder  # noqa: E402
import bracket  # noqa: E402
import csg_flange  # noqa: E402
import tool_with_stiffener  # noqa: E402

MAKERS = {
    "bracket": bracket.make,
    "block_and_cylinder": block_and_cylinder.make,
    "tool": tool_with_stiffener.make_without,
    "tool_with_stiffener": tool_with_stiffener.make,
    "csg_flange": csg_flange.make,
}


def write_examples(folder):
    for name, make in MAKERS.items():
        document = make()
        document.saveAs(os.path.join(folder, name + ".FCStd"))
        App.closeDocument(document.Name)


if __name__ == "make_examples":
    write_examples(os.environ.get("FEATUREMESH_EXAMPLES", FOLDER))

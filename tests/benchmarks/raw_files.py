# SPDX-License-Identifier: GPL-3.0-or-later
"""Raw documents as the workbench reads them, kept as files between FreeCAD's process and those that measure."""
import base64
import json


def write_raw(path, raw):
    raw = {**raw, "shapes": base64.b64encode(raw["shapes"]).decode("ascii")}
    path.write_text(json.dumps(raw), encoding="utf-8")


def read_raw(path):
    raw = json.loads(path.read_text(encoding="utf-8"))
    return {**raw, "shapes": base64.b64decode(raw["shapes"])}

# SPDX-License-Identifier: GPL-3.0-or-later
"""What the scripts share that the benchmarks run inside FreeCAD, each with its case as JSON in FEATUREMESH_CASE. The workbench can be imported after it."""
import json
import os
import sys
import traceback
from pathlib import Path

import FreeCAD as App
import freecad

ROOT = Path(__file__).resolve().parents[2]
freecad.__path__.append(str(ROOT / "Mod" / "FeatureMesh" / "freecad"))


def tell(measure):
    """Writes what measure(case) gives, or what went wrong, to the file FEATUREMESH_RESULT, and ends FreeCAD."""
    try:
        result = {"exit_code": 0, "message": "", "data": measure(json.loads(os.environ["FEATUREMESH_CASE"]))}
    except Exception as error:
        traceback.print_exc()
        result = {"exit_code": 1, "message": str(error), "data": {}}
    Path(os.environ["FEATUREMESH_RESULT"]).write_text(json.dumps(result), encoding="utf-8")
    App.Console.PrintMessage("done\n")
    sys.stdout.flush()
    os._exit(0)


def open_part(name):
    """The document of an example, or of a part that bench_parts.py makes."""
    example = ROOT / "resources" / "examples" / (name + ".FCStd")
    if example.is_file():
        return App.openDocument(str(example))
    import bench_parts
    return bench_parts.make(name)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the study of a document's object in a process of its own, beside the window; run as a script by freecadcmd.

FEATUREMESH_STUDY_RUN says in JSON: folder, the number of jobs, the program freecadcmd, the id of the window's process. The window reads how far it
is from the study's database, and how it ended from `run.json`.
"""

import json
import os
import signal
import sys
import traceback

import FreeCAD


def main():
    """Begins the study, or goes on with it, and runs what waits. How it ended is in the folder's run.json."""
    said = json.loads(os.environ["FEATUREMESH_STUDY_RUN"])
    from freecad.featuremesh import parent_process
    parent_process.end_with(said["parent"])
    signal.signal(signal.SIGTERM, _interrupt)
    from freecad.featuremesh import whole_file
    from freecad.featuremesh.errors import UserError
    from freecad.featuremesh.messages import of_error
    try:
        _run(said)
        state, message = "ended", ""
    except KeyboardInterrupt:
        state, message = "stopped", ""
    except UserError as error:
        state, message = "failed", of_error(error)
    except Exception as error:
        traceback.print_exc()
        state, message = "failed", of_error(error)
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    for name in FreeCAD.listDocuments():   # else what FreeCAD has of them stays in its cache
        FreeCAD.closeDocument(name)
    with whole_file.written(os.path.join(said["folder"], "run.json")) as stream:
        json.dump({"state": state, "message": message}, stream)


def _run(said):
    from freecad.featuremesh.study import base, beginning, design, planning
    from freecad.featuremesh.study.folder import StudyFolder, has_study
    from freecad.featuremesh.study.runner import Machine, Runner
    path = said["folder"]
    if has_study(path):
        folder = StudyFolder(path)
        folder.lock()
        if said.get("more"):
            planning.extend(folder, said["more"])
    else:
        folder = beginning.begin(design.read_toml(os.path.join(path, "study.toml")), path, base.make)
    with Runner(folder, Machine(said["freecad"], dict(os.environ), said["jobs"])) as runner:
        runner.run()


def _interrupt(*_):
    signal.signal(signal.SIGTERM, signal.SIG_IGN)   # once is enough: it ends its workers now
    raise KeyboardInterrupt


def _find_package():
    """freecadcmd runs this file as a script; the package it belongs to has to be found first."""
    import freecad
    folder = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    if folder not in freecad.__path__:
        freecad.__path__.append(folder)


if __name__ in ("run_main", "__main__"):
    _find_package()
    try:
        main()
    finally:
        sys.stdout.flush()
        os._exit(0)

# SPDX-License-Identifier: GPL-3.0-or-later
"""A Dask worker's side of a study. Dask sends this file to its workers, so it uses nothing of the workbench until it knows where that is.

Dask cannot interrupt a running task (distributed #1434, #1303), so limits and ends are those of the FreeCAD that the task speaks with.
"""
import hashlib
import os
import shutil
import sys
import tempfile
import threading
import types
from concurrent.futures import ThreadPoolExecutor

_lock = threading.Lock()
_idle, _all = {}, []   # FreeCADs that wait for a case, by base and settings; and all of them
# A FreeCAD ends with the thread that started it, so one thread that lives as long as the process starts them all.
_starter = ThreadPoolExecutor(max_workers=1)


def run_case(study, base, case):
    """The result of one case.

    `study` has workbench, engine, freecad (paths on the runner's machine; the worker's own FEATUREMESH_WORKBENCH, FEATUREMESH_ENGINE and
    FREECADCMD count more), settings, base_hash and folder; `base` are the base document's bytes.
    """
    from_workbench = _workbench(os.environ.get("FEATUREMESH_WORKBENCH", study["workbench"]))
    case = {**case, "folder": _case_folder(study, case)}
    key = study["key"]
    with _lock:
        worker = _idle.get(key, []).pop() if _idle.get(key) else None
    try:
        if worker is None:
            worker = _starter.submit(_new_worker, from_workbench, study, _base_file(study["base_hash"], base)).result()
            worker.answer()
        worker.send(case)
        result = worker.answer()
    except from_workbench.WorkerDied as error:
        if worker is not None:
            worker.end()
        return {"state": "killed", "message": from_workbench.of_error(error)}
    except from_workbench.BaseBroken as error:
        worker.end()
        return {"state": "failed", "message": from_workbench.said("a worker cannot open the base document: {why:messages}", why=from_workbench.of_error(error))}
    with _lock:
        _idle.setdefault(key, []).append(worker)
    return result


def end_all():
    """Ends every FreeCAD of this worker; cases that run there are over."""
    with _lock:
        ended, _all[:] = list(_all), []
        _idle.clear()
    for worker in ended:
        worker.end()


def _workbench(path):
    """The module worker_process of the workbench in that folder."""
    if "freecad" not in sys.modules:
        sys.modules["freecad"] = types.ModuleType("freecad")
        sys.modules["freecad"].__path__ = []
    folder = os.path.join(path, "freecad")
    if folder not in sys.modules["freecad"].__path__:
        sys.modules["freecad"].__path__.append(folder)
    from freecad.featuremesh.study import worker_process
    return worker_process


def _new_worker(worker_process, study, base_path):
    freecad = os.environ.get("FREECADCMD") or shutil.which("freecadcmd") or shutil.which("FreeCADCmd") or study["freecad"]
    environment = {**os.environ, "LC_ALL": "C.UTF-8", "FEATUREMESH_ENGINE": os.environ.get("FEATUREMESH_ENGINE", study["engine"])}
    log = os.path.join(_cache(), "worker-%d-%d.log" % (os.getpid(), len(_all) + 1))
    worker = worker_process.WorkerProcess(freecad, environment, {**study["settings"], "base": base_path}, log)
    with _lock:
        _all.append(worker)
    return worker


def _cache():
    folder = os.path.join(tempfile.gettempdir(), "featuremesh-studies-%d" % os.getuid())
    os.makedirs(folder, mode=0o700, exist_ok=True)
    return folder


def _base_file(base_hash, content):
    """The base document on this machine, written once."""
    path = os.path.join(_cache(), base_hash + ".FCStd")
    if not os.path.exists(path):
        if hashlib.sha256(content).hexdigest() != base_hash:
            raise RuntimeError("the base document did not arrive whole")
        temporary = "%s.%d.%d" % (path, os.getpid(), threading.get_ident())
        with open(temporary, "wb") as stream:
            stream.write(content)
        os.replace(temporary, path)
    return path


def _case_folder(study, case):
    """The study's own folder where this machine sees it, else one that stays here."""
    folder = case["folder"]
    if not os.path.exists(os.path.join(study["folder"], "study.sqlite")):
        folder = os.path.join(_cache(), study["base_hash"][:16], "%04d" % case["id"])
    os.makedirs(folder, exist_ok=True)
    return folder

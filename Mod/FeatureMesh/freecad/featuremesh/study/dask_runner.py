# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the waiting cases of a study on the workers of a Dask scheduler: one task for each case, only rows travel back."""

import hashlib
import json
import os
import time
from dataclasses import dataclass

from ..errors import UserError
from ..messages import of_error, said
from . import memory
from .case_book import CaseBook, Stopped

_TASKS_PER_THREAD = 2   # handed out at once, so that a worker has the next one at hand
_LOOK_EVERY = 0.5       # s between two lines of progress
_PAUSE = 0.02           # s between two looks at the tasks
_WORKER_FILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "dask_worker.py")
_LOST = ("lost", "cancelled")   # states of what no worker has any more
_PATIENCE = 30          # s for the scheduler to answer


@dataclass
class Cluster:
    """Where the cases run, and what its workers find where the runner's machine and theirs share a file system."""
    scheduler: str     # tcp://HOST:PORT
    workbench: str     # folders and program; environment variables of a worker count more
    engine: str
    freecad: str


def connect(address):
    """Dask's client of the scheduler at that address. Throws UserError where none answers."""
    try:
        from distributed import Client
    except ImportError as error:
        raise UserError(said("--scheduler needs Dask: install Debian's package python3-distributed")) from error
    try:
        return Client(address, timeout=_PATIENCE, set_as_default=False)
    except (OSError, TimeoutError, ValueError) as error:
        raise UserError(said("no Dask scheduler answers at {address:text} ({why:messages})", address=address, why=of_error(error))) from error


class DaskRunner:
    """To be used in a `with` statement, at whose end no task of the study is left. Options as for CaseBook."""

    def __init__(self, folder, cluster, show=None, keep_base=False):
        self._book, self._cluster = CaseBook(folder, show, keep_base), cluster
        self._running = {}   # future -> (case, start)
        self._client = connect(cluster.scheduler)

    def run(self, case_ids=None):
        """Runs all waiting cases, or those of `case_ids`. Throws Stopped, DiskFull."""
        try:
            self._run(self._book.waiting(case_ids))
        except (OSError, TimeoutError) as error:
            raise Stopped(said("the Dask scheduler {scheduler:text} is gone ({why:messages}); go on with `study resume`",
                               scheduler=self._cluster.scheduler, why=of_error(error))) from error

    def _run(self, waiting):
        self._client.upload_file(_WORKER_FILE)
        study, self._base = self._study(), None
        while waiting or self._running:
            self._book.refuse_changed_document()
            threads = self._threads()
            while waiting and len(self._running) < max(1, _TASKS_PER_THREAD * threads):
                self._submit(study, waiting.pop(0))
            self._book.show_progress([start for _, start in self._running.values()], threads)
            for future in self._finished():
                waiting += self._take(future)
        self._book.show_progress([], 1)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        unfinished = list(self._running)
        self._book.give_back_all()
        self._running = {}
        try:
            if unfinished:
                self._client.cancel(unfinished, force=True)
                self._client.run(_end_all)
            self._client.close()
        except (OSError, TimeoutError):
            pass   # the scheduler is gone, and its workers with it

    def _threads(self):
        return sum(worker["nthreads"] for worker in self._client.scheduler_info()["workers"].values())

    def _study(self):
        settings, base_hash = self._book.worker_settings(), self._book.database.value("base_hash")
        key = hashlib.sha256(json.dumps([settings, base_hash], sort_keys=True).encode()).hexdigest()
        return {"key": key, "settings": settings, "base_hash": base_hash, "folder": self._book.folder.path, "workbench": self._cluster.workbench,
                "engine": self._cluster.engine, "freecad": self._cluster.freecad}

    def _scattered_base(self):
        """The base document's bytes; Dask brings them to each worker once, by their hash. Scattered again when all workers that had them are gone."""
        if self._base is None or self._base.status in _LOST:
            self._client.wait_for_workers(1)
            with open(self._book.folder.base_path, "rb") as stream:
                self._base = self._client.scatter(stream.read(), hash=True, broadcast=True)
        return self._base

    def _submit(self, study, case):
        import dask_worker   # what upload_file brought to the workers; pickled by its name
        request = self._book.start(case)
        future = self._client.submit(dask_worker.run_case, study, self._scattered_base(), request, pure=False, resources=self._resources())
        self._running[future] = (case, time.monotonic())

    def _resources(self):
        """What a case needs of `cores` and `GB`, where the workers say what they have of them."""
        said = [worker.get("resources", {}) for worker in self._client.scheduler_info()["workers"].values()]
        needed = {"cores": self._book.study.threads, "GB": memory.of_case(self._book.facts) / 1e9}
        return {name: amount for name, amount in needed.items() if said and all(name in resources for resources in said)}

    def _finished(self):
        """The futures that have ended, looked for until there is one or a moment is over."""
        end = time.monotonic() + _LOOK_EVERY
        while True:
            done = [future for future in self._running if future.done()]
            if done or time.monotonic() > end:
                return done
            time.sleep(_PAUSE)

    def _take(self, future):
        case, start = self._running[future]
        if future.status == "finished":
            result = future.result()
        elif future.status in _LOST:
            result = {"state": "killed", "message": said("the Dask workers that had its base document are gone")}
        else:   # Dask's own word when the worker died as often as Dask allows, or when a task raised
            result = {"state": "failed", "message": "Dask: %r" % (future.exception() if future.status == "error" else future.status)}
        again = self._book.keep(case, result, time.monotonic() - start)
        del self._running[future]
        return [case] if again else []


def _end_all():
    import dask_worker
    dask_worker.end_all()

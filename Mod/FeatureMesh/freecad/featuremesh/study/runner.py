# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the waiting cases of a study on this machine: one FreeCAD for each job, which stays open for many cases."""

import os
import select
import time
from dataclasses import dataclass

from . import memory
from .case_book import CaseBook, Stopped
from .worker_process import BaseBroken, WorkerDied, WorkerProcess

_LOOK_EVERY = 0.5   # s between two lines of progress


@dataclass
class Machine:
    """What of this machine a study may use."""
    freecad: str          # the program freecadcmd
    environment: dict
    jobs: int = 1


@dataclass
class _Busy:
    worker: WorkerProcess
    case: object
    start: float


class Runner:
    """To be used in a `with` statement, at whose end no process is left. Options as for CaseBook."""

    def __init__(self, folder, machine, show=None, keep_base=False):
        self._machine, self._book = machine, CaseBook(folder, show, keep_base)
        self._busy, self._idle = [], []
        self._started = 0   # workers, for the names of their logs

    def run(self, case_ids=None):
        """Runs all waiting cases, or those of `case_ids`. Throws Stopped, DiskFull."""
        waiting = self._book.waiting(case_ids)
        jobs = self._jobs_now(min(self._machine.jobs, max(1, len(waiting))))
        while waiting or self._busy:
            self._book.refuse_changed_document()
            while waiting and len(self._busy) < jobs:
                self._start(waiting.pop(0))
            self._book.show_progress([busy.start for busy in self._busy], jobs)
            ready, _, _ = select.select([busy.worker for busy in self._busy], [], [], _LOOK_EVERY)
            for busy in [busy for busy in self._busy if busy.worker in ready]:
                waiting += self._take(busy)
        self._book.show_progress([], jobs)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        """Ends all workers; cases that run wait again."""
        for worker in self._idle + [busy.worker for busy in self._busy]:
            worker.end()
        self._book.give_back([busy.case for busy in self._busy])
        self._busy, self._idle = [], []

    def _jobs_now(self, jobs):
        """As many as have memory. Throws Stopped when not even one case has."""
        needed, available = memory.estimated_bytes(self._book.facts["nodes"], self._book.facts["solver"]), memory.available_bytes()
        fitting = memory.jobs_that_fit(jobs, needed, available)
        if not fitting:
            raise Stopped("a case needs about %.1f GB of memory, and %.1f GB are free; take a coarser mesh, or free memory"
                          % (needed / 1e9, available / 1e9))
        return fitting

    def _start(self, case):
        request = self._book.start(case)
        while True:
            worker = self._idle.pop() if self._idle else self._new_worker()
            try:
                worker.send(request)
            except WorkerDied:
                worker.end()   # between two cases: nothing is lost
                continue
            self._busy.append(_Busy(worker, case, time.monotonic()))
            return

    def _new_worker(self):
        self._started += 1
        log = os.path.join(self._book.folder.path, "worker-%d.log" % self._started)
        worker = WorkerProcess(self._machine.freecad, self._machine.environment, self._book.worker_settings(), log)
        try:
            worker.answer()
        except BaseBroken as error:
            worker.end()
            raise Stopped("a worker cannot open the base document: %s" % error) from error
        except WorkerDied as error:
            worker.end()
            raise Stopped("a worker cannot start: %s; see %s" % (error, log)) from error
        except BaseException:
            worker.end()
            raise
        return worker

    def _take(self, busy):
        """Keeps what a case gave. Returns the case, in a list, where it is to be run again."""
        try:
            result, worker = busy.worker.answer(), busy.worker
        except WorkerDied as error:
            busy.worker.end()
            result, worker = {"state": "killed", "message": str(error)}, None
        again = self._book.keep(busy.case, result, time.monotonic() - busy.start)
        self._busy.remove(busy)
        self._idle += [worker] if worker else []
        return [busy.case] if again else []

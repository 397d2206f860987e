# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the waiting cases of a study on this machine: one FreeCAD for each job, which stays open for many cases."""

import os
import select
import time
from dataclasses import dataclass

from ..messages import of_error, said
from . import memory
from .case_book import CaseBook, Stopped
from .worker_process import BaseBroken, WorkerDied, WorkerProcess

_LOOK_EVERY = 0.5   # s between two lines of progress
_MOST_STARTS = 3    # of workers one after the other that end before they are ready


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
        self._busy, self._idle, self._starting = [], [], []   # each worker is in one of them at any moment: an interrupt can come between two lines
        self._started = 0   # workers, for the names of their logs
        self._ended_early = 0

    def run(self, case_ids=None):
        """Runs all waiting cases, or those of `case_ids`. Throws Stopped, DiskFull."""
        waiting = self._book.waiting(case_ids)
        jobs = self._jobs_now(min(self._machine.jobs, max(1, len(waiting))))
        while waiting or self._busy:
            self._book.refuse_changed_document()
            while waiting and self._idle and len(self._busy) < jobs:
                waiting[:1] = self._start(waiting[0])
            while len(self._starting + self._idle + self._busy) < min(jobs, len(self._busy) + len(waiting)):
                self._starting.append(self._new_worker())
            self._book.show_progress([busy.start for busy in self._busy], jobs)
            watched = self._starting + [busy.worker for busy in self._busy]
            ready = select.select(watched, [], [], _LOOK_EVERY)[0] + [worker for worker in watched if worker.is_overdue()]
            for worker in [worker for worker in self._starting if worker in ready]:
                self._take_ready(worker)
            for busy in [busy for busy in self._busy if busy.worker in ready]:
                waiting += self._take(busy)
        self._book.show_progress([], jobs)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        """Ends all workers; cases that run wait again."""
        for worker in self._starting + self._idle + [busy.worker for busy in self._busy]:
            worker.end()
        self._book.give_back_all()
        self._busy, self._idle, self._starting = [], [], []

    def _jobs_now(self, jobs):
        """As many as have memory. Throws Stopped when not even one case has."""
        needed, available = memory.of_case(self._book.facts), memory.available_bytes()
        fitting = memory.jobs_that_fit(jobs, needed, available)
        if not fitting:
            raise Stopped(said("a case needs about {needed:text} GB of memory, and {free:text} GB are free; take a coarser mesh, or free memory",
                               needed="%.1f" % (needed / 1e9), free="%.1f" % (available / 1e9)))
        return fitting

    def _start(self, case):
        """Gives a case to an idle worker. Returns the case, in a list, where the worker had ended: between two cases nothing is lost."""
        worker, returned = self._idle[-1], []
        request = self._book.start(case)
        try:
            worker.send(request)
            self._busy.append(_Busy(worker, case, time.monotonic()))
        except WorkerDied:
            worker.end()
            self._book.give_back(case)
            returned = [case]
        self._idle.remove(worker)
        return returned

    def _new_worker(self):
        """A FreeCAD that opens the base document; it says when it has."""
        self._started += 1
        log = os.path.join(self._book.folder.path, "worker-%d.log" % self._started)
        return WorkerProcess(self._machine.freecad, self._machine.environment, self._book.worker_settings(), log)

    def _take_ready(self, worker):
        """The worker is ready for cases, or has ended. Throws Stopped where that is of no use."""
        try:
            worker.answer()
        except BaseBroken as error:
            worker.end()
            raise Stopped(said("a worker cannot open the base document: {why:messages}", why=of_error(error))) from error
        except WorkerDied as error:
            worker.end()
            self._starting.remove(worker)
            self._ended_early += 1
            if self._ended_early >= _MOST_STARTS:
                raise Stopped(said("a worker cannot start: {why:messages}; see the worker logs in {folder:text}",
                                   why=of_error(error), folder=self._book.folder.path)) from error
            return
        self._ended_early = 0
        self._idle.append(worker)
        self._starting.remove(worker)

    def _take(self, busy):
        """Keeps what a case gave. Returns the case, in a list, where it is to be run again."""
        try:
            result, worker = busy.worker.answer(), busy.worker
        except WorkerDied as error:
            busy.worker.end()
            result, worker = {"state": "killed", "message": of_error(error)}, None
        again = self._book.keep(busy.case, result, time.monotonic() - busy.start)
        self._idle += [worker] if worker else []
        self._busy.remove(busy)
        return [busy.case] if again else []

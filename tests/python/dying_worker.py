# SPDX-License-Identifier: GPL-3.0-or-later
"""The program of the worker process, which gives itself a signal once where a test asks for it. Run in its place by test_worker.py.

The program itself is FEATUREMESH_WORKER. FEATUREMESH_WORKERS_ORDER is a file with a signal's number and a step of the engine or one of
its functions; when the worker comes there it removes the file and sends itself the signal, after it has told the step.
"""
import importlib.util
import os
import sys

specification = importlib.util.spec_from_file_location("worker_main", os.environ["FEATUREMESH_WORKER"])
worker_main = importlib.util.module_from_spec(specification)
specification.loader.exec_module(worker_main)
ORDER = os.environ["FEATUREMESH_WORKERS_ORDER"]


class DyingWorker(worker_main.Worker):

    def _answer(self, name, args, kwargs):
        die_at(name)
        return super()._answer(name, args, kwargs)

    def _progress(self, step, share):
        goes_on = super()._progress(step, share)
        die_at(step)
        return goes_on


def die_at(place):
    try:
        with open(ORDER, encoding="utf-8") as stream:
            sent, wanted = stream.read().split()
    except FileNotFoundError:
        return
    if place == wanted:
        os.unlink(ORDER)
        os.kill(os.getpid(), int(sent))


worker_main.Worker = DyingWorker
worker_main.main(*sys.argv[1:])

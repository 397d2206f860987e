# SPDX-License-Identifier: GPL-3.0-or-later
"""What the steps of a case take: seconds by the clock, and those that the processors worked, which do not depend on what else the machine does."""

import resource
import time
from contextlib import contextmanager

PROCESSORS = "processors"   # the entry that holds the second kind, by step


@contextmanager
def step(seconds, name):
    """Puts what the block takes into `seconds`, unless it throws."""
    start, worked = time.perf_counter(), processor_seconds(resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    yield
    seconds[name] = time.perf_counter() - start
    seconds.setdefault(PROCESSORS, {})[name] = processor_seconds(resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN) - worked


def processor_seconds(*whose):
    """That the processors have worked so far for this process (resource.RUSAGE_SELF), for those that it waited for (resource.RUSAGE_CHILDREN)."""
    used = [resource.getrusage(who) for who in whose]
    return sum(entry.ru_utime + entry.ru_stime for entry in used)

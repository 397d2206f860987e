# SPDX-License-Identifier: GPL-3.0-or-later
"""Seconds by the clock and of the processors."""
import resource
import time


def seconds_of(work):
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def shortest(timed, rounds=(3, 40), enough=1.0):
    """The least that timed() gives in as many rounds as take `enough` seconds, within the limits."""
    found = []
    start = time.perf_counter()
    while len(found) < rounds[0] or (len(found) < rounds[1] and time.perf_counter() - start < enough):
        found.append(timed())
    return min(found)


def processor_seconds():
    """Of this process and those that it waited for (kernel calls that may crash run in one)."""
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(each.ru_utime + each.ru_stime for each in used)

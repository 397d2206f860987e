# SPDX-License-Identifier: GPL-3.0-or-later
"""How often something is done before its shortest time is taken."""
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

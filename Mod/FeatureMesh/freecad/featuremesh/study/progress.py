# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a study is, and how long it will take: from the cases that were run, not from a guess."""

from ..messages import english, said

_WIDTH = 20


def line(counts, running_for, seconds, jobs):
    """One line: a bar, the counts, the time left.

    `counts` by state, `running_for` the seconds that each running case has taken so far, `seconds` those of each case finished in this run.
    """
    total = sum(counts.values())
    finished = counts["done"] + counts["infeasible"] + counts["failed"]
    filled = _WIDTH * finished // total if total else 0
    words = ["%d of %d done" % (counts["done"], total), "%d running" % counts["running"]]
    words += ["%d %s" % (counts[state], state) for state in ("infeasible", "failed") if counts[state]]
    if counts["waiting"] or counts["running"]:
        words.append(english(time_left(seconds_left(counts, running_for, seconds, jobs))) or "time left not known yet")
    return "[%s%s] %s" % ("#" * filled, "." * (_WIDTH - filled), ", ".join(words))


def summary(counts, first_lost):
    """What came out so far, in one sentence: how many cases are done, how many are not, and why the first of those is not."""
    known = {"done": counts["done"], "all": sum(counts.values())}
    if first_lost is None:
        return said("{done:count} of {all:count} {all:case|cases} done", **known)
    return said("{done:count} of {all:count} {all:case|cases} done, {lost:count} could not be made or solved; case {first:count}: {why:messages}",
                **known, lost=counts["failed"] + counts["infeasible"], first=first_lost.id, why=first_lost.message)


def seconds_left(counts, running_for, seconds, jobs):
    """None while no case has been finished. A case that runs longer than the mean is taken to be nearly done."""
    if not seconds:
        return None
    mean = sum(seconds) / len(seconds)
    left = counts["waiting"] * mean + sum(max(mean - elapsed, 0.0) for elapsed in running_for)
    return left / max(1, jobs)


def time_left(seconds):
    """That in words, None where it is not known."""
    if seconds is None:
        return None
    if seconds < 0.5:   # what runs takes longer than others took
        return said("nearly done")
    if seconds < 90:
        return said("about {seconds:count} s left", seconds=round(seconds))
    if seconds < 5400:
        return said("about {minutes:count} min left", minutes=round(seconds / 60))
    return said("about {hours:number} h left", hours=round(seconds / 3600, 1))

# SPDX-License-Identifier: GPL-3.0-or-later
"""A worker of a study, run as a script by freecadcmd: opens the base document once and runs each case in a copy of its process.

A copy (fork) starts from the base's very bits, so no case can touch another; when it crashes, hangs or is killed, the worker stays.
Requests and answers are lines of JSON on two descriptors, which FEATUREMESH_STUDY_WORKER names with all else.
"""

import json
import os
import resource
import select
import signal
import sys
import time
import traceback

_LOOK_EVERY = 0.2       # s between two looks at the memory of a case
_ASKED_TO_END = (signal.SIGKILL, signal.SIGTERM, signal.SIGINT, signal.SIGHUP)


def main():
    """Serves until the requests end."""
    said = json.loads(os.environ["FEATUREMESH_STUDY_WORKER"])
    from freecad.featuremesh import parent_process
    parent_process.end_with(said["parent"])
    requests, answers = os.fdopen(said["requests"], "r", encoding="utf-8"), os.fdopen(said["answers"], "w", encoding="utf-8")
    from freecad.featuremesh.messages import of_error
    from freecad.featuremesh.study import case_run
    try:
        base = case_run.Base(said["base"], said["study"], said["solver"])
    except Exception as error:
        traceback.print_exc()
        _answer(answers, {"broken": of_error(error)})
        return
    _answer(answers, {"ready": os.getpid()})
    for line in requests:
        case = json.loads(line)
        _answer(answers, run_in_copy(lambda: case_run.run(base, case), case["folder"], said["seconds_limit"], said["memory_limit"]))


def run_in_copy(work, folder, seconds_limit, memory_limit):
    """What `work()` gives in a copy of this process; where that does not end well, a result that says how it ended."""
    from freecad.featuremesh.study.steps import PROCESSORS, processor_seconds
    reader, writer = os.pipe()
    everything = resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN
    start, worked, parent = time.monotonic(), processor_seconds(*everything), os.getpid()
    copy = os.fork()
    if copy == 0:
        os.close(reader)
        _in_copy(work, parent, folder, writer)
    os.close(writer)
    said, problem = _wait(reader, copy, start + seconds_limit, seconds_limit, memory_limit)
    _end_group(copy)
    _, status = os.waitpid(copy, 0)
    if problem:
        return {"state": "failed", "message": problem}
    if said.endswith(b"\n"):
        return {**json.loads(said), "elapsed": time.monotonic() - start, PROCESSORS: processor_seconds(*everything) - worked}
    return _how_it_ended(status)


def _in_copy(work, parent, folder, writer):
    """Never returns."""
    from freecad.featuremesh import parent_process
    from freecad.featuremesh.messages import of_error
    from freecad.featuremesh.study import room
    try:
        os.setpgid(0, 0)
        parent_process.end_with(parent)
        log = os.open(os.path.join(folder, "freecad.log"), os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o644)
        os.dup2(log, 1)
        os.dup2(log, 2)
        result = json.dumps(work())
    except OSError as error:
        result = json.dumps({"state": room.state_after(error, folder), "message": of_error(error)})
    with os.fdopen(writer, "w", encoding="utf-8") as stream:
        stream.write(result + "\n")
    os._exit(0)


def _wait(reader, copy, end, seconds_limit, memory_limit):
    """(what the copy said, why it was ended): one of the two, or neither when it ended by itself."""
    from freecad.featuremesh.messages import said
    heard = b""
    while True:
        left = max(0.0, end - time.monotonic())
        ready, _, _ = select.select([reader], [], [], min(left, _LOOK_EVERY) if memory_limit else left)
        if ready:
            chunk = os.read(reader, 1 << 16)
            if not chunk:
                os.close(reader)
                return heard, None
            heard += chunk
        elif time.monotonic() >= end:
            os.close(reader)
            return b"", said("it took longer than the limit of {seconds:number} s; try `study resume --retry-failed` with a longer --time-limit",
                            seconds=seconds_limit)
        elif memory_limit and memory_of_group(copy) > memory_limit:
            os.close(reader)
            return b"", said("it took more memory than the limit of {limit:number} GB; try `study resume --retry-failed` with a larger --memory-limit",
                            limit=memory_limit / 1e9)


def memory_of_group(group):
    """Bytes in the memory of all processes of a group, CalculiX included; pages that copies share count once each."""
    total, page = 0, os.sysconf("SC_PAGE_SIZE")
    for name in os.listdir("/proc"):
        if name.isdigit():
            try:
                if os.getpgid(int(name)) == group:
                    with open("/proc/%s/statm" % name, encoding="ascii") as stream:
                        total += int(stream.read().split()[1]) * page
            except (OSError, IndexError):
                pass   # it ended meanwhile
    return total


def _end_group(group):
    """Ends the copy and all that it started; until the copy is waited for, its number is nobody else's."""
    try:
        os.killpg(group, signal.SIGKILL)
    except ProcessLookupError:
        pass


def _how_it_ended(status):
    from freecad.featuremesh.messages import said
    code = os.waitstatus_to_exitcode(status)
    if -code in _ASKED_TO_END:
        return {"state": "killed", "message": said("it was ended from outside ({signal:text})", signal=signal.Signals(-code).name)}
    if code < 0:
        return {"state": "failed", "message": said("FreeCAD crashed ({signal:text})", signal=signal.Signals(-code).name)}
    return {"state": "failed", "message": said("FreeCAD ended with exit code {code:count}", code=code)}


def _answer(stream, value):
    stream.write(json.dumps(value) + "\n")
    stream.flush()


def _find_package():
    """freecadcmd runs this file as a script; the package it belongs to has to be found first."""
    import freecad
    folder = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    if folder not in freecad.__path__:
        freecad.__path__.append(folder)


if __name__ in ("worker_main", "__main__"):
    _find_package()
    try:
        main()
    finally:
        sys.stdout.flush()
        os._exit(0)

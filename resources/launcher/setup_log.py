# SPDX-License-Identifier: GPL-3.0-or-later
"""Set-up is quiet: what its programs say goes to build/setup.log, whose end is shown when one fails."""
import contextlib
import os
import signal
import subprocess
import sys

from layout import BUILD, SETUP_LOG, Failure

LINES_SHOWN, WIDTH_SHOWN = 25, 200


def say(line):
    print("featuremesh: " + line, file=sys.stderr, flush=True)


def run_logged(command, what, **options):
    """Runs a set-up program with its output in the log; raises Failure with the log's end when it fails. When the launcher is ended, all that the program
    started ends, too, where it has a session of its own (`start_new_session`): one that asks for a password needs the terminal's."""
    BUILD.mkdir(exist_ok=True)
    with open(SETUP_LOG, "a", encoding="utf-8") as log:
        log.write("\n$ " + " ".join(map(str, command)) + "\n")
        log.flush()
        start = log.tell()
        try:
            process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT,
                                       env={**os.environ, "LC_ALL": "C.UTF-8"}, **options)
        except FileNotFoundError:
            raise Failure(f"{what} failed: the program {command[0]} is not installed") from None
        code = wait_for(process)
    if code:
        raise Failure(f"{what} failed with exit code {code}; the end of {SETUP_LOG}:\n{end_of(SETUP_LOG, start)}")


def wait_for(process):
    """The exit code. When the launcher is ended, the process and the others of its session end first."""
    try:
        return process.wait()
    except KeyboardInterrupt:
        with contextlib.suppress(ProcessLookupError):   # it was interrupted, too, and has ended
            if os.getsid(process.pid) == process.pid:
                os.killpg(process.pid, signal.SIGTERM)
        process.terminate()
        process.wait()
        raise


def end_of(path, start=0):
    with open(path, encoding="utf-8", errors="replace") as text:
        text.seek(start)
        return "\n".join("    " + line.rstrip()[:WIDTH_SHOWN] for line in text.readlines()[-LINES_SHOWN:])

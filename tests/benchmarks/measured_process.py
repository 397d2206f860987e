# SPDX-License-Identifier: GPL-3.0-or-later
"""A program run once in a process of its own, so that its time and its memory are its own."""
import os
import signal
import subprocess
import tempfile
import threading
import time
from pathlib import Path


def run_measured(command, out, limit_seconds, environment=None):
    """(wall seconds, largest resident memory in MB) of a command that writes the file `out`; RuntimeError when it does not."""
    with tempfile.TemporaryFile() as said:
        start = time.perf_counter()
        process = subprocess.Popen(command, cwd=Path(out).parent, stdout=said, stderr=subprocess.STDOUT, env=environment)
        alarm = threading.Timer(limit_seconds, os.kill, (process.pid, signal.SIGKILL))
        alarm.start()
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.perf_counter() - start
        alarm.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode or not Path(out).is_file():
            said.seek(0)
            words = said.read().decode(errors="replace")[-300:]
            raise RuntimeError(f"{Path(command[0]).name} gave no mesh within {limit_seconds} s (exit {process.returncode}): {words}")
        return seconds, usage.ru_maxrss / 1024

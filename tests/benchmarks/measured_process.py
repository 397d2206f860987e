# SPDX-License-Identifier: GPL-3.0-or-later
"""A program run once in a process of its own, so that its time and its memory are its own.

measured_process.py OUT.json COMMAND...: runs the command and writes what it used (Used). A process starts with the memory of the one it came
from on its account, so this small one stands between the benchmark and what is measured.
"""
import json
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import NamedTuple


class Used(NamedTuple):
    seconds: float              # by the clock
    processor_seconds: float
    megabytes: float            # the largest resident memory


def run_measured(command, out, limit_seconds, environment=None):
    """What a command used that writes the file `out`; RuntimeError when it does not."""
    with tempfile.TemporaryDirectory() as folder:
        figures = Path(folder) / "figures.json"
        done = subprocess.run([sys.executable, __file__, str(figures), str(limit_seconds), *command], cwd=Path(out).parent, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, env=environment)
        if done.returncode or not Path(out).is_file():
            raise RuntimeError(f"{Path(command[0]).name} gave no mesh within {limit_seconds} s: {done.stdout.decode(errors='replace')[-300:]}")
        return Used(*json.loads(figures.read_text(encoding="utf-8")))


def measure(figures, limit_seconds, *command):
    start = time.perf_counter()
    try:
        code = subprocess.run(command, timeout=float(limit_seconds)).returncode
    except subprocess.TimeoutExpired:
        return 1
    seconds = time.perf_counter() - start
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    Path(figures).write_text(json.dumps(Used(seconds, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024)), encoding="utf-8")
    return code


if __name__ == "__main__":
    sys.exit(measure(*sys.argv[1:]))

# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs one task of the workbench in a FreeCAD process of its own, so that a crash of FreeCAD is not a crash of the launcher.

The task goes in as JSON by the environment, the result comes back as a JSON file; a missing result is a crash.
"""
import contextlib
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

from layout import FREECAD_LOG, RELEASE, WORKBENCH, Failure
from setup_log import end_of

TASK_SCRIPT = WORKBENCH / "freecad" / "featuremesh" / "cli.py"
MARK = "featuremesh:"
RESULT_NOT_WRITTEN = 4   # exit code of TASK_SCRIPT


def run_task(task):
    """The result of a task: {"exit_code", "message", "data"}."""
    inherited = (task["output"],) if "output" in task else ()
    kept = {"TMPDIR": tempfile.gettempdir()} if task["command"] == "run" else {}   # a script of the user may tell where it put something
    return run_script(TASK_SCRIPT, {"FEATUREMESH_TASK": json.dumps(task), **kept}, inherited=inherited)


def run_script(script, variables, lines_to=None, inherited=()):
    """Runs a script inside freecadcmd and gives the JSON object that it wrote to the file named by FEATUREMESH_RESULT.

    Lines of its standard error that start with `featuremesh:` are progress on a terminal, or go to `lines_to` as they come. It inherits
    the descriptors `inherited`. Its temporary files are gone afterwards, also where it was ended, unless `variables` name a folder for them.
    """
    with tempfile.TemporaryDirectory(prefix="featuremesh-", ignore_cleanup_errors=True) as folder:
        result_file, log_file = Path(folder) / "result.json", Path(folder) / FREECAD_LOG.name
        # FREECAD_USER_TEMP: else each run leaves the folder that FreeCAD has for a document in the user's cache.
        environment = freecad_environment(FEATUREMESH_RESULT=str(result_file), FREECAD_USER_TEMP=folder, **{"TMPDIR": folder, **variables})
        command = [freecadcmd(), str(script), f"--module-path={WORKBENCH}"]
        with open(log_file, "w", encoding="utf-8") as log, subprocess.Popen(
                command, env=environment, stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.PIPE,
                pass_fds=inherited) as process:
            try:
                pass_on(process.stderr, log, lines_to)
            except KeyboardInterrupt:
                process.terminate()
                raise
        code, log_end = process.returncode, end_of(log_file)
        keep(log_file)
        if code == RESULT_NOT_WRITTEN:
            raise Failure(f"there is no room in the folder for temporary files ({tempfile.gettempdir()}), so what FreeCAD did cannot be told; look whether the "
                          "file that it was to write is there, make room, and do this again")
        if not result_file.is_file():
            raise Failure(f"FreeCAD {how_it_ended(code)} before it was done, and no file was changed{no_home()}; "
                          f"the end of what it said (all of it is in {FREECAD_LOG}):\n{log_end}")
        return json.loads(result_file.read_text(encoding="utf-8"))


def keep(log_file):
    """Makes the log that of the last run. Several runs at once have a log each until then; in another user's clone there is none to keep."""
    with contextlib.suppress(OSError):
        shutil.copyfile(log_file, FREECAD_LOG)


def freecad_environment(**variables):
    """FreeCAD needs a UTF-8 locale, and a folder for temporary files that is there; the workbench is told where the engine is, and plain Python finds it on
    its path."""
    engine = str(RELEASE / "bindings")
    path = os.pathsep.join(filter(None, [engine, os.environ.get("PYTHONPATH", "")]))
    return {**os.environ, "FEATUREMESH_ENGINE": engine, "PYTHONPATH": path, "LC_ALL": "C.UTF-8", "TMPDIR": tempfile.gettempdir(), **variables}


def window_environment():
    """The same for FreeCAD's window, whose start page, a Chromium, ends the program when it is root's, unless it may do without its sandbox."""
    return freecad_environment(**({"QTWEBENGINE_DISABLE_SANDBOX": "1"} if os.geteuid() == 0 else {}))


def freecadcmd():
    chosen = os.environ.get("FREECADCMD")
    program = shutil.which(chosen) if chosen else shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
    if not program and chosen:
        raise Failure(f"FREECADCMD is set to {chosen}, which cannot be run")
    if not program:
        raise Failure("freecadcmd is not installed; set FREECADCMD to FreeCAD's command line program")
    return program


def pass_on(stream, log, lines_to):
    """Shows marked lines as they come, all go to the log."""
    progress = ProgressLine()
    for raw in stream:
        line = raw.decode("utf-8", errors="replace").rstrip()
        log.write(line + "\n")
        if not line.startswith(MARK):
            continue
        if lines_to:
            print(line[len(MARK):].lstrip(" "), file=lines_to, flush=True)
        else:
            progress.show(line[len(MARK):].strip())
    progress.clear()


class ProgressLine:
    """One line of a terminal that is written over and over; nothing where there is no terminal."""

    def __init__(self):
        self.width = 0

    def show(self, text):
        if sys.stderr.isatty():
            text = text[:shutil.get_terminal_size().columns - 1]
            print("\r" + text.ljust(self.width), end="", file=sys.stderr, flush=True)
            self.width = len(text)

    def clear(self):
        if self.width:
            self.show("")
            print("\r", end="", file=sys.stderr, flush=True)


def no_home():
    """Where FreeCAD cannot make its folders it crashes while it starts, without a word of why."""
    name = "FREECAD_USER_HOME" if "FREECAD_USER_HOME" in os.environ else "HOME"
    home = os.path.expanduser(os.environ.get(name, "~"))
    return "" if os.access(home, os.W_OK) else f"; it needs a folder for its settings, and nothing can be written to {home}: set {name} to another one"


def how_it_ended(code):
    if code >= 0:
        return f"ended with exit code {code}"
    if code == -signal.SIGKILL:
        return "was ended from outside (SIGKILL; perhaps memory ran out)"
    try:
        return f"crashed ({signal.Signals(-code).name})"
    except ValueError:
        return f"crashed (signal {-code})"

# SPDX-License-Identifier: GPL-3.0-or-later
"""The work behind the launcher's commands, done inside freecadcmd.

The task is JSON in the environment variable FEATUREMESH_TASK, the result goes as JSON to the file FEATUREMESH_RESULT:
{"exit_code": 0, 1 or 2, "message": text, "data": {...}}. FreeCAD ends with exit code 0 whatever a script does, hence a file.
"""

import json
import os
import sys
import traceback

RESULT_NOT_WRITTEN = 4   # exit code, as resources/launcher/freecad_task.py has it


def run_from_environment():
    """Runs the task, writes the result and ends the process with its exit code; without its launcher it ends at once."""
    from freecad.featuremesh import parent_process, whole_file
    parent_process.end_with(os.getppid())
    result = run(json.loads(os.environ["FEATUREMESH_TASK"]))
    code = result["exit_code"]
    try:
        with whole_file.written(os.environ["FEATUREMESH_RESULT"]) as stream:
            json.dump(result, stream)
    except OSError as error:   # FreeCAD would run the whole file once more
        print(error, file=sys.stderr)
        code = RESULT_NOT_WRITTEN
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code)  # FreeCAD's own shutdown can crash after the work is done


def run(task):
    """The result of one task; never throws."""
    from freecad.featuremesh import log, messages, tasks
    from freecad.featuremesh.errors import EngineMissing, UserError
    try:
        message, data = tasks.COMMANDS[task["command"]](task)
        return {"exit_code": 0, "message": message, "data": messages.in_english(data)}
    except UserError as error:
        return _failure(2, error)
    except EngineMissing as error:
        return _failure(1, error)
    except KeyboardInterrupt:
        return _failure(1, KeyboardInterrupt("cancelled"))   # FreeCAD would run the whole file once more
    except Exception as error:
        if tasks.is_users_fault(error):
            return _failure(2, error)
        traceback.print_exc()
        log.write_error(error)
        return _failure(1, error)


def _failure(code, error):
    from freecad.featuremesh import messages
    option = getattr(error, "option", None)   # of errors.NotSelected
    hint = " (name it with %s)" % option if option else ""
    return {"exit_code": code, "message": messages.english(messages.of_error(error)) + hint, "data": {}}


def _find_package():
    """freecadcmd runs this file as a script; the package it belongs to has to be found first."""
    import freecad
    folder = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    if folder not in freecad.__path__:
        freecad.__path__.append(folder)


if __name__ == "cli" or __name__ == "__main__":
    _find_package()
    run_from_environment()

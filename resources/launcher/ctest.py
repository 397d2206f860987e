# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs tests by CTest. Tests of FreeCAD's window that fail run once more, one at a time: they wait for a window server and for time, which no mesh depends on."""
import re
import subprocess

from layout import Failure
from setup_log import say

IN_FREECAD_LABEL = "in_freecad"   # of the tests that run in FreeCAD
IN_WINDOW_LABEL = "in_window"     # of those in its window
_CLOSING_LINES = 30
_TABLE_LINE = re.compile(r"\d+: (?=\| )")
_FAILED = re.compile(r"\s*\d+ - (\w+) \(")


def run(folder, options, environment):
    """Runs the tests of a build folder that `options` choose. What they say is in its ctest.log. Throws Failure."""
    log_file = folder / "ctest.log"
    with open(log_file, "w", encoding="utf-8") as log:
        code, lines = _run(folder, options, environment, log)
        _print_closing_lines(lines, failed=code != 0)
        failed = [found.group(1) for found in map(_FAILED.match, lines) if found]
        if code and failed and set(failed) <= _tests_in_window(folder, environment):
            say("running once more what failed in FreeCAD's window")
            code, lines = _run(folder, ["-R", "^(%s)$" % "|".join(failed)], environment, log)
            _print_closing_lines(lines, failed=code != 0)
            say("passed only the second time: %s" % ", ".join(failed) if code == 0 else "failed twice")
    if code:
        raise Failure(f"tests failed; everything they said: {log_file}")


def _run(folder, options, environment, log):
    """The exit code, and all that was said, of which tests and tables are shown as they come. It ends with the launcher."""
    lines = []
    with subprocess.Popen(["ctest", "--test-dir", str(folder), "--output-on-failure", "--no-tests=error", *options],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", env=environment) as process:
        try:
            for line in process.stdout:
                log.write(line)
                lines.append(line)
                if "Test  #" in line or "Test #" in line:
                    print(line, end="", flush=True)
                elif _TABLE_LINE.match(line):
                    print(_TABLE_LINE.sub("", line), end="", flush=True)
        except BaseException:
            process.terminate()
            raise
    return process.returncode, lines


def _tests_in_window(folder, environment):
    listed = subprocess.run(["ctest", "--test-dir", str(folder), "-N", "-L", IN_WINDOW_LABEL], stdout=subprocess.PIPE, text=True, env=environment)
    return set(re.findall(r"Test +#\d+: (\w+)", listed.stdout))


def _print_closing_lines(lines, failed):
    """CTest's summary, and after a failure all that the failed tests said."""
    if failed:
        print("".join(lines), end="")
        return
    start = next((i for i, line in enumerate(lines) if "tests passed" in line), max(0, len(lines) - _CLOSING_LINES))
    print("".join(lines[start:]), end="")

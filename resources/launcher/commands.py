# SPDX-License-Identifier: GPL-3.0-or-later
"""What each command does: set-up, then one task in FreeCAD or one program."""
import json
import os
import re
import subprocess
import sys
from pathlib import Path

import addon
import freecad_roots
import packages
from engine_build import PYTHON, set_up
from freecad_task import freecad_environment, run_script, run_task
from layout import RELEASE, ROOT, WORKBENCH, Failure, UserError
from setup_log import say

CLOSING_LINES = 30
IN_FREECAD = "in_freecad"   # the label of those tests
TABLE_LINE = re.compile(r"\d+: (?=\| )")


def mesh(given):
    part = existing_file(given.part)
    return finish(task(given, part=part, object=given.object, size=given.size, order=given.order, threads=given.threads,
                       out=written_file(given.out), json=written_file(given.json)))


def adopt(given):
    part = existing_file(given.part)
    return finish(task(given, part=part, mesh=given.mesh, object=given.object, size=given.size, threads=given.threads,
                       out=written_file(given.out), json=written_file(given.json)))


def update(given):
    part = existing_file(given.part)
    return finish(task(given, part=part, object=given.object, set=given.set, full=given.full, threads=given.threads,
                       out=written_file(given.out), json=written_file(given.json)))


def renumber(given):
    part = existing_file(given.part)
    return finish(task(given, part=part, object=given.object, out=written_file(given.out), json=written_file(given.json)))


def transfer(given):
    part = existing_file(given.part)
    return finish(task(given, part=part, new=existing_file(given.new) if given.new else None, result=given.result, object=given.object,
                       out=written_file(given.out), json=written_file(given.json)))


def diff(given):
    old, new = existing_file(given.old), existing_file(given.new)
    picture = written_file(given.picture) if given.picture else None
    if picture:
        set_up(packages.PICTURE_PACKAGES)
    return finish(task(given, old=old, new=new, object=given.object, json=given.json, picture=picture), given.json)


def tree(given):
    part = existing_file(given.part)
    return finish(task(given, part=part, object=given.object, json=given.json), given.json)


def export(given):
    part = existing_file(given.part)
    return finish(task(given, part=part, format=given.format, out=written_file(given.out)))


def demo(given):
    out = written_file(given.out)
    if Path(out).is_file():
        raise UserError(f"{given.out} is a file; give a folder with --out")
    set_up(packages.PICTURE_PACKAGES)
    result = run_script(ROOT / "resources" / "demo" / "run_demo.py", {"FEATUREMESH_DEMO_OUT": out}, lines_to=sys.stdout)
    if result["exit_code"] == 0:
        draw_report(out)
    return finish(result)


def draw_report(folder):
    """Pictures need an OpenGL of their own process: VTK and FreeCAD each bring one."""
    done = subprocess.run([PYTHON, str(ROOT / "resources" / "demo" / "draw_report.py"), folder], env=freecad_environment())
    if done.returncode:
        raise Failure(f"the pictures could not be drawn (exit code {done.returncode})")


def test(given):
    if given.freecad is not None:
        return test_elsewhere(given)
    set_up(packages.PICTURE_PACKAGES + packages.PEER_PACKAGES, everything=not given.in_freecad)
    say("running the tests" + (" in FreeCAD" if given.in_freecad else ""))
    options = [*(["-R", given.only] if given.only else []), *(["-L", IN_FREECAD] if given.in_freecad else [])]
    environment = dict(os.environ)
    if given.long:
        options.append("--verbose")
        environment["FEATUREMESH_LONG"] = "1"
    process = subprocess.Popen(["ctest", "--test-dir", str(RELEASE), "--output-on-failure", "--no-tests=error", *options],
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", env=environment)
    log_file = RELEASE / "ctest.log"
    lines = []
    with open(log_file, "w", encoding="utf-8") as log:
        for line in process.stdout:
            log.write(line)
            lines.append(line)
            if "Test  #" in line or "Test #" in line:
                print(line, end="", flush=True)
            elif TABLE_LINE.match(line):
                print(TABLE_LINE.sub("", line), end="", flush=True)
    code = process.wait()
    print_closing_lines(lines, failed=code != 0)
    if code:
        raise Failure(f"tests failed; everything they said: {log_file}")
    return 0


def test_elsewhere(given):
    """The same command in a root that has the FreeCAD asked for."""
    if given.freecad not in freecad_roots.RELEASE_OF:
        raise UserError(f"--freecad {given.freecad}: there are roots for {' and '.join(freecad_roots.RELEASE_OF)}; without this option "
                        "this machine's FreeCAD is tested")
    options = [*(["--only", given.only] if given.only else []), *(["--long"] if given.long else []),
               *(["--in-freecad"] if given.in_freecad else [])]
    return freecad_roots.run_in_root(given.freecad, [f"{freecad_roots.CHECKOUT}/featuremesh", "test", *options])


def print_closing_lines(lines, failed):
    """Ctest's summary, and after a failure all that the failed tests said."""
    if failed:
        print("".join(lines), end="")
        return
    start = next((i for i, line in enumerate(lines) if "tests passed" in line), max(0, len(lines) - CLOSING_LINES))
    print("".join(lines[start:]), end="")


def bench(given):
    script = ROOT / "tests" / "benchmarks" / "run_benchmarks.py"
    options = ["--repeat", str(given.repeat), "--threads", str(given.threads)]
    options += ["--list"] if given.list else []
    options += ["--history"] if given.history else []
    options += ["--netgen"] if given.netgen else []
    options += ["--ours"] if given.ours else []
    for case in given.case or []:
        options += ["--case", case]
    if not (given.list or given.history):
        set_up(packages.PEER_PACKAGES + (packages.NETGEN_PACKAGES if given.netgen else ()))
    return subprocess.run([PYTHON, str(script), *options], env=freecad_environment()).returncode


def gui(given):
    part = [existing_file(given.part)] if given.part else []
    set_up(packages.WINDOW_PACKAGES)
    if not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        raise UserError("there is no screen (neither DISPLAY nor WAYLAND_DISPLAY is set)")
    program = os.environ.get("FREECAD", "freecad")
    code = subprocess.run([program, f"--module-path={WORKBENCH}", *part], env=freecad_environment()).returncode
    if code:
        raise Failure(f"FreeCAD ended with exit code {code}")
    print("FreeCAD was closed")
    return 0


def install(given):
    set_up()
    folder = addon.addon_folder()
    folder.mkdir(parents=True, exist_ok=True)
    print(f"FeatureMesh is installed in {addon.install_into(folder)}; start FreeCAD anew")
    return 0


def uninstall(given):
    print(f"FeatureMesh was removed from {addon.remove_from(addon.addon_folder())}")
    return 0


def task(given, **options):
    """Runs the command's task in FreeCAD."""
    if getattr(given, "size", None) is not None and not given.size > 0:
        raise UserError(f"--size {given.size:g}: the edge length must be larger than 0")
    if getattr(given, "threads", None) is not None and given.threads < 1:
        raise UserError(f"--threads {given.threads}: at least one thread is needed")
    set_up()
    return run_task({"command": given.command, **{name: value for name, value in options.items() if value is not None}})


def finish(result, print_json=False):
    """Prints what a task said, its warnings on standard error, and gives its exit code."""
    code = result["exit_code"]
    if code == 0 and print_json:
        print(json.dumps(result["data"], indent=1))
    else:
        print(result["message"], file=sys.stderr if code else sys.stdout, flush=True)
    for line in result["data"].get("warnings", []):
        print(f"warning: {line}", file=sys.stderr)
    return code


def existing_file(name):
    path = Path(name).expanduser()
    if not path.is_file():
        raise UserError(f"{name}: no such file")
    return str(path.resolve())


def written_file(name):
    """The absolute path of a file to write, whose folder must exist."""
    if name is None:
        return None
    path = Path(name).expanduser().absolute()
    if not path.parent.is_dir():
        raise UserError(f"{name}: the folder {path.parent} does not exist")
    return str(path)

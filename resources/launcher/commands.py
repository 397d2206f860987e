# SPDX-License-Identifier: GPL-3.0-or-later
"""What each command does: set-up, then one task in FreeCAD or one program."""
import contextlib
import json
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import addon
import ctest
import freecad_roots
import package_tests
import packages
import published
import sanitizers
import streams
import tidy
import wheels
from engine_build import ALL, IN_FREECAD, PYTHON, processes_at_once, set_up
from freecad_task import freecad_environment, how_it_ended, no_home, run_script, run_task, window_environment
from layout import EXAMPLES, RELEASE, ROOT, WORKBENCH, Failure, Unavailable, UserError
from setup_log import say

DOCUMENT = ".FCStd"   # the ending of its name


def mesh(given):
    part = existing_file(given.part)
    return finish(task(given, part=part, object=given.object, size=given.size, order=given.order, dimension=given.dimension,
                       ignore_below=given.ignore_below, threads=given.threads, out=written_document(given.out, part), json=written_file(given.json, ".json")))


def adopt(given):
    part = existing_file(given.part)
    return finish(task(given, part=part, mesh=given.mesh, object=given.object, size=given.size, threads=given.threads,
                       out=written_document(given.out, part), json=written_file(given.json, ".json")))


def update(given):
    part = existing_file(given.part)
    if given.solve:
        set_up(packages.SOLVER_PACKAGES)
    return finish(task(given, part=part, object=given.object, set=given.set, full=given.full, solve=given.solve, threads=given.threads,
                       out=written_document(given.out, part), json=written_file(given.json, ".json")))


def solve(given):
    part = existing_file(given.part)
    set_up(() if given.ccx else packages.SOLVER_PACKAGES)
    return finish(task(given, part=part, analysis=given.analysis, live=given.live, ccx=given.ccx, accuracy=given.accuracy, threads=given.threads,
                       out=written_document(given.out, part), json=written_file(given.json, ".json")))


def renumber(given):
    part = existing_file(given.part)
    return finish(task(given, part=part, object=given.object, out=written_document(given.out, part), json=written_file(given.json, ".json")))


def transfer(given):
    part = existing_file(given.part)
    new = existing_file(given.new) if given.new else None
    return finish(task(given, part=part, new=new, result=given.result, object=given.object, out=written_document(given.out, new or part),
                       json=written_file(given.json, ".json")))


def diff(given):
    old, new = existing_file(given.old), existing_file(given.new)
    picture = written_file(given.picture, ".png") if given.picture else None
    if picture:
        set_up(packages.PICTURE_PACKAGES)
    return finish(task(given, old=old, new=new, object=given.object, json=given.json, picture=picture), given.json)


def tree(given):
    part = existing_file(given.part)
    return finish(task(given, part=part, object=given.object, json=given.json), given.json)


def export(given):
    part = existing_file(given.part)
    return finish(task(given, part=part, object=given.object, format=given.format, out=written_file(given.out, "." + given.format)))


def picture(given):
    part, out = existing_file(given.part), written_file(given.out or Path(given.part).stem + ".png", ".png")
    set_up(packages.PICTURE_PACKAGES)
    return finish(task(given, part=part, object=given.object, quality=given.quality, limits=given.limits, cut=given.cut, filled=given.filled, out=out))


def run(given):
    """The script's own output goes through a descriptor of its own, beside FreeCAD's lines, which go to the log."""
    script, part = existing_file(given.script), existing_file(given.part) if given.part else None
    sys.stdout.flush()
    output = os.dup(1)
    try:
        return finish(task(given, script=script, part=part, output=output))
    finally:
        os.close(output)


def demo(given):
    out = str(in_a_folder(given.out))
    if Path(out).is_file():
        raise UserError(f"{given.out} is a file; give a folder with --out")
    set_up(packages.PICTURE_PACKAGES + packages.STUDY_PACKAGES)
    result = run_script(ROOT / "resources" / "demo" / "run_demo.py", {"FEATUREMESH_DEMO_OUT": out}, lines_to=sys.stdout)
    data_of(result)
    draw_report(out)
    study_of_demo(out)
    return finish(result)


def study_of_demo(folder):
    """A small study of the same bracket, by the very commands that the user's guide names."""
    from arguments import parse   # which needs this module first
    study = Path(folder) / "study"
    shutil.rmtree(study, ignore_errors=True)
    print("Study          six brackets from one base mesh: a hole and a fillet are varied", flush=True)
    for words in (["run", str(EXAMPLES / "bracket.FCStd"), "--vary", "HoleSketch.Hole6X=95:110", "--vary", "Fillet.Radius=2:5", "--sampling", "lhs",
                   "--cases", "6", "--responses", "mass,max_mises,max_displacement", "--size", "8", "--order", "1", "--solver", "ccx",
                   "--folder", str(study)], ["report", str(study)]):
        given = parse(["study", *words])
        if given.run(given):
            raise Failure(f"the study failed; see {study}")


def draw_report(folder):
    """Pictures need an OpenGL of their own process: VTK and FreeCAD each bring one."""
    done = subprocess.run([PYTHON, str(ROOT / "resources" / "demo" / "draw_report.py"), folder], env=freecad_environment())
    if done.returncode:
        raise Failure(f"the pictures could not be drawn (exit code {done.returncode})")


def test(given):
    if given.packages:
        return test_packages(given)
    if given.freecad is not None:
        return test_elsewhere(given)
    if given.sanitize:
        return sanitizers.run(given.sanitize, given.only)
    if given.tidy:
        return tidy.run(given.tidy, given.seconds)
    extra = () if given.in_freecad else packages.STYLE_PACKAGES + packages.WINDOWS_PACKAGES + packages.SOLVER_PACKAGES + packages.CLUSTER_PACKAGES
    set_up(packages.PICTURE_PACKAGES + packages.PEER_PACKAGES + packages.READER_PACKAGES + packages.STUDY_PACKAGES + extra, IN_FREECAD if given.in_freecad else ALL)
    say("running the tests" + (" in FreeCAD" if given.in_freecad else ""))
    options = [*(["-R", given.only] if given.only else []), *(["-L", ctest.IN_FREECAD_LABEL] if given.in_freecad else [])]
    environment = dict(os.environ)
    if given.long:   # one at a time, for their tables would mix
        options.append("--verbose")
        environment["FEATUREMESH_LONG"] = "1"
    else:
        options += ["-j", str(processes_at_once())]
    ctest.run(RELEASE, options, environment)
    return 0


def test_packages(given):
    """Makes the packages and installs them as a user does, beside every FreeCAD or the one that is asked for."""
    versions = [given.freecad] if given.freecad else list(freecad_roots.USERS_RELEASE_OF)
    if versions[0] not in freecad_roots.USERS_RELEASE_OF:
        raise UserError(f"--freecad {given.freecad}: packages are tested beside {', '.join(freecad_roots.USERS_RELEASE_OF)}")
    package(given)
    return package_tests.run(versions, given.only)


def test_elsewhere(given):
    """The same command in a root that has the FreeCAD asked for."""
    if given.freecad not in freecad_roots.RELEASE_OF:
        raise UserError(f"--freecad {given.freecad}: there are roots for {' and '.join(freecad_roots.RELEASE_OF)}; without this option "
                        "this machine's FreeCAD is tested")
    options = [*(["--only", given.only] if given.only else []), *(["--long"] if given.long else []),
               *(["--in-freecad"] if given.in_freecad else [])]
    return freecad_roots.run_in_root(given.freecad, [f"{freecad_roots.CHECKOUT}/featuremesh", "test", *options])


def bench(given):
    script = ROOT / "tests" / "benchmarks" / "run_benchmarks.py"
    options = ["--repeat", str(given.repeat), "--threads", str(given.threads)]
    options += ["--list"] if given.list else []
    options += ["--history"] if given.history else []
    options += ["--netgen"] if given.netgen else []
    options += ["--ours"] if given.ours else []
    if not given.divisor > 0 or given.edits < 0:
        raise UserError(f"--divisor {given.divisor:g} has to be above 0, and --edits {given.edits} not below 0")
    if given.documents:
        options += ["--documents", existing_folder(given.documents), "--divisor", str(given.divisor), "--edits", str(given.edits)]
    for case in given.case or []:
        options += ["--case", case]
    if not (given.list or given.history):
        set_up(packages.PEER_PACKAGES + (packages.NETGEN_PACKAGES if given.netgen else ()))
    return subprocess.run([PYTHON, str(script), *options], env=freecad_environment()).returncode


def gui(given):
    # The first word must be no option: Debian's FreeCAD lets Python read those before it. Of "-" it makes nothing.
    first = existing_file(given.part) if given.part else "-"
    if not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        raise UserError("there is no screen (neither DISPLAY nor WAYLAND_DISPLAY is set)")
    set_up(packages.WINDOW_PACKAGES)
    program = os.environ.get("FREECAD") or "freecad"
    if not shutil.which(program):
        raise Failure(f"FreeCAD's program {program} cannot be run; set FREECAD to another one")
    # Ctrl-C would end FreeCAD with all that is not saved.
    signal.signal(signal.SIGINT, lambda *_: print("\nfeaturemesh gui: FreeCAD stays open; close it in its window", file=sys.stderr))
    with subprocess.Popen([program, first, f"--module-path={WORKBENCH}"], env=window_environment(), start_new_session=True) as process:
        try:
            code = process.wait()
        except KeyboardInterrupt:   # SIGTERM, see __main__.py
            process.terminate()
            raise
    if code:
        raise Failure(f"FreeCAD {how_it_ended(code)}{no_home()}")
    print("FreeCAD was closed")
    return 0


def about(given):
    return finish(task(given))


def install(given):
    set_up()
    folder = addon.addon_folder()
    folder.mkdir(parents=True, exist_ok=True)
    print(f"FeatureMesh is installed in {addon.install_into(folder)}; start FreeCAD anew")
    return 0


def uninstall(given):
    print(f"FeatureMesh was removed from {addon.remove_from(addon.addon_folder())}")
    return 0


def package(given):
    fetch_packaging_tools()
    set_up(packages.PACKAGING_PACKAGES)
    for path in published.make_all(ROOT / "dist", given.python):
        print(f"{path.stat().st_size / 1e6:5.1f} MB  {path.relative_to(ROOT)}")
    return 0


def fetch_packaging_tools():
    """Installs and unpacks what makes packages. Throws Unavailable."""
    try:
        packages.install_missing(packages.PACKAGING_PACKAGES)
        wheels.fetch_tools()
    except Failure as failure:
        raise Unavailable(f"what makes packages cannot be had here: {failure}") from None


def task(given, **options):
    """Runs the command's task in FreeCAD."""
    if getattr(given, "size", None) is not None and not given.size > 0:
        raise UserError(f"--size {given.size:g}: the edge length must be larger than 0")
    if getattr(given, "threads", None) is not None and given.threads < 1:
        raise UserError(f"--threads {given.threads}: at least one thread is needed")
    set_up()
    with contextlib.ExitStack() as stack:
        files = {name: stack.enter_context(streams.file_for(value)) for name, value in options.items() if value is not None}
        result = run_task({"command": given.command, **files})
        for name, stream in options.items():
            if isinstance(stream, streams.Stream):
                for written in (files[name], os.path.relpath(files[name])):
                    result["message"] = result["message"].replace(written, stream.name)
        return {**result, "tell": streams.beside(*options.values())}


def finish(result, print_json=False):
    """Prints what a task said, beside what went to standard output, and its warnings on standard error, and gives exit code 0. Throws UserError, Failure
    where the task failed."""
    data = data_of(result)
    if print_json:
        print(json.dumps(data, indent=1))
    elif result["message"]:
        print(result["message"], file=result.get("tell"), flush=True)
    for line in data.get("warnings", []):
        print(f"warning: {line}", file=sys.stderr)
    return 0


def data_of(result):
    """What a task gave. Throws UserError, Failure with its message where it failed."""
    if result["exit_code"]:
        raise (UserError if result["exit_code"] == 2 else Failure)(result["message"])
    return result["data"]


def existing_file(name):
    path = Path(name).expanduser()
    if path.is_dir():
        raise UserError(f"{name} is a folder; name a file in it")
    if not path.is_file():
        raise UserError(f"{name}: no such file")
    return str(path.resolve())


def existing_folder(name):
    path = Path(name).expanduser()
    if not path.is_dir():
        raise UserError(f"{name}: no such folder")
    return str(path.resolve())


def written_document(name, read):
    """The absolute path of a document to write, whose folder must exist; None where the document that is read is to be replaced."""
    if name is None:
        if not may_be_written(Path(read)):
            raise UserError(f"{read}: nothing can be written to its folder; name another document with --out")
        return None
    if not is_document(name):
        raise UserError(f"{name}: the name of a document ends in {DOCUMENT}")
    return path_to_write(name)


def written_file(name, ending):
    """The absolute path of another file to write, likewise; a Stream for what is none, which is written by way of a file with that ending."""
    if name is not None and streams.is_stream(name):
        return streams.Stream(name, ending)
    if name is not None and is_document(name):
        raise UserError(f"{name} is the name of a document, which this would overwrite; name another file")
    return path_to_write(name)


def is_document(name):
    return name.lower().endswith(DOCUMENT.lower())


def path_to_write(name):
    if name is None:
        return None
    path = in_a_folder(name)
    if path.is_dir():
        raise UserError(f"{name} is a folder; name a file in it to write")
    return str(path)


def in_a_folder(name):
    """The absolute path of what is to be written, whose folder must exist."""
    path = Path(name).expanduser().absolute()
    if not path.parent.is_dir():
        raise UserError(f"{name}: the folder {path.parent} does not exist")
    if not may_be_written(path):
        raise UserError(f"{name}: nothing can be written to the folder {path.parent}; name another one")
    return path


def may_be_written(path):
    """Can the file (or folder) be written, or made in its folder? Asked before the work is done, not after."""
    return os.access(path, os.W_OK) or os.access(path.parent, os.W_OK)

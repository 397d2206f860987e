# SPDX-License-Identifier: GPL-3.0-or-later
"""What each command of `featuremesh study` does. The studies themselves are in the workbench (freecad/featuremesh/study)."""
import contextlib
import errno
import os
import re
import shlex
import sys
import types
from pathlib import Path

import packages
import streams
from commands import data_of, existing_file, written_file
from engine_build import set_up
from freecad_task import ProgressLine, freecad_environment, freecadcmd, run_task
from layout import WORKBENCH, Failure, UserError


def workbench():
    """The workbench's package for studies, found without Debian's package `freecad`, which would load FreeCAD."""
    if "freecad" not in sys.modules:
        sys.modules["freecad"] = types.ModuleType("freecad")
        sys.modules["freecad"].__path__ = [str(WORKBENCH / "freecad")]
    from freecad.featuremesh import study
    return study


def english(message):
    """A message of the workbench in words."""
    workbench()
    from freecad.featuremesh import messages
    return messages.english(message)


@contextlib.contextmanager
def errors_of_studies():
    """The workbench's errors as the launcher's."""
    workbench()
    from freecad.featuremesh.errors import UserError as StudyError
    from freecad.featuremesh.study.database import DiskFull
    from freecad.featuremesh.study.case_book import Stopped
    try:
        yield
    except (DiskFull, Stopped) as error:
        raise Failure(str(error)) from error
    except OSError as error:
        if error.errno not in (errno.ENOSPC, errno.EDQUOT):
            raise
        raise Failure(f"the disk is full ({error}); every finished case is safe. Make room, then go on with `study resume`") from error
    except StudyError as error:
        raise UserError(str(error)) from error


def set_up_to_run(given, live=False):
    """Installs what the command needs and is missing; the live solver's packages only where that is asked for. Throws UserError where the cases cannot be
    run as asked for, before anything is made."""
    for option, count in (("--jobs", given.jobs), ("--slurm", given.slurm)):
        if count is not None and count < 1:
            raise UserError(f"{option} {count}: at least one job is needed")
    if given.scheduler and not re.search(r":\d+$", given.scheduler):
        raise UserError(f"--scheduler {given.scheduler}: the address of a scheduler is tcp://HOST:PORT, such as tcp://localhost:8786")
    if given.slurm is not None:
        with errors_of_studies():
            from freecad.featuremesh.study.slurm import refuse_without_slurm
            refuse_without_slurm()
    set_up(packages.STUDY_PACKAGES + (packages.SOLVER_PACKAGES if live else ()) + (packages.CLUSTER_PACKAGES if given.scheduler or given.slurm is not None else ())
           + (packages.OPTUNA_PACKAGES if getattr(given, "method", None) == "optuna" else ()))
    if given.scheduler:
        with errors_of_studies():
            from freecad.featuremesh.study.dask_runner import connect
            connect(given.scheduler).close()


def run(given):
    with errors_of_studies():
        from freecad.featuremesh.study import design
        study = design.read_toml(existing_file(given.what)) if given.what.endswith(".toml") else study_of_options(given)
        design.check(study)
        if not os.path.isfile(study.document):
            raise UserError(f"{given.what} names the document {study.document}, which is not there; its path is relative to that of the study's file")
        set_up_to_run(given, study.solver == "live")
        folder = new_folder(study, given.folder or Path(given.what).stem + "-study")
        return run_cases(folder, given)


def study_of_options(given):
    """The study that the command line says."""
    from freecad.featuremesh.study import design, response_words
    if not given.vary or not given.responses:
        raise UserError("without a study's file, say what to vary and what to ask: --vary OBJECT.PROPERTY=LOW:HIGH --responses mass,max_mises")
    study = design.Study(existing_file(given.what), [design.parse_parameter(text) for text in given.vary],
                         response_words.parse_list(given.responses), object=given.object, analysis=given.analysis, solver=given.solver,
                         constraints=given.constraint, mesh_size=given.size, mesh_order=given.order)
    for name, value in (("sampling", given.sampling), ("cases", given.cases), ("seed", given.seed), ("threads", given.threads),
                        ("seconds_limit", given.time_limit), ("memory_limit_gb", given.memory_limit),
                        ("rows", given.rows and existing_file(given.rows)), ("keep", given.keep and given.keep.split(","))):
        if value is not None:
            setattr(study, name, value)
    return study


def new_folder(study, path):
    """The study's folder, with the base document and the planned cases; locked."""
    from freecad.featuremesh.study import beginning
    folder = beginning.begin(study, path, make_base)
    for remark in folder.facts()["remarks"]:
        print(f"warning: {english(remark)}", file=sys.stderr)
    return folder


def make_base(plain_study, out):
    return data_of(run_task({"command": "study_base", "study": plain_study, "out": out}))


def resume(given):
    set_up_to_run(given)
    with errors_of_studies():
        folder = locked_folder(given.folder)
        set_limits(folder, given)
        if given.retry_failed:
            folder.database.retry_failed()
        return run_cases(folder, given, given.keep_base)


def set_limits(folder, given):
    """Gives the cases other limits, which change no result."""
    from freecad.featuremesh.study import design
    study = folder.study()
    for name, value in (("seconds_limit", given.time_limit), ("memory_limit_gb", given.memory_limit)):
        if value is not None:
            setattr(study, name, value)
    design.check_limits(study)
    folder.database.set_value("study", study.to_plain())


def add(given):
    set_up_to_run(given)
    if given.cases is not None and given.cases < 1:
        raise UserError(f"--cases {given.cases}: at least one case has to be added")
    with errors_of_studies():
        from freecad.featuremesh.study import planning
        folder = locked_folder(given.folder)
        count = planning.extend(folder, given.cases, given.rows and existing_file(given.rows))
        print(f"added {count} case{'' if count == 1 else 's'}", flush=True)
        return run_cases(folder, given)


def locked_folder(path):
    from freecad.featuremesh.study.folder import StudyFolder
    folder = StudyFolder(path)
    folder.lock()
    return folder


def run_cases(folder, given, keep_base=False):
    """Runs what waits, with a line of progress; says at the end what came out, or how to go on."""
    shown = ProgressLine()
    try:
        with runner_of(folder, given, progress_shower(shown), keep_base) as runner:
            runner.run()
    except KeyboardInterrupt:
        shown.clear()
        return tell_stopped(folder, f"featuremesh study resume {typed_path(folder.path)}")
    finally:
        shown.clear()
    return tell_end(folder)


def optimise(given):
    set_up_to_run(given)
    with errors_of_studies():
        from freecad.featuremesh.study.optimise import Optimiser
        from freecad.featuremesh.study.optuna_search import OptunaOptimiser
        folder = locked_folder(given.folder)
        optimiser = {"surfaces": Optimiser, "optuna": OptunaOptimiser}[given.method](folder, given.minimise, given.limit)
        try:
            with runner_of(folder, given, None, False) as runner:
                found = optimiser.run(lambda case_id: runner.run([case_id]), given.solves, tell_evaluation)
        except KeyboardInterrupt:
            return tell_stopped(folder, "the same command")
        if found.case is None:
            print(f"no case keeps {' and '.join(given.limit)} after {found.solves} solutions: {found.reason}")
            return 1
        print(f"best: {in_words(found.case)}; {found.solves} solutions, {found.reason}")
        return 0


def tell_evaluation(case, best):
    """A line for each case that the optimiser asked for."""
    print(f"{in_words(case)}{', the best so far' if best and best.id == case.id else ''}", file=sys.stderr, flush=True)


def in_words(case):
    if case.state != "done":
        return f"case {case.id} {case.state}: {english(case.message)}"
    return f"case {case.id}: " + ", ".join(f"{name} {value:.5g}" if isinstance(value, float) else f"{name} {value}"
                                           for name, value in {**case.parameters, **case.responses}.items())


def tell_stopped(folder, how):
    counts = folder.database.counts()
    print(f"stopped: {counts['done']} of {sum(counts.values())} cases are done and kept; go on with: {how}", file=sys.stderr)
    return 1


@contextlib.contextmanager
def runner_of(folder, given, show, keep_base):
    """On this machine, on a Dask scheduler's workers, or in Slurm jobs."""
    if given.slurm is not None:
        from freecad.featuremesh.study.slurm import slurm_cluster
        with slurm_cluster(given.slurm, folder.study(), folder.facts()) as address, dask_runner(folder, address, show, keep_base) as runner:
            yield runner
    elif given.scheduler:
        with dask_runner(folder, given.scheduler, show, keep_base) as runner:
            yield runner
    else:
        from freecad.featuremesh.study.runner import Machine, Runner
        machine = Machine(freecadcmd(), freecad_environment(), jobs_at_once(given.jobs, folder.study().threads))
        with Runner(folder, machine, show, keep_base) as runner:
            yield runner


def dask_runner(folder, address, show, keep_base):
    from freecad.featuremesh.study.dask_runner import Cluster, DaskRunner
    sys.path.append(str(WORKBENCH / "freecad" / "featuremesh" / "study"))   # for dask_worker, which Dask sends by its name
    return DaskRunner(folder, Cluster(address, str(WORKBENCH), freecad_environment()["FEATUREMESH_ENGINE"], freecadcmd()), show, keep_base)


def progress_shower(shown):
    """Shows each line on a terminal; elsewhere a line whenever another case is finished."""
    from freecad.featuremesh.study import progress
    last = [None]

    def show(counts, running_for, seconds, jobs):
        text = progress.line(counts, running_for, seconds, jobs)
        shown.show(text)
        finished = counts["done"] + counts["infeasible"] + counts["failed"]
        if not sys.stderr.isatty() and finished != last[0]:
            print(text, file=sys.stderr, flush=True)
        last[0] = finished
    return show


def jobs_at_once(asked, threads):
    """As many as the processors take, each with its threads."""
    fitting = max(1, len(os.sched_getaffinity(0)) // threads)
    if asked is not None and asked > fitting:
        print(f"{asked} jobs of {threads} thread{'s' if threads > 1 else ''} do not fit {len(os.sched_getaffinity(0))} processors; {fitting} run at once",
              file=sys.stderr)
    return min(asked or fitting, fitting)


def tell_end(folder):
    """A study whose cases are infeasible is no failure; one with failed cases is."""
    counts = folder.database.counts()
    words = [f"{counts['done']} of {sum(counts.values())} cases done"] + [f"{counts[state]} {state}" for state in ("infeasible", "failed") if counts[state]]
    print(", ".join(words) + f"; see them with: featuremesh study {'report' if counts['done'] else 'status'} {typed_path(folder.path)}")
    for case in folder.database.cases("failed"):
        print(f"warning: case {case.id}: {english(case.message)}", file=sys.stderr)
    return 1 if counts["failed"] else 0


def status(given):
    with errors_of_studies():
        from freecad.featuremesh.study.folder import StudyFolder
        folder = StudyFolder(given.folder)
        study, counts = folder.study(), folder.database.counts()
        print(f"{shown_path(study.document)}: " + ", ".join(f"{count} {state}" for state, count in counts.items()))
        for state in ("infeasible", "failed"):
            for case in folder.database.cases(state):
                print(f"{state}: case {case.id}: {english(case.message)}")
        return 0


def export(given):
    with errors_of_studies():
        from freecad.featuremesh.study import table
        from freecad.featuremesh.study.folder import StudyFolder
        out = written_file(given.out, "." + (given.format or "csv"))
        with streams.file_for(out) as file:
            count = table.write(StudyFolder(given.folder), file, given.format)
        print(f"wrote {given.out} ({count} cases)", file=streams.beside(out))
        return 0


def report(given):
    if given.limit and not given.minimise:
        raise UserError("--limit says what the case of --minimise has to keep; give both")
    set_up(packages.STUDY_PACKAGES)
    with errors_of_studies():
        from freecad.featuremesh.study import report as page
        from freecad.featuremesh.study.folder import StudyFolder
        folder = StudyFolder(given.folder)
        out = written_file(given.out or os.path.join(folder.path, "report.html"), ".html")
        with streams.file_for(out) as file:
            page.write(folder, file, given.pareto.split(",") if given.pareto else None, given.minimise, given.limit)
        print(f"wrote {out.name if isinstance(out, streams.Stream) else shown_path(out)}", file=streams.beside(out))
        return 0


def typed_path(path):
    """As a word of a command, with quotes where its name needs them."""
    return shlex.quote(shown_path(path))


def shown_path(path):
    """As short as it can be typed."""
    relative = os.path.relpath(path)
    return path if relative.startswith("..") else relative

# SPDX-License-Identifier: GPL-3.0-or-later
"""The options of `featuremesh study ...`."""
import study_commands
from lengths import millimetres


def add_commands(study, command, add_object):
    """Adds the commands of `study`; `command` and `add_object` are those of arguments.py."""
    parts = study.add_subparsers(prog="featuremesh study", dest="study_command", metavar="COMMAND ...", required=True, parser_class=type(study))
    for add in (add_run, add_status, add_resume, add_add, add_export, add_report, add_optimise):
        add(parts, command, add_object)


def add_run(parts, command, add_object):
    run = command(parts, "run", study_commands.run, "start a study of a study.toml, or of a document and what to vary in it")
    run.add_argument("what", metavar="STUDY.toml|PART.FCStd", help="a study's file, or a document with a mesh and an analysis")
    add_object(run)
    run.add_argument("--vary", action="append", default=[], metavar="OBJECT.PROPERTY=LOW:HIGH",
                     help="a parameter and its range, LOW:HIGH:LEVELS for a grid, or its values A,B,C; may be repeated")
    run.add_argument("--sampling", metavar="HOW", help="grid, one_at_a_time, lhs (default), sobol, halton, box_behnken, central_composite or csv")
    run.add_argument("--cases", type=int, metavar="N", help="cases of lhs, sobol and halton")
    run.add_argument("--rows", metavar="ROWS.csv", help="cases of one's own, for --sampling csv: a column for each parameter")
    run.add_argument("--constraint", action="append", default=[], metavar="EXPRESSION", help="what the parameters have to keep; may be repeated")
    run.add_argument("--responses", metavar="KIND,KIND@PLACE,KIND:p95", help="what is asked of each case, such as mass,max_mises,max_displacement@Face3")
    run.add_argument("--solver", metavar="live|ccx", help="default: live where that knows all that the analysis holds")
    run.add_argument("--analysis", metavar="NAME", help="the analysis (default: the only one of the document)")
    run.add_argument("--size", type=millimetres, metavar="H", help="edge length of the base mesh (default: as the document's mesh has it)")
    run.add_argument("--order", type=int, choices=(1, 2), help="order of the elements (default: as the document's mesh has it, or 2)")
    run.add_argument("--keep", metavar="mesh,inp,frd", help="files to keep of each case (default: none)")
    run.add_argument("--seed", type=int, metavar="N", help="of lhs, sobol and halton (default: 1)")
    run.add_argument("--threads", type=int, metavar="N", help="threads of each case (default: 1)")
    add_limits(run, "3600", "what the machine has")
    run.add_argument("--folder", metavar="DIR", help="the study's folder, made if need be (default: named as the file is)")
    add_machine(run)


def add_resume(parts, command, _):
    resume = command(parts, "resume", study_commands.resume, "go on with a study that was ended, or whose document was changed")
    add_folder(resume)
    resume.add_argument("--keep-base", action="store_true", help="go on with the document as it was when the study began")
    resume.add_argument("--retry-failed", action="store_true", help="run failed cases again, too")
    add_limits(resume, "as before", "as before")
    add_machine(resume)


def add_add(parts, command, _):
    add = command(parts, "add", study_commands.add, "add cases to a study and run them; those of sobol and halton go on where they stopped")
    add_folder(add)
    which = add.add_mutually_exclusive_group(required=True)
    which.add_argument("--cases", type=int, metavar="N", help="so many more of the same sampling")
    which.add_argument("--rows", metavar="ROWS.csv", help="cases of one's own: a column for each parameter")
    add_machine(add)


def add_status(parts, command, _):
    add_folder(command(parts, "status", study_commands.status, "tell how far a study is, and what failed"))


def add_export(parts, command, _):
    export = command(parts, "export", study_commands.export, "write a study's cases to a table")
    add_folder(export)
    export.add_argument("--format", choices=("csv", "json"), help="default: what the file's name says")
    export.add_argument("out", metavar="OUT", help="the file to write")


def add_report(parts, command, _):
    report = command(parts, "report", study_commands.report, "write what a study found as a page with pictures")
    add_folder(report)
    report.add_argument("--pareto", metavar="A,B", help="two responses whose best compromises are shown (default: the first two)")
    report.add_argument("--minimise", metavar="EXPRESSION", help="of responses and parameters: name the case with its least value")
    report.add_argument("--limit", action="append", default=[], metavar="EXPRESSION", help="what that case has to keep, such as 'max_mises <= 120'")
    report.add_argument("--out", metavar="OUT.html", help="the page (default: report.html in the folder)")


def add_optimise(parts, command, _):
    optimise = command(parts, "optimise", study_commands.optimise, "look for the best case; every evaluation is a case of the study")
    add_folder(optimise)
    optimise.add_argument("--minimise", required=True, metavar="EXPRESSION", help="of responses and parameters, such as mass or -frequency_1")
    optimise.add_argument("--limit", action="append", default=[], metavar="EXPRESSION", help="what has to be kept, such as 'max_mises <= 120'; may be repeated")
    optimise.add_argument("--method", choices=("surfaces", "optuna"), default="surfaces", help="surfaces through all cases, or Optuna's TPE (default: %(default)s)")
    optimise.add_argument("--solves", type=int, default=40, metavar="N", help="cases at most (default: %(default)s)")
    add_machine(optimise)


def add_folder(parser):
    parser.add_argument("folder", metavar="DIR", help="the study's folder")


def add_limits(parser, seconds, gigabytes):
    """The words are the defaults."""
    parser.add_argument("--time-limit", type=float, metavar="SECONDS", help=f"of each case (default: {seconds})")
    parser.add_argument("--memory-limit", type=float, metavar="GB", help=f"of each case (default: {gigabytes})")


def add_machine(parser):
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--jobs", type=int, metavar="N", help="cases at once (default: as many as the processors)")
    which.add_argument("--scheduler", metavar="tcp://HOST:PORT", help="run the cases on the workers of this Dask scheduler")
    which.add_argument("--slurm", type=int, metavar="JOBS", help="run the cases in so many Slurm jobs, by dask-jobqueue with its settings for Slurm")

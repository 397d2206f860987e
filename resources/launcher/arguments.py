# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands and their options. Lengths in mm."""
import argparse

import commands
import study_arguments
import wheels
from lengths import ignored_length, millimetres, share

PROGRAM = "featuremesh"
DESCRIPTION = "Tetrahedral FEM meshes of FreeCAD parts that are updated locally when the part is edited. Lengths in mm."


def one_line_each(prog):
    """Room for every command's explanation in one line."""
    return argparse.HelpFormatter(prog, max_help_position=20, width=100)


class Parser(argparse.ArgumentParser):
    """Errors in one line."""

    def error(self, message):
        self.exit(2, f"{self.prog}: {message} (see {self.prog} --help)\n")


def parse(words):
    parser = Parser(prog=PROGRAM, description=DESCRIPTION, usage=f"{PROGRAM} [-h] COMMAND ...",
                    formatter_class=one_line_each)
    parser.add_argument("--version", action="version", version=f"FeatureMesh {wheels.project_version()}", help="tell the version; of everything: about")
    subparsers = parser.add_subparsers(prog=PROGRAM, dest="command", metavar="COMMAND ...", required=True, parser_class=Parser)
    for add in (add_demo, add_test, add_mesh, add_adopt, add_update, add_solve, add_transfer, add_renumber, add_diff, add_tree, add_export, add_picture, add_script,
                add_gui, add_bench, add_study,
                add_install, add_uninstall, add_package, add_about):
        add(subparsers)
    return parser.parse_args(words)


def command(subparsers, name, run, line):
    parser = subparsers.add_parser(name, help=line, description=line[0].upper() + line[1:] + ".")
    parser.set_defaults(run=run)
    return parser


def add_demo(subparsers):
    demo = command(subparsers, "demo", commands.demo, "mesh, solve, edit, update and solve again an example, with a page of pictures")
    demo.add_argument("--out", metavar="DIR", default="featuremesh-out", help="folder for the page and the documents (default: %(default)s)")


def add_test(subparsers):
    test = command(subparsers, "test", commands.test, "build everything and run every test")
    test.add_argument("--freecad", metavar="VERSION", help="FreeCAD to test with: 1.0 or 1.1, in a root of another Debian release (default: this machine's)")
    test.add_argument("--long", action="store_true", help="also what takes minutes (all FEM examples, fine meshes), with its tables")
    test.add_argument("--in-freecad", action="store_true", help="only what runs in FreeCAD: the engine is built, the tests of its modules are not")
    test.add_argument("--sanitize", choices=("address", "thread"), help="the tests of the engine's modules, built with the address and "
                      "undefined behaviour sanitizers, or with the thread sanitizer")
    test.add_argument("--tidy", metavar="COMMIT", help="clang-tidy on the source files that changed since the commit")
    test.add_argument("--seconds", type=float, help="with --tidy: look at what changed last, as long as that takes no longer")
    test.add_argument("--packages", action="store_true", help="make the packages and install them in roots without anything to build with")
    test.add_argument("--python", action="append", default=[], metavar="PROGRAM", help=argparse.SUPPRESS)   # as for package
    test.add_argument("--only", metavar="PATTERN", help="run only tests whose name matches this regular expression")


def add_mesh(subparsers):
    mesh = command(subparsers, "mesh", commands.mesh, "add a mesh to a document's part")
    add_part(mesh)
    mesh.add_argument("--size", type=millimetres, metavar="H", help="edge length of the elements (default: chosen from the part)")
    mesh.add_argument("--order", type=int, choices=(1, 2), help="1: 4-node tetrahedra, too stiff in bending; 2: 10-node tetrahedra (default: 2, or as the document's mesh has it)")
    mesh.add_argument("--dimension", choices=("solids", "faces", "edges"), help="what is meshed: solids with tetrahedra, faces with triangles (shells), edges "
                      "with segments (beams); default: solids, else faces, else edges, as the part has them, or as the document's mesh has it")
    mesh.add_argument("--ignore-below", type=ignored_length, metavar="LENGTH", help="edges, steps and strips of faces smaller than this get no elements of their own: mm, off, "
                      "or auto, a two-hundredth of the size, or less where the part cannot be meshed so (default: auto, or as the document's mesh has it)")
    add_run(mesh)


def add_update(subparsers):
    update = command(subparsers, "update", commands.update, "edit a meshed part and update its mesh locally")
    add_part(update)
    update.add_argument("--set", action="append", default=[], metavar="OBJECT.PROPERTY=VALUE",
                        help="an edit: a property, Sketch.CONSTRAINT, Spreadsheet.ALIAS or Object.Placement.Base.x; may be repeated")
    update.add_argument("--solve", action="store_true", help="solve the analysis afterwards, as `solve` does")
    update.add_argument("--full", action="store_true", help="mesh the edited part from scratch instead, for comparison")
    add_run(update)


def add_solve(subparsers):
    solve = command(subparsers, "solve", commands.solve, "solve a meshed part's analysis, live (linear statics) or with CalculiX")
    solve.add_argument("part", metavar="PART.FCStd", help="a document with a mesh and an analysis")
    solve.add_argument("--analysis", metavar="NAME", help="the analysis (default: the only one of the document)")
    which = solve.add_mutually_exclusive_group()
    which.add_argument("--live", action="store_true", help="only the live solver, no CalculiX for what it does not know")
    which.add_argument("--ccx", action="store_true", help="only CalculiX")
    which.add_argument("--accuracy", type=share, metavar="PERCENT", help="the live solver; then the mesh is made finer where the result is off the most, and solved "
                       "again, until the estimate of its error in the energy norm is no more than this")
    add_run(solve)


def add_adopt(subparsers):
    adopt = command(subparsers, "adopt", commands.adopt, "take over a mesh that Gmsh or another mesher made, so that it is updated locally")
    add_part(adopt)
    adopt.add_argument("--mesh", required=True, metavar="NAME", help="the FEM mesh object to adopt; it stays in the document")
    adopt.add_argument("--size", type=millimetres, metavar="H", help="edge length for what is meshed anew (default: that of the mesh)")
    add_run(adopt)


def add_renumber(subparsers):
    renumber = command(subparsers, "renumber", commands.renumber, "number a mesh's nodes and elements anew, from 1 without gaps")
    add_part(renumber)
    renumber.add_argument("--out", metavar="OUT.FCStd", help="the document to write (default: the document itself)")
    renumber.add_argument("--json", metavar="REPORT.json", help="write the report to this file, or to standard output (-)")


def add_transfer(subparsers):
    transfer = command(subparsers, "transfer", commands.transfer, "carry a solved result over to the updated mesh, with an estimate of the error")
    transfer.add_argument("part", metavar="OLD.FCStd", help="the document with the result")
    transfer.add_argument("new", metavar="NEW.FCStd", nargs="?",
                          help="the document with the updated mesh (default: OLD itself, whose mesh was updated after it was solved)")
    transfer.add_argument("--result", metavar="NAME", help="the result object (default: the only one)")
    add_object(transfer)
    transfer.add_argument("--out", metavar="OUT.FCStd", help="the document to write (default: NEW)")
    transfer.add_argument("--json", metavar="REPORT.json", help="write the report to this file, or to standard output (-)")


def add_diff(subparsers):
    diff = command(subparsers, "diff", commands.diff, "tell what changed between two documents, feature by feature")
    diff.add_argument("old", metavar="OLD.FCStd", help="the document before")
    diff.add_argument("new", metavar="NEW.FCStd", help="the document after")
    diff.add_argument("--picture", metavar="OUT.png", help="draw both: kept faces as glass; vanished, appeared and differently cut ones in colours")
    add_object(diff)
    add_print_json(diff)


def add_tree(subparsers):
    tree = command(subparsers, "tree", commands.tree, "print the feature tree as the engine understands it")
    add_part(tree)
    add_print_json(tree)


def add_export(subparsers):
    export = command(subparsers, "export", commands.export, "write a document's mesh with its groups to a file")
    export.add_argument("part", metavar="PART.FCStd", help="a document with a mesh")
    export.add_argument("--format", required=True, choices=("vtu", "vtk", "inp", "bdf", "msh", "stl", "unv", "med", "z88"), help="format of the file")
    export.add_argument("out", metavar="OUT", help="the file to write, or standard output (-)")
    add_object(export)


def add_picture(subparsers):
    picture = command(subparsers, "picture", commands.picture, "draw a document's mesh, coloured by a measure of quality, perhaps cut open")
    add_part(picture)
    picture.add_argument("--quality", default="dihedral_angle", metavar="MEASURE", choices=(
        "dihedral_angle", "radius_ratio", "aspect_ratio", "scaled_jacobian", "skewness", "size_ratio"),
        help="dihedral_angle (default), radius_ratio, aspect_ratio, scaled_jacobian, skewness or size_ratio")
    picture.add_argument("--limits", type=float, nargs=2, metavar=("BAD", "GOOD"), help="where the colours end (default: the measure's own)")
    picture.add_argument("--cut", metavar="PLANE", help="what stays: z=5 or z<5 below a plane, z>5 above it; x and y likewise")
    picture.add_argument("--filled", action="store_true", help="cut through the elements instead of showing whole ones")
    picture.add_argument("--out", metavar="OUT.png", help="the picture to write (default: the document's name with .png)")


def add_script(subparsers):
    script = command(subparsers, "run", commands.run, "run a Python script in FreeCAD, with `api` and the open `document`")
    script.add_argument("script", metavar="SCRIPT.py", help="the script; what it prints is all that is printed")
    script.add_argument("part", metavar="PART.FCStd", nargs="?", help="a document to open for it")


def add_gui(subparsers):
    gui = command(subparsers, "gui", commands.gui, "open FreeCAD with the FeatureMesh workbench")
    gui.add_argument("part", metavar="PART.FCStd", nargs="?", help="a document to open")


def add_study(subparsers):
    study = command(subparsers, "study", None, "run many variants of a part and compare them: study run, status, resume, report and more")
    study_arguments.add_commands(study, command, add_object)


def add_bench(subparsers):
    bench = command(subparsers, "bench", commands.bench, "measure full meshes, updates and other meshers on the same parts")
    bench.add_argument("--case", action="append", metavar="NAME", help="only this case; may be repeated (default: all)")
    bench.add_argument("--repeat", type=int, default=5, metavar="N", help="runs of each, for the median (default: %(default)s)")
    bench.add_argument("--threads", type=int, default=1, metavar="N", help="threads of each mesher (default: %(default)s)")
    bench.add_argument("--netgen", action="store_true", help="measure Netgen, too, once for each case")
    bench.add_argument("--ours", action="store_true", help="measure the full mesh and the update only, without Gmsh")
    bench.add_argument("--documents", metavar="FOLDER", help="in place of the cases: every document of a folder and edits of its dimensions, with percentiles")
    bench.add_argument("--divisor", type=float, default=40, metavar="N", help="with --documents: the size is the part's diagonal over this (default: %(default)g)")
    bench.add_argument("--edits", type=int, default=3, metavar="N", help="with --documents: edits of each document (default: %(default)s)")
    bench.add_argument("--list", action="store_true", help="list the cases and stop")
    bench.add_argument("--history", action="store_true", help="what was measured before on this machine, and stop")


def add_install(subparsers):
    command(subparsers, "install", commands.install, "put the workbench into FreeCAD's folder for add-ons")


def add_uninstall(subparsers):
    command(subparsers, "uninstall", commands.uninstall, "remove the workbench from FreeCAD's folder for add-ons")


def add_package(subparsers):
    package = command(subparsers, "package", commands.package, "make wheels, addon, portable zip and Debian package in dist")
    package.add_argument("--python", action="append", default=[], metavar="PROGRAM",
                         help="one more Python to make a wheel for, which has its headers; may be repeated")


def add_about(subparsers):
    command(subparsers, "about", commands.about, "tell the versions of everything, for a bug report")


def add_part(parser):
    parser.add_argument("part", metavar="PART.FCStd", help="the document")
    add_object(parser)


def add_object(parser):
    parser.add_argument("--object", metavar="NAME", help="the body or solid (default: the only one of the document)")


def add_run(parser):
    parser.add_argument("--threads", type=int, metavar="N", help="threads of the engine (default: all processors)")
    parser.add_argument("--out", metavar="OUT.FCStd", help="the document to write (default: the document itself)")
    parser.add_argument("--json", metavar="REPORT.json", help="write the report to this file, or to standard output (-)")


def add_print_json(parser):
    parser.add_argument("--json", action="store_true", help="print JSON instead of a table")

# SPDX-License-Identifier: GPL-3.0-or-later
"""The Debian packages FeatureMesh needs, each group with its reason, and how the missing ones are installed."""
import contextlib
import fcntl
import os
import shutil
import subprocess
from pathlib import Path

from layout import BUILD, Failure
from setup_log import run_logged, say

RECORDS = "/var/lib/dpkg/info"   # of what Debian has installed
BUILD_PACKAGES = (
    "g++", "cmake", "ninja-build", "ccache", "python3-dev", "pybind11-dev", "catch2", "libtbb-dev", "libboost-dev",
    "libgmp-dev", "libmpfr-dev", "libocct-foundation-dev", "libocct-modeling-data-dev", "libocct-modeling-algorithms-dev",
    "libocct-visualization-dev",  # holds a header that OCCT's modelling headers include
)
RUN_PACKAGES = ("freecad-python3", "python3-numpy", "calculix-ccx", "tetgen")
PICTURE_PACKAGES = ("python3-vtk9", "python3-matplotlib", "xvfb", "xauth", "libgl1-mesa-dri")
PEER_PACKAGES = ("gmsh",)
READER_PACKAGES = ("python3-meshio", "python3-h5py")
STYLE_PACKAGES = ("clang-format-14", "flake8")
TIDY_PACKAGES = ("clang-tidy-16",)
SANITIZER_PACKAGES = ("clang-16", "libclang-rt-16-dev", "llvm-16")
SOLVER_PACKAGES = ("pkg-config", "libpetsc-real-dev")   # optional: without them the engine is built without its live solver
STUDY_PACKAGES = ("python3-scipy", "python3-matplotlib")
CLUSTER_PACKAGES = ("python3-distributed",)   # optional: studies on other machines
OPTUNA_PACKAGES = ("python3-optuna",)   # optional: another way to look for the best case
NETGEN_PACKAGES = ("python3-netgen",)
WINDOWS_PACKAGES = ("g++-mingw-w64-x86-64-posix",)
WINDOW_PACKAGES = ("freecad", "python3-pivy")
PACKAGING_PACKAGES = ("patchelf", "binutils", "debhelper", "dpkg-dev", "lintian", "fakeroot")
STYLE_OF_1_1_PACKAGES = ("qt6-svg-plugins",)   # FreeCAD 1.1 draws check marks and arrows by it, and Debian only recommends it
# What roots of other Debian releases have: those for the tests, and those that are as FreeCAD's users have them.
FOR_TESTS = BUILD_PACKAGES + RUN_PACKAGES + PICTURE_PACKAGES + PEER_PACKAGES + READER_PACKAGES + STUDY_PACKAGES + SOLVER_PACKAGES \
    + STYLE_OF_1_1_PACKAGES
FOR_USERS = ("freecad", "freecad-python3", "python3-numpy", "python3-pip", "xvfb", "xauth", "libgl1-mesa-dri", "unzip")
# Not in Debian 13 (CalculiX), of Debian 12 only (clang-format) or not in Debian 12 (Qt 6's plugin); what needs them is skipped where the program is not there otherwise.
NOT_EVERYWHERE = ("calculix-ccx", "clang-format-14", *STYLE_OF_1_1_PACKAGES)

REASONS = (
    (BUILD_PACKAGES, "to build the engine"),
    (RUN_PACKAGES, "to run in FreeCAD, to solve with CalculiX and to mesh parts of needles with TetGen"),
    (PICTURE_PACKAGES, "to draw the pictures of reports"),
    (PEER_PACKAGES, "to compare with another mesher"),
    (READER_PACKAGES, "to read exported files back in tests"),
    (STYLE_PACKAGES, "to check how the code is written"),
    (TIDY_PACKAGES, "to look for faults in the code"),
    (SANITIZER_PACKAGES, "to run the engine's tests with sanitizers"),
    (SOLVER_PACKAGES, "to solve with PETSc"),
    (STUDY_PACKAGES, "to sample the cases of studies and to draw what they found"),
    (CLUSTER_PACKAGES, "to run studies on a Dask cluster"),
    (OPTUNA_PACKAGES, "to optimise by Optuna"),
    (NETGEN_PACKAGES, "to measure Netgen, too"),
    (WINDOWS_PACKAGES, "to see that parts of the engine compile for Windows"),
    (PACKAGING_PACKAGES, "to make packages"),
    (STYLE_OF_1_1_PACKAGES, "to see FreeCAD's window as its users do"),
    (WINDOW_PACKAGES, "to open FreeCAD's window"),
)


def missing(packages):
    """Those of the packages that are not installed, in their order."""
    if not shutil.which("dpkg-query"):
        raise Failure("this is not Debian (no dpkg-query), so packages cannot be installed here")
    shown = subprocess.run(["dpkg-query", "-W", "-f=${Package} ${db:Status-Status}\n", *packages],
                           stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
    installed = {line.split()[0] for line in shown.splitlines() if line.endswith(" installed")}
    return [name for name in packages if name not in installed]


def records_of(packages):
    """Files that are written anew with each of the packages that is installed or upgraded, and go with it."""
    lists = [name for name in os.listdir(RECORDS) if name.endswith(".list")] if os.path.isdir(RECORDS) else []
    return [Path(RECORDS, name) for name in sorted(lists) if name.removesuffix(".list").partition(":")[0] in packages]


def install_missing(packages):
    """Installs what is missing, as root or through sudo, after saying what and why."""
    if missing(packages):
        with alone():
            names = missing(packages)
            if names:
                install(names)


@contextlib.contextmanager
def alone():
    """apt-get refuses to work beside another one, so this waits until no other set-up of the checkout installs."""
    BUILD.mkdir(exist_ok=True)
    with open(BUILD / "apt.lock", "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def install(names):
    for group, reason in REASONS:
        of_group = [name for name in names if name in group]
        if of_group:
            say(f"installing with apt-get {reason}: {' '.join(of_group)}")
    prefix = root_prefix(names)
    environment = ["env", "DEBIAN_FRONTEND=noninteractive"]
    if unknown_to_apt(names):
        run_logged([*prefix, "apt-get", "-q", "update"], "apt-get update")
        absent = [name for name in unknown_to_apt(names) if name in NOT_EVERYWHERE]
        if absent:
            say(f"this Debian has no {' '.join(absent)}; what needs it is skipped where it is not there otherwise")
            names = [name for name in names if name not in absent]
    if not names:
        return
    command = [*prefix, *environment, "apt-get", "-q", "-y", "install", "--no-install-recommends"]
    try:
        run_logged([*command, *names], "installing packages")
    except Failure:
        # Lists that are older than the mirror name versions that are gone.
        run_logged([*prefix, "apt-get", "-q", "update"], "apt-get update")
        run_logged([*command, *names], "installing packages")


def root_prefix(names):
    if os.geteuid() == 0:
        return []
    if shutil.which("sudo"):
        say("this needs root: sudo may ask for your password")
        return ["sudo"]
    raise Failure("these packages are missing: " + " ".join(names) + "; run this as root, or install sudo")


def unknown_to_apt(names):
    """Those of the packages that apt cannot install from the lists it has."""
    shown = subprocess.run(["apt-cache", "policy", *names], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                           env={**os.environ, "LC_ALL": "C.UTF-8"}).stdout
    known, name = set(), None
    for line in shown.splitlines():
        if line and not line[0].isspace():
            name = line.rstrip(":")
        elif line.strip().startswith("Candidate:") and "(none)" not in line:
            known.add(name)
    return [name for name in names if name not in known]

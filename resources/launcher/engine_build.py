# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the engine, and nothing at all when no source changed since the last build."""
import contextlib
import fcntl
import hashlib
import json
import os
from pathlib import Path

import cgal_headers
import packages
from layout import BUILD, CGAL, RELEASE, ROOT, SETUP_LOG
from setup_log import run_logged, say

SOURCE_FOLDERS = ("src", "bindings", "tests/cpp", "tests/python", "tests/benchmarks", "resources/launcher")
SOURCE_FILES = ("CMakeLists.txt", "CMakePresets.json", "tests/CMakeLists.txt")
# What can be built, each with all of those before.
ENGINE, IN_FREECAD, ALL = TARGETS = ("featuremesh_engine", "featuremesh_tests_in_freecad", "all")
WHAT = {ENGINE: "the engine", IN_FREECAD: "the engine and what its tests in FreeCAD need", ALL: "the engine and the tests"}
PYTHON = "/usr/bin/python3"
MEMORY_PER_PROCESS = 2 << 30


def set_up(extra_packages=(), target=ENGINE):
    """Installs, fetches and builds what is missing."""
    wanted = {*packages.BUILD_PACKAGES, *packages.RUN_PACKAGES, *extra_packages}
    known, built = what_is_there()
    if wanted <= known and target in built:
        return
    BUILD.mkdir(exist_ok=True)
    with alone():
        if not RELEASE.exists():
            SETUP_LOG.unlink(missing_ok=True)
            say(f"setting up, which takes some minutes the first time (log: {SETUP_LOG})")
        packages.install_missing(sorted(wanted))
        cgal_headers.fetch_cgal()
    with alone(RELEASE):
        target = max((target, *built), key=TARGETS.index)
        # Taken before the build, so that a source that changes meanwhile is built the next time.
        stamp = {"fingerprint": fingerprint(wanted | known), "packages": sorted(wanted | known), "target": target}
        build(target)
        stamp_file().write_text(json.dumps(stamp), encoding="utf-8")


def stamp_file():
    return RELEASE / "setup-stamp.json"


def what_is_there():
    """The packages that were seen to be there, and the targets that were built, if nothing has changed since."""
    try:
        stamp = json.loads(stamp_file().read_text(encoding="utf-8"))
    except (FileNotFoundError, json.JSONDecodeError):
        return set(), ()
    if stamp["fingerprint"] != fingerprint(stamp["packages"]) or stamp.get("target") not in TARGETS:
        return set(), ()
    return set(stamp["packages"]), TARGETS[:TARGETS.index(stamp["target"]) + 1]


@contextlib.contextmanager
def alone(folder=BUILD):
    """Only one set-up at a time installs, and one builds in a folder; others wait for it."""
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / "setup.lock", "w", encoding="utf-8") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            say("waiting for another set-up in this folder")
            fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def build(target):
    say(f"building {WHAT[target]}")
    run_logged(["cmake", "--preset", "release", "-B", RELEASE, f"-DPython_EXECUTABLE={PYTHON}", f"-DPython3_EXECUTABLE={PYTHON}",
                f"-DPYTHON_EXECUTABLE={PYTHON}", f"-DFEATUREMESH_CGAL_DIR={CGAL / 'usr'}"], "configuring the build", cwd=ROOT)
    run_logged(["cmake", "--build", RELEASE, "-j", str(processes_at_once()), "--target", target], "building", cwd=ROOT,
               start_new_session=True)


def processes_at_once():
    """Compilers or tests: one per processor, fewer where memory is short. CGAL's templates need up to 2 GB each, a test with its FreeCADs about as much."""
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    return max(1, min(len(os.sched_getaffinity(0)), memory // MEMORY_PER_PROCESS))


def fingerprint(names):
    """Changes when a source, one of these packages or of those that the engine is built with, or CGAL's headers do."""
    digest = hashlib.sha256()
    names = {*names, *packages.BUILD_PACKAGES, *packages.SOLVER_PACKAGES}
    for path in [*source_files(), *packages.records_of(names), CGAL / "usr/include/CGAL/version.h"]:
        try:
            status = path.stat()
            digest.update(f"{path} {status.st_size} {status.st_mtime_ns}\n".encode())
        except FileNotFoundError:
            digest.update(f"{path} none\n".encode())
    return digest.hexdigest()


def source_files():
    files = [ROOT / name for name in SOURCE_FILES]
    for folder in SOURCE_FOLDERS:
        for where, folders, names in os.walk(ROOT / folder):
            folders[:] = sorted(name for name in folders if name != "__pycache__")
            files += [Path(where) / name for name in sorted(names)]
    return files

# SPDX-License-Identifier: GPL-3.0-or-later
"""clang-tidy on what changed, with the checks of .clang-tidy, in a build that is configured but not built."""
import os
import subprocess
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import cgal_headers
import packages
from engine_build import alone, processes_at_once
from layout import BUILD, CGAL, ROOT, Failure, Unavailable
from setup_log import run_logged, say

CLANG_TIDY = "clang-tidy-16"   # 14 does not know all of C++20
FOLDERS = ("src", "bindings")


def run(since, seconds=None):
    """Looks at every source file that changed since the commit `since`, or whose header did; raises Failure when there is something to mend.

    Of more files than it can look at in `seconds` it looks at those that changed last, and says at how many.
    """
    ends = float("inf") if seconds is None else time.monotonic() + seconds
    files = sources_to_look_at(changed_since(since))
    folder = BUILD / "dev"
    with alone():
        packages.install_missing(packages.BUILD_PACKAGES + packages.TIDY_PACKAGES)
        cgal_headers.fetch_cgal()
    with alone(folder):
        run_logged(["cmake", "--preset", "dev", "-B", folder, f"-DFEATUREMESH_CGAL_DIR={CGAL / 'usr'}", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"],
                   "configuring the build", cwd=ROOT)
    say(f"looking at {len(files)} of {len(all_sources())} source files with {CLANG_TIDY}")
    with ThreadPoolExecutor(processes_at_once()) as pool:
        found = list(pool.map(lambda file: complaints_about(file, folder, ends), files))
    if None in found:
        say(f"its time is over after {len(found) - found.count(None)} of {len(files)} files, those that changed last")
    complaints = [text for text in found if text]
    if complaints:
        print("\n".join(complaints))
        raise Failure(f"{CLANG_TIDY} found something in {len(complaints)} files (see above)")
    say(f"{CLANG_TIDY} finds nothing to mend there")
    return 0


def changed_since(commit):
    """What changed last comes first."""
    done = [subprocess.run(["git", "-C", str(ROOT), *words, "--"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            for words in (["diff", "--name-only", "HEAD"], ["log", "--format=", "--name-only", f"{commit}..HEAD"])]
    if done[1].returncode:
        raise Unavailable(f"--tidy {commit}: git knows no such commit here; give another one")
    return list(dict.fromkeys(Path(name) for answer in done for name in answer.stdout.splitlines()))


def all_sources():
    return sorted(path.relative_to(ROOT) for folder in FOLDERS for path in (ROOT / folder).rglob("*.cpp"))


def sources_to_look_at(changed):
    """In the order of `changed`. A header is looked at from the source file of its name."""
    there = set(all_sources())
    return list(dict.fromkeys(path.with_suffix(".cpp") for path in changed if path.suffix in (".cpp", ".h") and path.with_suffix(".cpp") in there))


def complaints_about(file, folder, ends):
    """What it says when it finds something or cannot read the file; nothing otherwise; None where time.monotonic() came to `ends` before that."""
    seconds_left = ends - time.monotonic()
    try:
        done = subprocess.run([CLANG_TIDY, "-p", str(folder), "--quiet", str(file)], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True, errors="replace", env={**os.environ, "LC_ALL": "C.UTF-8"},
                              timeout=None if seconds_left == float("inf") else max(0, seconds_left))
    except subprocess.TimeoutExpired:
        return None
    return (done.stdout or done.stderr) if done.returncode else ""

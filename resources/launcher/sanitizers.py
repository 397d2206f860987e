# SPDX-License-Identifier: GPL-3.0-or-later
"""The tests of the engine's modules under a sanitizer, in a build of its own without the Python module."""
import os
import subprocess

import cgal_headers
import packages
from engine_build import alone, processes_at_once
from layout import BUILD, CGAL, ROOT, Failure
from setup_log import run_logged, say

# asan also finds undefined behaviour. Both are for Clang, which takes three fifths of GCC's time, and without ccache: Clang refuses a precompiled header when a
# file that it was made of has another time.
PRESET_OF = {"address": "asan", "thread": "tsan"}
# The kernel keeps what it allocated once to the end, so what is left then says nothing of us. Debian's libraries are built without the
# thread sanitizer; what works on a copy of the process (core/isolated_run.h) starts a thread there.
SYMBOLIZER = "external_symbolizer_path=/usr/bin/llvm-symbolizer-16"   # functions and lines in what it finds
OPTIONS = {"ASAN_OPTIONS": f"detect_leaks=0:detect_stack_use_after_return=1:{SYMBOLIZER}", "UBSAN_OPTIONS": f"print_stacktrace=1:{SYMBOLIZER}",
           "TSAN_OPTIONS": f"ignore_noninstrumented_modules=1:halt_on_error=1:die_after_fork=0:{SYMBOLIZER}"}
SECONDS_AT_MOST = 3600   # for one module: ten times what the slowest takes on two processors, for they may run in what other tests leave of these


def run(kind, only=None):
    """Builds and runs; raises Failure when a test fails or the sanitizer finds something."""
    folder = BUILD / PRESET_OF[kind]
    with alone():
        packages.install_missing(packages.BUILD_PACKAGES + packages.SANITIZER_PACKAGES)
        cgal_headers.fetch_cgal()
    with alone(folder):
        say(f"building the engine's tests with the {kind} sanitizer")
        run_logged(["cmake", "--preset", PRESET_OF[kind], "-B", folder, f"-DFEATUREMESH_CGAL_DIR={CGAL / 'usr'}"], "configuring the build", cwd=ROOT)
        run_logged(["cmake", "--build", folder, "-j", str(processes_at_once())], "building", cwd=ROOT)
    say(f"running them with the {kind} sanitizer")
    code = subprocess.run(["ctest", "--test-dir", str(folder), "-j", str(processes_at_once()), "--output-on-failure", "--no-tests=error", "--timeout", str(SECONDS_AT_MOST),
                           *(["-R", only] if only else [])], env={**os.environ, **OPTIONS}).returncode
    if code:
        raise Failure(f"the tests failed with the {kind} sanitizer (see above)")
    return 0

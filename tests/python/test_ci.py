# SPDX-License-Identifier: GPL-3.0-or-later
"""What .ci/run makes of the runs it starts, with a stand-in for ./featuremesh."""
import os
import re
import shutil
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

RUN = Path(__file__).resolve().parents[2] / ".ci" / "run"
# Ends with the first number when this machine's FreeCAD is tested, with the second in the root of 1.1, with the third for packages, with the fourth in the
# root of 1.0, with the fifth for the sanitizers, with the sixth for clang-tidy; "slow" takes longer than any limit.
STAND_IN = """#!/usr/bin/env bash
case "$*" in
    "test") exit %s ;;
    "test --freecad 1.1 --in-freecad") [ %s = slow ] && exec sleep 60; exit %s ;;
    "test --packages --freecad 0.20") exit %s ;;
    "test --freecad 1.0 --in-freecad --only ^python_("*")$") exit %s ;;
    "test --sanitize address") echo said by the sanitizers; exit %s ;;
    "test --tidy "*" --seconds "*) echo looks since "$3"; echo its time is over after 2 of 7 files; exit %s ;;
    *) exit 99 ;;
esac
"""


class Decisions(unittest.TestCase):
    def run_with(self, here, in_root, packages=0, few=0, sanitizers=0, tidy=0, **variables):
        """(exit code, what was said)."""
        with tempfile.TemporaryDirectory() as folder:
            os.mkdir(os.path.join(folder, ".ci"))
            shutil.copy(RUN, os.path.join(folder, ".ci"))
            launcher = Path(folder, "featuremesh")
            launcher.write_text(STAND_IN % (here, in_root, in_root, packages, few, sanitizers, tidy), encoding="utf-8")
            launcher.chmod(0o755)
            done = subprocess.run([os.path.join(folder, ".ci", "run")], env={**os.environ, **variables}, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True)
        return done.returncode, done.stdout

    def test_all_pass(self):
        code, said = self.run_with(0, 0)
        self.assertEqual(code, 0)
        self.assertIn("FreeCAD 1.1 passes", said)
        self.assertIn("FreeCAD 1.0 passes", said)
        self.assertIn("the engine with sanitizers passes", said)
        self.assertNotIn("said by the sanitizers", said)
        self.assertIn("clang-tidy passes\nits time is over after 2 of 7 files\n", said)
        self.assertNotIn("looks since", said)
        self.assertIn("installing the packages passes", said)
        self.assertEqual(said.splitlines()[-1], ".ci/run: after 0 minutes: came to their end: this machine's FreeCAD (0), FreeCAD 1.1 (0), "
                         "FreeCAD 1.0 (0), installing the packages (0), the engine with sanitizers (0), clang-tidy (0); did not: nothing")

    def test_a_failure_of_any_is_one(self):
        code, said = self.run_with(1, 0)
        self.assertEqual((code, said), (1, ".ci/run: after 0 minutes: this machine's FreeCAD fails\n"
                                        ".ci/run: after 0 minutes: came to their end: this machine's FreeCAD (0, fails); did not: nothing\n"))
        code, said = self.run_with(0, 1)
        self.assertEqual(code, 1)
        self.assertIn("FreeCAD 1.1 fails", said)
        self.assertIn("FreeCAD 1.1 (0, fails); did not", said)
        self.assertNotIn("FreeCAD 1.0", said)
        code, said = self.run_with(0, 0, 1)
        self.assertEqual(code, 1)
        self.assertIn("installing the packages fails", said)
        code, said = self.run_with(0, 0, 0, 1)
        self.assertEqual(code, 1)
        self.assertIn("FreeCAD 1.0 fails", said)
        code, said = self.run_with(0, 0, sanitizers=1)
        self.assertEqual(code, 1)
        self.assertIn("the engine with sanitizers fails\nsaid by the sanitizers", said)
        code, said = self.run_with(0, 0, tidy=1)
        self.assertEqual(code, 1)
        self.assertIn("clang-tidy fails\nlooks since HEAD", said)

    def test_the_few_tests_are_there(self):
        wanted = re.search(r"^few='\^python_\((.*)\)\$'$", RUN.read_text(encoding="utf-8"), re.MULTILINE).group(1).split("|")
        declared = (Path(__file__).parent / "CMakeLists.txt").read_text(encoding="utf-8")
        for name in wanted:
            self.assertRegex(declared, r"\b%s\b" % name)

    def test_where_there_can_be_no_root_it_is_skipped(self):
        code, said = self.run_with(0, 3)
        self.assertEqual(code, 0)
        self.assertIn("FreeCAD 1.1 is skipped, it cannot be had here", said)

    def test_without_time_it_is_skipped(self):
        code, said = self.run_with(0, 1, FEATUREMESH_CI_SECONDS="1140")
        self.assertEqual(code, 0)
        self.assertIn("FreeCAD 1.1 is skipped, since fewer than 20 of 19 minutes are left", said)
        self.assertIn("installing the packages passes", said)
        code, said = self.run_with(0, 0, 1, FEATUREMESH_CI_SECONDS="60", FEATUREMESH_CI_SECONDS_NEEDED="0")
        self.assertEqual(code, 0)
        self.assertIn("installing the packages is skipped, since fewer than 15 of 1 minutes are left", said)

    def test_when_its_time_is_over_it_ends(self):
        code, said = self.run_with(0, "slow", FEATUREMESH_CI_SECONDS="2", FEATUREMESH_CI_SECONDS_NEEDED="0")
        self.assertEqual(code, 0)
        self.assertIn("FreeCAD 1.1 is skipped, its time is over", said)
        self.assertTrue(said.endswith("did not: FreeCAD 1.1, installing the packages, FreeCAD 1.0\n"), said)

    def test_what_runs_beside_ends_with_it(self):
        with tempfile.NamedTemporaryFile("w+") as process:
            code, _ = self.run_with("$(sleep 1)1", 0, sanitizers="$(echo $$ >%s; sleep 60)" % process.name)
            self.assertEqual(code, 1)
            number = int(process.read())
        for _ in range(100):
            if not os.path.exists("/proc/%d" % number):
                return
            time.sleep(0.1)
        self.fail("it goes on")


if __name__ == "__main__":
    unittest.main()

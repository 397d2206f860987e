# SPDX-License-Identifier: GPL-3.0-or-later
"""A study on a Dask scheduler with two workers, one of which is killed while it runs. Runs in plain Python."""
import os
import re
import shutil
import signal
import subprocess
import unittest

from study_tests import StudyTest

MISSING = not (shutil.which("dask-scheduler") and shutil.which("dask-worker"))


@unittest.skipIf(MISSING, "python3-distributed is not installed")
class Dask(StudyTest):

    def setUp(self):
        super().setUp()
        self.scheduler = self.start_program("dask-scheduler", "--port", "0", "--no-dashboard", "--host", "127.0.0.1")
        for line in self.scheduler.stderr:
            found = re.search(r"tcp://127\.0\.0\.1:\d+", line)
            if found:
                break
        self.address = found.group()
        self.workers = [self.start_program("dask-worker", self.address, "--nthreads", "1", "--no-dashboard", "--no-nanny", "--local-directory",
                                           str(self.folder / ("dask%d" % number)), "--resources", "cores=2 GB=8") for number in range(2)]

    def start_program(self, *words):
        program = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, cwd=self.folder)
        self.addCleanup(program.communicate)
        self.addCleanup(program.kill)
        return program

    def done(self, folder):
        return (self.folder / folder / "study.sqlite").exists() and self.states(folder).count("done")

    def test_a_worker_is_killed_and_the_results_have_the_same_bits(self):
        self.response_file("time.sleep(0.5)", "return 1.0")
        self.study("run", "study.toml", "--folder", "here")
        process = self.start("run", "study.toml", "--folder", "there", "--scheduler", self.address)
        self.addCleanup(process.kill)
        self.wait_for(lambda: self.done("there"), "finished case")
        os.kill(self.workers[0].pid, signal.SIGKILL)
        out, err = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 0, out + err)
        self.assertEqual(self.states("there"), ["done"] * 4)
        self.assertEqual(self.results("there"), self.results("here"))

    def test_ctrl_c_ends_what_runs_there(self):
        self.response_file("time.sleep(3)", "return 1.0")
        process = self.start("run", "study.toml", "--folder", "there", "--scheduler", self.address, start_new_session=True)
        self.addCleanup(process.kill)
        self.wait_for(lambda: self.done("there"), "finished case")
        os.killpg(process.pid, signal.SIGINT)
        _, err = process.communicate(timeout=60)
        self.assertIn("go on with: featuremesh study resume there", err)
        self.assertNotIn("running", self.states("there"))
        self.assert_nothing_left_behind()
        self.study("resume", "there", "--scheduler", self.address)
        self.assertEqual(self.states("there"), ["done"] * 4)

    def test_no_scheduler(self):
        self.response_file("return 1.0")
        self.scheduler.kill()
        self.scheduler.wait()
        _, err = self.study("run", "study.toml", "--scheduler", self.address, code=2)
        self.assertIn("no Dask scheduler answers at " + self.address, err)


if __name__ == "__main__":
    unittest.main()

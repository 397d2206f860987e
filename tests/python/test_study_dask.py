# SPDX-License-Identifier: GPL-3.0-or-later
"""A study on a Dask scheduler with two workers, of which one is killed twice while it runs. Runs in plain Python."""
import importlib.util
import json
import os
import re
import shutil
import signal
import subprocess
import unittest
from pathlib import Path

from study_tests import StudyTest

JOBQUEUE = """
import json, os
from distributed import LocalCluster

class SLURMCluster(LocalCluster):
    def __init__(self, **asked):
        self._asked = asked
        resources = dict(pair.split("=") for pair in asked["worker_extra_args"][-1].split())
        super().__init__(n_workers=0, threads_per_worker=1, processes=True, dashboard_address=None,
                         resources={name: float(amount) for name, amount in resources.items()})

    def scale(self, jobs):
        if jobs:   # its end scales to none
            with open(os.environ["ASKED"], "w") as stream:
                json.dump({**self._asked, "jobs": jobs}, stream)
        super().scale(jobs)
"""
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
        self.workers = {number: self.start_worker(number) for number in range(2)}

    def start_worker(self, number):
        return self.start_program("dask-worker", self.address, "--nthreads", "1", "--no-dashboard", "--no-nanny", "--local-directory",
                                  str(self.folder / ("dask%d" % number)), "--resources", "cores=2 GB=8")

    def start_program(self, *words):
        program = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, cwd=self.folder)
        self.addCleanup(program.communicate)
        self.addCleanup(program.kill)
        return program

    def hold(self, held="True"):
        """Every case writes who runs it, and those that are `held` (an expression of `case`) wait for `let_go`."""
        return self.response_file("(HERE / ('case-%d.new' % case.id)).write_text(str(os.getppid()))",
                                  "os.replace(HERE / ('case-%d.new' % case.id), HERE / ('case-%d' % case.id))",
                                  "while %s and not (HERE / 'go').exists():" % held, "    time.sleep(0.02)", "return float(case.id)")

    def let_go(self):
        (self.folder / "go").touch()

    def freecad_of(self, case):
        """The id of the FreeCAD that runs it, None before."""
        path = self.folder / ("case-%d" % case)
        return int(path.read_text()) if path.exists() else None

    def kill_the_worker_of(self, case, seen):
        """Kills the Dask worker that runs the case in a FreeCAD that is not among those `seen`, and starts another in its place."""
        self.wait_for(lambda: self.freecad_of(case) not in (None, *seen), "case %d in another FreeCAD than %s" % (case, seen))
        seen.append(self.freecad_of(case))
        owner = int(Path("/proc/%d/stat" % seen[-1]).read_text(encoding="utf-8").rpartition(")")[2].split()[1])
        number, = [number for number, worker in self.workers.items() if worker.pid == owner]
        os.kill(owner, signal.SIGKILL)
        self.workers[number].wait()
        self.workers[number] = self.start_worker(number)

    def test_a_worker_is_killed_twice_and_the_results_have_the_same_bits_as_by_one_process_and_by_two(self):
        self.hold("case.id == 2")   # were others held, too, no worker might be left for its next start
        process = self.start("run", "study.toml", "--folder", "there", "--scheduler", self.address)
        self.addCleanup(process.kill)
        seen = []
        self.wait_for(lambda: self.freecad_of(1) and self.freecad_of(2), "two cases at once")
        for _ in range(2):
            self.kill_the_worker_of(2, seen)
        self.wait_for(lambda: self.freecad_of(2) not in seen, "third start of case 2")
        self.let_go()
        out, err = process.communicate(timeout=600)
        self.assertEqual(process.returncode, 0, out + err)
        self.assertEqual(self.states("there"), ["done"] * 4)
        for jobs in (1, 2):
            self.study("run", "study.toml", "--folder", "here%d" % jobs, "--jobs", jobs)
            self.assertEqual(self.results("there"), self.results("here%d" % jobs))

    def test_ctrl_c_ends_what_runs_there(self):
        self.hold()
        process = self.start("run", "study.toml", "--folder", "there", "--scheduler", self.address, start_new_session=True)
        self.addCleanup(process.kill)
        self.wait_for(lambda: self.freecad_of(1) and self.freecad_of(2), "two cases at once")
        os.killpg(process.pid, signal.SIGINT)
        _, err = process.communicate(timeout=600)
        self.assertIn("go on with: featuremesh study resume there", err)
        self.assertEqual(self.states("there"), ["waiting"] * 4)
        self.assert_nothing_left_behind()
        self.let_go()
        self.study("resume", "there", "--scheduler", self.address)
        self.assertEqual(self.states("there"), ["done"] * 4)

    def test_slurm_jobs(self):
        """A stand-in for dask-jobqueue, whose Slurm jobs are processes here; what it is asked for is what a case needs."""
        (self.folder / "dask_jobqueue.py").write_text(JOBQUEUE, encoding="utf-8")
        (self.folder / "sbatch").touch(0o755)
        self.environment.update(PATH="%s:%s" % (self.folder, os.environ["PATH"]), PYTHONPATH=str(self.folder), ASKED=str(self.folder / "asked.json"))
        self.response_file("return float(case.id)")
        self.study("run", "study.toml", "--folder", "there", "--slurm", 2)
        self.assertEqual(self.states("there"), ["done"] * 4)
        asked = json.loads((self.folder / "asked.json").read_text(encoding="utf-8"))
        self.assertEqual((asked["cores"], asked["processes"], asked["jobs"]), (1, 1, 2))
        self.assertRegex(asked["memory"], r"^0\.\d\dGB$")
        self.assertIn("cores=1 GB=" + asked["memory"][:-2], asked["worker_extra_args"])
        self.assert_nothing_left_behind()
        self.study("run", "study.toml", "--folder", "here")
        self.assertEqual(self.results("there"), self.results("here"))

    def test_slurm_without_dask_jobqueue(self):
        if importlib.util.find_spec("dask_jobqueue"):
            self.skipTest("dask-jobqueue is installed")
        self.response_file("return 1.0")
        self.assertIn("--slurm needs dask-jobqueue", self.study("run", "study.toml", "--slurm", 2, code=2)[1])

    def test_slurm_is_looked_for_before_the_base_is_made(self):
        (self.folder / "dask_jobqueue.py").write_text(JOBQUEUE, encoding="utf-8")
        self.environment.update(PYTHONPATH=str(self.folder), FREECADCMD="/no/freecad")
        self.response_file("return 1.0")
        self.assertIn("--slurm needs Slurm's program sbatch", self.study("run", "study.toml", "--slurm", 2, code=2)[1])
        self.assertFalse((self.folder / "study-study").exists())

    def test_no_scheduler(self):
        self.response_file("return 1.0")
        self.scheduler.kill()
        self.scheduler.wait()
        self.environment["FREECADCMD"] = "/no/freecad"   # it is said before the base is made
        _, err = self.study("run", "study.toml", "--scheduler", self.address, code=2)
        self.assertIn("no Dask scheduler answers at " + self.address, err)
        self.assertFalse((self.folder / "study-study").exists())


if __name__ == "__main__":
    unittest.main()

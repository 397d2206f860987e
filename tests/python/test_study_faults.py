# SPDX-License-Identifier: GPL-3.0-or-later
"""What goes wrong while a study runs: nothing that was finished is lost, no process stays, and `resume` goes on. Runs in plain Python."""
import os
import resource
import shutil
import signal
import subprocess
import unittest
from pathlib import Path

from study_tests import LAUNCHER, StudyTest

LONGEST_FILE = 30_000_000   # bytes, on the disk that is full: the base document fits


@unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
class Faults(StudyTest):
    undisturbed = {}   # {text of study.toml: results}

    def started(self, *words, **options):
        """A study of four cases of which the first is done, and the second is held in its middle until `let_go`."""
        self.response_file("(HERE / ('case-%d' % case.id)).touch()", "while case.id > 1 and not (HERE / 'go').exists():", "    time.sleep(0.02)", "return 1.0")
        process = self.start("run", "study.toml", "--jobs", "1", *words, **options)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        self.wait_for((self.folder / "case-2").exists, "second case")
        self.assertEqual(self.states(), ["done", "running", "waiting", "waiting"])
        return process

    def let_go(self):
        (self.folder / "go").touch()

    def workers(self):
        """Ids of the FreeCADs that stay open, not of their copies."""
        processes = self.processes()
        return [number for number in processes if Path("/proc/%d/stat" % number).read_text(encoding="utf-8").rpartition(")")[2].split()[1]
                not in map(str, processes) and "freecad" in processes[number].lower()]

    def assert_resumed(self, *words):
        """The study goes on and is then as one that was never disturbed."""
        self.let_go()
        before = {key: value for key, value in self.results().items() if value}
        self.study("resume", "study-study", *words)
        self.assertEqual(self.states(), ["done"] * 4)
        self.assertEqual(self.results(), self.results_undisturbed())
        self.assertLessEqual(before.items(), self.results().items())
        self.assert_nothing_left_behind()

    def results_undisturbed(self):
        """Those of the study in study.toml, which is run once for all tests: each of them returns 1 as its own response."""
        text = (self.folder / "study.toml").read_text(encoding="utf-8")
        if text not in self.undisturbed:
            self.study("run", "study.toml", "--folder", "undisturbed")
            self.undisturbed[text] = self.results("undisturbed")
        return self.undisturbed[text]

    def test_the_runner_is_killed(self):
        process = self.started()
        process.send_signal(signal.SIGKILL)
        process.wait()
        self.assert_nothing_left_behind()
        self.assertEqual(self.states(), ["done", "running", "waiting", "waiting"])
        self.assert_resumed()
        self.assertEqual({row["attempts"] for row in self.rows()}, {1})

    def test_the_runner_is_killed_while_it_makes_the_base(self):
        self.response_file("return 1.0")
        process = self.start("run", "study.toml")
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        self.wait_for(self.processes, "FreeCAD")
        process.send_signal(signal.SIGKILL)
        process.wait()
        self.assert_nothing_left_behind()
        self.assertIn("holds no study", self.study("resume", "study-study", code=2)[1])
        self.study("run", "study.toml")
        self.assertEqual(self.states(), ["done"] * 4)

    def test_ctrl_c_says_how_to_go_on(self):
        process = self.started(start_new_session=True)
        os.killpg(process.pid, signal.SIGINT)
        _, err = process.communicate(timeout=300)
        self.assertEqual(process.returncode, 1)
        self.assertRegex(err, r"stopped: 1 of 4 cases are done and kept; go on with: featuremesh study resume study-study")
        self.assertNotIn("Traceback", err)
        self.assert_nothing_left_behind()
        self.assertNotIn("running", self.states())
        self.assert_resumed()

    def test_a_worker_is_killed_which_costs_a_retry(self):
        process = self.started()
        worker, = self.workers()
        os.kill(worker, signal.SIGKILL)
        self.let_go()
        process.communicate(timeout=300)
        self.assertEqual(process.returncode, 0)
        self.assertEqual([row["attempts"] for row in self.rows()], [1, 2, 1, 1])
        self.assert_resumed()

    def start_workers_by(self, line):
        """A line of a shell that runs whenever a worker is started, before FreeCAD."""
        program = self.folder / "freecadcmd"
        program.write_text("#!/bin/sh\ncase $1 in *worker_main*) %s;; esac\nexec %s \"$@\"\n" % (line, shutil.which("freecadcmd")), encoding="utf-8")
        program.chmod(0o755)
        self.environment["FREECADCMD"] = str(program)
        self.response_file("return 1.0")

    def test_a_worker_is_killed_while_it_starts(self):
        """Nothing was begun, so nothing is tried again."""
        flag = self.folder / "was-killed"
        self.start_workers_by("[ -e %s ] || { touch %s; kill -9 $$; }" % (flag, flag))
        self.study("run", "study.toml", "--jobs", "1")
        self.assertTrue(flag.exists())
        self.assertEqual([row["attempts"] for row in self.rows()], [1] * 4)
        self.assert_nothing_left_behind()

    def test_a_worker_that_never_starts(self):
        self.start_workers_by("exit 3")
        self.assertIn("a worker cannot start: FreeCAD ended", self.study("run", "study.toml", code=1)[1])
        self.assertEqual(self.states(), ["waiting"] * 4)
        self.assert_nothing_left_behind()

    def test_a_case_that_is_killed_each_time_fails_and_the_others_do_not(self):
        self.response_file("os.kill(os.getpid(), 9) if case.id == 2 else None", "return 1.0")
        out, err = self.study("run", "study.toml", code=1)
        self.assertIn("3 of 4 cases done, 1 failed", out)
        self.assertIn("case 2: it was ended 2 times", err)

    def test_calculix_is_killed(self):
        """A program in CalculiX's place that is ended the first time that it is to solve, and CalculiX then. FreeCAD starts it without a model to see that it is there."""
        program, flag = self.folder / "bin" / "ccx", self.folder / "was-killed"
        program.parent.mkdir()
        program.write_text("#!/bin/sh\n[ \"$1\" != -i ] || [ -e %s ] || { touch %s; kill -9 $$; }\nexec %s \"$@\"\n" % (flag, flag, shutil.which("ccx")), encoding="utf-8")
        program.chmod(0o755)
        self.environment["PATH"] = "%s:%s" % (program.parent, os.environ["PATH"])
        self.toml('responses = ["max_mises"]', 'solver = "ccx"')
        self.study("run", "study.toml", "--jobs", "1")
        self.assertEqual(sorted(row["attempts"] for row in self.rows()), [1, 1, 1, 2])
        self.assertTrue(flag.exists())
        self.assert_resumed()

    def test_calculix_that_never_ends_goes_with_its_case(self):
        program = self.folder / "bin" / "ccx"
        program.parent.mkdir()
        program.write_text("#!/bin/sh\ntouch %s\nsleep 1000 &\nsleep 1000\n" % (self.folder / "began"), encoding="utf-8")
        program.chmod(0o755)
        self.environment["PATH"] = "%s:%s" % (program.parent, os.environ["PATH"])
        out, err = self.study("run", "part.FCStd", "--vary", "Plate.Length=9,10", "--sampling", "grid", "--solver", "ccx", "--responses", "max_mises",
                              "--time-limit", "20", "--folder", "study-study", code=1)
        self.assertIn("2 failed", out)
        self.assertTrue((self.folder / "began").exists())
        self.assertIn("case 1: it took longer than the limit of 20 s; try `study resume --retry-failed` with a longer --time-limit", err)
        self.assert_nothing_left_behind()
        program.unlink()
        self.study("resume", "study-study", "--retry-failed", "--time-limit", "600")
        self.assertEqual(self.states(), ["done", "done"])

    def test_a_case_that_crashes_or_ends_freecad(self):
        self.response_file("os.kill(os.getpid(), 11) if case.id == 1 else os._exit(7) if case.id == 2 else None", "return 1.0")
        _, err = self.study("run", "study.toml", code=1)
        self.assertEqual(self.states(), ["failed", "failed", "done", "done"])
        self.assertRegex(err, r"case 1: FreeCAD (crashed \(SIGSEGV\)|ended with exit code)")
        self.assertIn("case 2: FreeCAD ended with exit code 7", err)
        self.assertEqual([row["attempts"] for row in self.rows()], [1, 1, 1, 1])

    def test_a_case_that_takes_all_memory(self):
        self.response_file("hog = b'x' * (3 << 30) if case.id == 1 else b''", "time.sleep(2)", "return len(hog)")
        text = (self.folder / "study.toml").read_text(encoding="utf-8")
        (self.folder / "study.toml").write_text(text + "[limits]\nmemory_gb = 2\n", encoding="utf-8")
        _, err = self.study("run", "study.toml", code=1)
        self.assertEqual(self.states(), ["failed", "done", "done", "done"])
        self.assertIn("case 1: it took more memory than the limit of 2 GB", err)

    def test_the_folder_of_a_case_is_removed_while_it_runs(self):
        self.response_file("folder = HERE / 'study-study' / 'cases' / ('%04d' % case.id)", "__import__('shutil').rmtree(folder) if case.id > 1 else None",
                           "return float((folder / 'freecad.log').stat().st_size > 0) if case.id < 3 else 1.0")
        _, err = self.study("run", "study.toml", "--jobs", "1", code=1)
        self.assertEqual(self.states(), ["done", "failed", "done", "done"])
        self.assertRegex(err, "case 2: .*No such file or directory")

    def test_two_runners_on_one_folder(self):
        process = self.started()
        _, err = self.study("resume", "study-study", code=2)
        self.assertRegex(err, r"is being run already, by process %d\n" % process.pid)
        self.let_go()
        process.communicate(timeout=300)
        self.assertEqual(self.states(), ["done"] * 4)

    def test_the_document_is_changed(self):
        before = self.part.read_bytes()
        process = self.started()
        self.part.write_bytes(before + b"\0")
        _, err = process.communicate(timeout=300)
        self.assertEqual(process.returncode, 1)
        self.assertRegex(err, "part.FCStd was changed since the study began")
        self.assertEqual(self.states(), ["done", "waiting", "waiting", "waiting"])
        self.let_go()
        self.assertIn("was changed", self.study("resume", "study-study", code=1)[1])
        self.study("resume", "study-study", "--keep-base")
        self.part.write_bytes(before)
        self.assert_resumed()

    def test_the_disk_is_full(self):
        """No file may get longer than a size that all but one file keep to."""
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (LONGEST_FILE, LONGEST_FILE))

        self.response_file("Path('big').write_bytes(bytes(%d)) if case.id > 1 else None" % (LONGEST_FILE + 1), "return 1.0")
        _, err = self.study("run", "study.toml", "--jobs", "1", code=1, preexec_fn=limit)
        self.assertRegex(err, "the disk of .* is full .*every finished case is safe. Make room, then go on with `study resume`")
        self.assertEqual(self.states()[0], "done")
        self.assert_nothing_left_behind()
        self.assertEqual(self.states(), ["done", "waiting", "waiting", "waiting"])
        self.response_file("return 1.0")
        self.assert_resumed()

    def test_a_real_disk_is_full(self):
        """A disk of its own, mounted for these commands alone; the first case leaves `room` on it, for the database or for CalculiX too little."""
        unshare = ["unshare", "-m"] if os.geteuid() == 0 else ["unshare", "-U", "-r", "-m"]
        (self.folder / "disk").mkdir()
        mount = "mount -t tmpfs -o size=64m disk %s/disk" % self.folder
        if not shutil.which("unshare") or subprocess.run([*unshare, "sh", "-c", mount], stderr=subprocess.DEVNULL).returncode:
            self.skipTest("no disk can be mounted here")
        self.response_file("DISK, room = HERE / 'disk', int((HERE / 'room').read_text())", "free = os.statvfs(DISK).f_bavail * os.statvfs(DISK).f_frsize",
                           "(DISK / 'big').write_bytes(bytes(free - room)) if case.id == 1 and room else None", "return 1.0")
        text = (self.folder / "study.toml").read_text(encoding="utf-8")
        (self.folder / "study.toml").write_text(text.replace('"volume"', '"max_mises"').replace("responses", 'solver = "ccx"\nresponses', 1), encoding="utf-8")
        for room in (8_000, 120_000):
            with self.subTest(room=room):
                (self.folder / "room").write_text(str(room), encoding="utf-8")
                run, go_on = "%s study run study.toml --jobs 1 --folder disk/s" % LAUNCHER, "%s study resume disk/s" % LAUNCHER
                script = "%s; ! %s; %s study status disk/s; rm disk/big; echo 0 >room; %s; cp -r disk/s full-%d" % (mount, run, LAUNCHER, go_on, room)
                done = subprocess.run([*unshare, "sh", "-exc", script], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=600)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                self.assertRegex(done.stderr, "featuremesh study: .*every finished case is safe. Make room, then go on with `study resume`")
                self.assertNotIn("Traceback", done.stderr)
                self.assertIn(" 0 failed", done.stdout)
                self.assertIn("4 of 4 cases done", done.stdout)
        self.study("run", "study.toml", "--folder", "undisturbed")
        for room in (8_000, 120_000):
            self.assertEqual(self.results("full-%d" % room), self.results("undisturbed"))


if __name__ == "__main__":
    unittest.main()

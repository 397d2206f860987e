# SPDX-License-Identifier: GPL-3.0-or-later
"""Whatever of a study is killed, at any moment: nothing that was finished is lost, no process stays, and `resume` goes on. Runs in plain Python.

FEATUREMESH_KILLS is the number of kills, 5 by default, one of each kind; FEATUREMESH_SEED chooses other moments.
"""
import os
import random
import shutil
import signal
import sqlite3
import time
import unittest
from pathlib import Path

from study_tests import StudyTest

KILLS = int(os.environ.get("FEATUREMESH_KILLS") or 5)
SEED = int(os.environ.get("FEATUREMESH_SEED") or time.time_ns() % 1_000_000)
VICTIMS = ("runner", "base", "worker", "case", "calculix")
LINGER = 0.3   # s at most between the sight of a victim and its end


def parent_of(number):
    return int(Path("/proc/%d/stat" % number).read_text(encoding="utf-8", errors="replace").rpartition(")")[2].split()[1])


@unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
class Kills(StudyTest):

    def victims(self, kind, runner):
        """Ids of the processes of that kind that there are now: the runner, the FreeCAD that makes the base, those that stay open, their copies, CalculiX."""
        if kind == "runner":
            return [runner.pid]
        found = {"base": [], "worker": [], "case": [], "calculix": []}
        for number, command in self.processes().items():
            try:
                parent = parent_of(number)
            except OSError:
                continue   # it ended meanwhile
            if "freecad" not in command.lower():
                found["calculix"].append(number)
            elif "worker_main" not in command:
                found["base"].append(number)
            else:
                found["worker" if parent == runner.pid else "case"].append(number)
        return found[kind]

    def finished(self, folder):
        """{id: row} of the cases that are done, in a database that is whole."""
        if not (self.folder / folder / "study.sqlite").exists():
            return {}
        link = sqlite3.connect(self.folder / folder / "study.sqlite")
        self.assertEqual(link.execute("pragma integrity_check").fetchone()[0], "ok")
        link.close()
        return {row["id"]: row for row in self.rows(folder) if row["state"] == "done"}

    def go_on(self, folder):
        """The command that begins the study in the folder, or goes on with it; a case that was killed twice may be tried again."""
        if (self.folder / folder / "study.sqlite").exists():
            return ("resume", folder, "--retry-failed", "--jobs", "2")
        return ("run", "study.toml", "--folder", folder, "--jobs", "2")

    def kill(self, kind, folder, moment, linger):
        """Runs the study, and kills one of that kind `moment` seconds after the start or, where there is none yet, as soon as there is. Was there one?"""
        before = self.finished(folder)
        process = self.start(*self.go_on(folder))
        try:
            time.sleep(moment)
            while process.poll() is None and not self.victims(kind, process):
                time.sleep(0.01)
            time.sleep(linger)
            there = self.victims(kind, process) if process.poll() is None else []
            for number in there[:1]:
                os.kill(number, signal.SIGKILL)
            out, err = process.communicate(timeout=300)
        finally:
            process.kill()
        self.assertNotIn("Traceback", out + err)
        self.assert_nothing_left_behind()
        self.assertLessEqual(before.items(), self.finished(folder).items())
        return bool(there)

    def test_kills_at_any_moment(self):
        chance = random.Random(SEED)
        self.toml('responses = ["max_mises"]', 'solver = "ccx"')
        start = time.monotonic()
        self.study("run", "study.toml", "--folder", "undisturbed", "--jobs", "2")
        whole, killed, number = time.monotonic() - start, 0, 1
        while killed < KILLS:
            kind, folder = VICTIMS[killed % len(VICTIMS)], "killed-%d" % number
            moment, linger = (0.0 if kind == "base" else chance.uniform(0, whole)), chance.uniform(0, LINGER)
            with self.subTest(seed=SEED, kill=killed + 1, kind=kind, folder=folder, moment=moment, linger=linger):
                if kind == "base" and (self.folder / folder / "study.sqlite").exists():
                    folder = "killed-%d" % (number := number + 1)
                killed += self.kill(kind, folder, moment, linger)
                if len(self.finished(folder)) == 4:
                    number += 1
        for folder in ("killed-%d" % one for one in range(1, number + 1)):
            with self.subTest(seed=SEED, folder=folder):
                self.study(*self.go_on(folder))
                self.assertEqual(self.results(folder), self.results("undisturbed"))
        self.assert_nothing_left_behind()


if __name__ == "__main__":
    print("seed", SEED)
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of studies share: a part, the launcher as a user types it, a look into a study's folder."""
import json
import os
import shutil
import sqlite3
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LAUNCHER = ROOT / "featuremesh"
HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(ROOT / "resources" / "launcher"))

import study_commands  # noqa: E402

study_commands.workbench()
_OURS = b"FEATUREMESH_STUDY_WORKER=", b"FEATUREMESH_TASK="   # variables of workers, and of the FreeCAD that makes a study's base
VARIED = ("--vary", "HoleSketch.Radius=4:8", "--vary", "Plate.Length=8:12")


class StudyTest(unittest.TestCase):
    """Has a folder with `part.FCStd`: a plate 60 x 40 x 10 mm with a hole, fixed at x = 0, pulled by 6000 N at x = 60."""

    @classmethod
    def setUpClass(cls):
        cls.made = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.made)
        cls.pulled_face, cls.best_solver = cls.make_part(cls.made / "part.FCStd")

    @staticmethod
    def make_part(path, kind="static", script="make_study_part.py"):
        """Saves the part there, with an analysis of that kind (see the script). Returns the name of the face that is pulled, and the best solver that
        there is: live or ccx."""
        done = subprocess.run([LAUNCHER, "run", HERE / script], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              env={**os.environ, "FEATUREMESH_STUDY_PART": str(path), "FEATUREMESH_STUDY_KIND": kind})
        if done.returncode:
            raise RuntimeError(done.stderr)
        return done.stdout.split()[-2:]

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="featuremesh-study-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.part = self.folder / "part.FCStd"
        shutil.copyfile(self.made / "part.FCStd", self.part)
        self.environment = dict(os.environ)

    def start(self, *words, **options):
        """The command, running."""
        return subprocess.Popen([LAUNCHER, "study", *map(str, words)], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                env=self.environment, **options)

    def study(self, *words, code=0, **options):
        """Runs `featuremesh study ...` in the folder. Returns what it said on standard output and on standard error."""
        process = self.start(*words, **options)
        out, err = process.communicate(timeout=600)
        self.assertEqual(process.returncode, code, out + err)
        self.assertNotIn("Traceback", err)
        return out, err

    def response_file(self, *lines, name="own.py"):
        """A file with a function `response(case)` of these lines; returns the study.toml that uses it."""
        (self.folder / name).write_text("import os, time\nfrom pathlib import Path\nHERE = Path(__file__).parent\ndef response(case):\n"
                                        + "".join("    %s\n" % line for line in lines), encoding="utf-8")
        return self.toml('responses = ["volume", {name = "own", file = "%s"}]' % name)

    def toml(self, *lines, name="study.toml", varied=True):
        """A study of the part: a grid of 2 x 2 cases and what the lines say."""
        text = 'document = "part.FCStd"\nsampling = "grid"\n' + "".join(line + "\n" for line in lines)
        if varied:
            text += ('[[parameters]]\nset = "HoleSketch.Radius"\nname = "radius"\nvalues = [4.0, 6.5]\n'
                     '[[parameters]]\nset = "Plate.Length"\nrange = [8, 12]\nlevels = 2\n')
        (self.folder / name).write_text(text, encoding="utf-8")
        return name

    def rows(self, folder="study-study"):
        """The cases as dicts, by id."""
        link = sqlite3.connect(self.folder / folder / "study.sqlite")
        link.row_factory = sqlite3.Row
        try:
            return [{key: json.loads(row[key]) if key in ("parameters", "responses", "seconds", "mesh", "hashes") else row[key] for key in row.keys()}
                    for row in link.execute("select * from cases order by id")]
        finally:
            link.close()

    def results(self, folder="study-study"):
        """{parameters: hash of mesh and responses}."""
        return {tuple(row["parameters"].values()): row["hashes"].get("result") for row in self.rows(folder)}

    def states(self, folder="study-study"):
        return [row["state"] for row in self.rows(folder)]

    def wait_for(self, condition, what, seconds=300):
        """Waits until `condition()` is true."""
        end = time.monotonic() + seconds
        while not condition():
            self.assertLess(time.monotonic(), end, "no %s in %g s" % (what, seconds))
            time.sleep(0.05)

    def processes(self):
        """{id: command line} of all processes that work for studies in the folder."""
        found = {}
        for name in os.listdir("/proc"):
            if name.isdigit():
                try:
                    command, environment = Path("/proc/%s/cmdline" % name).read_bytes(), Path("/proc/%s/environ" % name).read_bytes()
                    state = Path("/proc/%s/stat" % name).read_text(encoding="utf-8", errors="replace").rpartition(")")[2].split()[0]
                except OSError:
                    continue
                if state != "Z" and str(self.folder).encode() in environment and any(name in environment for name in _OURS):
                    found[int(name)] = command.decode(errors="replace")
        return found

    def assert_nothing_left_behind(self):
        self.wait_for(lambda: not self.processes(), "end of all processes: %s" % self.processes(), 60)

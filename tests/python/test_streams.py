# SPDX-License-Identifier: GPL-3.0-or-later
"""What a command writes may go to standard output, a pipe or a device, as with other programs. Runs in plain Python, with a task that writes what it is told to."""
import os
import subprocess
import sys
import tempfile
import threading
import unittest
from pathlib import Path

LAUNCHER = Path(__file__).resolve().parents[2] / "resources" / "launcher"
# FreeCAD's process gets no descriptor of ours, and FreeCAD's own writers want a name with the right ending.
PROGRAM = """
import json, sys
from pathlib import Path
sys.path.insert(0, %r)
import commands
from arguments import parse
from layout import UserError

def run_task(task):
    file = Path(task.get("json") or task["out"])
    assert file.suffix == (".json" if task.get("json") else "." + task["format"]) and not file.exists(), file
    file.write_text("written\\n" * 3, encoding="utf-8")
    return {"exit_code": 0, "message": f"wrote {file} whole", "data": {"warnings": ["of it"]}}

commands.run_task, commands.set_up = run_task, lambda *words: None
given = parse(sys.argv[1:])
try:
    sys.exit(given.run(given))
except UserError as error:
    sys.exit(str(error))
""" % str(LAUNCHER)
WRITTEN = "written\n" * 3


class Streams(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.part = self.folder / "part.FCStd"
        self.part.touch()

    def run_command(self, *words, **more):
        return subprocess.run([sys.executable, "-B", "-c", PROGRAM, *words], stderr=subprocess.PIPE, text=True, cwd=self.folder, check=False,
                              **{"stdout": subprocess.PIPE, **more})

    def export(self, out, **more):
        return self.run_command("export", str(self.part), "--format", "inp", out, **more)

    def test_standard_output_has_the_file_alone(self):
        for words in (("export", str(self.part), "--format", "inp", "-"), ("export", str(self.part), "--format", "inp", "/dev/stdout"),
                      ("mesh", str(self.part), "--json", "-"), ("update", str(self.part), "--json", "/dev/stdout")):
            done = self.run_command(*words)
            self.assertEqual((done.returncode, done.stdout), (0, WRITTEN), done.stderr)
            self.assertRegex(done.stderr, "^wrote (standard output|/dev/stdout) whole\nwarning: of it\n$")
        self.assertEqual(os.listdir(self.folder), ["part.FCStd"])

    def test_standard_output_that_is_a_file(self):
        with open(self.folder / "all", "w", encoding="utf-8") as stream:
            stream.write("before\n")
            stream.flush()
            self.export("/dev/stdout", stdout=stream)
        self.assertEqual((self.folder / "all").read_text(encoding="utf-8"), "before\n" + WRITTEN)

    def test_a_pipe_stays_one(self):
        pipe, read = self.folder / "pipe", []
        os.mkfifo(pipe)
        reader = threading.Thread(target=lambda: read.append(pipe.read_text(encoding="utf-8")), daemon=True)
        reader.start()
        done = self.export(str(pipe))
        reader.join(30)
        self.assertEqual((read, done.stdout), ([WRITTEN], f"wrote {pipe} whole\n"))
        self.assertTrue(pipe.is_fifo())

    def test_a_descriptor_of_the_shell(self):
        reader, writer = os.pipe()
        done = self.run_command("mesh", str(self.part), "--json", f"/dev/fd/{writer}", pass_fds=[writer])
        os.close(writer)
        with open(reader, encoding="utf-8") as stream:
            self.assertEqual((stream.read(), done.returncode), (WRITTEN, 0), done.stderr)

    def test_devices(self):
        self.assertEqual(self.export("/dev/null").returncode, 0)
        self.assertEqual(self.export("/dev/full").stderr, "cannot write /dev/full: No space left on device\n")

    def test_a_file(self):
        self.assertEqual(self.export("mesh.inp").stdout, f"wrote {self.folder / 'mesh.inp'} whole\n")
        self.assertEqual((self.folder / "mesh.inp").read_text(encoding="utf-8"), WRITTEN)


if __name__ == "__main__":
    unittest.main()

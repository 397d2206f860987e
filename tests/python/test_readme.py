# SPDX-License-Identifier: GPL-3.0-or-later
"""The console session of the README, replayed: every command says what is written there, but for the seconds. So are the edits that the user's guide
makes of the example. Runs in plain Python."""
import re
import shlex
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SECONDS = re.compile(r"\d+\.\d+ s\b")


def sessions(text):
    """[(command, lines that it says)] of the indented blocks; a command stands behind a $."""
    found = []
    for block in re.findall(r"(?:^    .*\n)+", text, re.MULTILINE):
        for line in (row[4:] for row in block.splitlines()):
            if line.startswith("$ "):
                found.append((line[2:], []))
            elif found and block.startswith("    $ "):
                found[-1][1].append(line)
    return found


def pattern(line):
    """Matches the line with any seconds in it, any run of blanks, and whatever stands for three dots."""
    return r"\s+".join(".*".join(map(re.escape, word.split("..."))) for word in SECONDS.sub("SECONDS", line).split())


class Session(unittest.TestCase):
    def test_says_what_is_written(self):
        session = sessions((ROOT / "README.md").read_text(encoding="utf-8"))
        self.assertGreater(len(session), 4)
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "resources").symlink_to(ROOT / "resources")
            for command, lines in session:
                with self.subTest(command=command):
                    self.check(folder, command, lines)

    def check(self, folder, command, lines):
        words = shlex.split(command)
        if words[0] == "cp":
            shutil.copyfile(Path(folder) / words[1], Path(folder) / words[2])
            return
        done = subprocess.run([str(ROOT / words[0]), *words[1:]], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        said = SECONDS.sub("SECONDS", done.stdout).replace(folder + "/", "")
        for line in lines:
            self.assertRegex(said, pattern(line))


class Edits(unittest.TestCase):
    def test_each_edit_of_the_guide_can_be_made(self):
        """Those of the bracket, which the guide calls part.FCStd, with a coarse mesh."""
        guide = (ROOT / "docs" / "user-guide.md").read_text(encoding="utf-8")
        edits = re.findall(r"^    (\./featuremesh update part\.FCStd .*)$", guide, re.MULTILINE)
        self.assertGreater(len(edits), 2)
        with tempfile.TemporaryDirectory() as folder:
            shutil.copyfile(ROOT / "resources" / "examples" / "bracket.FCStd", Path(folder) / "part.FCStd")
            for command in ["./featuremesh mesh part.FCStd --size 12 --order 1", *edits]:
                with self.subTest(command=command):
                    program, *words = shlex.split(command, comments=True)
                    done = subprocess.run([str(ROOT / program), *words], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                    self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""How the code is written, as far as tools tell: clang-format (.clang-format) and flake8 (.flake8) have nothing to say, that no
test of the engine looks at a clock, and how long design notes are. Runs in plain Python."""
import re
import shutil
import subprocess
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("src", "bindings", "tests", "resources", "Mod")
CLANG_FORMAT = "clang-format-14"   # others break lines elsewhere
CLOCK = re.compile(r"_clock\b|std::clock\b|<ctime>|<time\.h>")


def files(*suffixes):
    return [path for folder in FOLDERS for path in sorted((ROOT / folder).rglob("*")) if path.suffix in suffixes]


def complaints(*command):
    return subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True).stdout


class Style(unittest.TestCase):
    @unittest.skipUnless(shutil.which(CLANG_FORMAT), f"this Debian has no {CLANG_FORMAT}")
    def test_clang_format_would_change_nothing(self):
        sources = files(".h", ".cpp")
        self.assertGreater(len(sources), 300)
        self.assertEqual(complaints(CLANG_FORMAT, "--style=file", "--dry-run", *sources), "")

    def test_flake8_has_nothing_to_say(self):
        scripts = files(".py")
        self.assertGreater(len(scripts), 80)
        self.assertEqual(complaints("flake8", *scripts), "")

    def test_no_test_of_the_engine_looks_at_a_clock(self):
        """A machine under load failed them; `asked_memory.h` tells how much work something is."""
        with_clock = [str(path) for path in sorted((ROOT / "tests" / "cpp").rglob("*.[ch]*")) if CLOCK.search(path.read_text(encoding="utf-8"))]
        self.assertEqual(with_clock, [])

    def test_design_notes_are_short(self):
        notes = sorted((ROOT / "docs" / "design").glob("*.md"))
        self.assertGreater(len(notes), 10)
        for note in notes:
            lines = note.read_text(encoding="utf-8").splitlines()
            wide = [line for line in lines if len(line) > 120 and not line.startswith("|")]   # a row of a table cannot be broken
            self.assertEqual((len(lines) <= 150, wide), (True, []), note.name)


if __name__ == "__main__":
    unittest.main()

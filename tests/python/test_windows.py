# SPDX-License-Identifier: GPL-3.0-or-later
"""The modules of the engine that need no OCCT compile for Windows, with Debian's mingw-w64. Runs in plain Python."""
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
COMPILER = "x86_64-w64-mingw32-g++-posix"
MODULES = ("core", "mesh")
SKIPPED = 77


class Windows(unittest.TestCase):
    def test_core_and_mesh_compile(self):
        files = [path for module in MODULES for path in sorted((ROOT / "src" / module).glob("*.cpp"))]
        self.assertGreater(len(files), 10)
        with tempfile.TemporaryDirectory() as folder:
            for name in ("tbb", "oneapi"):   # headers alone, without those of this machine's C library beside them
                Path(folder, name).symlink_to(Path("/usr/include", name))
            for path in files:
                done = subprocess.run([COMPILER, "-std=c++20", "-Wall", "-Wextra", "-Werror", f"-I{ROOT / 'src'}", "-isystem", folder, "-c", str(path),
                                       "-o", str(Path(folder, "out.o"))], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
                self.assertEqual(done.returncode, 0, f"{path.relative_to(ROOT)}:\n{done.stdout}")


if __name__ == "__main__":
    if not shutil.which(COMPILER):
        sys.exit(SKIPPED)
    unittest.main()

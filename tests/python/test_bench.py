# SPDX-License-Identifier: GPL-3.0-or-later
"""`./featuremesh bench --documents` on a folder with parts and a file that is no document."""
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BENCH = ROOT / "tests" / "benchmarks" / "run_benchmarks.py"
EXAMPLES = ROOT / "resources" / "examples"
sys.path.insert(0, str(BENCH.parent))

import gmsh_peer  # noqa: E402
import mesh_document  # noqa: E402
from measured_process import run_measured  # noqa: E402


class Documents(unittest.TestCase):
    def measured(self, folder, *words):
        return subprocess.run([sys.executable, str(BENCH), "--documents", str(folder), "--divisor", "12", "--edits", "1", "--ours", *words],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def test_every_part_has_a_line_and_all_have_a_table(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            for example in ("block_and_cylinder", "csg_flange"):
                (folder / example).mkdir()
                shutil.copy(EXAMPLES / f"{example}.FCStd", folder / example / "part.FCStd")
            (folder / "torn.FCStd").write_bytes((EXAMPLES / "bracket.FCStd").read_bytes()[:2000])
            done = self.measured(folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = done.stdout.splitlines()
        for line, part in zip(lines, ("block_and_cylinder", "csg_flange")):
            self.assertRegex(line, rf"^{part}/part\.FCStd: [\d,]+ tets in \d+\.\d\d s, smallest angle \d+\.\d deg; \S+=\S+ \d+\.\d\d of a full mesh, \d+% kept")
        self.assertTrue(lines[2].startswith("torn.FCStd: not measured: "), lines[2])
        self.assertEqual(lines[3], "3 documents, 1 not measured, 0 refused; 2 edits, 0 refused, 0 by a fallback")
        rows = {row.group(1): [float(value) for value in row.group(2).split()] for row in map(re.compile(r"^(\D+?)\s\s+([\d. ]+)$").match, lines[5:8]) if row}
        self.assertEqual(list(rows), ["update / full mesh", "kept nodes", "first mesh / meshing alone"])
        for name, values in rows.items():
            self.assertEqual(values, sorted(values), name)
            self.assertEqual(len(values), 6, name)
        self.assertGreaterEqual(rows["first mesh / meshing alone"][0], 1)

    def test_each_edit_is_measured_as_itself_however_many_there_are(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            for number in range(12):
                (folder / f"{number}.json").touch()
            (folder / "measured.json").touch()
            self.assertEqual([path.stem for path in mesh_document.edited(folder)], [str(number) for number in range(1, 12)])

    def test_a_process_that_waits_uses_time_but_no_processor(self):
        with tempfile.TemporaryDirectory() as name:
            out = Path(name) / "out"
            used = run_measured([sys.executable, "-c", f"import time; open({str(out)!r}, 'w').close(); time.sleep(1)"], out, 60)
        self.assertGreater(used.processor_seconds, 0)
        self.assertLess(used.processor_seconds, used.seconds - 0.9)
        self.assertGreater(used.megabytes, 1)

    def test_a_mesh_of_gmsh_without_tets_is_said_to_be_none(self):
        with tempfile.TemporaryDirectory() as name:
            path = Path(name) / "mesh.msh"
            points = b"".join(struct.pack("<i3d", number, *point) for number, point in enumerate(((0, 0, 0), (1, 0, 0), (0, 1, 0)), 1))
            path.write_bytes(b"$Nodes\n3\n" + points + b"\n$EndNodes\n$Elements\n1\n" + struct.pack("<9i", 2, 1, 2, 1, 0, 0, 1, 2, 3) + b"\n$EndElements\n")
            with self.assertRaisesRegex(RuntimeError, "no tets"):
                gmsh_peer.read_msh(path)

    def test_a_folder_without_documents_is_the_users_error(self):
        with tempfile.TemporaryDirectory() as name:
            done = self.measured(name)
        self.assertEqual(done.returncode, 2)
        self.assertIn("no document (*.FCStd)", done.stderr)

    def test_what_it_does_not_do_is_refused(self):
        for words in (["--threads", "2"], ["--case", "bracket"], ["--netgen"]):
            done = self.measured(EXAMPLES, *words)
            self.assertEqual(done.returncode, 2)
            self.assertIn("leave out --case, --threads and --netgen", done.stderr)

    def test_a_case_that_there_is_not_is_named(self):
        done = subprocess.run([sys.executable, str(BENCH), "--case", "bracket", "--case", "nope"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertEqual(done.stderr, "featuremesh bench: there is no case nope; ./featuremesh bench --list names all\n")

    def test_where_nothing_could_be_measured_it_fails(self):
        with tempfile.TemporaryDirectory() as name:
            (Path(name) / "torn.FCStd").write_bytes((EXAMPLES / "bracket.FCStd").read_bytes()[:2000])
            done = self.measured(name)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("1 documents, 1 not measured", done.stdout)


if __name__ == "__main__":
    unittest.main()

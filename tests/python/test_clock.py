# SPDX-License-Identifier: GPL-3.0-or-later
"""No clock and no number of threads decides what a mesh is: the examples, ten random documents and an edit of each, the same bytes by clocks that
run a thousand times too fast and too slow, and with 1, 2 and 4 threads."""
import json
import os
import random
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import FreeCAD
from detailed_parts import detailed_part
from freecad.featuremesh import api, reading, worker
from parts import new_document, placement

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "resources" / "examples"
sys.path.insert(0, str(ROOT / "tests" / "benchmarks"))

from raw_files import write_raw  # noqa: E402

ELEMENTS = 25          # along the part's diagonal
EDITS = {              # example: (document after, its edit, element order)
    "bracket": ("bracket", ["HoleSketch.Hole6X=105"], 2),
    "block_and_cylinder": ("block_and_cylinder", ["Cylinder.Placement.Base.x=35"], 1),
    "csg_flange": ("csg_flange", ["Bolt.Radius=4.5"], 1),
    "tool": ("tool_with_stiffener", [], 1),
}
FAST, SLOW = 1000, 0.001


class InProcesses(unittest.TestCase):
    """Each mesh is made in a process of its own."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def raw(self, example, edits, name):
        """The file with what is read of the example's part after the edits, and a size for it."""
        document = FreeCAD.openDocument(str(EXAMPLES / (example + ".FCStd")))
        try:
            if edits:
                api.set_parameters(document, edits)
                api.recompute(document)
            part = document.getObject("Body") or document.getObject("Flange")
            return self.written(part, name), api.default_size(part, ELEMENTS)
        finally:
            FreeCAD.closeDocument(document.Name)

    def written(self, part, name):
        path = self.folder / (name + ".json")
        write_raw(path, reading.read_document(part))
        return path

    def made(self, old, new, size, order, threads=1, clock=None):
        environment = {**os.environ, "PYTHONPATH": os.environ["FEATUREMESH_ENGINE"]}
        if clock is not None:
            environment.update(LD_PRELOAD=os.environ["FEATUREMESH_OTHER_CLOCK"], FEATUREMESH_CLOCK_FACTOR=str(clock))
        done = subprocess.run([worker.interpreters()[0], str(ROOT / "tests/clock/meshes_of_part.py"), old, new, str(size), str(order), str(threads)],
                              env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=500)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout.splitlines()[-1])


class Clock(InProcesses):
    def test_same_bytes_by_every_clock_and_with_any_number_of_threads(self):
        for example, (after, edits, order) in EDITS.items():
            with self.subTest(example=example):
                old, size = self.raw(example, [], "old")
                new, _ = self.raw(after, edits, "new")
                usual = self.made(old, new, size, order)
                self.assertGreater(usual["tets"], 500)
                self.assertGreater(min(usual["kept"]), 0.2)
                for threads in (2, 4):
                    self.assertEqual(self.made(old, new, size, order, threads)["digest"], usual["digest"], f"{threads} threads")
                fast, slow = (self.made(old, new, size, order, clock=clock) for clock in (FAST, SLOW))
                self.assertGreater(fast["clock"], 50)   # by these a tenth of a second is another time
                self.assertLess(slow["clock"], 0.05)
                self.assertEqual(fast["digest"], usual["digest"], "by a fast clock")
                self.assertEqual(slow["digest"], usual["digest"], "by a slow clock")


class RandomDocuments(InProcesses):
    def bored(self, shape, elements):
        """What is read of a document with a bore through the shape, and of the same with a wider bore; a size for so many elements along the diagonal."""
        document = new_document()
        try:
            solid, bore = document.addObject("Part::Feature", "Imported"), document.addObject("Part::Cylinder", "Bore")
            part = document.addObject("Part::Cut", "Bored")
            solid.Shape, part.Base, part.Tool = shape, solid, bore
            box = shape.BoundBox
            bore.Radius, bore.Height = 0.05 * box.DiagonalLength, 3 * box.DiagonalLength
            bore.Placement.Base = box.Center - FreeCAD.Vector(0, 0, box.DiagonalLength)
            document.recompute()
            old = self.written(part, "old")
            bore.Radius = 1.2 * bore.Radius.Value
            document.recompute()
            return old, self.written(part, "new"), api.default_size(part, elements)
        finally:
            FreeCAD.closeDocument(document.Name)

    def test_same_bytes_of_ten(self):
        chance = random.Random(8)
        for number in range(10):
            shape, words = detailed_part(chance)
            with self.subTest(number=number, part=words):
                old, new, size = self.bored(shape, 12)
                order = 1 + number % 2
                usual = self.made(old, new, size, order)
                for threads, clock in ((2, FAST), (4, SLOW)):
                    self.assertEqual(self.made(old, new, size, order, threads, clock)["digest"], usual["digest"], f"{threads} threads, {clock} times the time")


class LargeCavities(InProcesses):
    def bar(self, end):
        """A bar of three boxes, whose two ends are so long, mm."""
        document = new_document()
        for name, length, x in (("Middle", 24, 0), ("Left", end, -end), ("Right", end, 24)):
            box = document.addObject("Part::Box", name)
            box.Length, box.Width, box.Height, box.Placement = length, 26, 26, placement(x=x)
        bar = document.addObject("Part::MultiFuse", "Bar")
        bar.Shapes = [document.Middle, document.Left, document.Right]
        document.recompute()
        return self.written(bar, "bar_%d" % end)

    def test_two_at_once_are_filled_on_all_threads_with_the_same_bytes_for_any_number(self):
        old, new = self.bar(4), self.bar(34)
        one = self.made(old, new, 2, 1)
        self.assertEqual(one["large_cavities"][0], 2)
        self.assertGreater(one["kept"][0], 0.05)   # of the new mesh's nodes: the middle of the middle
        for threads in (2, 4):
            self.assertEqual(self.made(old, new, 2, 1, threads)["digest"], one["digest"], f"{threads} threads")

# SPDX-License-Identifier: GPL-3.0-or-later
"""What commands and panels change is one undo step, or nothing at all."""
import unittest

from freecad.featuremesh.gui.undo import undo_step
from parts import new_document


class UndoStep(unittest.TestCase):
    def setUp(self):
        self.document = new_document()
        self.document.UndoMode = 1

    def names(self):
        return [obj.Name for obj in self.document.Objects]

    def test_what_is_changed_within_is_one_step(self):
        with undo_step(self.document, "Add two"):
            self.document.addObject("App::FeaturePython", "One")
            self.document.addObject("App::FeaturePython", "Two")
        self.assertEqual(self.document.UndoNames, ["Add two"])
        self.document.undo()
        self.assertEqual(self.names(), [])

    def test_an_exception_takes_it_back_and_leaves_nothing_open(self):
        for change in (True, False):   # with something changed, and before anything was
            with self.assertRaises(ZeroDivisionError), undo_step(self.document, "Fail"):
                if change:
                    self.document.addObject("App::FeaturePython", "One")
                raise ZeroDivisionError
            self.assertEqual((self.names(), self.document.UndoCount, self.document.HasPendingTransaction), ([], 0, False))


if __name__ == "__main__":
    unittest.main()

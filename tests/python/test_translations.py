# SPDX-License-Identifier: GPL-3.0-or-later
"""Everything the workbench shows has a German text, and the compiled translation is that of the source. Needs PySide2, as FreeCAD does."""
import re
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "resources" / "translations"))
sys.dont_write_bytecode = True
import update_translations  # noqa: E402

try:
    from PySide2 import QtCore
except ImportError:
    from PySide6 import QtCore

PLACEHOLDER = re.compile(r"%[-.\d]*[a-zA-Z%]")
PARAMETER = re.compile(r"\{\w+:\w+\}")


class German(unittest.TestCase):
    def setUp(self):
        self.path = update_translations.FOLDER / "FeatureMesh_de.ts"
        self.translations = update_translations.read(self.path)

    def test_is_complete(self):
        texts = update_translations.texts_in_workbench()
        self.assertGreater(len(texts), 100)
        self.assertEqual(set(self.translations), texts, "run resources/translations/update_translations.py")
        self.assertEqual([key for key, text in self.translations.items() if not text], [])

    def test_is_in_words_that_users_of_fem_know(self):
        own = re.compile(r"\b(tets?|cells?|cavity|seam|entity|entities|interaction)\b|the other's material|mm3|mm³|mm²")
        self.assertEqual([source for _, source in self.translations if own.search(PARAMETER.sub("", source))], [])

    def test_has_the_same_placeholders(self):
        for (_, source), text in self.translations.items():
            self.assertEqual(PLACEHOLDER.findall(text), PLACEHOLDER.findall(source), text)
            self.assertEqual(sorted(PARAMETER.findall(text)), sorted(PARAMETER.findall(source)), text)   # in any order

    def test_has_every_message_of_the_engine(self):
        for code, template in update_translations.templates_of_engine().items():
            has_words = re.search("[A-Za-z]", PARAMETER.sub("", template)) is not None
            self.assertEqual(bool(self.translations.get(("FeatureMesh", template))), has_words, code)

    def test_is_compiled(self):
        translator = QtCore.QTranslator()
        self.assertTrue(translator.load(str(self.path.with_suffix(".qm"))))
        for (context, source), text in self.translations.items():
            self.assertEqual(translator.translate(context, source), text, "run resources/translations/update_translations.py")


if __name__ == "__main__":
    unittest.main()

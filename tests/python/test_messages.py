# SPDX-License-Identifier: GPL-3.0-or-later
"""The engine's messages are recognised, so that the window can say them in the user's language."""
import re
import unittest
from pathlib import Path
from unittest import mock

import FreeCAD
from freecad.featuremesh import messages

ROOT = Path(__file__).resolve().parents[2]
LITERAL = re.compile(r'"((?:[^"\\]|\\.)*)"')


def literals(path):
    """The texts in a source file, those that follow one another as one."""
    return LITERAL.sub(r"\1", re.sub(r'"\s*\n?\s*"', "", path.read_text(encoding="utf-8")))


class Sentences(unittest.TestCase):
    def test_are_still_those_of_the_sources(self):
        sources = [literals(path) for folder, kind in (("src", "*.cpp"), ("Mod", "*.py")) for path in sorted((ROOT / folder).rglob(kind))
                   if path.name != "messages.py"]
        for sentence in messages.SENTENCES:
            words = max(sentence.split("%s"), key=len).strip()
            kinds = words.replace("choose another ", "choose another %s|").split("|")[0]   # the kind of entity is put in there
            self.assertTrue(any(kinds in source for source in sources), "nothing says '%s' any more" % words)

    def test_each_is_recognised_and_nothing_is_lost(self):
        for sentence in messages.SENTENCES:
            text = sentence.replace("%s", "Face12")
            with mock.patch.object(messages, "translate", side_effect=lambda context, words: words) as translate:
                self.assertEqual(messages.in_words(text), text)
            self.assertTrue(translate.called, sentence)

    def test_a_message_inside_another_is_said_in_the_same_language(self):
        german = {"The mesh is not valid: %s.": "Das Netz ist nicht gültig: %s.", "meshed from scratch: %s": "von Grund auf vernetzt: %s"}
        with mock.patch.object(messages, "translate", side_effect=lambda context, words: german[words]):
            self.assertEqual(messages.in_words("meshed from scratch: The mesh is not valid: tet 5."),
                             "von Grund auf vernetzt: Das Netz ist nicht gültig: tet 5.")

    def test_lengths_are_in_the_users_units(self):
        said = ("The mesh size of 254 mm is larger than the part, which is 50.8 x 25.4 x -12.7 mm. Ask for a smaller size.", "volume 16387.064 -> 32774.128 mm^3",
                "Face2 has 3 edges, Edge12 mm", "node 7 at (25.4, 0, -2.54) mm")
        self.assertEqual([messages.in_words(text) for text in said], list(said))
        FreeCAD.Units.setSchema(3)   # inches with decimals
        self.addCleanup(FreeCAD.Units.setSchema, 0)
        self.assertEqual([messages.in_words(text) for text in said], [
            "The mesh size of 10.00 in is larger than the part, which is 2.00 in x 1.00 in x -0.50 in. Ask for a smaller size.",
            "volume 1.00 in^3 -> 2.00 in^3", "Face2 has 3 edges, Edge12 mm", "node 7 at (1.00 in, 0.00 in, -0.10 in)"])

    def test_are_in_words_that_users_know(self):
        own = re.compile(r"\b(tets?|cells?|cavity|seam|entity|entities|interaction)\b|material of the other|mm3|mm³|mm²")
        for sentence in messages.SENTENCES:
            self.assertIsNone(own.search(sentence), sentence)
        for path in sorted((ROOT / "src").rglob("*.cpp")):
            if path.name == "tet_complex.cpp":
                continue   # its findings are of the program's own mistakes
            for text in LITERAL.findall(path.read_text(encoding="utf-8")):
                self.assertIsNone(re.search(r"\btets?\b", text) if " " in text and not text.endswith(".h") else None, (path.name, text))

    def test_what_is_not_known_stays(self):
        self.assertEqual(messages.in_words("100 % new words"), "100 % new words")

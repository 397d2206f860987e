# SPDX-License-Identifier: GPL-3.0-or-later
"""What the user's guide says is there: a public function for every button, the properties, the commands, the pictures."""
import ast
import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
WORKBENCH = ROOT / "Mod" / "FeatureMesh" / "freecad" / "featuremesh"
GUIDE = (ROOT / "docs" / "user-guide.md").read_text(encoding="utf-8")


def button_texts():
    """The text of each command of the workbench."""
    texts = []
    for path in sorted((WORKBENCH / "commands").glob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ClassDef) and node.name == "Command":
                texts += [entry.value.value for entry in node.body
                          if isinstance(entry, ast.Assign) and getattr(entry.targets[0], "id", "") == "text"]
    return texts


class Guide(unittest.TestCase):
    def test_every_button_is_one_public_function(self):
        rows = dict(re.findall(r"^\| ([^|]+) \| ([^|]*`api\.[^|]+) \|$", GUIDE, re.MULTILINE))
        named = {text.strip(): functions for texts, functions in rows.items() for text in texts.split(",")}
        api = ast.parse((WORKBENCH / "api.py").read_text(encoding="utf-8"))
        public = {node.name for node in api.body if isinstance(node, ast.FunctionDef)}
        self.assertGreater(len(button_texts()), 8)
        self.assertEqual(sorted(named), sorted(button_texts()))
        for text, functions in named.items():
            self.assertLessEqual(set(re.findall(r"api\.(\w+)\(", functions)), public, text)

    def test_every_picture_is_there_and_shown(self):
        shown = set(re.findall(r"\(pictures/([\w./]+)\)", GUIDE))
        for page in [ROOT / "README.md", *(ROOT / "docs").rglob("*.md")]:
            shown |= set(re.findall(r"pictures/([\w./]+\.\w+)", page.read_text(encoding="utf-8")))
        pictures = ROOT / "docs" / "pictures"
        self.assertEqual(shown, {str(path.relative_to(pictures)) for path in pictures.rglob("*") if path.is_file()})

    def test_every_command_of_the_launcher_that_it_names_exists(self):
        arguments = (ROOT / "resources" / "launcher" / "arguments.py").read_text(encoding="utf-8")
        commands = set(re.findall(r'command\(subparsers, "(\w+)"', arguments))
        self.assertGreater(len(commands), 10)
        self.assertLessEqual(set(re.findall(r"\./featuremesh (\w+)", GUIDE)), commands)


if __name__ == "__main__":
    unittest.main()

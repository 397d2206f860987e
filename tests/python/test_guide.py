# SPDX-License-Identifier: GPL-3.0-or-later
"""What the user's guide says is there: a public function for every button, the properties, the commands, the pictures."""
import ast
import re
import unittest
import zipfile
from pathlib import Path
from xml.etree import ElementTree

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

    def test_every_dimension_that_it_sets_is_in_the_example(self):
        """The commands are typed as they stand, with a copy of the bracket."""
        with zipfile.ZipFile(ROOT / "resources" / "examples" / "bracket.FCStd") as archive:
            document = ElementTree.fromstring(archive.read("Document.xml"))
        objects = {entry.get("name"): {inner.get("name") for inner in entry.iter("Property")} | {inner.get("Name") for inner in entry.iter("Constrain")}
                   for entry in document.findall("ObjectData/Object")}
        commands = "\n".join(line for line in GUIDE.splitlines() if line.startswith("    "))
        python = "\n".join(re.findall(r"```python\n(.*?)```", GUIDE, re.DOTALL))
        targets = re.findall(r"--(?:set|vary) (\w+)\.(\w+)=", commands) + re.findall(r'set = "(\w+)\.(\w+)"', commands) + re.findall(r'\["(\w+)\.(\w+)=', python)
        self.assertGreater(len(targets), 8)
        for name, dimension in targets:
            self.assertIn(dimension, objects.get(name, ()), name)

    def test_our_properties_on_the_page_beside_gmsh_and_netgen_exist(self):
        page = (ROOT / "docs" / "beside-gmsh-and-netgen.md").read_text(encoding="utf-8")
        ours = set(re.findall(r'\("App::Property\w+", "(\w+)", "', (WORKBENCH / "mesh_properties.py").read_text(encoding="utf-8")
                              + (WORKBENCH / "size_zone.py").read_text(encoding="utf-8")))
        theirs = {name for row in re.findall(r"^\| ([^|]*) \|", page, re.MULTILINE) for name in re.findall(r"`(\w+)`", row)}
        named = {name for row in re.findall(r"^\|.*\| ([^|]*) \|$", page, re.MULTILINE) for name in re.findall(r"`([A-Z]\w+)`", row)}
        self.assertGreater(len(named), 20)
        self.assertEqual(named - ours - theirs - {"Part", "Face3", "Face3_Nodes"}, set())
        wishes = ("same", "better", "other way", "not")
        rows = [row for row in page.splitlines() if row.startswith("| `")]
        self.assertEqual([row for row in rows if row.split(" | ")[2].strip() not in wishes], [])


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Everything the workbench shows has a German text, and the compiled translation is that of the source. Needs PySide2, as FreeCAD does."""
import ast
import re
import sys
import tempfile
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
CHOICE = re.compile(r"\{(\w+):[^{}|]*\|[^{}|]*\}")   # of words for one or more
MARKING = ("translate", "QT_TRANSLATE_NOOP", "said", "addProperty")
LOGGING = ("write", "write_error")
# What a person sees of the words in their arguments.
SHOWING = {"setText", "setWindowTitle", "setToolTip", "setTitle", "addItem", "addTab", "addButton", "addRow", "addAction", "setPlaceholderText", "setSuffix",
           "setHeaderLabels", "setHorizontalHeaderLabels", "QLabel", "QPushButton", "QCheckBox", "QGroupBox", "QRadioButton", "QTableWidgetItem",
           "showMessage", "PrintMessage", "PrintWarning", "PrintError", "warning", "information", "critical", "question", "getOpenFileName", "getSaveFileName"}
# Their words are for the console alone, and English.
ON_THE_CONSOLE = ("cli.py", "tasks.py", "quality.py", "pictures.py", "difference_picture.py", "mesh_picture.py", "study/progress.py",
                  "study/optimise.py", "study/optuna_search.py")
# Two words in a row that are for no reader: of files, of FreeCAD's and CalculiX's own, of the engine, of reports as JSON, of what only we can cause.
NO_SENTENCE = re.compile(r"^\s*<|</|^\.?[a-z]*\{|^\*|^\^|^\n:root \{|^\ncreate table|^User parameter:|"
                         r"^(select|insert|update|create|pragma|begin|order|where) |^ (where|order) |FEM mesh has|"
                         r"^total (force|internal|mass)|^(interaction changed|trimmed differently|before and after|the inside|disk full|disk is full|readonly database|"
                         r"unable to open|thin-plate spline|From shape|Unless larger than a million elements|"
                         r"cancelled)$|^background-color|FeatureMesh, lengths in mm|^FIELD |^conjugate gradients|"
                         r"CalculiX's own choice|^few unknowns|^points or (edges|faces)|unknowns, linear statics|^the solver object|a state holds plain numbers|^a plane is|"
                         r"the base document did not arrive whole|do not tell the terms apart|^Place of a response|^of unknown version")


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
        self.assertEqual([source for _, source in self.translations if own.search(PARAMETER.sub("", source).replace("alias or cell", ""))], [])

    def test_has_the_same_placeholders(self):
        for (_, source), text in self.translations.items():
            self.assertEqual(PLACEHOLDER.findall(text), PLACEHOLDER.findall(source), text)
            self.assertEqual(sorted(PARAMETER.findall(text)), sorted(PARAMETER.findall(source)), text)   # in any order

    def test_has_words_for_one_and_for_more(self):
        for (_, source), text in self.translations.items():
            for words in (source, text):
                counts = re.findall(r"\{(\w+):count\}", words)
                self.assertEqual([name for name in CHOICE.findall(words) if name not in counts], [], words)
                self.assertNotRegex(CHOICE.sub("", PARAMETER.sub("", words)), r"[{}|]", words)
            self.assertNotRegex(source, r":count\} (?!has\b|cases;|characters |materials$|objects )[a-z]+s\b", "one would be in the plural")   # these are many

    def test_has_every_message_of_the_engine(self):
        for code, template in update_translations.templates_of_engine().items():
            has_words = re.search("[A-Za-z]", PARAMETER.sub("", template)) is not None
            self.assertEqual(bool(self.translations.get(("FeatureMesh", template))), has_words, code)

    def test_keeps_its_order(self):
        known = {("B", "two"): "zwei", ("B", "one"): "eins", ("C", "old"): "alt", ("C", "four"): "vier"}
        found = update_translations.brought_up_to_date(known, {("B", "one"), ("B", "two"), ("B", "three"), ("C", "four"), ("A", "new"), ("C", "z")})
        self.assertEqual(list(found.items()), [(("A", "new"), ""), (("B", "three"), ""), (("B", "two"), "zwei"), (("B", "one"), "eins"), (("C", "four"), "vier"),
                                               (("C", "z"), "")])
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "FeatureMesh_de.ts"
            update_translations.write(path, "de", found)
            self.assertEqual(list(update_translations.read(path).items()), list(found.items()))

    def test_is_as_the_program_leaves_it(self):
        self.assertEqual(list(update_translations.brought_up_to_date(self.translations, update_translations.texts_in_workbench())), list(self.translations))

    def test_is_compiled(self):
        translator = QtCore.QTranslator()
        self.assertTrue(translator.load(str(self.path.with_suffix(".qm"))))
        for (context, source), text in self.translations.items():
            self.assertEqual(translator.translate(context, source), text, "run resources/translations/update_translations.py")


class Sentences(unittest.TestCase):
    maxDiff = None

    def test_none_is_shown_or_raised_without_a_translation(self):
        found = [f"{path.relative_to(update_translations.WORKBENCH)}: {text!r}" for path in sorted(update_translations.WORKBENCH.rglob("*.py"))
                 if str(path.relative_to(update_translations.WORKBENCH)) not in ON_THE_CONSOLE for text in unmarked(path.read_text(encoding="utf-8"))]
        self.assertEqual(found, [])

    def test_a_new_one_is_found(self):
        for code, texts in (("raise UserError('%s is wrong' % name)", ["%s is wrong"]), ("label.setText('Wrong')", ["Wrong"]), ("said('x: {why:text}', why=y)", []),
                            ("text = 'all is wrong' if wrong else ''", ["all is wrong"]), ("raise UserError(said('{name:text} is wrong', name=name))", []),
                            ("label.setText(translate('FeatureMesh', 'all is wrong'))", []), ("def f():\n    'all is wrong'", []),
                            ("raise UserError(f'{name} is wrong')", [" is wrong"]), ("log.write('all is wrong')", []), ("raise ValueError('wrong')", ["wrong"])):
            self.assertEqual(list(unmarked(code)), texts, code)


def unmarked(code):
    """The texts in a module that a person sees and that no call marks for translation: sentences, and words in what is raised or put into widgets."""
    tree = ast.parse(code)
    parents = {child: node for node in ast.walk(tree) for child in ast.iter_child_nodes(node)}
    for node in ast.walk(tree):
        text = update_translations.text(node)
        if text is None or isinstance(parents[node], ast.Expr):   # a docstring
            continue
        around = list(above(node, parents))
        calls = [update_translations.name_of(call) for call in around if isinstance(call, ast.Call)]
        if {*MARKING, *LOGGING}.intersection(calls) or any(is_table_or_command(part, parents) for part in around) \
                or isinstance(parents[node], (ast.Subscript, ast.Compare)) or NO_SENTENCE.search(text):
            continue
        is_seen = calls[:1] and calls[0] in SHOWING or any(isinstance(part, ast.Raise) for part in around)
        if re.search(r"[A-Za-z]{3}" if is_seen else r"[A-Za-z]{2} [a-z]{2}", without_names(text)):
            yield text


def above(node, parents):
    while node in parents:
        node = parents[node]
        yield node


def is_table_or_command(node, parents):
    """The table of an object's properties, or what a command is called, which are marked as such."""
    name = getattr(node.targets[0], "id", "") if isinstance(node, ast.Assign) else ""
    return name == "PROPERTIES" or name in ("name", "text", "tooltip") and isinstance(parents[node], ast.ClassDef)


def without_names(text):
    return re.sub(r"FeatureMesh|FreeCAD|https?:\S+|<[^>]*>|\w*\.\w+|\(\*\.\w+\)|CSV|JSON|%\S", "", text)


if __name__ == "__main__":
    unittest.main()

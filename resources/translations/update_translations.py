# SPDX-License-Identifier: GPL-3.0-or-later
"""Brings the translations up to date with the workbench: new texts come into the .ts files, old ones go, lrelease makes the .qm files. What stays keeps
its place, so that a change shows as one.

    /usr/bin/python3 resources/translations/update_translations.py      # needs Debian's qttools5-dev-tools

Texts that still lack a translation are listed; write them into the .ts file (or with Qt Linguist) and run this again.
"""
import ast
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
WORKBENCH = ROOT / "Mod" / "FeatureMesh" / "freecad" / "featuremesh"
MESSAGES = ROOT / "src" / "core" / "messages.def"
FOLDER = WORKBENCH / "translations"
LRELEASE = ("/usr/lib/qt5/bin/lrelease", "lrelease")


def texts_in_workbench():
    """{(context, text)} of everything the workbench shows, as its sources and the engine's messages say it."""
    found = {("FeatureMesh", template) for template in templates_of_engine().values() if has_words(template)}
    for path in sorted(WORKBENCH.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call):
                found |= marked(node)
            elif isinstance(node, ast.ClassDef) and path.parent.name == "commands":
                found |= of_command(node)
            elif isinstance(node, ast.Assign) and getattr(node.targets[0], "id", "") == "PROPERTIES":
                found |= {("App::Property", text(row.elts[5])) for row in node.value.elts}
    return found


def templates_of_engine():
    """{code: English words} of the engine's messages."""
    return dict(re.findall(r'^MESSAGE\((\w+), "(.*)"\)$', MESSAGES.read_text(encoding="utf-8"), re.MULTILINE))


def has_words(template):
    """Is there anything to translate beside the parameters, words for one and more among it?"""
    return re.search("[A-Za-z]", re.sub(r"\{\w+:\w+\}", "", template)) is not None


def name_of(call):
    """The name of the function that is called."""
    return getattr(call.func, "attr", getattr(call.func, "id", ""))


def marked(call):
    """What translate(context, text), QT_TRANSLATE_NOOP(context, text), said(text) and addProperty(type, name, group, text) mark."""
    if name_of(call) == "addProperty":
        return {("App::Property", text(tooltip)) for tooltip in call.args[3:4] if text(tooltip)}
    words = [text(argument) for argument in call.args[:2]]
    if name_of(call) == "said":
        return {("FeatureMesh", words[0])} if words and words[0] and has_words(words[0]) else set()
    return {tuple(words)} if name_of(call) in ("translate", "QT_TRANSLATE_NOOP") and len(words) == 2 and all(words) else set()


def of_command(cls):
    """FreeCAD translates a command's texts with the command's name as context."""
    values = {node.targets[0].id: text(node.value) for node in cls.body
              if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name)}
    return {(values["name"], values[key]) for key in ("text", "tooltip")} if values.get("name") else set()


def text(node):
    """The string that a node of the syntax tree is, or None."""
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def read(path):
    """{(context, text): translation} of a .ts file."""
    if not path.exists():
        return {}
    return {(context.findtext("name"), message.findtext("source")): message.findtext("translation") or ""
            for context in ElementTree.parse(path).getroot().iter("context") for message in context.iter("message")}


def brought_up_to_date(known, texts):
    """{(context, text): translation}: what is still there in its order, and each new text before the first that sorts after it."""
    order = [key for key in known if key in texts]
    for key in sorted(texts - set(known)):
        order.insert(next((place for place, other in enumerate(order) if other > key), len(order)), key)
    return {key: known.get(key, "") for key in order}


def write(path, language, translations):
    """Writes a .ts file, in the order of the translations."""
    root = ElementTree.Element("TS", version="2.1", language=language, sourcelanguage="en")
    for name in dict.fromkeys(context for context, _ in translations):
        context = ElementTree.SubElement(root, "context")
        ElementTree.SubElement(context, "name").text = name
        for source in (source for where, source in translations if where == name):
            message = ElementTree.SubElement(context, "message")
            ElementTree.SubElement(message, "source").text = source
            translation = ElementTree.SubElement(message, "translation")
            translation.text = translations[name, source]
            if not translation.text:
                translation.set("type", "unfinished")
    ElementTree.indent(root)
    body = ElementTree.tostring(root, encoding="unicode")
    path.write_text('<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n' + body + "\n", encoding="utf-8")


def main():
    texts = texts_in_workbench()
    lacking = 0
    for path in sorted(FOLDER.glob("FeatureMesh_*.ts")):
        translations = brought_up_to_date(read(path), texts)
        write(path, re.search(r"_(\w+)\.ts$", path.name).group(1), translations)
        for (context, source), translation in translations.items():
            if not translation:
                lacking += 1
                print(f"{path.name}: [{context}] {source}")
        program = next((name for name in LRELEASE if Path(name).exists()), LRELEASE[-1])
        subprocess.run([program, "-silent", str(path), "-qm", str(path.with_suffix(".qm"))], check=True)
    return 1 if lacking else 0


if __name__ == "__main__":
    sys.exit(main())

# SPDX-License-Identifier: GPL-3.0-or-later
"""The modules of the engine use only those before them, libraries stop where they are needed, and the workbench's model
side never touches a window. Runs in plain Python."""
import ast
import re
import shutil
import subprocess
import unittest
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SOURCES = ROOT / "src"
WORKBENCH = ROOT / "Mod" / "FeatureMesh" / "freecad" / "featuremesh"
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]', re.MULTILINE)
ORDER = ["core", "brep", "mesh", "sizing", "surface", "volume", "features", "cells", "difference", "update", "statics"]
# Which modules know which library, and which of these may show it in their headers.
KNOW_OCCT = {"brep", "sizing", "surface", "features", "cells", "difference", "update"}
SHOW_OCCT = {"brep", "features", "cells", "difference", "update"}
KNOW_CGAL = {"statics", "surface", "volume"}
NAME = re.compile(r"[A-Za-z_]\w*")
KERNEL_NAMES = ("BOP", "BRep", "Geom_", "Message_")
WINDOW_FILES = {"init_gui.py", "live_view.py", "view_provider.py", "element_view.py", "study_view.py", "zone_view.py", "assembled_view.py"}
WINDOW_FOLDERS = {"commands", "gui"}
WINDOW_MODULES = {"FreeCADGui", "pivy", "FemGui", "PySide", "PySide2", "PySide6"}


def source_files(folder):
    return sorted(path for path in folder.rglob("*") if path.suffix in (".h", ".cpp"))


def includes(path):
    """(quoted or angled, name) of every include."""
    return INCLUDE.findall(path.read_text(encoding="utf-8"))


def imported_names(path):
    """Every module named by an import anywhere in a Python file."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield "." * node.level + (node.module or "")


def loaded_with(path):
    """The files of the workbench that are loaded with that one, itself among them: by what is imported outside of functions."""
    found, waiting = set(), [path]
    while waiting:
        file = waiting.pop()
        found.add(file)
        for node in ast.parse(file.read_text(encoding="utf-8")).body:
            if isinstance(node, ast.ImportFrom) and node.level:
                base = file.parents[node.level - 1].joinpath(*(node.module or "").split("."))
                named = [base.with_suffix(".py"), base / "__init__.py", *(base / (alias.name + ".py") for alias in node.names)]
                waiting += [other for other in named if other.is_file() and other not in found]
    return found


class ModuleOrder(unittest.TestCase):
    def test_build_and_folders_name_the_same_modules_in_the_same_order(self):
        text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
        self.assertEqual(re.search(r"set\(FEATUREMESH_MODULES ([a-z ]+)", text).group(1).split(), ORDER)
        self.assertEqual({path.name for path in SOURCES.iterdir()}, set(ORDER))

    def test_a_file_includes_only_modules_above_its_own(self):
        seen = 0
        for module in ORDER:
            allowed = set(ORDER[:ORDER.index(module) + 1])
            for path in source_files(SOURCES / module):
                for quote, name in includes(path):
                    if quote == '"':
                        seen += 1
                        self.assertIn(name.split("/")[0], allowed, f"{path.relative_to(ROOT)} includes {name}")
        self.assertGreater(seen, 100)

    def test_a_module_links_only_modules_above_its_own(self):
        for module in ORDER:
            text = (SOURCES / module / "CMakeLists.txt").read_text(encoding="utf-8")
            used = re.search(r"\bUSES\s+([a-z\s]+)", text)
            for name in used.group(1).split() if used else []:
                self.assertIn(name, ORDER[:ORDER.index(module)], f"{module} uses {name}")

    def test_every_source_file_is_built(self):
        for module in ORDER:
            text = (SOURCES / module / "CMakeLists.txt").read_text(encoding="utf-8")
            for path in (SOURCES / module).rglob("*.cpp"):
                self.assertIn(path.relative_to(SOURCES / module).as_posix(), text)


class Includes(unittest.TestCase):
    """A type counts where one header declares it, outside of any other, and nothing else has its name."""
    NO_CODE = re.compile(r'//[^\n]*|"(?:\\.|[^"\\\n])*"')
    KINDS = r"(?:enum class|struct|class|using) "
    OUTER = re.compile(rf"^{KINDS}([A-Z]\w*)\b(?! *;| : \w+::\w+;)", re.MULTILINE)
    INNER = re.compile(rf"^ +{KINDS}([A-Z]\w*)\b", re.MULTILINE)
    NAMED = re.compile(r"(?<![\w.:])(?<!->)[A-Z]\w*")
    FORWARD = re.compile(rf"^{KINDS}([A-Z]\w*)(?: : [\w:]+)?;|<class ([A-Z]\w*)|, class ([A-Z]\w*)", re.MULTILINE)

    def setUp(self):
        self.texts = {path.relative_to(SOURCES).as_posix(): self.NO_CODE.sub("", path.read_text(encoding="utf-8")) for path in source_files(SOURCES)}
        declared = [(word, name) for name, text in self.texts.items() for word in self.OUTER.findall(text)]
        often = Counter(word for word, _ in declared)
        inner = {word for text in self.texts.values() for word in self.INNER.findall(text)}
        self.home = {word: name for word, name in declared if name.endswith(".h") and often[word] == 1 and word not in inner}
        self.included = {name: {included for _, included in includes(SOURCES / name)} for name in self.texts}
        self.assertGreater(len(self.home), 200)

    def missing(self, name, known):
        own = {word for words in self.FORWARD.findall(self.texts[name]) for word in words}
        named = set(self.NAMED.findall(self.texts[name])) & self.home.keys() - own
        return {word: self.home[word] for word in named if self.home[word] not in known}

    def test_a_header_includes_what_declares_the_types_that_it_names(self):
        for name in (name for name in self.texts if name.endswith(".h")):
            self.assertEqual(self.missing(name, self.included[name] | {name}), {}, f"{name} should include these")

    def test_a_source_file_or_its_header_includes_what_declares_the_types_that_it_names(self):
        for name in (name for name in self.texts if name.endswith(".cpp")):
            known = self.included[name].union(*(self.included[header] for header in self.headers_of(name)))
            self.assertEqual(self.missing(name, known), {}, f"{name} should include these")

    def headers_of(self, source):
        """That of its name, or, where there is none, those of its folder that it includes: one of them declares what it defines."""
        own = source.replace(".cpp", ".h")
        folder = source.rpartition("/")[0]
        return [own] if own in self.texts else [name for name in self.included[source] if name in self.texts and name.rpartition("/")[0] == folder]


class Libraries(unittest.TestCase):
    def test_occt_stops_where_it_is_needed(self):
        for module in ORDER:
            for path in source_files(SOURCES / module):
                if any(name.endswith(".hxx") for _, name in includes(path)):
                    allowed = KNOW_OCCT if path.suffix == ".cpp" else SHOW_OCCT
                    self.assertIn(module, allowed, f"{path.relative_to(ROOT)} includes OCCT")

    def test_cgal_is_seen_by_source_files_only(self):
        for path in source_files(SOURCES):
            if any(name.startswith("CGAL/") for _, name in includes(path)):
                self.assertEqual(path.suffix, ".cpp", path.relative_to(ROOT))
                self.assertIn(path.relative_to(SOURCES).parts[0], KNOW_CGAL, path.relative_to(ROOT))

    def test_catch2_is_seen_through_the_header_for_both_its_versions(self):
        folder = ROOT / "tests" / "cpp"
        names = {path.relative_to(folder).as_posix() for path in source_files(folder) for _, name in includes(path) if name.startswith("catch2/")}
        self.assertEqual(names, {"catch.h", "main.cpp"})

    def test_the_engine_knows_nothing_of_python_and_freecad(self):
        for path in source_files(SOURCES):
            for _, name in includes(path):
                self.assertFalse(name.startswith(("pybind11/", "Python.h", "App/", "Base/")), f"{path.relative_to(ROOT)} includes {name}")


class DesignNotes(unittest.TestCase):
    def test_names_in_them_exist(self):
        folders = ("src", "bindings", "tests", "resources", "Mod")
        paths = [path for folder in folders for path in (ROOT / folder).rglob("*") if path.suffix in (".h", ".cpp", ".py")]
        known = {path.stem for path in paths} | {f"test_{module}" for module in ORDER}
        known.update(*(NAME.findall(path.read_text(encoding="utf-8")) for path in paths))
        seen = 0
        for note in sorted((ROOT / "docs" / "design").glob("*.md")):
            for quoted in re.findall(r"`([A-Za-z_][\w/.:]*)`", note.read_text(encoding="utf-8")):
                name = NAME.findall(quoted)[-1]
                if "_" in name and not name.startswith(KERNEL_NAMES):
                    seen += 1
                    self.assertTrue(name in known, f"{note.name} speaks of {name}")
        self.assertGreater(seen, 50)

    def test_files_in_them_exist(self):
        files = {str(path.relative_to(ROOT).with_suffix("")) for folder in ("src", "tests") for path in (ROOT / folder).rglob("*")}
        seen = 0
        for note in sorted((ROOT / "docs" / "design").glob("*.md")):
            for quoted in re.findall(r"`((?:src/|tests/cpp/)?(?:%s)/[\w/]+)(?:\.h|\.cpp)?`" % "|".join(ORDER), note.read_text(encoding="utf-8")):
                seen += 1
                self.assertTrue(quoted in files or "src/" + quoted in files, f"{note.name} speaks of {quoted}")
        self.assertGreater(seen, 20)


class UsersGuide(unittest.TestCase):
    def test_a_script_draws_each_of_its_pictures_and_none_is_left_over(self):
        scripts = "".join((ROOT / "tests" / "python" / name).read_text(encoding="utf-8") for name in ("draw_guide.py", "drive_first_use.py"))
        shown = re.findall(r"\(pictures/([\w/]+)\.jpg\)", (ROOT / "docs" / "user-guide.md").read_text(encoding="utf-8"))
        self.assertGreater(len(shown), 20)
        self.assertEqual([picture for picture in shown if '"%s"' % Path(picture).name not in scripts], [])
        there = {str(path.relative_to(ROOT / "docs" / "pictures").with_suffix("")) for path in (ROOT / "docs" / "pictures").rglob("*.jpg")}
        self.assertEqual(there - set(shown), {"kept"})   # that of the README, by `./featuremesh demo`


class Vocabulary(unittest.TestCase):
    """The noun of a type's name is its last word, but for names such as MadeFor, Filled and CellsBefore."""
    TYPE = re.compile(r"^(?:enum class|struct|class) (?:alignas\(\d+\) )?([A-Z]\w*)\b[^;{]*\{", re.MULTILINE)
    NO_NOUN = {"for", "of", "by", "before", "filled", "owned", "mid", "delaunay"}

    def test_has_the_nouns_of_all_headers(self):
        rows = re.findall(r"^\| ([^|]+) \|", (ROOT / "docs" / "vocabulary.md").read_text(encoding="utf-8"), re.MULTILINE)
        known = {singular(word) for row in rows for word in re.findall("[a-z]+", row.lower())} | self.NO_NOUN
        types = {name for path in SOURCES.rglob("*.h") for name in self.TYPE.findall(path.read_text(encoding="utf-8"))}
        self.assertGreater(len(types), 200)
        self.assertEqual([name for name in sorted(types) if singular(re.findall("[A-Z][a-z]*", name)[-1].lower()) not in known], [])


def singular(word):
    return word[:-3] + "y" if word.endswith("ies") else word[:-1] if word.endswith("s") and not word.endswith("ss") else word


class Workbench(unittest.TestCase):
    def test_the_model_side_imports_nothing_of_the_window(self):
        files = [path for path in WORKBENCH.rglob("*.py") if path.name not in WINDOW_FILES
                 and not WINDOW_FOLDERS & set(path.relative_to(WORKBENCH).parts)]
        self.assertGreater(len(files), 8)
        for path in files:
            for name in imported_names(path):
                self.assertNotIn(name.split(".")[0], WINDOW_MODULES, f"{path.relative_to(ROOT)} imports {name}")


    def test_it_starts_where_there_is_nothing_of_what_unix_alone_has(self):
        for start in ("api.py", "gui/start.py"):
            files = loaded_with(WORKBENCH / start)
            self.assertGreater(len(files), 50)
            for path in files:
                names = {alias.name for node in ast.parse(path.read_text(encoding="utf-8")).body if isinstance(node, ast.Import) for alias in node.names}
                self.assertFalse(names & {"fcntl", "resource", "pwd", "grp", "termios"}, path.relative_to(ROOT))

    def test_what_differs_between_versions_of_freecad_is_in_one_module(self):
        for path in WORKBENCH.rglob("*.py"):
            if path.name != "versions.py":
                text = path.read_text(encoding="utf-8")
                for words in ("FreeCAD.Version(", "version() <", "version() >", "hasattr(Gui", "hasattr(FreeCAD"):
                    self.assertNotIn(words, text, f"{path.relative_to(ROOT)}: versions.py should tell")


class TopLevel(unittest.TestCase):
    NAMES = {".ci", ".clang-format", ".clang-tidy", ".flake8", ".github", ".gitignore", "CHANGELOG.md", "CMakeLists.txt", "CMakePresets.json", "LICENSE", "Mod", "README.md",
             "bindings", "docs", "featuremesh", "pyproject.toml", "resources", "src", "tests"}

    @unittest.skipUnless(shutil.which("git") and (ROOT / ".git").exists(), "needs a clone")
    def test_nothing_was_committed_there_by_mistake(self):
        done = subprocess.run(["git", "-C", str(ROOT), "ls-files"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        if done.returncode:
            self.skipTest(done.stderr)   # a clone of somebody else's
        self.assertEqual({name.split("/")[0] for name in done.stdout.splitlines()}, self.NAMES)


class Style(unittest.TestCase):
    def test_every_file_names_its_licence(self):
        folders = ("src", "bindings", "tests", "resources", "Mod")
        for path in (path for folder in folders for path in (ROOT / folder).rglob("*")):
            if path.suffix in (".h", ".cpp", ".py") or path.name == "CMakeLists.txt":
                self.assertIn("SPDX-License-Identifier: GPL-3.0-or-later", path.read_text(encoding="utf-8")[:200], path.relative_to(ROOT))

    def test_no_file_grows_beyond_600_lines(self):
        for folder in ("src", "bindings", "tests", "resources", "Mod"):
            for path in (ROOT / folder).rglob("*"):
                if path.suffix in (".h", ".cpp", ".py"):
                    self.assertLessEqual(len(path.read_text(encoding="utf-8").splitlines()), 600, path.relative_to(ROOT))


if __name__ == "__main__":
    unittest.main()

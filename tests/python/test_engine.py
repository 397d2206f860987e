# SPDX-License-Identifier: GPL-3.0-or-later
"""Which engine is found and taken, and what is said about one that cannot be used."""
import importlib.machinery
import os
import shutil
import sys
import tempfile
import unittest
from unittest import mock

import FreeCAD
from freecad.featuremesh import engine, engine_places, worker
from freecad.featuremesh.errors import EngineMissing

OURS = engine_places.file_in(engine.folder())
FILE_NAME = os.path.basename(OURS)
OTHERS = os.environ["FEATUREMESH_OTHER_ENGINES"]


class Engines(unittest.TestCase):
    """Folders of engines in a folder whose name has a space and umlauts; nothing else is looked at."""

    def setUp(self):
        self.root = os.path.join(tempfile.mkdtemp(), "Über uns, größer")
        self.addCleanup(shutil.rmtree, os.path.dirname(self.root))
        os.makedirs(self.root)
        environment = {name: value for name, value in os.environ.items() if name != "FEATUREMESH_ENGINE"}
        self.patch(mock.patch.dict(os.environ, environment, clear=True))
        self.patch(mock.patch.object(engine_places, "folders", lambda: [entry.path for entry in sorted(os.scandir(self.root), key=lambda e: e.name)]))
        self.patch(mock.patch.object(engine, "_place", None))
        engine.run_in_worker()
        self.addCleanup(engine.run_here)
        self.warnings = []
        console = mock.Mock(wraps=FreeCAD.Console, PrintWarning=self.warnings.append)
        self.patch(mock.patch.object(engine.FreeCAD, "Console", console))

    def patch(self, patcher):
        patcher.start()
        self.addCleanup(patcher.stop)

    def put(self, folder, source=OURS, name=FILE_NAME, version=None):
        """A folder with a copy of an engine, and what tells its version."""
        place = os.path.join(self.root, folder)
        os.makedirs(place)
        shutil.copy(source, os.path.join(place, name))
        if version:
            os.makedirs(os.path.join(place, "featuremesh_engine-%s.dist-info" % version))
        return place

    def refused(self):
        with self.assertRaises(EngineMissing) as caught:
            engine.load()
        return str(caught.exception)

    def test_it_is_found_and_says_what_it_is(self):
        place = self.put("a", version="0.1.0")
        self.assertEqual(engine.folder(), place)
        said = engine.about()
        self.assertEqual(said["protocol"], engine.NEWEST_PROTOCOL)
        for name in ("version", "occt", "cgal", "tbb"):
            self.assertRegex(said[name], r"^\d+\.\d+")
        self.assertEqual(self.warnings, [])

    def test_the_newest_is_taken_and_said(self):
        self.put("a", version="0.9.0")
        newer = self.put("b", version="0.10.0")
        self.put("c")
        self.assertEqual(engine.folder(), newer)
        self.assertRegex("".join(self.warnings), r"newest, 0\.10\.0 in .*0\.9\.0 in")
        engine.folder()
        self.assertEqual(len(self.warnings), 1)

    def test_the_one_that_is_named_comes_first(self):
        self.put("a", version="9.0.0")
        named = self.put("b")
        with mock.patch.dict(os.environ, FEATUREMESH_ENGINE=named):
            self.assertEqual(engine.folder(), named)
        self.assertEqual(self.warnings, [])

    def test_one_of_another_python(self):
        self.put("a", name="featuremesh_engine.cpython-38-x86_64-linux-gnu.so")
        self.put("b", name="featuremesh_engine.cp37-win_amd64.pyd")
        message = self.refused()
        self.assertIn("not installed for Python %d.%d" % sys.version_info[:2], message)
        self.assertRegex(message, "is for Python 3.8.*is for Python 3.7")
        self.assertRegex(message, "pip install .*portable zip")

    def test_a_broken_one(self):
        place = self.put("a")
        with open(os.path.join(place, FILE_NAME), "r+b") as file:
            file.truncate(4000)
        os.makedirs(os.path.join(place, "featuremesh_engine.libs"))
        self.assertRegex(self.refused(), "(?s)could not be loaded.*To install it anew: .*pip install")

    def test_a_broken_one_in_the_own_process(self):
        place = self.put("a")
        with open(os.path.join(place, FILE_NAME), "w", encoding="utf-8") as file:
            file.write("half a download")
        engine.run_here()
        with mock.patch.dict(sys.modules):
            sys.modules.pop("featuremesh_engine", None)
            self.assertRegex(self.refused(), "(?s)could not be loaded.*To install it anew: .*pip install")

    def test_one_that_is_too_old_or_too_new(self):
        self.put("a", source=os.path.join(OTHERS, "older", FILE_NAME), version="0.0.1")
        self.assertRegex(self.refused(), "engine older in .* is too old for FeatureMesh .*pip install --upgrade")
        shutil.rmtree(os.path.join(self.root, "a"))
        engine.run_here()
        engine.run_in_worker()
        self.put("b", source=os.path.join(OTHERS, "newer", FILE_NAME), version="9.0.0")
        self.assertRegex(self.refused(), "engine newer in .* is too new for FeatureMesh .*Addon manager")

    def test_without_numpy(self):
        self.put("a")
        blocked = os.path.join(self.root, "blocked")
        os.makedirs(blocked)
        with open(os.path.join(blocked, "numpy.py"), "w", encoding="utf-8") as file:
            file.write("raise ImportError(\"No module named 'numpy'\")\n")
        with mock.patch.dict(os.environ, PYTHONPATH=blocked), self.assertRaisesRegex(worker.CannotStart, "No module named 'numpy'"):
            worker.WorkerEngine(engine.folder()).start()

    def test_one_with_its_own_libraries_runs_in_a_process_of_its_own(self):
        engine.run_here()
        place = self.put("a")
        os.makedirs(os.path.join(place, "featuremesh_engine.libs"))
        self.assertIsInstance(engine.load(), worker.WorkerEngine)
        self.assertTrue(engine.runs_in_worker())
        with mock.patch.object(worker, "interpreters", lambda: ["/bin/false"]):
            engine.run_here()
            self.assertRegex(self.refused(), "could not be loaded")


class FileNames(unittest.TestCase):

    def test_are_those_that_this_python_imports(self):
        for name in engine_places.FILE_NAMES:
            self.assertIn(name[len("featuremesh_engine"):], importlib.machinery.EXTENSION_SUFFIXES)

    def test_versions_are_compared_by_number(self):
        versions = ["0.10.0", "0.9.9", "1.0", "0.9"]
        self.assertEqual(sorted(versions, key=engine_places.number_of), ["0.9", "0.9.9", "0.10.0", "1.0"])

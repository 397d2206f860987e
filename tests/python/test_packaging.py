# SPDX-License-Identifier: GPL-3.0-or-later
"""What the launcher installs and packs: the addon in FreeCAD's folder, packages, and wheels of which Pythons. Runs in plain Python."""
import os
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "resources" / "launcher"))

import addon  # noqa: E402
import commands  # noqa: E402
import freecad_roots  # noqa: E402
import packages  # noqa: E402
import wheels  # noqa: E402
from layout import Failure, Unavailable, UserError  # noqa: E402


class AddOn(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name) / "Mod"
        self.folder.mkdir()
        build = Path(temporary.name) / "build"
        (build / "bindings").mkdir(parents=True)
        (build / "bindings" / "featuremesh_engine.so").write_bytes(b"engine")
        patched = mock.patch.object(addon, "RELEASE", build)
        patched.start()
        self.addCleanup(patched.stop)

    def test_installed_twice_and_removed(self):
        for _ in range(2):
            target = addon.install_into(self.folder)
            self.assertTrue((target / addon.OURS).is_file())
            self.assertEqual((target / "featuremesh_engine.so").read_bytes(), b"engine")
            self.assertEqual([path.name for path in self.folder.iterdir()], ["FeatureMesh"])
        addon.remove_from(self.folder)
        self.assertEqual(list(self.folder.iterdir()), [])
        with self.assertRaisesRegex(UserError, "not installed"):
            addon.remove_from(self.folder)

    def test_a_folder_of_somebody_else_stays(self):
        (self.folder / "FeatureMesh").mkdir()
        for act in (addon.install_into, addon.remove_from):
            with self.assertRaisesRegex(UserError, "not an installed FeatureMesh"):
                act(self.folder)
        self.assertTrue((self.folder / "FeatureMesh").is_dir())


class Packages(unittest.TestCase):
    def test_without_what_makes_them_they_cannot_be_had(self):
        with mock.patch.object(packages, "install_missing"), mock.patch.object(wheels, "fetch_tools", side_effect=Failure("no network")):
            with self.assertRaisesRegex(Unavailable, "what makes packages cannot be had here: no network"):
                commands.package(mock.Mock(python=[]))

    def test_a_root_without_network_must_be_allowed(self):
        with mock.patch.object(packages, "install_missing"), mock.patch.object(packages, "root_prefix", return_value=[]), \
                mock.patch.object(freecad_roots, "run_logged", side_effect=Failure("not permitted")) as run:
            with self.assertRaisesRegex(Unavailable, "not permitted"):
                freecad_roots.run_in_users_root("0.20", ["true"])
        self.assertIn("--net", run.call_args[0][0])


class Pythons(unittest.TestCase):
    """Of which wheels are made. The folder has no headers of Debian's."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for name, value in (("TOOLS", self.folder / "tools"), ("SYSTEM_HEADERS", self.folder / "system")):
            patcher = mock.patch.object(wheels, name, value)
            patcher.start()
            self.addCleanup(patcher.stop)
        environment = mock.patch.dict(os.environ, PATH="", PYENV_ROOT=str(self.folder / "pyenv"))
        environment.start()
        self.addCleanup(environment.stop)

    def put_headers(self, folder):
        (self.folder / folder).mkdir(parents=True)
        (self.folder / folder / "Python.h").write_text("", encoding="utf-8")

    def put_interpreter(self, name, version, headers):
        program = self.folder / name
        program.parent.mkdir(parents=True, exist_ok=True)
        program.write_text(f"#!/bin/sh\necho {version} {self.folder / headers}\n", encoding="utf-8")
        program.chmod(0o755)
        return str(program)

    def test_headers_of_testing_and_of_this_machine(self):
        self.put_headers("tools/usr/include/python3.13")
        self.put_headers("system/python3.11")
        self.put_headers("system/python3.9")
        self.assertEqual(wheels.pythons([]), [wheels.Python("3.11", (str(self.folder / "system/python3.11"),)),
                                              wheels.Python("3.13", (str(self.folder / "tools/usr/include/python3.13"), str(self.folder / "tools/usr/include")))])

    def test_interpreters_that_pyenv_keeps_fill_gaps(self):
        self.put_headers("system/python3.11")
        self.put_headers("own")
        for version in ("3.9", "3.11", "3.12"):
            self.put_interpreter(f"pyenv/versions/{version}.7/bin/python3", version, "own")
        self.put_interpreter("pyenv/versions/3.10.1/bin/python3", "3.10", "no headers there")
        self.assertEqual([(python.version, Path(python.headers[0]).name) for python in wheels.pythons([])], [("3.11", "python3.11"), ("3.12", "own")])

    def test_one_that_is_named_comes_first_and_must_have_headers(self):
        self.put_headers("system/python3.12")
        self.put_headers("named")
        named = self.put_interpreter("python", "3.12", "named")
        self.assertEqual(wheels.pythons([named]), [wheels.Python("3.12", (str(self.folder / "named"),))])
        for program in (self.put_interpreter("old", "3.8", "named"), self.put_interpreter("bare", "3.12", "nothing"), "/nonexistent"):
            with self.assertRaisesRegex(Failure, "is no Python 3.10 to 3.14 with headers"):
                wheels.pythons([program])


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""The launcher as a user meets it, and the set-up's parts that need neither root nor a network. Runs in plain Python."""
import contextlib
import datetime
import fcntl
import io
import json
import os
import shutil
import signal
import stat
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[2]
LAUNCHER = ROOT / "featuremesh"
sys.path.insert(0, str(ROOT / "resources" / "launcher"))

import cgal_headers  # noqa: E402
import commands  # noqa: E402
import ctest  # noqa: E402
import engine_build  # noqa: E402
import freecad_roots  # noqa: E402
import freecad_task  # noqa: E402
import packages  # noqa: E402
import setup_log  # noqa: E402
import study_commands  # noqa: E402
import tidy  # noqa: E402
from arguments import parse  # noqa: E402
from layout import RELEASE, Failure, Unavailable, UserError  # noqa: E402


def run(*words):
    return subprocess.run([str(LAUNCHER), *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def is_running(process):
    """A process that ended may still wait for whoever has to hear of it."""
    try:
        return Path(f"/proc/{process}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


class CommandLine(unittest.TestCase):
    def test_help_explains_each_command(self):
        shown = run("--help")
        self.assertEqual(shown.returncode, 0)
        for command in ("demo", "test", "mesh", "update", "diff", "tree", "export", "gui", "bench", "install", "uninstall"):
            self.assertRegex(shown.stdout, rf"\n    {command} +[a-z]")
            self.assertEqual(run(command, "--help").returncode, 0)

    def test_no_document_is_overwritten_by_what_is_none(self):
        for words in (("mesh", __file__, "--json", "part.FCStd"), ("export", __file__, "--format", "inp", "part.FCStd"), ("picture", __file__, "--out", "part.fcstd"),
                      ("diff", __file__, __file__, "--picture", "part.FCStd")):
            done = run(*words)
            self.assertEqual(done.returncode, 2)
            self.assertRegex(done.stderr, "part.FCStd|part.fcstd is the name of a document, which this would overwrite")
        done = run("mesh", __file__, "--out", "part.step")
        self.assertEqual((done.returncode, done.stderr), (2, "featuremesh mesh: part.step: the name of a document ends in .FCStd\n"))

    def test_lengths_may_have_their_unit(self):
        for text in ("2.5", "2.5mm", " 2.5 mm"):
            self.assertEqual(parse(["mesh", "part.FCStd", "--size", text, "--ignore-below", text]).size, 2.5)
            self.assertEqual(parse(["mesh", "part.FCStd", "--ignore-below", text]).ignore_below, 2.5)
            self.assertEqual(parse(["solve", "part.FCStd", "--accuracy", text.replace("mm", "%")]).accuracy, 0.025)

    def test_what_cannot_be_written_is_refused_before_the_work(self):
        with mock.patch.object(commands.os, "access", lambda path, mode: False), mock.patch.object(commands, "set_up", self.fail):
            for words, message in ((("mesh", __file__), "test_launcher.py: nothing can be written to its folder; name another document with --out"),
                                   (("transfer", __file__), "nothing can be written to its folder"),
                                   (("mesh", __file__, "--out", "part.FCStd"), "part.FCStd: nothing can be written to the folder %s; name another one" % os.getcwd()),
                                   (("export", __file__, "--format", "inp", "part.inp"), "part.inp: nothing can be written to the folder"),
                                   (("demo", "--out", "shown"), "shown: nothing can be written to the folder")):
                given = parse(list(words))
                with self.subTest(words=words), self.assertRaisesRegex(UserError, message):
                    given.run(given)

    def test_no_window_is_installed_where_there_is_no_screen(self):
        given = parse(["gui"])
        with mock.patch.dict(os.environ), mock.patch.object(commands, "set_up", self.fail):
            for name in ("DISPLAY", "WAYLAND_DISPLAY"):
                os.environ.pop(name, None)
            self.assertRaisesRegex(UserError, "there is no screen", given.run, given)

    def test_a_folder_that_is_gone_is_said(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(["sh", "-c", f"mkdir gone; cd gone; rmdir ../gone; exec {LAUNCHER} about 2>&1 | tail -n 1"], cwd=folder, stdout=subprocess.PIPE, text=True)
        self.assertEqual(done.stdout, "featuremesh: the folder that it was started in is gone; change to another one\n")

    def test_the_version_is_told(self):
        done = run("--version")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"^FeatureMesh \d+\.\d+\.\d+$")

    def test_wrong_use_is_the_users_error_in_one_line(self):
        for words in ((), ("mesh",), ("mesh", "no_such.FCStd"), ("mesh", __file__, "--size", "0"), ("mesh", __file__, "--size", "-1"),
                      ("mesh", __file__, "--size", "nan"), ("mesh", __file__, "--size", "inf"), ("mesh", __file__, "--order", "3"), ("mesh", __file__, "--threads", "0"),
                      ("update", "no_such.FCStd", "--set", "A.B=1"), ("diff", __file__), ("export", __file__, "out.vtu"),
                      ("mesh", __file__, "--out", "no/such/folder/out.FCStd"), ("mesh", __file__, "--out", str(ROOT)), ("mesh", __file__, "--json", "."),
                      ("mesh", str(ROOT)), ("mesh", __file__, "--size", "2,5"), ("study", "run", __file__, "--size", "2 m"), ("demo", "--out", __file__),
                      ("mesh", __file__, "--ignore-below", "little"), ("mesh", __file__, "--ignore-below", "0"), ("solve", __file__, "--accuracy", "100 %"),
                      ("test", "--freecad", "0.12"), ("bench", "--documents", __file__), ("bench", "--documents", "no/such/folder"),
                      ("bench", "--documents", str(ROOT), "--divisor", "0"), ("bench", "--documents", str(ROOT), "--edits", "-1"), ("nothing",)):
            with self.subTest(words=words):
                done = run(*words)
                self.assertEqual(done.returncode, 2)
                self.assertEqual(done.stdout, "")
                self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
                self.assertNotIn("Traceback", done.stderr)

    def test_an_error_from_within_freecad_begins_as_any_other(self):
        done = run("tree", __file__)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertRegex(done.stderr, r"^featuremesh tree: .*test_launcher\.py.*\n$")

    def test_what_a_mesh_is_asked_for_reaches_its_task(self):
        asked = {}
        with mock.patch.object(commands, "set_up"), mock.patch.object(commands, "run_task", lambda task: asked.update(task) or {"exit_code": 0, "message": "", "data": {}}):
            given = parse(["mesh", __file__, "--size", "3", "--order", "1", "--dimension", "faces", "--ignore-below", "0.05", "--object", "Plate"])
            given.run(given)
        wanted = {"size": 3, "order": 1, "dimension": "faces", "ignore_below": 0.05, "object": "Plate"}
        self.assertEqual({name: asked.get(name) for name in wanted}, wanted)

    def test_each_command_of_a_mesh_takes_the_object_that_it_is_of(self):
        asked = {}
        for words in (("mesh",), ("update",), ("renumber",), ("picture",), ("adopt", "--mesh", "Other"), ("export", "--format", "inp", "out.inp"), ("transfer",)):
            with self.subTest(words=words), mock.patch.object(commands, "set_up"), \
                    mock.patch.object(commands, "run_task", lambda task: asked.update(task) or {"exit_code": 0, "message": "", "data": {}}):
                given = parse([words[0], __file__, *words[1:], "--object", "Plate"])
                asked.clear()
                given.run(given)
                self.assertEqual(asked["object"], "Plate")

    def test_a_folder_in_a_command_to_type_is_one_word(self):
        self.assertEqual(study_commands.typed_path(str(Path.cwd() / "plate-study")), "plate-study")
        folder = "/of Anna's part/$HOME"
        typed = subprocess.run(["sh", "-c", f"printf %s {study_commands.typed_path(folder)}"], stdout=subprocess.PIPE, text=True, check=True).stdout
        self.assertEqual(typed, folder)

    def test_a_reader_that_has_seen_enough_is_no_error_to_tell_of(self):
        for words in (("--help",), ("bench", "--list")):
            with self.subTest(words=words):
                reader, writer = os.pipe()
                os.close(reader)
                done = subprocess.run([str(LAUNCHER), *words], stdout=writer, stderr=subprocess.PIPE, text=True)
                os.close(writer)
                self.assertEqual((done.returncode, done.stderr), (1, ""))

    def test_ctrl_c_while_python_starts_is_answered_by_the_launcher(self):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "sitecustomize.py").write_text("import os, signal\nos.kill(os.getpid(), signal.SIGINT)\n", encoding="utf-8")
            done = subprocess.run([str(LAUNCHER), "--help"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env={**os.environ, "PYTHONPATH": folder})
        self.assertEqual((done.returncode, done.stdout, done.stderr), (130, "", "\nfeaturemesh: cancelled\n"))

    def test_warnings_follow_the_message_on_standard_error(self):
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            code = commands.finish({"exit_code": 0, "message": "done", "data": {"warnings": ["Face3 is thin", "Edge1 is short"]}})
        self.assertEqual((code, out.getvalue(), err.getvalue()), (0, "done\n", "warning: Face3 is thin\nwarning: Edge1 is short\n"))


class FreecadTask(unittest.TestCase):
    """The launcher's side of a task, with other programs in FreeCAD's place."""

    def run_with(self, script_text, **arguments):
        with tempfile.TemporaryDirectory() as folder:
            program = Path(folder) / "freecadcmd"
            program.write_text("#!/bin/sh\n" + script_text, encoding="utf-8")
            program.chmod(program.stat().st_mode | stat.S_IXUSR)
            with mock.patch.dict(os.environ, FREECADCMD=str(program)), \
                    mock.patch.object(freecad_task, "FREECAD_LOG", Path(folder) / "freecad.log"):
                return freecad_task.run_script("script.py", {"FEATUREMESH_TASK": "{}"}, **arguments)

    def test_the_result_file_is_the_answer(self):
        answer = {"exit_code": 2, "message": "no", "data": {"a": [1]}}
        self.assertEqual(self.run_with(f"echo '{json.dumps(answer)}' > $FEATUREMESH_RESULT; exit 7"), answer)

    def test_a_crash_is_told_with_its_signal_and_the_logs_end(self):
        with self.assertRaisesRegex(Failure, r"(?s)SIGSEGV.*no file was changed.*last words"):
            self.run_with("echo last words >&2; kill -SEGV $$")

        with self.assertRaisesRegex(Failure, "SIGKILL; perhaps memory ran out"):
            self.run_with("kill -KILL $$")

    def test_temporary_files_are_gone_afterwards_and_have_a_folder_in_any_case(self):
        with mock.patch.dict(os.environ, TMPDIR="/no/such/folder"), mock.patch.object(tempfile, "tempdir", None):
            made = self.run_with("""echo "{\\"path\\": \\"$FREECAD_USER_TEMP\\"}" > $FEATUREMESH_RESULT; touch $TMPDIR/left $FREECAD_USER_TEMP/left""")["path"]
            self.assertFalse(os.path.exists(made))
            self.assertEqual(freecad_task.freecad_environment()["TMPDIR"], tempfile.gettempdir())
            self.assertTrue(made.startswith(tempfile.gettempdir()))

    def test_what_keeps_freecad_from_telling_or_starting_is_said(self):
        with mock.patch.dict(os.environ, FREECADCMD="/no/such/program"), self.assertRaisesRegex(Failure, "FREECADCMD is set to /no/such/program"):
            freecad_task.freecadcmd()
        with mock.patch.dict(os.environ, FREECAD="/no/such/program", DISPLAY=":0"), mock.patch.object(commands, "set_up"), self.assertRaisesRegex(Failure, "set FREECAD"):
            commands.gui(parse(["gui"]))
        with self.assertRaisesRegex(Failure, "no room in the folder for temporary files"):
            self.run_with("exit 4")
        with mock.patch.dict(os.environ, HOME="/no/such/home"), self.assertRaisesRegex(Failure, "nothing can be written to /no/such/home: set HOME"):
            os.environ.pop("FREECAD_USER_HOME", None)
            self.run_with("exit 1")

    def test_ctrl_c_leaves_the_window_open(self):
        """FreeCAD would end with all that is not saved."""
        self.addCleanup(signal.signal, signal.SIGINT, signal.getsignal(signal.SIGINT))
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stderr(io.StringIO()) as shown, contextlib.redirect_stdout(io.StringIO()):
            program = Path(folder) / "freecad"
            program.write_text(f"#!/bin/sh\nkill -INT {os.getpid()}; sleep 0.3; [ $(cut -d' ' -f6 /proc/$$/stat) = $$ ]", encoding="utf-8")
            program.chmod(0o755)
            with mock.patch.dict(os.environ, FREECAD=str(program), DISPLAY=":0"), mock.patch.object(commands, "set_up"):
                self.assertEqual(commands.gui(parse(["gui"])), 0)
        self.assertIn("FreeCAD stays open", shown.getvalue())

    def test_a_log_that_cannot_be_kept_is_no_failure(self):
        with mock.patch.object(shutil, "copyfile", side_effect=PermissionError):
            self.assertEqual(self.run_with("echo '{}' > $FEATUREMESH_RESULT"), {})

    def test_each_of_two_runs_tells_the_end_of_its_own_log(self):
        with tempfile.TemporaryDirectory() as folder:
            started, ready = (Path(folder) / name for name in ("started", "ready"))
            os.mkfifo(started)
            os.mkfifo(ready)
            said = []

            def first():
                try:
                    self.run_with(f"echo of the first >&2; echo > {started}; cat {ready}; exit 0")
                except Failure as failure:
                    said.append(str(failure))
            thread = threading.Thread(target=first)
            thread.start()
            started.read_text(encoding="utf-8")   # until then the program in FreeCAD's place is the first's
            with self.assertRaisesRegex(Failure, "of the second"):
                self.run_with("echo of the second >&2; exit 0")
            ready.write_text("", encoding="utf-8")
            thread.join()
        self.assertIn("of the first", said[0])
        self.assertNotIn("of the second", said[0])

    def test_an_end_without_result_is_a_failure(self):
        with self.assertRaisesRegex(Failure, "exit code 0"):
            self.run_with("exit 0")

    def test_marked_lines_are_passed_on(self):
        lines = io.StringIO()
        self.run_with("echo noise >&2; echo 'featuremesh: step 1' >&2; echo '{}' > $FEATUREMESH_RESULT", lines_to=lines)
        self.assertEqual(lines.getvalue(), "step 1\n")

    def test_freecad_gets_a_utf8_locale_and_the_engine(self):
        environment = freecad_task.freecad_environment()
        self.assertEqual(environment["LC_ALL"], "C.UTF-8")
        self.assertEqual(environment["FEATUREMESH_ENGINE"], str(RELEASE / "bindings"))
        self.assertTrue(environment["PYTHONPATH"].startswith(str(RELEASE / "bindings")))


class DebianSources(unittest.TestCase):
    ONE_LINE = """
# deb http://old.example/debian buster main
deb [arch=amd64 signed-by=/usr/share/keyrings/other.gpg] https://packages.example/apt stable main
deb-src http://mirror.example/debian bookworm main
deb [ check-valid-until=no ] http://mirror.example/debian bookworm main  # ours
"""
    DEB822 = """Types: deb
# http://snapshot.example/archive
URIs: https://packages.example/apt
Suites: nodistro
Signed-By: /usr/share/keyrings/other.gpg

Types: deb
Enabled: no
URIs: http://switched-off.example/debian
Suites: bookworm

Types: deb deb-src
URIs: http://mirror.example/debian
Suites: bookworm bookworm-updates
Components: main
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg
"""

    def source_with(self, **files):
        with tempfile.TemporaryDirectory() as folder:
            etc = Path(folder)
            (etc / "sources.list.d").mkdir()
            for name, text in files.items():
                place = etc / "sources.list" if name == "main" else etc / "sources.list.d" / name.replace("_", ".")
                place.write_text(text, encoding="utf-8")
            return cgal_headers.debian_source(etc)

    def test_the_machines_own_mirror_is_found_in_either_form(self):
        self.assertEqual(self.source_with(main=self.ONE_LINE),
                         {"uri": "http://mirror.example/debian", "signed_by": "", "check_valid_until": "no"})
        self.assertEqual(self.source_with(debian_sources=self.DEB822),
                         {"uri": "http://mirror.example/debian", "check_valid_until": "",
                          "signed_by": "/usr/share/keyrings/debian-archive-keyring.gpg"})

    def test_without_a_debian_mirror_the_message_says_what_to_do(self):
        with self.assertRaisesRegex(Failure, "no Debian mirror.*build/deps/cgal"):
            self.source_with(main="deb http://archive.example/ubuntu noble main\n")

    def lists_read(self, source, *failures):
        """The apt commands that reading the lists runs, when the first ones fail as given."""
        failures = list(failures)
        commands = []

        def run_logged(command, what):
            commands.append(command)
            if failures:
                raise Failure(failures.pop(0))

        with mock.patch.object(cgal_headers, "run_logged", run_logged), mock.patch.object(cgal_headers, "say"):
            cgal_headers.read_lists(["apt-get"], source)
        return ["Acquire::Check-Valid-Until=false" in command for command in commands]

    def test_only_a_frozen_archive_may_be_out_of_date(self):
        source = self.source_with(debian_sources=self.DEB822)
        self.assertEqual(self.lists_read(source), [False])
        self.assertEqual(self.lists_read({**source, "uri": "http://snapshot.example/archive/debian/20250101T000000Z"}), [True])
        self.assertEqual(self.lists_read({**source, "check_valid_until": "no"}), [True])
        self.assertEqual(self.lists_read(source, "E: Release file for x is expired (invalid since 15d)."), [False, True])
        with self.assertRaisesRegex(Failure, "no key"):
            self.lists_read(source, "no key")

    def test_the_signature_is_always_checked(self):
        line = cgal_headers.testing_line(self.source_with(debian_sources=self.DEB822))
        self.assertEqual(line, "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://mirror.example/debian testing main\n")
        self.assertNotIn("trusted", line)

    def test_the_version_of_unpacked_headers_is_read(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(cgal_headers.version_of(Path(folder)), (0, 0))
            header = Path(folder) / "usr/include/CGAL/version.h"
            header.parent.mkdir(parents=True)
            header.write_text("#define CGAL_VERSION_STR CGAL_STR(CGAL_VERSION)\n#define CGAL_VERSION 6.2.1\n", encoding="utf-8")
            self.assertEqual(cgal_headers.version_of(Path(folder)), (6, 2))


class OtherReleases(unittest.TestCase):
    """Roots of other Debian releases, short of making one."""

    def test_a_root_is_fresh_for_some_days(self):
        now = datetime.datetime(2026, 5, 20, 12)
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            self.assertFalse(freecad_roots.is_fresh(root, now))
            for made, fresh in (("2026-05-20T11:00:00", True), ("2026-05-14T11:00:00", True), ("2026-05-13T11:00:00", False),
                                ("2026-05-20T13:00:00", False), ("yesterday", False)):
                (root / freecad_roots.NOTE).write_text(json.dumps({"made": made}), encoding="utf-8")
                self.assertEqual(freecad_roots.is_fresh(root, now), fresh, made)
            (root / freecad_roots.NOTE).write_text("{", encoding="utf-8")
            self.assertFalse(freecad_roots.is_fresh(root, now))

    def test_the_machines_way_to_its_mirror_is_taken_along(self):
        dump = ('APT "";\nAcquire "";\nAcquire::http "";\nAcquire::http::Proxy "http://proxy.example:8080";\n'
                'Acquire::Check-Valid-Until "false";\nAcquire::IndexTargets::deb::Packages::MetaKey "x";\nDir::Cache "var/cache/apt";\n')
        with mock.patch.object(freecad_roots.subprocess, "run", return_value=mock.Mock(stdout=dump)):
            self.assertEqual(freecad_roots.machine_settings(), ['Acquire::http::Proxy "http://proxy.example:8080";\n',
                                                                'Acquire::Check-Valid-Until "false";\n'])
            self.assertEqual(freecad_roots.debootstrap_proxies(), ["http_proxy=http://proxy.example:8080"])

    def test_the_roots_packages_come_signed_from_the_machines_mirror(self):
        source = {"uri": "http://mirror.example/debian", "signed_by": "", "check_valid_until": ""}
        self.assertEqual(freecad_roots.sources_list("testing", source), "deb http://mirror.example/debian testing main\n")
        self.assertEqual(freecad_roots.sources_list("testing", {**source, "check_valid_until": "no"}),
                         "deb [check-valid-until=no] http://mirror.example/debian testing main\n")

    def test_what_a_release_lacks_comes_from_the_one_before(self):
        source = {"uri": "http://mirror.example/debian", "signed_by": "", "check_valid_until": ""}
        self.assertEqual(freecad_roots.from_before("trixie", source),
                         ("deb http://mirror.example/debian bookworm main", "calculix-ccx libspooles2.2", "libarpack2t64 libopenmpi40"))

    def test_where_there_can_be_no_root_it_is_said_so(self):
        with mock.patch.object(packages, "install_missing", side_effect=Failure("no network")):
            with self.assertRaisesRegex(Unavailable, "no network"):
                freecad_roots.run_in_root("1.1", ["true"])
        with mock.patch.object(packages, "install_missing"), mock.patch.object(packages, "root_prefix", return_value=[]), \
                mock.patch.object(freecad_roots, "run_logged", side_effect=Failure("unshare failed: not permitted")):
            with self.assertRaisesRegex(Unavailable, "not permitted"):
                freecad_roots.run_in_root("1.0", ["true"])

    def test_nobody_waits_for_a_fresh_root(self):
        with mock.patch.object(freecad_roots, "is_fresh", return_value=True), mock.patch.object(freecad_roots, "alone", side_effect=AssertionError), \
                mock.patch.object(freecad_roots, "prepare_machine", return_value=[]), mock.patch.object(freecad_roots, "give_back"), \
                mock.patch.object(freecad_roots, "run_mounted", return_value=7):
            self.assertEqual([freecad_roots.run_in_root("1.1", []), freecad_roots.run_in_users_root("0.20", [])], [7, 7])


class SetUp(unittest.TestCase):
    def test_installed_packages_are_not_missing(self):
        self.assertEqual(packages.missing(["dpkg", "no-such-package-anywhere", "apt"]), ["no-such-package-anywhere"])

    def test_a_package_that_this_debian_lacks_is_left_out_only_where_that_is_known(self):
        policy = "cmake:\n  Installed: (none)\n  Candidate: 3.25\ncalculix-ccx:\n  Candidate: (none)\n"
        with mock.patch.object(packages, "missing", lambda names: list(names)), mock.patch.object(packages, "root_prefix", return_value=[]), \
                mock.patch.object(packages.subprocess, "run", return_value=mock.Mock(stdout=policy)), \
                mock.patch.object(packages, "say"), mock.patch.object(packages, "run_logged") as commands:
            packages.install_missing(("cmake", "calculix-ccx", "unheard-of"))
        self.assertEqual(commands.call_args.args[0][-2:], ["cmake", "unheard-of"])

    def test_two_install_one_after_the_other(self):
        """The second finds that the first has installed what it misses, too."""
        folder, there, installed = Path(self.enterContext(tempfile.TemporaryDirectory())), [], []

        def install(names):
            installed.extend(names)
            time.sleep(0.3)
            there.extend(names)
        with mock.patch.multiple(packages, BUILD=folder, missing=lambda names: [name for name in names if name not in there], install=install):
            others = [threading.Thread(target=packages.install_missing, args=(["cmake"],)) for _ in range(2)]
            for thread in others:
                thread.start()
            for thread in others:
                thread.join()
        self.assertEqual(installed, ["cmake"])

    def test_every_package_has_a_reason(self):
        groups = [group for name, group in vars(packages).items() if name.endswith("_PACKAGES")]
        self.assertEqual({group for group, _ in packages.REASONS}, set(groups))

    def test_without_root_the_missing_packages_are_named(self):
        with mock.patch("os.geteuid", return_value=1000), mock.patch("shutil.which", return_value=None):
            with self.assertRaisesRegex(Failure, "cmake.*root"):
                packages.root_prefix(["cmake"])

    def test_a_changed_source_or_package_changes_the_fingerprint_another_package_does_not(self):
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(packages, "RECORDS", folder), \
                mock.patch.object(engine_build, "source_files", return_value=[Path(folder, "source")]):
            seen = [engine_build.fingerprint(["gmsh"])]
            for name in ("man-db.list", "gmsh.list", "libtbb-dev:amd64.list", "source"):
                Path(folder, name).write_text("more", encoding="utf-8")
                seen.append(engine_build.fingerprint(["gmsh"]))
            self.assertEqual([len(set(seen)), seen[0]], [4, seen[1]])

    def test_what_was_set_up_is_not_set_up_again(self):
        steps = []
        with tempfile.TemporaryDirectory() as folder, contextlib.ExitStack() as patches:
            for module, name, value in ((engine_build, "BUILD", Path(folder)), (engine_build, "RELEASE", Path(folder)),
                                        (packages, "install_missing", lambda wanted: steps.append("install")),
                                        (cgal_headers, "fetch_cgal", lambda: None), (engine_build, "say", lambda line: None),
                                        (engine_build, "build", lambda target: steps.append(f"build {target}"))):
                patches.enter_context(mock.patch.object(module, name, value))
            engine, in_freecad, everything = (["install", f"build {target}"] for target in engine_build.TARGETS)
            for extra, target, expected in (((), engine_build.ENGINE, engine), ((), engine_build.ENGINE, []),
                                            (("more",), engine_build.ENGINE, engine), ((), engine_build.ENGINE, []),
                                            (("other",), engine_build.ENGINE, engine), (("more", "other"), engine_build.ENGINE, []),
                                            ((), engine_build.IN_FREECAD, in_freecad), ((), engine_build.ENGINE, []),
                                            ((), engine_build.ALL, everything), ((), engine_build.IN_FREECAD, []), ((), engine_build.ALL, []),
                                            (("third",), engine_build.ENGINE, everything), ((), engine_build.ALL, [])):
                steps.clear()
                engine_build.set_up(extra, target)
                self.assertEqual(steps, expected)
            (Path(folder) / "setup-stamp.json").write_text("{", encoding="utf-8")
            engine_build.set_up()
            self.assertEqual(steps, engine)

    def test_what_a_build_started_ends_with_the_launcher(self):
        with tempfile.TemporaryDirectory() as folder:
            started = Path(folder) / "started"
            os.mkfifo(started)

            def cancel():
                self.grandchild = int(started.read_text(encoding="utf-8"))
                time.sleep(0.3)   # until the launcher waits for the build
                os.kill(os.getpid(), signal.SIGINT)
            threading.Thread(target=cancel).start()
            with mock.patch.multiple(setup_log, BUILD=Path(folder), SETUP_LOG=Path(folder) / "setup.log"), self.assertRaises(KeyboardInterrupt):
                setup_log.run_logged(["sh", "-c", f"sleep 60 & echo $! > {started}; wait"], "building", start_new_session=True)
        for _ in range(100):
            if not is_running(self.grandchild):
                return
            time.sleep(0.1)
        self.fail("it goes on")

    def stand_in_for_ctest(self, text):
        """A folder with the program in CTest's place, and an environment that finds it."""
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        (folder / "ctest").write_text("#!/bin/sh\n" + text, encoding="utf-8")
        (folder / "ctest").chmod(0o755)
        environment = {**os.environ, "PATH": f"{folder}:{os.environ['PATH']}"}
        self.enterContext(mock.patch.dict(os.environ, environment))
        return folder, environment

    def test_tests_end_with_the_launcher(self):
        folder, environment = self.stand_in_for_ctest("echo $$ > $2/started\necho '1/1 Test  #1: sleeps'\nexec sleep 60\n")
        with mock.patch("builtins.print", side_effect=KeyboardInterrupt), self.assertRaises(KeyboardInterrupt):
            ctest.run(folder, [], environment)
        process = int((folder / "started").read_text(encoding="utf-8"))
        for _ in range(100):
            if not is_running(process):
                return
            time.sleep(0.1)
        os.kill(process, signal.SIGKILL)
        self.fail("they go on")

    def test_only_tests_of_the_window_run_once_more(self):
        """One that fails the first time, one that fails twice, and one that is not of the window."""
        folder, environment = self.stand_in_for_ctest(
            'case "$*" in *" -N "*) echo "  Test  #7: python_live"; exit ;; esac\n'
            'echo "$*" >> $2/calls\nread name times < $2/fails\n[ $(wc -l < $2/calls) -gt $times ] && echo "100% tests passed" && exit\n'
            'printf "The following tests FAILED:\\n\\t  7 - $name (Failed)\\n"\nexit 8\n')
        for fails, calls, word in (("python_live 1", 2, "passed only the second time: python_live"), ("python_live 2", 2, "failed twice"), ("volume 1", 1, "")):
            (folder / "fails").write_text(fails, encoding="utf-8")
            (folder / "calls").unlink(missing_ok=True)
            with contextlib.redirect_stdout(io.StringIO()) as said, contextlib.redirect_stderr(said):
                with contextlib.nullcontext() if word.startswith("passed") else self.assertRaises(Failure):
                    ctest.run(folder, ["-L", "in_freecad"], environment)
            lines = (folder / "calls").read_text(encoding="utf-8").splitlines()
            self.assertEqual(len(lines), calls, said.getvalue())
            self.assertIn(word, said.getvalue())
            self.assertIn("- %s (Failed)" % fails.split()[0], (folder / "ctest.log").read_text(encoding="utf-8"))
            self.assertTrue(calls == 1 or lines[1].endswith("-R ^(python_live)$"), lines)

    def test_only_one_set_up_at_a_time(self):
        steps = []
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(engine_build, "BUILD", Path(folder)), \
                mock.patch.object(engine_build, "say", steps.append):
            def second():
                with engine_build.alone():
                    steps.append("second")

            with engine_build.alone():
                thread = threading.Thread(target=second)
                thread.start()
                thread.join(0.3)
                steps.append("first")
            thread.join(10)
        self.assertEqual(steps, ["waiting for another set-up in this folder", "first", "second"])

    def test_another_may_install_while_the_engine_is_built(self):
        def build(target):
            with open(folder / "setup.lock", "w", encoding="utf-8") as lock:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        (folder / "release").mkdir()
        with mock.patch.multiple(engine_build, BUILD=folder, RELEASE=folder / "release", build=build), \
                mock.patch.object(packages, "install_missing"), mock.patch.object(cgal_headers, "fetch_cgal"):
            engine_build.set_up()

    def test_sources_of_the_engine_are_watched(self):
        watched = {path.relative_to(ROOT).as_posix() for path in engine_build.source_files()}
        self.assertLessEqual({"CMakeLists.txt", "src/core/errors.h", "bindings/CMakeLists.txt"}, watched)


class Tidy(unittest.TestCase):
    """In a repository of its own, with another program in clang-tidy's place."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        (self.root / "src").mkdir()
        for name in ("one.cpp", "two.cpp", "two.h", "three.cpp", "only.h"):
            (self.root / "src" / name).write_text("first\n", encoding="utf-8")
        self.git("init", "--quiet")
        self.commit()
        for patch in (mock.patch.object(tidy, "ROOT", self.root), mock.patch.object(tidy, "CLANG_TIDY", str(self.root / "clang-tidy"))):
            patch.start()
            self.addCleanup(patch.stop)

    def git(self, *words):
        subprocess.run(["git", "-c", "user.name=nobody", "-c", "user.email=nobody", *words], cwd=self.root, check=True)

    def commit(self):
        self.git("add", ".")
        self.git("commit", "--quiet", "-m", "change")

    def change(self, name):
        (self.root / "src" / name).write_text("changed\n", encoding="utf-8")

    def test_what_changed_last_is_looked_at_first(self):
        for name in ("one.cpp", "two.h", "only.h"):
            self.change(name)
            self.commit()
        self.change("three.cpp")
        self.assertEqual([str(path) for path in tidy.sources_to_look_at(tidy.changed_since("HEAD~3"))], ["src/three.cpp", "src/two.cpp", "src/one.cpp"])
        self.assertEqual([str(path) for path in tidy.sources_to_look_at(tidy.changed_since("HEAD"))], ["src/three.cpp"])
        with self.assertRaisesRegex(Unavailable, "git knows no such commit"):
            tidy.changed_since("HEAD~7")

    def test_a_finding_is_told_and_time_that_is_over_is_none(self):
        program = self.root / "clang-tidy"
        program.write_text('#!/bin/sh\n[ "$4" = src/slow.cpp ] && exec sleep 60\n[ "$4" = src/one.cpp ] && echo "one is wrong" && exit 1\nexit 0\n', encoding="utf-8")
        program.chmod(0o755)
        soon, now = time.monotonic() + 60, time.monotonic()
        self.assertEqual(tidy.complaints_about(Path("src/one.cpp"), self.root, soon), "one is wrong\n")
        self.assertEqual(tidy.complaints_about(Path("src/two.cpp"), self.root, float("inf")), "")
        self.assertIsNone(tidy.complaints_about(Path("src/slow.cpp"), self.root, now + 0.5))
        self.assertIsNone(tidy.complaints_about(Path("src/slow.cpp"), self.root, now - 1))


if __name__ == "__main__":
    unittest.main()

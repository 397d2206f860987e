# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of studies that need no FreeCAD: what is read, sampled, kept, concluded. Runs in plain Python."""
import importlib.util
import math
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
from pathlib import Path
from types import SimpleNamespace

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from study_tests import ROOT

from freecad.featuremesh import modes  # noqa: E402
from freecad.featuremesh.errors import UserError  # noqa: E402
from freecad.featuremesh.messages import english  # noqa: E402
from freecad.featuremesh.study import (  # noqa: E402
    answers, case_book, design, memory, optimise, optuna_search, planning, plots, progress, runner, sampling, study_file, surface, worker_process)
from freecad.featuremesh.study.classic_designs import box_behnken, central_composite  # noqa: E402
from freecad.featuremesh.study.database import Database  # noqa: E402
from freecad.featuremesh.study.expressions import Expression  # noqa: E402
from freecad.featuremesh.study.folder import StudyFolder, is_same_study  # noqa: E402
from freecad.featuremesh.study.response_words import KINDS, WORDS, parse_list, parse_response  # noqa: E402

FULL_DISK = """
import resource, signal, sys
sys.path.insert(0, {tests!r})
import study_tests
from freecad.featuremesh.study.database import Database, DiskFull
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (60000, 60000))
database = Database({path!r}, new=True)
try:
    for number in range(10000):
        database.add_cases([({{"x": number}}, None)], "test")
except DiskFull as error:
    print(number, error)
"""


WORKER = """#!{python}
import json, os
said = json.loads(os.environ["FEATUREMESH_STUDY_WORKER"])
os.write(said["answers"], b'{{"ready": 1}}\\n')
for line in os.fdopen(said["requests"]):
    os.write(said["answers"], b'{{"state": "done", "responses": {{"mass": 1.0}}}}\\n')
"""


OPTUNA = (optuna_search.OptunaOptimiser,) if importlib.util.find_spec("optuna") else ()


def study(sampling_name, *parameters, **options):
    return design.Study("part.FCStd", [design.parse_parameter(text) for text in parameters], parse_list("mass"), sampling=sampling_name, **options)


def folder_of(test, asked, integers=()):
    """What a study's folder tells, with an empty database."""
    path = tempfile.mkdtemp()
    test.addCleanup(shutil.rmtree, path)
    database = Database(os.path.join(path, "study.sqlite"), new=True)
    test.addCleanup(database.close)
    return SimpleNamespace(path=path, database=database, study=lambda: design.from_plain(asked.to_plain()), facts=lambda: {"integers": list(integers), "base_values": {}})


def interrupted_after(method):
    """The method, and then Ctrl-C."""
    def call(*arguments):
        method(*arguments)
        raise KeyboardInterrupt
    return call


def finish(folder, cases, mass):
    """Adds the cases, as done; `mass(parameters)` is their response."""
    for case_id in folder.database.add_cases([(parameters, None) for parameters in cases], "test"):
        folder.database.finish(case_id, {"state": "done", "responses": {"mass": mass(folder.database.case(case_id).parameters)}})


class Words(unittest.TestCase):

    def test_parameters(self):
        found = design.parse_parameter("HoleSketch.Hole6X=95:115:5 mm")
        self.assertEqual((found.name, found.bounds, found.levels, found.unit), ("HoleSketch.Hole6X", (95.0, 115.0), 5, "mm"))
        self.assertEqual(found.assignment(95.5), "HoleSketch.Hole6X=95.5 mm")
        self.assertEqual(design.parse_parameter("Pad.Midplane=true,false").values, ["true", "false"])
        listed = design.parse_parameter("Pad.Length=0.5, 0.6 cm")
        self.assertEqual((listed.values, listed.unit, listed.assignment(0.5)), ([0.5, 0.6], "cm", "Pad.Length=0.5 cm"))
        self.assertEqual(design.parse_parameter("Mesh.Order=1st,2nd").values, ["1st", "2nd"])
        for text in ("Pad.Length", "Pad=1:2", "Pad.Length=1:2:3:4", "Pad.Length=a:b", "=1:2"):
            with self.subTest(text=text), self.assertRaisesRegex(UserError, "cannot read"):
                design.parse_parameter(text)

    def test_the_values_of_a_parameter_are_numbers_or_words(self):
        for text in ("Pad.Length=5,six", "Pad.Length=nan,5", "Pad.Length=5,inf", "Pad.Length=5,,6"):
            with self.subTest(text=text), self.assertRaisesRegex(UserError, "the values of Pad.Length are numbers, or words"):
                design.check(study("grid", text))
        listed = study("grid", "A.x=1,2")
        listed.parameters[0].values = [1, [2]]
        self.assertRaisesRegex(UserError, "are numbers, or words", design.check, listed)
        for text in ("Pad.Length=5,6 mm", "Pad.Midplane=true,false", "Mesh.Order=1st,2nd"):
            design.check(study("grid", text))

    def test_responses(self):
        one, two, three, four = parse_list("mass,top=max_mises@Face3:p95,displacement_z@1.5,2,-3,frequency_2")
        self.assertEqual((one.name, one.kind), ("mass", "mass"))
        self.assertEqual((two.name, two.kind, two.at, two.percentile), ("top", "max_mises", "Face3", 95.0))
        self.assertEqual((three.kind, three.at), ("displacement_z", "1.5,2,-3"))
        self.assertEqual((four.name, four.kind, four.mode), ("frequency_2", "frequency", 2))
        for said in ("mass_2", "max mises", "mass@Face1", "mass:p90", "max_mises:p101", {"name": "x"}, {"kind": "mass", "where": "Face1"}):
            with self.subTest(said=said), self.assertRaises(UserError):
                parse_response(said)

    def test_responses_are_called_what_they_are_or_by_their_own_names(self):
        for text, words in (("mass", "mass, kg"), ("max_mises", "largest von Mises stress, MPa"), ("max_mises@Face3:p95", "von Mises stress (percentile 95) at Face3, MPa"),
                            ("top=max_mises@Face3", "top, MPa"), ("frequency_1", "first frequency, Hz"), ("frequency_3", "frequency 3, Hz"),
                            ("buckling_factor", "first buckling factor"),
                            ("reaction_x@Fixed", "force in x at Fixed, N"), ("displacement_z@1.5,2,-3", "displacement in z at 1.5,2,-3, mm"),
                            ({"name": "own", "expression": "mass / 2"}, "own"), ({"kind": "max_displacement", "at": "Hole"}, "largest displacement at Hole, mm")):
            self.assertEqual(english(parse_response(text).title), words)
        self.assertEqual(WORDS.keys(), KINDS.keys())

    def test_expressions_know_names_with_dots_and_nothing_of_python(self):
        self.assertEqual(Expression("HoleSketch.X > 2 * sqrt(radius)", "it").value({"HoleSketch.X": 5.0, "radius": 4.0}), True)
        for text, message in (("__import__('os')", "cannot be evaluated"), ("a +", "cannot be read"), ("b", "it may use a"), ("().__class__", "cannot be read: __class__")):
            with self.subTest(text=text), self.assertRaisesRegex(UserError, message):
                Expression(text, "it").value({"a": 1})


class Sampling(unittest.TestCase):

    def test_grid_and_one_at_a_time(self):
        asked = study("grid", "A.x=0:1", "A.y=1,2")
        self.assertEqual(sampling.rows(asked, {}), [[0, 1], [0, 2], [0.5, 1], [0.5, 2], [1, 1], [1, 2]])
        asked.sampling = "one_at_a_time"
        self.assertEqual(sampling.rows(asked, {"A.x": 0.25, "A.y": 2.0}), [[0.25, 2], [0, 2], [0.5, 2], [1, 2], [0.25, 1]])

    def test_a_latin_hypercube_has_a_case_in_each_slice(self):
        rows = np.array(sampling.rows(study("lhs", "A.x=10:20", "A.y=-1:1", cases=16), {}))
        for column, (low, high) in enumerate(((10, 20), (-1, 1))):
            self.assertEqual(sorted(np.floor((rows[:, column] - low) / (high - low) * 16)), list(range(16)))

    def test_sequences_continue_and_are_the_same_each_time(self):
        for name in ("sobol", "halton"):
            asked = study(name, "A.x=10:20", "A.y=-1:1", cases=12)
            whole = sampling.rows(asked, {})
            self.assertEqual(whole, sampling.rows(asked, {}, 5) + sampling.rows(asked, {}, 7, start=5))
            self.assertNotEqual(whole, sampling.rows(study(name, "A.x=10:20", "A.y=-1:1", cases=12, seed=2), {}))

    def test_rows_of_other_peoples_files(self):
        asked = study("grid", "A.x=0:1", "A.y=1,2")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "rows.csv")

            def read(content):
                with open(path, "wb") as stream:
                    stream.write(content)
                return sampling.read_rows(asked, path)
            self.assertEqual(read("\ufeffA.x,A.y\r\n0.5,2\r\n".encode()), [[0.5, 2]])   # as Excel writes it
            for content, message in ((b"A.x,A.y\n0.5\n", "line 2"), (b"A.x,A.y\nnan,2\n", "nan is no number for A.x"),
                                     (b"A.x,A.y\n0.5,inf\n", "inf is no number"), ("A.x,A.y,H\u00f6he\n0,1,2\n".encode("latin-1"), "cannot read")):
                with self.subTest(content=content), self.assertRaisesRegex(UserError, message):
                    read(content)

    def test_whole_numbers_take_each_value_as_often(self):
        asked = study("sobol", "A.n=2:5", cases=64)
        asked.parameters[0].integer = True
        values = [row[0] for row in sampling.rows(asked, {})]
        self.assertEqual([values.count(n) for n in range(2, 6)], [16] * 4)
        self.assertTrue(all(type(value) is int for value in values))

    def test_whole_numbers_are_within_bounds_that_are_none(self):
        asked = study("sobol", "A.n=2.5:5.5", cases=16)
        folder = folder_of(self, asked, integers=["A.n"])
        planning.plan(folder)
        self.assertEqual({case.parameters["A.n"] for case in folder.database.cases()}, {3, 4, 5})
        asked.parameters[0].bounds = (2.2, 2.8)
        with self.assertRaisesRegex(UserError, "no whole number is between 2.2 and 2.8, the bounds of A.n"):
            planning.plan(folder)

    def test_classic_designs_can_fit_every_quadratic_term(self):
        for make, count, size in ((box_behnken, 3, 13), (box_behnken, 4, 25), (central_composite, 2, 9), (central_composite, 4, 25)):
            rows = make(count)
            self.assertEqual(rows.shape, (size, count))
            self.assertEqual(len(np.unique(rows, axis=0)), size)
            self.assertLess(np.abs(rows.sum(axis=0)).max(), 1e-12)
            self.assertEqual(np.linalg.matrix_rank(surface._quadratic_terms(rows)), (count + 1) * (count + 2) // 2)


class Files(unittest.TestCase):

    def test_a_written_study_is_read_as_it_was(self):
        with tempfile.TemporaryDirectory() as folder:
            asked = study("sobol", "A.x=10:20", "Sheet.d=1:3:5 cm", "A.kind=round,square", cases=12, seed=7, object="Body", solver="ccx", keep=["inp"],
                          constraints=['A.x < 15 or "a" < "b"'], mesh_size=2.5, seconds_limit=9.0, memory_limit_gb=1.5, threads=2)
            asked.document = os.path.join(folder, "pärt.FCStd")
            asked.parameters[0].label = 'Größe "A".x'
            asked.responses = parse_list("mass,frequency_2,own=max_mises@Face3:p99,displacement_z@1,2,3") + [
                parse_response({"name": "ratio", "expression": "mass / 2"}), parse_response({"name": "f", "file": os.path.join(folder, "f.py")})]
            path = os.path.join(folder, "study.toml")
            study_file.write(asked, path)
            self.assertEqual(design.read_toml(path), asked)


    def test_each_key_holds_its_kind_of_value(self):
        good = {"document": '"part.FCStd"', "sampling": '"grid"', "responses": '["mass"]', "parameters": '[{set = "A.x", range = [1, 2]}]'}
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "study.toml")
            for key, value, message in (
                    ("cases", '"2"', "study.toml: cases is a whole number, not '2'"), ("responses", '"mass"', "responses is a list in square brackets"),
                    ("responses", "[3]", "a response is a text such as \"max_mises\" or a table, not 3"), ("constraints", "[3]", "the constraint 3 cannot be read"),
                    ("parameters", "3", "parameters is a list"), ("parameters", "[3]", r"a parameter is a table \[\[parameters\]\]"),
                    ("parameters", '[{set = "A.x", range = 3}]', "range is a list"), ("parameters", '[{set = "A.x", levels = true}]', "levels is a whole number, not True"),
                    ("mesh", '{size = "2 mm"}', r"\[mesh\]: size is a number, not '2 mm'"), ("limits", "{seconds = 0}", "the time limit of a case is more than 0 s"),
                    ("limits", "{seconds = inf}", "the time limit of a case is at most 1e.08 s, not inf"),
                    ("limits", "{memory_gb = inf}", "the memory limit of a case is more than 0 GB, not inf"),
                    ("mesh", "{order = 3}", "the order of the elements is 1 or 2, not 3"),
                    ("threds", "2", "there is no threds; known are analysis, "), ("document", None, "has no document; a study's file needs document, parameters and")):
                entries = {name: said for name, said in {**good, key: value}.items() if said}
                with open(path, "w", encoding="utf-8") as stream:
                    stream.write("".join("%s = %s\n" % entry for entry in entries.items()))
                with self.subTest(key=key, value=value), self.assertRaisesRegex(UserError, message):
                    design.read_toml(path)


class Answers(unittest.TestCase):

    def test_sobol_indices_of_ishigamis_function(self):
        """Ishigami and Homma (1990), a = 7, b = 0.1: known in closed form."""
        def ishigami(points):
            x = math.pi * points
            return np.sin(x[:, 0]) + 7 * np.sin(x[:, 1]) ** 2 + 0.1 * x[:, 2] ** 4 * np.sin(x[:, 0])
        first, total = answers.sobol_indices(ishigami, 3)
        np.testing.assert_allclose(first, [0.3139, 0.4424, 0], atol=0.03)
        np.testing.assert_allclose(total, [0.5576, 0.4424, 0.2437], atol=0.03)

    def test_the_surface_is_the_kind_that_predicts_best(self):
        points = np.random.default_rng(3).uniform(-1, 1, (40, 2))
        x, y = points.T
        for values, kind in ((3 + 2 * x - y, "linear"), (1 + x * y - 2 * y ** 2, "quadratic"), (np.sin(4 * x) * np.exp(y), "thin-plate spline")):
            found = surface.fit(points, values)
            self.assertTrue(found.kind == kind or found.relative_error < 1e-9, found)
            self.assertLess(found.relative_error, 0.5)
        noise = surface.fit(points, np.random.default_rng(4).normal(size=40))
        self.assertGreater(noise.relative_error, 0.8)   # an honest word about what cannot be predicted
        self.assertIsNone(surface.fit(points[:3], x[:3]))

    def test_numbers_below_a_plot_do_not_run_into_one_another(self):
        data = self.data()
        data.limits = [(0.009026, 0.01052), (-0.01052, -0.009026)]
        for inches in (5.0, 8.7):   # narrower and wider than in the page, as windows are
            figure = Figure()
            plots.scatter(figure, data, [parse_response("mass")])
            figure.set_size_inches(inches, 2.4)
            figure.tight_layout()
            FigureCanvasAgg(figure).draw()
            for axes in figure.axes:
                labels = [label for label in axes.get_xticklabels() if label.get_text()]
                boxes = [label.get_window_extent() for label in labels]
                self.assertGreater(len(boxes), 1)
                self.assertTrue(all(left.x1 < right.x0 for left, right in zip(boxes, boxes[1:])), [label.get_text() for label in labels])

    def data(self):
        with tempfile.TemporaryDirectory() as folder:
            database = Database(os.path.join(folder, "study.sqlite"), new=True)
            values = [(x, y) for x in (1.0, 2.0, 3.0) for y in (10.0, 20.0, 30.0)]
            ids = database.add_cases([({"x": x, "y": y}, None) for x, y in values], "test")
            for case_id, (x, y) in zip(ids, values):
                database.finish(case_id, {"state": "done", "responses": {"mass": x, "stress": 100 / x + y}})
            cases = database.cases("done")
        points = np.array([(x - 2, (y - 20) / 10) for x, y in values])
        return answers.Data(None, cases, ["x", "y"], points, [(1, 3), (10, 30)])

    def test_pareto_front_and_best_case(self):
        data = self.data()
        self.assertEqual([case.parameters for case in answers.pareto(data, "mass", "stress")], [{"x": x, "y": 10.0} for x in (1.0, 2.0, 3.0)])
        self.assertEqual(answers.best(data, "mass", ["stress <= 75", "y > 10"]).parameters, {"x": 2.0, "y": 20.0})
        self.assertIsNone(answers.best(data, "mass", ["stress < 1"]))

    def test_main_effects_have_the_sign_and_size_of_the_change(self):
        found = answers.effects(self.data(), "mass")
        np.testing.assert_allclose(found.main, [2, 0], atol=1e-9)
        np.testing.assert_allclose(found.first, [1, 0], atol=0.01)


    def test_plots_name_everything_with_its_unit_and_show_what_differs(self):
        data, responses = self.data(), [parse_response("mass"), parse_response("stress=max_mises")]
        figure = Figure()
        plots.scatter(figure, data, responses)
        self.assertEqual([(axes.get_xlabel(), axes.get_ylabel()) for axes in figure.axes], [("x", "mass, kg"), ("y", ""), ("x", "stress, MPa"), ("y", "")])
        figure = Figure()
        for case in data.cases:
            case.responses["max_mises"] = case.responses["stress"]
        plots.scatter(figure, data, [parse_response("max_mises")], lambda message: english(message).upper())
        self.assertEqual(figure.axes[0].get_ylabel(), "LARGEST VON MISES\nSTRESS, MPA")
        figure = Figure()
        plots.parallel(figure, data, responses)
        self.assertEqual([text.get_text() for text in figure.axes[0].texts],
                         ["1\nx", "3", "10\ny", "30", "1\nmass, kg", "3", "43.33\nstress, MPa", "130"])
        self.assertEqual(plots._told_apart(0.11794, 0.11801), ("0.11794", "0.11801"))
        self.assertEqual(plots._told_apart(1 / 3, 1 / 3), ("0.3333", "0.3333"))

    def test_labels_of_parameters_are_shown_as_they_are(self):
        data, responses = self.data(), [parse_response("mass")]
        data.names = [r"Größe $x^{ \frac$", "50 $ & <b>"]
        for draw in (lambda figure: plots.scatter(figure, data, responses), lambda figure: plots.parallel(figure, data, responses),
                     lambda figure: plots.tornado(figure, data, responses, [answers.effects(data, "mass")])):
            figure = Figure()
            draw(figure)
            FigureCanvasAgg(figure).draw()

    def test_the_names_of_many_axes_are_not_on_one_another(self):
        data, names = self.data(), ["r%d" % number for number in range(6)]
        for case in data.cases:
            case.responses.update(dict.fromkeys(names, 1.0))
        figure = Figure()
        plots.parallel(figure, data, [parse_response(name + "=max_displacement") for name in names])
        below = [text.get_text().count("\n") for text in figure.axes[0].texts[::2]]
        self.assertEqual(below, [1, 2] * 4)

    def test_plots_do_not_show_what_solving_leaves_as_a_difference(self):
        data = self.data()
        for number, case in enumerate(data.cases):
            case.responses["force"] = 1974.79594529 * (1 + 1e-12 * number)
        force = parse_response("force=reaction")
        figure = Figure()
        plots.parallel(figure, data, [force])
        self.assertEqual([text.get_text() for text in figure.axes[0].texts][-2:], ["1975\nforce, N", "1975"])
        self.assertEqual({line.get_ydata()[-1] for line in figure.axes[0].lines[:len(data.cases)]}, {0.5})
        figure = Figure()
        plots.scatter(figure, data, [force])
        low, high = figure.axes[0].get_ylim()
        self.assertGreater(high - low, 100)


class WordsAmongValues(unittest.TestCase):
    """A list of words need not have the document's own, nor those of somebody's rows."""

    def setUp(self):
        self.folder = folder_of(self, study("one_at_a_time", "Hole.Size=M3,M4", "Pad.Length=1:2"))
        finish(self.folder, [{"Hole.Size": size, "Pad.Length": length} for size in ("M6", "M3", "M4", "M5") for length in (1.0, 2.0)],
               lambda of: float(of["Hole.Size"][1]) * of["Pad.Length"])

    def test_words_that_are_not_in_the_list_come_after_it(self):
        data = answers.data_of(self.folder)
        self.assertEqual((data.names, data.limits), (["Hole.Size", "Pad.Length"], [(0.0, 3.0), (1.0, 2.0)]))
        np.testing.assert_allclose(data.points[::2, 0], [1 / 3, -1, -1 / 3, 1])

    def test_cases_with_such_words_are_no_part_of_surfaces(self):
        found = optimise.Optimiser(self.folder, "mass").run(self.solve, 12)
        self.assertEqual(found.case.parameters, {"Hole.Size": "M3", "Pad.Length": 1.0})

    def solve(self, case_id):
        parameters = self.folder.database.case(case_id).parameters
        self.folder.database.finish(case_id, {"state": "done", "responses": {"mass": float(parameters["Hole.Size"][1]) * parameters["Pad.Length"]}})


class Optimising(unittest.TestCase):

    def optimised(self, asked, mass, known=(), goal="mass", **options):
        folder = folder_of(self, asked, **options)
        finish(folder, known, mass)

        def solve(case_id):
            folder.database.finish(case_id, {"state": "done", "responses": {"mass": mass(folder.database.case(case_id).parameters)}})
        return optimise.Optimiser(folder, goal).run(solve, 30)

    def test_cases_on_a_line_are_no_surface(self):
        """As where all others were infeasible."""
        found = self.optimised(study("grid", "A.x=1:2", "A.y=1:2"), lambda of: of["A.x"] + (of["A.y"] - 1.5) ** 2,
                               [{"A.x": 1.5, "A.y": 1 + share / 10} for share in range(10)])
        self.assertEqual(found.case.parameters["A.x"], 1)
        self.assertAlmostEqual(found.case.parameters["A.y"], 1.5, delta=0.02)

    def searched(self, optimiser, folder, most):
        """What a search finds, and the parameters of the cases that it really solved."""
        solved = []

        def solve(case_id):
            case = folder.database.case(case_id)
            if case.state == "waiting":
                solved.append(case.parameters)
                folder.database.finish(case_id, {"state": "done", "responses": {"mass": case.parameters["A.x"] + case.parameters["A.y"]}})
        return optimiser(folder, "mass").run(solve, most), solved

    def test_a_search_that_goes_on_counts_what_it_solves(self):
        for optimiser in (optimise.Optimiser, *OPTUNA):
            with self.subTest(optimiser=optimiser.__name__):
                ended, whole = (folder_of(self, study("grid", "A.x=1:2", "A.y=1:2")) for _ in range(2))
                first, solved = self.searched(optimiser, ended, 3)
                self.assertEqual((first.solves, len(solved)), (3, 3))
                second, more = self.searched(optimiser, ended, 2)
                self.assertEqual((second.solves, len(more)), (2, 2))
                self.assertEqual(solved + more, self.searched(optimiser, whole, 5)[1])

    def test_a_search_ends_where_no_other_case_is_left(self):
        for optimiser in (optimise.Optimiser, *OPTUNA):
            with self.subTest(optimiser=optimiser.__name__):
                folder = folder_of(self, study("grid", "A.x=1,2", "A.y=1,2"))
                found, solved = self.searched(optimiser, folder, 30)
                self.assertEqual((found.solves, len(solved), found.reason), (4, 4, "no other case was found"))
                self.assertEqual(found.case.parameters, {"A.x": 1.0, "A.y": 1.0})
                self.assertEqual(self.searched(optimiser, folder, 30)[1], [])

    def test_what_has_one_value_only_stays(self):
        found = self.optimised(study("grid", "A.x=1:2", "A.kind=round", "A.y=3"), lambda of: (of["A.x"] - 1.25) ** 2 + of["A.y"])
        self.assertAlmostEqual(found.case.parameters.pop("A.x"), 1.25, delta=0.02)
        self.assertEqual(found.case.parameters, {"A.kind": "round", "A.y": 3.0})

    def test_a_goal_need_not_have_a_value_everywhere(self):
        asked = study("grid", "A.x=2:3", "A.y=4:5")
        found = self.optimised(asked, lambda of: of["A.x"], goal="mass / (A.y - A.x) + log(A.x - 1)")
        self.assertEqual(found.case.parameters, {"A.x": 2.0, "A.y": 5.0})
        for goal in ("mass / (A.y - A.z)", "mas / (A.y - A.x)", "1 / (A.x - A.y) + mas", "logg(mass)", "B.x"):
            with self.subTest(goal=goal), self.assertRaisesRegex(UserError, "the goal .* cannot be evaluated: there is no .*; it may use A.x, A.y, mass"):
                optimise.Optimiser(folder_of(self, asked), goal)
        optimise.Optimiser(folder_of(self, asked), "max(x * mass for x in (A.x, A.y))")


class Running(unittest.TestCase):

    def test_a_worker_that_is_stuck_is_overdue(self):
        """In FreeCAD's place a program that says that it is ready, and then nothing."""
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch.object(worker_process, "_GRACE", 0.0):
            program = os.path.join(folder, "stuck")
            with open(program, "w", encoding="utf-8") as stream:
                stream.write("#!%s\nimport json, os, time\nsaid = json.loads(os.environ['FEATUREMESH_STUDY_WORKER'])\n"
                             "os.write(said['answers'], json.dumps({'ready': 1, 'cache': os.environ['FREECAD_USER_TEMP']}).encode() + b'\\n')\ntime.sleep(1000)\n" % sys.executable)
            os.chmod(program, 0o755)
            worker = worker_process.WorkerProcess(program, dict(os.environ), {"seconds_limit": 20.0}, os.path.join(folder, "log"))
            try:
                cache = worker.answer()["cache"]
                self.assertTrue(os.path.isdir(cache))
                self.assertFalse(worker.is_overdue())
                worker._limit = 0.2
                worker.send({"id": 1})
                with self.assertRaisesRegex(worker_process.WorkerDied, "FreeCAD does not answer"):
                    worker.answer()
                self.assertTrue(worker.is_overdue())
            finally:
                worker.end()
            self.assertFalse(os.path.exists(cache))

    def test_an_interrupt_between_two_lines_loses_no_case(self):
        """It comes when the database has just heard that a case begins, or is done; a worker that is no FreeCAD."""
        for name, states, attempts in (("start", ["waiting"] * 3, [0] * 3), ("finish", ["done"] + ["waiting"] * 2, [1, 0, 0])):
            folder = self.folder_with_base(cases=3)
            program = os.path.join(folder.path, "worker")
            with open(program, "w", encoding="utf-8") as stream:
                stream.write(WORKER.format(python=sys.executable))
            os.chmod(program, 0o755)
            with unittest.mock.patch.object(Database, name, interrupted_after(getattr(Database, name))), self.assertRaises(KeyboardInterrupt):
                with runner.Runner(folder, runner.Machine(program, dict(os.environ)), keep_base=True) as running:
                    running.run()
            cases = folder.database.cases()
            self.assertEqual(([case.state for case in cases], [case.attempts for case in cases]), (states, attempts))

    def folder_with_base(self, cases):
        folder = folder_of(self, study("grid", "A.x=1:3"))
        folder.database.add_cases([({"A.x": float(number)}, None) for number in range(cases)], "test")
        folder.facts = lambda: {"nodes": 10, "filled_by": "tets", "solver": None, "engine": "", "freecad": ""}
        folder.base_path, folder.refuse_damaged_base, folder.clear_case = "base.FCStd", lambda: None, lambda case_id: folder.path
        return folder

    def test_the_longest_time_limit_can_be_waited_for(self):
        with tempfile.TemporaryDirectory() as folder:
            worker = worker_process.WorkerProcess("/bin/true", dict(os.environ), {"seconds_limit": design.MOST_SECONDS}, os.path.join(folder, "log"))
            self.addCleanup(worker.end)
            self.assertRaisesRegex(worker_process.WorkerDied, "FreeCAD ended", worker.answer)

    def test_no_case_starts_without_memory_for_it(self):
        book = SimpleNamespace(facts={"nodes": 1_000_000, "filled_by": "tets", "solver": "ccx"})
        with unittest.mock.patch.object(runner, "CaseBook", lambda *_: book), unittest.mock.patch.object(memory, "available_bytes", lambda: 2e9):
            with self.assertRaisesRegex(case_book.Stopped, r"a case needs about [\d.]+ GB of memory, and 2.0 GB are free; take a coarser mesh, or free memory"):
                runner.Runner(None, None)._jobs_now(2)


class Keeping(unittest.TestCase):

    def test_a_full_disk_is_told_and_what_was_written_is_there(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "study.sqlite")
            done = subprocess.run([sys.executable, "-c", FULL_DISK.format(tests=str(ROOT / "tests" / "python"), path=path)],
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            self.assertIn("every finished case is safe", done.stdout, done.stderr)
            self.assertEqual(sum(Database(path).counts().values()), int(done.stdout.split()[0]))

    def test_a_study_in_a_folder_that_cannot_be_written_is_read(self):
        with tempfile.TemporaryDirectory(suffix=" 50% #1?") as folder:
            path = os.path.join(folder, "study.sqlite")
            database = Database(path, new=True)
            database.add_cases([({"x": 1.5}, None)], "test")
            database.close()
            before = Path(path).read_bytes()
            with unittest.mock.patch.object(os, "access", return_value=False):   # nothing is closed to root
                database = Database(path)
                self.assertEqual([case.parameters for case in database.cases()], [{"x": 1.5}])
                with self.assertRaisesRegex(UserError, "study.sqlite cannot be written"):
                    database.add_cases([({"x": 2.5}, None)], "test")
                self.assertEqual(os.listdir(folder), ["study.sqlite"])
                database.close()
            os.mkdir(os.path.join(folder, "running.lock"))   # what even root cannot open
            with self.assertRaisesRegex(UserError, "cannot write .*running.lock: Is a directory"):
                StudyFolder(folder).lock()
            self.assertEqual(Path(path).read_bytes(), before)

    def test_cases_that_are_only_in_the_log_are_read_where_nothing_can_be_written(self):
        with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as left, tempfile.TemporaryDirectory() as copies:
            path = os.path.join(folder, "study.sqlite")
            database = Database(path, new=True)
            database.add_cases([({"x": 1.5}, None), ({"x": 2.5}, None)], "test")
            for name in ("study.sqlite", "study.sqlite-wal"):   # what a crash leaves
                shutil.copy(os.path.join(folder, name), left)
            database.close()
            before = {name: Path(left, name).read_bytes() for name in os.listdir(left)}
            with unittest.mock.patch.object(os, "access", return_value=False), unittest.mock.patch.object(tempfile, "tempdir", copies):   # nothing is closed to root
                database = Database(os.path.join(left, "study.sqlite"))
                self.assertEqual([case.parameters for case in database.cases()], [{"x": 1.5}, {"x": 2.5}])
                with self.assertRaisesRegex(UserError, "study.sqlite cannot be written"):
                    database.add_cases([({"x": 3.5}, None)], "test")
                self.assertEqual(len(os.listdir(copies)), 1)
                database.close()
            self.assertEqual({name: Path(left, name).read_bytes() for name in os.listdir(left)}, before)
            self.assertEqual(os.listdir(copies), [])

    def test_a_folder_knows_its_copy_and_the_document_in_that(self):
        with tempfile.TemporaryDirectory() as place:
            folders = [os.path.join(place, name) for name in ("first", "other")]
            for folder, text in zip(folders, ("a part", "other")):
                os.mkdir(folder)
                for name in ("part.FCStd", "base.FCStd"):
                    Path(folder, name).write_text(text, encoding="utf-8")
                asked = study("lhs", "Plate.Length=8:12")
                asked.document = os.path.join(folder, "part.FCStd")
                StudyFolder(folder, new=True).create(asked, {}, lambda made: None)
            copied = os.path.join(place, "copied")
            shutil.copytree(folders[0], copied)
            self.assertEqual([is_same_study(copied, folder) for folder in folders], [True, False])
            self.assertFalse(is_same_study(copied, os.path.join(place, "gone")))
            self.assertEqual(StudyFolder(copied).study().document, os.path.join(copied, "part.FCStd"))
            os.unlink(os.path.join(copied, "part.FCStd"))
            self.assertEqual(StudyFolder(copied).study().document, os.path.join(folders[0], "part.FCStd"))

    def test_the_same_parameters_are_one_case(self):
        with tempfile.TemporaryDirectory() as folder:
            database = Database(os.path.join(folder, "study.sqlite"), new=True)
            self.assertEqual(database.add_cases([({"x": 1.5}, None), ({"x": 2.5}, "not kept"), ({"x": 1.5}, None)], "test"), [1, 2, 1])
            self.assertEqual(database.counts()["infeasible"], 1)

    def test_cases_that_could_not_be_made_are_not_called_done(self):
        with tempfile.TemporaryDirectory() as folder:
            database = Database(os.path.join(folder, "study.sqlite"), new=True)
            database.add_cases([({"x": 1.5}, None), ({"x": 2.5}, None), ({"x": 3.5}, "the constraint x < 3 is not kept"), ({"x": 4.5}, None)], "test")
            self.assertIsNone(database.mean_seconds())
            database.finish(1, {"state": "done", "seconds": {"total": 4.0, "solve": 1.0}})
            self.assertEqual(english(progress.summary({"done": 1, "failed": 0, "infeasible": 0}, None)), "1 of 1 case done")
            database.finish(2, {"state": "failed", "message": "Pad: no", "seconds": {"total": 9.0}})
            self.assertEqual(english(progress.summary(database.counts(), database.first_lost())), "1 of 4 cases done, 2 could not be made or solved; case 2: Pad: no")
            database.finish(4, {"state": "done", "seconds": {"total": 6.0}})
            self.assertEqual(database.mean_seconds(), 5.0)

    def test_modes_of_calculix(self):
        text = ("     E I G E N V A L U E   O U T P U T\n\n MODE NO    EIGENVALUE  FREQUENCY\n\n"
                "      1   0.4E+08   0.6E+04   0.1E+04   0.0E+00\n      2   0.9E+08   0.9E+04   0.15E+04   0.0E+00\n\n"
                "     P A R T I C I P A T I O N   F A C T O R S\n\n      1   0.5E+00   0.0E+00   0.0E+00   0.0E+00\n")
        self.assertEqual(modes.read(text, "frequency"), [1000.0, 1500.0])
        self.assertEqual(modes.read("\n".join(line for line in text.splitlines() if "0.4E+08" not in line), "frequency"), [1500.0])   # one below what was asked for
        self.assertEqual(modes.read("     B U C K L I N G   F A C T O R   O U T P U T\n\n      1   0.5E+02\n      2   0.7E+02\n", "buckling"), [50.0, 70.0])

    def test_time_left_is_that_of_what_was_measured(self):
        counts = {"done": 2, "infeasible": 0, "failed": 0, "running": 2, "waiting": 6}
        self.assertIsNone(progress.seconds_left(counts, [1, 1], [], 2))
        self.assertEqual(progress.seconds_left(counts, [4.0, 12.0], [9.0, 11.0], 2), (6 * 10 + 6) / 2)
        self.assertIn("2 of 10 done, 2 running, about 33 s left", progress.line(counts, [4.0, 12.0], [9.0, 11.0], 2))
        self.assertIn("2 running, nearly done", progress.line({**counts, "waiting": 0}, [14.0, 12.0], [9.0, 11.0], 2))
        self.assertTrue(progress.line({**counts, "done": 10, "running": 0, "waiting": 0}, [], [9.0, 11.0], 2).endswith("10 of 10 done, 0 running"))

    def test_jobs_wait_for_memory(self):
        self.assertEqual(memory.jobs_that_fit(4, 3e9, 7e9), 2)
        self.assertEqual(memory.jobs_that_fit(4, 3e9, 2e9), 0)
        for unknowns, measured in ((37_000, 0.19e9), (153_000, 1.04e9)):   # of CalculiX alone
            self.assertTrue(measured < memory.estimated_bytes(unknowns / 3, "ccx") < 3 * measured + 0.25e9)
        facts = {"nodes": 70_000, "filled_by": "tets", "solver": "ccx", "iterative": True}
        self.assertTrue(0.30e9 < memory.of_case(facts) < 3 * 0.30e9 + 0.25e9)
        self.assertLess(2 * memory.of_case(facts), memory.of_case({**facts, "nodes": 140_000, "iterative": False}))


if __name__ == "__main__":
    unittest.main()

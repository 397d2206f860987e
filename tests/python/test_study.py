# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies as a user runs them, with real meshes and real solutions. Runs in plain Python."""
import contextlib
import csv
import importlib.util
import io
import json
import math
import shutil
import unittest

from study_tests import VARIED, StudyTest

import commands


def volume(radius, height):
    return (60 * 40 - math.pi * radius ** 2) * height


@unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
class Studies(StudyTest):

    def table(self, folder, name="rows.csv"):
        self.study("export", folder, name)
        with open(self.folder / name, newline="", encoding="utf-8") as stream:
            return list(csv.DictReader(stream))

    def test_from_the_command_line_alone(self):
        before = self.part.read_bytes()
        out, err = self.study("run", "part.FCStd", *VARIED, "--sampling", "sobol", "--cases", "3", "--solver", "ccx", "--folder", "mine",
                              "--responses", "mass,max_mises,max_displacement@%s,reaction_x@Fixed,strain_energy" % self.pulled_face)
        self.assertIn("3 of 3 cases done", out)
        self.assertIn("[####################] 3 of 3 done, 0 running", err)
        rows = self.table("mine")
        self.assertEqual(list(rows[0])[:9], ["case", "state", "HoleSketch.Radius", "Plate.Length", "mass", "max_mises",
                                             "max_displacement@" + self.pulled_face, "reaction_x@Fixed", "strain_energy"])
        for row in rows:
            radius, height = float(row["HoleSketch.Radius"]), float(row["Plate.Length"])
            self.assertAlmostEqual(float(row["mass"]), 7850e-9 * volume(radius, height), places=9)
            nominal, at_hole = 6000 / (40 * height), 6000 / ((40 - 2 * radius) * height)
            self.assertGreater(float(row["max_mises"]), 2 * nominal)
            self.assertLess(float(row["max_mises"]), 3.5 * at_hole)
            self.assertAlmostEqual(abs(float(row["reaction_x@Fixed"])), 6000, delta=1)
            stretched = nominal / 210000 * 60
            self.assertGreater(float(row["max_displacement@" + self.pulled_face]), stretched)
            self.assertLess(float(row["max_displacement@" + self.pulled_face]), 1.5 * stretched)
            work = 6000 * float(row["max_displacement@" + self.pulled_face]) / 2
            self.assertAlmostEqual(float(row["strain_energy"]), work, delta=0.1 * work)
        self.assertEqual(self.part.read_bytes(), before)
        self.assertIn("0 waiting, 0 running, 3 done, 0 infeasible, 0 failed", self.study("status", "mine")[0])
        self.study("report", "mine")
        self.assertRegex((self.folder / "mine" / "report.html").read_text(encoding="utf-8"), r"mass: least [\d.]+ kg in case \d, largest [\d.]+ kg in case")
        self.assertIn("compromises are between two responses, not mass", self.study("report", "mine", "--pareto", "mass", code=2)[1])
        self.assertIn("added 2 cases", self.study("add", "mine", "--cases", "2")[0])
        self.study("run", "part.FCStd", *VARIED, "--sampling", "sobol", "--cases", "5", "--responses", "volume", "--folder", "longer")
        self.assertEqual(list(self.results("mine")), list(self.results("longer")))   # the sequence went on where it had stopped
        self.assert_nothing_left_behind()

    def test_a_file_with_constraints_places_and_own_responses(self):
        self.response_file("return case.fields.displacements[:, 0].max() + 0 * case.part.Shape.Volume")
        self.toml('solver = "ccx"', 'keep = ["mesh", "inp", "frd"]', 'constraints = ["radius * 2 < 12 or Plate.Length > 10"]',
                  'responses = ["volume", "max_mises@Hole", "max_mises:p90", {name = "middle", kind = "displacement_x", at = "30,5,4"},',
                  '  "max_principal", "min_principal", {name = "own", file = "own.py"}, {name = "ratio", expression = "own / middle"}]')
        self.study("run", "study.toml")
        rows = self.rows()
        self.assertEqual([row["state"] for row in rows], ["done", "done", "infeasible", "done"])
        self.assertIn("infeasible: case 3: the constraint radius * 2 < 12 or Plate.Length > 10 is not kept", self.study("status", "study-study")[0])
        for row in (rows[0], rows[1], rows[3]):
            found = row["responses"]
            self.assertGreater(found["max_mises@Hole"], 1.3 * found["max_mises:p90"])
            self.assertGreater(found["max_principal"], 0)
            self.assertLess(found["min_principal"], found["max_principal"])
            self.assertGreater(found["middle"], 0.3 * found["own"])
            self.assertAlmostEqual(found["ratio"], found["own"] / found["middle"])
            kept = {path.name for path in (self.folder / "study-study" / "cases" / ("%04d" % row["id"])).iterdir()}
            self.assertEqual(kept, {"case.vtu", "case.inp", "case.frd", "freecad.log"})
        self.study("export", "study-study", "all.json")
        self.assertEqual(len(json.loads((self.folder / "all.json").read_text(encoding="utf-8"))["cases"]), 4)

    def test_the_document_as_it_is_is_so_in_any_unit(self):
        self.study("run", "part.FCStd", "--vary", "Plate.Length=0.8:1.2:2 cm", "--sampling", "one_at_a_time", "--responses", "volume", "--folder", "cm")
        rows = self.rows("cm")
        self.assertEqual([row["parameters"]["Plate.Length"] for row in rows], [1.0, 0.8, 1.2])
        for row, height in zip(rows, (10, 8, 12)):
            self.assertAlmostEqual(row["responses"]["volume"], volume(6, height), places=6)

    def test_what_freecad_cannot_make_is_infeasible_and_no_failure(self):
        out, _ = self.study("run", "part.FCStd", "--vary", "Plate.Length=10,0", "--vary", "HoleSketch.X=22", "--sampling", "grid", "--responses", "volume", "--folder", "s")
        self.assertIn("1 of 2 cases done, 1 infeasible", out)
        self.assertEqual(self.states("s"), ["done", "infeasible"])
        self.assertGreater(self.rows("s")[0]["mesh"]["kept_share"], 0.1)   # a case starts from the base mesh
        self.assertRegex(self.rows("s")[1]["message"], "Plate")
        self.assertIn("infeasible: case 2: ", self.study("status", "s")[0])
        out, _ = self.study("run", "part.FCStd", "--vary", "Plate.Length=0,-1", "--sampling", "grid", "--responses", "volume", "--folder", "none")
        self.assertIn("0 of 2 cases done, 2 infeasible; see them with: featuremesh study status none", out)   # a report there would be of nothing

    def test_a_response_that_is_no_number_fails_its_case_by_name(self):
        self.response_file("return float('nan') if case.id == 2 else 1.0")
        out, err = self.study("run", "study.toml", code=1)
        self.assertIn("3 of 4 cases done, 1 failed", out)
        self.assertIn("warning: case 2: response own is not a number: nan", err)

    def test_the_same_bits_by_one_process_by_two_and_in_another_order(self):
        self.toml('responses = ["max_mises"]', 'solver = "ccx"')
        self.study("run", "study.toml", "--folder", "one", "--jobs", "1")
        self.study("run", "study.toml", "--folder", "two", "--jobs", "2")
        backwards = [row["parameters"] for row in reversed(self.rows("one"))]
        with open(self.folder / "rows.csv", "w", newline="", encoding="utf-8") as stream:
            writer = csv.DictWriter(stream, ["radius", "Plate.Length"])
            writer.writeheader()
            writer.writerows(backwards)
        self.toml('responses = ["max_mises"]', 'solver = "ccx"', 'rows = "rows.csv"')
        text = (self.folder / "study.toml").read_text(encoding="utf-8").replace('"grid"', '"csv"')
        (self.folder / "study.toml").write_text(text, encoding="utf-8")
        self.study("run", "study.toml", "--folder", "backwards")
        self.assertNotIn(None, self.results("one").values())
        self.assertEqual(len(set(self.results("one").values())), 4)
        self.assertEqual(self.results("one"), self.results("two"))
        self.assertEqual(self.results("one"), self.results("backwards"))

    def test_both_solvers_agree_and_live_has_the_same_bits_each_time(self):
        if self.best_solver != "live":
            self.skipTest("the engine has no live solver")
        for solver, jobs, folder in (("live", 1, "live"), ("live", 2, "again"), ("ccx", 2, "ccx")):
            self.toml('responses = ["max_displacement", "max_mises", "strain_energy", "reaction_x@Fixed", "displacement_x@59,20,5"]', 'solver = "%s"' % solver)
            self.study("run", "study.toml", "--folder", folder, "--jobs", jobs)
        self.assertEqual(self.results("live"), self.results("again"))
        for live, ccx in zip(self.rows("live"), self.rows("ccx")):
            for name, value in ccx["responses"].items():
                self.assertAlmostEqual(live["responses"][name], value, delta=2e-3 * abs(value), msg=name)

    def of_kind(self, kind, responses):
        """The responses of the plate 8 and 12 mm thick, by an analysis of that kind."""
        self.make_part(self.part, kind)
        self.study("run", "part.FCStd", "--vary", "Plate.Length=8,12", "--sampling", "grid", "--solver", "ccx", "--responses", responses, "--folder", "s")
        return [row["responses"] for row in self.rows("s")]

    def test_a_mesh_of_gmsh_gives_its_place_to_ours_in_the_cases(self):
        words = ["run", "part.FCStd", *VARIED, "--sampling", "sobol", "--cases", "2", "--responses", "max_mises", "--folder"]
        self.study(*words, "ours")
        self.make_part(self.part, "gmsh")
        before = self.part.read_bytes()
        self.study(*words, "theirs")
        self.assertEqual(self.part.read_bytes(), before)
        ours, theirs = ([row["max_mises"] for row in self.table(folder)] for folder in ("ours", "theirs"))
        self.assertEqual(ours, theirs)   # of the same size

    def test_frequencies_rise_with_the_thickness(self):
        thin, thick = self.of_kind("frequency", "mass,frequency_1,frequency_2")
        self.assertLess(thin["frequency_1"], thin["frequency_2"])
        self.assertAlmostEqual(thick["frequency_1"] / thin["frequency_1"], 1.5, delta=0.1)   # of bending: in proportion
        beam = 1.8751 ** 2 / (2 * math.pi * 60 ** 2) * math.sqrt(210e9 * 8e-3 ** 2 / 12 / 7850) * 1e6
        self.assertAlmostEqual(thin["frequency_1"], beam, delta=0.15 * beam)

    def test_buckling_factors_rise_with_the_cube_of_the_thickness(self):
        thin, thick = self.of_kind("buckling", "buckling_factor_1")
        self.assertAlmostEqual(thick["buckling_factor_1"] / thin["buckling_factor_1"], 1.5 ** 3, delta=0.5)
        euler = math.pi ** 2 * 210000 * 40 * 8 ** 3 / 12 / (2 * 60) ** 2 / 6000
        self.assertAlmostEqual(thin["buckling_factor_1"], euler, delta=0.25 * euler)

    def test_temperatures(self):
        for found in self.of_kind("thermomech", "max_temperature,min_temperature,middle=max_temperature@40,35,4,max_displacement"):
            self.assertAlmostEqual(found["max_temperature"], 400, delta=0.1)
            self.assertAlmostEqual(found["min_temperature"], 300, delta=0.1)
            self.assertTrue(360 < found["middle"] < 372, found)
            self.assertGreater(found["max_displacement"], 1.2e-5 * 50 * 60)

    def of_other_part(self, kind, vary, responses):
        """The responses of the cases of another kind of part (see make_other_study_part.py)."""
        self.make_part(self.part, kind, "make_other_study_part.py")
        self.study("run", "part.FCStd", *(word for text in vary for word in ("--vary", text)), "--sampling", "grid", "--responses", responses, "--folder", "s")
        return [row["responses"] for row in self.rows("s")]

    def test_shells_bend_as_beams_do_and_their_thickness_is_varied(self):
        found = self.of_other_part("sheet", ("Sheet.Length=200,250", "Thickness.Thickness=8,10"),
                                   "mass,area,max_mises,root=max_mises@Edge1,max_displacement,end=displacement_z@Sheet,reaction_z@Fixed,strain_energy")
        for row, (length, thickness) in zip(found, ((200, 8), (200, 10), (250, 8), (250, 10)), strict=True):
            bent = 100 * length ** 3 / (3 * 210000 * 50 * thickness ** 3 / 12)
            self.assertAlmostEqual(row["mass"], 7850e-9 * length * 50 * thickness, places=9)
            self.assertAlmostEqual(row["area"], length * 50, places=6)
            self.assertAlmostEqual(row["max_mises"] / (100 * length / (50 * thickness ** 2 / 6)), 1, delta=0.05)   # outside, where the sheet is held
            self.assertEqual(row["root"], row["max_mises"])
            self.assertAlmostEqual(row["max_displacement"] / bent, 1, delta=0.02)
            self.assertAlmostEqual(abs(row["end"]) / bent, 1, delta=0.02)
            self.assertAlmostEqual(abs(row["reaction_z@Fixed"]), 100, delta=0.1)
            self.assertAlmostEqual(row["strain_energy"] / (100 * bent / 2), 1, delta=0.02)

    def test_sheets_of_several_thicknesses_and_materials_weigh_what_they_weigh(self):
        for row, length in zip(self.of_other_part("sheets", ("Near.Length=100,120",), "mass"), (100, 120), strict=True):
            self.assertAlmostEqual(row["mass"], 1e-9 * 50 * (7850 * length * 8 + 2700 * 100 * 2), places=9)

    def test_beams_with_their_section_as_a_parameter(self):
        found = self.of_other_part("beam", ("Axis.X2=200,250", "Section.RectHeight=20,24"), "mass,max_mises,max_displacement,displacement_z@Vertex2")
        for row, (length, height) in zip(found, ((200, 20), (200, 24), (250, 20), (250, 24)), strict=True):
            self.assertAlmostEqual(row["mass"], 7850e-9 * length * 20 * height, places=9)
            self.assertAlmostEqual(row["max_mises"] / (100 * length / (20 * height ** 2 / 6)), 1, delta=0.05)
            bent = 100 * length ** 3 / (3 * 210000 * 20 * height ** 3 / 12)
            self.assertAlmostEqual(row["max_displacement"] / bent, 1, delta=0.03)
            self.assertAlmostEqual(abs(row["displacement_z@Vertex2"]) / bent, 1, delta=0.03)

    def test_parts_of_two_materials_held_by_a_tie(self):
        found = self.of_other_part("tied", ("Upper.Height=20,24",), "mass,max_displacement,reaction_z@Fixed,max_mises@Lower")
        for row, height in zip(found, (20, 24), strict=True):
            self.assertAlmostEqual(row["mass"], 1e-9 * 100 * (7850 * 20 + 2700 * height), places=9)
            self.assertAlmostEqual(row["max_displacement"] / (10 * (20 / 210000 + height / 70000)), 1, delta=0.01)
            self.assertAlmostEqual(abs(row["reaction_z@Fixed"]), 1000, delta=1)
            self.assertAlmostEqual(row["max_mises@Lower"], 10, delta=0.1)

    def test_a_zone_of_the_mesh_is_varied(self):
        self.of_other_part("zone", ("HoleSketch.Radius=4,6", "SizeZone.InnerSize=3,1.5"), "max_mises")
        coarse, fine, coarse_too, fine_too = (row["mesh"]["nodes"] for row in self.rows("s"))
        self.assertGreater(fine, 1.2 * coarse)
        self.assertGreater(fine_too, 1.2 * coarse_too)
        self.assertEqual({row["mesh"]["fallback"] for row in self.rows("s")}, {None})

    def test_what_shells_cannot_be_asked_is_told_in_one_line(self):
        self.make_part(self.part, "middle", "make_other_study_part.py")
        vary = ("run", "part.FCStd", "--vary", "Sheet.Length=200", "--sampling", "grid")
        for words, message in ((("--responses", "volume"), "the response volume needs a solid, and Sheet has none"),
                               (("--responses", "max_mises", "--solver", "live"), "the live solver knows solids only")):
            _, err = self.study(*vary, *words, "--folder", "refused", code=2)
            self.assertIn(message, err.splitlines()[-1])
        _, err = self.study(*vary, "--responses", "displacement_z@100,25,0", "--folder", "point", code=2)
        self.assertIn("the part has no solid that the point (100, 25, 0) mm could be in", err)
        _, err = self.study(*vary, "--responses", "max_mises", "--folder", "middle")
        self.assertIn("warning: the stresses of shells and beams are those in the middle of the thickness", err)
        self.assertLess(self.rows("middle")[0]["responses"]["max_mises"], 10)

    def test_shells_beside_solids_are_refused_in_one_line(self):
        self.make_part(self.part, "mixed", "make_other_study_part.py")
        vary = ("run", "part.FCStd", "--vary", "Block.Height=20,24", "--sampling", "grid", "--responses")
        for responses in ("mass", "max_mises"):
            _, err = self.study(*vary, responses, "--folder", "refused", code=2)
            self.assertIn("Both has several of them in one analysis", err.splitlines()[-1])
        self.study(*vary, "volume", "--folder", "volume")
        self.assertEqual([round(row["responses"]["volume"]) for row in self.rows("volume")], [2000, 2400])

    def test_optimising_finds_the_known_best_and_counts_every_evaluation_as_a_case(self):
        """The thinnest plate of a volume of 20 000 mm^3 has the smallest hole: its height is 20 000 / (60 * 40 - pi r^2)."""
        self.study("run", "part.FCStd", "--vary", "HoleSketch.Radius=4:8", "--vary", "Plate.Length=6:12", "--sampling", "central_composite",
                   "--responses", "volume", "--folder", "s")
        words = ("optimise", "s", "--minimise", "Plate.Length", "--limit", "volume >= 20000", "--solves", "12")
        out, err = self.study(*words)
        best = min((row for row in self.rows("s") if row["responses"]["volume"] >= 20000), key=lambda row: row["parameters"]["Plate.Length"])
        self.assertAlmostEqual(best["parameters"]["Plate.Length"], 20000 / (2400 - math.pi * 16), delta=0.03)
        self.assertIn("best: case %d: " % best["id"], out)
        self.assertEqual(len(err.splitlines()), len(self.rows("s")) - 9)
        if importlib.util.find_spec("optuna"):
            by_optuna, _ = self.study(*words[:-1], "5", "--method", "optuna")
            self.assertRegex(by_optuna, "best: case .*; 5 solutions")
        again, _ = self.study(*words)
        self.assertIn("best: case ", again)
        self.assertIn("no case keeps", self.study("optimise", "s", "--minimise", "volume", "--limit", "volume < 1", "--solves", "1", code=1)[0])
        self.assertIn("it may use", self.study("optimise", "s", "--minimise", "beauty", code=2)[1])

    def test_the_demo_ends_with_a_study(self):
        with contextlib.redirect_stdout(io.StringIO()) as said, contextlib.redirect_stderr(io.StringIO()):
            commands.study_of_demo(str(self.folder))
        self.assertIn("6 of 6 cases done", said.getvalue())
        html = (self.folder / "study" / "report.html").read_text(encoding="utf-8")
        self.assertEqual(html.count("data:image/png;base64,"), 4)

    def test_wrong_use_is_told_in_one_line(self):
        self.study("run", "part.FCStd", *VARIED, "--sampling", "grid", "--responses", "volume", "--folder", "there")
        (self.folder / "endless.csv").write_text("Plate.Length\ninf\n", encoding="utf-8")
        (self.folder / "latin.toml").write_text('document = "käse"', encoding="latin-1")
        run, two = ("run", "part.FCStd"), ("--responses", "mass", "--cases", "2")
        for words, message in (
                (run, "say what to vary"),
                (("run", "gone.FCStd", *VARIED, *two), "gone.FCStd: no such file"), (("run", "gone.toml"), "gone.toml: no such file"),
                ((*run, *VARIED, "--responses", "max_misses", "--cases", "2"), "there is no response max_misses, did you mean max_mises?; there are mass, "),
                ((*run, *VARIED, "--responses", "mass"), "needs a number of cases, such as --cases 32"),
                ((*run, *VARIED, "--responses", "mass", "--sampling", "csv"), "needs a file of rows: --rows ROWS.csv"),
                ((*run, *VARIED, "--responses", "mass", "--sampling", "box_behnken"), "needs at least three parameters, not 2; take central_composite"),
                ((*run, *VARIED, *two, "--seed", "-1"), "the seed is 0 or larger, not -1"),
                ((*run, *VARIED, *two, "--threads", "0"), "at least one thread, not 0"),
                ((*run, *VARIED, *two, "--time-limit", "0"), "the time limit of a case is more than 0 s, not 0"),
                ((*run, *VARIED, *two, "--memory-limit", "-2"), "the memory limit of a case is more than 0 GB, not -2; leave it out"),
                ((*run, *VARIED, *two, "--folder", "/proc/there/study"), "/proc/there/study cannot be made a study's folder (No such file or directory); name another"),
                ((*run, *VARIED, *two, "--folder", "e", "--jobs", "0"), "--jobs 0: at least one job is needed"),
                ((*run, *VARIED, *two, "--folder", "e", "--scheduler", "there"), "--scheduler there: the address of a scheduler is tcp://HOST:PORT"),
                (("add", "there", "--cases", "1", "--jobs", "0"), "--jobs 0: at least one job is needed"),
                ((*run, *VARIED, *two, "--folder", "there"), "holds a study already: go on with `study resume`"),
                ((*run, *VARIED, *two, "--folder", "part.FCStd"), "cannot be made a study's folder (Not a directory); name another --folder"),
                ((*run, "--vary", "Plaet.Length=1:2", *two, "--folder", "a"), "the document has no object Plaet; did you mean Plate"),
                ((*run, "--vary", "Plate.Lenght=1:2", *two, "--folder", "a"), "Plate has no property Lenght; did you mean Length"),
                ((*run, *VARIED, "--responses", "max_mises@Face99", "--cases", "2", "--folder", "b"), "the part has no Face99"),
                ((*run, *VARIED, "--responses", "displacement_z@20,20,5", "--cases", "2", "--folder", "b"), "the point (20, 20, 5) mm, where a response is asked for, is not"),
                ((*run, *VARIED, "--responses", "frequency_1", "--cases", "2", "--folder", "c", "--solver", "ccx"), "needs an analysis of the kind"),
                ((*run, *VARIED, "--responses", "mass:p1.2.3", "--cases", "2"), "cannot read the response 'mass:p1.2.3'"),
                ((*run, *VARIED, "--responses", "frequency_0", "--cases", "2"), "counts its modes from 1"),
                ((*run, *VARIED, "--responses", "mass", "--cases", "1000000000"), "a study has at most 100000 cases; 1000000000 are too many"),
                ((*run, "--vary", "Plate.Length=1:2:1000000000", "--responses", "mass", "--sampling", "grid"), "needs two levels to 100000, not 1000000000"),
                ((*run, "--vary", "Plate.Length=1:2", "--responses", "mass", "--sampling", "csv", "--rows", "endless.csv", "--folder", "d"), "line 2: inf is no number"),
                (("run", "latin.toml"), "latin.toml cannot be read"),
                (("report", "there", "--limit", "volume <= 1"), "give both"),
                ((*run, "--vary", "Plate.Length=2:1", *two), "the range of Plate.Length has to rise, not 2:1; write its low end first"),
                (("resume", "there", "--time-limit", "-1"), "the time limit of a case is more than 0 s, not -1"),
                (("add", "there", "--cases", "2"), "the sampling grid is complete"),
                (("status", "nowhere"), "nowhere holds no study; begin one there with `study run ... --folder nowhere`")):
            with self.subTest(words=words):
                _, err = self.study(*words, code=2)
                self.assertIn(message, err)
                self.assertEqual(len(err.splitlines()), 1, err)
        self.assertEqual([name for name in "abcde" if (self.folder / name).exists()], [])

    def test_a_file_that_names_a_document_that_is_not_there(self):
        self.toml('responses = ["volume"]')
        self.part.unlink()
        self.assertRegex(self.study("run", "study.toml", code=2)[1], r"study.toml names the document .*part.FCStd, which is not there; its path is relative")

    def test_what_was_refused_leaves_no_study_behind(self):
        """The rows are read when the base is there already."""
        (self.folder / "rows.csv").write_text("Plate.Length\nthick\n", encoding="utf-8")
        words = ("run", "part.FCStd", "--vary", "Plate.Length=8:12", "--sampling", "csv", "--rows", "rows.csv", "--responses", "volume", "--folder", "s")
        self.assertIn("line 2: thick is no number for Plate.Length", self.study(*words, code=2)[1])
        self.assertFalse((self.folder / "s").exists())
        (self.folder / "rows.csv").write_text("Plate.Length\n9\n", encoding="utf-8")
        self.study(*words)
        self.assertEqual(self.states("s"), ["done"])


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Messages are put into words from their code's template and their parameters, in the user's language and units."""
import re
import string
import sys
import unittest
from pathlib import Path
from unittest import mock

import FreeCAD
from freecad.featuremesh import engine, job, messages, reading, user_words
from parts import new_document, plate_with_hole
from PySide import QtCore

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "resources" / "translations"))
sys.dont_write_bytecode = True
import update_translations  # noqa: E402

TOO_LARGE = {"code": "size_larger_than_part",
             "template": "The mesh size of {size:length} is larger than the part, which is {part:extent}. Ask for a smaller size.",
             "parameters": {"size": 254.0, "part": [50.8, 25.4, 12.7]}}
CROSSING = {"code": "full_mesh", "template": "full mesh: {why:messages}", "parameters": {"why": [
    {"code": "pair", "template": "{one:entities} and {other:entities}", "parameters": {"one": ["Face2"], "other": ["Edge7"]}},
    {"code": "with_itself", "template": "{one:entities} and itself", "parameters": {"one": ["Face2"]}}]}}
OF_EACH_KIND = {"count": 3, "number": 0.5, "length": 2.5, "volume": 8.0, "extent": [1.0, 2.0, 3.0], "point": [1.0, -2.0, 0.25],
                "entities": ["Face12", "Edge3"], "text": "Pad {1}", "messages": [TOO_LARGE]}


def translated(words):
    """A stand-in for Qt's translate that knows these words only."""
    return mock.patch.object(FreeCAD.Qt, "translate", side_effect=lambda context, text: words[text])


class Templates(unittest.TestCase):
    def test_are_those_of_the_engine(self):
        self.assertEqual(update_translations.templates_of_engine(), engine.load().message_templates())

    def test_each_is_said_somewhere(self):
        sources = "".join(path.read_text(encoding="utf-8") for folder in ("src", "bindings") for path in (ROOT / folder).rglob("*.cpp")) \
            + "".join(path.read_text(encoding="utf-8") for path in (ROOT / "src").rglob("*.h"))
        said = set(re.findall(r"Code::(\w+)", sources)) | {"none"}
        self.assertEqual(sorted(set(update_translations.templates_of_engine()) - said), [])

    def test_each_is_put_into_words_with_parameters_of_its_kinds(self):
        for template in update_translations.templates_of_engine().values():
            names = {name: kind for _, name, kind, _ in string.Formatter().parse(template) if name and "|" not in kind}
            said = {"template": template, "parameters": {name: OF_EACH_KIND[kind] for name, kind in names.items()}}
            self.assertNotRegex(messages.english(said), r"\{\w+:|\}\}")
            self.assertEqual(user_words.in_words(said), messages.english(said))   # without a translation, and in mm

    def test_are_in_words_that_users_know(self):
        own = re.compile(r"\b(tets?|cells?|cavity|seam|entity|entities|interaction)\b|material of the other|mm3|mm³|mm²")
        for template in update_translations.templates_of_engine().values():
            self.assertIsNone(own.search(re.sub(r"\{.*?\}", "", template)), template)


class Messages(unittest.TestCase):
    def test_numbers_have_the_decimal_sign_of_freecad(self):
        before = QtCore.QLocale()
        self.addCleanup(QtCore.QLocale.setDefault, before)
        message = messages.said("{number:number}, {length:length}, {volume:volume}, {extent:extent}, {point:point}, {text:text}", number=0.5, length=2.25,
                                volume=1.5, extent=[1.5, 2.0], point=[1.5, -2.0, 0.25], text="0.20.2")
        for locale, words in (("de_DE", "0,5, 2,25 mm, 1,5 mm^3, 1,5 x 2 mm, (1,5; -2; 0,25) mm, 0.20.2"),
                              ("C", "0.5, 2.25 mm, 1.5 mm^3, 1.5 x 2 mm, (1.5, -2, 0.25) mm, 0.20.2")):
            QtCore.QLocale.setDefault(QtCore.QLocale(locale))
            self.assertEqual(user_words.in_words(message), words)
            self.assertIn("0.5, 2.25 mm", messages.english(message))

    def test_one_is_in_the_singular(self):
        def folded(count):
            return messages.said("{triangles:count} {triangles:triangle is|triangles are} folded", triangles=count)
        self.assertEqual([messages.english(folded(count)) for count in (0, 1, 2)], ["0 triangles are folded", "1 triangle is folded", "2 triangles are folded"])
        with translated({folded(1)["template"]: "{triangles:count} {triangles:Dreieck ist|Dreiecke sind} gefaltet"}):
            self.assertEqual([user_words.in_words(folded(count)) for count in (1, 2)], ["1 Dreieck ist gefaltet", "2 Dreiecke sind gefaltet"])

    def test_a_message_of_one_element_is_the_engines(self):
        template = engine.load().message_templates()["misfit_outside"]
        self.assertEqual(messages.english(messages.said(template, elements=1)), "1 element is outside the part")

    def test_what_is_no_number_is_no_nothing(self):
        self.assertEqual(messages.english(messages.said("{a:number} {b:number} {c:number}", a=float("nan"), b=float("inf"), c=1e-12)), "nan inf 0")

    def test_an_error_of_freecads_is_said_without_its_wrapping(self):
        self.assertEqual(messages.of_error(ValueError({"sclassname": "N4Base10ValueErrorE", "sErrMsg": "no external\n object", "iline": 0})), "no external object")
        self.assertEqual(messages.of_error(OSError(2, "No such file")), "[Errno 2] No such file")
        self.assertEqual(messages.english(messages.of_error(MemoryError("std::bad_alloc"))), "There is not enough memory for this mesh. Choose a larger size.")

    def test_each_kind_of_parameter(self):
        template = "; ".join("{a%s:%s}" % (kind, kind) for kind in OF_EACH_KIND if kind != "messages")
        said = {"template": template, "parameters": {"a" + kind: value for kind, value in OF_EACH_KIND.items()}}
        self.assertEqual(messages.english(said), "3; 0.5; 2.5 mm; 8 mm^3; 1 x 2 x 3 mm; (1, -2, 0.25) mm; Face12, Edge3; Pad {1}")

    def test_a_message_of_the_engine_says_what_the_engine_says(self):
        with self.assertRaises(engine.load().InputError) as caught:
            engine.load().mesh_part({"final_object": "", "records": [], "shapes": b""}, {"local": [("Wire1", 2.0)]})
        message = caught.exception.message
        self.assertEqual((message["code"], message["parameters"]), ("no_entity", {"name": "Wire1"}))
        self.assertEqual(messages.of_error(caught.exception), message)
        self.assertEqual(messages.english(message), str(caught.exception))

    def test_is_in_the_users_language_with_all_in_it(self):
        german = {"full mesh: {why:messages}": "ganz neu vernetzt: {why:messages}", "{one:entities} and {other:entities}": "{other:entities} und {one:entities}",
                  "{one:entities} and itself": "{one:entities} und sich selbst"}
        with translated(german):
            self.assertEqual(user_words.in_words(CROSSING), "ganz neu vernetzt: Edge7 und Face2; Face2 und sich selbst")
        self.assertEqual(messages.english(CROSSING), "full mesh: Face2 and Edge7; Face2 and itself")

    def test_by_itself_it_begins_with_a_capital_and_a_label_stays_as_it_is(self):
        within = messages.said("{all:messages}", all=[CROSSING, TOO_LARGE])
        self.assertEqual([user_words.as_sentence(message) for message in (messages.said("cannot write {path:text}", path="a"), within, CROSSING["parameters"]["why"][0],
                                                                          messages.said("{part:text} has no mesh", part="plate"), "plate: no", "")],
                         ["Cannot write a", "F" + user_words.in_words(within)[1:], "Face2 and Edge7", "plate has no mesh", "plate: no", ""])
        with translated({CROSSING["template"]: "überall neu"}):
            self.assertEqual(user_words.as_sentence(CROSSING), "Überall neu")

    def test_lengths_are_in_the_users_units(self):
        self.assertEqual(messages.english(messages.said("{old:volume}, {place:length}", old=1.25e-10, place=1.25e-10)), "1.25e-10 mm^3, 0 mm")
        volume = messages.said("volume {old:volume} at {place:point}", old=16387.064, place=[25.4, 0.0, -2.54])
        FreeCAD.Units.setSchema(3)   # inches with decimals
        self.addCleanup(FreeCAD.Units.setSchema, 0)
        self.assertEqual(user_words.in_words(TOO_LARGE), "The mesh size of 10 in is larger than the part, which is 2 in x 1 in x 0.5 in. "
                                                       "Ask for a smaller size.")
        self.assertEqual(user_words.in_words(volume), "volume 1 in^3 at (1 in, 0 in, -0.1 in)")
        self.assertEqual(user_words.in_words("shorter than 0.0412 mm"), "shorter than 0.001622 in")   # which FreeCAD itself shows as 0.00 in
        self.assertIn("254 mm", messages.english(TOO_LARGE))

    def test_knows_what_it_is_about(self):
        self.assertEqual(messages.entities_in(CROSSING), ["Face2", "Edge7"])
        self.assertEqual(messages.entities_in(messages.said("{a:text}", a="Face3")), [])
        self.assertEqual(messages.entities_in("Face3 cannot be meshed"), [])

    def test_names_the_features_of_faces_that_have_few(self):
        asked = []

        def labels_of(names):
            asked.append(names)
            return [{"Face2": ["Fillet"], "Edge7": ["Pad", "Fillet"], "Face9": ["A", "B", "C", "D"]}.get(name, []) for name in names]
        faces = messages.said("thin: {faces:entities}", faces=["Face2", "Face9", "Face10", "Vertex1"])
        report = messages.with_owners({"nodes": 3, "fallback": CROSSING, "warnings": [faces, "old"], "rounds": [{"refusal": None}]}, labels_of)
        self.assertEqual(asked, [["Face2", "Edge7", "Face9", "Face10"]])
        self.assertEqual(messages.in_english(report), {
            "nodes": 3, "fallback": "full mesh: Face2 (Fillet) and Edge7 (Pad, Fillet); Face2 (Fillet) and itself",
            "warnings": ["thin: Face2 (Fillet), Face9, Face10, Vertex1", "old"], "rounds": [{"refusal": None}]})
        self.assertEqual(messages.entities_in(report["fallback"]), ["Face2", "Edge7"])
        touching = messages.with_parts(messages.with_owners(messages.said("{both:entities}", both=["Face2", "Solid1", "Solid2"]), labels_of), {"Solid2": "Lid"})
        self.assertEqual(messages.english(touching), "Face2 (Fillet), Solid1, Solid2 (Lid)")
        asked.pop()
        self.assertEqual(messages.with_owners(TOO_LARGE, labels_of), TOO_LARGE)
        self.assertEqual(len(asked), 1)

    def test_an_error_names_the_features_as_the_user_does(self):
        document = new_document()
        body = plate_with_hole(document)
        document.Hole.Label = "Bohrung"
        hole = next("Face%d" % n for n, face in enumerate(body.Shape.Faces, 1) if type(face.Surface).__name__ == "Cylinder")

        def refused(progress):
            error = engine.load().MeshError("in short")
            error.message = messages.said("{face:entities} cannot be meshed", face=[hole])
            raise error
        with self.assertRaisesRegex(engine.load().MeshError, r"^%s \(Bohrung\) cannot be meshed$" % hole) as caught:
            job.run_engine(refused, reading.read_document(body), {"size": 5.0}, None)
        self.assertEqual(messages.english(messages.of_error(caught.exception)), "%s (Bohrung) cannot be meshed" % hole)

    def test_an_error_of_a_part_that_cannot_be_read_names_what_it_knows(self):
        def refused(progress):
            error = engine.load().InputError("in short")
            error.message = messages.said("{face:entities} is open", face=["Face1"])
            raise error
        with self.assertRaisesRegex(engine.load().InputError, "^Face1 is open$"):
            job.run_engine(refused, {"final_object": "", "records": [], "shapes": b""}, {"size": 5.0}, None)

    def test_names_six_faces_and_counts_the_rest(self):
        said = messages.said("{faces:entities}", faces=["Face%d" % n for n in range(1, 9)])
        self.assertEqual(messages.english(said), "Face1, Face2, Face3, Face4, Face5, Face6 and 2 more")

    def test_lengths_in_texts_are_in_the_users_units(self):
        said = ("The size of 254 mm is larger than 50.8 x 25.4 x -12.7 mm.", "volume 16387.064 -> 32774.128 mm^3", "Face2 has 3 edges, Edge12 mm",
                "node 7 at (25.4, 0, -2.54) mm")
        self.assertEqual([user_words.in_words(text) for text in said], list(said))
        FreeCAD.Units.setSchema(3)
        self.addCleanup(FreeCAD.Units.setSchema, 0)
        self.assertEqual([user_words.in_words(text) for text in said], [
            "The size of 10 in is larger than 2 in x 1 in x -0.5 in.", "volume 1 in^3 -> 2 in^3", "Face2 has 3 edges, Edge12 mm",
            "node 7 at (1 in, 0 in, -0.1 in)"])

    def test_numbers_that_belong_together_have_one_unit(self):
        point = messages.said("at {place:point}", place=[508.0, 2.54, 0.0])   # 20 in and 0.1 in
        self.addCleanup(FreeCAD.Units.setSchema, 0)
        for schema, words in ((2, "at (1.6667 ft, 0.0083333 ft, 0 ft)"), (3, "at (20 in, 0.1 in, 0 in)")):
            FreeCAD.Units.setSchema(schema)   # of US customary units, FreeCAD takes feet for the first and inches for the others
            self.assertEqual(user_words.in_words(point), words)
        FreeCAD.Units.setSchema(2)
        self.assertEqual(user_words.in_words("Hole4X 101.6 -> 508 mm"), "Hole4X 0.33333 ft -> 1.6667 ft")
        self.assertEqual(user_words.in_words("50.8 x 25.4 x 0.254 mm"), "2 in x 1 in x 0.01 in")

    def test_figures_are_written_as_people_write_them(self):
        for value, digits, text in ((16500.4, 4, "16500"), (-99999.7, 5, "-100000"), (1e12, 4, "1e+12"), (0.00012345, 3, "0.000123"), (0.0, 4, "0")):
            self.assertEqual(messages.figure(value, digits), text)
        self.assertEqual(messages.figure(164190.3, 5), "164190")

    def test_figures_have_the_users_units(self):
        self.addCleanup(FreeCAD.Units.setSchema, 0)
        for schema, mpa, mm in ((0, (1.0, "MPa"), (1.0, "mm")), (3, (0.006894757, "psi"), (25.4, "in")), (4, (1.0, "MPa"), (10.0, "cm"))):
            FreeCAD.Units.setSchema(schema)
            for unit, wanted in (("MPa", mpa), ("mm", mm)):
                one, name = user_words.unit_of(unit)
                self.assertEqual(name, wanted[1], schema)
                self.assertAlmostEqual(one / wanted[0], 1, 5)

    def test_sentences_of_older_documents_stay(self):
        self.assertEqual(user_words.in_words("meshed from scratch: 100 % new {words}"), "meshed from scratch: 100 % new {words}")

    def test_several_are_one(self):
        self.assertIsNone(messages.several([None, ""]))
        self.assertIs(messages.several([None, TOO_LARGE]), TOO_LARGE)
        self.assertEqual(messages.english(messages.several(["older words", CROSSING["parameters"]["why"][1]])), "older words; Face2 and itself")

    def test_a_sentence_before_others_ends_without_a_full_stop(self):
        why = [TOO_LARGE, CROSSING["parameters"]["why"][1], TOO_LARGE]
        self.assertEqual(messages.english({**CROSSING, "parameters": {"why": why}}).count("Ask for a smaller size;"), 1)
        self.assertTrue(messages.english({**CROSSING, "parameters": {"why": why}}).endswith("itself; " + messages.english(TOO_LARGE)))
        self.assertEqual(messages.english({**CROSSING, "parameters": {"why": []}}), "full mesh: ")

    def test_of_a_whole_report(self):
        self.assertEqual(messages.in_english({"nodes": 3, "fallback": None, "warnings": [CROSSING, "old"]}),
                         {"nodes": 3, "fallback": None, "warnings": ["full mesh: Face2 and Edge7; Face2 and itself", "old"]})

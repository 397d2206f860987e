# SPDX-License-Identifier: GPL-3.0-or-later
"""Random edits with loads on random faces, clicked and scripted: none ends on a face that nobody chose, none is lost in silence.

A few edits by default; FEATUREMESH_REFERENCE_EDITS=500 for the long run, FEATUREMESH_SOAK_SEED and FEATUREMESH_SOAK_EXAMPLES as for the other random edits.
"""
import collections
import json
import os
import random
import sys
import unittest

import FreeCAD
import ObjectsFem
from freecad.featuremesh import api, references, versions
from freecad.featuremesh.messages import english
from reference_oracle import Oracle
from test_following import names_of, open_example
from test_soak import ENGINE_ERRORS, Editor

EDITS = int(os.environ.get("FEATUREMESH_REFERENCE_EDITS", "16"))
NAMES = [name for name in os.environ.get("FEATUREMESH_SOAK_EXAMPLES", "").split(",") if name] or \
    ["bracket", "block_and_cylinder", "tool", "csg_flange"]
LOADS = 6


class PlacingEditor(Editor):
    """Moves and turns the part and the container that a body is in, too."""

    def edit(self):
        if self.chance.random() < 0.2:
            words, self.undo = self.place()
            api.recompute(self.document)
            return words
        return super().edit()

    def place(self):
        placed = self.chance.choice([self.part, container_of(self.part) or self.part])
        before = FreeCAD.Placement(placed.Placement)
        shift, axis = (FreeCAD.Vector(*(round(self.chance.uniform(-30, 30), 2) for _ in range(3))) for _ in range(2))
        turn = self.chance.choice([0, 0, 90, round(self.chance.uniform(-180, 180), 1)])
        placed.Placement = FreeCAD.Placement(shift, FreeCAD.Rotation(axis, turn)).multiply(before)

        def undo():
            placed.Placement = before
        return "%s placed, turned by %g deg" % (placed.Name, turn), undo


def container_of(part):
    """The App::Part that the part is in, or None."""
    return part.getParentGeoFeatureGroup()


class RandomEdits(unittest.TestCase):

    def test_loads_stay(self):
        seed = int(os.environ.get("FEATUREMESH_SOAK_SEED", 21 if EDITS < 100 else random.randrange(1 << 30)))
        verdicts = collections.Counter()
        for index, name in enumerate(NAMES):
            share = EDITS * (index + 1) // len(NAMES) - EDITS * index // len(NAMES)
            self.edit_example(name, random.Random("%s %d" % (name, seed)), share, verdicts)
        print("seed %d, %d edits: %s" % (seed, EDITS, dict(verdicts)), file=sys.stderr)
        judged = sum(verdicts.values()) - verdicts["not judged"]
        self.assertGreater(judged, sum(verdicts.values()) / 3)
        self.assertLessEqual(verdicts["lost, but there"], 0.02 * judged)

    def edit_example(self, name, chance, edits, verdicts):
        document = open_example(self, name)
        part = document.getObject("Body") or document.getObject("Flange")
        if part.TypeId == "PartDesign::Body":
            document.addObject("App::Part", "Container").addObject(part)
        mesh = api.add_mesh(part, size=round(part.Shape.BoundBox.DiagonalLength / 8, 1), order=1)
        mesh.Automatic = False
        api.update_mesh(mesh)
        editor = PlacingEditor(document, part, chance)
        analysis = document.Analysis
        for index in range(edits):
            loads = self.renew_loads(analysis, part, chance)
            chosen = {load: references.record_of([load], self.resolver(part))[load.Name]["names"] for load in loads}
            oracle = Oracle(part)
            words = editor.edit()
            try:
                api.update_mesh(mesh)
            except ENGINE_ERRORS as error:
                print("%s %d: %s: refused: %s" % (name, index, words, error), file=sys.stderr)
                editor.take_back()
                continue
            found = collections.Counter()
            for load, before in chosen.items():
                now = [sub for _, sub in names_of(load)]
                verdict = oracle.judge(before, now)
                found[verdict] += 1
                with self.subTest(example=name, edit=index, what=words, load=load.Name, before=before, now=now):
                    self.assertNotIn(verdict, ("stranger", "not all of it"))
                    if not now:
                        self.assertIn(load, [obj for obj, _ in references.unmended(analysis)])
                        self.assertTrue(any(english(line).startswith(load.Label + " ") for line in json.loads(mesh.Report)["warnings"]))
                if verdict not in ("right", "not judged"):
                    print("%s %d: %s: %s, %s -> %s" % (name, index, words, verdict, before, now), file=sys.stderr)
            print("%s %d: %s: %s" % (name, index, words, dict(found)), file=sys.stderr)
            verdicts.update(found)

    @staticmethod
    def resolver(part):
        from freecad.featuremesh.resolving import Resolver
        return Resolver(part)

    def renew_loads(self, analysis, part, chance):
        """Loads on one or two random faces each: named by a script, as a click makes them, and by a path through the container."""
        document = analysis.Document
        for load in [obj for obj in analysis.Group if obj.Name.startswith("Random")]:
            document.removeObject(load.Name)
        loads, faces = [], len(part.Shape.Faces)
        for number in range(LOADS):
            load = ObjectsFem.makeConstraintPressure(document, "Random%d" % number)
            names = ["Face%d" % n for n in chance.sample(range(1, faces + 1), min(faces, chance.choice([1, 1, 2])))]
            load.References = [self.as_referred(part, number % 3, names)]
            analysis.addObject(load)
            loads.append(load)
        return loads

    @staticmethod
    def as_referred(part, way, names):
        """A reference to faces of the part by one of three ways, where it has them."""
        if way == 0 or part.TypeId != "PartDesign::Body":
            return part, tuple(names)
        if way == 1 or versions.version() >= (1, 0):   # which crashes where a load refers to a face through a container
            return part.Tip, tuple(names)
        return container_of(part), tuple("%s.%s.%s" % (part.Name, part.Tip.Name, name) for name in names)

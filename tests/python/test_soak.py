# SPDX-License-Identifier: GPL-3.0-or-later
"""Random edits in a row on every example: each mesh valid, what was kept the same bits, no drift, no growth.

A few edits each by default; FEATUREMESH_SOAK_EDITS=50 for the long run, FEATUREMESH_SOAK_EXAMPLES=bracket,tool for some of the examples,
FEATUREMESH_SOAK_SEED=7 for another seed than 21, with which a few edits are made, or than a random one, with which many are.
"""
import collections
import os
import random
import resource
import shutil
import sys
import tempfile
import unittest

import FreeCAD
import numpy as np
from freecad.featuremesh import api, documents, engine, mesh_object, reading, versions
from freecad.featuremesh.errors import UserError
from freecad.featuremesh.messages import in_english

EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "resources", "examples")
EDITS = int(os.environ.get("FEATUREMESH_SOAK_EDITS", "3"))
NAMES = [name for name in os.environ.get("FEATUREMESH_SOAK_EXAMPLES", "").split(",") if name] or \
    ["bracket", "block_and_cylinder", "tool", "csg_flange"]
LOOKS_EVERY = 5        # edits, at how far the mesh is from a full one
ELEMENTS = 18          # along the part's diagonal
ENGINE_ERRORS = (UserError, engine.load().MeshError, engine.load().KernelError)
PRIMITIVES = ("PartDesign::SubtractiveCylinder", "PartDesign::AdditiveBox", "PartDesign::SubtractiveBox")


def megabytes():
    """Memory in use now."""
    with open("/proc/self/statm", encoding="ascii") as stream:
        return int(stream.read().split()[1]) * resource.getpagesize() / 1e6


class Editor:
    """Random edits of a document. Each is undone at once when FreeCAD cannot recompute it."""

    def __init__(self, document, part, chance):
        self.document, self.part, self.chance = document, part, chance
        self.added = []
        self.undo = lambda: None    # of the last edit

    def edit(self):
        """Makes one edit that FreeCAD can recompute. Returns it in words."""
        for _ in range(40):
            kinds = [self.change, self.change, self.move]
            if self.part.TypeId == "PartDesign::Body":
                kinds += [self.add] + ([self.delete] if self.added else [])
            words, self.undo = self.chance.choice(kinds)()
            if words is None:
                continue
            try:
                api.recompute(self.document)
                shape = self.part.Shape
                if shape.isValid() and len(shape.Solids) == 1 and shape.Volume > 1 and not self._misses():
                    return words
            except UserError:
                pass
            self.take_back()
        raise AssertionError("no edit of 40 could be recomputed")

    def take_back(self):
        self.undo()
        api.recompute(self.document)

    def _misses(self):
        """Does one of the boxes and cylinders of the body not touch it? FreeCAD 0.20 then shifts the whole body."""
        features = [obj for obj in getattr(self.part, "Group", []) if obj.TypeId.startswith(("PartDesign::Additive", "PartDesign::Subtractive"))
                    and obj.BaseFeature is not None]
        return any(feature.Shape.isNull() or abs(feature.Shape.Volume - feature.BaseFeature.Shape.Volume) < 1e-9 * feature.Shape.Volume
                   for feature in features)

    def change(self):
        """A dimension by up to a fifth."""
        assignments = list(self._dimensions())
        name, value = self.chance.choice(assignments)
        new = round(value * self.chance.uniform(0.8, 1.2), 3)
        return self._set(name, value, new)

    def move(self):
        """A placement by up to a few mm."""
        places = [obj for obj in self.document.Objects
                  if obj.TypeId in ("Part::Cylinder", "Part::Cone") or obj.TypeId.startswith("PartDesign::Additive")
                  or obj.TypeId.startswith("PartDesign::Subtractive")]
        if not places:
            return self.change()
        obj = self.chance.choice(places)
        axis = self.chance.choice("xy")
        value = getattr(obj.Placement.Base, axis)
        return self._set("%s.Placement.Base.%s" % (obj.Name, axis), value, round(value + self.chance.uniform(-4, 4), 3))

    def add(self):
        """A box or a cylinder, added or cut out, somewhere in the part's box."""
        box, kind = self.part.Shape.BoundBox, self.chance.choice(PRIMITIVES)
        tip = self.part.Tip
        obj = self.part.newObject(kind, "Soak")
        size = 0.06 * box.DiagonalLength * self.chance.uniform(0.5, 1.5)
        at = [self.chance.uniform(low, high) for low, high in ((box.XMin, box.XMax), (box.YMin, box.YMax), (box.ZMin, box.ZMax))]
        if kind.endswith("Cylinder"):
            obj.Radius, obj.Height = round(size / 2, 3), round(3 * size, 3)
        else:
            obj.Length, obj.Width, obj.Height = round(size, 3), round(1.3 * size, 3), round(1.7 * size, 3)
        obj.Placement.Base = FreeCAD.Vector(*(round(x, 3) for x in at))
        self.part.Tip = obj
        self.added.append(obj.Name)

        def undo():
            self._remove(obj.Name, tip)
        return "%s %s added" % (kind, obj.Name), undo

    def delete(self):
        """The feature that was added last."""
        name = self.added[-1]
        features = [obj.Name for obj in self.part.Group if obj.isDerivedFrom("PartDesign::Feature")]
        if features[-1] != name:
            return None, None
        self._remove(name, self.document.getObject(features[-2]))
        return "%s deleted" % name, lambda: None

    def _remove(self, name, tip):
        self.part.Tip = tip
        self.document.removeObject(name)
        self.added.remove(name)

    def _dimensions(self):
        for obj in self.document.Objects:
            if obj.isDerivedFrom("Sketcher::SketchObject"):
                for constraint in obj.Constraints:
                    if constraint.Name and constraint.Driving and abs(constraint.Value) > 0.5:
                        yield "%s.%s" % (obj.Name, constraint.Name), constraint.Value
            elif obj.isDerivedFrom("PartDesign::Feature") or obj.TypeId.startswith("Part::"):
                for name in ("Length", "Width", "Height", "Radius", "Radius1", "Radius2"):
                    value = getattr(getattr(obj, name, None), "Value", 0)
                    if value > 0.5 and getattr(obj, "Type", None) != "ThroughAll" and not (name == "Radius" and "Fillet" in obj.TypeId):
                        yield "%s.%s" % (obj.Name, name), value

    def _set(self, name, old, new):
        def undo():
            api.set_parameters(self.document, ["%s=%.17g" % (name, old)])
        try:
            api.set_parameters(self.document, ["%s=%.17g" % (name, new)])
        except UserError:
            return None, None
        return "%s: %g -> %g" % (name, old, new), undo


class Soak(unittest.TestCase):

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        for known in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(known)

    def test_random_edits(self):
        seed = int(os.environ.get("FEATUREMESH_SOAK_SEED", 21 if EDITS < 20 else random.randrange(1 << 30)))
        totals, done = collections.Counter(), 0
        try:
            for name in NAMES:
                with self.subTest(example=name, seed=seed):
                    done += self.soak(name, random.Random("%s %d" % (name, seed)), totals)
        finally:
            print("seed %d: %d edits; fallbacks: %s" % (seed, done, dict(totals) or "none"), file=sys.stderr)

    def soak(self, name, chance, totals):
        path = os.path.join(self.folder, name + ".FCStd")
        shutil.copyfile(os.path.join(EXAMPLES, name + ".FCStd"), path)
        document = documents.open_document(path)
        part = document.getObject("Body") or document.getObject("Flange")
        mesh = api.add_mesh(part, size=round(part.Shape.BoundBox.DiagonalLength / ELEMENTS, 1), order=1)
        mesh.Automatic = False
        api.update_mesh(mesh)
        editor, kept_shares, sizes, distances, states = Editor(document, part, chance), [], [], [], [mesh.Proxy._raw]
        for index in range(EDITS):
            before = self.arrays(mesh)
            words = editor.edit()
            try:
                report = api.update_mesh(mesh)
            except ENGINE_ERRORS as error:
                # A part that cannot be meshed at all is no failure of the update.
                with self.subTest(example=name, edit=index, what=words, error=str(error)), self.assertRaises(ENGINE_ERRORS):
                    engine.load().mesh_part(reading.read_document(part), mesh_object.options_of(mesh, part))
                totals["refused as a full mesh is: " + reason_of(str(error))] += 1
                print("%s %d: %s: refused: %s" % (name, index, words, error), file=sys.stderr)
                editor.take_back()
                continue
            after = self.arrays(mesh)
            with self.subTest(example=name, edit=index, what=words):
                self.check_valid(mesh)
                self.check_kept(before, after, mesh.Proxy.last_part_mesh(mesh))
            report = in_english(report)
            if report["fallback"]:
                totals[reason_of(report["fallback"])] += 1
            for detail in {feature["detail"] for feature in report["difference"]["features"] if "treated as changed" in (feature["detail"] or "")}:
                totals[reason_of(detail)] += 1
            kept_shares.append(report["kept"]["nodes_share"])
            states = [states[-1], mesh.Proxy._raw]
            sizes.append((os.path.getsize(mesh.SavedState), report["nodes"]))
            if index % LOOKS_EVERY == 0 or index == EDITS - 1:
                distances.append(self.distance_from_full_mesh(mesh))
            print("%s %d: %s: %d tets, %.1f %% kept, %s" % (name, index, words, report["tets"], 100 * kept_shares[-1],
                                                         report["fallback"] or "no fallback"), file=sys.stderr)
        with self.subTest(example=name, what="drift"):   # what comes after is measured in any case
            self.check_drift(mesh, distances)
        # the state grows with the part, not with the number of edits
        (first, first_nodes), (last, last_nodes) = sizes[0], sizes[-1]
        self.assertLess(last, 1.5 * first * max(1, last_nodes / first_nodes) + 50 * last_nodes)
        self.check_numbers(mesh)
        self.check_memory(mesh, states)
        return len(kept_shares)

    def check_numbers(self, mesh):
        """Of small meshes random edits use numbers up; asked for, they start at 1 again."""
        api.renumber_mesh(mesh)
        self.assertEqual(max(mesh.FemMesh.Nodes), mesh.NodeCount)

    def check_memory(self, mesh, states):
        """Updates to and fro between the last two states. FreeCAD keeps the memory of every mesh that is handed over to it, so none is."""
        options, load = mesh_object.options_of(mesh, versions.part_of(mesh)), engine.load()
        part_mesh, memory, rounds = load.mesh_part(states[-1], options)[0], [], 12 if EDITS >= 20 else 5
        for _ in range(rounds):
            for raw in states:
                part_mesh = load.update_part(part_mesh, raw, options)[0]
            memory.append(megabytes())
        print("memory by round, MB: %s" % " ".join("%.0f" % m for m in memory), file=sys.stderr)
        # A state of the smallest example is some 10 MB; the allocator's own scatter is below one of them.
        self.assertLess(memory[-1] - memory[2], 10)

    def arrays(self, mesh):
        return {name: np.array(values) for name, values in mesh.Proxy.arrays(mesh).items()}

    def check_valid(self, mesh):
        """All invariants of the whole mesh, whatever the update itself looked at."""
        raw, options, arrays = mesh.Proxy._raw, mesh_object.options_of(mesh, versions.part_of(mesh)), mesh.Proxy.arrays(mesh)
        engine.load().restore_part(raw, options, arrays)
        used = [arrays[name].ravel() for name in ("tets", "tet_mids", "triangles", "segments")]
        self.assertEqual(len(np.unique(np.concatenate(used))), len(arrays["points"]), "a node without elements")

    def check_kept(self, before, after, part_mesh):
        origin = part_mesh.node_origin()
        kept = origin >= 0
        self.assertTrue(np.array_equal(before["node_numbers"][origin[kept]], after["node_numbers"][kept]))
        moved = (before["points"][origin[kept]] != after["points"][kept]).any(axis=1)
        # Other bits only where a feature was carried, and then whole tets with their shape.
        for number in after["node_numbers"][kept][moved][:50]:
            self.check_carried(number, before, after)
        self.assertTrue((after["node_numbers"][~kept] >= before["counters"][2]).all(), "a number was given twice")
        tets = part_mesh.tet_origin()
        self.assertTrue((after["tet_numbers"][tets < 0] >= before["counters"][3]).all(), "a number was given twice")
        for name in ("node_numbers", "tet_numbers", "triangle_numbers", "segment_numbers"):
            self.assertEqual(len(np.unique(after[name])), len(after[name]))

    def check_carried(self, number, before, after):
        tet = np.flatnonzero((after["node_numbers"][after["tets"]] == number).any(axis=1) & np.isin(after["tet_numbers"], before["tet_numbers"]))[:1]
        for row in tet:
            old = np.flatnonzero(before["tet_numbers"] == after["tet_numbers"][row])[0]
            sides = [np.linalg.norm(a["points"][a["tets"][r]][[0, 1, 2, 3]] - a["points"][a["tets"][r]][[1, 2, 3, 0]], axis=1)
                     for a, r in ((before, old), (after, row))]
            self.assertLess(np.abs(sides[0] - sides[1]).max(), 1e-9)

    def distance_from_full_mesh(self, mesh):
        """Of its mean radius ratio, and its number of tets as a share of theirs."""
        options = mesh_object.options_of(mesh, versions.part_of(mesh))
        full = engine.load().mesh_part(mesh.Proxy._raw, options)[1]
        return mesh.MeanRadiusRatio - full["quality"]["mean_radius_ratio"], mesh.TetCount / full["tets"]

    def check_drift(self, mesh, distances):
        """One mesh of some hundred tets scatters by 0.01 and more, so only a mean of many can carry narrower bounds."""
        ratios, tets = zip(*distances)
        print("mean radius ratio %.4f; less that of a full mesh, %d times on the way: mean %+.4f, lowest %+.4f, at the end %+.4f; %.3f times its tets; "
              "largest node number %.2f times the count" % (
                  mesh.MeanRadiusRatio, len(ratios), np.mean(ratios), min(ratios), ratios[-1], np.mean(tets),
                  mesh.Proxy.arrays(mesh)["node_numbers"].max() / mesh.NodeCount), file=sys.stderr)
        are_many = len(ratios) >= 10
        self.assertGreater(np.mean(ratios), -0.005 if are_many else -0.02)
        self.assertGreater(np.mean(tets), 0.95 if are_many else 0.8)


def reason_of(fallback):
    """A fallback without its figures, so that equal ones add up."""
    return "".join(letter for letter in fallback.split(";")[0] if not letter.isdigit())[:120]

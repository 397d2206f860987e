# SPDX-License-Identifier: GPL-3.0-or-later
"""Random parts with details of a millionth to a hundredth of their size: each gets a valid mesh, in both orders.

A few by default; FEATUREMESH_DETAIL_PARTS=500 for the long run, FEATUREMESH_SOAK_SEED=7 for another seed than 5. Then what is refused counts only
where Gmsh, if it is installed, meshes the part; FEATUREMESH_DETAIL_SECONDS (60, of a processor) is how long one may take. The refused parts
are written to FEATUREMESH_DETAIL_FOLDER, if given, as BREP files.
"""
import collections
import json
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

import FreeCAD
import numpy
import Part
from detailed_parts import detailed_part
from freecad.featuremesh import engine, reading
from parts import new_document

PARTS = int(os.environ.get("FEATUREMESH_DETAIL_PARTS", "6"))
SEED = int(os.environ.get("FEATUREMESH_SOAK_SEED", "5"))
SECONDS = int(os.environ.get("FEATUREMESH_DETAIL_SECONDS", "60"))
FOLDER = os.environ.get("FEATUREMESH_DETAIL_FOLDER")
ELEMENTS = (40, 30, 20, 15)    # along the part's diagonal
MOST_OFF = 0.05                # of the volume, by the chords of curved faces
# Seed, part and order: the end of a groove in the side of a step, no wider than is ignored; six strips with thousands of tets without a volume; a
# block that is not quite flush with another one; a floor of 0.002 under a hole, with 21 tets without a volume; a floor of 0.0036 and a drill of 0.00015;
# floors of 0.0004 and 0.0093 under holes that meet
REFUSED_ONCE = ((5, 272, 1), (11, 30, 1), (12, 10, 2), (21, 60, 1), (21, 60, 2), (42, 69, 2),
                (28710, 56, 1), (28710, 56, 2))


def mesh_and_measure(raw, options, volume):
    """The number of tets, the share of the part's volume that they fill, and the rounds that it took. Throws what the engine does."""
    engine_module = engine.load()
    part_mesh, report = engine_module.mesh_part(raw, options)
    arrays = part_mesh.arrays()
    engine_module.restore_part(raw, options, arrays)    # all invariants of the mesh
    corners = arrays["points"][arrays["tets"]]
    sides = corners[:, 1:] - corners[:, :1]
    filled = abs(numpy.linalg.det(sides).sum()) / 6
    return {"tets": report["tets"], "share": filled / volume, "angle": report["quality"]["min_dihedral"],
            "rounds": [round_["reason"] for round_ in report["rounds"]], "warnings": [line["code"] for line in report["warnings"]]}


def in_a_process(work):
    """What the function returns, and processor seconds; a part that takes longer than SECONDS, or crashes, is a refusal."""
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
        try:
            result = work()
        except Exception as error:    # of any kind, since the parent tells it
            result = {"refused": str(error)}
        seconds = os.times()
        result["seconds"] = seconds.user + seconds.system + seconds.children_user + seconds.children_system
        os.write(writer, json.dumps(result).encode())
        os._exit(0)
    os.close(writer)
    with os.fdopen(reader, "rb") as pipe:
        data = pipe.read()
    _, status = os.waitpid(child, 0)
    if data:
        return json.loads(data)
    return {"refused": "more than %d s" % SECONDS if os.WIFSIGNALED(status) and os.WTERMSIG(status) in (signal.SIGXCPU, signal.SIGKILL)
            else "ended with %d" % status, "seconds": SECONDS}


def gmsh_meshes(shape, size):
    """Whether Gmsh makes tetrahedra of it with the sizes that FreeCAD would give it; None where it is not installed."""
    if shutil.which("gmsh") is None:
        return None
    with tempfile.TemporaryDirectory() as folder:
        brep, out = os.path.join(folder, "part.brep"), os.path.join(folder, "part.msh")
        shape.exportBrep(brep)
        try:
            done = subprocess.run(["gmsh", brep, "-3", "-algo", "del3d", "-clmin", str(0.1 * size), "-clmax", str(size), "-clcurv", "12", "-nt", "1",
                                   "-format", "msh22", "-o", out, "-v", "2"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                  timeout=10 * SECONDS, check=False)
        except subprocess.TimeoutExpired:
            return False
        if done.returncode != 0 or not os.path.exists(out):
            return False
        with open(out, encoding="ascii") as lines:
            return any(words[1] == "4" for words in map(str.split, lines) if len(words) > 8)


class RandomDetails(unittest.TestCase):

    def test_every_part_has_a_mesh(self):
        self.check_parts((SEED, index, (1, 2)) for index in range(PARTS))

    def test_parts_that_were_refused_have_one(self):
        self.check_parts((seed, index, (order,)) for seed, index, order in REFUSED_ONCE)

    def test_a_part_refused_without_its_smallest_details_is_meshed_with_them(self):
        """A wedge and two blind holes with floors of 0.0047."""
        new_document()
        feature = FreeCAD.ActiveDocument.addObject("Part::Feature", "Part")
        feature.Shape, _ = detailed_part(random.Random("details 41 11"))
        size = feature.Shape.BoundBox.DiagonalLength / 15
        options = {"size": size, "min_size": 0.1 * size, "order": 1, "threads": 1, "ignore_below": 0.0}
        result = in_a_process(lambda: mesh_and_measure(reading.read_document(feature), options, feature.Shape.Volume))
        self.assertLess(abs(result["share"] - 1), MOST_OFF)
        self.assertIn("details", result["rounds"])

    def test_small_tets_between_short_edges_stay(self):
        """A strip as thin as lettering beside a large block: at its cut corner tets have next to no volume, but are not flat."""
        width, cut, height = 0.1, 0.0046, 0.001
        corners = [FreeCAD.Vector(*at) for at in ((0, 0), (1.3, 0), (1.3, width), (cut, width), (0, width - cut), (0, 0))]
        strip = Part.Face(Part.makePolygon(corners)).extrude(FreeCAD.Vector(0, 0, height))
        strip.translate(FreeCAD.Vector(34, 31, 31))
        new_document()
        feature = FreeCAD.ActiveDocument.addObject("Part::Feature", "Part")
        feature.Shape = Part.makeCompound([Part.makeBox(32, 32, 32), strip])
        size = feature.Shape.BoundBox.DiagonalLength / 12
        for order in (1, 2):
            options = {"size": size, "min_size": 0.1 * size, "order": order, "threads": 1, "ignore_below": 0.0}
            with self.subTest(order=order):
                result = in_a_process(lambda options=options: mesh_and_measure(reading.read_document(feature), options, feature.Shape.Volume))
                self.assertNotIn("refused", result)
                self.assertLess(abs(result["share"] - 1), 1e-6)
                self.assertIn("thin_elements_remain_beside", result["warnings"])

    def check_parts(self, parts):
        new_document()
        totals = collections.Counter()
        for seed, index, orders in parts:
            shape, words = detailed_part(random.Random("details %d %d" % (seed, index)))
            feature = FreeCAD.ActiveDocument.addObject("Part::Feature", "Part")
            feature.Shape = shape
            raw, diagonal = reading.read_document(feature), shape.BoundBox.DiagonalLength
            for order in orders:
                size = diagonal / ELEMENTS[(index + order - 1) % len(ELEMENTS)]
                with self.subTest(seed=seed, part=index, order=order, what=words):
                    self.check_mesh(raw, shape, {"size": size, "min_size": 0.1 * size, "order": order, "threads": 1, "ignore_below": 0.0}, index, totals)
            feature.Document.removeObject(feature.Name)
        print("seed %d: %s" % (SEED, dict(totals)), file=sys.stderr)

    def check_mesh(self, raw, shape, options, index, totals):
        result = in_a_process(lambda: mesh_and_measure(raw, options, shape.Volume))
        print("part %d, order %d: %s" % (index, options["order"], result), file=sys.stderr)
        totals["seconds"] += result["seconds"]
        totals["tets"] += result.get("tets", 0)
        totals["refused" if "refused" in result else "meshed"] += 1
        if "refused" not in result:
            self.assertLess(abs(result["share"] - 1), MOST_OFF)
            return
        if FOLDER:
            shape.exportBrep(os.path.join(FOLDER, "%d-%d.brep" % (SEED, index)))
        by_gmsh = gmsh_meshes(shape, options["size"])
        totals["refused, meshed by Gmsh: %s" % by_gmsh] += 1
        self.assertIs(by_gmsh, False, result["refused"])

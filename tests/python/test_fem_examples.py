# SPDX-License-Identifier: GPL-3.0-or-later
"""FreeCAD's own FEM examples with our mesh in place of theirs: CalculiX runs, and finds the same.

A few in each run, all of them when FEATUREMESH_LONG is set. The examples are those of the running FreeCAD. Left out are shells and
beams, and constraint_centrif, one of whose rings is held by nothing.
"""
import importlib.util
import math
import shutil
import unittest
from unittest import mock

from analyses import LONG, clear_results, print_table, solve
from freecad.featuremesh import api, mesh_object, versions
from parts import new_document

WITHIN = 0.02
LATER_NAMES = {"thermomech_bimetall": "thermomech_bimetal"}
# Tets of an even mesh have 1.7 times the number of regular ones of the same edge length in the same volume.
OURS_PER_REGULAR = 0.85
EULER_OVER_LOAD = math.pi ** 2 * 210000 * (1.5 * 1 ** 3 / 12) / (4 * 8 ** 2) / 21
# (example, what is compared, in each run, its true value where that is known and the example's own elements are far from it)
EXAMPLES = [
    ("ccx_cantilever_faceload", "displacement", True, None),
    ("ccx_cantilever_nodeload", "displacement", True, None),
    ("ccx_cantilever_prescribeddisplacement", "displacement", False, None),
    ("constraint_selfweight_cantilever", "displacement", False, None),
    ("boxanalysis_static", "displacement", True, None),
    ("boxanalysis_frequency", "frequency", False, None),
    ("frequency_beamsimple", "frequency", False, None),
    ("ccx_buckling_flexuralbuckling", "buckling", False, EULER_OVER_LOAD),  # linear hexahedra, 11 % too stiff
    ("constraint_section_print", "displacement", False, None),
    ("constraint_transform_beam_hinged", "displacement_z", True, None),     # nothing holds it along the hinges
    ("constraint_transform_torque", "displacement", False, None),
    ("constraint_tie", "displacement", False, None),
    ("constraint_contact_solid_solid", "displacement", False, None),
    ("material_multiple_bendingbeam_fiveboxes", "displacement", False, None),
    ("material_multiple_tensionrod_twoboxes", "displacement", True, None),
    ("material_nl_platewithhole", "displacement", False, None),
    ("thermomech_bimetall", "displacement", True, None),
    ("thermomech_spine", "coldest", True, None),                            # 12 tets: only its temperature means something
]


def example_here(example):
    """The name of that example in the running FreeCAD, None when it has it no more."""
    return next((name for name in (example, LATER_NAMES.get(example)) if name and importlib.util.find_spec("femexamples." + name)), None)


def set_up(example, document):
    """The example with the mesh that FreeCAD brings along for it; since 1.1 Gmsh would make another where it is installed, of linear tets."""
    setup = importlib.import_module("femexamples." + example).setup
    if importlib.util.find_spec("femexamples.meshes.generate_mesh") is None:
        setup(document)
        return
    with mock.patch("femexamples.meshes.generate_mesh.mesh_from_mesher", return_value=False):
        setup(document)


@unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
class FemExamples(unittest.TestCase):

    def test_our_mesh_gives_the_figures_of_the_examples(self):
        rows = []
        for example, measure, always, truth in EXAMPLES:
            if always or LONG:
                example = example_here(example)
                if example is None:
                    continue
                with self.subTest(example):
                    rows.append(self.compare(example, measure, truth))
        self.assertGreater(len(rows), 4)
        print_table("FreeCAD's FEM examples", ("example", "compared", "its tets", "our tets", "its figure", "ours", "off, %"), rows)

    def compare(self, example, measure, truth):
        """A row of the table."""
        document = new_document()
        set_up(example, document)
        analysis = document.Analysis
        theirs, = [member for member in analysis.Group if member.isDerivedFrom("Fem::FemMeshObject")]
        part, elements = versions.part_of(theirs), theirs.FemMesh.VolumeCount
        reference = solve(analysis)[measure]
        clear_results(analysis)
        analysis.removeObject(theirs)
        document.removeObject(theirs.Name)
        size = OURS_PER_REGULAR * (6 * math.sqrt(2) * part.Shape.Volume / elements) ** (1 / 3)
        mesh = api.add_mesh(part, size, order=2)
        document.recompute()
        self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
        ours = solve(analysis)[measure]
        off = ours / (truth or reference) - 1
        self.assertLess(abs(off), WITHIN, "%s: %g, the example itself %g" % (example, ours, truth or reference))
        return (example, measure, elements, mesh.TetCount, "%.5g" % reference, "%.5g" % ours,
                "%+.2f" % (100 * off) + (" of %.5g" % truth if truth else ""))

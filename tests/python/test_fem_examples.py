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

import numpy as np
from analyses import LONG, clear_results, print_table, solve
from freecad.featuremesh import api, engine, mesh_object, statics, versions
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


# Those that are linear statics of solids, and what the live solver says of each other one that is static.
LIVE = {"ccx_cantilever_faceload", "ccx_cantilever_nodeload", "ccx_cantilever_prescribeddisplacement", "constraint_selfweight_cantilever", "boxanalysis_static",
        "material_multiple_tensionrod_twoboxes"}
NOT_LIVE = {"constraint_section_print": "SectionPrint", "constraint_transform_beam_hinged": "Transform", "constraint_transform_torque": "Transform",
            "constraint_tie": "Tie", "constraint_contact_solid_solid": "Contact",
            "material_multiple_bendingbeam_fiveboxes": "refers to another object than the meshed part",
            "material_nl_platewithhole": "nonlinear"}


def with_our_mesh(example):
    """The document of an example with our mesh in place of its own, of about as many tets."""
    document = new_document()
    set_up(example, document)
    theirs, = [member for member in document.Analysis.Group if member.isDerivedFrom("Fem::FemMeshObject")]
    part, elements = versions.part_of(theirs), theirs.FemMesh.VolumeCount
    document.Analysis.removeObject(theirs)
    document.removeObject(theirs.Name)
    mesh = api.add_mesh(part, OURS_PER_REGULAR * (6 * math.sqrt(2) * part.Shape.Volume / elements) ** (1 / 3), order=2)
    document.recompute()
    return document, mesh


@unittest.skipUnless(shutil.which("ccx") and not engine.load().statics_missing(), "PETSc or CalculiX is not installed")
class LiveOnFemExamples(unittest.TestCase):

    def test_linear_statics_of_solids_is_as_calculix_has_it(self):
        rows = []
        for example, _, always, _ in EXAMPLES:
            if example in LIVE and (always or LONG):
                with self.subTest(example):
                    rows.append(self.compare(example))
        self.assertGreater(len(rows), 3)
        print_table("The live solver on FreeCAD's FEM examples", ("example", "nodes", "displacement, CalculiX", "live", "worst node, %", "worst stress, %"), rows)

    def compare(self, example):
        document, mesh = with_our_mesh(example)
        fields, report = statics.solve(document.Analysis)
        theirs = api.solve_analysis(document.Analysis, "ccx")
        result = document.getObject(theirs["result"])
        there = np.array([tuple(vector) for vector in result.DisplacementVectors])
        mises = np.array(result.vonMises)
        self.assertEqual(len(there), mesh.NodeCount)
        off = np.abs(fields["displacements"] - there).max() / np.abs(there).max()
        off_stress = np.abs(fields["von_mises"] - mises).max() / mises.max()
        self.assertLess(off, 1e-3)
        self.assertLess(off_stress, 5e-3)
        for name in ("max_displacement_mm", "strain_energy_mj"):
            self.assertAlmostEqual(report["responses"][name] / theirs["responses"][name], 1, delta=1e-3)
        return (example, mesh.NodeCount, "%.5g" % theirs["responses"]["max_displacement_mm"], "%.5g" % report["responses"]["max_displacement_mm"],
                "%.4f" % (100 * off), "%.4f" % (100 * off_stress))

    def test_what_else_the_examples_hold_is_named(self):
        for example, kind in NOT_LIVE.items():
            if example_here(example) and (LONG or example in ("constraint_tie", "constraint_transform_beam_hinged")):
                with self.subTest(example):
                    document, _ = with_our_mesh(example)
                    with self.assertRaisesRegex(statics.NotUnderstood, kind):
                        statics.solve(document.Analysis)


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
        print_table("FreeCAD's FEM examples", ("example", "compared", "its elements", "our elements", "its figure", "ours", "off, %"), rows)

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

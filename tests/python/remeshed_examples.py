# SPDX-License-Identifier: GPL-3.0-or-later
"""FreeCAD's own examples, solved with the mesh that they bring along and then with ours."""
from analyses import LONG, clear_results, print_table, solve
from freecad.featuremesh import api, mesh_object, versions
from parts import new_document
from test_fem_examples import example_here, set_up

WITHIN = 0.02   # of the largest displacement
STEEL = {"Name": "Steel", "YoungsModulus": "210000 MPa", "PoissonRatio": "0.30", "Density": "7900 kg/m^3"}


class RemeshedExamples:
    """For test cases. `meshing_of` tells of the part and the mesh of an example how many elements that has, and the size and the order of ours."""

    def meshing_of(self, part, fem_mesh):
        raise NotImplementedError

    def check_examples(self, kind, elements, examples):
        """`examples` are (name, in each run), `kind` and `elements` the words of the table that is printed."""
        rows = []
        for example, always in examples:
            if example_here(example) and (always or LONG):
                with self.subTest(example):
                    rows.append(self.compared(example))
        self.assertGreater(len(rows), 1)
        print_table("FreeCAD's %s examples" % kind, ("example", "its " + elements, "ours", "its displacement, mm", "ours, mm", "off, %"), rows)

    def compared(self, example):
        """The example's row of the table."""
        document = new_document()
        set_up(example, document)
        analysis = document.Analysis
        theirs, = [member for member in analysis.Group if member.isDerivedFrom("Fem::FemMeshObject")]
        part = versions.part_of(theirs)
        count, size, order = self.meshing_of(part, theirs.FemMesh)
        reference = solve(analysis)["displacement"]
        clear_results(analysis)
        analysis.removeObject(theirs)
        document.removeObject(theirs.Name)
        mesh = api.add_mesh(part, size, order, active_analysis=analysis)
        document.recompute()
        self.assertEqual(mesh.Status, mesh_object.UP_TO_DATE)
        ours = solve(analysis)["displacement"]
        self.assertLess(abs(ours / reference - 1), WITHIN, "%s: %g, the example itself %g" % (example, ours, reference))
        return (example, count, mesh.TetCount, "%.5g" % reference, "%.5g" % ours, "%+.2f" % (100 * (ours / reference - 1)))

# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads on parts that touch, as they are in CalculiX's input: each acts on the part that was chosen, and is as large as it is."""
import os
import shutil
import unittest

import numpy as np
import ObjectsFem
from analyses import add_material, add_solver, quantity
from femmesh.meshsetsgetter import MeshSetsGetter
from femtools import membertools
from freecad.featuremesh import api, versions
from parts import groups_of, placement
from statics_cases import HAS_SOLVER, STEEL, Case, faces_at
from test_assemblies import FORCE, InADocument, nodes_by_solid


class WhereAnotherPartLies(InADocument):
    """A strip lies on a plate, along one of its edges: FreeCAD finds the strip's nodes there, too."""

    def setUp(self):
        super().setUp()
        plate, strip = (self.document.addObject("Part::Box", name) for name in ("Plate", "Strip"))
        for box, width, height in ((plate, 40, 0), (strip, 10, 10)):
            box.Length, box.Width, box.Height, box.Placement = 40, width, 10, placement(0, 0, height)
        self.document.recompute()
        self.mesh = self.meshed(self.compound([plate, strip]), 5, 1)
        self.part = versions.part_of(self.mesh)
        self.plate = self.part.Shape.Solids[0]
        self.analysis = ObjectsFem.makeAnalysis(self.document, "Analysis")
        add_solver(self.document, self.analysis)
        add_material(self.document, self.analysis, "Steel", STEEL)
        self.analysis.addObject(self.mesh)

    def added(self, make, shape):
        """What `make` adds to the analysis, on one of the plate's shapes."""
        kind = shape.ShapeType
        shapes = {"Face": self.part.Shape.Faces, "Edge": self.part.Shape.Edges, "Vertex": self.part.Shape.Vertexes}[kind]
        load = make(self.document)
        load.References = [(self.part, next(kind + str(number) for number, own in enumerate(shapes, 1) if own.isSame(shape)))]
        self.analysis.addObject(load)
        return load

    def found(self):
        """What FreeCAD's writer of CalculiX input found, as its members of the analysis."""
        member = membertools.AnalysisMember(self.analysis)
        MeshSetsGetter(self.analysis, self.document.Solver, self.mesh, member).get_mesh_sets()
        return member

    def test_forces_are_as_large_as_they_are(self):
        """They grew by the strip's share on the face, ended in an error of Python on the edge, and were left out on the vertex."""
        top = next(face for face in self.plate.Faces if face.CenterOfMass.z > 9.999)
        edge = next(edge for edge in top.Edges if edge.CenterOfMass.y < 0.001)
        for shape in (top, edge, edge.Vertexes[0]):
            force = self.added(ObjectsFem.makeConstraintForce, shape)
            force.Force = quantity(FORCE, "N")
        plate, = [nodes for nodes in nodes_by_solid(self.mesh) if all(self.mesh.FemMesh.Nodes[node].z < 10.001 for node in nodes)]
        for entry in self.found().cons_force:
            loads = [(node, getattr(load, "Value", load)) for _, table in entry["NodeLoadTable"] for node, load in table.items()]
            self.assertAlmostEqual(sum(load for _, load in loads) / FORCE, 1, places=6)
            self.assertLessEqual({node for node, _ in loads}, plate)

    def test_a_force_on_a_coarse_circle(self):
        """Of which the chords are shorter by more than a hundredth: an error of Python in FreeCAD 0.20."""
        drum = self.document.addObject("Part::Cylinder", "Drum")
        drum.Radius = 20
        self.analysis.removeObject(self.mesh)
        self.mesh, self.part = self.meshed(drum, 20, 1), drum
        if self.mesh not in self.analysis.Group:
            self.analysis.addObject(self.mesh)
        self.added(ObjectsFem.makeConstraintForce, next(edge for edge in drum.Shape.Edges if edge.Closed)).Force = quantity(FORCE, "N")
        (_, loads), = self.found().cons_force[0]["NodeLoadTable"]
        self.assertAlmostEqual(sum(getattr(load, "Value", load) for load in loads.values()) / FORCE, 0.97, delta=0.02)

    def test_heat_and_section_prints_are_those_of_the_part_that_was_chosen(self):
        self.document.Solver.AnalysisType = "thermomech"
        for make in (ObjectsFem.makeConstraintHeatflux, ObjectsFem.makeConstraintSectionPrint):
            self.added(make, next(face for face in self.plate.Faces if face.CenterOfMass.z > 9.999))
        found = self.found()
        (heat,), (printed,) = found.cons_heatflux, found.cons_sectionprint
        (_, heated, *_), = heat.get("HeatFluxFaceTable") or heat["HeatFluxFaces"]
        for elements in (heated, printed["SectionPrintFaces"]):
            self.assertGreater(len(elements), 10)
            self.assertLessEqual({element for element, _ in elements}, set(groups_of(self.mesh)["Solid1"]))


@unittest.skipUnless(HAS_SOLVER and shutil.which("ccx"), "this machine has no CalculiX, or no PETSc")
class AnyLoads(Case):
    """The live solver and CalculiX, which gets FreeCAD's input, find the same."""

    def test_random_loads(self):
        seed = int(os.environ.get("FEATUREMESH_SOAK_SEED", "5"))
        print("seed", seed)
        random = np.random.default_rng(seed)
        for _ in range(int(os.environ.get("FEATUREMESH_LOAD_CASES", "4"))):
            self.setUp()
            part = self.document.addObject("Part::Compound", "Compound")
            part.Links = [self.box(*random.choice((10, 20, 30), 2).tolist(), 10) for _ in range(2)]
            part.Links[1].Placement = placement(*random.choice((0, 5), 2).tolist(), 10)
            self.document.recompute()
            analysis = self.analysis()
            self.fix(analysis, part, faces_at(part, 2, 0) + faces_at(part, 2, 20))
            for kind in ("Face", "Edge", "Vertex", "Pressure"):
                names = ["%s%d" % (kind if kind != "Pressure" else "Face", number) for number in random.choice(np.arange(1, 13), 2, replace=False)]
                if kind == "Pressure":
                    self.add(analysis, ObjectsFem.makeConstraintPressure, kind, [(part, names)], Pressure=quantity(2.0, "MPa"))
                else:
                    self.force(analysis, part, names, name=kind, along=int(random.integers(3)))
            self.mesh(part, 5, int(random.integers(1, 3)))
            live, ccx = (api.solve_analysis(analysis, which)["responses"] for which in ("live", "ccx"))
            for name in ("max_displacement_mm", "max_mises_mpa"):
                self.assertAlmostEqual(ccx[name] / live[name], 1, delta=1e-3)


if __name__ == "__main__":
    unittest.main()

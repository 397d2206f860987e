# SPDX-License-Identifier: GPL-3.0-or-later
"""One case of a study, made as a worker makes it: which mesh and analysis of a document it is of, and where its responses are taken."""
import os
import tempfile
import unittest
from unittest import mock

import FreeCAD
from analyses import quantity
from freecad.featuremesh import api, mesh_properties
from freecad.featuremesh.study import base, case_run, window_run
from freecad.featuremesh.study.design import Study, parse_parameter
from freecad.featuremesh.study.response_words import parse_response
from parts import plate_with_hole
from statics_cases import HAS_SOLVER, Case, faces_at

RADIUS = 5.0


@unittest.skipUnless(HAS_SOLVER, "PETSc is not installed")
class Documents(Case):

    def setUp(self):
        super().setUp()
        self.body, self.analysis_of_plate = plate_with_hole(self.document), self.analysis()
        self.held, self.pulled = (faces_at(self.body, 0, place)[0] for place in (0, 60))
        self.fix(self.analysis_of_plate, self.body, [self.held])
        self.force(self.analysis_of_plate, self.body, [self.pulled])
        self.mesh_of_plate = self.mesh(self.body, 8)
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def saved(self):
        """The path of the document, which is closed."""
        self.document.saveAs(self.path("part.FCStd"))
        FreeCAD.closeDocument(self.document.Name)
        return self.path("part.FCStd")

    def case(self, document, *responses, out="base.FCStd", **more):
        """(what a worker has opened, the responses of a case of it)."""
        plain = Study(document, [parse_parameter("HoleSketch.Radius=4:8")], list(map(parse_response, responses)), object="Body", **more).to_plain()
        facts = base.make(plain, self.path(out))
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)
        opened = case_run.Base(self.path(out), plain, facts["solver"])
        found = case_run.run(opened, {"id": 1, "parameters": {"HoleSketch.Radius": RADIUS}, "set": ["HoleSketch.Radius=%r" % RADIUS], "folder": self.folder.name})
        self.assertEqual(found["state"], "done", found["message"])
        return opened, found["responses"]

    def test_each_of_two_analyses_has_its_own_mesh(self):
        api.copy_analysis(self.analysis_of_plate, "Fine", mesh="own")
        self.document.FeatureMesh001.Size = 5
        self.document.recompute()
        document, nodes = self.saved(), {}
        for analysis in ("Analysis", "Fine"):
            opened, _ = self.case(document, "max_mises", analysis=analysis)
            self.assertIn(opened.mesh, opened.analysis.Group)
            nodes[analysis] = opened.mesh.Proxy.last_part_mesh(opened.mesh).arrays()["points"].shape[0]
        self.assertGreater(nodes["Fine"], nodes["Analysis"])

    def test_an_analysis_that_shares_the_mesh(self):
        """CalculiX takes the mesh of the object that shows it there."""
        push = api.copy_analysis(self.analysis_of_plate, "Push")
        next(member for member in push.Group if member.isDerivedFrom("Fem::ConstraintForce")).Force = quantity(2000.0, "N")
        self.document.recompute()
        document = self.saved()
        once, live, ccx = (self.case(document, "max_displacement", analysis=analysis, solver=solver)[1]["max_displacement"]
                           for analysis, solver in (("Analysis", "live"), ("Push", "live"), ("Push", "ccx")))
        self.assertAlmostEqual(live / once, 2, places=4)
        self.assertAlmostEqual(ccx / live, 1, places=3)

    def test_other_meshes_are_left_as_they_are(self):
        """Each case made them anew, and wrote into the folder that the worker's other cases read."""
        box = self.document.addObject("Part::Box", "Other")
        box.setExpression("Length", "HoleSketch.Constraints.Radius * 10")
        self.document.recompute()
        api.add_mesh(box, 5, order=1, join_analysis=False)
        self.document.recompute()
        opened, _ = self.case(self.saved(), "max_mises")
        self.assertEqual([mesh.Status for mesh in api.meshes_of(opened.document)], [mesh_properties.UP_TO_DATE, mesh_properties.OUT_OF_DATE])

    def test_a_document_that_was_the_base_of_another_study(self):
        """Its faces were asked in place of those of this one."""
        _, there = self.case(self.saved(), "max_displacement@" + self.held, out="first.FCStd")
        self.assertEqual(list(there.values()), [0])
        _, there = self.case(self.path("first.FCStd"), "max_displacement@" + self.pulled)
        self.assertGreater(list(there.values())[0], 1e-4)

    def test_any_number_of_jobs_in_the_property_editor(self):
        """With fewer than none the study did nothing and never ended."""
        with mock.patch.object(window_run.subprocess, "Popen"):
            found = [window_run.WindowRun(self.folder.name, jobs).jobs for jobs in (-2, 0, 1, 10000)]
        processors = len(os.sched_getaffinity(0))
        self.assertEqual(found, [processors, processors, 1, processors])


if __name__ == "__main__":
    unittest.main()

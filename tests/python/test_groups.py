# SPDX-License-Identifier: GPL-3.0-or-later
"""The groups by which a solver finds the nodes of loads are where these are, also when undo, redo or a new label came without a recompute."""
import unittest
from unittest import mock

import ObjectsFem
from femmesh import meshtools
from freecad.featuremesh import api, hand_over
from meshed_plate import MeshedPlate
from parts import groups_in_freecad, placement
from test_load_cases import face_across


class GroupsFollow(MeshedPlate):

    def setUp(self):
        super().setUp()
        self.document.UndoMode = 1
        self.analysis = ObjectsFem.makeAnalysis(self.document, "Analysis")
        self.analysis.addObject(self.mesh)
        self.left, self.right = (face_across(self.body, 0, place) for place in (0, 60))
        self.fixed = ObjectsFem.makeConstraintFixed(self.document, "Fixed")
        self.fixed.References = [(self.body, self.right)]
        self.analysis.addObject(self.fixed)
        self.document.recompute()

    def step(self, change):
        """One step of undo."""
        self.document.openTransaction("Step")
        change()
        self.document.commitTransaction()

    def places(self, group):
        """Where the nodes of a group are along x; None where there is no such group."""
        nodes = self.mesh.FemMesh.Nodes
        return {round(nodes[number].x, 6) for number in groups_in_freecad(self.mesh)[group]} if group in groups_in_freecad(self.mesh) else None

    def test_another_face_is_undone_and_redone(self):
        self.step(lambda: setattr(self.fixed, "References", [(self.body, self.left)]))
        self.assertEqual(self.places("Fixed_Nodes"), {0})
        self.document.undo()
        self.assertEqual(self.places("Fixed_Nodes"), {60})
        self.document.redo()
        self.assertEqual(self.places("Fixed_Nodes"), {0})
        self.document.openTransaction("Cancelled")
        self.fixed.References = [(self.body, self.right)]
        self.document.abortTransaction()
        self.assertEqual(self.places("Fixed_Nodes"), {0})

    def test_groups_that_are_right_stay(self):
        """Thousands of them, of a load on many faces, were made anew with each face that was clicked."""
        fem_mesh = self.mesh.FemMesh
        before = {group: fem_mesh.getGroupName(group) for group in fem_mesh.Groups}
        api.add_group(self.mesh, [(self.body, self.left)], name="Left")
        after = {group: fem_mesh.getGroupName(group) for group in fem_mesh.Groups}
        self.assertEqual({**after, **before}, after)
        self.assertEqual(set(after.values()) - set(before.values()), {"Left", "Left_Nodes"})
        self.document.removeObject("Left")
        self.assertEqual({group: fem_mesh.getGroupName(group) for group in fem_mesh.Groups}, before)

    def test_a_deleted_support_comes_back(self):
        self.step(lambda: self.document.removeObject("Fixed"))
        self.assertIsNone(self.places("Fixed_Nodes"))
        self.document.undo()
        self.assertEqual(self.places("Fixed_Nodes"), {60})

    def test_a_mesh_that_left_its_analysis_comes_back(self):
        self.step(lambda: self.analysis.removeObject(self.mesh))
        self.step(self.edit)
        self.document.undo()
        self.document.undo()
        self.assertEqual(self.places("Fixed_Nodes"), {60})

    def test_mesh_groups(self):
        group = api.add_group(self.mesh, [(self.body, self.right)])
        self.document.recompute()
        self.step(lambda: setattr(group, "References", [(self.body, self.left)]))
        self.assertEqual(self.places(group.Name + "_Nodes"), {0})
        self.document.undo()
        self.assertEqual(self.places(group.Name + "_Nodes"), {60})
        group.UseLabel = True
        for label, name in (("Öse", "Öse"), ("two\nlines", "two lines"), ("", group.Name), ("Face1", "Face1"), ("A, b", "A, b")):
            self.step(lambda label=label: setattr(group, "Label", label))
            self.assertEqual({name, name + "_Nodes", "Fixed_Nodes", self.right + "_Nodes"}, set(groups_in_freecad(self.mesh)))
        self.document.undo()
        self.assertEqual(self.places("Face1_Nodes"), {60})

    def test_a_mesh_that_comes_while_groups_are_made_has_its_own(self):
        """The window's timers go on while the engine is asked what a reference means."""
        in_the_meantime, original = [lambda: api.update_mesh(self.mesh, full=True)], hand_over.analysis_groups

        def asked(*words):
            found = original(*words)
            for come in [in_the_meantime.pop()] if in_the_meantime else []:
                come()
            return found
        with mock.patch.object(hand_over, "analysis_groups", asked):
            self.mesh.Proxy.renew_groups(self.mesh)
        self.assertEqual(self.mesh.Status, "up to date")
        now = groups_in_freecad(self.mesh)
        self.mesh.Proxy.renew_groups(self.mesh)
        self.assertEqual(now, groups_in_freecad(self.mesh))

    def solved_places(self, support):
        """Where along x FreeCAD holds the nodes of a support when it writes CalculiX's input."""
        nodes = self.mesh.FemMesh.Nodes
        return {round(nodes[number].x, 6) for number in meshtools.get_femnodes_by_femobj_with_references(self.mesh.FemMesh, {"Object": support})}

    def test_supports_whose_names_begin_alike(self):
        """FreeCAD takes the first group whose name begins with that of the support and _."""
        first, last = (ObjectsFem.makeConstraintFixed(self.document, name) for name in ("Fixed_left", "Fixed_left_too"))
        first.References, last.References = [(self.body, self.left)], [(self.body, self.right)]
        self.analysis.Group = [self.mesh, last, first, self.fixed]
        api.update_mesh(self.mesh, full=True)
        self.assertEqual([self.solved_places(support) for support in (self.fixed, first, last)], [{60}, {0}, {60}])

    def test_a_mesh_group_with_the_name_of_a_support(self):
        self.fixed.Label = "Clamp"
        group = api.add_group(self.mesh, [(self.body, self.left)])
        group.UseLabel, group.Label = True, "Fixed"
        for make in (lambda: None, lambda: api.update_mesh(self.mesh, full=True)):
            make()
            self.assertEqual((self.solved_places(self.fixed), self.places("Fixed_2_Nodes")), ({60}, {0}))

    def test_a_part_that_was_moved_without_a_recompute(self):
        """By FreeCAD's dragger, and undone is what came after it: the mesh of before is not that of the part."""
        self.step(lambda: setattr(self.body, "Placement", placement(5)))
        self.step(self.edit)
        self.assertEqual(self.mesh.Status, "up to date")
        self.document.undo()
        self.assertRegex(self.mesh.Status, "^out of date")
        self.document.recompute()
        self.assertEqual((self.mesh.Status, self.places("Fixed_Nodes")), ("up to date", {65}))
        for _ in range(2):
            self.step(self.edit)
            self.document.undo()
            self.assertEqual(self.mesh.Status, "up to date")


if __name__ == "__main__":
    unittest.main()

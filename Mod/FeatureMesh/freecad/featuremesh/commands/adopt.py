# SPDX-License-Identifier: GPL-3.0-or-later
import FreeCAD
import FreeCADGui as Gui

from .. import adopt, api, preferences, reading, versions
from ..errors import UserError
from ..gui import message_box, recording
from ..messages import said
from ..mesh_object import is_feature_mesh
from .base import MeshCommand

translate = FreeCAD.Qt.translate


class Command(MeshCommand):
    name = "FeatureMesh_Adopt"
    text = "Adopt a mesh"
    tooltip = "Turns the selected mesh of Gmsh, Netgen or another maker (or the only one) into one that follows the part"

    def is_possible(self, document):
        return bool(_foreign_meshes(document.Objects))

    def run(self, document):
        selected = _foreign_meshes(Gui.Selection.getSelection(document.Name)) or _foreign_meshes(document.Objects)
        if len(selected) != 1:
            raise UserError(said("the document has several meshes, select the one to adopt: {meshes:text}", meshes=", ".join(mesh.Label for mesh in selected)))
        part = adopt.part_of(selected[0]) or reading.find_meshable(document)
        existing = [mesh for mesh in api.meshes_of(document) if versions.part_of(mesh) is part][-1:]
        if not existing or self.may_take_place(part, existing[0]):
            self.adopt(selected[0], part, *existing)

    def may_take_place(self, part, mesh):
        """The part has a mesh of ours: is the adopted one to take its place?"""
        return message_box.answer(self.title, translate("FeatureMesh", "%s has the mesh %s already.") % (part.Label, mesh.Label),
                                  translate("FeatureMesh", "The adopted mesh can take its place; %s stays in the document.") % mesh.Label,
                                  {"take": translate("FeatureMesh", "Take its place")})

    def adopt(self, foreign, part, existing=None):
        mesh, _ = recording.run(api.adopt_mesh, foreign, part, in_place_of=existing, **preferences.for_adopted_mesh())
        for obj in filter(None, (foreign, existing, versions.part_of(mesh))):
            obj.ViewObject.Visibility = False   # two things in one place flicker
        mesh.ViewObject.Visibility = True
        Gui.Selection.clearSelection()


def _foreign_meshes(objects):
    return [obj for obj in objects if obj.isDerivedFrom("Fem::FemMeshObject") and not is_feature_mesh(obj)]

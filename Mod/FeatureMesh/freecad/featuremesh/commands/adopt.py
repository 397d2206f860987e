# SPDX-License-Identifier: GPL-3.0-or-later
import FreeCADGui as Gui

from .. import api, versions
from ..errors import UserError
from ..messages import said
from ..mesh_object import is_feature_mesh
from .base import MeshCommand


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
        mesh, _ = api.adopt_mesh(selected[0])
        for obj in (selected[0], versions.part_of(mesh)):
            obj.ViewObject.Visibility = False   # two things in one place flicker
        mesh.ViewObject.Visibility = True
        Gui.Selection.clearSelection()


def _foreign_meshes(objects):
    return [obj for obj in objects if obj.isDerivedFrom("Fem::FemMeshObject") and not is_feature_mesh(obj)]

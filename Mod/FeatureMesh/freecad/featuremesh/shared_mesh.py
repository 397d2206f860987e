# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh of ours in a second analysis: the same nodes, elements and numbers, with the groups of that analysis.

In FreeCAD an object is in one group at most, so an analysis gets an object of its own that shows another's mesh.
"""

import FreeCAD
import Fem

from . import analyses, given_mesh, hand_over, state, versions
from .errors import StateError
from .given_mesh import give
from .mesh_properties import choose_form, is_saved_for_freecad
from .proxies import Stateless
from .resolving import Resolver

translate = FreeCAD.Qt.translate


class SharedMesh(Stateless):
    """Proxy of the object. Its class path is stored in documents and never changes."""

    Type = analyses.SHARED
    _shown = ""   # which state of the mesh FemMesh is of
    _is_opened = False   # not before all of its document, or of what is pasted, is there

    def __init__(self, shared, mesh):
        self._is_opened = True
        shared.Proxy = self
        shared.addProperty("App::PropertyLink", "Mesh", "Mesh", "The mesh object whose mesh this analysis is solved with")
        if versions.part_property(mesh) not in shared.PropertiesList:
            shared.addProperty("App::PropertyLinkGlobal", versions.part_property(mesh), "Mesh", "The meshed part")
        shared.Mesh = mesh
        setattr(shared, versions.part_property(mesh), versions.part_of(mesh))

    def execute(self, shared):
        """Called by recompute."""
        self.show(shared)

    def onChanged(self, shared, name):
        """Called by FreeCAD when a property was set."""
        if not self._is_opened:
            given_mesh.set_aside(shared)

    def onDocumentRestored(self, shared):
        self._is_opened, mesh = True, shared.Mesh
        with given_mesh.Opened(shared) as opened:
            if mesh is None or not state.checksum_of(mesh.SavedState):
                return
            try:
                arrays = state.load(mesh.SavedState).arrays
            except StateError:
                return   # the mesh's own object says so
            opened.fem_mesh = hand_over.reopened(shared.FemMesh, arrays, lambda: mesh.Proxy.groups_as_saved(mesh, arrays, shared))
            opened.skin = hand_over.skin(shared, arrays)
        self._shown = state.checksum_of(mesh.SavedState)
        shared.purgeTouched()

    def show(self, shared, anew=False):
        """Makes FemMesh what the mesh is now; with `anew` also where it is that already, for other groups."""
        mesh = shared.Mesh
        if mesh is None:
            return
        checksum = state.checksum_of(mesh.SavedState)
        if checksum == self._shown and not anew:
            return
        if checksum:
            part_mesh = mesh.Proxy.last_part_mesh(mesh)
            groups = hand_over.groups_of(part_mesh.arrays(), part_mesh.owners_of_tets, mesh, analysis_of=shared)
            give(shared, hand_over.build(part_mesh.arrays(), groups), hand_over.skin(shared, part_mesh.arrays()))
        else:
            give(shared, Fem.FemMesh())
        self._shown = checksum
        shared.purgeTouched()

    def renew_groups(self, shared):
        """Makes the groups of constraints, materials and mesh group objects anew, without touching the mesh."""
        mesh = shared.Mesh
        if mesh is not None and self._shown and versions.part_of(mesh) is not None:
            hand_over.renew_groups(shared, Resolver(versions.part_of(mesh)), mesh.Proxy.arrays(mesh))

    def why_not_to_solve(self, shared):
        """As of the mesh itself; or that it is gone."""
        if shared.Mesh is None:
            return translate("FeatureMesh", "%s shows a mesh that was deleted; delete it, too, and give the analysis another mesh") % shared.Label
        return shared.Mesh.Proxy.why_not_to_solve(shared.Mesh)

    def state_of_mesh(self, shared):
        """As of the mesh itself."""
        return shared.Mesh.Proxy.state_of_mesh(shared.Mesh) if shared.Mesh is not None else ""

    def state_of_part(self, shared):
        """As of the mesh itself."""
        return shared.Mesh.Proxy.state_of_part(shared.Mesh) if shared.Mesh is not None else ""


def share(mesh, analysis):
    """Adds to `analysis` an object that shows the mesh. Returns it."""
    shared = mesh.Document.addObject(versions.mesh_object_type(), mesh.Name + "_" + analysis.Name)
    SharedMesh(shared, mesh)
    shared.Label = "%s (%s)" % (mesh.Label, analysis.Label)
    analyses.take_in(analysis, shared)
    choose_form(shared, is_saved_for_freecad(mesh))
    shared.Proxy.show(shared, anew=True)
    return shared

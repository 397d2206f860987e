# SPDX-License-Identifier: GPL-3.0-or-later
"""The analyses of a document: which of them a new mesh joins, which meshes they have, and what in them goes with a mesh."""

import FreeCAD

from . import versions
from .errors import UserError
from .mesh_properties import is_of_its_part
from .messages import said
from .proxies import type_of
from .reading import describe, refuse_gone
from .resolving import Resolver, pairs_of

translate = FreeCAD.Qt.translate
MESH_IS_SUPPRESSED = FreeCAD.Qt.QT_TRANSLATE_NOOP("FeatureMesh", "{mesh:text} is suppressed, and {analysis:text} has no other mesh")
_OURS, SHARED, _STUDY = "Fem::FeatureMesh", "Fem::FeatureMeshShared", "FeatureMesh::Study"


def for_new_mesh(part, active=None):
    """(the analysis that a new mesh of `part` is to join, or None; what the user should know of it, or "").

    The active one, else the only one, else the only one whose loads, supports or materials are on the part; never one that has a mesh, since
    FreeCAD solves an analysis with exactly one.
    """
    every = analyses_of(part.Document)
    meant = _meant(every, active)
    if meant is not None:
        return _unless_it_has_a_mesh(meant)
    fitting = [analysis for analysis in every if not meshes_of(analysis) and _is_about(analysis, part)]
    if len(fitting) == 1:
        return fitting[0], translate("FeatureMesh", "The mesh is in %s, which refers to %s.") % (describe(fitting[0]), describe(part))
    if not every:
        return None, ""
    return None, translate("FeatureMesh", "The mesh is in no analysis, because none of %s is active: drag it into the one that it is for.") % (
        ", ".join(describe(analysis) for analysis in every))


def other_makers_mesh(document, active=None):
    """(the analysis that a new mesh would join, the mesh of another maker in it), or None where no such mesh is in the way."""
    analysis = _meant(analyses_of(document), active)
    meshes = meshes_of(analysis) if analysis is not None else []
    return (analysis, meshes[0]) if len(meshes) == 1 and not is_ours(meshes[0]) else None


def refuse_other(obj):
    """Throws UserError for what is no analysis."""
    refuse_gone(obj, said("an analysis"))
    if not is_analysis(obj):
        raise UserError(said("{analysis:text} is no analysis", analysis=describe(obj)))


def is_analysis(obj):
    """Is this one of FEM's analyses?"""
    return obj.isDerivedFrom("Fem::FemAnalysis")


def analyses_of(document):
    """All analyses of the document."""
    return document.findObjects("Fem::FemAnalysis")


def meshes_in(document):
    """All mesh objects of ours in the document. FreeCAD looks for them by their type, which takes it a hundredth of the time that all objects take in Python."""
    return [obj for obj in document.findObjects("Fem::FemMeshObject") if type_of(obj) == _OURS]


def holding(obj):
    """The analyses that the object is in, itself or by an object that shows its mesh there."""
    direct = directly_holding(obj)
    others = [analysis for shared in shares_of(obj) for analysis in directly_holding(shared)]
    return direct + [analysis for analysis in others if analysis not in direct]


def directly_holding(obj):
    """The analyses that the object is in itself."""
    return list(filter(is_analysis, obj.InList))


def shares_of(mesh):
    """The objects by which other analyses have the mesh, too."""
    return [obj for obj in dict.fromkeys(mesh.InList) if type_of(obj) == SHARED and obj.Mesh is mesh]


def source_of(mesh):
    """The mesh object of ours whose mesh it is, None for a mesh of another maker."""
    return mesh.Mesh if type_of(mesh) == SHARED else mesh if type_of(mesh) == _OURS else None


def members_of(analysis):
    """The members that FreeCAD would write; not those of an analysis in it, where FreeCAD 1.1 pastes a copy while it is selected."""
    return [member for member in analysis.Group if not getattr(member, "Suppressed", False) and not is_analysis(member)]


def meshes_of(analysis):
    """The meshes among the members of an analysis, those of results apart."""
    return [member for member in analysis.Group if member.isDerivedFrom("Fem::FemMeshObject")
            and type_of(member) != "Fem::MeshResult" and not getattr(member, "Suppressed", False)]


def mesh_of_member(member):
    """The mesh object of ours on which a member of an analysis is solved, or None."""
    return next((source_of(mesh) for analysis in directly_holding(member) for mesh in meshes_of(analysis) if is_ours(mesh)), None)


def take_in(analysis, obj, in_place_of=()):
    """Adds the object, in place of others. FreeCAD would mark the analysis for a recompute, which makes nothing of it."""
    was_touched = "Touched" in analysis.State
    for other in in_place_of:
        analysis.removeObject(other)
    analysis.addObject(obj)
    if not was_touched:
        analysis.purgeTouched()


def suppressed_mesh_of(analysis):
    """The mesh of an analysis that has no other and this one suppressed, as FreeCAD 1.1 can; None where that is not so."""
    suppressed = [member for member in analysis.Group if member.isDerivedFrom("Fem::FemMeshObject") and getattr(member, "Suppressed", False)]
    return suppressed[0] if suppressed and not meshes_of(analysis) else None


def studies_of(mesh):
    """The studies whose faces, edges and vertices go with this mesh: of several meshes of their part with the first."""
    part = versions.part_of(mesh)
    return [obj for obj in mesh.Document.Objects if type_of(obj) == _STUDY and getattr(obj, "Part", None) is part] if _is_first_of_its_part(mesh) else []


def dependents_of(mesh):
    """Constraints and materials of the analyses with this mesh, its group objects, and studies of its part."""
    members = [member for analysis in holding(mesh) for member in analysis.Group]
    return members + list(mesh.MeshGroupList) + studies_of(mesh)


def followed_by(mesh):
    """These, and with the first mesh of its part what refers to that in analyses that wait: it may be dragged there, or shared."""
    waiting = [analysis for analysis in analyses_of(mesh.Document) if _waits(analysis)] if _is_first_of_its_part(mesh) else []
    part, own = versions.part_of(mesh), dependents_of(mesh)
    clicked = part, getattr(part, "Tip", None)
    return own + [member for analysis in waiting for member in analysis.Group if member not in own and all(target in clicked for target, _ in pairs_of(member))]


def _waits(analysis):
    """Has it no mesh, or none that follows an edit by itself?"""
    return all(is_ours(mesh) and not getattr(source_of(mesh), "Automatic", False) for mesh in meshes_of(analysis))


def _is_first_of_its_part(mesh):
    """Of those that follow an edit by themselves, if there are any."""
    part = versions.part_of(mesh)
    of_part = [obj for obj in meshes_in(mesh.Document) if versions.part_of(obj) is part]
    return mesh is next((obj for obj in of_part if getattr(obj, "Automatic", True)), of_part[0] if of_part else None)


def left_behind(mesh):
    """The other meshes of its part that have not followed the last edit."""
    return [obj for obj in meshes_in(mesh.Document) if obj is not mesh and obj.SavedState and versions.part_of(obj) is versions.part_of(mesh)
            and not is_of_its_part(obj)]


def is_ours(mesh):
    """Is this one of our mesh objects, or one that shows the mesh of one?"""
    return type_of(mesh) in (_OURS, SHARED)


def _meant(every, active):
    """The active one, else the only one, or None."""
    return active if active in every else every[0] if len(every) == 1 else None


def _unless_it_has_a_mesh(analysis):
    meshes = meshes_of(analysis)
    if not meshes:
        return analysis, ""
    return None, translate("FeatureMesh", "The mesh is in no analysis: %s has %s already, and an analysis is solved with one mesh. Drag the "
                               "other one out of it and this one into it, if this one is to be solved.") % (describe(analysis), describe(meshes[0]))


def _is_about(analysis, part):
    resolver = Resolver(part)
    return any(resolver.of_object(member)[0] for member in analysis.Group if hasattr(member, "References"))

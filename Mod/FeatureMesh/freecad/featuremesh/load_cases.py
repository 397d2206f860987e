# SPDX-License-Identifier: GPL-3.0-or-later
"""Several analyses with one mesh, and copies of analyses."""

from . import analyses, reading, shared_mesh, statics_model
from .errors import UserError
from .messages import said
from .refusals import all_or_nothing

# What becomes of the mesh in a copy of an analysis.
MESHES = ("shared", "own", "none")


def share(mesh, analysis):
    """Lets a second analysis be solved with the mesh `mesh`. Returns the object in it. Throws UserError when it has a mesh already."""
    analyses.refuse_other(analysis)
    if analysis.Document is not mesh.Document:
        raise UserError(said("{mesh:text} and {analysis:text} are in two documents; an analysis is solved with a mesh of its own document",
                             mesh=reading.describe(mesh), analysis=reading.describe(analysis)))
    there = analyses.meshes_of(analysis)
    if there:
        raise UserError(said("{analysis:text} has {mesh:text} already, and an analysis is solved with one mesh",
                             analysis=reading.describe(analysis), mesh=reading.describe(there[0])))
    with all_or_nothing(mesh.Document):
        return shared_mesh.share(analyses.source_of(mesh), analysis)


def copy(analysis, name, mesh):
    """A copy of the analysis with copies of its loads, supports, materials and solvers, without results. Throws UserError."""
    analyses.refuse_other(analysis)
    if mesh not in MESHES:
        raise UserError(said("the mesh of a copy is one of {kinds:text}, not {kind:text}", kinds=", ".join(MESHES), kind=mesh))
    document = analysis.Document
    ours = next((analyses.source_of(member) for member in analyses.meshes_of(analysis) if analyses.is_ours(member)), None)
    if ours is None and mesh != "none":
        raise UserError(said("{analysis:text} has no mesh of FeatureMesh to copy along", analysis=reading.describe(analysis)))
    with all_or_nothing(document):
        made = document.addObject("Fem::FemAnalysis", name or analysis.Name)
        for member in analysis.Group:
            if member.isDerivedFrom("Fem::FemMeshObject") or analyses.is_analysis(member) or statics_model.is_result(member) or statics_model.is_part(member):
                continue
            twin = document.copyObject(member, False)
            twin.Label = "%s (%s)" % (member.Label, made.Label)
            made.addObject(twin)
        if mesh == "shared":
            share(ours, made)
        elif mesh == "own":
            made.addObject(document.copyObject(ours, False))
        return made

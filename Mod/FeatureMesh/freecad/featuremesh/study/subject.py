# SPDX-License-Identifier: GPL-3.0-or-later
"""What of a document a study is of: the analysis whose figures it asks for, and the mesh of its part. The base and each worker find the same ones."""

from .. import analyses, api, versions
from . import response_words


def analysis_of(document, study):
    """The analysis that is named or needed, or None. Throws UserError: none there, or several."""
    is_wanted = study.analysis or response_words.needs_analysis(study.responses)
    return api.find_analysis(document, study.analysis) if is_wanted else None


def mesh_of(document, study, analysis):
    """The mesh of the study's part, of several that of the analysis; None where there is none."""
    part = api.find_part(document, study.object)
    found = [mesh for mesh in api.meshes_of(document) if versions.part_of(mesh) is part]
    return next((mesh for mesh in found if shown_in(analysis, mesh)), found[0] if found else None)


def shown_in(analysis, mesh):
    """The objects by which the analysis has the mesh: itself, or one that shows it."""
    return [shown for shown in analyses.meshes_of(analysis) if analyses.source_of(shown) is mesh] if analysis is not None else []

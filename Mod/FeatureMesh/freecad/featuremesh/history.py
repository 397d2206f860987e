# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps mesh objects true to what happens around them: undo and redo, and edits of the analysis they belong to.

FreeCAD's undo does not bring back an old FemMesh, but it does bring back the saved state; so the mesh is made from that. The
groups by which a solver finds the nodes of constraints are renewed when the references of a constraint change.
"""

import FreeCAD

_observer = None


def watch():
    """Starts watching all documents; further calls do nothing."""
    global _observer
    if _observer is None:
        _observer = _Observer()
        FreeCAD.addDocumentObserver(_observer)


class _Observer:

    def slotUndoDocument(self, document):
        _show_states(document)

    def slotRedoDocument(self, document):
        _show_states(document)

    def slotAbortTransaction(self, document):
        _show_states(document)

    def slotChangedObject(self, obj, name):
        if name not in ("References", "Group") or FreeCAD.isRestoring():
            return
        analyses = [obj] if obj.isDerivedFrom("Fem::FemAnalysis") else \
            [parent for parent in obj.InList if parent.isDerivedFrom("Fem::FemAnalysis")]
        for analysis in analyses:
            for member in analysis.Group:
                if _is_ours(member):
                    member.Proxy.renew_analysis_groups(member)


def _show_states(document):
    for obj in document.Objects:
        if _is_ours(obj):
            obj.Proxy.show_state(obj)


def _is_ours(obj):
    return getattr(getattr(obj, "Proxy", None), "Type", "") == "Fem::FeatureMesh"

# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh objects that a FreeCAD without this addon has saved: it forgets whose they are, and nothing else. They become ours again."""

import FreeCAD

from .mesh_object import FeatureMesh
from .mesh_properties import OUT_OF_DATE

_observer = None


def install():
    """Looks from now on at every document that comes to be the active one; further calls do nothing."""
    global _observer
    if _observer is None:
        _observer = _Observer()
        FreeCAD.addDocumentObserver(_observer)


def adopt_all(document):
    """Makes those of a document ours again. Their parts may have been edited meanwhile, so that the next recompute updates them."""
    for obj in document.Objects:
        if obj.isDerivedFrom("Fem::FemMeshObject") and getattr(obj, "Proxy", obj) is None and "SavedState" in obj.PropertiesList:
            proxy = FeatureMesh.__new__(FeatureMesh)
            proxy.loads(None)
            obj.Proxy = proxy
            proxy.onDocumentRestored(obj)
            obj.Status = OUT_OF_DATE
            obj.touch()


class _Observer:

    def slotActivateDocument(self, document):
        if not document.Restoring:
            adopt_all(document)

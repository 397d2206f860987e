# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects of ours that a FreeCAD without this addon has saved: it forgets whose they are, and nothing else. They become ours again."""

import FreeCAD

from . import live_result, mesh_properties
from .assembled import AssembledParts
from .live_result import LiveResult
from .mesh_object import FeatureMesh
from .size_zone import SizeZone
from .study.study_object import StudyObject

# By proxy properties that no other object without one has.
_PROPERTIES = {AssembledParts: {"Container", "Join"}, SizeZone: {"InnerSize", "OuterSize"}, FeatureMesh: {"SavedState"}, LiveResult: {"SolvedState"},
               StudyObject: {"Sampling", "SecondsLimit"}}
_observer = None


def install():
    """Looks from now on at every document that comes to be the active one; further calls do nothing."""
    global _observer
    if _observer is None:
        _observer = _Observer()
        FreeCAD.addDocumentObserver(_observer)


def adopt_all(document):
    """Makes those of a document ours again. What they follow may have been edited meanwhile, so the next recompute updates them."""
    for obj in document.Objects:
        proxy_class = _class_of(obj)
        if proxy_class is None:
            continue
        proxy = proxy_class.__new__(proxy_class)
        proxy.loads(None)
        obj.Proxy = proxy
        proxy.onDocumentRestored(obj)
        if proxy_class is FeatureMesh:
            obj.Status = mesh_properties.OUT_OF_DATE
        if proxy_class is LiveResult:
            proxy.set_status(obj, live_result.OUT_OF_DATE)
        if proxy_class is not StudyObject:
            obj.touch()


def _class_of(obj):
    if getattr(obj, "Proxy", obj) is not None:
        return None
    return next((proxy_class for proxy_class, names in _PROPERTIES.items() if names <= set(obj.PropertiesList)), None)


class _Observer:

    def slotActivateDocument(self, document):
        if not document.Restoring:
            adopt_all(document)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects of ours that a FreeCAD without this addon has saved: it forgets whose they are, and nothing else. They become ours again."""

import FreeCAD

from . import assembled, error_sizes, live_result, mesh_object, mesh_properties, size_zone
from .study import study_object

# Properties that no other object without a proxy has, and the module and class of the proxy. A document may need any of these modules first, so the class
# is looked up when it is wanted.
_OURS = (({"Container", "Join"}, assembled, "AssembledParts"), ({"InnerSize", "OuterSize"}, size_zone, "SizeZone"), ({"Radii", "Sizes"}, error_sizes, "ErrorSizes"),
         ({"SavedState"}, mesh_object, "FeatureMesh"),
         ({"SolvedState"}, live_result, "LiveResult"), ({"Sampling", "SecondsLimit"}, study_object, "StudyObject"))
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
        if proxy_class is mesh_object.FeatureMesh:
            obj.Status = mesh_properties.OUT_OF_DATE
        if proxy_class is live_result.LiveResult:
            proxy.set_status(obj, live_result.OUT_OF_DATE)
        if proxy_class is not study_object.StudyObject:
            obj.touch()


def _class_of(obj):
    if getattr(obj, "Proxy", obj) is not None:
        return None
    return next((getattr(module, name) for properties, module, name in _OURS if properties <= set(obj.PropertiesList)), None)


class _Observer:

    def slotActivateDocument(self, document):
        if not document.Restoring:
            adopt_all(document)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Several parts as one shape that a mesh can be made of: the solids of a container (App::Part, group, assembly), each where it is.

A container has no shape of its own that a mesh or a load could refer to. This document object has one: a compound of its parts in their order,
whatever is hidden. Nothing is joined, so each part gets a mesh of its own, and an edit of one leaves those of the others.
"""

import FreeCAD
import Part

from . import reading
from .errors import UserError

translate = FreeCAD.Qt.translate
_CONTAINERS = ("App::Part", "App::DocumentObjectGroup")   # FreeCAD 1.x's assemblies are App::Parts, too
# Called with every object that was made or opened; the window's side adds its view there.
on_ready = []


class AssembledParts:
    """Proxy of the object. Its class path is stored in documents and never changes; reading.py and the engine know the class by its name."""

    Type = "Part::FeatureMeshAssembledParts"

    def __init__(self, obj):
        obj.Proxy = self
        self._get_ready(obj)

    def execute(self, obj):
        """Puts the parts of the container together as they are now."""
        if obj.Container is None:
            raise UserError(translate("FeatureMesh", "%s has no container, set its property Container") % reading.describe(obj))
        parts = parts_in(obj.Container)
        if not parts:
            raise UserError(translate("FeatureMesh", "%s has no part with a solid") % reading.describe(obj.Container))
        if parts != obj.Parts:
            obj.Parts = parts
        obj.Shape = Part.makeCompound([reading.shape_in_place(part) for part in parts])

    def onDocumentRestored(self, obj):
        self._get_ready(obj)

    def dumps(self):
        return None

    def loads(self, saved):
        return None

    __getstate__ = dumps
    __setstate__ = loads

    def _get_ready(self, obj):
        if "Container" not in obj.PropertiesList:
            obj.addProperty("App::PropertyLink", "Container", "Parts", "The container whose parts these are")
            obj.addProperty("App::PropertyLinkList", "Parts", "Parts", "The parts, in the order of the solids of the shape")
        obj.setEditorMode("Parts", 1)
        obj.setEditorMode("Placement", 2)   # the parts are where they are
        for hook in on_ready:
            hook(obj)


def is_container(obj):
    """Is this something that holds parts and has no shape itself?"""
    return any(obj.isDerivedFrom(kind) for kind in _CONTAINERS)


def is_assembled(obj):
    """Is this one of our objects?"""
    return isinstance(getattr(obj, "Proxy", None), AssembledParts)


def shows(obj, container):
    """Does the object show the parts of that container?"""
    return is_assembled(obj) and obj.Container is container


def parts_in(container):
    """The objects with a solid in a container and in the containers in it that none of the others is made of, in order."""
    return reading.final_solids_of([member for member in _members_of(container) if not is_assembled(member)])


def of(container):
    """The object with the shape of the container's parts, made where there is none yet. Throws UserError: no part with a solid."""
    known = [obj for obj in container.Document.Objects if shows(obj, container)]
    if known:
        return known[0]
    if not parts_in(container):
        raise UserError(translate("FeatureMesh", "%s has no part with a solid") % reading.describe(container))
    obj = container.Document.addObject("Part::FeaturePython", "AssembledParts")
    AssembledParts(obj)
    obj.Label = translate("FeatureMesh", "Parts of %s") % container.Label
    obj.Container = container
    obj.Proxy.execute(obj)
    return obj


def _members_of(container):
    for member in container.Group:
        if is_container(member):
            yield from _members_of(member)
        else:
            yield member

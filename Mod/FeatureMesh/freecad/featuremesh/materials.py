# SPDX-License-Identifier: GPL-3.0-or-later
"""Which tets each material of an analysis gets, so that FreeCAD need not search for them (which takes it minutes).

A material may refer to solids of the meshed part, or, as users of boolean fragments do, to those of the objects that it is made of.
"""

import FreeCAD
import numpy as np

from . import versions
from .messages import said
from .resolving import pairs_of, path_of

_POINTS_PER_SOLID = 8


def materials_among(members):
    """Those of an analysis's members, reinforced ones, too, whose own values are those of what is reinforced."""
    return [member for member in members if member.isDerivedFrom("App::MaterialObject")]


def material_groups(materials, resolver, entities):
    """One volume group per material, but only if together they cover every tet once: else none, and FreeCAD searches itself."""
    claimed, groups, rest = [], [], None
    for material in materials:
        if not material.References:
            if rest is not None:
                return []
            rest = material
            continue
        names = _solids_of(material, resolver, entities)
        if names is None:
            return []
        numbers = np.concatenate([entities.elements(name) for name in names])
        claimed.append(numbers)
        groups.append((material.Name + "_Volumes", "Volume", numbers))
    everything = np.sort(entities.all_elements())
    if rest is not None:
        left = np.setdiff1d(everything, np.concatenate(claimed)) if claimed else everything
        groups.append((rest.Name + "_Volumes", "Volume", left))
        claimed.append(left)
    covered = np.sort(np.concatenate(claimed)) if claimed else everything[:0]
    return groups if np.array_equal(covered, everything) else []


def doubt(materials, resolver, entities):
    """Why it is not clear which of several materials a solid has, as a message; None where it is, or cannot be told. CalculiX would take the last one."""
    if len(materials) < 2:
        return None
    solids = {material: _solids_of(material, resolver, entities) for material in materials if material.References}
    if None in solids.values():
        return None
    for solid in entities.solids():
        on_it = [material.Label for material, own in solids.items() if solid in own]
        if len(on_it) > 1:
            return said("{solid:entities} has several materials: {materials:text}; take it out of the references of all but one", solid=[solid], materials=", ".join(on_it))
        if not on_it and len(solids) == len(materials):
            return said("{solid:entities} has no material; choose one for it", solid=[solid])
    return None


def _solids_of(material, resolver, entities):
    """Names of the part's solids that a material refers to; None when it refers to something else, too."""
    names = set()
    for obj, sub in pairs_of(material):
        path, element = path_of(obj, sub)
        target = path[-1]
        is_state_of_part = resolver.is_alike(target) or target.isDerivedFrom("PartDesign::Feature")
        found = resolver.of_shown(target, element) or \
            (resolver.names(obj, sub) if is_state_of_part else _solids_within(target, element, entities))
        if not found or not all(name.startswith("Solid") for name in found):
            return None
        names.update(found)
    return sorted(names)


def _solids_within(target, sub, entities):
    """Names of the mesh's solids that lie wholly in a solid of any object, or in all its solids for ""."""
    if sub and not sub.startswith("Solid"):
        return []
    solids = target.Shape.Solids
    if sub:
        solids = solids[int(sub[len("Solid"):]) - 1:][:1]
    into_target = versions.parent_frame(target).inverse()
    found = []
    for name in entities.solids():
        points = [into_target.multVec(FreeCAD.Vector(*point)) for point in entities.points_inside(name, _POINTS_PER_SOLID)]
        if any(all(solid.isInside(point, 1e-7, True) for point in points) for solid in solids):
            found.append(name)
    return found

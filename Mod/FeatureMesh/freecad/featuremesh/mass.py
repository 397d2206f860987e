# SPDX-License-Identifier: GPL-3.0-or-later
"""The mass of a part: of its solids, of shells by their thicknesses, of beams by their sections."""

import math

import numpy as np
from femtools import femutils

from . import analyses, formats, materials, statics, statics_model
from .errors import UserError
from .hand_over import EntityGroups
from .messages import said
from .quality import contents
from .reading import describe
from .resolving import Resolver

_SECTIONS = {"triangles": ("Fem::ElementGeometry2D", said("thickness")), "segments": ("Fem::ElementGeometry1D", said("section"))}
_AREAS = {   # of FreeCAD's sections of beams, mm^2
    "Rectangular": lambda width, height: width * height,
    "Circular": lambda diameter: math.pi / 4 * diameter ** 2,
    "Elliptical": lambda first, second: math.pi / 4 * first * second,
    "Pipe": lambda diameter, thickness: math.pi * thickness * (diameter - thickness),
    "Box": lambda width, height, right, top, left, bottom: width * height - (width - right - left) * (height - top - bottom),
}
_MEASURES = {
    "Rectangular": ("RectWidth", "RectHeight"), "Circular": ("CircDiameter",), "Elliptical": ("Axis1Length", "Axis2Length"),
    "Pipe": ("PipeDiameter", "PipeThickness"), "Box": ("BoxWidth", "BoxHeight", "BoxT1", "BoxT2", "BoxT3", "BoxT4"),
}


def of_part(part, analysis, arrays):
    """kg. What the mesh says of shares is of its straight elements, the whole is FreeCAD's. Throws UserError."""
    kind, _, own, _ = formats.filling_of(arrays)
    resolver, entities = Resolver(part), EntityGroups(arrays)
    members = analyses.members_of(analysis) if analysis else []

    def by_element(found, what, value_of, numbers_of):
        if not found:
            raise UserError(said("the mass needs an analysis with a {what:messages}", what=what))
        return _by_element(arrays[own], what, [(numbers, value_of(member)) for member, numbers in zip(found, numbers_of(found))])

    def named(found):
        return [_numbers(member, resolver, entities) for member in found]

    def of_solids(found):
        groups = {name: numbers for name, _, numbers in materials.material_groups(found, resolver, entities)}
        return [groups.get(member.Name + "_Volumes", ()) for member in found]

    sizes = contents(arrays["points"], arrays[kind])
    each = by_element(materials.materials_among(members), said("material"), _density, of_solids if kind == "tets" else named) * sizes
    if kind in _SECTIONS:
        fem_type, what = _SECTIONS[kind]
        sections = [member for member in members if femutils.is_of_type(member, fem_type)]
        each *= by_element(sections, what, _thickness if kind == "triangles" else _section, named)
    return float(each.sum()) * whole(part, kind) / float(sizes.sum()) * statics.TONNE


def whole(part, kind):
    """mm^3 of a part's solids, mm^2 of its faces or mm of its edges, by the array's name of what fills it."""
    shape = part.Shape   # whose own Volume counts open sheets in
    return {"tets": lambda: sum(solid.Volume for solid in shape.Solids), "triangles": lambda: sum(face.Area for face in shape.Faces),
            "segments": lambda: sum(edge.Length for edge in shape.Edges)}[kind]()


def _by_element(own, what, claims):
    """(m,) the value of each element. `claims` are (the elements' numbers or None for all the rest, value). Throws UserError for elements without one."""
    values = np.full(len(own), np.nan)
    for numbers, value in claims:
        if numbers is not None:
            values[np.isin(own, numbers)] = value
    for value in [value for numbers, value in claims if numbers is None][:1]:
        values[np.isnan(values)] = value
    if np.isnan(values).any():
        raise UserError(said("the mass needs a {what:messages} for all of the part, and {count:count} {count:element has|elements have} none",
                             what=what, count=int(np.isnan(values).sum())))
    return values


def _numbers(member, resolver, entities):
    """Of the elements on what a member refers to, None where it refers to nothing."""
    if not member.References:
        return None
    names, _ = resolver.of_object(member)
    return np.concatenate([entities.elements(name) for name in names]) if names else ()


def _density(material):
    """t/mm^3."""
    density = statics_model.density_of(material)
    if density is None:
        raise UserError(said("the material {material:text} has no density; give it one, with its unit", material=describe(material)))
    return density


def _thickness(member):
    """mm."""
    return statics_model.amount(member.Thickness, "mm")


def _section(member):
    """mm^2."""
    if member.SectionType not in _AREAS:
        raise UserError(said("the mass of a beam with the section {section:text} of {member:text} is not known",
                             section=member.SectionType, member=describe(member)))
    return _AREAS[member.SectionType](*(statics_model.amount(getattr(member, name), "mm") for name in _MEASURES[member.SectionType]))

# SPDX-License-Identifier: GPL-3.0-or-later
"""Has FreeCAD's writer of CalculiX input write the heat that flows into the faces of shells.

FreeCAD looks for the faces of solids: of shells 0.20 and 1.0 find none, and 1.1 fails at what it finds. CalculiX takes the heat into the positive side of a
shell, by the letters POS in place of the number of a solid's face.
"""

from .wrapping import wrap

_SIDE = "POS"


def install():
    """To be called once one of our meshes is there; further calls do nothing."""
    wrap("femsolver.calculix.write_constraint_heatflux", None, "write_meshdata_constraint", _of_flux)


def _of_flux(original, stream, entry, flux, writer):
    if not writer.femmesh.VolumeCount:
        if "HeatFluxFaces" in entry:
            entry["HeatFluxFaces"] = [(place, found if is_sub_element else _sides(found), is_sub_element) for place, found, is_sub_element in entry["HeatFluxFaces"]]
        else:
            faces = [(obj, name) for obj, names in flux.References for name in names if name.startswith("Face")]
            entry["HeatFluxFaceTable"] = [("%s:%s" % (obj.Name, name), _sides(writer.femmesh.getFacesByFace(obj.Shape.getElement(name)))) for obj, name in faces]
    return original(stream, entry, flux, writer)


def _sides(elements):
    return [(element, _SIDE) for element in elements]

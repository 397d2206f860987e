# SPDX-License-Identifier: GPL-3.0-or-later
"""What differs between FreeCAD 0.20, 1.0 and 1.1, in one place."""

import functools

import FreeCAD


@functools.lru_cache(maxsize=None)
def version():
    """(major, minor) of the running FreeCAD."""
    return tuple(int(part) for part in FreeCAD.Version()[:2])


def mesh_object_type():
    """The best base class for a mesh object written in Python."""
    return "Fem::FemMeshObjectPython" if version() < (1, 0) else "Fem::FemMeshShapeBaseObjectPython"


def part_property(mesh):
    """Name of the link from a mesh object to its part: `Shape` where FreeCAD brings it along, else our own `Part`."""
    return "Part" if "Part" in mesh.PropertiesList or version() < (1, 0) else "Shape"


def part_of(mesh):
    """The object that `mesh` is a mesh of, or None."""
    return getattr(mesh, part_property(mesh), None)


def parent_frame(part):
    """Placement that takes `part.Shape` into the frame in which FEM compares nodes with geometry.

    0.20 uses the object's own placement only, 1.0 and later the global one.
    """
    if version() < (1, 0):
        return FreeCAD.Placement()
    if hasattr(part, "getGlobalPlacement"):
        return part.getGlobalPlacement().multiply(part.Placement.inverse())
    parent = part.getParentGeoFeatureGroup()  # a link, whose global placement 1.0 does not tell
    return parent.getGlobalPlacement() if parent is not None else FreeCAD.Placement()


def colour_elements(view, colours):
    """Colours the elements {number: (red, green, blue)} of a mesh's view; none: as usual. Since 1.0 a view has a mode for that."""
    view.ElementColor = colours
    if "ColorMode" in view.PropertiesList:
        view.ColorMode = "ByElement" if colours else "Overall"


def number_of(enumerator):
    """A Qt enumerator as the number that FreeCAD's task panels ask for: PySide 2 converts by int(), PySide 6 has `value`."""
    return int(getattr(enumerator, "value", enumerator))


def follows_faces():
    """Does FreeCAD itself move references when faces get other numbers? Since 1.0."""
    return version() >= (1, 0)


def asks_manipulators():
    """Does FreeCAD ask manipulators of workbenches when it builds toolbars and menus? Since 1.0."""
    return version() >= (1, 0)

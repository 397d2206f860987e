# SPDX-License-Identifier: GPL-3.0-or-later
"""What differs between FreeCAD 0.20, 1.0 and 1.1, in one place."""

import functools
import os
import re
import sys

import FreeCAD

_SAME_PLACE = 1e-7   # mm, and of the numbers of a rotation


@functools.lru_cache(maxsize=None)
def version():
    """(major, minor) of the running FreeCAD."""
    return tuple(int(part) for part in FreeCAD.Version()[:2])


def text():
    """The version of the running FreeCAD as it says it."""
    return ".".join(FreeCAD.Version()[:3])


def wrote(document):
    """Was the document made or last saved by a FreeCAD of this version?"""
    saved_by = document.getProgramVersion()
    return not saved_by or saved_by.startswith("%d.%dR" % version())


def later_that_saved(document):
    """The later FreeCAD that saved the document last, as "1.1"; None where it was no later one."""
    found = re.match(r"(\d+)\.(\d+)", document.getProgramVersion())
    return found[0] if found and tuple(map(int, found.groups())) > version() else None


def packages_folder():
    """The folder into which this FreeCAD's Addon Manager installs Python packages."""
    folder = os.path.join(FreeCAD.getUserAppDataDir(), "AdditionalPythonPackages")
    return folder if version() < (0, 21) else os.path.join(folder, "py%d%d" % sys.version_info[:2])


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
    return frame_around(part)   # of a link, whose global placement 1.0 does not tell


def are_same_place(one, other):
    """Are two placements the same, but for rounding? Told by placements themselves since 0.21."""
    return all(abs(a - b) <= _SAME_PLACE for a, b in zip(one.toMatrix().A, other.toMatrix().A))


def frame_around(obj):
    """Placement of the frame that the object's own is relative to: that of the container it is in."""
    parent = obj.getParentGeoFeatureGroup()
    return parent.getGlobalPlacement() if parent is not None else FreeCAD.Placement()


def frame_of(obj):
    """Placement of an object in the frame in which FEM has nodes: its own in 0.20, the global one in 1.0 and later."""
    if version() < (1, 0):
        return obj.Placement
    if hasattr(obj, "getGlobalPlacement"):
        return obj.getGlobalPlacement()
    return frame_around(obj).multiply(obj.Placement)   # of an object made in Python, which does not tell it


def number_of(enumerator):
    """A Qt enumerator as the number that FreeCAD's task panels ask for: PySide 2 converts by int(), PySide 6 has `value`."""
    return int(getattr(enumerator, "value", enumerator))


def is_frozen(obj):
    """Is the object left out of recomputes? Told since 1.1; FreeCAD tells nobody when it changes all the same, as a primitive of Part does."""
    return obj.getStatusString() == "Freezed"


def follows_faces():
    """Does FreeCAD itself move references when faces get other numbers? Since 1.0."""
    return version() >= (1, 0)


def tells_without_running():
    """Can a line be told to the console and the macro without being run? Since 1.1."""
    return version() >= (1, 1)


def can_leave_chosen_calculix():
    """Has FEM a setting by which CalculiX is the program on the path, whatever path was chosen? Before 1.1."""
    return version() < (1, 1)


def asks_manipulators():
    """Does FreeCAD ask manipulators of workbenches when it builds toolbars and menus? Since 1.0."""
    return version() >= (1, 0)

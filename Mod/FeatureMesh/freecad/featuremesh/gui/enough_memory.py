# SPDX-License-Identifier: GPL-3.0-or-later
"""Asks before a mesh is begun that the computer has no memory for: where it runs out FreeCAD is ended, with what is not saved."""

import os

import FreeCAD

from .. import reading, too_fine, versions
from ..study import memory
from . import message_box

translate = FreeCAD.Qt.translate
# Of an element, in FreeCAD and the mesher together. 814 000 took 0.53 GB of 4 nodes and 1.35 GB of 10 where both are one process; as two they hold the arrays
# twice: 480 000 of 10 nodes took 1.1 GB.
_BYTES = {"1st": 0.9e3, "2nd": 2.3e3}


def or_all_the_same(mesh):
    """Is there enough for the mesh with its settings, or does the user want it all the same?"""
    part = versions.part_of(mesh)
    return reading.filled_with(part, mesh.Dimension) != "Solids" or for_tets(mesh, too_fine.least_tets(part.Shape, mesh.Size.Value))


def for_tets(mesh, count):
    """The same of so many elements."""
    if not os.path.exists("/proc/meminfo"):   # only Linux tells there
        return True
    needed, available = _BYTES[mesh.Order] * count, memory.available_bytes()
    is_refused_anyway = count > too_fine.MOST
    return needed < available or is_refused_anyway or _ask(mesh, count, needed, available)


def _ask(mesh, count, needed, available):
    text = translate("FeatureMesh", "About %d million elements need about %d GB of memory; %d GB are free.") % (
        round(count / 1e6), round(needed / 1e9), available // 1e9)
    return message_box.answer(mesh.Label, text, translate("FeatureMesh", "Where memory runs out, what is not saved is lost. A larger size makes fewer elements."),
                  {"mesh": translate("FeatureMesh", "Mesh all the same")}, is_risky=True) is not None

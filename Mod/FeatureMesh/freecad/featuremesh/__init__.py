# SPDX-License-Identifier: GPL-3.0-or-later
"""FeatureMesh: FEM meshes of FreeCAD parts that are updated, not thrown away, when the part is edited."""

__version__ = "0.1.0"

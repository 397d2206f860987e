# SPDX-License-Identifier: GPL-3.0-or-later
"""The workbench's commands, one per file; each is a transaction around one function of `api`."""

import importlib

# Name of the command -> module of this package that holds it as `Command`; in the order of the toolbar.
COMMANDS = {
    "FeatureMesh_MeshPart": "mesh_part",
    "FeatureMesh_UpdateNow": "update_now",
    "FeatureMesh_Adopt": "adopt",
    "FeatureMesh_AddLocalSize": "add_local_size",
    "FeatureMesh_AddSizeZone": "add_size_zone",
    "FeatureMesh_AddGroup": "add_group",
    "FeatureMesh_ShowKept": "show_kept",
    "FeatureMesh_ShowQuality": "show_quality",
    "FeatureMesh_LiveResult": "live_result",
    "FeatureMesh_Study": "study",
    "FeatureMesh_ShowTree": "show_tree",
    "FeatureMesh_Compare": "compare",
    "FeatureMesh_Export": "export_mesh",
    "FeatureMesh_About": "about",
}

# Those that are in the Mesh toolbar and menu of FreeCAD's FEM workbench, too.
IN_FEM = [name for name in COMMANDS if name not in ("FeatureMesh_ShowTree", "FeatureMesh_About")]

# Those in the menu of a mesh in the tree.
OF_A_MESH = ("FeatureMesh_UpdateNow", "FeatureMesh_AddLocalSize", "FeatureMesh_AddSizeZone", "FeatureMesh_AddGroup")


def made(name):
    """A new object of the command of that name."""
    return importlib.import_module("." + COMMANDS[name], __name__).Command()

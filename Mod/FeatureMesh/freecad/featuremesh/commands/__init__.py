# SPDX-License-Identifier: GPL-3.0-or-later
"""The workbench's commands, one per file; each is a transaction around one function of `api`."""

import FreeCADGui as Gui

# Name of the command -> module of this package that holds it as `Command`; in the order of the toolbar.
COMMANDS = {
    "FeatureMesh_MeshPart": "mesh_part",
    "FeatureMesh_UpdateNow": "update_now",
    "FeatureMesh_Adopt": "adopt",
    "FeatureMesh_AddLocalSize": "add_local_size",
    "FeatureMesh_ShowKept": "show_kept",
    "FeatureMesh_ShowQuality": "show_quality",
    "FeatureMesh_ShowTree": "show_tree",
    "FeatureMesh_Compare": "compare",
    "FeatureMesh_Export": "export_mesh",
}

# Those that are in the Mesh toolbar and menu of FreeCAD's FEM workbench, too.
IN_FEM = [name for name in COMMANDS if name != "FeatureMesh_ShowTree"]


def register():
    """Makes the commands known to FreeCAD."""
    import importlib
    for name, module in COMMANDS.items():
        Gui.addCommand(name, importlib.import_module("." + module, __name__).Command())

# SPDX-License-Identifier: GPL-3.0-or-later
"""Run by the Addon Manager before it removes this addon: removes FeatureMesh's log and says how to remove the engine, which the Addon
Manager installed as a Python package and leaves."""

import os
import shutil
import sys

import FreeCAD

shutil.rmtree(os.path.join(FreeCAD.getUserAppDataDir(), "FeatureMesh"), ignore_errors=True)
packages = os.path.join(FreeCAD.getUserAppDataDir(), "AdditionalPythonPackages")
for folder in (packages, os.path.join(packages, "py%d%d" % sys.version_info[:2])):
    if os.path.isdir(folder) and any(name.startswith("featuremesh_engine-") for name in os.listdir(folder)):
        FreeCAD.Console.PrintMessage('FeatureMesh\'s engine stays installed. To remove it, type: PYTHONPATH="%s" python%d.%d -m pip uninstall '
                                     "--break-system-packages featuremesh-engine\n" % (folder, *sys.version_info[:2]))

# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs in FreeCAD: lets its own Addon Manager install, update or remove the addon in ADDON_ZIP, with pip as the environment sets it."""
import ctypes
import json
import os
import sys
import traceback

import FreeCAD

sys.path.append(os.path.join(FreeCAD.getHomePath(), "Mod", "AddonManager"))
sys.path.append("/usr/share/freecad/Mod/AddonManager")
import addonmanager_utilities as utils  # noqa: E402
from Addon import Addon  # noqa: E402
from addonmanager_dependency_installer import DependencyInstaller  # noqa: E402
from addonmanager_installer import AddonInstaller  # noqa: E402
from addonmanager_uninstaller import AddonUninstaller  # noqa: E402


def let_constraints_be_here():
    """The Addon Manager's list of versions that packages may have is on the network; an empty one of this machine takes its place."""
    folder = os.path.join(os.path.dirname(os.environ["FEATUREMESH_RESULT"]), "constraints")
    of_python = os.path.join(folder, "%d.%d" % sys.version_info[:2])
    os.makedirs(of_python, exist_ok=True)
    open(os.path.join(of_python, "constraints.txt"), "w", encoding="utf-8").close()
    FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Addons").SetString("pip_constraints_path", folder)


def install(addon):
    """As the Addon Manager does: the addon, whose package.xml names the packages that it needs, and these."""
    assert AddonInstaller(addon, []).run(), "the addon was not installed"
    needed = sorted(addon.python_requires)
    assert packages_installed(needed), "pip failed"
    return {"dependencies": needed, "packages": utils.get_pip_target_directory()}


def update(addon):
    """As the Addon Manager does: the addon alone, since it asks only whether a package is there."""
    assert AddonInstaller(addon, []).run(), "the addon was not updated"
    return {}


def packages_installed(needed):
    failures = []
    installer = DependencyInstaller([], needed, [])
    installer.failure.connect(lambda short, detail: failures.append((short, detail)))
    installer.no_pip.connect(lambda call: failures.append(("no pip", call)))
    installer.run()
    print(*failures)
    return not failures


def remove(addon):
    assert AddonUninstaller(addon).run(), "the addon was not removed"
    return {}


said = {}
try:
    let_constraints_be_here()
    addon = Addon("FeatureMesh", os.environ["ADDON_ZIP"], Addon.Status.NOT_INSTALLED, "main")
    said = {"install": install, "update": update, "remove": remove}[os.environ["DO"]](addon)
except BaseException:
    said["error"] = traceback.format_exc()
    traceback.print_exc()
with open(os.environ["FEATUREMESH_RESULT"], "w", encoding="utf-8") as result:
    json.dump(said, result)
sys.stdout.flush()
ctypes.CDLL(None).fflush(None)   # what FreeCAD itself printed
os._exit(0)

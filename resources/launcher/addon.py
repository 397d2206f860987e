# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts the workbench with its engine into FreeCAD's folder for add-ons, and takes it out again."""
import shutil
from pathlib import Path

from freecad_task import run_script
from layout import RELEASE, WORKBENCH, Failure, UserError

NAME = "FeatureMesh"
LIVE_SOLVER = "featuremesh_petsc.so"
OURS = Path("freecad") / "featuremesh" / "api.py"


def addon_folder():
    """The folder of the user's add-ons, which only FreeCAD itself knows for its version."""
    return Path(run_script(Path(__file__).with_name("find_user_folder.py"), {})["user_folder"]) / "Mod"


def install_into(folder):
    """Copies workbench and engine into the folder; what was there before is replaced only when the copy is whole."""
    engines = sorted((RELEASE / "bindings").glob("featuremesh_engine*.so"))
    if not engines:
        raise Failure(f"there is no engine in {RELEASE / 'bindings'}")
    target = folder / NAME
    refuse_foreign(target)
    fresh = folder / (NAME + ".new")
    shutil.rmtree(fresh, ignore_errors=True)
    shutil.copytree(WORKBENCH, fresh, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy2(engines[-1], fresh)
    if (RELEASE / "bindings" / LIVE_SOLVER).exists():
        shutil.copy2(RELEASE / "bindings" / LIVE_SOLVER, fresh)
    if target.exists():
        shutil.rmtree(target)
    fresh.rename(target)
    return target


def remove_from(folder):
    """Removes the workbench from the folder."""
    target = folder / NAME
    if not target.exists():
        raise UserError(f"FeatureMesh is not installed in {folder}")
    refuse_foreign(target)
    shutil.rmtree(target)
    return target


def refuse_foreign(target):
    if target.is_symlink() or (target.exists() and not (target / OURS).is_file()):
        raise UserError(f"{target} is not an installed FeatureMesh; move it away first")

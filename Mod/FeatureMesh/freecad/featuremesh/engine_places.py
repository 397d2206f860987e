# SPDX-License-Identifier: GPL-3.0-or-later
"""Where compiled engines are, which of them this Python can load, and which is taken.

An engine is the extension module `featuremesh_engine`. A wheel, the portable zip and an installation have a `.dist-info` folder
beside it that names its version. It may bring its libraries along, in a folder of their own.
"""

import glob
import importlib.machinery
import os
import re
import sys
from typing import NamedTuple

from . import __version__, versions

NAME = "featuremesh_engine"
DISTRIBUTION = "featuremesh-engine"
# What an engine of this Python can be called, such as featuremesh_engine.cpython-311-x86_64-linux-gnu.so.
FILE_NAMES = tuple(NAME + suffix for suffix in importlib.machinery.EXTENSION_SUFFIXES)
_LIBRARY_FOLDERS = (NAME + ".libs", DISTRIBUTION.replace("-", "_") + ".libs", ".dylibs")
_PACKAGE = os.path.dirname(os.path.abspath(__file__))
_WORKBENCH = os.path.dirname(os.path.dirname(_PACKAGE))
# Where the engine lies that was installed or built together with this package.
_OWN = [os.path.abspath(folder) for folder in (_PACKAGE, _WORKBENCH, os.path.join(_WORKBENCH, "engines"),
                                               os.path.join(_WORKBENCH, "..", "..", "build", "release", "bindings"))]


class Place(NamedTuple):
    """A folder with an engine that this Python can load."""
    folder: str
    version: str   # "" where nothing beside it says so, as in a build folder

    def brings_its_libraries(self):
        """Has it an OCCT of its own, which must not meet FreeCAD's in one process?"""
        return any(os.path.isdir(os.path.join(self.folder, name)) for name in _LIBRARY_FOLDERS)


def folders():
    """Every folder that may hold an engine, those before going first where versions are equal.

    FreeCAD with a window, and since 1.0 every FreeCAD, ignores PYTHONPATH. Installed, the engine lies beside the workbench or where
    packages are; in a clone, where the launcher builds it.
    """
    return list(dict.fromkeys(os.path.abspath(folder) for folder in [*_OWN, *sys.path, versions.packages_folder()] if os.path.isdir(folder)))


def usable():
    """The engines that this Python can load, the one to take first: that of FEATUREMESH_ENGINE, else the newest."""
    named = os.environ.get("FEATUREMESH_ENGINE", "")
    if named and file_in(named):
        return [Place(os.path.abspath(named), version_in(named))]
    places = [Place(folder, version_in(folder)) for folder in folders() if file_in(folder)]
    return sorted(places, key=lambda place: number_of(place.version), reverse=True)


def of_other_pythons():
    """{folder: names of the Pythons} of engines that this Python cannot load."""
    found = {}
    for folder in folders():
        for path in glob.glob(os.path.join(glob.escape(folder), NAME + ".*")):
            known = re.search(r"\.(?:cpython-|cp)(\d)(\d+)-", os.path.basename(path))
            if known and os.path.basename(path) not in FILE_NAMES:
                found.setdefault(folder, set()).add("%s.%s" % known.groups())
    return {folder: sorted(versions, key=number_of) for folder, versions in found.items()}


def version_in(folder):
    """The newest version of an engine that a folder says it holds; this package's for one that came with it; else ""."""
    names = glob.glob(os.path.join(glob.escape(folder), NAME + "-*.dist-info"))
    unsaid = __version__ if os.path.abspath(folder) in _OWN else ""
    return max((os.path.basename(name)[len(NAME) + 1:-len(".dist-info")] for name in names), key=number_of, default=unsaid)


def number_of(version):
    """A version's text as something to be compared."""
    return tuple(int(part) for part in re.findall(r"\d+", version))


def file_in(folder):
    """The file of the engine in a folder, or None."""
    paths = (os.path.join(folder, name) for name in FILE_NAMES)
    return next(filter(os.path.isfile, paths), None)

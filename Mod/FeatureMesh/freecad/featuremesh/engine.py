# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads the compiled engine here or runs it in a process of its own; `load()` gives the same functions with the same results.

Scripts and freecadcmd run here an engine that uses FreeCAD's own OCCT. FreeCAD's window calls `run_in_worker`, so that a crash of
the geometry kernel cannot take FreeCAD along. An engine with an OCCT of its own always runs in a process of its own.
"""

import importlib.util
import os
import sys

import FreeCAD

from . import __version__, engine_places, log, versions, worker
from .errors import EngineMissing
from .messages import of_error
from .user_words import in_words

translate = FreeCAD.Qt.translate
# The numbers of the interface between this package and the engine (`featuremesh_engine.protocol`) that it can speak.
OLDEST_PROTOCOL, NEWEST_PROTOCOL = 4, 4
_place = None    # the engine_places.Place in use
_asked = False   # was a process of its own asked for?
_worker = worker.WorkerEngine()


def run_in_worker():
    """From now on the engine runs in a process of its own."""
    global _asked
    _asked = True


def run_here():
    """From now on the engine runs in FreeCAD's own process, unless it has an OCCT of its own."""
    global _asked
    _asked = False
    _worker.retire()


def runs_in_worker():
    """Does the engine run in a process of its own?"""
    return _asked or (_place is not None and _place.brings_its_libraries())


def load():
    """The engine: the module `featuremesh_engine`, or its functions in a worker process. Throws EngineMissing."""
    place = chosen()
    alone = place.brings_its_libraries()
    if not alone and not _asked:
        return _load_here(place)
    _worker.folder = place.folder
    try:
        _check(_worker.start(), place)
    except EngineMissing:
        _worker.stop()
        raise
    except worker.CannotStart as error:
        if alone:
            raise _not_loaded(place.folder, in_words(of_error(error))) from error
        FreeCAD.Console.PrintWarning(translate(
            "FeatureMesh", "FeatureMesh cannot start its worker process and runs inside FreeCAD: %s") % in_words(of_error(error)) + "\n")
        run_here()
        return _load_here(place)
    return _worker


def is_here():
    """Does the engine run in this very process, so that a copy of it (fork) has what the engine knows? Throws EngineMissing."""
    return load() is not _worker


def about():
    """What the engine says about itself: version, protocol and those of its libraries. Throws EngineMissing."""
    return load().about()


def folder():
    """The folder with the compiled engine. Throws EngineMissing."""
    return chosen().folder


def chosen():
    """The engine's place; says so when there are several. Throws EngineMissing."""
    global _place
    if _place is not None and engine_places.file_in(_place.folder):
        return _place
    places = engine_places.usable()
    if not places:
        _place = None
        raise EngineMissing(_why_missing())
    _place = places[0]
    _worker.stop()
    log.write("engine %s in %s", _place.version or "of unknown version", _place.folder)
    if len({place.version for place in places}) > 1:
        FreeCAD.Console.PrintWarning(translate("FeatureMesh", "FeatureMesh found several engines and uses the newest, %s in %s; the others: %s") % (
            _place.version, _place.folder, ", ".join("%s in %s" % (place.version or "?", place.folder) for place in places[1:])) + "\n")
    return _place


def how_to_install():
    """The ways to get an engine for this Python, in words."""
    return translate("FeatureMesh", "let the Addon Manager install %s, or type `%s`, or unpack FeatureMesh's portable zip into %s") % (
        engine_places.DISTRIBUTION, pip_command(), os.path.join(FreeCAD.getUserAppDataDir(), "Mod"))


def pip_command(words="install --upgrade"):
    """What to type so that pip puts the engine where FreeCAD looks for it."""
    return 'python%d.%d -m pip %s --target "%s" %s' % (
        *sys.version_info[:2], words, versions.packages_folder(), engine_places.DISTRIBUTION)


def _why_missing():
    words = [translate("FeatureMesh", "FeatureMesh's compiled engine (featuremesh_engine) is not installed for Python %d.%d; the mesh is shown as it "
                       "was saved.") % sys.version_info[:2]]
    for place, pythons in engine_places.of_other_pythons().items():
        words.append(translate("FeatureMesh", "The one in %s is for Python %s.") % (place, ", ".join(pythons)))
    words.append(translate("FeatureMesh", "To install it: %s; in a clone any command of `./featuremesh` builds it.") % how_to_install())
    return " ".join(words)


def _not_loaded(folder, why):
    return EngineMissing(translate("FeatureMesh", "FeatureMesh's engine in %s could not be loaded: %s. To install it anew: %s") % (folder, why, how_to_install()))


def _check(said, place):
    """Throws EngineMissing unless the engine speaks a protocol of this package. `said` is what its `about` gives."""
    protocol = said.get("protocol", 0)
    if OLDEST_PROTOCOL <= protocol <= NEWEST_PROTOCOL:
        return
    which = (said.get("version", "?"), place.folder, __version__)
    if protocol < OLDEST_PROTOCOL:
        raise EngineMissing(translate("FeatureMesh", "FeatureMesh's engine %s in %s is too old for FeatureMesh %s. To install a newer one: %s") % (
            *which, how_to_install()))
    raise EngineMissing(translate("FeatureMesh", "FeatureMesh's engine %s in %s is too new for FeatureMesh %s; update FeatureMesh with "
                                  "Tools, Addon manager.") % which)


def _load_here(place):
    module = sys.modules.get(engine_places.NAME)
    if module is None:
        module = _imported(engine_places.file_in(place.folder))
    _check(module.about() if hasattr(module, "about") else {}, place)
    return module


def _imported(path):
    """The module in a file, wherever the Python path leads."""
    spec = importlib.util.spec_from_file_location(engine_places.NAME, path)
    try:
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
    except ImportError as error:
        raise _not_loaded(os.path.dirname(path), error) from error
    sys.modules[engine_places.NAME] = module
    return module

# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs one test module inside freecadcmd: FEATUREMESH_TESTS names it.

FreeCAD ends with exit code 0 whatever a script does; so a run counts only when the line PASSED below is printed, which CTest
looks for.
"""
import importlib
import os
import sys
import traceback
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
PASSED = "every test of the module passed"


def main():
    sys.path.insert(0, HERE)
    import freecad
    installed = os.environ.get("FEATUREMESH_TESTED")   # a folder of an installed workbench, which FreeCAD finds by itself
    workbench = os.path.join(HERE, "..", "..", "Mod", "FeatureMesh", "freecad")
    if workbench not in freecad.__path__ and not installed:
        freecad.__path__.append(workbench)
    from freecad import featuremesh
    if installed and os.path.commonpath([os.path.realpath(featuremesh.__file__), os.path.realpath(installed)]) != os.path.realpath(installed):
        raise RuntimeError("%s is tested instead of %s" % (featuremesh.__file__, installed))
    module = importlib.import_module(os.environ["FEATUREMESH_TESTS"])
    suite = unittest.defaultTestLoader.loadTestsFromModule(module)
    result = unittest.TextTestRunner(stream=sys.stderr, verbosity=2).run(suite)
    return result.wasSuccessful() and result.testsRun > 0


try:
    passed = main()
except BaseException:
    traceback.print_exc()
    passed = False
if passed:
    print("\n" + PASSED)
sys.stdout.flush()
sys.stderr.flush()
os._exit(0 if passed else 1)

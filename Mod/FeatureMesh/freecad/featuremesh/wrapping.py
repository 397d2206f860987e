# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts functions of ours round those of FreeCAD."""

import functools
import importlib

_WRAPPERS = "wrappers_of_featuremesh"   # those that a function has


def wrap(module_name, class_name, function, wrapper):
    """Lets `wrapper` be called, with the original first, in place of a function of FreeCAD, or of a class of it; once, and where there is one."""
    try:
        module = importlib.import_module(module_name)
    except ImportError:
        return
    owner = getattr(module, class_name, None) if class_name else module
    original = getattr(owner, function, None)
    wrappers = getattr(original, _WRAPPERS, ())
    if original is None or wrapper in wrappers:
        return
    wrapped = functools.wraps(original)(functools.partial(wrapper, original) if class_name is None
                                        else lambda self, *rest, **named: wrapper(original, self, *rest, **named))
    setattr(wrapped, _WRAPPERS, (*wrappers, wrapper))
    setattr(owner, function, wrapped)

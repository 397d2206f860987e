# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts functions of ours round those of FreeCAD."""

import functools
import importlib

_MARK = "is_wrapped_by_featuremesh"


def wrap(module_name, class_name, function, wrapper):
    """Lets `wrapper` be called, with the original first, in place of a function of FreeCAD, or of a class of it; once, and where there is one."""
    try:
        module = importlib.import_module(module_name)
    except ImportError:
        return
    owner = getattr(module, class_name, None) if class_name else module
    original = getattr(owner, function, None)
    if original is None or hasattr(original, _MARK):
        return
    wrapped = functools.wraps(original)(functools.partial(wrapper, original) if class_name is None
                                        else lambda self, *rest: wrapper(original, self, *rest))
    setattr(wrapped, _MARK, True)
    setattr(owner, function, wrapped)

# SPDX-License-Identifier: GPL-3.0-or-later
"""The log file for bug reports: which engine runs, what it did and how long it took, and errors with where they came from.

It lies in FreeCAD's folder of the user, at most two files of a megabyte. Where nothing can be written there is none.
"""

import logging
import logging.handlers
import os

import FreeCAD

_logger = logging.getLogger("featuremesh")
_logger.propagate = False


def path():
    """Where the log is."""
    return os.path.join(FreeCAD.getUserAppDataDir(), "FeatureMesh", "featuremesh.log")


def is_written():
    """Can it be written?"""
    return bool(_handlers()) and not isinstance(_handlers()[0], logging.NullHandler)


def write(text, *values):
    """Adds a line."""
    _handlers()
    _logger.info(text, *values)


def write_error(error):
    """Adds an error with the lines of code that led to it."""
    _handlers()
    _logger.error("%s: %s", type(error).__name__, error, exc_info=error)


def _handlers():
    if not _logger.handlers:
        _logger.setLevel(logging.INFO)
        _logger.addHandler(_opened())
    return _logger.handlers


def _opened():
    try:
        os.makedirs(os.path.dirname(path()), exist_ok=True)
        handler = logging.handlers.RotatingFileHandler(path(), maxBytes=1 << 20, backupCount=1, encoding="utf-8")
    except OSError:
        return logging.NullHandler()
    handler.handleError = lambda record: None   # where the disk is full a line is lost, and nothing is said of it
    handler.setFormatter(logging.Formatter("%(asctime)s %(process)d %(levelname)s %(message)s"))
    return handler

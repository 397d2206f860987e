# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes that travel together, as one compound in FreeCAD's binary form, which leaves out the triangulations of a view."""

import contextlib
import functools
import os
import tempfile

import Part


def of_shapes(shapes):
    """The bytes of shapes no two of which are equal: FreeCAD 1.1 lists what is twice in a compound once."""
    with _file_in_memory() as (path, handle):
        Part.Compound(shapes).exportBinary(path)
        if handle is not None:
            return os.pread(handle, os.fstat(handle).st_size, 0)
        with open(path, "rb") as stream:
            return stream.read()


def shapes_in(data):
    """The shapes again."""
    compound = Part.Shape()
    with _file_in_memory() as (path, _):
        with open(path, "wb") as stream:
            stream.write(bytes(data))
        compound.importBinary(path)
    return compound.SubShapes


@functools.lru_cache(maxsize=None)
def _handle_in_memory():
    """Handle of a file without a disk, None where there is no such thing. A new one for each reading would cost as much as a small part's records."""
    return os.memfd_create("featuremesh") if hasattr(os, "memfd_create") and os.path.isdir("/proc/self/fd") else None


@contextlib.contextmanager
def _file_in_memory():
    """Path of an empty file for as long as it is needed, and a handle at its start or None; without a disk where there is another place."""
    handle = _handle_in_memory()
    if handle is not None:
        try:
            yield "/proc/self/fd/%d" % handle, handle
        finally:
            os.ftruncate(handle, 0)
        return
    folder = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
    handle, path = tempfile.mkstemp(".bin", "featuremesh-", folder)
    os.close(handle)
    try:
        yield path, None
    finally:
        os.unlink(path)

# SPDX-License-Identifier: GPL-3.0-or-later
"""VTK's legacy form of unstructured grids, binary."""

import numpy as np

from .vtk_contents import contents_of

_TYPE_NAMES = {"f8": "double", "i4": "int"}


def write(path, arrays, groups):
    """See vtk_contents for what the file says; spaces in names of groups become underscores."""
    contents = contents_of(arrays, [("_".join(name.split()), kind, members) for name, kind, members in groups])
    cells = [np.hstack([np.full((len(block), 1), block.shape[1]), block]).reshape(-1) for block in contents.blocks]
    size = sum(len(row) for row in cells)
    with open(path, "wb") as stream:
        def say(text):
            stream.write(text.encode())

        say("# vtk DataFile Version 3.0\nFeatureMesh, lengths in mm\nBINARY\nDATASET UNSTRUCTURED_GRID\n")
        say("POINTS %d double\n" % len(arrays["points"]))
        _write_binary(stream, arrays["points"], "f8")
        say("CELLS %d %d\n" % (len(contents.types), size))
        _write_binary(stream, np.concatenate(cells), "i4")
        say("CELL_TYPES %d\n" % len(contents.types))
        _write_binary(stream, contents.types, "i4")
        for title, data, count in (("POINT_DATA", contents.point_data, len(arrays["points"])), ("CELL_DATA", contents.cell_data, len(contents.types))):
            say("%s %d\nFIELD FieldData %d\n" % (title, count, len(data)))
            for name, values in data:
                kind = "i4" if values.dtype.kind in "iu" else "f8"
                say("%s 1 %d %s\n" % (name, count, _TYPE_NAMES[kind]))
                _write_binary(stream, values, kind)


def _write_binary(stream, values, kind):
    """The most significant byte first, whatever the machine."""
    stream.write(np.ascontiguousarray(values, dtype=">" + kind).tobytes())
    stream.write(b"\n")

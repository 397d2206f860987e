# SPDX-License-Identifier: GPL-3.0-or-later
"""VTK's XML form of unstructured grids, with binary data in base64."""

import base64
from xml.sax.saxutils import quoteattr

import numpy as np

from .vtk_contents import contents_of


def write(path, arrays, groups):
    """See vtk_contents for what the file says."""
    contents = contents_of(arrays, groups)
    widths = np.concatenate([np.full(len(block), block.shape[1], dtype=np.int64) for block in contents.blocks])
    cells = [("connectivity", np.concatenate([block.reshape(-1) for block in contents.blocks]).astype(np.int64)),
             ("offsets", np.cumsum(widths)), ("types", contents.types)]
    _write_xml(path, arrays["points"], cells, contents.point_data, contents.cell_data)


def _write_xml(path, points, cells, point_data, cell_data):
    lines = ['<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" '
             'header_type="UInt64">\n<UnstructuredGrid>\n<Piece NumberOfPoints="%d" NumberOfCells="%d">\n'
             % (len(points), len(cells[2][1])),
             "<Points>\n", _array("Points", points, 3), "</Points>\n<Cells>\n"]
    lines += [_array(name, values) for name, values in cells] + ["</Cells>\n<PointData>\n"]
    lines += [_array(name, values) for name, values in point_data] + ["</PointData>\n<CellData>\n"]
    lines += [_array(name, values) for name, values in cell_data]
    lines.append("</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n")
    with open(path, "w", encoding="utf-8", newline="\n") as stream:
        stream.writelines(lines)


def _array(name, values, components=1):
    """Each array by itself: meshio cannot read arrays that are appended one after the other with Python 3.14, whose base64 goes on behind an end."""
    values = np.ascontiguousarray(values)
    kind = {"f": "Float", "i": "Int", "u": "UInt"}[values.dtype.kind] + str(8 * values.dtype.itemsize)
    data = base64.b64encode(np.uint64(values.nbytes).tobytes() + values.tobytes()).decode("ascii")
    return '<DataArray type="%s" Name=%s NumberOfComponents="%d" format="binary">\n%s\n</DataArray>\n' % (kind, quoteattr(name), components, data)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a mesh with its groups to a file.

UNV and MED go through FreeCAD's writers, which keep numbers and groups. FreeCAD's VTK and Abaqus writers drop surface elements
and groups, so these two are written here from the saved state.
"""

import os

import FreeCAD
import numpy as np

from . import state
from .errors import UserError

translate = FreeCAD.Qt.translate
FORMATS = ("vtu", "inp", "unv", "med")
_VTK_TYPES = {2: 3, 3: 5, 4: 10, 6: 22, 10: 24}
_VTK_TYPES_OF_SEGMENTS = {2: 3, 3: 21}
# Corners of the faces S1 to S4 of a tet as Abaqus and CalculiX number them.
_ABAQUS_FACES = ((0, 1, 2), (0, 1, 3), (1, 2, 3), (0, 2, 3))
# Abaqus wants mid-side nodes of 01, 12, 02, 03, 13, 23, which is how the engine keeps them; VTK likewise.


def write(mesh, path, file_format):
    """Writes `mesh` to `path`, whole or not at all. Throws UserError for an unknown format or a mesh object without a mesh."""
    file_format = file_format.lower()
    if file_format not in FORMATS:
        raise UserError(translate("FeatureMesh", "cannot export to %s, only to %s") % (file_format or path, ", ".join(FORMATS)))
    if not mesh.FemMesh.VolumeCount:
        raise UserError(translate("FeatureMesh", "%s has no mesh yet") % mesh.Label)
    temporary = os.path.join(os.path.dirname(os.path.abspath(path)),
                             ".%d.%s.%s" % (os.getpid(), os.path.basename(path), file_format))
    try:
        if file_format in ("unv", "med"):
            mesh.FemMesh.write(temporary)
        else:
            writer = write_vtu if file_format == "vtu" else write_inp
            writer(temporary, state.load(mesh.SavedState).arrays, groups_in(mesh.FemMesh))
        os.replace(temporary, path)
    except OSError as error:
        raise UserError(translate("FeatureMesh", "cannot write %s: %s") % (path, error)) from error
    finally:
        if os.path.exists(temporary):
            os.unlink(temporary)


def groups_in(fem_mesh):
    """(name, kind, numbers) of every group of a Fem.FemMesh."""
    return [(fem_mesh.getGroupName(group), fem_mesh.getGroupElementType(group),
             np.array(sorted(fem_mesh.getGroupElements(group)), dtype=np.int64)) for group in fem_mesh.Groups]


def write_vtu(path, arrays, groups):
    """VTK's XML form with raw binary data: segments, triangles and tets; groups as 0/1 arrays on cells and points.

    The groups of single edges, faces and solids are one integer array `Entity` instead (with `Dimension`).
    """
    blocks = [_with_mids(arrays, "segments", "segment_mids"), _with_mids(arrays, "triangles", "triangle_mids"),
              _with_mids(arrays, "tets", "tet_mids")]
    types = [(_VTK_TYPES_OF_SEGMENTS if dimension == 1 else _VTK_TYPES).get(block.shape[1], 0)
             for dimension, block in enumerate(blocks, 1)]
    numbers = np.concatenate([arrays[kind + "_numbers"] for kind in ("segment", "triangle", "tet")])
    dimension = np.repeat(np.array([1, 2, 3], dtype=np.uint8), [len(block) for block in blocks])
    entity = np.concatenate([arrays["segment_edges"], arrays["triangle_faces"], arrays["tet_solids"]]) + 1
    widths = np.repeat(np.array([block.shape[1] for block in blocks], dtype=np.int64), [len(block) for block in blocks])
    cell_data = [("Number", numbers), ("Dimension", dimension), ("Entity", entity.astype(np.int32))]
    point_data = [("Number", arrays["node_numbers"])]
    for name, kind, members in groups:
        if _is_single_entity(name):
            continue
        target, known = (point_data, arrays["node_numbers"]) if kind == "Node" else (cell_data, numbers)
        target.append((name, np.isin(known, members).astype(np.uint8)))
    cells = [("connectivity", np.concatenate([block.reshape(-1) for block in blocks]).astype(np.int64)),
             ("offsets", np.cumsum(widths)),
             ("types", np.repeat(np.array(types, dtype=np.uint8), [len(block) for block in blocks]))]
    _write_vtk_xml(path, arrays["points"], cells, point_data, cell_data)


def write_inp(path, arrays, groups):
    """Abaqus and CalculiX: nodes, tets, node and element sets, and each face as an element surface."""
    order = 2 if len(arrays["tet_mids"]) else 1
    nodes, numbers = arrays["node_numbers"], arrays["tet_numbers"]
    with open(path, "w", encoding="ascii", errors="replace") as stream:
        stream.write("** FeatureMesh, lengths in mm\n*NODE, NSET=Nall\n")
        np.savetxt(stream, np.column_stack([nodes, arrays["points"]]), fmt="%d, %.17g, %.17g, %.17g")
        stream.write("*ELEMENT, TYPE=%s, ELSET=Eall\n" % ("C3D10" if order == 2 else "C3D4"))
        tets = nodes[_with_mids(arrays, "tets", "tet_mids")]
        np.savetxt(stream, np.column_stack([numbers, tets]), fmt=", ".join(["%d"] * (tets.shape[1] + 1)))
        for name, kind, members in groups:
            if kind in ("Node", "Volume"):
                keyword = "*NSET, NSET=" if kind == "Node" else "*ELSET, ELSET="
                stream.write("%s%s\n" % (keyword, name))
                _write_numbers(stream, members)
        _write_surfaces(stream, arrays)


def _write_surfaces(stream, arrays):
    corners = np.sort(np.vstack([arrays["tets"][:, list(face)] for face in _ABAQUS_FACES]), axis=1)
    sides = np.repeat(np.arange(1, 5), len(arrays["tets"]))
    owners = np.tile(arrays["tet_numbers"], 4)
    triangles = np.sort(arrays["triangles"], axis=1)
    # Each triangle gets one whole number that it has among the tets' sides too.
    _, keys = np.unique(np.vstack([corners, triangles]), axis=0, return_inverse=True)
    row_of = np.empty(len(keys), dtype=np.int64)
    row_of[keys[:len(corners)]] = np.arange(len(corners))
    rows = row_of[keys[len(corners):].reshape(-1)]
    for face in np.unique(arrays["triangle_faces"]):
        stream.write("*SURFACE, NAME=Face%d, TYPE=ELEMENT\n" % (face + 1))
        for row in rows[arrays["triangle_faces"] == face]:
            stream.write("%d, S%d\n" % (owners[row], sides[row]))


def _write_numbers(stream, numbers):
    for start in range(0, len(numbers), 16):
        stream.write(", ".join(str(number) for number in numbers[start:start + 16]) + ",\n")


def _with_mids(arrays, elements, mids):
    corners = arrays[elements]
    if not len(arrays[mids]):
        return corners
    return np.hstack([corners, arrays[mids].reshape(len(corners), -1)])


def _is_single_entity(name):
    stem = name[:-len("_Nodes")] if name.endswith("_Nodes") else name
    return stem.rstrip("0123456789") in ("Solid", "Face", "Edge") and stem[-1:].isdigit()


def _write_vtk_xml(path, points, cells, point_data, cell_data):
    offset, payload = 0, []

    def array(name, values, components=1):
        nonlocal offset
        values = np.ascontiguousarray(values)
        kind = {"f": "Float", "i": "Int", "u": "UInt"}[values.dtype.kind] + str(8 * values.dtype.itemsize)
        line = '<DataArray type="%s" Name="%s" NumberOfComponents="%d" format="appended" offset="%d"/>\n' % (
            kind, _xml(name), components, offset)
        payload.append(values)
        offset += 8 + values.nbytes
        return line

    lines = ['<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" '
             'header_type="UInt64">\n<UnstructuredGrid>\n<Piece NumberOfPoints="%d" NumberOfCells="%d">\n'
             % (len(points), len(cells[2][1])),
             "<Points>\n", array("Points", points, 3), "</Points>\n<Cells>\n"]
    lines += [array(name, values) for name, values in cells] + ["</Cells>\n<PointData>\n"]
    lines += [array(name, values) for name, values in point_data] + ["</PointData>\n<CellData>\n"]
    lines += [array(name, values) for name, values in cell_data]
    lines.append('</CellData>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding="raw">\n_')
    with open(path, "wb") as stream:
        stream.write("".join(lines).encode())
        for values in payload:
            stream.write(np.uint64(values.nbytes).tobytes())
            stream.write(values.tobytes())
        stream.write(b"\n</AppendedData>\n</VTKFile>\n")


def _xml(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")

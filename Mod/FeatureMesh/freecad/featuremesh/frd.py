# SPDX-License-Identifier: GPL-3.0-or-later
"""Nodal values of a result file of CalculiX (.frd, the ASCII form), as arrays. Needs neither FreeCAD nor the engine."""

import re

import numpy as np

_NUMBER = slice(3, 13)   # columns of a line
_FIRST, _WIDTH = 13, 12
_LONG_EXPONENT = re.compile(rb"(\d)([+-]\d{3})$")   # for which Fortran leaves the E out


def read(path, names):
    """{name: (numbers (n,), values (n,k))} of those blocks, such as DISP and STRESS, that the file has; of several with a name the last."""
    with open(path, "rb") as stream:
        data = stream.read()
    found = {}
    for name, count in names.items():
        start = data.rfind(b"\n -4  %-8s" % name.encode())
        if start >= 0:
            found[name] = _block(data, start, count)
    return found


def read_mesh(path):
    """(numbers (n,), points (n,3) mm, {element: its nodes' numbers}) of the mesh that CalculiX solved: of shells and beams the solids that it made of them."""
    with open(path, "rb") as stream:
        data = stream.read()
    numbers, points = _block(data, data.index(b"\n    2C"), 3)
    start = data.index(b"\n    3C")
    elements, nodes = {}, []
    for line in data[start:data.index(b"\n -3", start)].splitlines():
        if line.startswith(b" -1"):
            nodes = elements.setdefault(int(line[_NUMBER]), [])
        elif line.startswith(b" -2"):
            nodes += [int(line[at:at + 10]) for at in range(_NUMBER.start, len(line), 10)]
    return numbers, points, elements


def _block(data, start, count):
    first = data.index(b"\n -1", start) + 1
    end = data.index(b"\n -3", start) + 1
    length = data.index(b"\n", first) + 1 - first
    lines = np.frombuffer(data, dtype=np.uint8, count=end - first, offset=first).reshape(-1, length)
    values = np.ascontiguousarray(lines[:, _FIRST:_FIRST + _WIDTH * count]).view("S%d" % _WIDTH)
    return np.ascontiguousarray(lines[:, _NUMBER]).view("S10").ravel().astype(np.int64), _as_numbers(values)


def _as_numbers(texts):
    try:
        return texts.astype(float)
    except ValueError:
        return np.array([_LONG_EXPONENT.sub(rb"\1e\2", text) for text in texts.ravel().tolist()]).reshape(texts.shape).astype(float)

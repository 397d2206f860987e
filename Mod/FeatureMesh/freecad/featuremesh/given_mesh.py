# SPDX-License-Identifier: GPL-3.0-or-later
"""Gives a FemMesh to an object of FreeCAD, which does not copy it then.

`obj.FemMesh = fem_mesh` copies one element after the other and forgets the old mesh without freeing its memory (`Fem::FemMesh::operator=`, up to
FreeCAD 1.1): 70 MB with each update of 360 000 elements. So here the two FemMesh exchange the mesh of SMESH that each of them points to, and the old one
is freed with the FemMesh that was given. That uses FreeCAD's and SMESH's own functions by their names in its library and takes nothing for granted:
where they are not there, as on Windows, or anything is not as expected, FreeCAD copies as ever.
"""

import ctypes
import functools

import Fem

# The C++ object round one of Python's begins that much before it, with the address of its table of virtual functions.
_BEFORE = ctypes.sizeof(ctypes.c_void_p)
_TABLE_HEADER = 2 * ctypes.sizeof(ctypes.c_void_p)
_MOST_WORDS = 64   # a FemMesh has some thirty before what it points to


def give(obj, fem_mesh):
    """Makes `fem_mesh` the FemMesh of the object. Afterwards it is another mesh or none: use that of the object."""
    if _exchange(obj.FemMesh, fem_mesh):
        fem_mesh = obj.FemMesh   # FreeCAD tells everybody of the change and has nothing to copy
    obj.FemMesh = fem_mesh


def _exchange(one, other):
    """Exchanges what two FemMesh point to; False where that cannot be done."""
    functions = _functions()
    if functions is None or one.Placement != other.Placement:
        return False
    places = [_place_of_pointer(functions, fem_mesh) for fem_mesh in (one, other)]
    if None in places:
        return False
    here, there = (ctypes.c_void_p.from_address(place) for place in places)
    here.value, there.value = there.value, here.value
    return True


def _place_of_pointer(functions, fem_mesh):
    """The address in the FemMesh at which that of its SMESH mesh is written; None where that is not to be found."""
    wrapper = id(fem_mesh) - _BEFORE
    if ctypes.c_void_p.from_address(wrapper).value != functions.table:
        return None
    address = functions.fem_mesh(wrapper)
    pointed_to = functions.smesh(address)
    words = (address + i * ctypes.sizeof(ctypes.c_void_p) for i in range(_MOST_WORDS))
    return next((word for word in words if pointed_to and ctypes.c_void_p.from_address(word).value == pointed_to), None)


class _Functions:
    """Of FreeCAD's library, by their C++ names. Throws AttributeError, ValueError or OSError where it has them not."""

    def __init__(self):
        library = ctypes.CDLL(Fem.__file__)
        self.table = ctypes.addressof(ctypes.c_char.in_dll(library, "_ZTVN3Fem9FemMeshPyE")) + _TABLE_HEADER
        self.fem_mesh = library._ZNK3Fem9FemMeshPy13getFemMeshPtrEv
        self.smesh = library._ZN3Fem7FemMesh8getSMeshEv
        for function in (self.fem_mesh, self.smesh):
            function.restype, function.argtypes = ctypes.c_void_p, [ctypes.c_void_p]


@functools.cache
def _functions():
    try:
        return _Functions()
    except (AttributeError, ValueError, OSError):
        return None

# SPDX-License-Identifier: GPL-3.0-or-later
"""Gives a FemMesh to an object of FreeCAD, which does not copy it then.

`obj.FemMesh = fem_mesh` copies one element after the other and forgets the old mesh without freeing its memory (`Fem::FemMesh::operator=`, up to
FreeCAD 1.1): 70 MB with each update of 360 000 elements. So here the two FemMesh exchange the mesh of SMESH that each of them points to, and the old one
is freed with the FemMesh that was given. That uses FreeCAD's and SMESH's own functions by their names in its library and takes nothing for granted:
where they are not there, as on Windows, or anything is not as expected, FreeCAD copies as ever.
"""

import contextlib
import ctypes
import functools

import Fem
import FreeCAD

# The C++ object round one of Python's begins that much before it, with the address of its table of virtual functions.
_BEFORE = ctypes.sizeof(ctypes.c_void_p)
_TABLE_HEADER = 2 * ctypes.sizeof(ctypes.c_void_p)
_MOST_WORDS = 64   # a FemMesh has some thirty before what it points to
_aside = {}   # (name of a document, name of an object) -> its FemMesh


def empty():
    """A FemMesh to be filled. One made by FemMesh() alone keeps a command for each node and element that it is given, in SMESH, which nobody asks for;
    filling takes half longer with them, and each mesh more than the one before, since another thread frees them. A copy keeps none."""
    return Fem.FemMesh(Fem.FemMesh())


def give(obj, fem_mesh, skin=None):
    """Makes `fem_mesh` the FemMesh of the object. Afterwards it is another mesh or none: use that of the object.

    With `skin`, a FemMesh of what can be seen alone, FreeCAD's view draws that: it would look for it in all elements.
    """
    with _quick_view(obj):
        if not _exchange(obj.FemMesh, fem_mesh if skin is None else skin):
            obj.FemMesh = fem_mesh
            return
        obj.FemMesh = obj.FemMesh   # FreeCAD tells everybody of the change and has nothing to copy
        if skin is not None and not _exchange(obj.FemMesh, fem_mesh):
            obj.FemMesh = fem_mesh


def set_aside(obj):
    """Takes the FemMesh out of an object that is being opened, as soon as it was read, until it is `Opened`: FreeCAD's view would look for its surface two
    or three times until all of the document is there. To be called whenever a property of the object changes."""
    where, fem_mesh = (obj.Document.Name, obj.Name), Fem.FemMesh()
    if FreeCAD.GuiUp and where not in _aside and obj.FemMesh.NodeCount and _exchange(obj.FemMesh, fem_mesh):
        _aside[where] = fem_mesh


class Opened:
    """An object whose document was opened, while its proxy looks at it: it has the FemMesh again that was set aside. At the end it is given `fem_mesh`, if
    there is one, and FreeCAD's view `skin`."""

    def __init__(self, obj):
        self._object, self._is_to_show = obj, False
        self.fem_mesh = self.skin = None

    def __enter__(self):
        aside = _aside.pop((self._object.Document.Name, self._object.Name), None)
        self._is_to_show = aside is not None and _exchange(self._object.FemMesh, aside)
        return self

    def __exit__(self, *_):
        if self.fem_mesh is None and self._is_to_show:
            self.fem_mesh = Fem.FemMesh()
            _exchange(self._object.FemMesh, self.fem_mesh)
        if self.fem_mesh is not None:
            give(self._object, self.fem_mesh, self.skin)
            self._object.purgeTouched()


@contextlib.contextmanager
def _quick_view(obj):
    """Meanwhile FreeCAD's view finds the faces inside a mesh by their places, as in a large one, not by comparing all of up to 50 000 with one another. It
    does not do so where they are to be shown."""
    view = getattr(obj, "ViewObject", None)
    most = getattr(view, "MaxFacesShowInner", None)
    if not most or view.ShowInner:
        yield
        return
    view.MaxFacesShowInner = 0
    try:
        yield
    finally:
        view.MaxFacesShowInner = most


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

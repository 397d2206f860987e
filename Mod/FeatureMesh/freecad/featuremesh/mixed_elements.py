# SPDX-License-Identifier: GPL-3.0-or-later
"""Has FreeCAD's writer of CalculiX input take solids with shells, or with beams, of one mesh.

FreeCAD (0.20 to 1.1) finds the element sets of such a mesh, yet writes only the elements of the highest dimension, so that its sections would name sets
that are not there; therefore its check refuses thicknesses and beam sections on any mesh with solids. This wraps the three functions: the check, the
search for sets, and the writing. Shells are the triangles of no tetrahedron, and those on the faces that a thickness names: the skin of a solid. Beams
are likewise the segments of no other element, and those on the edges that a beam section names.
"""

from itertools import combinations

import FreeCAD

from . import analyses, versions
from .errors import UserError
from .given_mesh import empty
from .reading import describe
from .wrapping import wrap

translate = FreeCAD.Qt.translate
# What the check says of a mesh with solids, in all versions.
_SHELLS_REFUSED = "Shell thicknesses defined but FEM mesh has volume elements.\n"
_BEAMS_REFUSED = "Beam sections defined but FEM mesh has volume or shell elements.\n"


def install():
    """To be called once one of our meshes is there; further calls do nothing."""
    wrap("femtools.checksanalysis", None, "check_member_for_solver_calculix", _of_check)
    wrap("femmesh.meshsetsgetter", "MeshSetsGetter", "get_mesh_sets", _of_sets)
    wrap("femmesh.meshsetsgetter", "MeshSetsGetter", "get_constraints_force_nodeloads", _of_loads)
    wrap("femsolver.calculix.write_mesh", None, "write_mesh", _of_writing)


def is_mixed(fem_mesh, member):
    """Do thicknesses or beam sections of the analysis mean elements of a mesh with solids?"""
    return bool(fem_mesh.VolumeCount and (member.geos_shellthickness or member.geos_beamsection))


def shells_of(fem_mesh, member):
    """{number: nodes} of the triangles that are elements, or nothing without a thickness."""
    solids = (fem_mesh.getElementNodes(number) for number in fem_mesh.Volumes)
    return _elements(fem_mesh, member.geos_shellthickness, fem_mesh.Faces, _sides(solids, 4, 3), 3, "Face", fem_mesh.getFacesByFace)


def beams_of(fem_mesh, member):
    """{number: nodes} of the segments that are elements, or nothing without a beam section."""
    solids = (fem_mesh.getElementNodes(number) for number in fem_mesh.Volumes)
    triangles = (fem_mesh.getElementNodes(number) for number in fem_mesh.Faces)
    taken = _sides(solids, 4, 2) | _sides(triangles, 3, 2)
    return _elements(fem_mesh, member.geos_beamsection, fem_mesh.Edges, taken, 2, "Edge", fem_mesh.getEdgesByEdge)


def _sides(elements, corners, of_side):
    return {frozenset(side) for nodes in elements for side in combinations(nodes[:corners], of_side)}


def _elements(fem_mesh, objects, numbers, taken, corners, kind, on_shape):
    """Where an object names nothing: all that nothing else has. Else those on what is named."""
    if not objects:
        return {}
    found = {number for shape in _named(objects, kind) for number in on_shape(shape)}
    if any(not entry["Object"].References for entry in objects):
        found |= {number for number in numbers if frozenset(fem_mesh.getElementNodes(number)[:corners]) not in taken}
    return {number: fem_mesh.getElementNodes(number) for number in sorted(found)}


def _named(objects, kind):
    """The faces or edges that the objects refer to."""
    return [part.Shape.getElement(name) for entry in objects for part, names in entry["Object"].References
            for name in ((names,) if isinstance(names, str) else names) if name.startswith(kind)]


def _of_check(original, analysis, solver, mesh, member):
    message = original(analysis, solver, mesh, member)
    if mesh is None or not is_mixed(mesh.FemMesh, member):
        return message
    message += _lost_pressure(mesh.FemMesh, member)
    if shells_of(mesh.FemMesh, member):
        message = message.replace(_SHELLS_REFUSED, "")
    return message.replace(_BEAMS_REFUSED, "") if beams_of(mesh.FemMesh, member) else message


def _lost_pressure(fem_mesh, member):
    """A sentence on a pressure that FreeCAD would leave out without a word, or ""."""
    for entry in member.cons_pressure:
        if not all(fem_mesh.getccxVolumesByFace(face) for face in _named([entry], "Face")):
            return translate("FeatureMesh", "%s presses on a shell beside a solid, which FreeCAD cannot write for CalculiX; use a force there") \
                % describe(entry["Object"]) + "\n"
    return ""


def _of_sets(original, getter, *rest):
    """FreeCAD searches these tables, where it has them, for the elements of each thickness and beam section. The solver object of 1.1 does not listen to
    the check."""
    source = analyses.source_of(getter.mesh_object)
    if getter.theshape is None and source is not None:   # in 1.x, which does not look where a mesh of 0.20 has its part
        getter.theshape = versions.part_of(source)
    if is_mixed(getter.femmesh, getter.member):
        lost = _lost_pressure(getter.femmesh, getter.member)
        if lost:
            raise UserError(lost.strip())
        getter.femelement_faces_table = shells_of(getter.femmesh, getter.member)
        getter.femelement_edges_table = beams_of(getter.femmesh, getter.member)
    return original(getter, *rest)


def _of_loads(original, getter, *rest):
    """The loads of edges are shared out among the elements that have them."""
    if not is_mixed(getter.femmesh, getter.member):
        return original(getter, *rest)
    solids = getter.femelement_table
    getter.femelement_table = {**solids, **getter.femelement_faces_table, **getter.femelement_edges_table}
    try:
        return original(getter, *rest)
    finally:
        getter.femelement_table = solids


def _of_writing(original, writer):
    if not is_mixed(writer.femmesh, writer.member):
        return original(writer)
    whole, writer.femmesh = writer.femmesh, _Elements(writer.femmesh, writer.member)
    try:
        stream = original(writer)
    finally:
        writer.femmesh = whole
    for entry in writer.member.cons_fixed:   # of a mixed mesh FreeCAD writes this set in two, and asks for the forces on the whole of it
        stream.write("*NSET,NSET=%s\n%s\n" % (entry["Object"].Name, "".join("%d,\n" % node for node in sorted(entry["Nodes"]))))
    return stream


class _Elements:
    """A mesh that writes its solids, shells and beams, and nothing else."""

    def __init__(self, fem_mesh, member):
        self._mesh = empty()
        for number, place in fem_mesh.Nodes.items():
            self._mesh.addNode(place.x, place.y, place.z, number)
        for number in fem_mesh.Volumes:
            self._mesh.addVolume(list(fem_mesh.getElementNodes(number)), number)
        for number, nodes in shells_of(fem_mesh, member).items():
            self._mesh.addFace(list(nodes), number)
        for number, nodes in beams_of(fem_mesh, member).items():
            self._mesh.addEdge(list(nodes), number)

    def writeABAQUS(self, path, _elements, groups, **variants):
        """As Fem.FemMesh.writeABAQUS, but for all elements."""
        self._mesh.writeABAQUS(path, 0, groups, **variants)

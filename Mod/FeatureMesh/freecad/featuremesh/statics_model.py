# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads an analysis as FreeCAD's writer of CalculiX input understands it, as arrays for linear statics.

Whatever an analysis holds that is not read here raises NotUnderstood, whose text names it: nothing is left out silently.
"""

import FreeCAD
import numpy as np
from femtools import constants, femutils

from . import analyses, assembled, engine, resolving, solvers, versions
from .errors import UserError
from .hand_over import EntityGroups
from .materials import material_groups, materials_among
from .messages import said
from .reading import describe
from .references import ACTS_ON_NOTHING, ELSEWHERE
from .resolving import Resolver

LIVE_RESULT = "Fem::FeatureMeshLiveResult"   # the type of live_result.LiveResult
_LOWEST_MODULUS, _HIGHEST_POISSON = 1.0, 0.49   # MPa; beyond, displacements of these elements mean nothing


class NotUnderstood(UserError):
    """The analysis holds something that linear statics here does not know."""


class Statics:
    """An analysis as arrays: loads, held and given are (n,3), rows as in the mesh's arrays; N, mm, MPa, t/mm^3."""

    def __init__(self, arrays):
        count = len(arrays["points"])
        self.arrays = arrays
        self.materials = np.zeros((0, 3))
        self.tet_materials = np.zeros(len(arrays["tets"]), dtype=np.int32)
        self.loads = np.zeros((count, 3))
        self.held = np.zeros((count, 3), dtype=bool)
        self.given = np.zeros((count, 3))
        self.supports = {}     # name of a support -> (n,3) which components it holds
        self.has_density = True
        self.part_of = {}      # label of the part by the name of the solid, of several parts
        self.warnings = []
        self.load_makers = []  # for each load: its member in words, what makes its (n,3) of the arrays, and what else that needs; see add_up
        self.is_added_up = False

    def add_up(self):
        """Makes the loads and adds them up, once. Touches no FreeCAD object, so any thread may do it."""
        for described, make, given in self.load_makers if not self.is_added_up else ():
            load = make(self.arrays, *given)
            if not np.abs(load).max(initial=0.0) > 0:
                self.warnings.append(said("{load:text} loads nothing", load=described))
            self.loads += load
        self.is_added_up = True
        return self

    def is_same(self, other):
        """Is it the same to solve? Loads need not be added up for that."""
        return _equal([of.arrays for of in (self, other)]) and _equal(
            [(of.materials, of.tet_materials, of.held, of.given, of.supports, of.has_density, of.load_makers) for of in (self, other)])

    def model(self):
        """As featuremesh_engine.solve_statics takes it."""
        return {"materials": self.materials, "tet_materials": self.tet_materials, "loads": self.loads, "held": self.held,
                "given": self.given}


def _equal(pair):
    """Are the two the same, arrays in them number by number?"""
    one, other = pair
    if one is other:
        return True
    if isinstance(one, dict):
        return one.keys() == other.keys() and all(_equal((one[name], other[name])) for name in one)
    if isinstance(one, (tuple, list)):
        return len(one) == len(other) and all(map(_equal, zip(one, other)))
    return np.array_equal(one, other) if isinstance(one, np.ndarray) else one == other


def read(analysis, mesh):
    """The analysis on the mesh object `mesh` of ours. Throws NotUnderstood, and UserError for what cannot be meant."""
    return prepared(analysis, mesh).add_up()


def prepared(analysis, mesh, arrays=None):
    """Likewise, but the loads are still to be added up. `arrays` are those of the mesh that the object is about to get, if it is."""
    return _Reader(analysis, mesh, arrays or mesh.Proxy.arrays(mesh)).statics


class _Reader:

    def __init__(self, analysis, mesh, arrays):
        self.part = versions.part_of(mesh)
        self.resolver = Resolver(self.part)
        self.arrays = arrays
        if not len(self.arrays["tets"]):
            raise NotUnderstood(said("the live solver knows solids only; {mesh:text} is of shells or beams, which CalculiX solves",
                                     mesh=describe(mesh)))
        self.statics = Statics(self.arrays)
        self.statics.part_of = assembled.part_of_solids(self.part)
        self.entities = EntityGroups(self.arrays)
        self.row_of = np.full(int(self.arrays["node_numbers"].max(initial=0)) + 1, -1)
        self.row_of[self.arrays["node_numbers"]] = np.arange(len(self.arrays["node_numbers"]))
        members = analyses.members_of(analysis)
        materials = materials_among(members)
        self._read_materials(materials)
        _check_solver(analysis)
        for member in members:
            if member in materials or analyses.source_of(member) is mesh or _is_without_effect(member):
                continue
            read = next((read for kind, read in _READERS if femutils.is_of_type(member, kind)), None)
            if read is None:
                raise _not_known(member)
            if getattr(member, "EnableAmplitude", False):
                raise NotUnderstood(said("the live solver does not know the amplitude of {member:text}", member=describe(member)))
            read(self, member)

    # Materials

    def _read_materials(self, materials):
        if not materials:
            raise UserError(said("the analysis has no material: add one"))
        statics = self.statics
        statics.materials = np.array([self._material(material) for material in materials])
        if len(materials) == 1:
            return
        groups = {name: numbers for name, _, numbers in material_groups(materials, self.resolver, self.entities)}
        if not groups:
            raise NotUnderstood(said("the live solver cannot tell which solid has which of the {materials:count} materials",
                                     materials=len(materials)))
        for row, material in enumerate(materials):
            statics.tet_materials[np.isin(self.arrays["tet_numbers"], groups[material.Name + "_Volumes"])] = row

    def _material(self, material):
        values = material.Material
        if not femutils.is_of_type(material, "Fem::MaterialCommon"):   # a reinforced one, of whose results CalculiX's reader knows more
            raise _not_known(material)
        if getattr(material, "Category", "Solid") != "Solid":
            raise NotUnderstood(said("the live solver knows solids only, not the fluid {material:text}", material=describe(material)))
        try:
            young = float(FreeCAD.Units.Quantity(values["YoungsModulus"]).getValueAs("MPa").Value)
            poisson = float(values["PoissonRatio"])
        except (KeyError, ValueError, ArithmeticError) as error:
            raise UserError(said(
                "the material {material:text} has no Young's modulus or no Poisson's ratio that is a number: choose a card that has both, or type them, in its panel",
                material=describe(material))) from error
        if young < _LOWEST_MODULUS:
            raise UserError(said("Young's modulus of the material {material:text} is {young:number} MPa: check its unit",
                                 material=describe(material), young=young))
        if not -1 < poisson <= _HIGHEST_POISSON:
            raise NotUnderstood(said("the material {material:text} is nearly incompressible (Poisson's ratio {poisson:number}), for "
                                                       "which these elements are too stiff", material=describe(material), poisson=poisson))
        density = density_of(material)
        if density is None:
            self.statics.has_density = False
        return young, poisson, density or 0.0

    # Supports

    def read_fixed(self, member):
        self._hold(member, np.ones(3, dtype=bool), np.zeros(3))

    def read_displacement(self, member):
        held, given = np.zeros(3, dtype=bool), np.zeros(3)
        for axis, letter in enumerate("xyz"):
            if getattr(member, "has%sFormula" % letter.upper(), False):
                raise NotUnderstood(said("the live solver does not know the formula of {member:text}", member=describe(member)))
            if getattr(member, letter + "Fix", False):
                held[axis] = True
            elif not getattr(member, letter + "Free"):
                held[axis], given[axis] = True, amount(getattr(member, letter + "Displacement"), "mm")
        self._hold(member, held, given)

    def _hold(self, member, held, given):
        statics, rows = self.statics, self._rows(member)
        before = statics.held[rows] & held
        if (before & (np.abs(statics.given[rows] - given) > 0)).any():
            raise NotUnderstood(said("{support:text} gives nodes another displacement than a support before it; let one of the two hold them", support=describe(member)))
        mine = np.zeros_like(statics.held)
        mine[rows] = held & ~statics.held[rows]   # what several supports hold counts with the first, so that reactions add up
        statics.supports[member.Name] = mine
        statics.held |= mine
        statics.given = np.where(mine, given, statics.given)

    # Loads

    def read_force(self, member):
        names, force = self._names(member), amount(member.Force, "N")
        kinds = {name.rstrip("0123456789") for name in names}
        if len(kinds) != 1 or not kinds <= {"Face", "Edge", "Vertex"}:
            raise NotUnderstood(said("the live solver knows forces on faces, on edges or on vertices, not {force:text}", force=describe(member)))
        along = force * np.array(tuple(member.DirectionVector))
        if kinds == {"Vertex"}:
            self._load(member, _by_shares, self._shares_of_vertices(member), along)
            return
        kind, = kinds
        shapes = [self.part.Shape.getElement(name) for name in names]
        whole = sum(shape.Area if kind == "Face" else shape.Length for shape in shapes)
        shares = "statics_area_shares" if kind == "Face" else "statics_length_shares"
        elements = self._elements(member, names)
        self._load(member, _by_sizes, shares, elements, along / whole)

    def _shares_of_vertices(self, member):
        share = np.zeros(len(self.arrays["points"]))
        for target, subs in member.References:
            subs = [subs] if isinstance(subs, str) else subs
            for sub in subs:
                for name in self.resolver.names(target, sub):
                    share[self._rows_of(member, name)] += 1.0 / len(member.References) / len(subs)
        return share

    def read_pressure(self, member):
        value = amount(member.Pressure, "MPa") * (-1 if member.Reversed else 1)
        names = self._names(member)
        if any(not name.startswith("Face") for name in names):
            raise NotUnderstood(said("the live solver knows pressure on faces only, not {pressure:text}", pressure=describe(member)))
        names = list(dict.fromkeys(names))
        for name in names:
            if resolving.is_between_solids(self.part.Shape, name):
                raise NotUnderstood(said("{pressure:text} presses on {face:entities}, which lies between two solids; choose an outer face", pressure=describe(member),
                                         face=[name]))
        elements = self._elements(member, names)
        self._load(member, _by_pressure, elements, value)

    def read_self_weight(self, member):
        if not self.statics.has_density:
            raise UserError(said("{weight:text} needs the density of every material; give each of them one, with its unit", weight=describe(member)))
        self._load(member, _by_weight, self.statics.materials, self.statics.tet_materials, list(gravity(member)))

    def _load(self, member, make, *given):
        self.statics.load_makers.append((describe(member), make, given))

    # References

    def _names(self, member):
        names, foreign = self.resolver.of_object(member)
        if foreign:
            raise NotUnderstood(said("{member:text} refers to another object than the meshed part {part:text}", member=describe(member),
                                     part=describe(self.part)))
        if gone := self.resolver.without_trace(member):
            raise UserError(said(ELSEWHERE, object=member.Label, where=[resolving.describe(*pair) for pair in gone], part=describe(self.part)))
        if not names:
            raise UserError(said("{member:text} refers to nothing: choose faces, edges or vertices for it", member=describe(member)))
        return names

    def _rows(self, member):
        return np.unique(np.concatenate([self._rows_of(member, name) for name in self._names(member)]))

    def _rows_of(self, member, name):
        numbers = self.entities.nodes(name)
        if not len(numbers):
            raise UserError(said("{member:text} refers to {face:entities}, which has no nodes in the mesh: update the mesh, or choose "
                                                                  "another face", member=describe(member), face=[name]))
        return self.row_of[numbers]

    def _elements(self, member, names):
        found = [self._elements_of(member, name) for name in names]
        if not any(map(len, found)):
            raise UserError(said(ACTS_ON_NOTHING, object=describe(member), places=names))
        return np.concatenate(found)

    def _elements_of(self, member, name):
        self._rows_of(member, name)
        owners = self.arrays["triangle_faces" if name.startswith("Face") else "segment_edges"]
        return np.flatnonzero(owners == int(name.lstrip("FaceEdge")) - 1).astype(np.int32)


_READERS = (
    ("Fem::ConstraintFixed", _Reader.read_fixed),
    ("Fem::ConstraintDisplacement", _Reader.read_displacement),
    ("Fem::ConstraintForce", _Reader.read_force),
    ("Fem::ConstraintPressure", _Reader.read_pressure),
    ("Fem::ConstraintSelfWeight", _Reader.read_self_weight),
)


def _by_shares(_, shares, force):
    return shares[:, None] * force


def _by_sizes(arrays, shares, elements, force):
    return getattr(engine.load(), shares)(arrays, elements)[:, None] * force


def _by_pressure(arrays, elements, pressure):
    return engine.load().statics_pressure(arrays, elements, pressure)


def _by_weight(arrays, materials, tet_materials, along):
    return engine.load().statics_weight(arrays, materials, tet_materials, along)


def density_of(material):
    """t/mm^3; None where the material has none, or one without its unit, of which FreeCAD makes nothing."""
    try:
        return float(FreeCAD.Units.Quantity(material.Material["Density"]).getValueAs("t/mm^3").Value)
    except (KeyError, ValueError, ArithmeticError):
        return None


def amount(value, unit):
    """A property's value in that unit; FreeCAD 0.20 has plain numbers in it."""
    return float(value.getValueAs(unit).Value) if hasattr(value, "getValueAs") else float(value)


def gravity(member):
    """The acceleration that a self weight means, as FreeCAD writes it, mm/s^2; CalculiX wants a direction of length 1."""
    if hasattr(member, "GravityDirection"):
        direction, size = member.GravityDirection, amount(member.GravityAcceleration, "mm/s^2")
    else:
        direction = FreeCAD.Vector(member.Gravity_x, member.Gravity_y, member.Gravity_z)
        size = int(FreeCAD.Units.Quantity(constants.gravity()).getValueAs("mm/s^2"))
    if not direction.Length > 0:
        raise UserError(said("{weight:text} has no direction; give it one", weight=describe(member)))
    return np.array(tuple(direction)) * (size / direction.Length)


def _is_without_effect(member):
    """Results, live or not, and what else no solver is given: solvers and parts."""
    return is_result(member) or is_part(member) or any(member.isDerivedFrom(kind) for kind in ("Fem::FemSolverObject", "Fem::FemSolverObjectPython"))


def is_part(member):
    """Is it one of the parts that FreeCAD pastes beside the analysis of theirs that is copied?"""
    return any(member.isDerivedFrom(kind) for kind in ("App::Part", "App::Link", "Part::Feature"))


def is_result(member):
    """Is this what a solution left in an analysis, such as what CalculiX printed, or a plot of that, rather than what is to be solved?"""
    return any(member.isDerivedFrom(kind) for kind in ("Fem::FemResultObject", "Fem::FemPostObject", "App::TextDocument")) \
        or any(femutils.is_of_type(member, kind) for kind in ("Fem::MeshResult", LIVE_RESULT)) or _is_plot(member)


def _is_plot(member):
    """Is this a histogram, line plot or table of FreeCAD 1.1? In a document that was opened it has no type of its own."""
    return type(getattr(member, "Proxy", None)).__module__.startswith("femobjects.post_")


def _check_solver(analysis):
    solver = solvers.for_linear_statics(analysis)
    beyond = solvers.beyond_linear_statics(solver) if solver is not None else None
    if beyond is not None:
        raise NotUnderstood(said("the live solver knows linear statics only, and {solver:text} asks for {setting:text} = {value:text}",
                                 solver=describe(solver), setting=beyond[0], value=beyond[1]))


def _not_known(member):
    return NotUnderstood(said("only CalculiX knows {member:text} ({kind:text}), not the live solver", member=describe(member), kind=_kind_of(member)))


def _kind_of(member):
    kind = femutils.type_of_obj(member)
    return kind.split("::")[-1]

# SPDX-License-Identifier: GPL-3.0-or-later
"""Solves the analysis of one case, live or with CalculiX, and gives its fields by the rows of the mesh's arrays."""

import glob
import os
import shutil
import signal
import subprocess
from dataclasses import dataclass, field

import numpy as np
from femtools import ccxtools

from .. import calculix, engine, formats, frd, modes, parent_process, statics
from ..errors import Said, UserError
from ..messages import of_error, said
from ..reading import describe
from .steps import step


class Killed(Said, RuntimeError):
    """Somebody ended the solver; the case may be tried again."""


@dataclass
class Fields:
    """A solution. None or empty: the analysis gives no such thing.

    Of solids n counts the nodes of the mesh's arrays; of shells and beams whose result is asked for in 3D those of the solids that CalculiX makes of them.
    """
    rows: np.ndarray = None            # (n,) the row of the mesh's arrays that each value belongs to
    displacements: np.ndarray = None   # (n,3) mm
    stresses: np.ndarray = None        # (n,6) MPa: xx, yy, zz, xy, yz, zx
    temperatures: np.ndarray = None    # (n,) K
    reactions: dict = field(default_factory=dict)   # name of a support -> [x, y, z] N
    strain_energy: float = None        # mJ
    frequencies: list = field(default_factory=list)      # Hz
    buckling_factors: list = field(default_factory=list)


@dataclass
class LiveBase:
    """The base's solution by our own solver, which each case starts from."""
    keep: str      # the name under which the engine keeps it, "" where the engine does not run in this process
    start: tuple   # (node_numbers (n,), displacements (n,3) mm)


def solve_live_base(analysis):
    """From nothing, on one thread, since copies of this process have no other; so it has the same bits in every worker."""
    keep = "study" if engine.is_here() else ""   # an engine elsewhere would be one and the same for all cases
    fields, _ = statics.solve(analysis, keep, 1)
    return LiveBase(keep, (statics.arrays_of(analysis)["node_numbers"], fields["displacements"]))


def solve_live(analysis, threads, base):
    """Linear statics by our own solver, in a copy of the process that solved the base: what a case changes of that, no other case sees."""
    fields, report = statics.solve(analysis, base.keep, threads, start=base.start)
    return Fields(np.arange(len(fields["displacements"])), fields["displacements"], fields["stresses"], reactions=report["responses"]["reactions_n"],
                  strain_energy=report["responses"]["strain_energy_mj"])


def solve_ccx(analysis, arrays, folder, threads, seconds):
    """CalculiX, in `folder`; what writing, solving and reading take goes into `seconds`. Throws UserError when it cannot be solved, Killed when CalculiX
    was ended from outside."""
    solver = calculix.solver_of(analysis)
    with step(seconds, "write"):
        known = calculix.as_arrays(analysis)
        tools = ccxtools.FemToolsCcx(analysis, solver, test_mode=False)
        calculix.write_input(tools, folder, analysis)
        calculix.amend(tools.inp_file_name, solver, known)
    base = os.path.splitext(tools.inp_file_name)[0]
    with step(seconds, "solve"):
        _run(base, threads)
    with step(seconds, "read"):
        return _read(base, analysis, arrays, known)


def _read(base, analysis, arrays, known):
    """What CalculiX left. Throws UserError."""
    kind = calculix.solver_of(analysis).AnalysisType
    try:
        with open(base + ".dat", encoding="utf-8") as stream:
            printed = stream.read()
        if kind in modes.TABLES:
            found = modes.read(printed, kind)
            return Fields(frequencies=found if kind == "frequency" else [], buckling_factors=found if kind == "buckling" else [])
        found = frd.read(base + ".frd", {"DISP": 3, "STRESS": 6, "FORC": 3, "NDTEMP": 1})
        swollen = _rows_of_swollen(base + ".frd", arrays) if _is_swollen(found, arrays) else None
    except (OSError, ValueError) as error:
        raise UserError(said("CalculiX left no readable result: {why:messages}", why=of_error(error))) from error
    if not {"DISP", "NDTEMP"} & set(found):
        raise UserError(said("CalculiX gave no displacements for {analysis:text}", analysis=describe(analysis)))
    return _fields(found, swollen, printed, analysis, arrays, known)


def _fields(found, swollen, printed, analysis, arrays, known):
    """What was read, by the rows of the mesh or, where there are such, of `swollen`. Reactions are sums over the nodes where the analysis is known as
    arrays, else those that were printed."""
    numbers, rows = swollen or (arrays["node_numbers"], np.arange(len(arrays["node_numbers"])))
    values = {name: _by_number(*block, numbers) for name, block in found.items()}
    if known is not None and "FORC" in values:
        reactions = statics.reactions(known, values["FORC"] - known.add_up().loads)
    else:
        reactions = calculix.printed_reactions(printed, analysis)
    temperatures = values["NDTEMP"][:, 0] if "NDTEMP" in values else None
    return Fields(rows, values.get("DISP"), values.get("STRESS"), temperatures, reactions, calculix.printed_strain_energy(printed))


def _is_swollen(found, arrays):
    """Are the values at nodes of solids that CalculiX made of shells or beams?"""
    return bool(found) and not np.isin(next(iter(found.values()))[0], arrays["node_numbers"]).any()


def _rows_of_swollen(path, arrays):
    """(numbers, rows) of the nodes of such solids: which node of the mesh each is made of, the nearest one of its own shell or beam."""
    numbers, points, solids = frd.read_mesh(path)
    kind, mids, own, _ = formats.filling_of(arrays)
    nodes_of = dict(zip(arrays[own].tolist(), formats.connectivity(arrays, kind, mids)))
    order = np.argsort(numbers)
    rows = np.empty(len(numbers), dtype=np.int64)
    for element, of_solid in solids.items():
        at, nodes = order[np.searchsorted(numbers, of_solid, sorter=order)], nodes_of[element]
        off = np.linalg.norm(points[at][:, None] - arrays["points"][nodes][None], axis=2)
        rows[at] = nodes[off.argmin(axis=1)]
    return numbers, rows


def _run(base, threads):
    program = calculix.program()
    log = base + ".log"
    environment = {**os.environ, "OMP_NUM_THREADS": str(threads)}
    parent = os.getpid()
    with open(log, "wb") as stream:
        code = subprocess.run([program, "-i", os.path.basename(base)], cwd=os.path.dirname(base), env=environment, stdin=subprocess.DEVNULL,
                              stdout=stream, stderr=subprocess.STDOUT, preexec_fn=lambda: parent_process.end_with(parent)).returncode
    if code in (-signal.SIGKILL, -signal.SIGTERM):
        raise Killed(said("CalculiX was ended from outside ({signal:text})", signal=signal.Signals(-code).name))
    with open(log, encoding="utf-8", errors="replace") as stream:
        calculix.refuse_failure(code, stream.read())


def _by_number(numbers, values, wanted):
    """A field with a row for each of the nodes that are wanted; no number where CalculiX gave none."""
    result = np.full((len(wanted), values.shape[1]), np.nan)
    order = np.argsort(wanted)
    place = np.minimum(np.searchsorted(wanted, numbers, sorter=order), len(order) - 1)
    ours = wanted[order[place]] == numbers
    result[order[place[ours]]] = values[ours]
    return result


def keep_files(folder, target, kept):
    """Moves what is to be kept of CalculiX's files out of its folder, and removes the rest."""
    for ending in kept:
        for path in glob.glob(os.path.join(folder, "*." + ending)):
            os.replace(path, os.path.join(target, "case." + ending))
    shutil.rmtree(folder, ignore_errors=True)

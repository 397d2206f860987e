# SPDX-License-Identifier: GPL-3.0-or-later
"""What a case will need of memory, estimated before it starts; so that cases wait for each other rather than for the swap."""

# bytes = _BASE + _PER_UNKNOWN * n + _FILL * n^(4/3), n unknowns. CalculiX 2.20 (SPOOLES) alone took 0.19 GB for 37 000 and 1.04 GB for 153 000; by
# iterative Cholesky, which fills nothing in, 0.30 GB for 210 000 of 10-node tets. The rest is FreeCAD's.
_BASE = 0.25e9
_PER_UNKNOWN = 3.5e3
_FILL = 80.0
_LIVE_PER_UNKNOWN = 9e3


# Nodes of the solids that CalculiX makes of shells and beams, by those of the mesh.
_NODES_MADE_OF_ONE = {"tets": 1, "triangles": 3, "segments": 12}


def of_case(facts):
    """Bytes of one case whose mesh has about as many nodes as the base. `facts` are what base.make gave."""
    return estimated_bytes(facts["nodes"] * _NODES_MADE_OF_ONE[facts["filled_by"]], facts["solver"], facts.get("iterative", False))


def estimated_bytes(nodes, solver, iterative=False):
    """Of one case with so many nodes. `solver` is "ccx", "live" or None; of "ccx" it counts whether its own solver is an iterative one."""
    unknowns = 3 * nodes
    if solver == "ccx" and not iterative:
        return _BASE + _PER_UNKNOWN * unknowns + _FILL * unknowns ** (4 / 3)
    return _BASE + (_LIVE_PER_UNKNOWN if solver == "live" else _PER_UNKNOWN) * unknowns


def available_bytes():
    """What the machine can give without swapping."""
    with open("/proc/meminfo", encoding="ascii") as stream:
        for line in stream:
            if line.startswith("MemAvailable:"):
                return int(line.split()[1]) * 1024
    return 0


def jobs_that_fit(jobs, bytes_per_job, available):
    """How many of the jobs have memory at once; 0 when not even one has."""
    return min(jobs, int(available // bytes_per_job))

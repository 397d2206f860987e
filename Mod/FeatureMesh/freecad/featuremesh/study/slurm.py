# SPDX-License-Identifier: GPL-3.0-or-later
"""A Dask cluster of Slurm jobs, by dask-jobqueue where that is installed; queue, account and times are those of its own jobqueue.yaml."""

import importlib.util
import shutil
from contextlib import contextmanager

from ..errors import UserError
from ..messages import said
from . import memory


def refuse_without_slurm():
    """Throws UserError where no Slurm job can be asked for from this machine."""
    if importlib.util.find_spec("dask_jobqueue") is None:
        raise UserError(said("--slurm needs dask-jobqueue, which is not among Debian's packages: python3 -m pip install dask-jobqueue"))
    if not shutil.which("sbatch"):
        raise UserError(said("--slurm needs Slurm's program sbatch, which is not on this machine's path; run the study on a machine that submits Slurm jobs"))


@contextmanager
def slurm_cluster(jobs, study, facts):
    """Gives the address of a scheduler to which so many Slurm jobs, each a worker for one case at a time, come as Slurm starts them.

    Each job asks for the threads of a case and the memory that it is estimated to need, or its limit where the study has one.
    """
    from dask_jobqueue import SLURMCluster
    gigabytes = study.memory_limit_gb or memory.of_case(facts) / 1e9
    cluster = SLURMCluster(cores=study.threads, processes=1, memory="%.2fGB" % gigabytes, worker_extra_args=[
        "--nthreads", "1", "--resources", "cores=%d GB=%.2f" % (study.threads, gigabytes)])
    try:
        cluster.scale(jobs=jobs)
        yield cluster.scheduler_address
    finally:
        cluster.close()

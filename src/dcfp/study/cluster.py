"""Runs a study on several machines, or in several processes: Dask gives the blocks to workers, this process writes them."""

import logging
import zlib
from collections.abc import Generator
from concurrent.futures import CancelledError
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from typing import Any

import xarray

from dcfp.errors import AnalysisError, InputError
from dcfp.study.plan import Plan
from dcfp.study.results import kept_peaks
from dcfp.study.run import Report, missing_blocks, run_blocks
from dcfp.study.store import makers, store_on_disk
from dcfp.study.study import Study

#: Blocks that wait for each worker, besides the one at work.
_WAITING = 2
#: Deaths of workers over the same block before it is given up: a block is small, and a cluster may lose many machines.
_MOST_DEATHS = 20
#: Time for which a scheduler is waited for [s].
_PATIENCE = 10


def run_on_cluster(
    study: Study,
    place: str | Path,
    *,
    address: str | None = None,
    processes: int | None = None,
    resume: bool = False,
    overwrite: bool = False,
    report: Report | None = None,
) -> xarray.Dataset:
    """Run a study on the workers of a Dask cluster; the numbers are those of `run_study`.

    Parameters
    ----------
    study
        The study.
    place
        Folder of the store, which only this process has to reach.
    address
        Of the scheduler, such as ``tcp://10.0.0.1:8786``; None starts workers on this machine.
    processes
        How many workers are started on this machine.
    resume, overwrite, report
        As for `run_study`.

    Raises
    ------
    InputError
        If Dask is not installed, the cluster cannot be reached or has another version, or as for `run_study`.
    AnalysisError
        If the cluster is lost; what is written stays, and `resume` goes on.
    """
    distributed = _distributed()
    plan = study.plan
    with store_on_disk(plan, Path(place), resume=resume, overwrite=overwrite) as store:
        missing = missing_blocks(store, report)
        if missing:
            with _told_in_a_sentence(distributed), _client(distributed, address, processes) as client:
                _check_versions(client)
                packed = zlib.compress(cloudpickle().dumps(study))
                # a task, not data on a worker: should that worker die, another one unpacks it again
                unpacked = client.submit(unpack, packed, pure=False)
                most = max(1, len(client.ncores())) * (1 + _WAITING)
                run_blocks(store, missing, client.get_executor(pure=False), unpacked, most, report)
        return store.dataset()


def _distributed() -> Any:
    try:
        return import_module("distributed")
    except ImportError as error:
        msg = "a study on a cluster needs Dask; install it with pip install 'dcfp[studies]'."
        raise InputError(msg) from error


@contextmanager
def _client(distributed: Any, address: str | None, processes: int | None) -> Generator[Any]:
    """Give a client of a cluster that is there, or of one made for the time of the block."""
    _silence()
    dask: Any = import_module("dask")
    quiet = {
        "distributed.scheduler.allowed-failures": _MOST_DEATHS,
        "distributed.comm.timeouts.connect": _PATIENCE,
        "distributed.admin.large-graph-warning-threshold": "1 GiB",  # the records travel once, within a task
    }
    with dask.config.set(quiet):
        if address is None:
            with (
                _local_cluster(distributed, processes) as cluster,
                distributed.Client(cluster, set_as_default=False) as client,
                client.as_current(),
            ):
                yield client
            return
        try:
            client = distributed.Client(address, timeout=_PATIENCE, set_as_default=False)
        except (OSError, ValueError) as error:
            msg = f"{address}: there is no Dask scheduler; start one with dask scheduler, and workers with dask worker {address}."
            raise InputError(msg) from error
        try:
            with client.as_current():
                yield client
        finally:
            client.close(timeout=1)


def _local_cluster(distributed: Any, processes: int | None) -> Any:
    try:
        return distributed.LocalCluster(
            n_workers=processes, threads_per_worker=1, processes=True, dashboard_address=None
        )
    except RuntimeError as error:  # what Dask raises where a worker dies while it starts
        msg = "a worker died while it started; try again, from what is there (resume)."
        raise AnalysisError(msg) from error


def _silence() -> None:
    """Keep Dask's tracebacks from the terminal: what happens to a cluster is told in one sentence here."""
    for name in [name for name in logging.root.manager.loggerDict if name.startswith("distributed")]:
        logging.getLogger(name).setLevel(logging.CRITICAL)


def _check_versions(client: Any) -> None:
    """Refuse workers that would not give the same numbers."""
    ours = _identity()
    for worker, theirs in client.run(_identity, on_error="return").items():
        # one that has died since is no reason to stop
        if theirs != ours and not isinstance(theirs, OSError):
            msg = f"the worker {worker} has another version of dcfp, or none; install the same on every machine."
            raise InputError(msg)


def _identity() -> dict[str, Any]:
    return {**makers(), "kept": kept_peaks()}


@contextmanager
def _told_in_a_sentence(distributed: Any) -> Generator[None]:
    """Say what happened to a cluster that is lost."""
    try:
        yield
    except distributed.KilledWorker as error:
        msg = (
            f"workers died {_MOST_DEATHS + 1} times over the same block; look at their memory. What is written stays;"
            " go on from it (resume)."
        )
        raise AnalysisError(msg) from error
    except (CancelledError, distributed.CancelledError, OSError, TimeoutError) as error:
        msg = "the cluster is lost; what is written stays; go on from it (resume)."
        raise AnalysisError(msg) from error


def cloudpickle() -> Any:
    """Return what Dask itself pickles with: it also takes a law that a user wrote in a notebook."""
    return import_module("cloudpickle")


def unpack(packed: bytes) -> Plan:
    """Return the plan of a study, on a worker."""
    study: Study = cloudpickle().loads(zlib.decompress(packed))
    return study.plan

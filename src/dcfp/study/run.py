"""Runs a study: blocks on threads, or by Dask on several machines, each written as soon as it is done."""

import logging
import zlib
from collections.abc import Callable, Generator, Iterable
from concurrent.futures import FIRST_COMPLETED, CancelledError, Executor, Future, ThreadPoolExecutor, wait
from contextlib import contextmanager
from importlib import import_module
from itertools import islice
from pathlib import Path
from typing import Any

import xarray

from dcfp.analysis.batch import available_threads
from dcfp.errors import AnalysisError, InputError
from dcfp.study.results import kept_peaks
from dcfp.study.store import StudyStore, makers, store_in_memory, store_on_disk
from dcfp.study.study import Block, Plan, Study
from dcfp.study.work import Results, work_off

#: Called after each block with the analyses and the cost that are done with it.
Report = Callable[[int, float], None]
#: Blocks that wait for all threads, or for each worker: enough that none is idle, few enough for the memory.
_WAITING = 2
#: Deaths of workers over the same block before it is given up: a block is small, and a cluster may lose many machines.
_MOST_DEATHS = 20
#: Time for which a scheduler is waited for [s].
_PATIENCE = 10


def run_study(
    study: Study,
    place: str | Path | None = None,
    *,
    threads: int | None = None,
    resume: bool = False,
    overwrite: bool = False,
    report: Report | None = None,
) -> xarray.Dataset:
    """Run a study, or what is left of it, and return its results.

    Parameters
    ----------
    place
        Folder of the store, from which the results are read when they are used; None keeps them in memory.
    threads
        Analyses at the same time; by default one for each processor.
    resume, overwrite
        Whether a store of this study that is there is gone on with, or replaced; where there is none, one is
        begun.
    report
        Called after each block.

    Returns
    -------
    xarray.Dataset
        The results, read from the store when they are used.

    Raises
    ------
    InputError
        If the study cannot be made, or the store cannot be used or written.
    """
    plan = study.plan
    if place is None:
        return _run(store_in_memory(plan), threads, report)
    with store_on_disk(plan, Path(place), resume=resume, overwrite=overwrite) as store:
        return _run(store, threads, report)


def _run(store: StudyStore, threads: int | None, report: Report | None) -> xarray.Dataset:
    count = available_threads() if threads is None else threads
    if count < 1:
        msg = f"The number of threads must be a positive whole number, not {threads!r}."
        raise InputError(msg)
    with ThreadPoolExecutor(count) as pool:
        _run_blocks(store, _missing_blocks(store, report), pool, store.plan, count + _WAITING, report)
    return store.dataset()


def _missing_blocks(store: StudyStore, report: Report | None) -> list[Block]:
    """Return the blocks that are not done, those that take longest first; those that are done are reported."""
    plan = store.plan
    missing: list[tuple[float, Block]] = []
    for block in plan.blocks():
        if store.is_done(block):
            if report is not None:
                report(block.size, plan.cost(block))
        else:
            missing.append((plan.cost(block), block))
    return [block for _, block in sorted(missing, key=lambda one: (-one[0], one[1].number))]


def _run_blocks(
    store: StudyStore,
    blocks: Iterable[Block],
    pool: Executor,
    plan: Any,
    most: int,
    report: Report | None,
) -> None:
    """Let a pool work off blocks, at `most` so many at the same time, and write each as soon as it is done.

    The plan is as the pool takes it. Ctrl-C lets the blocks at work come to their end and writes them.
    """
    pending: dict[Future[Results], Block] = {}
    left = iter(blocks)

    def write(done: Iterable[Future[Results]]) -> None:
        for one in done:
            block = pending.pop(one)
            store.write(block, one.result())
            if report is not None:
                report(block.size, store.plan.cost(block))

    try:
        while True:
            for block in islice(left, most - len(pending)):
                pending[pool.submit(work_off, plan, block)] = block
            if not pending:
                break
            write(wait(pending, return_when=FIRST_COMPLETED).done)
    except KeyboardInterrupt:
        for one in [one for one in pending if one.cancel()]:
            del pending[one]
        write(wait(pending).done)
        raise
    finally:
        for one in pending:
            one.cancel()


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
    study, resume, overwrite, report
        As for `run_study`.
    place
        Folder of the store, which only this process has to reach.
    address, processes
        Of the scheduler, such as ``tcp://10.0.0.1:8786``; None starts so many workers on this machine.

    Raises
    ------
    InputError
        If Dask is not installed, the cluster cannot be reached or has another version, or as for `run_study`.
    AnalysisError
        If the cluster is lost; what is written stays, and `resume` goes on.
    """
    try:
        distributed = import_module("distributed")
    except ImportError as error:
        msg = "a study on a cluster needs Dask; install it with pip install 'dcfp[studies]'."
        raise InputError(msg) from error
    plan = study.plan
    with store_on_disk(plan, Path(place), resume=resume, overwrite=overwrite) as store:
        missing = _missing_blocks(store, report)
        if missing:
            with _told_in_a_sentence(distributed), _client(distributed, address, processes) as client:
                _check_versions(client)
                packed = zlib.compress(cloudpickle().dumps(study))
                # a task, not data on a worker: should that worker die, another one unpacks it again
                unpacked = client.submit(unpack, packed, pure=False)
                most = max(1, len(client.ncores())) * (1 + _WAITING)
                _run_blocks(store, missing, client.get_executor(pure=False), unpacked, most, report)
        return store.dataset()


@contextmanager
def _client(distributed: Any, address: str | None, processes: int | None) -> Generator[Any]:
    """Give a client of a cluster that is there, or of one made for the time of the block."""
    # Dask's tracebacks stay from the terminal: what happens to a cluster is told in one sentence here
    for name in [name for name in logging.root.manager.loggerDict if name.startswith("distributed")]:
        logging.getLogger(name).setLevel(logging.CRITICAL)
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


def _check_versions(client: Any) -> None:
    """Refuse workers that would not give the same numbers."""
    ours = _identity()
    for worker, theirs in client.run(_identity, on_error="return").items():
        # one that has died since is no reason to stop
        if theirs != ours and not isinstance(theirs, OSError):
            msg = f"the worker {worker} has another version of dcfp, or none; install the same on every machine."
            raise InputError(msg)


def _identity() -> dict[str, Any]:
    return {**makers(), "kept": [kept_peaks(in_plane=one) for one in (False, True)]}


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

"""Runs a study on this machine: blocks on threads, each written as soon as it is done."""

from collections.abc import Callable, Iterable
from concurrent.futures import FIRST_COMPLETED, Executor, Future, ThreadPoolExecutor, wait
from itertools import islice
from pathlib import Path
from typing import Any

import xarray

from dcfp.analysis.batch import available_threads
from dcfp.errors import InputError
from dcfp.study.plan import Block
from dcfp.study.store import StudyStore, store_in_memory, store_on_disk
from dcfp.study.study import Study
from dcfp.study.work import Results, work_off

#: Called after each block with the analyses and the cost that are done with it.
Report = Callable[[int, float], None]
#: Blocks that wait for a thread, besides those at work: enough that none is idle, few enough that memory stays flat.
_WAITING = 2


def run_study(
    study: Study,
    place: str | Path | None = None,
    *,
    threads: int | None = None,
    resume: bool = False,
    overwrite: bool = False,
    report: Report | None = None,
) -> xarray.Dataset:
    """Run a study, or what is left of it.

    Parameters
    ----------
    study
        The study.
    place
        Folder of the store; None keeps the results in memory.
    threads
        Analyses at the same time; by default one for each processor.
    resume
        Whether a store of this study that is there is gone on with; where there is none, one is begun.
    overwrite
        Whether a store that is there is replaced.
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
        run_blocks(store, missing_blocks(store, report), pool, store.plan, count + _WAITING, report)
    return store.dataset()


def missing_blocks(store: StudyStore, report: Report | None = None) -> list[Block]:
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


def run_blocks(
    store: StudyStore,
    blocks: Iterable[Block],
    pool: Executor,
    plan: Any,
    most: int,
    report: Report | None,
) -> None:
    """Let a pool work off blocks and write each as soon as it is done.

    An interruption (Ctrl-C) lets the blocks at work come to their end and writes them.

    Parameters
    ----------
    store
        Where the results are written.
    blocks
        Those to work off.
    pool
        Threads of this process, or the workers of a cluster.
    plan
        The plan as the pool takes it.
    most
        Blocks that it may have at the same time, at work and waiting.
    report
        Called after each block.
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

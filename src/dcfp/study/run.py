"""Runs a study on this machine: blocks on threads, each written as soon as it is done."""

from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from contextlib import contextmanager
from pathlib import Path

import xarray

from dcfp.analysis.batch import available_threads
from dcfp.errors import InputError
from dcfp.study.plan import Block, Plan
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
        store = store_in_memory(plan)
        run_blocks(store, missing_blocks(store, report), threads, report)
        return store.dataset()
    with store_on_disk(plan, Path(place), resume=resume, overwrite=overwrite) as store:
        run_blocks(store, missing_blocks(store, report), threads, report)
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
    store: StudyStore, blocks: Iterable[Block], threads: int | None, report: Report | None
) -> None:
    """Work off blocks on threads and write each.

    An interruption (Ctrl-C) lets the blocks at work come to their end and writes them.
    """
    count = available_threads() if threads is None else threads
    if count < 1:
        msg = f"The number of threads must be a positive whole number, not {threads!r}."
        raise InputError(msg)
    plan = store.plan
    with ThreadPoolExecutor(count) as pool, _pending() as pending:
        left = iter(blocks)
        try:
            while _fill(pool, pending, left, plan, count + _WAITING):
                done, _ = wait(pending, return_when=FIRST_COMPLETED)
                _write(store, pending, done, report)
        except KeyboardInterrupt:
            for one in list(pending):
                if one.cancel():
                    del pending[one]
            _write(store, pending, wait(pending).done, report)
            raise


@contextmanager
def _pending() -> "Generator[dict[Future[Results], Block]]":
    """Give a place for what is under way, and drop what has not begun when it is left."""
    pending: dict[Future[Results], Block] = {}
    try:
        yield pending
    finally:
        for one in pending:
            one.cancel()


def _fill(
    pool: ThreadPoolExecutor,
    pending: "dict[Future[Results], Block]",
    left: Iterator[Block],
    plan: Plan,
    most: int,
) -> bool:
    """Give the pool as much as it may have waiting; return whether anything is under way."""
    while len(pending) < most:
        block = next(left, None)
        if block is None:
            break
        pending[pool.submit(work_off, plan, block)] = block
    return bool(pending)


def _write(
    store: StudyStore,
    pending: "dict[Future[Results], Block]",
    done: "Iterable[Future[Results]]",
    report: Report | None,
) -> None:
    for one in done:
        block = pending.pop(one)
        store.write(block, one.result())
        if report is not None:
            report(block.size, store.plan.cost(block))

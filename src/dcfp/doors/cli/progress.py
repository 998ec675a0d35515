"""A progress bar for work that takes long, on a terminal only."""

import sys
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager
from threading import Timer
from typing import TYPE_CHECKING, Any

from rich.console import Console
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    TextColumn,
    TimeElapsedColumn,
    TimeRemainingColumn,
)

if TYPE_CHECKING:
    from dcfp.study import Plan

#: Time before a bar appears [s].
PATIENCE = 2.0


@contextmanager
def progress(words: str, total: int | None) -> Generator[Callable[[], None]]:
    """Show how many of `total` pieces of work (None: not known) are done; call what it gives after each."""
    if not sys.stderr.isatty():
        yield lambda: None
        return
    bar = _bar(TextColumn(words), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    task = bar.add_task(words, total=total)
    # a timer, because the first piece of work may be the one that takes long: the kernels are compiled in it
    timer = Timer(PATIENCE, bar.start)
    timer.daemon = True
    timer.start()
    try:
        yield lambda: bar.advance(task)
    finally:
        timer.cancel()
        bar.stop()


@contextmanager
def study_progress(plan: "Plan") -> Generator[Callable[[int, float], None]]:
    """Show how much of a plan is done; call what it gives with the analyses and the cost of each block.

    The bar goes by the cost, since analyses of long records take longer; so does the time left.
    """
    if not sys.stderr.isatty():
        yield lambda _, __: None
        return
    bar = _bar(
        TextColumn("{task.fields[done]:,} of " + f"{plan.count:,} analyses"),
        BarColumn(),
        TextColumn("{task.fields[rate]}"),
        TimeElapsedColumn(),
        TextColumn("left"),
        TimeRemainingColumn(elapsed_when_finished=False),
    )
    task = bar.add_task("", total=sum(plan.cost(block) for block in plan.blocks()), done=0, rate="")
    began = time.perf_counter()
    done = 0

    def report(analyses: int, cost: float) -> None:
        nonlocal done
        done += analyses
        rate = done / (time.perf_counter() - began)
        bar.update(task, advance=cost, done=done, rate=f"{rate:,.0f}/s")

    with bar:
        yield report


def _bar(*columns: Any) -> Progress:
    return Progress(*columns, console=Console(stderr=True), transient=True)

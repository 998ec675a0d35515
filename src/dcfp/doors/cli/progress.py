"""Progress bars for work that takes long, on a terminal only; that of a study shows analyses, their rate and the time left."""

import sys
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager
from threading import Timer
from typing import TYPE_CHECKING

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
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    bar = Progress(
        TextColumn(words),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
        console=Console(stderr=True),
        transient=True,
    )
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


# The progress of a study: analyses, their rate and the time left.


@contextmanager
def study_bar(plan: "Plan") -> Generator[Callable[[int, float], None]]:
    """Show how much of a plan is done, on a terminal only; call what it gives with the analyses and the cost of each block.

    The bar goes by the cost, since analyses of long records take longer; so does the time left.
    """
    if not sys.stderr.isatty():
        yield lambda _, __: None
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn, TimeRemainingColumn

    total = sum(plan.cost(block) for block in plan.blocks())
    bar = Progress(
        TextColumn("{task.fields[done]:,} of " + f"{plan.count:,} analyses"),
        BarColumn(),
        TextColumn("{task.fields[rate]}"),
        TimeElapsedColumn(),
        TextColumn("left"),
        TimeRemainingColumn(elapsed_when_finished=False),
        console=Console(stderr=True),
        transient=True,
    )
    task = bar.add_task("", total=total, done=0, rate="")
    began = time.perf_counter()
    done = 0

    def report(analyses: int, cost: float) -> None:
        nonlocal done
        done += analyses
        rate = done / (time.perf_counter() - began)
        bar.update(task, advance=cost, done=done, rate=f"{rate:,.0f}/s")

    with bar:
        yield report

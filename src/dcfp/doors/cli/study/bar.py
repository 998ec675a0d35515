"""The progress of a study: analyses, their rate and the time left."""

import sys
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dcfp.study import Plan


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

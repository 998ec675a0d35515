"""What is printed of every command: labelled lines, tables and remarks; and a progress bar for work that takes long, on a terminal only."""

import sys
import time
from collections.abc import Callable, Generator, Iterable, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from io import StringIO
from threading import Timer
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar

from rich.console import Console
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    TextColumn,
    TimeElapsedColumn,
    TimeRemainingColumn,
)
from rich.table import Table as Grid
from rich.text import Text

from dcfp.errors import AnalysisError
from dcfp.schema.table import Table

if TYPE_CHECKING:
    from dcfp.study import Plan

#: Width where the output is not a terminal.
WIDTH = 100

#: A sentence, labels with their texts, a table, or a table below a sentence on it.
Block: TypeAlias = str | Sequence[tuple[str, str]] | Grid | tuple[str | Text, Grid]


@dataclass(frozen=True)
class Page:
    """What is printed of an answer: blocks below each other, and sentences that a reader must know, each once."""

    blocks: Sequence[Block]
    remarks: Sequence[str] = ()

    def show(self, said: Callable[[str], str] = str) -> None:
        """Print it on standard output; `said` puts remarks in the words of the door."""
        with console() as out:
            for place, block in enumerate(self.blocks):
                if place:
                    out.print()
                match block:
                    case str():
                        out.print(block, soft_wrap=True)
                    case Grid():
                        out.print(block)
                    case (str() | Text() as words, Grid() as table):
                        out.print(words)
                        out.print(table)
                    case _:
                        out.print(labelled(block))
            if self.remarks:
                out.print()
                out.print(labelled([("-", said(one)) for one in dict.fromkeys(self.remarks)]))


@contextmanager
def console() -> Generator[Console]:
    """Give a console for standard output; where that is no terminal, of a fixed width and without colours."""
    settings: dict[str, Any] = {"highlight": False, "markup": False, "emoji": False}
    if sys.stdout.isatty():
        terminal = Console(file=sys.stdout, **settings)
        # better a line that the terminal breaks than a number cut short
        terminal.width = max(terminal.width, WIDTH)
        yield terminal
        return
    text = StringIO()
    yield Console(file=text, width=WIDTH, color_system=None, **settings)
    for line in text.getvalue().splitlines():
        print(line.rstrip())


def grid(table: Table, repeated: int = 0) -> Grid:
    """Return a table to print: words, which may be folded, and numbers, which may not.

    Parameters
    ----------
    table
        What is shown.
    repeated
        How many of the first columns are left empty where all of them are as in the line above.
    """
    drawn = Grid(box=None, padding=(0, 1, 0, 0), pad_edge=False, header_style="bold")
    for one, head in zip(table.printed, table.heads(), strict=True):
        text = Text(head if "\n" in head else f"{head}\n")
        if one.is_number:
            drawn.add_column(text, justify="right", no_wrap=True)
        else:
            drawn.add_column(text, overflow="fold")
    before: list[str] = []
    for cells in table.cells():
        first = cells[:repeated]
        shown = [""] * repeated if first == before else first
        drawn.add_row(*(Text(cell) for cell in (*shown, *cells[repeated:])))
        before = first
    return drawn


def labelled(lines: Iterable[tuple[str, str]]) -> Grid:
    """Return lines with a label before a text; a long text goes on below itself."""
    drawn = Grid.grid(padding=(0, 2, 0, 0))
    for label, text in lines:
        drawn.add_row(Text(label), Text(text))
    return drawn


def grouped(remarks: Iterable[tuple[str, str]]) -> list[str]:
    """Return remarks, each given with the name that it may begin with; what is said of several names is said once."""
    names: dict[str, list[str]] = {}
    for name, remark in remarks:
        told = remark.removeprefix(f"{name}: ")
        names.setdefault(told, []).extend([name] if told != remark else [])
    return [
        f"{', '.join(dict.fromkeys(members))}: {told}" if members else told for told, members in names.items()
    ]


T = TypeVar("T")
R = TypeVar("R")

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


def each(words: str, things: Sequence[T], work: Callable[[T], R]) -> list[R]:
    """Return what some work makes of each thing, and show how much of it is done."""
    found: list[R] = []
    with progress(words, len(things)) as advance:
        for one in things:
            found.append(work(one))
            advance()
    return found


def each_that_can(
    words: str, things: Sequence[T], work: Callable[[T], R]
) -> tuple[list[R], list[AnalysisError]]:
    """Do the same, and return what could be made, and what failed.

    Raises
    ------
    AnalysisError
        If all of them fail.
    """

    def tried(one: T) -> R | AnalysisError:
        try:
            return work(one)
        except AnalysisError as error:
            return error

    made = each(words, things, tried)
    failures = [one for one in made if isinstance(one, AnalysisError)]
    if failures and len(failures) == len(things):
        raise AnalysisError(" ".join(dict.fromkeys(map(str, failures))))
    return [one for one in made if not isinstance(one, AnalysisError)], failures


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

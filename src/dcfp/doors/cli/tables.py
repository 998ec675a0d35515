"""What the tables of every command look like, and what a reader of the numbers must know beside them."""

import sys
from collections.abc import Generator, Iterable, Sequence
from contextlib import contextmanager
from io import StringIO
from typing import Any

from rich.console import Console
from rich.table import Table
from rich.text import Text

#: Width where the output is not a terminal.
WIDTH = 100


@contextmanager
def page() -> Generator[Console]:
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


def new_table(words: Iterable[str], numbers: Iterable[str], last_words: Iterable[str] = ()) -> Table:
    r"""Return an empty table: columns of words, which may be folded, then numbers, then words again.

    A head is ``"name"`` or ``"name\\n[unit]"``.
    """
    table = Table(box=None, padding=(0, 1, 0, 0), pad_edge=False, header_style="bold")
    for head in words:
        table.add_column(_head(head), overflow="fold")
    for head in numbers:
        table.add_column(_head(head), justify="right", no_wrap=True)
    for head in last_words:
        table.add_column(_head(head), overflow="fold")
    return table


def add_row(table: Table, cells: Iterable[str]) -> None:
    """Add a row whose cells are taken as they are written."""
    table.add_row(*(Text(cell) for cell in cells))


def print_labelled(out: Console, lines: Iterable[tuple[str, str]]) -> None:
    """Print a label and a text on each line; a long text goes on below itself."""
    grid = Table.grid(padding=(0, 2, 0, 0))
    for label, text in lines:
        grid.add_row(Text(label), Text(text))
    out.print(grid)


def print_remarks(out: Console, remarks: Sequence[str]) -> None:
    """Print every remark once, below an empty line."""
    if remarks:
        out.print()
        print_labelled(out, [("-", remark) for remark in dict.fromkeys(remarks)])


def _head(text: str) -> Text:
    return Text(text if "\n" in text else f"{text}\n")


def grouped(remarks: "Iterable[tuple[str, str]]") -> list[str]:
    """Return remarks, each given with the name that it may begin with; what is said of several names is said once."""
    names: dict[str, list[str]] = {}
    for name, remark in remarks:
        told = remark.removeprefix(f"{name}: ")
        names.setdefault(told, []).extend([name] if told != remark else [])
    return [
        f"{', '.join(dict.fromkeys(members))}: {told}" if members else told for told, members in names.items()
    ]

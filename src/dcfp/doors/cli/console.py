"""What is printed of every command: labelled lines, tables and remarks."""

import sys
from collections.abc import Callable, Generator, Iterable, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from io import StringIO
from typing import Any, TypeAlias

from rich.console import Console
from rich.table import Table as Grid
from rich.text import Text

from dcfp.schema.table import Table

#: Width where the output is not a terminal.
WIDTH = 100

#: A sentence, labels with their texts, a table, or a table below a sentence on it.
Block: TypeAlias = str | Sequence[tuple[str, str]] | Grid | tuple[str | Text, Grid]


@dataclass(frozen=True)
class Page:
    """What is printed of an answer.

    Attributes
    ----------
    blocks
        One below the other, with an empty line between.
    remarks
        Sentences that a reader must know; each is printed once.
    """

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

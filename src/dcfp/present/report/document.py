"""What a report is made of, whatever it is written in: both renderers hold the same words and the same numbers."""

from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING, Any, TypeAlias

from dcfp.methods.result import Verdict
from dcfp.present.report.digits import number
from dcfp.study.scenario import Heading

if TYPE_CHECKING:
    from collections.abc import Callable

    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Maths:
    """Mathematics within words, as `dcfp.present.report.maths` reads it; never a user's words."""

    source: str


@dataclass(frozen=True)
class Code:
    """Words of a machine, which are not to be broken."""

    text: str


#: A piece of a sentence; a plain string may hold whatever a user wrote.
Part: TypeAlias = str | Maths | Code
Parts: TypeAlias = tuple[Part, ...]


class Tone(Enum):
    """How a paragraph sounds."""

    PLAIN = "plain"
    NOTE = "note"
    GOOD = "good"
    BAD = "bad"
    OPEN = "open"


@dataclass(frozen=True)
class Paragraph:
    """One paragraph."""

    parts: Parts
    tone: Tone = Tone.PLAIN


@dataclass(frozen=True)
class Bullets:
    """A list of sentences."""

    items: tuple[Parts, ...]


@dataclass(frozen=True)
class Cell:
    """A cell of a table; `verdict` sets its colour, and it reaches over `span` columns."""

    parts: Parts
    verdict: Verdict | None = None
    span: int = 1
    strong: bool = False


@dataclass(frozen=True)
class Table:
    """A table.

    Attributes
    ----------
    head
        Of the columns; empty for names and values.
    rows
        Of cells.
    aligned
        A letter for each column: ``l``, ``r`` or ``c``.
    widths
        Weight of each column's width; 0 for one that is as narrow as its content.
    caption
        Above it.
    """

    head: tuple[Parts, ...]
    rows: tuple[tuple[Cell, ...], ...]
    aligned: str
    widths: tuple[float, ...]
    caption: str = ""


@dataclass(frozen=True)
class Formula:
    """A formula with its numbers put in.

    Attributes
    ----------
    name
        What it gives, in words.
    symbols, numbers
        Mathematics: in symbols from the left side on, and the right side in numbers; `numbers` is empty for a value that is taken as it is.
    value
        Its result.
    decimals
        With which the result is written.
    unit
        Of the result; empty for none.
    source
        Paper and equation, code and clause.
    confirmed
        Whether that could be confirmed in its source.
    """

    name: str
    symbols: str
    numbers: str
    value: float
    decimals: int
    unit: str
    source: str
    confirmed: bool = True

    @property
    def result(self) -> str:
        """The result as mathematics, with its unit."""
        return number(self.value, self.decimals) + (f' thin "{self.unit}"' if self.unit else "")

    @property
    def lines(self) -> tuple[str, ...]:
        """Parts of the mathematics between which a line may be broken."""
        return (
            self.symbols,
            *((f"= {self.numbers}",) if self.numbers else ()),
            f"= {self.result}",
        )

    @property
    def origin(self) -> str:
        """Where it is from, as it is printed beside it."""
        return self.source if self.confirmed else f"{self.source}, unconfirmed"

    def as_numbers(self) -> dict[str, Any]:
        """Return it as JSON has it."""
        return {
            "name": self.name,
            "value": self.value,
            "unit": self.unit,
            "decimals": self.decimals,
            "source": self.source,
            "confirmed": self.confirmed,
        }


@dataclass(frozen=True)
class Equations:
    """Equations as they are in their source, without numbers; each is mathematics, and `origin` says where they are from."""

    symbols: tuple[str, ...]
    origin: str


@dataclass(frozen=True)
class Drawing:
    """A figure, drawn when it is needed.

    Attributes
    ----------
    draw
        Returns the figure.
    words
        What it shows, for those who cannot see it.
    caption
        Below it.
    """

    draw: "Callable[[], Figure]"
    words: str
    caption: str = ""


@dataclass(frozen=True)
class Listing:
    """A file, character for character."""

    text: str


Block: TypeAlias = Paragraph | Bullets | Table | Formula | Equations | Drawing | Listing


@dataclass(frozen=True)
class Section:
    """A section with its blocks, and sections within it.

    Attributes
    ----------
    title
        May hold a user's words.
    blocks
        In their order, before the sections within.
    parts
        Sections within.
    on_new_page
        Whether it begins a page.
    """

    title: str
    blocks: tuple[Block, ...] = ()
    parts: tuple["Section", ...] = ()
    on_new_page: bool = False


@dataclass(frozen=True, eq=False)
class Document:
    """A whole report.

    Attributes
    ----------
    title, heading
        Of the scenario.
    front
        What stands on the first page, below the head.
    sections
        After that.
    maker
        Program and version.
    with_contents
        Whether it is long enough for a table of contents.
    numbers
        Every number in it, ready for JSON.
    """

    title: str
    heading: Heading
    front: tuple[Block, ...]
    sections: tuple[Section, ...]
    maker: str
    with_contents: bool
    numbers: dict[str, Any]


def words(*parts: Part, tone: Tone = Tone.PLAIN) -> Paragraph:
    """Return a paragraph."""
    return Paragraph(parts, tone)


def cells(*texts: str | Parts) -> tuple[Cell, ...]:
    """Return a row of plain cells."""
    return tuple(Cell((text,) if isinstance(text, str) else text) for text in texts)


def heads(*texts: str | Parts) -> tuple[Parts, ...]:
    """Return the head of a table."""
    return tuple((text,) if isinstance(text, str) else text for text in texts)


def named_values(rows: "list[tuple[str, str | Parts]]", caption: str = "") -> Table:
    """Return a table of names and values; a value that is empty is left out."""
    return Table((), tuple(cells(name, value) for name, value in rows if value), "ll", (0.0, 1.0), caption)

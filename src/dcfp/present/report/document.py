"""What a report is made of, whatever it is written in: both renderers hold the same words and the same numbers."""

import math
import re
import unicodedata
from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING, Any, TypeAlias

from dcfp.present.report.maths import SYMBOLS
from dcfp.schema.check import Verdict
from dcfp.schema.formulas import Formula, true_minus, typeset
from dcfp.schema.quantities import NOTHING
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


#: Words, names and letters of a symbol in LaTeX.
_LATEX = re.compile(r"\\mathrm\{(?P<word>[^{}]*)\}|\\(?P<name>[A-Za-z]+)|[A-Za-z]{2,}")
#: What a box of a tone and a cell of a verdict are called in both forms.
BOXES = {Tone.GOOD: "met", Tone.BAD: "broken", Tone.OPEN: "open"}
COLOURS = {Verdict.MET: "met", Verdict.NOT_MET: "broken", Verdict.NOT_KNOWN: "open"}


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
    """A table with a caption above it.

    Attributes
    ----------
    head
        Of the columns; empty for names and values.
    aligned
        A letter for each column: ``l``, ``r`` or ``c``.
    widths
        Weight of each column's width; 0 for one that is as narrow as its content.
    """

    head: tuple[Cell, ...]
    rows: tuple[tuple[Cell, ...], ...]
    aligned: str
    widths: tuple[float, ...]
    caption: str = ""


@dataclass(frozen=True)
class Equations:
    """Equations as they are in their source, without numbers; each is mathematics, and `origin` says where they are from."""

    symbols: tuple[str, ...]
    origin: str


@dataclass(frozen=True)
class Drawing:
    """A figure, drawn when it is needed; `words` say what it shows to those who cannot see it."""

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
    """A section: its blocks, and then the sections within it; the title may hold a user's words."""

    title: str
    blocks: tuple[Block, ...] = ()
    parts: tuple["Section", ...] = ()
    on_new_page: bool = False


@dataclass(frozen=True, eq=False)
class Document:
    """A whole report: what stands on the first page below the head, the sections, and every number ready for JSON."""

    title: str
    heading: Heading
    front: tuple[Block, ...]
    sections: tuple[Section, ...]
    maker: str
    numbers: dict[str, Any]


def words(*parts: Part, tone: Tone = Tone.PLAIN) -> Paragraph:
    """Return a paragraph."""
    return Paragraph(parts, tone)


def note(*parts: Part) -> Paragraph:
    """Return a note."""
    return Paragraph(parts, Tone.NOTE)


def cells(*texts: str | Parts) -> tuple[Cell, ...]:
    """Return a row of plain cells, or the head of a table."""
    return tuple(Cell((text,) if isinstance(text, str) else text) for text in texts)


def maths_of(symbol: str) -> str:
    """Return a symbol in LaTeX as `dcfp.present.report.maths` reads it; what that does not know stands there as words."""

    def piece(found: re.Match[str]) -> str:
        word, name = found["word"], found["name"]
        if word is None and name is None:
            return " ".join(found[0])  # each letter is a symbol
        return name if name in SYMBOLS else f'"{word or name}"'

    return _LATEX.sub(piece, symbol).replace("{", "(").replace("}", ")")


def named_values(rows: "list[tuple[str, str | Parts]]", caption: str = "") -> Table:
    """Return a table of names and values; a value that is empty is left out."""
    return Table((), tuple(cells(name, value) for name, value in rows if value), "ll", (0.0, 1.0), caption)


#: Decimals by the key of JSON; what ends in none of these is no number of a table.
DECIMALS = {
    "pgv_m_s": 3,
    "y_max_mm": 1,
    "dy_max_mm": 1,
    "v_max_mm_s": 1,
    "residual_mm": 1,
    "force_max_kN": 1,
    "temperature_max_degC": 1,
    "temperature_point_max_degC": 1,
    "friction_min": 4,
    "V_E_mm_s": 1,
    "V_Eh_mm_s": 1,
    "dy_mm": 1,
    "y_mm": 1,
    "V_dE_mm_s": 1,
    "V_dEhr_mm_s": 1,
    "displacement_mm": 1,
    "base_shear_over_weight": 4,
    "effective_period_s": 3,
    "effective_damping": 4,
    "energy_kN_m": 2,
    "pga_m_s2": 3,
    "ratio": 2,
}


def written(key: str, value: float | None) -> str:
    """Return a number of a key as it stands in the report; a dash for none and for what is not finite."""
    return NOTHING if value is None or not math.isfinite(value) else typeset(value, DECIMALS[key])


def powered(value: float) -> str:
    """Return a small number with a power of ten, as in ``1.1e−14``."""
    return true_minus(f"{value:.1e}") if value else "0"


def short(value: float) -> str:
    """Return a given number with the digits that it was given with."""
    return true_minus(f"{value:.10g}")


#: Who signs below what the scenario says.
_SIGNING = ("author", "checker")


def heading_rows(document: Document) -> Table:
    """Return what the scenario says of the report."""
    told = [
        (one.words.capitalize(), value) for one, value in document.heading.rows() if one.name not in _SIGNING
    ]
    return named_values([*told, ("Calculated with", document.maker)])


def short_title(document: Document) -> str:
    """Return what stands at the top of every page."""
    heading = document.heading
    return "  |  ".join(shortened(word) for word in (heading.number, heading.project, document.title) if word)


def signatories(document: Document) -> tuple[tuple[str, str, str], ...]:
    """Return role and name of those who sign, and a line for the date where the report has none."""
    heading = document.heading
    asked, date = ("signature, date", "") if heading.date else ("signature", "Date: ________")
    return (
        (f"Calculated by ({asked})", heading.author, date),
        (f"Checked by ({asked})", heading.checker, date),
    )


def shortened(text: str, most: int = 45) -> str:
    """Return a text on one line, cut to so many characters."""
    plain = " ".join(text.split())
    return plain if len(plain) <= most else plain[: most - 1].rstrip() + "…"


def printable(text: str) -> str:
    """Return a text without the characters that steer a machine; line ends and tabs stay."""
    return "".join(c for c in text if c in "\n\t" or unicodedata.category(c) not in ("Cc", "Cs"))

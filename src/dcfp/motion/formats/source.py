"""The text of a record file: its lines, the numbers in them, and what stands in its header, each error with its line and value."""

import math
import re
from collections.abc import Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from datetime import datetime, timedelta, timezone
from pathlib import Path
from typing import NamedTuple, NoReturn

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import InputError
from dcfp.schema.reading import read_bytes

#: Largest file that is read [bytes]; the longest public records stay far below it.
MAXIMUM_SIZE = 200_000_000
_RECORD = "a record of ground acceleration"


@dataclass(frozen=True)
class SourceText:
    """A file as lines of text, with what the user says of the unit and the time step of a record where that is not left to the file."""

    path: Path  #: as the user wrote it
    lines: tuple[str, ...]  #: without the ends of line
    units: str | None = None
    time_step: float | None = None  #: [s]

    def fail(self, reason: str, *, line: int | None = None) -> NoReturn:
        """Raise an `InputError` that names the file and, counted from 1, the line."""
        place = f"{self.path}" if line is None else f"{self.path}, line {line}"
        msg = f"{place}: {reason}"
        raise InputError(msg)


def read_source(
    path: Path, *, units: str | None = None, time_step: float | None = None, what: str = _RECORD
) -> SourceText:
    """Return a file as text; `what` it should hold is for sentences.

    Raises
    ------
    InputError
        If there is no such file, or it is empty, too large, not readable or not text.
    """
    hint = _likely(path) if what == _RECORD else f"{what} was expected"
    content = read_bytes(path, hint, most=MAXIMUM_SIZE + 1)
    if len(content) > MAXIMUM_SIZE:
        msg = f"{path}: the file is larger than {MAXIMUM_SIZE / 1e6:.0f} MB, so it is not {what}."
        raise InputError(msg)
    return source_of(content, path, units=units, time_step=time_step, what=what)


def _likely(path: Path) -> str:
    """Return which files are there that begin as one that is not."""
    try:
        near = sorted(one.name for one in path.parent.iterdir() if one.name.startswith(path.stem))
    except OSError:
        near = []
    if not near or path.exists():
        return "check the path"
    return f"in its folder {'is' if len(near) == 1 else 'are'} {', '.join(near[:3])}{' and others' if len(near) > 3 else ''}"


def source_of(
    content: bytes,
    path: Path,
    *,
    units: str | None = None,
    time_step: float | None = None,
    what: str = _RECORD,
) -> SourceText:
    """Return the content of a file as text; `path` is only its name. Errors are those of `read_source`."""
    if not content.strip():
        msg = f"{path}: the file is empty; {what} was expected."
        raise InputError(msg)
    if b"\x00" in content:
        msg = f"{path}: this is a binary file; {what} as text was expected."
        raise InputError(msg)
    text = _decode(content).replace("\r\n", "\n").replace("\r", "\n")
    return SourceText(path, tuple(text.rstrip(" \t\n\x1a").split("\n")), units, time_step)


def _decode(content: bytes) -> str:
    """Decode by trying: UTF-8, then the Shift-JIS of Japanese files, then one byte a character."""
    for encoding in ("utf-8-sig", "cp932"):
        with suppress(UnicodeDecodeError):
            return content.decode(encoding)
    return content.decode("latin-1")


#: One number as Fortran and C write it; no ``nan``, ``inf`` or ``1_000``, which Python would accept.
NUMBER = r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[EeDd][+-]?[0-9]{1,3})?"

_NUMBER = re.compile(NUMBER)
_PLAIN_CHARACTERS = frozenset("0123456789+-.eE \t\n")


class Layout(NamedTuple):
    """A Fortran format of one kind of field: how many on a line, and how wide."""

    per_line: int
    width: int


def parse_layout(text: str) -> Layout | None:
    """Return the layout that a Fortran format such as ``8F10.5`` or ``(1E15.6)`` says, or None."""
    found = re.search(r"(?<![\w.])(\d{0,3})\s*[FEDGI](\d{1,2})(?![\w])", text, re.IGNORECASE)
    if found is None:
        return None
    per_line, width = int(found[1] or 1), int(found[2])
    return Layout(per_line, width) if per_line > 0 and width > 0 else None


def to_number(text: str) -> float | None:
    """Return the finite number that `text` is, or None when it is anything else."""
    word = text.strip()
    if len(word) > 60 or not _NUMBER.fullmatch(word):
        return None
    value = float(word.replace("D", "E").replace("d", "e"))
    return value if math.isfinite(value) else None


def free_numbers(source: SourceText, first: int, count: int) -> FloatArray:
    """Return the `count` numbers, separated by blanks, that must stand from ``lines[first]`` of the file on."""
    lines = source.lines[first:]
    text = "\n".join(lines)
    values: list[float] = []
    if _PLAIN_CHARACTERS.issuperset(text):
        with suppress(ValueError):
            values = [float(word) for word in text.split()]
    if not values or not all(map(math.isfinite, values)):
        # one by one, to tell where the first is that is no number
        rows = (_row(source, line.split(), number) for number, line in enumerate(lines, first + 1))
        values = [value for row in rows for value in row]
    check_count(source, len(values), count)
    return np.array(values, dtype=np.float64)


def check_count(source: SourceText, found: int, promised: int) -> None:
    """Refuse a file in which other than the promised number of values is found."""
    if found < promised:
        source.fail(
            f"the header promises {promised} values but only {found} are there; the file is truncated."
        )
    if found > promised:
        source.fail(f"the header promises {promised} values but {found} are there; the file is damaged.")


def table_numbers(source: SourceText, first: int, columns: int, separator: str | None = None) -> FloatArray:
    """Return the lines from ``lines[first]`` on, which must be a table of numbers, shape (rows, columns)."""
    rows: list[list[float]] = []
    for number, line in enumerate(source.lines[first:], first + 1):
        words = line.split(separator)
        if len(words) != columns:
            source.fail(f"{len(words)} values stand where {columns} were expected.", line=number)
        rows.append(_row(source, words, number))
    return np.array(rows, dtype=np.float64).reshape(-1, columns)


def fixed_numbers(source: SourceText, first: int, count: int, layout: Layout) -> tuple[FloatArray, int]:
    """Return the `count` numbers that must stand in fields of fixed width from ``lines[first]`` on, and the line after them."""
    rows = -(-count // layout.per_line)
    values: list[float] = []
    for number, line in enumerate(source.lines[first : first + rows], first + 1):
        expected = min(layout.per_line, count - len(values))
        fields = [line[place * layout.width :][: layout.width] for place in range(expected)]
        for place, field in enumerate(fields, 1):
            if not field.strip():
                source.fail(f"the header promises {count} values but value {place} is missing.", line=number)
        values += _row(source, fields, number)
        if line[expected * layout.width :].strip():
            source.fail(f"more stands here than the {expected} values that the header promises.", line=number)
    check_count(source, len(values), count)
    return np.array(values, dtype=np.float64), first + rows


def announced_numbers(source: SourceText, line: int, count: int, text: str) -> tuple[FloatArray, int]:
    """Return the `count` numbers that must stand below a line whose `text` gives their format, and the line after them.

    Raises
    ------
    InputError
        If there is no such format, or the numbers are not in it, or more of them follow.
    """
    layout = parse_layout(text)
    if layout is None:
        source.fail("the values need a format such as '(8F10.5)'.", line=line + 1)
    values, after = fixed_numbers(source, line + 1, count, layout)
    if after < len(source.lines) and not re.search("[A-Za-z]{2}|/&", source.lines[after]):
        source.fail(f"more values stand here than the {count} that were promised.", line=after + 1)
    return values, after


def _row(source: SourceText, words: Sequence[str], line: int) -> list[float]:
    """Return the numbers that the words of a line must be."""
    values: list[float] = []
    for place, word in enumerate(words, 1):
        value = to_number(word)
        if value is None:
            word = word.strip()
            shown = repr(word if len(word) <= 30 else f"{word[:30]}...")
            source.fail(f"value {place} is {shown}, not a finite number.", line=line)
        values.append(value)
    return values


#: A date and a time of day, with the year first or last, of which an American year may have two digits.
_YEAR_FIRST = re.compile(r"(\d{4})\D?(\d{1,2})\D?(\d{1,2})\D+(\d{1,2})\D?(\d{1,2})\D?(\d{1,2}(?:\.\d{1,9})?)")
_YEAR_LAST = re.compile(
    r"(?<!\d)(\d{1,2})/(\d{1,2})/(\d{4}|\d{2}),?\s+(\d{1,2}):(\d{1,2}):(\d{1,2}(?:\.\d{1,9})?)"
)


def moment(text: str, hours: int = 0, more: float = 0.0) -> str:
    """Return a date and time as ISO 8601 with its offset from UTC, `hours`, and `more` seconds later; empty where `text` holds none."""
    if found := _YEAR_LAST.search(text):
        month, day, year, hour, minute, second = found.groups()
        if len(year) == 2:
            year = f"20{year}" if year < "50" else f"19{year}"
    elif found := _YEAR_FIRST.search(text):
        year, month, day, hour, minute, second = found.groups()
    else:
        return ""
    with suppress(ValueError, OverflowError):
        zone = timezone(timedelta(hours=hours))
        begun = datetime(int(year), int(month), int(day), int(hour), int(minute), tzinfo=zone)
        # a second of 60 is the next minute
        return (begun + timedelta(seconds=float(second) + more)).isoformat()
    return ""


class Header(dict[str, str]):
    """Texts of the header of a record file by their names; the file is for sentences."""

    def __init__(self, source: SourceText, entries: Iterable[tuple[str, str]]) -> None:
        super().__init__((name, text.strip()) for name, text in entries)
        self._source = source

    @classmethod
    def of_lines(cls, source: SourceText, lines: Iterable[str], mark: str) -> "Header":
        """Return what stands in lines of a name and a text with a mark in between, such as ``=``."""
        parts = (line.strip().lstrip("#").partition(mark) for line in lines if mark in line)
        return cls(source, ((name.strip(), text) for name, _, text in parts))

    def text(self, name: str) -> str:
        """Return an entry, which must be there."""
        text = self.get(name, "")
        if not text:
            self._source.fail(f"the header has no entry {name!r}; the file is damaged.")
        return text

    def number(self, name: str) -> float:
        """Return the positive number that an entry must begin with (``"100Hz"`` gives 100)."""
        text = self.text(name)
        found = re.match(NUMBER, text)
        value = to_number(found[0]) if found else None
        if value is None or not 0.0 < value < math.inf:
            self._source.fail(f"the header entry {name!r} is {text[:30]!r}; a positive number was expected.")
        return value

    def unit(self, name: str, usual: str) -> str:
        """Return the unit of acceleration that an entry must begin with."""
        text = self.text(name)
        unit = canonical_unit(re.split(r"\.?\s", text)[0])
        if unit is None:
            self._source.fail(f"the unit is {text[:30]!r}; {usual!r} was expected.")
        return unit

    def count(self, rate: str, duration: str) -> int:
        """Return the number of values at a rate [Hz] over a duration [s], as two entries give them."""
        count = self.number(rate) * self.number(duration)
        if not 2 <= count <= 1e9:
            self._source.fail(
                f"the header promises {count:.3g} values ({self.number(duration):g} s at {self.number(rate):g} Hz)."
            )
        return round(count)


#: Size of each unit [mm/s2], under the spelling that `canonical_unit` makes of it.
_SIZES = {"mm/s2": 1.0, "cm/s2": 10.0, "gal": 10.0, "m/s2": 1000.0, "g": STANDARD_GRAVITY}

_SPELLINGS = {"gals": "gal", "gal(cm/s/s)": "gal", "g's": "g", "gs": "g"}


def canonical_unit(text: str) -> str | None:
    """Return one of mm/s2, cm/s2, gal, m/s2, g for any usual spelling of it, or None."""
    word = re.sub(r"[\s^*.]+", "", text.lower())
    word = _SPELLINGS.get(word, word)
    word = re.sub(r"/(?:sec|s)/(?:sec|s)$", "/s2", word)
    word = re.sub(r"/sec2$", "/s2", word)
    word = word.replace("²", "2")
    return word if word in _SIZES else None


def unit_size(text: str) -> float:
    """Return the size of a unit of acceleration [mm/s2], which must be known.

    Raises
    ------
    InputError
        If the unit is not known.
    """
    unit = canonical_unit(text)
    if unit is None:
        msg = f"the unit {text!r} is not known; use one of {', '.join(_SIZES)}."
        raise InputError(msg)
    return _SIZES[unit]

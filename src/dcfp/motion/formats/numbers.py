"""Numbers from the lines and from the header of a record file, each error with its line and value."""

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.motion.formats.source import SourceText

#: One number as Fortran and C write it; no ``nan``, ``inf`` or ``1_000``, which Python would accept.
NUMBER = r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[EeDd][+-]?[0-9]{1,3})?"

_NUMBER = re.compile(NUMBER)
_PLAIN_CHARACTERS = frozenset("0123456789+-.eE \t\n")


@dataclass(frozen=True)
class Layout:
    """A Fortran format of one kind of field: how many on a line, and how wide."""

    per_line: int
    width: int

    def fields(self, line: str, count: int) -> list[str]:
        """Return the first `count` fields of a line."""
        return [line[place * self.width : (place + 1) * self.width] for place in range(count)]

    def remainder(self, line: str, count: int) -> str:
        """Return what follows the first `count` fields of a line."""
        return line[count * self.width :]


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


def free_numbers(source: SourceText, first: int) -> FloatArray:
    """Return the numbers, separated by blanks, from ``lines[first]`` of the file on.

    Raises
    ------
    InputError
        If anything there is not a finite number.
    """
    lines = source.lines[first:]
    text = "\n".join(lines)
    if _PLAIN_CHARACTERS.issuperset(text):
        try:
            values = np.array([float(word) for word in text.split()], dtype=np.float64)
        except ValueError:
            values = None
        if values is not None and np.isfinite(values).all():
            return values
    return np.array(list(_located_numbers(source, first, lines)), dtype=np.float64)


def _located_numbers(source: SourceText, first: int, lines: Sequence[str]) -> Iterator[float]:
    for number, line in enumerate(lines, first + 1):
        for place, word in enumerate(line.split(), 1):
            yield _value_at(source, word, number, place)


def check_count(source: SourceText, found: int, promised: int) -> None:
    """Compare the number of values found with the number that the header promises.

    Raises
    ------
    InputError
        If they differ.
    """
    if found < promised:
        source.fail(
            f"the header promises {promised} values but only {found} are there; the file is truncated."
        )
    if found > promised:
        source.fail(f"the header promises {promised} values but {found} are there; the file is damaged.")


def table_numbers(source: SourceText, first: int, columns: int, separator: str | None = None) -> FloatArray:
    """Return the lines from ``lines[first]`` on as a table of numbers, shape (rows, columns).

    Raises
    ------
    InputError
        If a row has more or fewer values, or one that is not a finite number.
    """
    rows: list[list[float]] = []
    for number, line in enumerate(source.lines[first:], first + 1):
        words = line.split(separator)
        if len(words) != columns:
            source.fail(f"{len(words)} values stand where {columns} were expected.", line=number)
        rows.append([_value_at(source, word, number, place) for place, word in enumerate(words, 1)])
    return np.array(rows, dtype=np.float64).reshape(-1, columns)


def fixed_numbers(source: SourceText, first: int, count: int, layout: Layout) -> tuple[FloatArray, int]:
    """Return `count` numbers in fields of fixed width from ``lines[first]`` on, and the line after them.

    Raises
    ------
    InputError
        If a field is not a finite number, or there are fewer or more values than `count`.
    """
    rows = -(-count // layout.per_line)
    values: list[float] = []
    for number, line in enumerate(source.lines[first : first + rows], first + 1):
        expected = min(layout.per_line, count - len(values))
        for place, field in enumerate(layout.fields(line, expected), 1):
            if not field.strip():
                source.fail(f"the header promises {count} values but value {place} is missing.", line=number)
            values.append(_value_at(source, field, number, place))
        if layout.remainder(line, expected).strip():
            source.fail(f"more stands here than the {expected} values that the header promises.", line=number)
    check_count(source, len(values), count)
    return np.array(values, dtype=np.float64), first + rows


def _value_at(source: SourceText, word: str, line: int, place: int) -> float:
    value = to_number(word)
    if value is None:
        source.fail(f"value {place} is {_shown(word)}, not a finite number.", line=line)
    return value


def _shown(word: str) -> str:
    word = word.strip()
    return repr(word if len(word) <= 30 else f"{word[:30]}...")


# What the headers of record files have in common: lines of a name and its text.


def required_text(source: SourceText, header: Mapping[str, str], name: str) -> str:
    """Return an entry of the header.

    Raises
    ------
    InputError
        If it is missing or empty.
    """
    text = header.get(name, "").strip()
    if not text:
        source.fail(f"the header has no entry {name!r}; the file is damaged.")
    return text


def required_number(source: SourceText, header: Mapping[str, str], name: str) -> float:
    """Return the number that an entry of the header begins with (``"100Hz"`` gives 100).

    Raises
    ------
    InputError
        If the entry is missing, or no positive number.
    """
    text = required_text(source, header, name)
    found = re.match(NUMBER, text)
    value = to_number(found[0]) if found else None
    if value is None or not 0.0 < value < math.inf:
        source.fail(f"the header entry {name!r} is {text[:30]!r}; a positive number was expected.")
    return value


def promised_count(source: SourceText, rate: float, duration: float) -> int:
    """Return the number of values in a record of `duration` [s] at `rate` [Hz].

    Raises
    ------
    InputError
        If that is not a number of values that a record can have.
    """
    count = rate * duration
    if not 2 <= count <= 1e9:
        source.fail(f"the header promises {count:.3g} values ({duration:g} s at {rate:g} Hz).")
    return round(count)

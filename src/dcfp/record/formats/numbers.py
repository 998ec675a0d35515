"""Numbers from the lines of a record file, each error with its line and value."""

import math
import re
from collections.abc import Iterator, Sequence

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.record.formats.source import SourceText

#: One number as Fortran and C write it; no ``nan``, ``inf`` or ``1_000``, which Python would accept.
NUMBER = r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[EeDd][+-]?[0-9]{1,3})?"

_NUMBER = re.compile(NUMBER)
_PLAIN_CHARACTERS = frozenset("0123456789+-.eE \t\n")


def to_number(text: str) -> float | None:
    """Return the finite number that `text` is, or None when it is anything else."""
    word = text.strip()
    if len(word) > 60 or not _NUMBER.fullmatch(word):
        return None
    value = float(word.replace("D", "E").replace("d", "e"))
    return value if math.isfinite(value) else None


def free_numbers(source: SourceText, first: int, last: int | None = None) -> FloatArray:
    """Return the numbers, separated by blanks, in ``lines[first:last]`` of the file.

    Raises
    ------
    InputError
        If anything there is not a finite number.
    """
    lines = source.lines[first:last]
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
        for position, word in enumerate(line.split(), 1):
            value = to_number(word)
            if value is None:
                shown = word if len(word) <= 30 else f"{word[:30]}..."
                source.fail(f"value {position} is {shown!r}, not a finite number.", line=number)
            yield value


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

"""What the headers of record files have in common: lines of a name and its text."""

import math
import re
from collections.abc import Mapping

from dcfp.motion.formats.numbers import NUMBER, to_number
from dcfp.motion.formats.source import SourceText


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

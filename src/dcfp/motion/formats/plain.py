"""Plain text or CSV: one column of acceleration, or time and acceleration.

Lines before the first line of numbers are a header. Columns are parted by commas, semicolons or blanks.
"""

from dcfp.motion.formats.registry import (
    PLAIN,
    RecordFormat,
    Series,
    printed_resolution,
    uniform_step,
)
from dcfp.motion.formats.source import SourceText, canonical_unit, table_numbers, to_number

_COMMENTS = ("#", "%", "//", "!")
_LONGEST_HEADER = 100


def _recognises(source: SourceText) -> bool:
    """Never: any other format goes before this one."""
    return False


def _read(source: SourceText) -> list[Series]:
    first, separator, columns = _shape(source)
    if columns > 2:
        source.fail(
            f"the file is in none of the known record formats and has {columns} columns; plain text must "
            "have one (acceleration) or two (time, acceleration).",
            line=first + 1,
        )
    if source.units is None:
        source.fail(
            f"the file is in none of the known record formats; to read it as {PLAIN}, give the unit of its "
            "acceleration (units), for example g."
        )
    unit = canonical_unit(source.units)
    if unit is None:
        source.fail(f"the unit {source.units!r} is not known; use one of mm/s2, cm/s2, gal, m/s2, g.")
    table = table_numbers(source, first, columns, separator)
    step = source.time_step
    if columns == 2:
        resolution = max(printed_resolution(line.split(separator)[0]) for line in source.lines[first:])
        step = uniform_step(source, table[:, 0], resolution)
        given = source.time_step
        if given is not None and abs(given - step) > 1e-6 * step:
            source.fail(f"the column of times has a step of {step:g} s, but time_step={given!r} was given.")
    if step is None:
        source.fail("the file has one column and no times; give the time step in seconds (time_step)")
    return [Series(table[:, -1], unit, step, processing="unknown; the file does not say")]


def _shape(source: SourceText) -> tuple[int, str | None, int]:
    """Return the first line of numbers, what parts its columns, and how many there are."""
    for index, line in enumerate(source.lines[: _LONGEST_HEADER + 1]):
        if not line.strip() or line.lstrip().startswith(_COMMENTS):
            continue
        separator = next((mark for mark in (",", ";") if mark in line), None)
        words = line.split(separator)
        if all(to_number(word) is not None for word in words):
            return index, separator, len(words)
    return source.fail(
        "the file is in none of the known record formats, and no line of numbers was found at its beginning."
    )


PLAIN_COLUMNS = RecordFormat(
    PLAIN,
    "any other text: a column of acceleration, with its unit and time step given, or time and acceleration, with the unit given",
    _recognises,
    _read,
)

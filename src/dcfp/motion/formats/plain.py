"""Plain text or CSV: one column of acceleration, or time and acceleration.

Lines before the first line of numbers are a header. Columns are parted by commas, semicolons or blanks.
"""

from dcfp.arrays import FloatArray
from dcfp.motion.formats.component import (
    Component,
    build_component,
    canonical_unit,
    printed_resolution,
    uniform_step,
)
from dcfp.motion.formats.numbers import table_numbers, to_number
from dcfp.motion.formats.source import SourceText
from dcfp.motion.ground_motion import Origin

NAME = "plain columns"

_COMMENTS = ("#", "%", "//", "!")
_LONGEST_HEADER = 100


def read(source: SourceText, units: str | None, time_step: float | None) -> list[Component]:
    """Return the one component of the file.

    Parameters
    ----------
    source
        The file.
    units
        Unit of the acceleration.
    time_step
        Time step [s]; needed for one column, checked against the times where there are two.

    Raises
    ------
    InputError
        If the file has neither one nor two columns of numbers, or the unit or the time step is missing.
    """
    first, separator, columns = _shape(source)
    if columns > 2:
        source.fail(
            f"the file is in none of the known record formats and has {columns} columns; plain text must "
            "have one (acceleration) or two (time, acceleration).",
            line=first + 1,
        )
    if units is None:
        source.fail(
            f"the file is in none of the known record formats; to read it as {NAME}, give the unit of its "
            "acceleration (units), for example g."
        )
    unit = canonical_unit(units)
    if unit is None:
        source.fail(f"the unit {units!r} is not known; use one of mm/s2, cm/s2, gal, m/s2, g.")
    table = table_numbers(source, first, columns, separator)
    words = [line.split(separator)[0] for line in source.lines[first:]]
    step = _given_step(source, time_step) if columns == 1 else _column_step(source, words, table[:, 0])
    if columns == 2 and time_step is not None and abs(time_step - step) > 1e-6 * step:
        source.fail(f"the column of times has a step of {step:g} s, but time_step={time_step!r} was given.")
    origin = Origin(source=source.path.name, file_format=NAME, processing="unknown; the file does not say")
    return [build_component(source, table[:, -1], unit=unit, time_step=step, origin=origin)]


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


def _given_step(source: SourceText, time_step: float | None) -> float:
    if time_step is None:
        source.fail("the file has one column and no times; give the time step in seconds (time_step)")
    return time_step


def _column_step(source: SourceText, words: list[str], time: FloatArray) -> float:
    resolution = max(printed_resolution(word) for word in words)
    return uniform_step(source, time, resolution)

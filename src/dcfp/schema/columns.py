"""Tables in text: CSV whose head names each column with its unit."""

import csv
import io
import math
import re
from collections.abc import Mapping, Sequence
from typing import TypeAlias

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.schema.units import CM, INCH, METRE, MILLISECOND, MM, SECOND, Unit

#: Columns that a file may have, each with its units by their names; a column that may do without one has the name ``""``.
Columns: TypeAlias = Mapping[str, Mapping[str, Unit]]

_HEAD = re.compile(r"\s*(?P<name>[^\[\](]+?)\s*[\[(]\s*(?P<unit>[^\])]*?)\s*[\])]\s*")
#: Beginnings of lines that are no data: a note, and how a spreadsheet names its separator.
_NOTES = ("#", "sep=")
#: Size beyond which a number is no measured value, and characters of one that a sentence repeats.
_LARGEST_NUMBER = 1e30
_LONGEST_WORD = 40


def named(*units: Unit) -> dict[str, Unit]:
    """Return units by their names."""
    return {name: unit for unit in units for name in (unit.text, unit.name)}


#: Units of times and lengths, by their names.
TIMES, LENGTHS = named(SECOND, MILLISECOND), named(MM, CM, METRE, INCH)


def names_of(text: str) -> set[str]:
    """Return the names in the head of measured columns, without their units."""
    return {_name(cell) for row in csv.reader([_head(text)], delimiter=_separator(text)) for cell in row}


def read_columns(
    text: str, where: str, columns: Columns, needed: Sequence[str], fewest: int, rows_are: str, example: str
) -> tuple[dict[str, FloatArray], list[int]]:
    """Return those of the `columns` that there are, in the units of the package, and the number of the line of each row.

    Parameters
    ----------
    text, where
        What the file holds, and its name.
    columns, needed
        Columns that there may be, and names of those that there must be.
    fewest, rows_are
        Least number of rows, and what they are called.
    example
        A head, for the sentence on an empty file.

    Raises
    ------
    InputError
        If a column or a unit is missing, or what should be a number is none.
    """
    separator = _separator(text)
    reader = csv.reader(io.StringIO(text, newline=None), delimiter=separator)
    try:
        rows = [
            (reader.line_num, row)
            for row in reader
            if any(cell.strip() for cell in row) and not row[0].lstrip().startswith(_NOTES)
        ]
    except csv.Error as error:
        msg = f"{where}, line {reader.line_num}: this is not a line of a CSV file ({error})."
        raise InputError(msg) from error
    if not rows:
        msg = f"{where}: the file is empty; its first line must name the columns, such as {example!r}."
        raise InputError(msg)
    places = _places(rows[0][1], where, columns, needed)
    if len(rows) - 1 < fewest:
        msg = f"{where}: there are {len(rows) - 1} {rows_are}; at least {fewest} are needed."
        raise InputError(msg)
    values = {
        name: np.array([_number(row, place, name, number, where, separator) for number, row in rows[1:]])
        * factor
        for name, (place, factor) in places.items()
    }
    return values, [number for number, _ in rows[1:]]


def _head(text: str) -> str:
    lines = (line for line in text.splitlines() if line.strip() and not line.lstrip().startswith(_NOTES))
    return next(lines, "")


def _separator(text: str) -> str:
    """Return what stands between the columns of the head: a comma, a semicolon or a tab."""
    return max(",;\t", key=_head(text).count)


def _name(cell: str) -> str:
    found = _HEAD.fullmatch(cell)
    return (found["name"] if found else cell.strip()).lower()


def _places(
    head: list[str], where: str, columns: Columns, needed: Sequence[str]
) -> dict[str, tuple[int, float]]:
    """Return for each known column its place and the factor of its unit."""
    places: dict[str, tuple[int, float]] = {}
    for place, cell in enumerate(head):
        found, name = _HEAD.fullmatch(cell), _name(cell)
        if name not in columns:
            continue
        units = columns[name]
        unit = found["unit"] if found else ""
        if unit not in units and found is None:
            msg = f"{where}: the column {name!r} has no unit; write it in brackets, such as '{name} [{next(iter(units))}]'."
            raise InputError(msg)
        if unit not in units:
            msg = f"{where}: the unit {unit[:_LONGEST_WORD]!r} of the column {name!r} is not known; the choices are {', '.join(units)}."
            raise InputError(msg)
        if name in places:
            msg = f"{where}: there are two columns {name!r}; leave one."
            raise InputError(msg)
        places[name] = (place, units[unit].size)
    for name in needed:
        if name not in places:
            unit = next(iter(columns[name]))
            wanted = f"{name} [{unit}]" if unit else name
            msg = f"{where}: the first line names no column {wanted!r}; it must name the columns with their units."
            raise InputError(msg)
    return places


def _number(row: list[str], place: int, name: str, line: int, where: str, separator: str) -> float:
    cell = row[place].strip() if place < len(row) else ""
    try:
        value = float(cell if separator == "," else cell.replace(",", "."))  # a decimal comma
    except ValueError:
        value = math.nan
    if not abs(value) < _LARGEST_NUMBER:
        shown = cell if len(cell) <= _LONGEST_WORD else f"{cell[:_LONGEST_WORD]}..."
        what = f"is {shown!r}, not a number" if cell else "is missing"
        msg = f"{where}, line {line}: the {name} {what}."
        raise InputError(msg)
    return value

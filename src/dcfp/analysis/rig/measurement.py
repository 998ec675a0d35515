"""A measured test: histories from a CSV file whose head names each column and its unit."""

import csv
import hashlib
import io
import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from dcfp.analysis.rig.measures import Cycle, cycles_of, zero_crossings
from dcfp.analysis.rig.waveform import cycle_bounds
from dcfp.arrays import FloatArray, freeze
from dcfp.errors import InputError
from dcfp.schema.notebook import fields_card
from dcfp.schema.reading import read_bytes
from dcfp.schema.units import (
    CM,
    DEGC,
    INCH,
    KIP,
    KN,
    MEGANEWTON,
    METRE,
    MILLISECOND,
    MM,
    NEWTON,
    SECOND,
    Unit,
)

#: Columns that a file may have, each with its units by their names.
Columns: TypeAlias = Mapping[str, Mapping[str, Unit]]


def _named(*units: Unit) -> dict[str, Unit]:
    return {name: unit for unit in units for name in (unit.text, unit.name)}


#: Units of times, lengths and forces, by their names.
TIMES, LENGTHS = _named(SECOND, MILLISECOND), _named(MM, CM, METRE, INCH)
FORCES = _named(NEWTON, KN, MEGANEWTON, KIP)
_COLUMNS: Columns = {
    "time": TIMES,
    "displacement": LENGTHS,
    "force": FORCES,
    "load": FORCES,
    "temperature": _named(DEGC, replace(DEGC, typed="C")),
}
_NEEDED = ("time", "displacement")
_HEAD = re.compile(r"\s*(?P<name>[^\[\](]+?)\s*[\[(]\s*(?P<unit>[^\])]*?)\s*[\])]\s*")
#: A step so much longer than the usual one is a gap.
_GAP = 10.0
_FEWEST_SAMPLES = 20
#: Beginnings of lines that are no data: a note, and how a spreadsheet names its separator.
_NOTES = ("#", "sep=")
#: Part of the largest force times the largest displacement that the work may fall below zero by rounding and noise [-].
_BACKWARD_WORK = 0.1
#: Size beyond which a number is no measured value, and characters of one that a sentence repeats.
_LARGEST_NUMBER = 1e30
_LONGEST_WORD = 40
#: Peaks that a wrong unit would pass: displacement [mm], mean velocity between samples [mm/s], force over load [-].
_DISPLACEMENTS = (0.5, 5000.0)
_VELOCITIES = (0.01, 10_000.0)
_FORCE_RATIOS = (1e-3, 2.0)


@dataclass(frozen=True, eq=False)
class Measurement:
    """Histories that were measured: times from zero [s] and displacement [mm], with name and SHA-256 of the file.

    Attributes
    ----------
    optional_force, optional_load, optional_temperature
        Horizontal and vertical force [N, compression positive], temperature of the contact [degC]; None where the file has no such column.
    """

    name: str
    time: FloatArray
    displacement: FloatArray
    optional_force: FloatArray | None
    optional_load: FloatArray | None
    optional_temperature: FloatArray | None
    digest: str

    @property
    def force(self) -> FloatArray:
        """Horizontal force [N]."""
        return self._needed(self.optional_force, "force [kN]")

    @property
    def load(self) -> FloatArray:
        """Vertical force [N]."""
        return self._needed(self.optional_load, "load [kN]")

    @property
    def cycle_times(self) -> FloatArray:
        """Times at which cycles begin and end [s]."""
        return cycle_bounds(self.time, self.displacement)

    @property
    def crossings(self) -> FloatArray:
        """Time [s], force [N] and load [N] wherever the displacement passes zero, shape (crossings, 3)."""
        return zero_crossings(self)

    @cached_property
    def cycles(self) -> tuple[Cycle, ...]:
        """Measures of each cycle."""
        return cycles_of(self)

    def _needed(self, values: FloatArray | None, head: str) -> FloatArray:
        if values is None:
            msg = f"{self.name}: the file has no column {head!r}, which is needed here."
            raise InputError(msg)
        return values

    def _repr_html_(self) -> str:
        return fields_card(self, f"Measured test {self.name}")


def read_measurement(path: str | Path) -> Measurement:
    """Read a measured test.

    Parameters
    ----------
    path
        CSV whose first line names the columns with their units: ``time [s]`` and ``displacement [mm]``, and where they were measured
        ``force [kN]``, ``load [kN]`` (vertical, compression positive) and ``temperature [degC]``. Other columns are left alone, lines that begin
        with ``#`` are notes; columns may be separated by commas, semicolons or tabs, the last two with decimal commas. A file that `dcfp test --out` wrote is one.

    Raises
    ------
    InputError
        If the file cannot be read, a number or a unit is missing, time does not increase or has a gap, the load turns into tension, or
        a quantity is so large or small that its unit must be wrong.
    """
    content, text = read_text(path)
    known, lines = read_columns(text, str(path), _COLUMNS, _NEEDED)
    measurement = Measurement(
        name=Path(path).stem,
        time=known["time"],
        displacement=known["displacement"],
        optional_force=known.get("force"),
        optional_load=known.get("load"),
        optional_temperature=known.get("temperature"),
        digest=hashlib.sha256(content).hexdigest(),
    )
    _check(measurement, lines, str(path))
    return measurement


def read_text(path: str | Path) -> tuple[bytes, str]:
    """Return what a file of measured columns holds, and the same as text."""
    content = read_bytes(Path(path), "a measured test is a CSV file")
    try:
        return content, content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        msg = f"{path}: this is not a text file; a measured test is a CSV file with a head such as 'time [s],displacement [mm]'."
        raise InputError(msg) from error


def names_of(text: str) -> set[str]:
    """Return the names in the head of measured columns, without their units."""
    return {_name(cell) for row in csv.reader([_head(text)], delimiter=_separator(text)) for cell in row}


def read_columns(
    text: str, where: str, columns: Columns, needed: Sequence[str]
) -> tuple[dict[str, FloatArray], list[int]]:
    """Return those of the `columns` that there are, in N, mm, s, degC, time from zero, and the number of the line of each sample."""
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
        msg = f"{where}: the file is empty; its first line must name the columns, such as 'time [s],displacement [mm],load [kN]'."
        raise InputError(msg)
    places = _places(rows[0][1], where, columns, needed)
    if len(rows) - 1 < _FEWEST_SAMPLES:
        msg = f"{where}: there are {len(rows) - 1} samples; at least {_FEWEST_SAMPLES} are needed."
        raise InputError(msg)
    values = {
        name: np.array([_number(row, place, name, number, where, separator) for number, row in rows[1:]])
        * factor
        for name, (place, factor) in places.items()
    }
    values["time"] = values["time"] - values["time"][0]
    known = {name: freeze(one) for name, one in values.items()}
    return known, [number for number, _ in rows[1:]]


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
        if found is None:
            msg = f"{where}: the column {name!r} has no unit; write it in brackets, such as '{name} [{next(iter(units))}]'."
            raise InputError(msg)
        if found["unit"] not in units:
            msg = f"{where}: the unit {found['unit'][:_LONGEST_WORD]!r} of the column {name!r} is not known; the choices are {', '.join(units)}."
            raise InputError(msg)
        if name in places:
            msg = f"{where}: there are two columns {name!r}; leave one."
            raise InputError(msg)
        places[name] = (place, units[found["unit"]].size)
    for name in needed:
        if name not in places:
            unit = next(iter(columns[name]))
            msg = f"{where}: the first line names no column '{name} [{unit}]'; it must name the columns with their units."
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


def _refuse(found: bool, where: str, words: str, line: int | None = None) -> None:
    if found:
        msg = f"{where if line is None else f'{where}, line {line}'}: {words}"
        raise InputError(msg)


def check_motion(time: FloatArray, position: NDArray[Any], lines: list[int], where: str) -> None:
    """Refuse a displacement, or a path x + i y, that cannot have been measured so; `lines` are the numbers of the lines of the samples.

    Raises
    ------
    InputError
        If time does not increase or has a gap, or displacement or velocity is so large or small that a unit must be wrong.
    """
    steps = np.diff(time)
    i = int(np.argmax(steps <= 0.0))
    back = f"time goes from {time[i]:.6g} to {time[i + 1]:.6g} s after the start; it must increase from line to line."
    _refuse(bool(steps[i] <= 0.0), where, back, lines[i + 1])
    usual = float(np.median(steps))
    i = int(np.argmax(steps > _GAP * usual))
    gap = f"a gap of {steps[i]:.4g} s where samples are {usual:.4g} s apart; fill it, or cut the file there."
    _refuse(bool(steps[i] > _GAP * usual), where, gap, lines[i + 1])
    for values, (least, most), name, unit, look in (
        (position, _DISPLACEMENTS, "displacement", "mm", "its unit"),
        (np.diff(position) / steps, _VELOCITIES, "velocity", "mm/s", "the units of time and displacement"),
    ):
        largest = float(np.abs(values).max())
        size = f"the largest {name} is {largest:.4g} {unit}, and from {least:g} to {most:g} {unit} is possible; look at {look}."
        _refuse(not least <= largest <= most, where, size)


def check_no_tension(load: FloatArray | None, lines: list[int], where: str) -> None:
    """Refuse a vertical force [N] that ever pulls."""
    if load is not None:
        i = int(np.argmax(load <= 0.0))
        tension = f"the load is {load[i] / 1e3:.4g} kN; a sliding bearing takes no tension, and compression must be positive."
        _refuse(bool(load[i] <= 0.0), where, tension, lines[i])


def _check(measurement: Measurement, lines: list[int], where: str) -> None:
    """Refuse what cannot have been measured so; `lines` are the numbers of the lines of the samples."""
    displacement, load, force = (
        measurement.displacement,
        measurement.optional_load,
        measurement.optional_force,
    )
    check_motion(measurement.time, displacement, lines, where)
    check_no_tension(load, lines, where)
    if load is not None and force is not None:
        ratio = float(np.abs(force).max() / load.mean())
        far = f"the largest force is {ratio:.3g} times the load; look at the units of both."
        _refuse(not _FORCE_RATIOS[0] <= ratio <= _FORCE_RATIOS[1], where, far)
    if force is not None:
        work = float((0.5 * (force[1:] + force[:-1])) @ np.diff(displacement))
        least_work = -_BACKWARD_WORK * float(np.abs(force).max() * np.abs(displacement).max())
        drives = "the force does negative work, so the bearing would drive the machine; change the sign of the force or the displacement."
        _refuse(work < least_work, where, drives)

"""A measured test: histories from a CSV file whose head names each column and its unit."""

import csv
import hashlib
import io
import math
import re
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import numpy as np

from dcfp.analysis.rig.measures import Cycle, measured_cycles, zero_crossings
from dcfp.analysis.rig.waveform import cycle_bounds
from dcfp.arrays import FloatArray, freeze
from dcfp.errors import InputError
from dcfp.schema.notebook import fields_card
from dcfp.schema.reading import read_bytes
from dcfp.schema.units import DEGC, NEWTON

#: Units of each column: what the value is multiplied by to be in N, mm, s, degC.
_LENGTHS = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4}
_FORCES = {"N": 1.0, "kN": 1e3, "MN": 1e6, "kip": 4448.2216152605}
_TIMES = {"s": 1.0, "ms": 1e-3}
_UNITS = {
    "time": _TIMES,
    "displacement": _LENGTHS,
    "force": _FORCES,
    "load": _FORCES,
    "temperature": {"degC": 1.0, "°C": 1.0, "C": 1.0},
}
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
    """Histories that were measured.

    Attributes
    ----------
    name
        Of the file, without its extension.
    time
        Increasing, from zero [s], shape (n,).
    displacement
        [mm].
    optional_force, optional_load, optional_temperature
        Horizontal and vertical force [N, compression positive], temperature of the contact [degC]; None where the file has no such column.
    digest
        SHA-256 of the file.
    """

    name: str
    time: FloatArray
    displacement: FloatArray
    optional_force: FloatArray | None = field(metadata={"unit": NEWTON})
    optional_load: FloatArray | None = field(metadata={"unit": NEWTON})
    optional_temperature: FloatArray | None = field(metadata={"unit": DEGC})
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
        return measured_cycles(self)

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
    place = Path(path)
    content = read_bytes(place, "a measured test is a CSV file")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        msg = f"{path}: this is not a text file; a measured test is a CSV file with a head such as 'time [s],displacement [mm]'."
        raise InputError(msg) from error
    columns, lines = _columns(text, str(path))
    measurement = Measurement(
        name=place.stem,
        time=freeze(columns["time"]),
        displacement=freeze(columns["displacement"]),
        optional_force=freeze(columns["force"]) if "force" in columns else None,
        optional_load=freeze(columns["load"]) if "load" in columns else None,
        optional_temperature=freeze(columns["temperature"]) if "temperature" in columns else None,
        digest=hashlib.sha256(content).hexdigest(),
    )
    _check(measurement, lines, str(path))
    return measurement


def _columns(text: str, where: str) -> tuple[dict[str, FloatArray], list[int]]:
    """Return the columns in N, mm, s, degC, time from zero, and the number of the line of each sample."""
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
    places = _places(rows[0][1], where)
    if len(rows) - 1 < _FEWEST_SAMPLES:
        msg = f"{where}: there are {len(rows) - 1} samples; at least {_FEWEST_SAMPLES} are needed."
        raise InputError(msg)
    values = {
        name: np.array([_number(row, place, name, number, where, separator) for number, row in rows[1:]])
        * factor
        for name, (place, factor) in places.items()
    }
    values["time"] = values["time"] - values["time"][0]
    return values, [number for number, _ in rows[1:]]


def _separator(text: str) -> str:
    """Return what stands between the columns of the head: a comma, a semicolon or a tab."""
    lines = (line for line in text.splitlines() if line.strip() and not line.lstrip().startswith(_NOTES))
    head = next(lines, "")
    return max(",;\t", key=head.count)


def _places(head: list[str], where: str) -> dict[str, tuple[int, float]]:
    """Return for each known column its place and the factor of its unit."""
    places: dict[str, tuple[int, float]] = {}
    for place, cell in enumerate(head):
        found = _HEAD.fullmatch(cell)
        name = (found["name"] if found else cell.strip()).lower()
        if name not in _UNITS:
            continue
        units = _UNITS[name]
        if found is None:
            msg = f"{where}: the column {name!r} has no unit; write it in brackets, such as '{name} [{next(iter(units))}]'."
            raise InputError(msg)
        if found["unit"] not in units:
            msg = f"{where}: the unit {found['unit'][:_LONGEST_WORD]!r} of the column {name!r} is not known; the choices are {', '.join(units)}."
            raise InputError(msg)
        if name in places:
            msg = f"{where}: there are two columns {name!r}; leave one."
            raise InputError(msg)
        places[name] = (place, units[found["unit"]])
    for name in ("time", "displacement"):
        if name not in places:
            unit = next(iter(_UNITS[name]))
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


def _check(measurement: Measurement, lines: list[int], where: str) -> None:
    time, displacement = measurement.time, measurement.displacement
    steps = np.diff(time)
    if (steps <= 0.0).any():
        i = int(np.argmax(steps <= 0.0))
        msg = f"{where}, line {lines[i + 1]}: time goes from {time[i]:.6g} to {time[i + 1]:.6g} s after the start; it must increase from line to line."
        raise InputError(msg)
    usual = float(np.median(steps))
    if steps.max() > _GAP * usual:
        i = int(np.argmax(steps > _GAP * usual))
        msg = f"{where}, line {lines[i + 1]}: a gap of {steps[i]:.4g} s where samples are {usual:.4g} s apart; fill it, or cut the file there."
        raise InputError(msg)
    _check_size(np.abs(displacement), _DISPLACEMENTS, "displacement", "mm", where)
    _check_size(
        np.abs(np.diff(displacement)) / steps,
        _VELOCITIES,
        "velocity",
        "mm/s",
        where,
        "the units of time and displacement",
    )
    load, force = measurement.optional_load, measurement.optional_force
    if load is not None and load.min() <= 0.0:
        i = int(np.argmax(load <= 0.0))
        msg = f"{where}, line {lines[i]}: the load is {load[i] / 1e3:.4g} kN; a sliding bearing takes no tension, and compression must be positive."
        raise InputError(msg)
    if load is not None and force is not None:
        ratio = float(np.abs(force).max() / load.mean())
        if not _FORCE_RATIOS[0] <= ratio <= _FORCE_RATIOS[1]:
            msg = f"{where}: the largest force is {ratio:.3g} times the load; look at the units of both."
            raise InputError(msg)
    if force is not None:
        work = float((0.5 * (force[1:] + force[:-1])) @ np.diff(displacement))
        if work < -_BACKWARD_WORK * float(np.abs(force).max() * np.abs(displacement).max()):
            msg = f"{where}: the force does negative work, so the bearing would drive the machine; change the sign of the force or the displacement."
            raise InputError(msg)


def _check_size(
    values: FloatArray, limits: tuple[float, float], name: str, unit: str, where: str, look: str = ""
) -> None:
    largest = float(values.max())
    if not limits[0] <= largest <= limits[1]:
        msg = (
            f"{where}: the largest {name} is {largest:.4g} {unit}, and from {limits[0]:g} to {limits[1]:g} {unit} is possible; look at"
            f" {look or 'its unit'}."
        )
        raise InputError(msg)

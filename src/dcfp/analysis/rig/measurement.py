"""A measured test: histories from a CSV file whose head names each column and its unit."""

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from dcfp.analysis.rig.measures import Cycle, cycles_of, zero_crossings
from dcfp.analysis.rig.waveform import cycle_bounds
from dcfp.arrays import FloatArray, freeze
from dcfp.errors import InputError
from dcfp.schema.columns import LENGTHS, TIMES, Columns, named, read_columns
from dcfp.schema.notebook import fields_card
from dcfp.schema.reading import read_bytes
from dcfp.schema.units import DEGC, KIP, KN, MEGANEWTON, NEWTON

#: Units of forces, by their names.
FORCES = named(NEWTON, KN, MEGANEWTON, KIP)
_COLUMNS: Columns = {
    "time": TIMES,
    "displacement": LENGTHS,
    "force": FORCES,
    "load": FORCES,
    "temperature": named(DEGC, replace(DEGC, typed="C")),
}
_NEEDED = ("time", "displacement")
#: A step so much longer than the usual one is a gap.
_GAP = 10.0
_FEWEST_SAMPLES = 20
#: Part of the largest force times the largest displacement that the work may fall below zero by rounding and noise [-].
_BACKWARD_WORK = 0.1
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
    known, lines = read_histories(text, str(path), _COLUMNS, _NEEDED)
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


def read_histories(
    text: str, where: str, columns: Columns, needed: Sequence[str]
) -> tuple[dict[str, FloatArray], list[int]]:
    """Return measured columns in N, mm, s, degC, time from zero, and the number of the line of each sample."""
    example = "time [s],displacement [mm],load [kN]"
    values, lines = read_columns(text, where, columns, needed, _FEWEST_SAMPLES, "samples", example)
    values["time"] = values["time"] - values["time"][0]
    return {name: freeze(one) for name, one in values.items()}, lines


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

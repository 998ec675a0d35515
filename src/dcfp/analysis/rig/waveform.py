"""What the test machine does: displacement over time as cubic pieces, and where its cycles begin and end."""

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import Annotated, Any, ClassVar, TypeAlias

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicHermiteSpline, PchipInterpolator

from dcfp.analysis.rig.measures import CROSSING
from dcfp.arrays import FloatArray, equally_spaced
from dcfp.errors import InputError
from dcfp.schema.declared import Declared, declared
from dcfp.schema.parameters import Parameter
from dcfp.schema.units import MM, MM_PER_S, NONE

#: Pieces in a cycle of a generated motion; the cubic is then within 2e-10 of the amplitude of a sine.
PIECES_PER_CYCLE = 400
#: Part of a piece that is not cut off [-].
_SLIVER = 0.05
#: Range of a cycle over that of the largest from which on it is not one of a ramp [-].
_FULL_CYCLE = 0.9

#: How a sine can start.
STARTS = ("speed", "peak", "ramp")


@dataclass(frozen=True)
class Travel:
    """A displacement as cubic pieces.

    Attributes
    ----------
    lengths, pieces
        How long each piece lasts [s], shape (n,), and coefficients of 1, t, t2 and t3 in it [mm, mm/s, ...], shape (n, 4); of a path in the plane complex, x + i y.
    cycles
        Times at which cycles begin and end [s], shape (cycles + 1,).
    """

    lengths: FloatArray
    pieces: NDArray[Any]
    cycles: FloatArray

    @property
    def time(self) -> FloatArray:
        """Times at the ends of the pieces [s], shape (n + 1,)."""
        return np.concatenate(([0.0], np.cumsum(self.lengths)))

    def cut_at(self, times: FloatArray) -> "Travel":
        """Return the same displacement with pieces that also end at `times` [s]."""
        ends = self.time
        inside = times[(times > 0.0) & (times < ends[-1])]
        piece = np.searchsorted(ends, inside, side="right") - 1
        apart = (inside - ends[piece] > _SLIVER * self.lengths[piece]) & (
            ends[piece + 1] - inside > _SLIVER * self.lengths[piece]
        )
        start = np.sort(np.concatenate((ends[:-1], inside[apart])))
        origin = np.searchsorted(ends, start, side="right") - 1
        moved = _moved(self.pieces[origin], start - ends[origin])
        lengths = np.diff(np.append(start, ends[-1]))
        # to the last digit, for the kernels prepare a length once
        whole = np.bincount(origin)[origin] == 1
        lengths[whole] = self.lengths[origin[whole]]
        return Travel(lengths, moved, self.cycles)

    @property
    def largest(self) -> float:
        """Largest displacement, to either side, at the ends of pieces [mm]."""
        last = self.pieces[-1] @ self.lengths[-1] ** np.arange(4.0)
        return float(max(np.abs(self.pieces[:, 0]).max(), abs(last)))


@declared
class Wave(Declared):
    """Cycles that are alike: what a sine and a triangle have in common."""

    kind: ClassVar[str]
    #: Travel over the period times the largest velocity.
    way: ClassVar[float]

    amplitude: Annotated[float, Parameter("amplitude of the displacement", MM, 0.0, above=True)]
    peak_velocity: Annotated[float, Parameter("largest velocity", MM_PER_S, 0.0, above=True)]
    cycles: Annotated[float, Parameter("number of full cycles that count", NONE, 1.0, 10_000.0)]

    def check_relations(self) -> None:
        """Refuse parts of a cycle other than quarters."""
        check_quarters(self.cycles)

    @property
    def period(self) -> float:
        """Period [s]."""
        return self.way * self.amplitude / self.peak_velocity

    def bounds(self, first: float) -> FloatArray:
        """Return the times [s] at which full cycles begin and end, from the `first` on."""
        return first + self.period * np.arange(math.floor(self.cycles + 1e-9) + 1, dtype=np.float64)


@declared
class Sine(Wave):
    """A sine wave.

    Parameters
    ----------
    peak_velocity
        Largest velocity [mm/s]; the period is 2 pi amplitude / peak_velocity.
    start
        ``"speed"``: from zero displacement at full velocity, as if the machine had been moving; ``"peak"``: from rest at the
        amplitude; ``"ramp"``: from rest at zero, with cycles that grow before those that count and shrink after them.
    ramp_cycles
        Number of cycles in which the amplitude grows, and in which it shrinks, for a start by ramp.
    """

    noun = "a sine"
    kind: ClassVar[str] = "sine"
    way: ClassVar[float] = 2.0 * math.pi

    start: Annotated[str, Parameter("how the test starts", choices=STARTS)] = "speed"
    ramp_cycles: Annotated[
        float, Parameter("number of cycles of a ramp", NONE, 0.0, 10_000.0, above=True)
    ] = 1.0

    def check_relations(self) -> None:
        """Refuse parts of a cycle other than quarters."""
        super().check_relations()
        check_quarters(self.ramp_cycles)

    def travel(self) -> Travel:
        """Return the displacement."""
        ramp = self.ramp_cycles if self.start == "ramp" else 0.0
        turns = self.cycles + 2.0 * ramp
        count = max(8, math.ceil(turns * PIECES_PER_CYCLE))
        phase = 2.0 * math.pi * turns * np.arange(count + 1) / count
        if self.start == "peak":
            displacement, slope = np.cos(phase), -np.sin(phase)
        elif ramp > 0.0:
            own, (envelope, change) = phase - 2.0 * math.pi * ramp, ramped(phase, 2.0 * math.pi * ramp)
            displacement, slope = envelope * np.sin(own), envelope * np.cos(own) + change * np.sin(own)
        else:
            displacement, slope = np.sin(phase), np.cos(phase)
        step = self.period * turns / count
        spline = CubicHermiteSpline(
            step * np.arange(count + 1), self.amplitude * displacement, self.peak_velocity * slope
        )
        return Travel(np.full(count, step), rows_of(spline.c), self.bounds(self.period * ramp))


def ramped(phase: FloatArray, ramp: float) -> tuple[FloatArray, FloatArray]:
    """Return how an amplitude grows over a `ramp` and shrinks over the last one, and the derivative of that, over the phase [rad]."""
    last = float(phase[-1])
    rise = np.clip(np.minimum(phase, last - phase) / ramp, 0.0, 1.0)
    envelope = rise * rise * (3.0 - 2.0 * rise)
    return envelope, 6.0 * rise * (1.0 - rise) / ramp * np.where(phase < 0.5 * last, 1.0, -1.0)


@declared
class Triangle(Wave):
    """A displacement at constant speed to and fro, from zero; parameters as of a `Wave`."""

    noun = "a triangle"
    kind: ClassVar[str] = "triangle"
    way: ClassVar[float] = 4.0

    def travel(self) -> Travel:
        """Return the displacement."""
        quarters = round(4.0 * self.cycles)
        per_quarter = PIECES_PER_CYCLE // 4
        quarter = np.arange(quarters + 1)
        corners = self.amplitude * np.where(quarter % 2 == 0, 0.0, np.where(quarter % 4 == 1, 1.0, -1.0))
        displacement = np.interp(np.arange(quarters * per_quarter + 1) / per_quarter, quarter, corners)
        step = self.period / PIECES_PER_CYCLE
        pieces = np.zeros((displacement.size - 1, 4))
        pieces[:, 0] = displacement[:-1]
        pieces[:, 1] = np.diff(displacement) / step
        return Travel(np.full(displacement.size - 1, step), pieces, self.bounds(0.0))


@dataclass(frozen=True, eq=False)
class Recorded:
    """A measured displacement [mm] at increasing times [s], shape (n,); between samples it goes one way only, without overshoot."""

    time: FloatArray
    displacement: FloatArray
    kind: ClassVar[str] = "recorded"

    def __post_init__(self) -> None:
        check_samples(self.time, self.displacement, "displacement", "displacements")

    @property
    def peak_velocity(self) -> float:
        """Largest mean velocity between two samples [mm/s]."""
        return largest_velocity(self.time, self.displacement)

    @property
    def period(self) -> float:
        """Mean length of the cycles found [s]; of the whole motion where there is none."""
        bounds = self.travel().cycles
        return float((bounds[-1] - bounds[0]) / max(bounds.size - 1, 1)) or float(self.time[-1])

    def travel(self) -> Travel:
        """Return the displacement."""
        time = self.time - self.time[0]
        pieces = rows_of(PchipInterpolator(time, self.displacement).c)
        return Travel(lengths_between(time), pieces, cycle_bounds(time, self.displacement))


def check_samples(time: FloatArray, values: NDArray[Any], noun: str, plural: str) -> None:
    """Refuse what is no recorded motion: too few samples, what is not finite, times that do not increase."""
    if time.size < 4 or time.shape != values.shape:
        msg = f"A recorded {noun} needs at least four samples, and as many times as {plural}, not {time.size} and {values.size}."
        raise InputError(msg)
    if not (np.isfinite(time).all() and np.isfinite(values).all()):
        msg = f"A recorded {noun} must consist of finite numbers."
        raise InputError(msg)
    if not (np.diff(time) > 0.0).all():
        msg = f"The times of a recorded {noun} must increase from sample to sample."
        raise InputError(msg)


def largest_velocity(time: FloatArray, values: NDArray[Any]) -> float:
    """Return the largest mean velocity between two samples [mm/s]."""
    return float(np.abs(np.diff(values) / np.diff(time)).max())


def lengths_between(time: FloatArray) -> FloatArray:
    """Return the intervals between times from zero on [s], to the last digit the same where they are equal."""
    lengths = np.diff(time)
    return np.full(lengths.size, float(time[-1]) / lengths.size) if equally_spaced(time) else lengths


Waveform: TypeAlias = Sine | Triangle | Recorded


def cycle_bounds(time: FloatArray, displacement: FloatArray) -> FloatArray:
    """Return the times [s] at which the displacement passes zero upwards, with the start if it begins there.

    Only passages between a tenth of the largest displacement on either side count, so that noise around zero makes no cycle. A motion that has no full cycle is one.
    """
    far = CROSSING * float(np.abs(displacement).max())
    bounds: list[float] = []
    below = abs(displacement[0]) <= far
    last_zero = float(time[0])
    for i in range(displacement.size - 1):
        y, following = float(displacement[i]), float(displacement[i + 1])
        if y <= 0.0 < following:
            last_zero = float(time[i] - y * (time[i + 1] - time[i]) / (following - y))
        if following < -far:
            below = True
        elif following > far and below:
            bounds.append(last_zero)
            below = False
    tail = displacement[time > bounds[-1]] if bounds else displacement
    if bounds and tail.min() < -far and abs(displacement[-1]) <= far:
        bounds.append(float(time[-1]))  # the last cycle ends where the motion does
    if len(bounds) < 2:
        bounds = [float(time[0]), float(time[-1])]
    return _without_ramps(np.array(bounds), time, displacement)


def _without_ramps(bounds: FloatArray, time: FloatArray, displacement: FloatArray) -> FloatArray:
    """Leave out smaller cycles at both ends, if all between them are alike: they are ramps, or the start and stop of the machine."""
    ranges = np.array(
        [np.ptp(displacement[(time >= first) & (time <= last)]) for first, last in pairwise(bounds.tolist())]
    )
    full = np.flatnonzero(ranges >= _FULL_CYCLE * ranges.max())
    first, last = int(full[0]), int(full[-1])
    return bounds[first : last + 2] if full.size == last - first + 1 else bounds


def _moved(pieces: NDArray[Any], t: FloatArray) -> NDArray[Any]:
    """Return cubic pieces that begin later by `t` [s]."""
    c0, c1, c2, c3 = pieces.T
    value, slope = c0 + t * (c1 + t * (c2 + t * c3)), c1 + t * (2.0 * c2 + t * 3.0 * c3)
    return np.column_stack((value, slope, c2 + 3.0 * t * c3, c3))


def rows_of(coefficients: NDArray[Any]) -> NDArray[Any]:
    """Return SciPy's coefficients, highest order first, as rows of pieces, lowest order first."""
    return np.ascontiguousarray(coefficients[::-1].T)


def check_quarters(cycles: float) -> None:
    """Refuse parts of a cycle other than quarters."""
    if abs(4.0 * cycles - round(4.0 * cycles)) > 1e-9:
        msg = f"The number of cycles must be one of whole quarters, not {cycles!r}."
        raise InputError(msg)

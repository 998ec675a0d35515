r"""What the test machine does in two directions: paths in the plane, as complex numbers x + i y.

A path of a shape z(s) is gone along once while the phase s goes through a full turn. A new shape is a class here with its `shape`, in `PATHS` by its name.
"""

import math
from abc import abstractmethod
from dataclasses import dataclass, field
from typing import Annotated, Any, ClassVar, TypeAlias

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import Akima1DInterpolator, CubicHermiteSpline

from dcfp.analysis.rig.waveform import (
    PIECES_PER_CYCLE,
    Travel,
    Wave,
    check_quarters,
    check_samples,
    largest_velocity,
    lengths_between,
    ramped,
    rows_of,
)
from dcfp.arrays import FloatArray
from dcfp.schema.declared import declared
from dcfp.schema.parameters import Parameter
from dcfp.schema.registry import Registry
from dcfp.schema.units import MM, NONE

#: Positions or velocities in the plane, x + i y.
ComplexArray: TypeAlias = NDArray[np.complexfloating[Any, Any]]

#: How a path can start.
PATH_STARTS = ("speed", "ramp", "radius")
#: Pieces of a way out along the radius, and its largest over its mean velocity.
_LEG_PIECES, _LEG_PEAK = 100, 1.5
#: How much further than one turn the angle of a path that goes around may go to and fro in it [-].
_AROUND = 1.2


@declared
class PlanePath(Wave):
    """A closed path that is gone along at an even pace of its phase; a cycle is a lap.

    Parameters
    ----------
    peak_velocity
        Largest velocity [mm/s], along the path.
    start
        ``"speed"``: at full velocity from where the path begins, as if the machine had been moving; ``"ramp"``: from rest in the middle, with laps that grow before those that
        count and shrink after them; ``"radius"``: from rest in the middle straight out to the path, then along it from rest, with a pace that grows before the laps that count, and
        all that backwards after them.
    ramp_cycles
        Number of laps in which the amplitude or the pace grows, and in which it shrinks.
    """

    noun = "a path"
    #: The highest multiple of the pace in its shape.
    highest: ClassVar[int] = 1

    start: Annotated[str, Parameter("how the test starts", choices=PATH_STARTS)] = "speed"
    ramp_cycles: Annotated[float, Parameter("number of laps of a ramp", NONE, 0.0, 10_000.0, above=True)] = (
        1.0
    )

    def check_relations(self) -> None:
        """Refuse parts of a lap other than quarters."""
        super().check_relations()
        check_quarters(self.ramp_cycles)

    @abstractmethod
    def shape(self, phase: FloatArray) -> tuple[ComplexArray, ComplexArray]:
        """Return the positions at phases [rad], and their derivatives by the phase [mm]."""

    @property
    @abstractmethod
    def fastest(self) -> float:
        """Largest size of the derivative by the phase [mm]."""

    @property
    def period(self) -> float:
        """Time of a lap at full pace [s]."""
        return 2.0 * math.pi * self.fastest / self.peak_velocity

    def travel(self) -> Travel:
        """Return the path."""
        pace = 2.0 * math.pi / self.period
        ramp = 0.0 if self.start == "speed" else 2.0 * math.pi * self.ramp_cycles
        last = 2.0 * math.pi * self.cycles + 2.0 * ramp
        count = max(8, math.ceil(last / (2.0 * math.pi) * PIECES_PER_CYCLE * self.highest))
        tau = last * np.arange(count + 1) / count
        if self.start == "radius":
            position, velocity = self._paced(tau, ramp, last)
        else:
            position, velocity = self.shape(tau - ramp)
        if self.start == "ramp":
            envelope, change = ramped(tau, ramp)
            position, velocity = envelope * position, envelope * velocity + change * position
        time, velocity = tau / pace, velocity * pace
        lengths = np.full(count, last / pace / count)
        lead = 0.0
        if self.start == "radius" and abs(position[0]) > 1e-9 * self.amplitude:
            # the ends of laps of whole quarters may differ
            out, back = self._leg(complex(position[0])), self._leg(complex(position[-1]))
            lead = float(out[0][-1])
            steps = np.diff(out[0]), lengths, np.diff(back[0])
            lengths = np.concatenate(steps)
            time = np.concatenate((out[0][:-1], lead + time, lead + time[-1] + back[0][1:]))
            position = np.concatenate((out[1][:-1], position, back[1][-2::-1]))
            velocity = np.concatenate((out[2][:-1], velocity, -back[2][-2::-1]))
        return Travel(lengths, pieces_of(time, position, velocity), self.bounds(lead + ramp / pace))

    def _paced(self, tau: FloatArray, ramp: float, last: float) -> tuple[ComplexArray, ComplexArray]:
        """Return positions and velocities with a pace that grows over a `ramp` and shrinks over the last one."""
        pace, _ = ramped(tau, ramp)
        x, rest = np.minimum(tau / ramp, 1.0), np.minimum((last - tau) / ramp, 1.0)
        # the integral of the pace less its value where the first lap that counts begins
        phase = tau - ramp + ramp * (x**3 - 0.5 * x**4 - x + 0.5) - ramp * (rest**3 - 0.5 * rest**4 - rest + 0.5)  # fmt: skip
        position, slope = self.shape(phase)
        return position, slope * pace

    def _leg(self, end: complex) -> tuple[FloatArray, ComplexArray, ComplexArray]:
        """Return times, positions and velocities from the middle straight out, from rest to rest."""
        length = _LEG_PEAK * abs(end) / self.peak_velocity
        x = np.arange(_LEG_PIECES + 1) / _LEG_PIECES
        out, pace = x * x * (3.0 - 2.0 * x), 6.0 / length * x * (1.0 - x)
        return length * x, end.real * out + 1j * end.imag * out, end.real * pace + 1j * end.imag * pace


@declared
class Circle(PlanePath):
    """A circle about the middle, from the positive x axis towards the positive y axis; the amplitude is its radius."""

    noun = "a circle"
    kind: ClassVar[str] = "circle"

    @property
    def fastest(self) -> float:
        """Largest size of the derivative by the phase [mm]."""
        return self.amplitude

    def shape(self, phase: FloatArray) -> tuple[ComplexArray, ComplexArray]:
        """Return the positions at phases [rad], and their derivatives by the phase [mm]."""
        around = self.amplitude * np.exp(1j * phase) * (1.0 + 0j)
        return around, 1j * around


@declared
class Ellipse(PlanePath):
    """An ellipse about the middle, x = A cos s, y = B sin s; with a second amplitude B of zero the straight line along x."""

    noun = "an ellipse"
    kind: ClassVar[str] = "ellipse"

    second_amplitude: Annotated[
        float, Parameter("amplitude of the displacement in direction y", MM, 0.0)
    ] = field(kw_only=True)  # fmt: skip

    @property
    def fastest(self) -> float:
        """Largest size of the derivative by the phase [mm]."""
        return max(self.amplitude, self.second_amplitude)

    def shape(self, phase: FloatArray) -> tuple[ComplexArray, ComplexArray]:
        """Return the positions at phases [rad], and their derivatives by the phase [mm]."""
        a, b = self.amplitude, self.second_amplitude
        return (
            a * np.cos(phase) + 1j * b * np.sin(phase),
            -a * np.sin(phase) + 1j * b * np.cos(phase),
        )


@declared
class FigureOfEight(PlanePath):
    """A figure of eight that lies along x: x = A sin s, y = B sin 2s; by default B is half of A."""

    noun = "a figure of eight"
    kind: ClassVar[str] = "eight"
    highest: ClassVar[int] = 2

    second_amplitude: Annotated[
        float | None,
        Parameter("amplitude of the displacement in direction y", MM, 0.0, more="default half of the first"),
    ] = None  # fmt: skip

    @property
    def width(self) -> float:
        """Amplitude in direction y [mm]."""
        return 0.5 * self.amplitude if self.second_amplitude is None else self.second_amplitude

    @property
    def fastest(self) -> float:
        """Largest size of the derivative by the phase [mm], in the middle."""
        return math.hypot(self.amplitude, 2.0 * self.width)

    def shape(self, phase: FloatArray) -> tuple[ComplexArray, ComplexArray]:
        """Return the positions at phases [rad], and their derivatives by the phase [mm]."""
        a, b = self.amplitude, self.width
        return (
            a * np.sin(phase) + 1j * b * np.sin(2.0 * phase),
            a * np.cos(phase) + 2j * b * np.cos(2.0 * phase),
        )


@declared
class Cloverleaf(PlanePath):
    """A clover of four leaves, the rose r = A sin 2s at the angle s; it passes the middle four times in a lap."""

    noun = "a cloverleaf"
    kind: ClassVar[str] = "cloverleaf"
    highest: ClassVar[int] = 3

    @property
    def fastest(self) -> float:
        """Largest size of the derivative by the phase [mm], in the middle."""
        return 2.0 * self.amplitude

    def shape(self, phase: FloatArray) -> tuple[ComplexArray, ComplexArray]:
        """Return the positions at phases [rad], and their derivatives by the phase [mm]."""
        around, fold = np.exp(1j * phase) * self.amplitude, np.exp(2j * phase)
        sine = 0.5j * (fold.conj() - fold)
        return around * sine, around * (fold.conj() + fold + 1j * sine)


@dataclass(frozen=True, eq=False)
class RecordedPath:
    """A measured path: positions x + i y [mm] at increasing times [s], shape (n,), smooth between samples (Akima 1970, modified)."""

    time: FloatArray
    position: ComplexArray
    kind: ClassVar[str] = "recorded path"

    def __post_init__(self) -> None:
        check_samples(self.time, self.position, "path", "positions")

    @property
    def peak_velocity(self) -> float:
        """Largest mean velocity between two samples [mm/s]."""
        return largest_velocity(self.time, self.position)

    @property
    def period(self) -> float:
        """Mean time of the laps found [s]; of the whole path where there is none."""
        bounds = lap_bounds(self.time - self.time[0], self.position)
        return float((bounds[-1] - bounds[0]) / (bounds.size - 1))

    def travel(self) -> Travel:
        """Return the path."""
        time = self.time - self.time[0]
        x, y = (
            rows_of(Akima1DInterpolator(time, one, method="makima").c)
            for one in (self.position.real, self.position.imag)
        )
        return Travel(lengths_between(time), x + 1j * y, lap_bounds(time, self.position))


def lap_bounds(time: FloatArray, position: ComplexArray) -> FloatArray:
    """Return the times [s] at which a path has gone around its middle once more, counted from its start; one that goes another way is one lap."""
    whole = np.array([time[0], time[-1]])
    about = position - 0.5 * (
        complex(position.real.max(), position.imag.max()) + complex(position.real.min(), position.imag.min())
    )
    if not np.abs(about).min() > 0.0:
        return whole
    angle = np.unwrap(np.angle(about)) / (2.0 * math.pi)
    angle = np.abs(angle - angle[0])
    turns = math.floor(float(angle[-1]) + 1e-3)
    if turns < 1 or np.abs(np.diff(angle)).sum() > _AROUND * angle[-1]:
        return whole
    rising = np.maximum.accumulate(angle)
    return np.interp(np.minimum(np.arange(turns + 1.0), rising[-1]), rising, time)


def pieces_of(time: FloatArray, position: ComplexArray, velocity: ComplexArray) -> NDArray[Any]:
    """Return the cubic pieces through positions with these velocities, as rows of `Travel`."""
    return rows_of(CubicHermiteSpline(time, position, velocity).c)


#: Paths of a formula, by name.
PATHS: Registry[type[PlanePath]] = Registry("path in the plane")
for _path in (Circle, Ellipse, FigureOfEight, Cloverleaf):
    PATHS.add(_path.kind, _path)

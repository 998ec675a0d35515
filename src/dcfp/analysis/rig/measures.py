"""What is measured on each cycle of a test."""

import itertools
import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

import numpy as np

from dcfp.arrays import FloatArray, IntArray
from dcfp.schema.notebook import fields_card
from dcfp.schema.units import DEGC, MM, N_MM, N_PER_MM, NEWTON

if TYPE_CHECKING:
    from dcfp.analysis.rig.loops import Loops
    from dcfp.analysis.rig.measurement import Measurement

#: Displacement, relative to the amplitude, up to which a branch of a loop is fitted by a line [-].
_BRANCH = 0.5
#: Fewest samples of a branch to fit a line to.
_FEWEST = 5
#: Standard deviation of a steady load over its mean [-]; instruments scatter by some percent.
_STEADY = 0.05
#: Displacement, relative to the largest, that lies between two passages of zero [-].
CROSSING = 0.1
#: Part of a cycle within which a passage of zero is at its end [-].
_AT_END = 0.02
#: Parts of a cycle before and after an end in which a measured turn is looked for, and before it in which its force is [-].
_NEAR_END, _LEADING = 0.04, 0.02
#: Least travel in such a branch, relative to the amplitude [-].
_LEAST_STROKE = 1e-3


class ForceHistory(NamedTuple):
    """What cycles are measured on [s, mm, N], with the times at which they begin and end."""

    time: FloatArray
    displacement: FloatArray
    force: FloatArray
    load: FloatArray
    cycle_times: FloatArray


#: The same of a test of the virtual machine, or of a measured one.
History: TypeAlias = "ForceHistory | Loops | Measurement"


@dataclass(frozen=True)
class Cycle:
    """Measures of one cycle.

    Attributes
    ----------
    largest, least, force_at_largest, force_at_least
        Displacements at its ends, d+ and d- [mm], and forces there, F+ and F- [N].
    load
        Mean vertical force [N].
    energy
        Work of the machine over the cycle, the area of the loop [N mm].
    crossings
        Coefficients at zero displacement [-], |F| / N wherever the cycle passes zero: at its start, unless nothing has moved before,
        and in its middle. Its end belongs to the next cycle.
    strength
        Characteristic strength: mean size of the forces there [N]; NaN where it never passes zero.
    post_yield_stiffness
        Mean slope of the strokes between half of the amplitude to either side of the loop's middle [N/mm]; NaN where they are too short or
        the load changes.
    peak_temperature
        Highest temperature of the contact [degC]; NaN for a measured history.
    steady_load
        Whether the vertical force hardly changes; if it does, the pendulum takes part in the work and in the slopes.
    """

    number: int
    largest: float = field(metadata={"unit": MM})
    least: float = field(metadata={"unit": MM})
    force_at_largest: float = field(metadata={"unit": NEWTON})
    force_at_least: float = field(metadata={"unit": NEWTON})
    load: float = field(metadata={"unit": NEWTON})
    energy: float = field(metadata={"unit": N_MM})
    crossings: tuple[float, ...]
    strength: float = field(metadata={"unit": NEWTON})
    post_yield_stiffness: float = field(metadata={"unit": N_PER_MM})
    peak_temperature: float = field(metadata={"unit": DEGC})
    steady_load: bool = True

    @property
    def friction(self) -> float:
        """Return the mean coefficient at zero displacement [-]; NaN where the cycle never passes zero."""
        return float(np.mean(self.crossings)) if self.crossings else math.nan

    @property
    def loop_friction(self) -> float:
        """Return the mean coefficient over the cycle, E / (2 N (d+ - d-)) [-]: that of the Coulomb loop of the same area.

        NaN under a load that changes, where the area is not that of friction alone.
        """
        travel = self.largest - self.least
        return self.energy / (2.0 * self.load * travel) if travel > 0.0 and self.steady_load else math.nan

    @property
    def effective_stiffness(self) -> float:
        """Return k_eff = (|F+| + |F-|)/(|d+| + |d-|) [N/mm]: ASCE/SEI 7-16, Eq. (17.8-1)."""
        travel = abs(self.largest) + abs(self.least)
        forces = abs(self.force_at_largest) + abs(self.force_at_least)
        return forces / travel if travel > 0.0 else math.nan

    @property
    def effective_damping(self) -> float:
        """Return beta_eff = 2/pi E / (k_eff (|d+| + |d-|)^2) [-]: ASCE/SEI 7-16, Eq. (17.8-2)."""
        elastic = self.effective_stiffness * (abs(self.largest) + abs(self.least)) ** 2
        return 2.0 / math.pi * self.energy / elastic if elastic > 0.0 else math.nan

    def _repr_html_(self) -> str:
        return fields_card(self, f"Cycle {self.number}")


def cycles_of(
    history: History, work: FloatArray | None = None, temperature: FloatArray | None = None
) -> tuple[Cycle, ...]:
    """Return the measures of every cycle.

    Of a measured history neither `work` [N mm] nor `temperature` [degC] is known: the area is that of the polygon of its samples, and the forces at
    the ends are fitted to the samples before.
    """
    exact = work is not None
    if work is None:
        steps = 0.5 * (history.force[1:] + history.force[:-1]) * np.diff(history.displacement)
        work = np.concatenate(([0.0], np.cumsum(steps)))
    temperature = np.full(work.size, math.nan) if temperature is None else temperature
    time, bounds = history.time, history.cycle_times
    slack = 1e-9 * float(time[-1] - time[0])
    crossings = zero_crossings(history)
    cycles: list[Cycle] = []
    for number, (first, last) in enumerate(itertools.pairwise(bounds.tolist()), start=1):
        samples = np.flatnonzero((time >= first - slack) & (time <= last + slack))
        part = slice(int(samples[0]), int(samples[-1]) + 1)
        displacement, force = history.displacement[part], history.force[part]
        virgin = int(part.start == 0)  # the first sample of all has no friction force
        highest = virgin + int(displacement[virgin:].argmax())
        lowest = virgin + int(displacement[virgin:].argmin())
        # a passage at the end belongs to the next cycle, also where noise has moved it
        guard = _AT_END * (last - first)
        inside = (crossings[:, 0] >= first - guard) & (crossings[:, 0] < last - guard)
        load = history.load[part]
        steady = bool(load.std() <= _STEADY * load.mean())
        forces, loads = np.abs(crossings[inside, 1]), crossings[inside, 2]
        cycles.append(
            Cycle(
                number=number,
                largest=float(displacement[highest]),
                least=float(displacement[lowest]),
                force_at_largest=_force_at_end(time[part], displacement, force, highest, exact=exact),
                force_at_least=_force_at_end(time[part], displacement, force, lowest, exact=exact),
                load=float(load.mean()),
                energy=float(np.diff(np.interp(np.array([first, last]), time, work))[0]),
                crossings=tuple((forces / loads).tolist()),
                strength=float(forces.mean()) if forces.size else math.nan,
                post_yield_stiffness=_post_yield_stiffness(displacement, force, virgin)
                if steady
                else math.nan,
                peak_temperature=float(temperature[part].max()),
                steady_load=steady,
            )
        )
    return tuple(cycles)


def _force_at_end(
    time: FloatArray, displacement: FloatArray, force: FloatArray, end: int, *, exact: bool
) -> float:
    """Return the force [N] at the turn near the sample `end`.

    A single sample can lie on either side of the turn, where the force jumps. Unless it is `exact`, the turn is that of a parabola through the
    samples near the end, and the force that of a parabola through those that lead up to it.
    """
    cycle = float(time[-1] - time[0])
    near = np.flatnonzero(
        (np.abs(time - time[end]) < _NEAR_END * cycle) & (displacement * displacement[end] > 0.0)
    )
    if exact or near.size < _FEWEST:
        return float(force[end])
    shifted = time[near] - time[end]
    second, first, _ = _fitted(shifted, displacement[near], 2)
    turn = -0.5 * first / second if second * displacement[end] < 0.0 else 0.0
    turn = min(max(turn, float(shifted[0])), float(shifted[-1]))
    before = (shifted < turn) & (shifted > turn - _LEADING * cycle)
    if before.sum() < _FEWEST:
        return float(force[end])
    # the coefficient falls with the speed, and that bends the force
    degree = 2 if before.sum() > _FEWEST + 1 else 1
    return _fitted(shifted[before] - turn, force[near][before], degree)[-1]


def _fitted(x: FloatArray, y: FloatArray, degree: int) -> list[float]:
    """Return the coefficients of the polynomial that fits best, highest first."""
    return np.asarray(np.polyfit(x, y, degree), dtype=np.float64).tolist()


def zero_crossings(history: History) -> FloatArray:
    """Return time [s], force [N] and load [N] wherever the displacement passes zero, shape (crossings, 3).

    The start is left out: a bearing that has not moved yet has no friction force.
    """
    y = history.displacement
    # what is a rounding error away from zero is there
    y = np.where(np.abs(y) < 1e-9 * np.abs(y).max(), 0.0, y)
    ends = np.flatnonzero((y[1:] == 0.0) & (y[:-1] != 0.0) | (y[:-1] * y[1:] < 0.0))
    ends = _passages(y, ends)
    part = y[ends] / (y[ends] - y[ends + 1])
    columns = (history.time, history.force, history.load)
    return np.column_stack([c[ends] + part * (c[ends + 1] - c[ends]) for c in columns])


def _passages(displacement: FloatArray, crossings: IntArray) -> IntArray:
    """Return the crossings before each of which it has been far from zero since the one before: noise around zero makes none."""
    far = CROSSING * float(np.abs(displacement).max())
    kept: list[int] = []
    since = 0
    for place in crossings.tolist():
        if np.abs(displacement[since : place + 1]).max() > far:
            kept.append(place)
            since = place + 1
    return np.array(kept, dtype=np.intp)


def _post_yield_stiffness(displacement: FloatArray, force: FloatArray, virgin: int) -> float:
    """Return the mean slope of the strokes [N/mm], weighted by how far they go; so many `virgin` samples at the start are left out."""
    largest = 0.5 * float(np.ptp(displacement))
    middle = 0.5 * float(displacement.max() + displacement.min())
    near = np.abs(displacement - middle) <= _BRANCH * largest
    near[:virgin] = False
    steps = np.sign(np.diff(displacement))
    moving = np.flatnonzero(steps)  # a sample may be there twice
    turns = moving[1:][steps[moving[1:]] != steps[moving[:-1]]]
    slopes: list[float] = []
    weights: list[float] = []
    for stroke in np.split(np.arange(displacement.size), turns):
        part = stroke[near[stroke]]
        if part.size >= _FEWEST and np.ptp(displacement[part]) > _LEAST_STROKE * largest:
            slopes.append(_fitted(displacement[part], force[part], 1)[0])
            weights.append(float(np.ptp(displacement[part])))
    return float(np.average(slopes, weights=weights)) if sum(weights) > 0.0 else math.nan

"""Which friction and which radius hold a displacement at a PGV: analyses of a record set over a grid of bearings."""

import math
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace

import numpy as np

from dcfp.analysis.batch import GroundSet, Lanes, Peaks, available_threads, respond_in_batch
from dcfp.analysis.response import FAILED
from dcfp.arrays import FloatArray
from dcfp.errors import AnalysisError, InputError
from dcfp.inference.case import Setting
from dcfp.inference.earthquake import event_of
from dcfp.motion.ground_motion import GroundMotion
from dcfp.system import System

#: Grid that is looked at unless another is given: radius of each plate [mm] and reference coefficient [-].
RADII = np.array([1500.0, 2250.0, 3000.0, 4500.0, 6000.0])
COEFFICIENTS = np.array([0.02, 0.03, 0.04, 0.05, 0.06, 0.075, 0.09, 0.105, 0.125, 0.15])
#: Draws of earthquakes by which it is said how sure a coefficient is, and where their random numbers start.
_DRAWS, _SEED = 100, 33


@dataclass(frozen=True, eq=False)
class DesignSpace:
    """Displacement and force of every record over a grid of bearings, at one PGV.

    Attributes
    ----------
    pgv
        [mm/s].
    radii
        Effective radius of each plate [mm], shape (r,).
    coefficients
        Reference coefficient of the friction law [-], shape (c,).
    displacement
        y_max of every record [mm], shape (r, c, records).
    force
        Largest force over the weight [-], shape (r, c, records).
    events
        The earthquake of each record.
    """

    pgv: float
    radii: FloatArray
    coefficients: FloatArray
    displacement: FloatArray
    force: FloatArray
    events: tuple[str, ...]

    @property
    def records(self) -> int:
        """Number of records analysed for each bearing."""
        return self.displacement.shape[2]

    def displacement_at(self, part: float) -> FloatArray:
        """Return the y_max [mm] that another earthquake of this PGV does not exceed with a probability of `part` [-], shape (r, c)."""
        return _quantiles(self.displacement, part)

    def force_at(self, part: float) -> FloatArray:
        """Return the force over the weight [-] in the same sense, shape (r, c)."""
        return _quantiles(self.force, part)

    def holding(self, allowed: float, part: float) -> tuple[FloatArray, FloatArray]:
        """Return for each radius the least coefficient from which on `allowed` [mm] holds with a probability of `part` [-], and the force over the weight that goes with it, shape (r,).

        Between the bearings of the grid both are taken as straight lines. The coefficient is the first of the grid where that is enough, and
        both are not a number where the last is not.
        """
        least = self._least(self.displacement, allowed, part)
        force = np.full(least.size, np.nan)
        for i, line in enumerate(self.force_at(part)):
            if not np.isnan(least[i]):
                force[i] = np.interp(least[i], self.coefficients, line)
        return least, force

    def spread(self, allowed: float, part: float) -> tuple[float, float]:
        """Return 5 and 95 % of the least coefficient [-], mean of the radii, had other earthquakes of the same kind been in the set.

        Whole earthquakes are drawn with replacement. A draw in which no coefficient of the grid is enough counts as the largest of the grid.
        """
        numbers = np.random.default_rng(_SEED)
        names = sorted(set(self.events))
        members = [[i for i, event in enumerate(self.events) if event == name] for name in names]
        found: list[float] = []
        for _ in range(_DRAWS):
            places: list[int] = numbers.integers(len(names), size=len(names)).tolist()
            drawn = [i for place in places for i in members[place]]
            least = self._least(self.displacement[:, :, drawn], allowed, part)
            found.append(float(np.where(np.isnan(least), self.coefficients[-1], least).mean()))
        low, high = np.quantile(found, [0.05, 0.95])
        return float(low), float(high)

    def _least(self, displacement: FloatArray, allowed: float, part: float) -> FloatArray:
        lines = _quantiles(displacement, part)
        return np.array([_crossing(self.coefficients, line, allowed) for line in lines])


def _quantiles(values: FloatArray, part: float) -> FloatArray:
    """Return what the next value does not exceed with a probability of `part`, along the last axis; see `quantile`.

    Raises
    ------
    InputError
        If there are too few values for that probability.
    """
    number = values.shape[-1]
    if part * (number + 1) > number:
        msg = f"What {100.0 * part:g} % of earthquakes do not exceed needs more than {number} records."
        raise InputError(msg)
    rank = max(part * (number + 1) - 1.0, 0.0)
    ordered = np.sort(values, axis=-1)
    low = min(int(rank), number - 2) if number > 1 else 0
    share = rank - low
    return (1.0 - share) * ordered[..., low] + share * ordered[..., min(low + 1, number - 1)]


def survey(
    motions: Sequence[GroundMotion],
    pgv: float,
    setting: Setting,
    radii: FloatArray = RADII,
    coefficients: FloatArray = COEFFICIENTS,
    report: Callable[[], None] | None = None,
) -> DesignSpace:
    """Analyse every motion at a PGV [mm/s] on every bearing of a grid.

    Parameters
    ----------
    motions
        The record set.
    pgv
        [mm/s].
    setting
        The bearing whose radii are varied, equal on all plates, and the law whose reference coefficient is.
    radii, coefficients
        As in `DesignSpace`, increasing.
    report
        Called after each radius.

    Raises
    ------
    InputError
        If the friction law has no reference coefficient to vary.
    AnalysisError
        If an analysis cannot be finished.
    """
    grounds = GroundSet.of(motions)
    scales = np.array([[pgv / motion.peak_velocity] for motion in motions])
    laws = [setting.friction.with_reference(coefficient) for coefficient in coefficients.tolist()]

    def analyse(radius: float) -> Peaks:
        plates = (radius,) * len(setting.bearing.radii)
        bearing = replace(setting.bearing, radii=plates, displacement_capacity=None, capacity_note="")
        models = [System(bearing, law, setting.heating) for law in laws]
        peaks = respond_in_batch(grounds, Lanes.grid(len(motions), scales, models))
        if (peaks.status == FAILED).any():
            msg = f"An analysis with a radius of {radius:g} mm cannot be finished; look at the friction law {setting.friction.title}."
            raise AnalysisError(msg)
        return peaks

    displacement = np.empty((radii.size, coefficients.size, len(motions)))
    force = np.empty_like(displacement)
    with ThreadPoolExecutor(available_threads()) as pool:
        for i, peaks in enumerate(pool.map(analyse, radii.tolist())):
            displacement[i] = peaks.peak_displacement.reshape(len(motions), -1).T
            force[i] = peaks.force_ratio.reshape(len(motions), -1).T
            if report is not None:
                report()
    return DesignSpace(pgv, radii, coefficients, displacement, force, tuple(map(event_of, motions)))


def _crossing(coefficients: FloatArray, displacement: FloatArray, allowed: float) -> float:
    """Return where the displacement falls to what is allowed for good [-]."""
    above = np.flatnonzero(displacement > allowed)
    if above.size == 0:
        return float(coefficients[0])
    last = int(above[-1])
    if last + 1 == coefficients.size:
        return math.nan
    share = (displacement[last] - allowed) / (displacement[last] - displacement[last + 1])
    return float(coefficients[last] + share * (coefficients[last + 1] - coefficients[last]))

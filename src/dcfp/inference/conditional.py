r"""Intervals that know the spectrum of the earthquake: how far a prediction is off, regressed on what explains it.

Records of one PGV differ in how much of it is at long periods, and that decides how far the bearing goes. So the logarithm of analysis over prediction is regressed on

.. math:: \ln \frac{S_v(0.6\,T_e)}{\mathrm{PGV}}, \quad \ln \frac{S_v(1.6\,T_e)}{\mathrm{PGV}}

with the pseudo-velocity :math:`S_v` at 5 % of damping and :math:`T_e` the period of the secant stiffness at the median displacement of that PGV. All the energy put in also depends on how long the
shaking lasts, and is regressed on :math:`\ln \int v_g^2\,dt / \mathrm{PGV}^2` besides. The interval is a conformal one: its ends are quantiles of the residuals of
each earthquake from a fit to the other ones. The form and the margin are ours; ``studies/intervals`` has the evidence.
"""

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.inference.case import Case
from dcfp.inference.statistics import COVERED, Interval, fewest
from dcfp.methods.equivalent_linear import PendulumWithFriction
from dcfp.methods.prediction import Methods
from dcfp.methods.pulses import TOTAL
from dcfp.methods.spectra.elastic import ElasticSpectrum, velocity
from dcfp.methods.spectra.of_record import response_spectrum
from dcfp.methods.spectra.of_station import station_spectrum
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.station import Station
from dcfp.schema.quantities import Quantity

#: A record, where it is at hand.
Ground: TypeAlias = GroundMotion | Station | None

#: Periods at which the spectrum is read, over the secant period [-].
PARTS_OF_PERIOD = (0.6, 1.6)
#: By how much half of the interval is made wider: earthquakes that are in no set differ more from the set than its own do from each other [-].
MARGIN = 1.15
#: By how much wider it is for each standard deviation that an earthquake is beyond the experience, besides the leverage: a guess [-].
_WIDER = 0.25
#: How an earthquake of several components counts: each of n as n to this power.
_WEIGHT_POWER = -0.5
#: Fewest earthquakes that a regression rests on.
_FEWEST_EVENTS = 6
#: Shortest and longest period at which a spectrum is read [s].
_SHORTEST, _LONGEST = 0.1, 10.0
#: What an earthquake is known by, in the order of the columns.
_CALLED = (
    "spectral velocity at {0:.1f} s over the PGV",
    "spectral velocity at {1:.1f} s over the PGV",
    "time integral of the squared ground velocity over that of the PGV [s]",
)


def periods_at(displacement: float, methods: Methods) -> FloatArray:
    """Return the two periods at which the spectrum is read [s], for a median displacement [mm]."""
    bearing = methods.system.bearing
    pendulum = PendulumWithFriction(bearing.effective_radius, methods.constants.nominal_friction)
    period = pendulum.effective_period(max(displacement, 1e-3))
    return np.clip(np.array(PARTS_OF_PERIOD) * period, _SHORTEST, _LONGEST)


def of_spectrum(spectrum: ElasticSpectrum, pgv: float, periods: FloatArray) -> FloatArray:
    """Return what a spectrum at a PGV [mm/s] is known by: logarithms, shape (2,)."""
    return np.log(velocity(spectrum, periods) / pgv)


def of_record(motion: GroundMotion | Station, periods: FloatArray) -> FloatArray:
    """Return what a record is known by, however it is scaled: logarithms, shape (3,); of a station by the median of all directions and the resultant's PGV."""
    if isinstance(motion, Station):
        displacement = station_spectrum(motion, periods).rotated(50.0)
    else:
        displacement = response_spectrum(motion, periods).displacement
    spectral = displacement * (2.0 * np.pi / periods) / motion.peak_velocity
    lasting = float(np.sum(motion.velocity**2)) * motion.time_step / motion.peak_velocity**2
    return np.log(np.append(spectral, lasting))


@dataclass(frozen=True, eq=False)
class Regression:
    """How far predictions are off, by what is known of the earthquake.

    Attributes
    ----------
    coefficients, inverse
        Of the least squares, the constant first, and the inverse of their normal matrix, for weights with a mean of one.
    low, median, high
        Ends and median of the residuals over their standard deviation's growth by leverage, the margin included.
    least, largest, spread
        Range and standard deviation of what is known, over the cases.
    cases
        That it rests on.
    """

    coefficients: FloatArray
    inverse: FloatArray
    low: float
    median: float
    high: float
    least: FloatArray
    largest: FloatArray
    spread: FloatArray
    cases: int

    @classmethod
    def of(
        cls, errors: FloatArray, known: FloatArray, events: Sequence[str], covered: float = COVERED
    ) -> "Regression | None":
        """Return the regression of errors [-] on what is `known` of their earthquakes, shape (cases, columns); None where they are too few.

        Errors that are no number do not count. Components of one earthquake resemble each other: each residual is from a fit to the other earthquakes.
        """
        there = np.isfinite(errors) & np.isfinite(known).all(axis=1)
        names = [event for event, counts in zip(events, there, strict=True) if counts]
        numbers = Counter(names)
        if len(names) < fewest(covered) + known.shape[1] or len(numbers) < _FEWEST_EVENTS:
            return None
        y = errors[there]
        rows: FloatArray = np.column_stack((np.ones(len(names)), known[there]))
        weights = np.array([numbers[name] ** _WEIGHT_POWER for name in names])
        weights /= weights.mean()
        weighted: FloatArray = weights[:, np.newaxis] * rows
        normal: FloatArray = rows.T @ weighted
        right: FloatArray = weighted.T @ y
        residuals, of = np.empty(len(names)), np.array(names)
        for name in numbers:
            own = of == name
            inverse = _inverse(normal - rows[own].T @ weighted[own])
            fitted = rows[own] @ (inverse @ (right - weighted[own].T @ y[own]))
            residuals[own] = (y[own] - fitted) / _growth(rows[own], inverse)
        low, median, high = (
            _quantile(residuals, weights, part)
            for part in (0.5 * (1.0 - covered), 0.5, 0.5 * (1.0 + covered))
        )
        middle, half = 0.5 * (low + high), 0.5 * MARGIN * (high - low)
        inverse = _inverse(normal)
        return cls(
            inverse @ right, inverse, middle - half, median, middle + half,
            known[there].min(axis=0), known[there].max(axis=0), known[there].std(axis=0), len(names),
        )  # fmt: skip

    def beyond(self, known: FloatArray) -> FloatArray:
        """Return how far what is known is beyond all that the regression has seen, in standard deviations, of the shape of `known`."""
        outside = np.maximum(np.maximum(self.least - known, known - self.largest), 0.0)
        return outside / self.spread

    def ends(self, known: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Return low end, median and high end of errors [-] by what is `known`, shape (cases, columns); wider where that is beyond the experience."""
        rows = np.column_stack((np.ones(len(known)), known))
        at, growth = rows @ self.coefficients, _growth(rows, self.inverse)
        middle, half = 0.5 * (self.low + self.high), 0.5 * (self.high - self.low)
        half = half * (1.0 + _WIDER * self.beyond(known).max(axis=1))
        return at + growth * (middle - half), at + growth * self.median, at + growth * (middle + half)

    def interval(self, known: FloatArray, predicted: float = 1.0) -> Interval:
        """Return where the analysis will be found, about what is predicted, by what is `known`, shape (columns,)."""
        low, median, high = (predicted * math.exp(float(end[0])) for end in self.ends(known[np.newaxis]))
        return Interval(low, median, high, self.cases)


@dataclass(frozen=True, eq=False)
class Experience:
    """The earthquakes of other records at one PGV, at which periods their spectra are read [s], and what each is known by: logarithms, shape (records, 3)."""

    events: Sequence[str]
    periods: FloatArray
    known: FloatArray

    @classmethod
    def of(
        cls,
        motions: Sequence[Ground],
        events: Sequence[str],
        displacements: Sequence[float],
        methods: Methods,
    ) -> "Experience":
        """Return the experience of records of some earthquakes with their largest displacements [mm]; a record that is None is not at hand."""
        periods = periods_at(float(np.median(displacements)), methods)
        known = [np.full(len(_CALLED), np.nan) if one is None else of_record(one, periods) for one in motions]
        return cls(events, periods, np.array(known))

    @classmethod
    def of_cases(cls, cases: Sequence[Case], methods: Methods) -> "Experience":
        """Return the experience of cases that were predicted by `methods`."""
        displacements = [case.analysed.whole.bound for case in cases]
        return cls.of([one.motion for one in cases], [one.event for one in cases], displacements, methods)

    def of_quantity(self, quantity: Quantity) -> FloatArray:
        """Return what the errors of a quantity are regressed on, shape (records, columns)."""
        return self.known[:, : _columns(quantity)]

    def interval(
        self, errors: FloatArray, quantity: Quantity, known: FloatArray, predicted: float = 1.0
    ) -> tuple[Interval, list[str]] | None:
        """Return where the analysis will be found by the errors [-] of the other records, and what of the earthquake is beyond the experience, in words; None where that cannot be told."""
        columns = _columns(quantity)
        found = Regression.of(errors, self.known[:, :columns], self.events)
        if found is None or known.size < columns:
            return None
        here = known[:columns]
        return found.interval(here, predicted), self._words(found.beyond(here), here, found)

    def _words(self, beyond: FloatArray, known: FloatArray, regression: Regression) -> list[str]:
        return [
            f"a {called.format(*self.periods)} of {math.exp(value):.2g}, where the set has {math.exp(least):.2g} to {math.exp(largest):.2g}"
            for off, called, value, least, largest in zip(
                beyond, _CALLED, known, regression.least, regression.largest, strict=False
            )
            if off > 0.0
        ]


def _columns(quantity: Quantity) -> int:
    """Return how many columns the errors of a quantity depend on."""
    return len(_CALLED) if quantity is TOTAL else len(PARTS_OF_PERIOD)


def _inverse(matrix: FloatArray) -> FloatArray:
    return np.asarray(np.linalg.inv(matrix), dtype=np.float64)


def _growth(rows: FloatArray, inverse: FloatArray) -> FloatArray:
    """Return by how much a residual of what was not fitted spreads more than the errors do [-]: by the leverage of its row."""
    return np.sqrt(1.0 + np.einsum("ij,jk,ik->i", rows, inverse, rows))


def _quantile(values: FloatArray, weights: FloatArray, part: float) -> float:
    """Return what the next value, of a weight of one, will be below with a probability of `part` [-]."""
    order = np.argsort(values)
    reached = np.cumsum(weights[order]) / (weights.sum() + 1.0)
    return float(np.interp(part, reached, values[order]))

"""The fit of a fragility and how sure it is, from draws of whole earthquakes."""

from dataclasses import dataclass

import numpy as np
from scipy.special import ndtr

from dcfp.arrays import FloatArray
from dcfp.study.assessment.first_exceedance import FirstExceedance
from dcfp.study.assessment.interval_fit import fit_lognormal


@dataclass(frozen=True)
class Fit:
    """The fit of one capacity; not a number where there is none.

    Attributes
    ----------
    median
        In the unit of the intensity.
    dispersion, total_dispersion
        Between the records, and with further ones [-].
    median_bound, dispersion_bound
        Low and high.
    probability, probability_bound
        Of the curve, shape (points,) and (2, points) [-].
    without
        Part of the draws that have no fit [-].
    """

    median: float
    dispersion: float
    total_dispersion: float
    median_bound: FloatArray
    dispersion_bound: FloatArray
    probability: FloatArray
    probability_bound: FloatArray
    without: float


@dataclass(frozen=True, eq=False)
class Draws:
    """What the fits of all capacities share.

    Attributes
    ----------
    counts
        How often each record counts, shape (1 + draws, records); see `drawn_counts`.
    points
        Intensities of the curve, in their unit.
    confidence
        Part of the draws inside the bounds [-].
    """

    counts: FloatArray
    points: FloatArray
    confidence: float

    def fit(self, crossings: FirstExceedance, further: float) -> Fit:
        """Fit what was observed, and each draw; `further` is a dispersion that is added to that of the records [-]."""
        ends, place = np.unique(np.stack((crossings.lower, crossings.upper)), axis=1, return_inverse=True)
        weights = np.stack(
            [self.counts[:, place.ravel() == i].sum(axis=1) for i in range(ends.shape[1])], axis=1
        )
        median, dispersion = fit_lognormal(ends[0], ends[1], weights)
        total = np.hypot(dispersion, further)
        curves = lognormal_probability(self.points, median[:, None], total[:, None])
        return Fit(
            float(median[0]),
            float(dispersion[0]),
            float(total[0]),
            self._bound(median[1:]),
            self._bound(dispersion[1:]),
            curves[0],
            self._bound(curves[1:]),
            float(np.isnan(median[1:]).mean()),
        )

    def _bound(self, values: FloatArray) -> FloatArray:
        known = values[np.isfinite(values.reshape(len(values), -1)).all(axis=1)]
        if len(known) == 0:
            return np.full((2, *values.shape[1:]), np.nan)
        tail = 0.5 * (1.0 - self.confidence)
        return np.quantile(known, [tail, 1.0 - tail], axis=0)


def lognormal_probability(
    intensities: FloatArray, median: "FloatArray | float", dispersion: "FloatArray | float"
) -> FloatArray:
    """Return the probability that a capacity is exceeded at intensities of the unit of the median; 0 at zero."""
    with np.errstate(divide="ignore"):
        return np.asarray(ndtr(np.log(intensities / median) / dispersion), dtype=np.float64)


def drawn_counts(events: np.ndarray, draws: int, seed: int) -> FloatArray:
    """Return how often each record is drawn: first once each, then with whole earthquakes drawn, shape (1 + draws, records)."""
    names, member = np.unique(events, return_inverse=True)
    parts = np.full(names.size, 1.0 / names.size)
    drawn = np.random.default_rng(seed).multinomial(names.size, parts, size=draws)
    return np.concatenate((np.ones((1, events.size)), drawn[:, member].astype(np.float64)))

"""The fit of a fragility and how sure it is, from draws of whole earthquakes."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import log_ndtr, ndtr

from dcfp.arrays import FloatArray

# A lognormal distribution from intervals, in each of which one value is known to lie.
#
# With a slope a = 1/beta and an offset c = ln(theta)/beta, the logarithm of the likelihood is concave in a
# and c, whether an interval has two ends or one, so that Newton's method finds its one maximum.


_LOG_ROOT_TWO_PI = 0.5 * np.log(2.0 * np.pi)
#: Dispersion at which the search begins [-].
_FIRST_DISPERSION = 0.4
#: The search ends when a step would raise the logarithm of the likelihood by less than that [-], or after so many steps.
_SMALL, _MOST_STEPS, _MOST_HALVINGS = 1e-12, 60, 40


def can_be_fitted(lower: FloatArray, upper: FloatArray, weights: FloatArray) -> NDArray[np.bool_]:
    """Return whether intervals have a finite median and a finite dispersion above zero, shape (draws,).

    They have unless one value lies in all of them, or none of them has two ends.
    """
    there = weights > 0.0
    last_low = np.where(there, lower, 0.0).max(axis=1)
    first_high = np.where(there, upper, np.inf).min(axis=1)
    two_ends = (there & (lower > 0.0) & np.isfinite(upper)).any(axis=1)
    return (last_low > first_high) & two_ends


def fit_lognormal(lower: FloatArray, upper: FloatArray, weights: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return median and dispersion of greatest likelihood, shape (draws,); not a number where they cannot be fitted.

    Parameters
    ----------
    lower, upper
        Ends of the intervals, shape (n,): 0 and infinity where there is none.
    weights
        How often each interval counts, shape (draws, n).

    Returns
    -------
    median, dispersion
        Shape (draws,); not a number where they cannot be fitted.
    """
    with np.errstate(divide="ignore"):
        low, high = np.log(lower), np.log(upper)
    ends = np.concatenate((low, high))
    middle = ends[np.isfinite(ends)].mean()
    low, high = low - middle, high - middle  # about zero, where the equations are best conditioned
    median, dispersion = np.full(len(weights), np.nan), np.full(len(weights), np.nan)
    good = can_be_fitted(lower, upper, weights)
    if good.any():
        slope, offset = _maximum(low, high, weights[good])
        median[good], dispersion[good] = np.exp(offset / slope + middle), 1.0 / slope
    return median, dispersion


def _maximum(low: FloatArray, high: FloatArray, weights: FloatArray) -> tuple[FloatArray, FloatArray]:
    slope = np.full(len(weights), 1.0 / _FIRST_DISPERSION)
    offset = np.zeros(len(weights))
    value = _log_likelihood(slope, offset, low, high, weights)
    for _ in range(_MOST_STEPS):
        step_slope, step_offset, gain = _newton_step(slope, offset, low, high, weights)
        if gain.max() < _SMALL:
            break
        share, new = np.ones(len(weights)), value
        for _ in range(_MOST_HALVINGS):
            new = _log_likelihood(
                slope + share * step_slope, offset + share * step_offset, low, high, weights
            )
            worse = new < value - _SMALL * np.abs(value)
            if not worse.any():
                break
            share = np.where(worse, 0.5 * share, share)
        slope, offset, value = slope + share * step_slope, offset + share * step_offset, new
    return slope, offset


def _log_likelihood(
    slope: FloatArray, offset: FloatArray, low: FloatArray, high: FloatArray, weights: FloatArray
) -> FloatArray:
    inside = np.where(slope > 0.0, slope, 1.0)
    logarithm = _log_probability(
        inside[:, None] * low - offset[:, None], inside[:, None] * high - offset[:, None]
    )
    there = np.where(weights > 0.0, weights * logarithm, 0.0)
    return np.where(slope > 0.0, there.sum(axis=1), -np.inf)


def _log_probability(low: FloatArray, high: FloatArray) -> FloatArray:
    """Return the logarithm of the normal probability between two ends, from the tail in which no digits are lost."""
    above = low > 0.0
    first, last = np.where(above, -high, low), np.where(above, -low, high)
    at_last = log_ndtr(last)
    with np.errstate(divide="ignore"):
        return at_last + np.log1p(-np.exp(log_ndtr(first) - at_last))


def _newton_step(
    slope: FloatArray, offset: FloatArray, low: FloatArray, high: FloatArray, weights: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return Newton's step of slope and offset, and by how much it would raise the logarithm of the likelihood."""
    first, last = (slope[:, None] * end - offset[:, None] for end in (low, high))
    logarithm = np.where(
        weights > 0.0, _log_probability(first, last), 0.0
    )  # what does not count may be impossible
    one, other = _density(last, logarithm), _density(first, logarithm)
    x_one, x_other = (np.where(np.isfinite(end), end, 0.0) for end in (high, low))
    z_one, z_other = (np.where(np.isfinite(end), end, 0.0) for end in (last, first))
    by_slope, by_offset = one * x_one - other * x_other, other - one
    g_slope, g_offset = (weights * by_slope).sum(axis=1), (weights * by_offset).sum(axis=1)
    curve = -(weights * (z_other * other * x_other**2 - z_one * one * x_one**2 - by_slope**2)).sum(axis=1)
    mixed = -(weights * (z_one * one * x_one - z_other * other * x_other - by_slope * by_offset)).sum(axis=1)
    level = -(weights * (z_other * other - z_one * one - by_offset**2)).sum(axis=1)
    determinant = curve * level - mixed**2
    step_slope = (level * g_slope - mixed * g_offset) / determinant
    step_offset = (curve * g_offset - mixed * g_slope) / determinant
    return step_slope, step_offset, step_slope * g_slope + step_offset * g_offset


def _density(end: FloatArray, logarithm: FloatArray) -> FloatArray:
    """Return the normal density at an end over the probability of its interval; zero at infinity."""
    return np.exp(-0.5 * end**2 - _LOG_ROOT_TWO_PI - logarithm)


@dataclass(frozen=True, eq=False)
class FirstExceedance:
    """For each record the intensities between which it first exceeds a capacity, 0 and infinity where there is none.

    Some records, `returns` in number, are within the capacity again at a higher intensity.
    """

    lower: FloatArray
    upper: FloatArray
    returns: int

    def reason(self, shown: Callable[[float], str]) -> str:
        """Return why no lognormal distribution can be fitted, as the end of a sentence; empty if it can."""
        number = self.upper.size
        if not np.isfinite(self.upper).any():
            return (
                f"none of the {number} records exceeds it up to {shown(self.lower.min())},"
                " which is only a lower bound of the median"
            )
        if not (self.lower > 0.0).any():
            return f"all of the {number} records exceed it at {shown(self.upper.max())}, the lowest intensity, already"
        first, last = float(self.lower.max()), float(self.upper.min())
        if first <= last:
            between = f"between {shown(first)} and {shown(last)}" if first < last else f"about {shown(first)}"
            return f"the intensities are too far apart to see a dispersion {between}; add some there"
        if not ((self.lower > 0.0) & np.isfinite(self.upper)).any():
            return (
                f"the records exceed it at the lowest intensity or not at all up to {shown(first)};"
                " widen the range of the intensities"
            )
        return ""


def first_exceedance(intensities: FloatArray, values: FloatArray, capacity: float) -> FirstExceedance:
    """Return between which increasing intensities each record first exceeds a capacity; values have shape (records, i).

    Parameters
    ----------
    intensities
        Increasing, shape (i,).
    values
        Of the quantity, shape (records, i); what is not a number is not known, and widens the interval. A record of which nothing is known is left out.
    capacity
        In the unit of the quantity.
    """
    lower: list[float] = []
    upper: list[float] = []
    returns = 0
    for row in values:
        known = np.isfinite(row)
        if not known.any():
            continue
        at, exceeds = intensities[known], row[known] > capacity
        first = int(np.argmax(exceeds)) if exceeds.any() else at.size
        lower.append(float(at[first - 1]) if first > 0 else 0.0)
        upper.append(float(at[first]) if first < at.size else np.inf)
        returns += not exceeds[first:].all()
    return FirstExceedance(np.array(lower), np.array(upper), returns)


@dataclass(frozen=True)
class Fit:
    """The fit of one capacity; not a number where there is none.

    Bounds are low and high; the curve has the shape (points,). The part of the draws `without` a fit is in
    [-].
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
    """What the fits of all capacities share: how often each record counts, the points of the curve, the confidence."""

    counts: FloatArray
    points: FloatArray
    confidence: float

    def fit(self, crossings: FirstExceedance, further: float) -> Fit:
        """Fit what was observed, and each draw, with a further dispersion beside that of the records [-]."""
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
    """Return how often each record counts: once each, then with whole earthquakes drawn, shape (1 + draws, records)."""
    names, member = np.unique(events, return_inverse=True)
    parts = np.full(names.size, 1.0 / names.size)
    drawn = np.random.default_rng(seed).multinomial(names.size, parts, size=draws)
    return np.concatenate((np.ones((1, events.size)), drawn[:, member].astype(np.float64)))

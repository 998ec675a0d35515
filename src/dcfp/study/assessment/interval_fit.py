"""A lognormal distribution from intervals, in each of which one value is known to lie.

With a slope a = 1/beta and an offset c = ln(theta)/beta, the logarithm of the likelihood is concave in a and c, whether an interval has two ends or
one, so that Newton's method finds its one maximum.
"""

import numpy as np
from numpy.typing import NDArray
from scipy.special import log_ndtr

from dcfp.arrays import FloatArray

_LOG_ROOT_TWO_PI = 0.5 * np.log(2.0 * np.pi)
#: Dispersion at which the search begins [-].
_FIRST_DISPERSION = 0.4
#: The search ends when a step would raise the logarithm of the likelihood by less than that [-], or after so many steps.
_SMALL, _MOST_STEPS, _MOST_HALVINGS = 1e-12, 60, 40


def can_be_fitted(lower: FloatArray, upper: FloatArray, weights: FloatArray) -> NDArray[np.bool_]:
    """Return whether intervals have a finite median and a finite dispersion above zero, shape (draws,).

    They have unless one value lies in all of them, or none of them has two ends. Arguments as for `fit_lognormal`.
    """
    there = weights > 0.0
    last_low = np.where(there, lower, 0.0).max(axis=1)
    first_high = np.where(there, upper, np.inf).min(axis=1)
    two_ends = (there & (lower > 0.0) & np.isfinite(upper)).any(axis=1)
    return (last_low > first_high) & two_ends


def fit_lognormal(lower: FloatArray, upper: FloatArray, weights: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return median and dispersion of greatest likelihood, the latter as standard deviation of the natural logarithm [-].

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

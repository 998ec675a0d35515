"""Strokes of a measured motion, and histories without their noise: Savitzky and Golay's filter, stroke by stroke."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.polynomial.legendre import legder, legval, legvander
from scipy.interpolate import PchipInterpolator

from dcfp.arrays import FloatArray, equally_spaced

#: Windows of the filter that are tried [samples].
_WINDOWS = (5, 7, 9, 13, 17, 23, 31, 41, 55, 73, 97, 129, 173, 231, 309, 411, 549, 731, 975, 1301, 1735)


@dataclass(frozen=True)
class Smoothed:
    """A history without its noise.

    Attributes
    ----------
    values
        In the unit of what was smoothed, shape (n,).
    slope
        Its derivative by time, per second.
    window
        Length of the filter [samples]; zero where there was too little to smooth.
    """

    values: FloatArray
    slope: FloatArray
    window: int


def find_strokes(displacement: FloatArray, least: float) -> list[slice]:
    """Return the parts between reversals, from turn to turn, of motions of at least `least` [mm].

    A turn belongs to the stroke that ends with it.
    """
    y = displacement.tolist()
    turns = [0]
    furthest, direction = 0, 0
    for i, value in enumerate(y):
        step = value - y[furthest]
        if direction == 0:
            if abs(value - y[0]) >= least:
                direction, furthest = (1 if value > y[0] else -1), i
        elif direction * step >= 0.0:
            furthest = i
        elif direction * step <= -least:
            turns.append(furthest)
            direction, furthest = -direction, i
    # what comes after the last turn is a stroke if it goes far enough, up to its furthest point
    last = [] if direction == 0 else [furthest]
    bounds = [*turns, *last]
    firsts = [0, *(turn + 1 for turn in bounds[1:-1])]
    return [slice(first, end + 1) for first, end in zip(firsts, bounds[1:], strict=False)]


def smooth(
    values: FloatArray, time: FloatArray, parts: Sequence[slice], order: int, scatter: float = 0.0
) -> Smoothed:
    """Fit polynomials of an `order` to `values` in a window that moves through each part.

    Where one polynomial for each part leaves a root mean square of no more than `scatter`, the window is the part. Else it is the one,
    of those from 5 to 1735 samples that are tried, with the least generalised cross-validation (Craven and Wahba 1979): as long as the noise asks for, if that is
    white, and no longer than the motion in its sampling allows. At the ends of a part the polynomial of the last whole window goes on. What
    belongs to no part, or to one that is too short, stays as it is.
    """
    long_parts = [part for part in parts if part.stop - part.start >= order + 3]
    smoothed = values.copy()
    slope = np.gradient(values, time)
    if not long_parts:
        return Smoothed(smoothed, slope, 0)
    uniform = equally_spaced(time)
    even = values.copy()
    grids: dict[int, FloatArray] = {}
    if not uniform:  # they are read off a curve through them at as many times that are evenly spaced
        for part in long_parts:
            first, last = float(time[part.start]), float(time[part.stop - 1])
            grids[part.start] = np.linspace(first, last, part.stop - part.start)
            even[part] = PchipInterpolator(time[part], values[part])(grids[part.start])
    window = max(part.stop - part.start for part in long_parts)
    if _residual(even, long_parts, order, window)[0] > scatter**2:
        window = _best_window(even, long_parts, order)
    for part in long_parts:
        moving = _moving_polynomial(_fitting(window, part, order), order)
        pace = float(time[part.stop - 1] - time[part.start]) / (part.stop - part.start - 1)
        found = np.stack((moving.value(even[part]), moving.slope(even[part]) / pace), axis=1)
        if grids:
            found = PchipInterpolator(grids[part.start], found)(time[part])
        smoothed[part], slope[part] = found[:, 0], found[:, 1]
    return Smoothed(smoothed, slope, window)


def _fitting(window: int, part: slice, order: int) -> int:
    """Return the window, or the longest that a part has room for."""
    room = part.stop - part.start
    return max(min(window, room - 1 + room % 2), order + 1 + order % 2)


def _best_window(values: FloatArray, parts: Sequence[slice], order: int) -> int:
    longest = max(part.stop - part.start for part in parts)
    tried = [window for window in _WINDOWS if order + 2 <= window <= longest] or [longest - 1 + longest % 2]
    return min(tried, key=lambda window: _cross_validation(values, parts, order, window))


def _cross_validation(values: FloatArray, parts: Sequence[slice], order: int, window: int) -> float:
    square, freedom = _residual(values, parts, order, window)
    return square / (1.0 - freedom) ** 2


def _residual(values: FloatArray, parts: Sequence[slice], order: int, window: int) -> tuple[float, float]:
    """Return the mean squared residual, and the part of the freedom of the samples that the polynomials take [-]."""
    squares, freedom, count = 0.0, 0.0, 0
    for part in parts:
        moving = _moving_polynomial(_fitting(window, part, order), order)
        piece = values[part]
        residual = piece - moving.value(piece)
        squares += float(residual @ residual)
        freedom += moving.freedom(piece.size)
        count += piece.size
    return squares / count, freedom / count


@dataclass(frozen=True)
class _MovingPolynomial:
    """Least squares polynomials over a window of an odd number of samples (Savitzky and Golay 1964).

    Attributes
    ----------
    basis
        Orthonormal polynomials at the samples of the window, shape (window, order + 1).
    change
        Their derivatives by the number of the sample.
    """

    basis: FloatArray
    change: FloatArray

    def value(self, samples: FloatArray) -> FloatArray:
        """Return the polynomials at the samples."""
        return self._at(samples, self.basis)

    def slope(self, samples: FloatArray) -> FloatArray:
        """Return their derivatives by the number of the sample."""
        return self._at(samples, self.change)

    def freedom(self, count: int) -> float:
        """Return the trace of the filter for so many samples."""
        window, order = self.basis.shape
        half = window // 2
        return (count - window) * float(self.basis[half] @ self.basis[half]) + order

    def _at(self, samples: FloatArray, read: FloatArray) -> FloatArray:
        window = self.basis.shape[0]
        half = window // 2
        return np.concatenate(
            (
                read[:half] @ (self.basis.T @ samples[:window]),
                np.convolve(samples, (self.basis @ read[half])[::-1], "valid"),
                read[half + 1 :] @ (self.basis.T @ samples[-window:]),
            )
        )


@lru_cache(maxsize=128)
def _moving_polynomial(window: int, order: int) -> _MovingPolynomial:
    place = np.linspace(-1.0, 1.0, window)
    raw = legvander(place, order)
    basis, change = np.linalg.qr(raw)
    slopes = np.stack([legval(place, legder(row)) for row in np.eye(order + 1)], axis=1)
    return _MovingPolynomial(basis, slopes @ np.linalg.inv(change) * (2.0 / (window - 1)))

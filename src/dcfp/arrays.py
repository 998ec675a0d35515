"""Array types that the whole package shares."""

from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

FloatArray: TypeAlias = NDArray[np.float64]
IntArray: TypeAlias = NDArray[np.intp]


#: Steps that differ by no more than that from the middle one are equal [-].
_SAME_STEP = 1e-6
#: Part of an array that is worth keeping all of it [-].
_MOST = 0.8


def equally_spaced(time: FloatArray) -> bool:
    """Return whether times are the same step apart, but for the digits that a file leaves out."""
    steps = np.diff(time)
    middle = float(np.median(steps))
    return bool(np.abs(steps - middle).max() < _SAME_STEP * middle)


def freeze(array: NDArray[np.floating[Any]]) -> FloatArray:
    """Return a contiguous read-only float copy, so that a result cannot be changed by accident."""
    copy = np.array(array, dtype=np.float64, order="C")
    copy.flags.writeable = False
    return copy


def integral(values: FloatArray, step: float) -> FloatArray:
    """Return the integral from the first sample to each one by the trapezoidal rule; samples are rows."""
    found = np.empty_like(values)
    found[0], rest = 0.0, found[1:]
    np.add(values[1:], values[:-1], out=rest)
    rest *= 0.5 * step
    np.cumsum(rest, axis=0, out=rest)
    return found


def whole_integral(values: FloatArray, step: float) -> FloatArray:
    """Return the integral from the first sample to the last one by the trapezoidal rule; samples are rows."""
    return step * (np.ones(len(values)) @ values - 0.5 * (values[0] + values[-1]))


def first_rows(values: FloatArray, count: int) -> FloatArray:
    """Return the first rows of an array that is not used otherwise, read-only: not copied where they are most of it."""
    if count < _MOST * len(values):
        return freeze(values[:count])
    values.flags.writeable = False
    return values[:count]

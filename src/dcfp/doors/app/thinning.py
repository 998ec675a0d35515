"""Fewer points for the screen, without losing a peak."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from dcfp.arrays import FloatArray, IntArray

#: Parts that a history is divided into; of each part the extremes are drawn.
PARTS = 420


def kept(columns: Sequence[FloatArray], parts: int = PARTS) -> IntArray:
    """Return which samples are enough to draw histories: first and last, and of every part the extremes of each column.

    Parameters
    ----------
    columns
        Histories of the same length.
    parts
        Into which they are divided.
    """
    size = int(columns[0].size)
    if size <= 2 * parts:
        return np.arange(size, dtype=np.intp)
    starts = np.linspace(0, size, parts + 1).astype(np.intp)[:-1]
    ends = np.append(starts[1:], size)
    width = int((ends - starts).max())
    # a row for each part, the last sample of a shorter one twice
    places = np.minimum(starts[:, None] + np.arange(width)[None, :], ends[:, None] - 1)
    rows = np.arange(parts)
    chosen = [np.array([0, size - 1], dtype=np.intp)]
    for column in columns:
        values = column[places]
        chosen += [places[rows, values.argmin(axis=1)], places[rows, values.argmax(axis=1)]]
    return np.unique(np.concatenate(chosen))


def points(x: FloatArray, y: FloatArray, digits: int = 5) -> list[Any]:
    """Return pairs for a chart, rounded to significant digits of the largest value, a gap where a value is not a number."""
    return np.column_stack((_rounded(x, digits), _rounded(y, digits))).tolist()


def _rounded(values: FloatArray, digits: int) -> FloatArray:
    finite = values[np.isfinite(values)]
    largest = float(np.abs(finite).max()) if finite.size else 0.0
    if largest == 0.0:
        return values
    return np.round(values, digits - 1 - int(np.floor(np.log10(largest))))

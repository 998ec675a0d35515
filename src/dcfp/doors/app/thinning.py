"""Fewer points for the screen, without losing a peak."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from dcfp.arrays import FloatArray, IntArray

#: Parts that a history is divided into; of each part the extremes are drawn.
PARTS = 420
#: Distance that is allowed between a path and what is drawn of it, as a part of its extent: half a pixel on a screen [-].
TOLERANCE = 1e-3


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
        values = np.nan_to_num(column)[places]
        chosen += [places[rows, values.argmin(axis=1)], places[rows, values.argmax(axis=1)]]
    return np.unique(np.concatenate(chosen))


def kept_of_path(x: FloatArray, y: FloatArray, tolerance: float = TOLERANCE) -> IntArray:
    """Return which points are enough to draw a path, such as a loop: its turning points, and between them what no chord passes near enough.

    The rule is that of Douglas and Peucker (1973), for all chords at once; thinned along time, a loop would become chords with invented tips.

    Parameters
    ----------
    x, y
        Coordinates of the points in their order.
    tolerance
        Distance from the path that is allowed to what is drawn, as a part of its extent along each axis [-].
    """
    spans = [float(np.ptp(values)) or 1.0 for values in (x, y)]
    path = np.column_stack([values / span for values, span in zip((x, y), spans, strict=True)])
    ends = np.array([0, path.shape[0] - 1], dtype=np.intp)
    chosen = np.unique(np.concatenate([ends, *(turning_points(one, tolerance) for one in path.T)]))
    starts, stops = chosen[:-1], chosen[1:]
    while starts.size:
        places, distances = _farthest(path, starts, stops)
        far = distances > tolerance
        chosen = np.concatenate((chosen, places[far]))
        starts, stops = (
            np.concatenate((starts[far], places[far])),
            np.concatenate((places[far], stops[far])),
        )
    return np.sort(chosen)


def turning_points(values: FloatArray, least: float) -> IntArray:
    """Return the samples at which a history turns and from which it comes back by more than `least`."""
    slopes = np.sign(np.diff(values))
    moving = np.flatnonzero(slopes)
    turns = moving[1:][np.diff(slopes[moving]) != 0.0]
    found, farthest = [0], 0
    for place in [*turns.tolist(), values.size - 1]:
        away, on = values[farthest] - values[found[-1]], values[place] - values[farthest]
        if away * on >= 0.0:
            farthest = place
        elif abs(on) > least:
            found.append(farthest)
            farthest = place
    return np.array(found[1:], dtype=np.intp)


def _farthest(path: FloatArray, starts: IntArray, stops: IntArray) -> tuple[IntArray, FloatArray]:
    """Return for each chord from one point of a path to a later one which point between is farthest from it, and how far."""
    lengths = stops - starts
    chord_of, first = np.repeat(np.arange(starts.size), lengths), np.cumsum(lengths) - lengths
    places = np.arange(chord_of.size) + (starts - first)[chord_of]
    chords = path[stops] - path[starts]
    squares = np.maximum((chords**2).sum(axis=1), np.finfo(float).tiny)
    along = path[places] - path[starts][chord_of]
    share = np.clip((along * chords[chord_of]).sum(axis=1) / squares[chord_of], 0.0, 1.0)
    distance = np.hypot(*(along - share[:, None] * chords[chord_of]).T)
    largest = np.maximum.reduceat(distance, first)
    best = np.flatnonzero(distance == largest[chord_of])
    return places[best[np.searchsorted(chord_of[best], np.arange(starts.size))]], largest


def points(x: FloatArray, y: FloatArray, digits: int = 5) -> list[Any]:
    """Return pairs for a chart, rounded to significant digits of the largest value, a gap where a value is not a number."""
    return np.column_stack((_rounded(x, digits), _rounded(y, digits))).tolist()


def _rounded(values: FloatArray, digits: int) -> FloatArray:
    finite = values[np.isfinite(values)]
    largest = float(np.abs(finite).max()) if finite.size else 0.0
    if largest == 0.0:
        return values
    return np.round(values, digits - 1 - int(np.floor(np.log10(largest))))

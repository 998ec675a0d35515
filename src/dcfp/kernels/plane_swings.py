"""Swings of a path in the plane: the largest change of its projection between two successive peaks, over all directions."""

import math

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel
from dcfp.kernels.oscillator import angle_of, passed

#: Rows of what `largest_change` works in: the directions' cosine and sine, and in each the last peak and the largest change so far [mm].
COSINE, SINE, LAST_PEAK, LARGEST, ROWS = range(5)


@kernel
def largest_change(
    displacement: NDArray[np.float64],
    velocity: NDArray[np.float64],
    interval: float,
    directions: NDArray[np.float64],
) -> float:
    """Return the largest change of displacement between two successive peaks in any of the directions [mm].

    Rows of `displacement` [mm] and `velocity` [mm/s] are `interval` [s] apart; `directions`, shape (ROWS, n), are evenly spaced over half a turn.
    Each interval concerns only those directions that the velocity turns past.
    """
    count = directions.shape[1]
    for k in range(count):
        directions[LAST_PEAK, k], directions[LARGEST, k] = _along(directions, k, displacement[0]), 0.0
    angle = angle_of(velocity[0, 0], velocity[0, 1])
    for i in range(displacement.shape[0] - 1):
        before, angle = angle, angle_of(velocity[i + 1, 0], velocity[i + 1, 1])
        low, high = passed(before, angle, count)
        first, number = math.ceil(low), math.floor(high) + 1 - math.ceil(low)
        first %= count
        _note_peaks(
            displacement[i],
            velocity[i],
            velocity[i + 1],
            interval,
            directions,
            first,
            min(first + number, count),
        )
        _note_peaks(
            displacement[i], velocity[i], velocity[i + 1], interval, directions, 0, first + number - count
        )
    largest = 0.0
    for k in range(count):
        end = _along(directions, k, displacement[-1])
        largest = max(largest, directions[LARGEST, k], abs(end - directions[LAST_PEAK, k]))
    return largest


@kernel
def _note_peaks(
    displacement: NDArray[np.float64],
    velocity: NDArray[np.float64],
    later: NDArray[np.float64],
    interval: float,
    directions: NDArray[np.float64],
    first: int,
    beyond: int,
) -> None:
    """Note the peaks in an interval in some of the directions: the velocities decide, and are taken as linear. Without branches, so that it is done for several at once."""
    for k in range(first, beyond):
        v0, v1 = _along(directions, k, velocity), _along(directions, k, later)
        turns = v0 * v1 < 0.0
        peak = _along(directions, k, displacement) + 0.5 * interval * v0 * v0 / (v0 - v1)
        last, most = directions[LAST_PEAK, k], directions[LARGEST, k]
        change = abs(peak - last)
        directions[LARGEST, k] = change if turns and change > most else most
        directions[LAST_PEAK, k] = peak if turns else last


@kernel
def _along(directions: NDArray[np.float64], k: int, vector: NDArray[np.float64]) -> float:
    """Component of a vector in a direction."""
    return directions[COSINE, k] * vector[0] + directions[SINE, k] * vector[1]

"""Swings of a path in the plane: the largest change of its projection between two successive peaks, over all directions."""

import math

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel
from dcfp.kernels.oscillator import passed

#: Of a row of what `largest_change` works in: the directions' cosine and sine, and the last peak in each [mm].
COSINE, SINE, LAST_PEAK = range(3)


@kernel
def largest_change(
    displacement: NDArray[np.float64],
    velocity: NDArray[np.float64],
    interval: float,
    directions: NDArray[np.float64],
) -> float:
    """Return the largest change of displacement between two successive peaks in any of the directions [mm].

    Rows of `displacement` [mm] and `velocity` [mm/s] are `interval` [s] apart; `directions`, shape (3, n), are evenly spaced over half a turn.
    Each interval concerns only those directions that the velocity turns past.
    """
    count = directions.shape[1]
    for k in range(count):
        directions[LAST_PEAK, k] = _along(directions, k, displacement[0])
    largest = 0.0
    angle = math.atan2(velocity[0, 1], velocity[0, 0])
    for i in range(displacement.shape[0] - 1):
        before, angle = angle, math.atan2(velocity[i + 1, 1], velocity[i + 1, 0])
        low, high = passed(before, angle, count)
        for place in range(math.ceil(low), math.floor(high) + 1):  # the velocities decide
            k = place % count
            v0, v1 = _along(directions, k, velocity[i]), _along(directions, k, velocity[i + 1])
            if v0 * v1 < 0.0:
                # the velocity as linear in the interval of the turn
                peak = _along(directions, k, displacement[i]) + 0.5 * interval * v0 * v0 / (v0 - v1)
                largest = max(largest, abs(peak - directions[LAST_PEAK, k]))
                directions[LAST_PEAK, k] = peak
    for k in range(count):
        end = _along(directions, k, displacement[-1])
        largest = max(largest, abs(end - directions[LAST_PEAK, k]))
    return largest


@kernel
def _along(directions: NDArray[np.float64], k: int, vector: NDArray[np.float64]) -> float:
    """Component of a vector in a direction."""
    return directions[COSINE, k] * vector[0] + directions[SINE, k] * vector[1]

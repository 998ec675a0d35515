"""Pulses of the ground velocity: where a history turns."""

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel


@kernel
def find_extremes(
    acceleration: NDArray[np.float64],
    velocity: NDArray[np.float64],
    time_step: float,
    times: NDArray[np.float64],
    velocities: NDArray[np.float64],
) -> int:
    """Write time [s] and value [mm/s] of every extreme of the velocity, and of its two ends; return their number. There is room for two for each sample.

    Samples are `time_step` [s] apart, between which the acceleration [mm/s2] is linear. A sample of no acceleration counts where it stands, a change of sign
    where the straight line passes zero.
    """
    count, last = 0, velocity.size - 1
    for i in range(velocity.size):
        here = acceleration[i]
        if here == 0.0 or i == 0 or i == last:
            times[count], velocities[count] = i * time_step, velocity[i]
            count += 1
        if i < last and here * acceleration[i + 1] < 0.0:
            share = here / (here - acceleration[i + 1])
            times[count] = (i + share) * time_step
            velocities[count] = velocity[i] + 0.5 * here * share * time_step
            count += 1
    return count


@kernel
def find_turning_points(values: NDArray[np.float64], least: float, places: NDArray[np.int64]) -> int:
    """Write the places of the successive peaks of `values`, up and down in turn; return their number.

    A peak counts once the history has turned back from it by at least `least`. The first place is where the history left for the first peak, the last is the
    furthest point after the last peak that counts. Of equal values the last counts at the beginning and the first thereafter, so that zeros before and after
    change nothing.
    """
    high, low = 0, 0
    count, i = 0, 1
    while i < values.size and values[high] - values[low] < least:
        if values[i] >= values[high]:
            high = i
        if values[i] <= values[low]:
            low = i
        i += 1
    if values[high] - values[low] < least:
        return 0
    upwards = high > low
    places[0] = low if upwards else high
    count, furthest = 1, high if upwards else low
    while i < values.size:
        ahead = values[i] - values[furthest] if upwards else values[furthest] - values[i]
        if ahead > 0.0:
            furthest = i
        elif -ahead >= least:
            places[count] = furthest
            count += 1
            upwards = not upwards
            furthest = i
        i += 1
    places[count] = furthest
    return count + 1

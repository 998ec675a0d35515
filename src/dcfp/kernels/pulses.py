"""Pulses of the ground velocity: where a history turns."""

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel


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

"""The temperature of one point of a plate under a disc that has gone along a known path, and the hottest point near one.

The grid of `plane_heat` finds the hottest of its own points; between them a ridge of the temperature can be a degree or two higher.
"""

import math

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import called_kernel, kernel
from dcfp.kernels.plane_step import length_of
from dcfp.kernels.sum_of_exponentials import accumulate, decayed_total, fill_decay, fill_weights, total

# rows of the modes here: the constants, the factors of an interval (three rows), and the state of the point
RATES, WEIGHTS, FACTORS, STATE, ROWS = 0, 1, 2, 5, 6
# columns of a path: place of the disc [mm]; flux at the start of the interval and at its end as linear, and what it is at the end [N/(mm s)]
PLACE_X, PLACE_Y, OPENING, CLOSING, NOW, COLUMNS = range(6)

#: How often the distance of the points that are tried is halved.
_HALVINGS = 3


@called_kernel
def highest_rise(
    modes: NDArray[np.float64],
    instant: float,
    path: NDArray[np.float64],
    radius: float,
    point: complex,
    between: bool,
) -> float:
    """Return the highest rise of temperature of a point [degC] while the disc covers it: at the ends of intervals, and when the rim passes it where `between`.

    The factors of an interval stand in `modes`.
    """
    for j in range(modes.shape[1]):
        modes[STATE, j] = 0.0
    opening, closing = total(modes, FACTORS + 1), total(modes, FACTORS + 2)
    rise, highest, after = 0.0, 0.0, length_of(point - complex(path[0, PLACE_X], path[0, PLACE_Y]))
    for i in range(1, path.shape[0]):
        before, after = after, length_of(point - complex(path[i, PLACE_X], path[i, PLACE_Y]))
        part = 1.0
        if before > radius and after > radius:
            part = 0.0
        elif before > radius or after > radius:  # the rim passes it
            part = (radius - min(before, after)) / abs(after - before)
            if between and before <= radius:
                whole = (
                    decayed_total(modes, FACTORS, STATE)
                    + opening * path[i, OPENING]
                    + closing * path[i, CLOSING]
                )
                now = path[i - 1, NOW] + part * (path[i, NOW] - path[i - 1, NOW])
                highest = max(highest, rise + part * (whole - rise) + instant * now)
        rise = accumulate(modes, FACTORS, STATE, part * path[i, OPENING], part * path[i, CLOSING])
        if after <= radius:
            highest = max(highest, rise + instant * path[i, NOW])
    return highest


@kernel
def rise_between(
    modes: NDArray[np.float64],
    instant: float,
    path: NDArray[np.float64],
    interval: float,
    radius: float,
    point: complex,
    spacing: float,
) -> float:
    """Return by how much the hottest point within a `spacing` [mm] of a point gets hotter than that [degC]; rows of `path` are `interval` [s] apart."""
    fill_decay(modes, RATES, interval, FACTORS)
    fill_weights(modes, RATES, WEIGHTS, interval, FACTORS)
    of_grid = highest_rise(modes, instant, path, radius, point, False)
    highest, best, step = highest_rise(modes, instant, path, radius, point, True), point, spacing
    for _ in range(_HALVINGS):
        step *= 0.5
        centre = best
        for k in range(8):
            aside = complex(
                math.floor(math.cos(k * math.pi / 4) + 0.5), math.floor(math.sin(k * math.pi / 4) + 0.5)
            )
            tried = centre + complex(step * aside.real, step * aside.imag)
            rise = highest_rise(modes, instant, path, radius, tried, True)
            if rise > highest:
                highest, best = rise, tried
    return highest - of_grid

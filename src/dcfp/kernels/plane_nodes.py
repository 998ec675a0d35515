"""Nodes of a ground velocity in the plane: as of `dcfp.kernels.nodes`, with vectors, so that they do not depend on where x and y point."""

import math

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel
from dcfp.kernels.nodes import (
    BEYOND,
    BLOCK,
    END,
    FURTHEST_MOVE,
    START,
    cut_or_keep,
    leg_line,
    most_within,
    velocity_at,
    write_ranges,
)
from dcfp.kernels.plane_step import dot, length_of, times

#: Columns of what the search for better places works in: the velocity at both ends of a leg's own straight line, by direction.
FROM_X, FROM_Y, TO_X, TO_Y, MOVE_SIZE = range(5)
#: How often the interval is halved in which a distance is extreme.
_HALVINGS = 30


@kernel
def plane_velocity_at(
    ax: NDArray[np.float64], ay: NDArray[np.float64], vx: NDArray[np.float64], vy: NDArray[np.float64], place: float
) -> complex:  # fmt: skip
    """Return the velocity at a place, counted in samples [mm/s]."""
    return complex(velocity_at(ax, vx, place), velocity_at(ay, vy, place))


@kernel
def choose_plane_nodes(
    ax: NDArray[np.float64], ay: NDArray[np.float64], vx: NDArray[np.float64], vy: NDArray[np.float64],
    first: int, last: int, tolerance: float,
    ranges: NDArray[np.float64], waiting: NDArray[np.float64], places: NDArray[np.float64],
) -> int:  # fmt: skip
    """Write the places of the nodes between two samples, as `choose_nodes` does; the distance is that of the vectors. `ranges`, shape (2, blocks, RANGE_SIZE), is worked in."""
    write_ranges(ax, vx, ranges[0])
    write_ranges(ay, vy, ranges[1])
    places[0] = first
    count, open_legs = 1, 1
    waiting[0, START], waiting[0, END] = first, last
    while open_legs > 0:
        start, end = waiting[open_legs - 1, START], waiting[open_legs - 1, END]
        place = _furthest(ax, ay, vx, vy, ranges, start, end, tolerance)
        count, open_legs = cut_or_keep(place, waiting, open_legs, places, count)
    return count


@kernel
def _furthest(
    ax: NDArray[np.float64], ay: NDArray[np.float64], vx: NDArray[np.float64], vy: NDArray[np.float64],
    ranges: NDArray[np.float64], start: float, end: float, tolerance: float,
) -> float:  # fmt: skip
    """Return where the velocity is furthest from the leg between two places; not a number where it is nowhere by more than the tolerance."""
    origin = plane_velocity_at(ax, ay, vx, vy, start)
    slope = times(1.0 / (end - start), plane_velocity_at(ax, ay, vx, vy, end) - origin)
    of_x, of_y = slope.real, slope.imag
    x, y = origin.real - start * of_x, origin.imag - start * of_y
    low, high = int(start), min(math.ceil(end), vx.size - 1)
    found, furthest = math.nan, tolerance
    i = low
    while i < high:
        block = i // BLOCK
        last = min((block + 1) * BLOCK, high)
        # most blocks are nowhere as far as one before
        far_x = most_within(ranges[0], block, x + i * of_x, x + last * of_x)
        far_y = most_within(ranges[1], block, y + i * of_y, y + last * of_y)
        if far_x * far_x + far_y * far_y <= furthest * furthest:
            i = last
            continue
        dx, dy = vx[i] - x - i * of_x, vy[i] - y - i * of_y
        before = dx * dx + dy * dy
        for j in range(i, last):
            away = complex(dx, dy)
            dx, dy = vx[j + 1] - x - (j + 1) * of_x, vy[j + 1] - y - (j + 1) * of_y
            after = dx * dx + dy * dy
            least = furthest - BEYOND * (abs(ax[j + 1] - ax[j]) + abs(ay[j + 1] - ay[j]))
            largest = max(before, after)
            before = after
            if least > 0.0 and largest < least * least:
                continue
            here, there = complex(ax[j], ay[j]) - slope, complex(ax[j + 1], ay[j + 1]) - slope
            share = _extreme_within(away, here, there)
            if share < 0.0:
                continue
            distance = length_of(away + times(share, here) + times(0.5 * share * share, there - here))
            if start < j + share < end and distance > furthest:
                found, furthest = j + share, distance
        i = last
    return found


@kernel
def _extreme_within(away: complex, here: complex, there: complex) -> float:
    """Return where in an interval a distance from a leg is extreme, as a part of it; below zero where it is nowhere.

    It begins as the vector `away`, which changes at the rates `here` at its start and `there` at its end.
    """
    end = away + times(0.5, here + there)
    growing = dot(away, here)
    if growing * dot(end, there) > 0.0:
        return -1.0
    low, high = 0.0, 1.0
    for _ in range(_HALVINGS):
        share = 0.5 * (low + high)
        vector = away + times(share, here) + times(0.5 * share * share, there - here)
        if growing * dot(vector, here + times(share, there - here)) > 0.0:
            low = share
        else:
            high = share
    return 0.5 * (low + high)


@kernel
def plane_peak_of(
    ax: NDArray[np.float64], ay: NDArray[np.float64], vx: NDArray[np.float64], vy: NDArray[np.float64]
) -> float:
    """Return the largest amount of the velocity, between samples too [mm/s]."""
    highest = 0
    largest = -1.0
    for i in range(vx.size):
        square = vx[i] * vx[i] + vy[i] * vy[i]
        if square > largest:
            largest, highest = square, i
    peak = math.sqrt(largest)
    for i in range(max(highest - 1, 0), min(highest + 1, vx.size - 1)):
        away, here, there = complex(vx[i], vy[i]), complex(ax[i], ay[i]), complex(ax[i + 1], ay[i + 1])
        share = max(_extreme_within(away, here, there), 0.0)
        peak = max(peak, length_of(away + times(share, here) + times(0.5 * share * share, there - here)))
    return peak


@kernel
def move_plane_nodes(
    ax: NDArray[np.float64], ay: NDArray[np.float64], vx: NDArray[np.float64], vy: NDArray[np.float64],
    places: NDArray[np.float64], work: NDArray[np.float64],
) -> None:  # fmt: skip
    """Move the nodes between the ends to where the straight lines are closest to each other that fit the velocity along each leg by itself."""
    for k in range(places.size - 1):
        work[k, FROM_X], work[k, TO_X] = leg_line(ax, vx, places[k], places[k + 1])
        work[k, FROM_Y], work[k, TO_Y] = leg_line(ay, vy, places[k], places[k + 1])
    start = places[0]  # of the leg before, as its line was fitted
    for k in range(1, places.size - 1):
        here = places[k]
        before, after = here - start, places[k + 1] - here
        came = complex(work[k - 1, TO_X], work[k - 1, TO_Y])
        goes = complex(work[k, FROM_X], work[k, FROM_Y])
        change = times(1.0 / before, came - complex(work[k - 1, FROM_X], work[k - 1, FROM_Y])) - times(
            1.0 / after, complex(work[k, TO_X], work[k, TO_Y]) - goes
        )
        square = dot(change, change)
        if square > 0.0:
            move = dot(goes - came, change) / square
            places[k] += max(-FURTHEST_MOVE * before, min(move, FURTHEST_MOVE * after))
        start = here

"""Nodes of a ground velocity in the plane: as of `dcfp.kernels.nodes`, with vectors, so that they do not depend on where x and y point."""

import math

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel
from dcfp.kernels.nodes import (
    ALMOST,
    BEYOND,
    BLOCK,
    END,
    FURTHEST_MOVE,
    START,
    bow_between,
    cut_or_keep,
    leg_line,
    velocity_at,
)
from dcfp.kernels.plane_step import dot, length_of, times

#: Columns of what the search for better places works in: the velocity at both ends of a leg's own straight line, by direction.
FROM_X, FROM_Y, TO_X, TO_Y, MOVE_SIZE = range(5)
#: How often at most, and how closely, it is looked where in an interval a distance is extreme.
_ROUNDS, _CLOSE = 60, 1e-12


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
    bows: NDArray[np.float64], waiting: NDArray[np.float64], places: NDArray[np.float64],
) -> int:  # fmt: skip
    """Write the places of the nodes between two samples, as `choose_nodes` does; the distance is that of the vectors."""
    _write_bows(ax, ay, vx, vy, bows)
    places[0] = first
    count, open_legs = 1, 1
    waiting[0, START], waiting[0, END] = first, last
    while open_legs > 0:
        start, end = waiting[open_legs - 1, START], waiting[open_legs - 1, END]
        place = _furthest(ax, ay, vx, vy, bows, start, end, tolerance)
        count, open_legs = cut_or_keep(place, waiting, open_legs, places, count)
    return count


@kernel
def _write_bows(
    ax: NDArray[np.float64], ay: NDArray[np.float64], vx: NDArray[np.float64], vy: NDArray[np.float64],
    bows: NDArray[np.float64],
) -> None:  # fmt: skip
    """Write how far the velocity is at most from the chord of every block of intervals [mm/s]."""
    for block in range(bows.size):
        first, last = block * BLOCK, min((block + 1) * BLOCK, vx.size - 1)
        over = 1.0 / (last - first)
        of_x, of_y = over * (vx[last] - vx[first]), over * (vy[last] - vy[first])
        away, bend = 0.0, 0.0
        place = 0.0
        for i in range(first, last):
            dx, dy = vx[i] - vx[first] - of_x * place, vy[i] - vy[first] - of_y * place
            place += 1.0
            away = max(away, dx * dx + dy * dy)
            bend = max(bend, abs(ax[i + 1] - ax[i]) + abs(ay[i + 1] - ay[i]))
        bows[block] = math.sqrt(away) + BEYOND * bend


@kernel
def _furthest(
    ax: NDArray[np.float64], ay: NDArray[np.float64], vx: NDArray[np.float64], vy: NDArray[np.float64],
    bows: NDArray[np.float64], start: float, end: float, tolerance: float,
) -> float:  # fmt: skip
    """Return where the velocity is furthest from the leg between two places; not a number where it is nowhere by more than the tolerance."""
    origin = plane_velocity_at(ax, ay, vx, vy, start)
    slope = times(1.0 / (end - start), plane_velocity_at(ax, ay, vx, vy, end) - origin)
    of_x, of_y = slope.real, slope.imag
    x, y = origin.real - start * of_x, origin.imag - start * of_y
    low, high = int(start), min(math.ceil(end), vx.size - 1)
    # what is closer than the end of a block is not where it is furthest
    square = 0.0
    for i in range((low // BLOCK + 1) * BLOCK, high, BLOCK):
        dx, dy = vx[i] - x - i * of_x, vy[i] - y - i * of_y
        square = max(square, dx * dx + dy * dy)
    found, furthest = math.nan, tolerance
    least = max(tolerance, ALMOST * math.sqrt(square))
    dx, dy = vx[low] - x - low * of_x, vy[low] - y - low * of_y
    after = dx * dx + dy * dy
    first = low
    while first < high:
        last = min((first // BLOCK + 1) * BLOCK, high)
        before = after
        dx, dy = vx[last] - x - last * of_x, vy[last] - y - last * of_y
        after = dx * dx + dy * dy
        within = least - bow_between(bows, first, last)
        if within <= 0.0 or max(before, after) > within * within:
            dx, dy = vx[first] - x - first * of_x, vy[first] - y - first * of_y
            for j in range(first, last):
                away, nearer = complex(dx, dy), dx * dx + dy * dy
                dx, dy = vx[j + 1] - x - (j + 1) * of_x, vy[j + 1] - y - (j + 1) * of_y
                within = least - BEYOND * (abs(ax[j + 1] - ax[j]) + abs(ay[j + 1] - ay[j]))
                if within > 0.0 and max(nearer, dx * dx + dy * dy) < within * within:
                    continue
                here, there = complex(ax[j], ay[j]) - slope, complex(ax[j + 1], ay[j + 1]) - slope
                share = _extreme_within(away, here, there)
                if share < 0.0:
                    continue
                distance = length_of(away + times(share, here) + times(0.5 * share * share, there - here))
                if start < j + share < end and distance > furthest:
                    found, furthest = j + share, distance
                    least = max(least, ALMOST * distance)
        first = last
    return found


@kernel
def _extreme_within(away: complex, here: complex, there: complex) -> float:
    """Return where in an interval a distance from a leg is extreme, as a part of it; below zero where it is nowhere.

    It begins as the vector `away`, which changes at the rates `here` at its start and `there` at its end.
    """
    growing, bend = dot(away, here), times(0.5, there - here)
    ends = dot(away + here + bend, there)
    if growing * ends > 0.0:
        return -1.0
    # half of the rate of its square is a cubic
    first, second, third = (
        dot(here, here) + 2.0 * dot(away, bend),
        3.0 * dot(here, bend),
        2.0 * dot(bend, bend),
    )
    low, high = 0.0, 1.0
    share = growing / (growing - ends) if growing != ends else 0.0
    for _ in range(_ROUNDS):
        rate = growing + share * (first + share * (second + share * third))
        if growing * rate > 0.0:
            low = share
        else:
            high = share
        before = share
        share -= rate / (first + share * (2.0 * second + share * 3.0 * third))
        if not low <= share <= high:
            share = 0.5 * (low + high)
        if abs(share - before) < _CLOSE:
            break
    return share


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
    sums: NDArray[np.float64], places: NDArray[np.float64], work: NDArray[np.float64],
) -> None:  # fmt: skip
    """Move the nodes between the ends to where the straight lines are closest to each other that fit the velocity along each leg by itself."""
    for k in range(places.size - 1):
        work[k, FROM_X], work[k, TO_X] = leg_line(ax, vx, sums[0], places[k], places[k + 1])
        work[k, FROM_Y], work[k, TO_Y] = leg_line(ay, vy, sums[1], places[k], places[k + 1])
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

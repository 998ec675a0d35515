"""Nodes of a ground velocity: a line of straight legs that follows it, after Douglas and Peucker (1973), fitted to it by least squares.

The ground's acceleration is linear between samples, so that its velocity is a parabola there. Nodes lie anywhere on it, not at samples only, and the fit is of the curve itself:
neither depends on where the motion was sampled.
"""

import math

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel

#: Columns of what the search works in: ends of a leg that is still to be looked at.
START, END, WAITING_SIZE = range(3)
#: Columns of what the fit works in: main diagonal and the one beside it; or the velocities at both ends of a leg's own straight line.
_DIAGONAL, _BESIDE, FIT_SIZE = range(3)
_FROM, _TO = _DIAGONAL, _BESIDE
#: Intervals in a block of which the whole is known: how far the velocity is from a straight line there, and its integrals.
BLOCK = 16
#: How far a parabola is from its chord at most, over the change of its rate [-].
BEYOND = 0.125
#: Part of a distance that is more than rounding.
ALMOST = 1.0 - 1e-9
#: Columns of the integrals from the start of a block to the end of an interval: of the velocity, of it times the place from there, and of its square.
WHOLE, RISING, SQUARE, SUMS = range(4)
# a multiplication is quicker than a division
_SIXTH, _EIGHTH = 1.0 / 6.0, 1.0 / 8.0
#: How far a node is moved at once, over the leg that becomes shorter [-].
FURTHEST_MOVE = 0.25


@kernel
def moving(acceleration: NDArray[np.float64]) -> tuple[int, int]:
    """Return the last sample at which the ground has not begun to accelerate, and the first at which it has ceased; the other way round where it is never."""
    size = acceleration.size
    first, last = 0, size - 1
    while first < size and acceleration[first] == 0.0:
        first += 1
    while last >= 0 and acceleration[last] == 0.0:
        last -= 1
    return max(first - 1, 0), min(last + 1, size - 1)


@kernel
def peak_of(acceleration: NDArray[np.float64], velocity: NDArray[np.float64]) -> float:
    """Return the largest amount of the velocity, between samples too [mm/s]; accelerations are in mm/s per sample."""
    peak = 0.0
    for sign in (1.0, -1.0):
        highest = 0
        for i in range(velocity.size):
            if sign * velocity[i] > sign * velocity[highest]:
                highest = i
        place = _extreme_beside(acceleration, highest, 0.0, sign)
        peak = max(peak, sign * velocity_at(acceleration, velocity, place))
    return peak


@kernel
def choose_nodes(
    acceleration: NDArray[np.float64],
    velocity: NDArray[np.float64],
    first: int,
    last: int,
    tolerance: float,
    bows: NDArray[np.float64],
    waiting: NDArray[np.float64],
    places: NDArray[np.float64],
) -> int:
    """Write the places of the nodes between two samples, ends included, counted in samples; return their number.

    A leg is cut where the velocity is furthest from it, until nowhere is by more than `tolerance` [mm/s]. Accelerations are in mm/s per sample.
    `waiting` and `places` need as many rows as there can be nodes; nothing is cut any more where they are full. `bows`, one for each block, is worked in.
    """
    _write_bows(acceleration, velocity, bows)
    places[0] = first
    count, open_legs = 1, 1
    waiting[0, START], waiting[0, END] = first, last
    while open_legs > 0:
        start, end = waiting[open_legs - 1, START], waiting[open_legs - 1, END]
        place = _furthest(acceleration, velocity, bows, start, end, tolerance)
        count, open_legs = cut_or_keep(place, waiting, open_legs, places, count)
    return count


@kernel
def _write_bows(
    acceleration: NDArray[np.float64], velocity: NDArray[np.float64], bows: NDArray[np.float64]
) -> None:
    """Write how far the velocity is at most from the chord of every block of intervals [mm/s]."""
    for block in range(bows.size):
        first, last = block * BLOCK, min((block + 1) * BLOCK, velocity.size - 1)
        rate = (velocity[last] - velocity[first]) / (last - first)
        away, bend, place = 0.0, 0.0, 0.0
        for i in range(first, last):
            away = max(away, abs(velocity[i] - velocity[first] - rate * place))
            place += 1.0
            bend = max(bend, abs(acceleration[i + 1] - acceleration[i]))
        bows[block] = away + BEYOND * bend


@kernel
def bow_between(bows: NDArray[np.float64], first: int, last: int) -> float:
    """Return how far the velocity is at most from its chord between two samples of one block [mm/s]."""
    bow = bows[first // BLOCK]
    # the ends of the chord of a part may be beside that of the whole
    return bow if last - first == BLOCK else 2.0 * bow


@kernel
def cut_or_keep(
    place: float, waiting: NDArray[np.float64], open_legs: int, places: NDArray[np.float64], count: int
) -> tuple[int, int]:
    """Cut the last waiting leg at a place, or keep it where that is not a number or there is no more room; return the numbers of nodes and of waiting legs then."""
    last = open_legs - 1
    start, end = waiting[last, START], waiting[last, END]
    if math.isnan(place) or count + open_legs >= places.size:
        places[count] = end
        return count + 1, last
    waiting[last, START] = place
    waiting[open_legs, START], waiting[open_legs, END] = start, place
    return count, open_legs + 1


@kernel
def _furthest(
    acceleration: NDArray[np.float64],
    velocity: NDArray[np.float64],
    bows: NDArray[np.float64],
    start: float,
    end: float,
    tolerance: float,
) -> float:
    """Return where the velocity is furthest from the straight leg between two places; not a number where it is nowhere by more than the tolerance."""
    from_velocity = velocity_at(acceleration, velocity, start)
    slope = (velocity_at(acceleration, velocity, end) - from_velocity) / (end - start)
    low, high = int(start), min(math.ceil(end), velocity.size - 1)
    # what is closer than the end of a block is not where it is furthest
    least = tolerance
    for i in range((low // BLOCK + 1) * BLOCK, high, BLOCK):
        least = max(least, ALMOST * abs(velocity[i] - from_velocity - slope * (i - start)))
    found, furthest = math.nan, tolerance
    first = low
    while first < high:
        last = min((first // BLOCK + 1) * BLOCK, high)
        before = abs(velocity[first] - from_velocity - slope * (first - start))
        after = abs(velocity[last] - from_velocity - slope * (last - start))
        if max(before, after) + bow_between(bows, first, last) > least:
            for i in range(first, last):
                # it is extreme where the acceleration is the slope of the leg
                here, there = acceleration[i] - slope, acceleration[i + 1] - slope
                distance = velocity[i] - from_velocity - slope * (i - start)
                if abs(distance) + 0.5 * abs(here) <= least or here * there > 0.0:
                    continue
                share = here / (here - there) if here != there else 0.0
                distance = abs(distance + 0.5 * here * share)
                if start < i + share < end and distance > furthest:
                    found, furthest = i + share, distance
                    least = max(least, ALMOST * distance)
        first = last
    return found


@kernel
def _extreme_beside(acceleration: NDArray[np.float64], sample: int, slope: float, sign: float) -> float:
    """Return where the distance from a leg is extreme in the interval before or after the sample at which it is largest."""
    rate = acceleration[sample] - slope
    beside = sample + 1 if sign * rate > 0.0 else sample - 1
    if rate == 0.0 or beside < 0 or beside >= acceleration.size:
        return sample
    other = acceleration[beside] - slope
    if rate * other >= 0.0:
        return sample
    return sample + (beside - sample) * rate / (rate - other)


@kernel
def velocity_at(acceleration: NDArray[np.float64], velocity: NDArray[np.float64], place: float) -> float:
    """Return the velocity at a place, counted in samples, between which it is a parabola [mm/s]; accelerations in mm/s per sample."""
    i = min(int(place), velocity.size - 2)
    share = place - i
    return velocity[i] + share * (acceleration[i] + 0.5 * share * (acceleration[i + 1] - acceleration[i]))


@kernel
def write_sums(
    acceleration: NDArray[np.float64], velocity: NDArray[np.float64], sums: NDArray[np.float64]
) -> None:
    """Write the integrals of the velocity from the start of its block to the end of every interval, shape (intervals, SUMS) [mm/s times samples].

    They begin anew with every block, so that differences of them keep their digits.
    """
    for origin in range(0, velocity.size - 1, BLOCK):
        whole, rising, square, place = 0.0, 0.0, 0.0, 0.0
        for i in range(origin, min(origin + BLOCK, velocity.size - 1)):
            # of a parabola from sample to sample, and of it times the place
            v, a, b = velocity[i], acceleration[i], acceleration[i + 1]
            part = v + (_SIXTH * b + 2.0 * _SIXTH * a)
            whole += part
            rising += place * part + (0.5 * v + (_EIGHTH * b + 5.0 / 3.0 * _EIGHTH * a))
            square += _square_of(v, a, b - a)
            place += 1.0
            sums[i, WHOLE], sums[i, RISING], sums[i, SQUARE] = whole, rising, square


@kernel
def move_nodes(
    acceleration: NDArray[np.float64],
    velocity: NDArray[np.float64],
    sums: NDArray[np.float64],
    places: NDArray[np.float64],
    work: NDArray[np.float64],
) -> None:
    """Move the nodes between the ends to where the straight lines meet that are closest to the velocity along each leg by itself."""
    for k in range(places.size - 1):
        work[k, _FROM], work[k, _TO] = leg_line(acceleration, velocity, sums, places[k], places[k + 1])
    start = places[0]  # of the leg before, as its line was fitted
    for k in range(1, places.size - 1):
        here = places[k]
        before, after = here - start, places[k + 1] - here
        change = (work[k - 1, _TO] - work[k - 1, _FROM]) / before - (work[k, _TO] - work[k, _FROM]) / after
        if change != 0.0:
            move = (work[k, _FROM] - work[k - 1, _TO]) / change
            places[k] += max(-FURTHEST_MOVE * before, min(move, FURTHEST_MOVE * after))
        start = here


@kernel
def fit_nodes(
    acceleration: NDArray[np.float64],
    velocity: NDArray[np.float64],
    sums: NDArray[np.float64],
    places: NDArray[np.float64],
    work: NDArray[np.float64],
    fitted: bool,
    ordinates: NDArray[np.float64],
) -> None:
    """Write the velocities at the nodes [mm/s]: of the ground there, or with which the straight legs are closest to it by least squares of the integral.

    The nodes' hat functions overlap with their neighbours' only, so that the normal equations are tridiagonal.
    """
    count = places.size
    if not fitted:
        for k in range(count):
            ordinates[k] = velocity_at(acceleration, velocity, places[k])
        return
    for k in range(count):
        ordinates[k] = work[k, _DIAGONAL] = work[k, _BESIDE] = 0.0
    for k in range(count - 1):
        length = places[k + 1] - places[k]
        left, right, _ = _moments(acceleration, velocity, sums, places[k], places[k + 1])
        ordinates[k] += left
        ordinates[k + 1] += right
        work[k, _DIAGONAL] += length / 3.0
        work[k + 1, _DIAGONAL] += length / 3.0
        work[k, _BESIDE] = length / 6.0
    for k in range(1, count):
        factor = work[k - 1, _BESIDE] / work[k - 1, _DIAGONAL]
        work[k, _DIAGONAL] -= factor * work[k - 1, _BESIDE]
        ordinates[k] -= factor * ordinates[k - 1]
    for k in range(count - 1, -1, -1):
        if k < count - 1:
            ordinates[k] -= work[k, _BESIDE] * ordinates[k + 1]
        ordinates[k] /= work[k, _DIAGONAL]


@kernel
def leg_line(
    acceleration: NDArray[np.float64],
    velocity: NDArray[np.float64],
    sums: NDArray[np.float64],
    start: float,
    end: float,
) -> tuple[float, float]:
    """Return the velocities at both ends of the straight line that is closest to the velocity along a leg by itself [mm/s]."""
    left, right, _ = _moments(acceleration, velocity, sums, start, end)
    over = 2.0 / (end - start)
    return over * (2.0 * left - right), over * (2.0 * right - left)


@kernel
def _moments(
    acceleration: NDArray[np.float64],
    velocity: NDArray[np.float64],
    sums: NDArray[np.float64],
    start: float,
    end: float,
) -> tuple[float, float, float]:
    """Return the integrals of the velocity along a leg, weighted by what falls and what rises along it from 0 to 1 [mm/s times samples], and of its square."""
    low, high = math.ceil(start), int(end)
    if low > high:
        whole, rising, square = _part(acceleration, velocity, start, end, start)
    else:
        whole, rising, square = _part(acceleration, velocity, start, low, start)
        first = low
        while first < high:
            origin = first // BLOCK * BLOCK
            last = min(origin + BLOCK, high)
            part, moment = sums[last - 1, WHOLE], sums[last - 1, RISING]
            square += sums[last - 1, SQUARE]
            if first > origin:
                part, moment = part - sums[first - 1, WHOLE], moment - sums[first - 1, RISING]
                square -= sums[first - 1, SQUARE]
            whole += part
            rising += moment + (origin - start) * part
            first = last
        part, moment, rest = _part(acceleration, velocity, high, end, start)
        whole += part
        rising += moment
        square += rest
    rising /= end - start
    return whole - rising, rising, square


@kernel
def squares_beside(
    acceleration: NDArray[np.float64],
    velocity: NDArray[np.float64],
    sums: NDArray[np.float64],
    places: NDArray[np.float64],
    ordinates: NDArray[np.float64],
) -> tuple[float, float]:
    """Return the integrals of the square of the velocity beside the legs, and of its own square, from the first node to the last [mm2/s2 times samples]."""
    beside = own = 0.0
    for k in range(places.size - 1):
        left, right, square = _moments(acceleration, velocity, sums, places[k], places[k + 1])
        begin, end = ordinates[k], ordinates[k + 1]
        of_leg = (places[k + 1] - places[k]) * (begin * begin + begin * end + end * end) / 3.0
        beside += square - 2.0 * (begin * left + end * right) + of_leg
        own += square
    return max(beside, 0.0), own


@kernel
def _square_of(start: float, rate: float, bend: float) -> float:
    """Return the integral from 0 to 1 of the square of ``start`` + ``rate`` s + ``bend`` s2 / 2."""
    return (
        start * (start + rate)
        + 2.0 * _SIXTH * (rate * rate + start * bend)
        + bend * (0.25 * rate + 0.05 * bend)
    )


@kernel
def _part(
    acceleration: NDArray[np.float64], velocity: NDArray[np.float64], begin: float, end: float, origin: float
) -> tuple[float, float, float]:
    """Return the integrals over a part of an interval of the velocity, of it times the place from the origin on, and of its square."""
    middle = 0.5 * (begin + end)
    first = velocity_at(acceleration, velocity, begin)
    second = 4.0 * velocity_at(acceleration, velocity, middle)
    third = velocity_at(acceleration, velocity, end)
    # Simpson's rule is exact for a cubic
    whole = first + second + third
    moment = (begin - origin) * first + (middle - origin) * second + (end - origin) * third
    bend = 4.0 * (first + third) - 2.0 * second
    square = _square_of(first, third - first - 0.5 * bend, bend)
    return (end - begin) / 6.0 * whole, (end - begin) / 6.0 * moment, (end - begin) * square

"""The largest displacement of elastic oscillators under two components, in every direction of half a turn.

The displacement in a direction is the projection of that in the plane, and turns where the velocity is at a right angle to the direction: in each step only
those directions are looked at that the velocity turns past. Most steps cannot change anything and are left out, for which an oscillator goes through the
record twice. The first time the points of its orbit that are furthest in a few directions are found, whose polygon with its mirror image is within what
every direction reaches in the end; the second time only steps count that touch its outside, by as much as a displacement may rise between two samples.
"""

import math

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel
from dcfp.kernels.oscillator import angle_of, furthest, passed, stepped

#: Directions in which the furthest points are looked for.
SECTORS = 6
#: The polygon is made smaller by so much, so that its corners are outside of it [-].
_WITHIN = 1e-9
#: Width of the polygon over its length below which the orbit is taken for a line, which has no inside [-].
_THIN = 1e-6
# rows of what is worked with, by sector: the furthest point with how far it is, and the normal of a side of the polygon over its distance from the middle
_FAR, _CORNER_U, _CORNER_W, _NORMAL_U, _NORMAL_W, WORKED = range(6)


@kernel
def _find_corners(
    coefficients: NDArray[np.float64],
    j: int,
    acceleration: NDArray[np.float64],
    directions: NDArray[np.float64],
    every: int,
    work: NDArray[np.float64],
) -> None:
    """Find the points of the orbit that are furthest in a few directions, at `every` so many samples."""
    apart = directions.shape[0] // SECTORS
    work[:] = 0.0
    u, v, w, z, wait = 0.0, 0.0, 0.0, 0.0, every
    for i in range(acceleration.shape[0] - 1):
        a, b = acceleration[i, 0], acceleration[i, 1]
        u, v = stepped(coefficients, j, u, v, a, acceleration[i + 1, 0] - a)
        w, z = stepped(coefficients, j, w, z, b, acceleration[i + 1, 1] - b)
        wait -= 1
        if wait == 0:
            wait = every
            for n in range(SECTORS):
                along = directions[n * apart, 0] * u + directions[n * apart, 1] * w
                if abs(along) > work[_FAR, n]:
                    side = 1.0 if along > 0.0 else -1.0
                    work[_FAR, n], work[_CORNER_U, n], work[_CORNER_W, n] = abs(along), side * u, side * w


@kernel
def _set_sides(slack: NDArray[np.float64], j: int, work: NDArray[np.float64]) -> bool:
    """Set the sides of the polygon, moved inwards by the slack; return whether anything is left of it."""
    furthest_of_all = 0.0
    for n in range(SECTORS):
        furthest_of_all = max(furthest_of_all, work[_FAR, n])
    for n in range(SECTORS):
        u, w = work[_CORNER_U, n], work[_CORNER_W, n]
        # beyond the last corner comes the first again, on the other side
        turned, after = (1.0, n + 1) if n + 1 < SECTORS else (-1.0, 0)
        x, y = turned * work[_CORNER_W, after] - w, u - turned * work[_CORNER_U, after]
        length = math.hypot(x, y)
        if length > 0.0:
            away = ((x * u + y * w) / length - slack[1, j]) / (1.0 + slack[0, j]) * (1.0 - _WITHIN)
            if not away > _THIN * furthest_of_all:
                return False
            x, y = x / (length * away), y / (length * away)
        work[_NORMAL_U, n], work[_NORMAL_W, n] = x, y
    return furthest_of_all > 0.0


@kernel
def _is_outside(work: NDArray[np.float64], u: float, w: float) -> bool:
    sides = 0
    for n in range(SECTORS):
        sides += abs(work[_NORMAL_U, n] * u + work[_NORMAL_W, n] * w) > 1.0
    return sides > 0


@kernel
def _note_step(
    before: tuple[float, float, float, float],
    after: tuple[float, float, float, float],
    step: float | None,
    directions: NDArray[np.float64],
    is_last: bool,
    peaks: NDArray[np.float64],
    j: int,
) -> None:
    """Note the largest displacement in a step in the directions in which it turns; in the last step in all, for it may still move outwards."""
    count = directions.shape[0]
    u, v, w, z = before
    next_u, next_v, next_w, next_z = after
    low, high = passed(angle_of(v, z), angle_of(next_v, next_z), count)
    if is_last:
        high = low + count
    for place in range(math.ceil(low), math.floor(high) + 1):
        k = place % count
        x, y = directions[k, 0], directions[k, 1]
        start_u, end_u = x * u + y * w, x * next_u + y * next_w
        most = max(abs(start_u), abs(end_u))
        if step is not None:
            most = max(most, furthest(start_u, x * v + y * z, end_u, x * next_v + y * next_z, step))
        peaks[j, k] = max(peaks[j, k], most)


@kernel
def respond_in_all_directions(
    coefficients: NDArray[np.float64],
    step: float | None,
    acceleration: NDArray[np.float64],
    directions: NDArray[np.float64],
    slack: NDArray[np.float64],
    every: NDArray[np.int64],
    work: NDArray[np.float64],
    peaks: NDArray[np.float64],
) -> None:
    """Take every oscillator through the samples of two components, shape (n, 2) [mm/s2]; note its largest displacement in every direction.

    `coefficients` are those of `dcfp.kernels.oscillator`. `directions` are unit vectors over half a turn, at equal angles, shape (directions, 2). `slack` is
    by how much a displacement between two samples may be larger than at both, shape (2, oscillators): its ratio [-] and then a length [mm]. The furthest
    points are looked for at `every` so many samples, shape (oscillators,). `work`, shape (WORKED, SECTORS), is worked with. `peaks`, shape (oscillators,
    directions), begin with zeros. Without a `step`, as numba knows when it compiles, only the samples are looked at.
    """
    last = acceleration.shape[0] - 1
    for j in range(peaks.shape[0]):
        _find_corners(coefficients, j, acceleration, directions, every[j], work)
        always = not _set_sides(slack, j, work)
        u, v, w, z, was_outside = 0.0, 0.0, 0.0, 0.0, always
        for i in range(last):
            a, b = acceleration[i, 0], acceleration[i, 1]
            next_u, next_v = stepped(coefficients, j, u, v, a, acceleration[i + 1, 0] - a)
            next_w, next_z = stepped(coefficients, j, w, z, b, acceleration[i + 1, 1] - b)
            outside = always or _is_outside(work, next_u, next_w)
            if outside or was_outside or i == last - 1:
                before, after = (u, v, w, z), (next_u, next_v, next_w, next_z)
                _note_step(before, after, step, directions, i == last - 1, peaks, j)
            u, v, w, z, was_outside = next_u, next_v, next_w, next_z, outside

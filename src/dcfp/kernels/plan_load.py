"""Vertical loads of the bearings under a rigid slab: the plane that balances the weight and the moments, with bearings that lift off where they would pull."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import called_kernel
from dcfp.kernels.plan_bearing import STATIC, Bearings, X, Y

#: Times that the bearings in contact are looked for.
_MOST_TRIES = 60
#: Part of the square of the sum of the spreads below which bearings stand on one line.
_ON_A_LINE = 1e-9


class Slab(NamedTuple):
    """How the slab passes its weight on."""

    weight: float  # sum of the static loads [N]
    own_weight: float  # of the slab without the floors [N]
    moment_x: float  # sum of static loads times X, Y [N mm]
    moment_y: float
    compliance: NDArray[np.float64]  # (3, 3): from a force and two moments to the plane a + b X + c Y
    needed_contacts: int  # 3, or 2 of bearings on one line, or 1 where all stand in one point
    leverage: float  # largest change of a load over the mean of all, of a moment [1/(N mm)]
    height: float  # at which the slab's own inertia acts [mm]


@called_kernel
def share_loads(b: Bearings, slab: Slab, column: int, ratio: float, tip_x: float, tip_y: float) -> bool:
    """Write the load of every bearing [N] into a `column` of the trial: of `ratio` times the weight, and moments that press where X and Y are large [N mm].

    Return False where nothing balances them, so that all lift off.
    """
    count = b.constants.shape[0]
    c = slab.compliance
    rise, lean_x, lean_y = (
        c[0, 1] * tip_x + c[0, 2] * tip_y,
        c[1, 1] * tip_x + c[1, 2] * tip_y,
        c[2, 1] * tip_x + c[2, 2] * tip_y,
    )
    least = 1.0
    for i in range(count):
        one = b.constants[i]
        load = ratio * one[STATIC] + rise + lean_x * one[X] + lean_y * one[Y]
        b.trial[i, column] = load
        least = min(least, load)
    if least >= 0.0:
        return True
    fits = ratio > 0.0
    for _ in range(_MOST_TRIES):
        if not fits:
            break
        n, sx, sy, xx, xy, yy, w, wx, wy = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
        for i in range(count):
            if b.trial[i, column] > 0.0:
                x, y, own = b.constants[i, X], b.constants[i, Y], ratio * b.constants[i, STATIC]
                n, sx, sy = n + 1.0, sx + x, sy + y
                xx, xy, yy = xx + x * x, xy + x * y, yy + y * y
                w, wx, wy = w + own, wx + own * x, wy + own * y
        if n < slab.needed_contacts:
            fits = False
            break
        # about the middle of those in contact
        mx, my = sx / n, sy / n
        force = ratio * slab.weight - w
        turn_x = ratio * slab.moment_x + tip_x - wx - mx * force
        turn_y = ratio * slab.moment_y + tip_y - wy - my * force
        xx, xy, yy = xx - mx * sx, xy - mx * sy, yy - my * sy
        det, both = xx * yy - xy * xy, xx + yy
        lean_x, lean_y = 0.0, 0.0
        if slab.needed_contacts == 3:
            if det <= _ON_A_LINE * both * both:
                fits = False
                break
            lean_x, lean_y = (yy * turn_x - xy * turn_y) / det, (xx * turn_y - xy * turn_x) / det
        elif slab.needed_contacts == 2:
            # nothing balances what tips across the line
            lean_x = (xx * turn_x + xy * turn_y) / (both * both)
            lean_y = (xy * turn_x + yy * turn_y) / (both * both)
        rise = force / n - lean_x * mx - lean_y * my
        changed = False
        for i in range(count):
            one = b.constants[i]
            load = ratio * one[STATIC] + rise + lean_x * one[X] + lean_y * one[Y]
            changed = changed or (load > 0.0) != (b.trial[i, column] > 0.0)
            b.trial[i, column] = load
        if not changed:
            break
    for i in range(count):
        b.trial[i, column] = max(b.trial[i, column], 0.0) if fits else 0.0
    return fits

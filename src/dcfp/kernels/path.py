"""One interval of a prescribed path: a cubic displacement under a vertical load that changes linearly."""

import math
from typing import NamedTuple

from dcfp.kernels._jit import kernel


class Piece(NamedTuple):
    """One interval; time in it starts from zero.

    The displacement is ``displacement`` + ``velocity`` t + ``second`` t2 + ``third`` t3.
    """

    displacement: float  # [mm]
    velocity: float  # [mm/s]
    second: float  # [mm/s2]
    third: float  # [mm/s3]
    load: float  # vertical force [N]
    load_rate: float  # [N/s]
    reference: float  # of the friction law at the pressure of this load [-]
    reference_rate: float  # [1/s]


@kernel
def displacement_at(piece: Piece, time: float) -> float:
    """Displacement [mm]."""
    return piece.displacement + time * (piece.velocity + time * (piece.second + time * piece.third))


@kernel
def velocity_at(piece: Piece, time: float) -> float:
    """Velocity [mm/s]."""
    return piece.velocity + time * (2.0 * piece.second + time * 3.0 * piece.third)


@kernel
def load_at(piece: Piece, time: float) -> float:
    """Vertical force [N]."""
    return piece.load + time * piece.load_rate


@kernel
def reference_at(piece: Piece, time: float) -> float:
    """Return the reference of the friction law [-]."""
    return piece.reference + time * piece.reference_rate


@kernel
def next_turn(piece: Piece, now: float, end: float) -> float:
    """First time after `now` and before `end` at which the velocity passes zero, or infinity."""
    a, b, c = 3.0 * piece.third, 2.0 * piece.second, piece.velocity
    earliest = math.inf
    near = now + 1e-9 * (end - now)
    if a == 0.0:
        root = -c / b if b != 0.0 else math.inf
        return root if near < root < end else math.inf
    under_root = b * b - 4.0 * a * c
    if under_root < 0.0:
        return math.inf
    q = -0.5 * (b + math.copysign(math.sqrt(under_root), b))
    for root in (q / a, c / q if q != 0.0 else math.inf):
        if near < root < end:
            earliest = min(earliest, root)
    return earliest


@kernel
def time_at(piece: Piece, now: float, end: float, target: float) -> float:
    """Time between `now` and `end`, where the displacement goes one way, at which it is `target` [mm].

    Newton's iteration inside a bracket.
    """
    low, high = now, end
    rising = displacement_at(piece, end) > displacement_at(piece, now)
    t = 0.5 * (low + high)
    for _ in range(60):
        away = displacement_at(piece, t) - target
        if (away > 0.0) == rising:
            high = t
        else:
            low = t
        rate = velocity_at(piece, t)
        better = t - away / rate if rate != 0.0 else low - 1.0
        if not low <= better <= high:
            better = 0.5 * (low + high)
        close = abs(better - t) < 1e-12 * (end - now)
        t = better
        if close:
            break
    return t

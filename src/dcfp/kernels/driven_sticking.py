"""One step of sticking along a prescribed path, until spring (b) reaches the yield surface."""

import math

from dcfp.kernels._jit import kernel
from dcfp.kernels.grip import Grip, Rig, Stroke, available, pendulum_work
from dcfp.kernels.heat_state import BETWEEN, ODD_LENGTH, PRESENT, Heat
from dcfp.kernels.heating import cool_down, expect_cooling, mix, prepare_cooling
from dcfp.kernels.law import Law
from dcfp.kernels.motion import Structure
from dcfp.kernels.path import Piece, displacement_at, load_at, next_turn

#: How close to the yield surface the start of sliding is found [mm].
_CLOSE = 1e-10
#: Part of a step within which what is outside of the surface was so from the start [-].
_AT_ONCE = 1e-3


@kernel
def stick_driven(
    law: Law,
    structure: Structure,
    rig: Rig,
    heat: Heat,
    piece: Piece,
    grip: Grip,
    now: float,
    room: float,
    interval: float,
) -> Stroke:
    """Stick for at most `room` [s], or until spring (b) reaches the yield surface."""
    length = room
    turn = next_turn(piece, now, now + room)
    if turn < now + room:
        length = turn - now
    place = 0 if length == interval else ODD_LENGTH
    prepare_cooling(heat, place, length)
    expect_cooling(heat, structure, place)
    start = displacement_at(piece, now)
    # spring (b) reaches the yield surface on the side that it moves to, unless the surface shrinks faster on the other one
    side = 1 if displacement_at(piece, now + length) >= start else -1
    slip = _slip_time(law, structure, rig, heat, piece, grip, side, now, length)
    behind = _slip_time(law, structure, rig, heat, piece, grip, -side, now, length)
    if behind < slip:
        slip, side = behind, -side
    slips = slip < length
    if slips:
        length = slip
    if length > 0.0:
        place = 0 if length == interval else ODD_LENGTH
        prepare_cooling(heat, place, length)
        cool_down(heat, structure, place)
    elongation = grip.elongation + displacement_at(piece, now + length) - start
    friction = available(law, structure, rig, heat, piece, now + length, PRESENT)
    if slips:
        friction = abs(elongation) * rig.elastic / load_at(piece, now + length)
    stored = 0.5 * rig.elastic * (elongation * elongation - grip.elongation * grip.elongation)
    work = stored + pendulum_work(rig, piece, now, length)
    return Stroke(Grip(elongation, side if slips else 0, friction), length, work, 0.0, True)


@kernel
def _excess(
    law: Law,
    structure: Structure,
    rig: Rig,
    heat: Heat,
    piece: Piece,
    grip: Grip,
    side: int,
    now: float,
    time: float,
    length: float,
) -> float:
    """How far spring (b) is beyond the yield surface on a side [mm], `time` [s] into a step of `length`."""
    mix(heat, structure, time / length, BETWEEN)
    t = now + time
    friction = available(law, structure, rig, heat, piece, t, BETWEEN)
    elongation = grip.elongation + displacement_at(piece, t) - displacement_at(piece, now)
    return side * elongation - friction * load_at(piece, t) / rig.elastic


@kernel
def _slip_time(
    law: Law,
    structure: Structure,
    rig: Rig,
    heat: Heat,
    piece: Piece,
    grip: Grip,
    side: int,
    now: float,
    length: float,
) -> float:
    """Time into the step of the slip on a side, by the Illinois method; infinity if there is none."""
    below = _excess(law, structure, rig, heat, piece, grip, side, now, 0.0, length)
    # it may begin on the surface, as closely as the temperature was expected: it slips where it goes further out
    outside = max(below, 0.0)
    beyond = _excess(law, structure, rig, heat, piece, grip, side, now, length, length) - outside
    if beyond <= 0.0:
        return math.inf
    low, high = 0.0, length
    below -= outside
    if below > -_CLOSE:  # on the surface: does it go further out at once, or does it first move away?
        low = _AT_ONCE * length
        below = _excess(law, structure, rig, heat, piece, grip, side, now, low, length) - outside
        if below >= 0.0:
            return 0.0
    below = min(below, -_CLOSE)
    kept = 0  # which end stayed in the last round
    for _ in range(60):
        middle = high - beyond * (high - low) / (beyond - below)
        there = _excess(law, structure, rig, heat, piece, grip, side, now, middle, length) - outside
        if abs(there) < _CLOSE:
            return middle
        if there > 0.0:
            high, beyond = middle, there
            below *= 0.5 if kept == -1 else 1.0
            kept = -1
        else:
            low, below = middle, there
            beyond *= 0.5 if kept == 1 else 1.0
            kept = 1
    return high

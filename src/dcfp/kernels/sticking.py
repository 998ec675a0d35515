"""One step of sticking: an oscillator on springs (a) and (b), until spring (b) reaches the yield surface."""

import math

from dcfp.kernels._jit import kernel
from dcfp.kernels.friction import mean_coefficient
from dcfp.kernels.heat_state import BETWEEN, ODD_LENGTH, PRESENT, Heat
from dcfp.kernels.heating import cool_down, expect_cooling, mix, prepare_cooling
from dcfp.kernels.law import Law
from dcfp.kernels.motion import Advance, Motion, Push, Structure
from dcfp.kernels.oscillator import Swing, swing, work

#: Largest angle of a sticking step [rad], so that spring (b) cannot pass the yield surface and return unseen.
LARGEST_ANGLE = 0.55
#: How close to the yield surface the start of sliding is found [mm].
_CLOSE = 1e-10


@kernel
def stick_step(
    law: Law, structure: Structure, heat: Heat, motion: Motion, push: Push, room: float, interval: float
) -> Advance:
    """Stick for at most `room` [s] of the sample `interval`, or until sliding starts."""
    stiffness = structure.restoring + structure.elastic
    y, v, x = motion.displacement, motion.velocity, motion.elongation
    start = -push.now - structure.restoring * y - structure.elastic * x
    length = room
    if room * room * stiffness > LARGEST_ANGLE * LARGEST_ANGLE:
        length = room / math.ceil(room * math.sqrt(stiffness) / LARGEST_ANGLE)
    swung = swing(stiffness, length, v, start, -push.rate, 0.0)
    friction = mean_coefficient(law, structure, abs(swung.velocity), heat.notes, PRESENT)
    slips = abs(x + swung.displacement) > friction * structure.reach
    # spring (b) moves one way from `low` to `high`, so it can reach only the surface on that side
    low, high = 0.0, length
    turning = math.nan
    going = v if v != 0.0 else start
    if going * swung.velocity < 0.0:
        turn = _turn(stiffness, length, swung.velocity, v, start, push.rate)
        turned = swing(stiffness, turn, v, start, -push.rate, 0.0).displacement
        turning = y + turned
        slow = mean_coefficient(law, structure, 0.0, heat.notes, PRESENT)
        if abs(x + turned) > slow * structure.reach:
            slips, high = True, turn
        else:
            low = turn
    if slips:
        place = 0 if length == interval else ODD_LENGTH
        prepare_cooling(heat, place, length)
        expect_cooling(heat, structure, place)
        slip = _slip_time(law, structure, heat, motion, push, start, length, low, high)
        cut = high < length
        slips = slip <= high
        length = min(slip, high)
        swung = swing(stiffness, length, v, start, -push.rate, 0.0)
        friction = abs(x + swung.displacement) / structure.reach
        if cut and (not slips or going * swung.velocity <= 0.0):
            # the turn no more than touches the surface: it stays, and goes on from rest
            slips = False
            swung = Swing(swung.displacement, 0.0, swung.area, swung.moment)
        elif low == 0.0 and length < high:
            turning = math.nan  # it slips before it turns
    if length > 0.0:
        place = 0 if length == interval else ODD_LENGTH
        prepare_cooling(heat, place, length)
        cool_down(heat, structure, place)
    x += swung.displacement
    side = 0
    if slips:
        side = 1 if x > 0.0 else -1
    return Advance(
        Motion(y + swung.displacement, swung.velocity, x, side),
        length,
        -work(push.now, push.rate, 0.0, length, swung),
        0.0,
        friction,
        turning,
        True,
    )


@kernel
def _excess(
    law: Law,
    structure: Structure,
    heat: Heat,
    motion: Motion,
    push: Push,
    start: float,
    side: float,
    time: float,
    length: float,
) -> float:
    """How far spring (b) is beyond the yield surface on a side, r_f = mu N / kf [mm], `time` [s] into the step."""
    mix(heat, structure, time / length, BETWEEN)
    swung = swing(structure.restoring + structure.elastic, time, motion.velocity, start, -push.rate, 0.0)
    friction = mean_coefficient(law, structure, abs(swung.velocity), heat.notes, BETWEEN)
    return side * (motion.elongation + swung.displacement) - friction * structure.reach


@kernel
def _slip_time(
    law: Law,
    structure: Structure,
    heat: Heat,
    motion: Motion,
    push: Push,
    start: float,
    length: float,
    low: float,
    high: float,
) -> float:
    """Time of the first slip in [low, high], by the Illinois method; infinity if cooling has prevented it."""
    stiffness = structure.restoring + structure.elastic
    end = motion.elongation + swing(stiffness, high, motion.velocity, start, -push.rate, 0.0).displacement
    side = 1.0 if end > 0.0 else -1.0
    # a sticking phase begins on the surface, as closely as the temperature was expected: it slips where it goes further out
    below = _excess(law, structure, heat, motion, push, start, side, low, length)
    outside = max(below, 0.0)
    beyond = _excess(law, structure, heat, motion, push, start, side, high, length) - outside
    if beyond <= 0.0:
        return math.inf
    below = min(below - outside, -_CLOSE)
    kept = 0  # which end stayed in the last round
    for _ in range(60):
        middle = high - beyond * (high - low) / (beyond - below)
        there = _excess(law, structure, heat, motion, push, start, side, middle, length) - outside
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


@kernel
def _turn(
    stiffness: float, length: float, last: float, velocity: float, acceleration: float, push_rate: float
) -> float:
    """Time at which the velocity passes zero, by Newton's iteration inside a bracket."""
    low, high = 0.0, length
    going = velocity if velocity != 0.0 else acceleration
    t = length * velocity / (velocity - last)
    if t < 0.01 * length:  # it starts from rest, and that is not the turn
        t = 0.5 * length
    for _ in range(30):
        swung = swing(stiffness, t, velocity, acceleration, -push_rate, 0.0)
        if swung.velocity * going > 0.0:
            low = t
        else:
            high = t
        now = acceleration - push_rate * t - stiffness * swung.displacement
        better = t - swung.velocity / now if now != 0.0 else 0.5 * (low + high)
        if not low <= better <= high:
            better = 0.5 * (low + high)
        close = abs(better - t) < 1e-8 * length  # the displacement is stationary there
        t = better
        if close:
            break
    return t

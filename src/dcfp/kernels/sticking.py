"""One step of sticking: an oscillator on springs (a) and (b), until spring (b) reaches the yield surface."""

import math

from dcfp.kernels._jit import kernel
from dcfp.kernels.friction import mean_coefficient
from dcfp.kernels.heating import (
    BETWEEN,
    ODD_LENGTH,
    PRESENT,
    cool_down,
    expect_cooling,
    mix,
    prepare_cooling,
)
from dcfp.kernels.motion import Advance, Motion
from dcfp.kernels.oscillator import swing, work

#: Largest angle of a sticking step [rad], so that spring (b) cannot pass the yield surface and return unseen.
LARGEST_ANGLE = 0.55
#: How close to the yield surface the start of sliding is found [mm].
_CLOSE = 1e-11


@kernel
def stick_step(law, structure, heat, motion, push, room, interval):
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
    until = length
    turning = math.nan
    if v * swung.velocity < 0.0:
        turn = _turn(stiffness, length, swung.velocity, v, start, push.rate)
        turning = y + swing(stiffness, turn, v, start, -push.rate, 0.0).displacement
        if abs(x + turning - y) > abs(x + swung.displacement):
            slow = mean_coefficient(law, structure, 0.0, heat.notes, PRESENT)
            if abs(x + turning - y) > slow * structure.reach:
                slips, until = True, turn
    if slips:
        prepare_cooling(heat, ODD_LENGTH, length)
        expect_cooling(heat, structure, ODD_LENGTH)
        slip = _slip_time(law, structure, heat, motion, push, start, length, until)
        slips = slip <= until
        length = min(slip, until)
        swung = swing(stiffness, length, v, start, -push.rate, 0.0)
        friction = abs(x + swung.displacement) / structure.reach
        if v * swung.velocity > 0.0:
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
def _excess(law, structure, heat, motion, push, start, time, length):
    """How far spring (b) is beyond the yield surface r_f = mu N / kf [mm], `time` [s] into the step."""
    mix(heat, structure, time / length)
    swung = swing(structure.restoring + structure.elastic, time, motion.velocity, start, -push.rate, 0.0)
    friction = mean_coefficient(law, structure, abs(swung.velocity), heat.notes, BETWEEN)
    return abs(motion.elongation + swung.displacement) - friction * structure.reach


@kernel
def _slip_time(law, structure, heat, motion, push, start, length, until):
    """Time of the first slip in [0, until], by the Illinois method; infinity if cooling has prevented it."""
    low, high = 0.0, until
    beyond = _excess(law, structure, heat, motion, push, start, high, length)
    if beyond <= 0.0:
        return math.inf
    # rounding may put the start of a sticking phase on the wrong side of the surface that it lies on
    below = min(_excess(law, structure, heat, motion, push, start, low, length), -_CLOSE)
    kept = 0  # which end stayed in the last round
    for _ in range(60):
        middle = high - beyond * (high - low) / (beyond - below)
        there = _excess(law, structure, heat, motion, push, start, middle, length)
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
def _turn(stiffness, length, last, velocity, acceleration, push_rate):
    """Time at which the velocity passes zero, by Newton's iteration inside a bracket."""
    low, high = 0.0, length
    t = length * velocity / (velocity - last)
    for _ in range(30):
        swung = swing(stiffness, t, velocity, acceleration, -push_rate, 0.0)
        if swung.velocity * velocity > 0.0:
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

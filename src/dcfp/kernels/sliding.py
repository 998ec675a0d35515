"""One step of sliding: an oscillator on spring (a) under a friction force that follows the law.

Over the step the coefficient is the parabola through its values at the start, in the middle and at the end.
How far the middle is from the chord tells whether the step is short enough. All else is closed form, so energy is conserved to rounding.
"""

import math

from dcfp.kernels._jit import kernel
from dcfp.kernels.friction import mean_coefficient, note_ratios
from dcfp.kernels.heat_state import BETWEEN, EXPECTED, FINEST_LEVEL, ODD_LENGTH, POINT, RATIO, Heat
from dcfp.kernels.heating import expect, heat_up, mix, prepare
from dcfp.kernels.law import Law
from dcfp.kernels.motion import Advance, Motion, Push, Structure, share
from dcfp.kernels.oscillator import squared_speed, swing, work

#: Length of a step over the sample interval, by level.
HALVES = tuple(0.5**n for n in range(FINEST_LEVEL + 1))


@kernel
def slide_step(
    law: Law,
    structure: Structure,
    heat: Heat,
    fresh: bool,
    motion: Motion,
    friction: float,
    push: Push,
    time: float,
    room: float,
    interval: float,
    level: int,
    coarsest: int,
    tolerance: float,
) -> tuple[Advance, int]:
    """Slide for at most `room` [s] of the sample `interval`; return the step and the level of halving for the next one.

    `fresh` says that sliding has just begun; `coarsest` is the level that may not be gone below.
    """
    y, v, side = motion.displacement, motion.velocity, motion.side
    start = -push.now - structure.restoring * y - side * structure.gravity * friction
    jerk = -push.rate - structure.restoring * v
    flux = structure.pressure * friction

    while True:
        regular = interval * HALVES[level]
        length = next_length(regular, room)
        turns = False
        turn = _turning_time(v, start, jerk, length)
        if turn < 1e-12 * regular:  # it moves no more
            return Advance(Motion(y, 0.0, motion.elongation, 0), 0.0, 0.0, 0.0, friction, y, True), level
        if turn < length:
            length, turns = turn, True
        travel = length * (v + 0.5 * length * start)
        if heat.kind == POINT:
            leave = _leaving_time(heat, structure, y, travel, v, start, jerk, length)
            if leave < length:
                travel *= leave / length
                length, turns = leave, False
        speed = 0.0 if turns else abs(v + length * (start + 0.5 * length * jerk))
        # what an odd length brings is a part of what the regular one would: its modes are at hand
        part = length / regular
        opening = flux * abs(v)
        closing = opening + (flux * speed - opening) / part
        prepare(heat, level, regular)
        rubbing = structure.pressure * travel * travel / (length * part)
        expect(heat, structure, level, time, y + 0.5 * travel, travel / part, opening, closing, rubbing)
        if part != 1.0:
            mix(heat, structure, part, EXPECTED)
        last = mean_coefficient(law, structure, speed, heat.notes, EXPECTED)
        bend = 0.0
        if abs(last - friction) > tolerance * last:
            mix(heat, structure, 0.5, BETWEEN)
            half_speed = abs(v + 0.5 * length * (start + 0.25 * length * jerk))
            central = mean_coefficient(law, structure, half_speed, heat.notes, BETWEEN)
            bend = central - 0.5 * (friction + last)
            if abs(bend) > tolerance * last and level < FINEST_LEVEL:
                level += 1
                continue
        place = level
        if abs(bend) < 0.2 * tolerance * last and level > coarsest and not fresh:
            level -= 1
        break

    # mu(t) = friction + slope t + curve t2
    per_length = 1.0 / length
    slope = (last - friction + 4.0 * bend) * per_length
    curve = bend * (-4.0 * per_length * per_length)
    pull = -side * structure.gravity
    push_rate = -push.rate + pull * slope
    push_curve = pull * curve
    swung = swing(structure.restoring, length, v, start, push_rate, push_curve)
    if turns or v * swung.velocity < 0.0:
        furthest = min(room, 2.0 * length)
        length, turns = _polish_turn(structure.restoring, length, furthest, v, start, push_rate, push_curve)
        swung = swing(structure.restoring, length, v, start, push_rate, push_curve)
        last = friction + length * (slope + length * curve)
        per_length = 1.0 / length

    reach = side * last * structure.reach
    if side * (swung.displacement - reach + motion.elongation) < 0.0:
        # spring (b) lags behind: the force can grow faster than the yield force, so this is sticking
        if not fresh:
            return Advance(Motion(y, v, motion.elongation, 0), 0.0, 0.0, 0.0, friction, math.nan, True), level
        if level < FINEST_LEVEL:  # it has just begun to slide: once more, with a shorter step
            return Advance(motion, 0.0, 0.0, 0.0, friction, math.nan, True), level + 1

    end = y + swung.displacement
    speed = 0.0 if turns else swung.velocity
    rubbed = work(friction, slope, curve, length, swung)
    closing = structure.pressure * last * abs(speed)
    # the flux is taken as linear, and raised so that the heat is the work of friction
    missing = structure.pressure * abs(rubbed) * per_length - 0.5 * (opening + closing)
    place = place if length == regular else ODD_LENGTH
    prepare(heat, place, length)
    note_ratios(law, structure, abs(speed), heat.notes, EXPECTED, RATIO)
    fits = heat_up(
        heat,
        structure,
        place,
        time + length,
        length,
        end,
        y + 0.5 * swung.displacement,
        opening + missing,
        closing + missing,
        closing,
        structure.pressure * squared_speed(length, v, speed, swung.displacement),
    )
    stored = 0.5 * structure.elastic * (reach * reach - motion.elongation * motion.elongation)
    advance = Advance(
        Motion(end, speed, reach, 0 if turns else side),
        length,
        -work(push.now, push.rate, 0.0, length, swung),
        -pull * rubbed - stored,
        last,
        end if turns else math.nan,
        fits,
    )
    return advance, level


@kernel
def next_length(length: float, room: float) -> float:
    """Length of the next step: never a sliver at the end of the room."""
    if room <= length * (1.0 + 1e-9):
        return length if abs(room - length) < 1e-9 * length else room
    if room < 2.0 * length:
        return 0.5 * room if abs(room - 2.0 * length) > 1e-9 * length else length
    return length


@kernel
def _turning_time(velocity: float, acceleration: float, jerk: float, length: float) -> float:
    """First time at which v + a t + j t2 / 2 passes zero within `length`, or infinity."""
    sign = 1.0 if velocity > 0.0 else -1.0
    v, a, j = sign * velocity, sign * acceleration, sign * jerk
    if v <= 0.0:
        return math.inf
    ends_behind = v + length * (a + 0.5 * length * j) < 0.0
    dips = a < 0.0 and a + j * length > 0.0
    if not (ends_behind or dips):
        return math.inf
    under_root = a * a - 2.0 * j * v
    if under_root < 0.0:
        return math.inf
    denominator = -a + math.sqrt(under_root)
    return 2.0 * v / denominator if denominator > 0.0 else math.inf


@kernel
def _polish_turn(
    stiffness: float,
    length: float,
    furthest: float,
    velocity: float,
    acceleration: float,
    push_rate: float,
    push_curve: float,
) -> tuple[float, bool]:
    """Return the time at which the velocity is zero, and True; or `length` and False if that is not by `furthest`.

    Newton's iteration inside a bracket: with the friction corrected, a turn that was expected may come later or never.
    """
    low, high = 0.0, length
    if swing(stiffness, length, velocity, acceleration, push_rate, push_curve).velocity * velocity > 0.0:
        last = swing(stiffness, furthest, velocity, acceleration, push_rate, push_curve)
        if last.velocity * velocity > 0.0:
            return length, False
        low, high = length, furthest
    h = length
    for _ in range(50):
        swung = swing(stiffness, h, velocity, acceleration, push_rate, push_curve)
        if swung.velocity * velocity > 0.0:
            low = h
        else:
            high = h
        now = acceleration + h * (push_rate + h * push_curve) - stiffness * swung.displacement
        better = h - swung.velocity / now if now != 0.0 else 0.5 * (low + high)
        if not low <= better <= high:
            better = 0.5 * (low + high)
        close = abs(better - h) < 1e-8 * length
        h = better
        if close:
            break
    return h, True


@kernel
def _leaving_time(
    heat: Heat,
    structure: Structure,
    displacement: float,
    travel: float,
    velocity: float,
    acceleration: float,
    jerk: float,
    length: float,
) -> float:
    """Time at which a plate's monitoring point comes under the slider or leaves it, or infinity: Eq. (12)."""
    earliest = math.inf
    end = displacement + travel
    for i in range(structure.plates):
        portion = share(structure, i)
        inside = portion * abs(displacement) <= heat.half_contact
        if inside == (portion * abs(end) <= heat.half_contact):
            continue
        outer = displacement if abs(displacement) > abs(end) else end
        target = math.copysign(heat.half_contact / portion, outer)
        t = length * (target - displacement) / travel
        for _ in range(6):
            away = displacement - target + t * (velocity + t * (0.5 * acceleration + t * jerk / 6.0))
            rate = velocity + t * (acceleration + 0.5 * t * jerk)
            if rate == 0.0:
                break
            t = min(max(t - away / rate, 0.0), length)
        if t > 1e-9 * length:
            earliest = min(earliest, t)
    return earliest

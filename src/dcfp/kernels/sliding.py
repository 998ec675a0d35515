"""One step of sliding, of a free structure or of the test machine.

Over the step the coefficient of friction is the parabola through its values at the start, in the middle and at the end. How far the middle
is from the chord tells whether the step is short enough. A free structure is an oscillator on spring (a) under that friction; in the test
machine the motion is known. All else is closed form, so energy is conserved to rounding.

Where `imposed` is None, as numba knows when it compiles, the structure is free; else the ground is at rest.
"""

import math
from typing import NamedTuple

from dcfp.kernels._jit import kernel
from dcfp.kernels.friction import BearingModel, mean_coefficient, store_ratios
from dcfp.kernels.heat_state import BETWEEN, EXPECTED, MOST_HALVINGS, ODD_LENGTH, POINT, RATIO, Heat
from dcfp.kernels.heating import crossed_edge, expect, heat_up, interpolate, prepare
from dcfp.kernels.imposed_motion import (
    GAUSS_PARTS,
    GAUSS_POINTS,
    ImposedMotion,
    displacement_at,
    friction_at,
    law_at,
    load_at,
    next_turn,
    pendulum_work,
    system_at,
    time_at,
    velocity_at,
)
from dcfp.kernels.motion import Motion, SpringState, StepControl, StepResult, StepStart, SystemConstants
from dcfp.kernels.oscillator import advance_oscillator, squared_speed, time_of_turn, work

#: Length of a step over the sample interval, by the number of halvings.
STEP_FRACTIONS = tuple(0.5**n for n in range(MOST_HALVINGS + 1))


class Course(NamedTuple):
    """What a step is expected to be, up to an event or its regular end."""

    length: float  # [s]; zero where it moves no more
    travel: float  # [mm]
    speed: float  # at the end [mm/s]
    turns: bool


class Slide(NamedTuple):
    """What a step is with the friction found."""

    length: float  # [s]
    motion: Motion  # at the end
    middle: float  # displacement in the middle [mm]
    travel: float  # [mm]
    turns: bool
    friction: float  # at the end
    rubbed: float  # integral of mu v [mm], or of mu N v [N mm]
    rubbing: float  # integral of p v2 [N/s]
    work: float  # of the ground or the machine [mm2/s2] or [N mm]


@kernel
def slide_step(
    model: BearingModel,
    control: StepControl,
    imposed: ImposedMotion | None,
    begin: StepStart,
    just_yielded: bool,
    halvings: int,
) -> tuple[StepResult, int]:
    """Slide for at most what remains of the sample interval; return the step and the halvings for the next one.

    `just_yielded` says that sliding has just begun.
    """
    system, heat, tolerance = model.system, model.heat, control.tolerance
    motion, spring, slip_sign, friction = (
        begin.motion,
        begin.spring,
        begin.spring.slip_sign,
        begin.spring.friction,
    )
    start = (
        -begin.ground.acceleration
        - system.restoring * motion.displacement
        - slip_sign * system.gravity * friction
    )
    jerk = -begin.ground.rate - system.restoring * motion.velocity
    while True:
        regular = control.interval * STEP_FRACTIONS[halvings]
        course = _course(model, imposed, motion, start, jerk, next_length(regular, begin.remaining), regular)
        if course.length == 0.0:
            stuck = SpringState(spring.elongation, 0, friction)
            at_rest = Motion(motion.displacement, 0.0)
            return StepResult(at_rest, stuck, 0.0, 0.0, 0.0, motion.displacement, True), halvings
        opening, last = _friction_at_end(model, imposed, begin, course, regular, halvings, tolerance)
        bend = 0.0
        if abs(last - friction) > tolerance * last:
            interpolate(heat, system, 0.5, BETWEEN)
            bend = _friction_in_the_middle(model, imposed, motion, start, jerk, course.length) - 0.5 * (
                friction + last
            )
            if abs(bend) > tolerance * last and halvings < MOST_HALVINGS:
                halvings += 1
                continue
        place = halvings
        if abs(bend) < 0.2 * tolerance * last and halvings > control.fewest_halvings and not just_yielded:
            halvings -= 1
        break

    slide = _slide(model, imposed, begin, start, course, last, bend)
    here = system_at(system, imposed, slide.length)
    elongation = slip_sign * slide.friction * here.yield_per_mu
    if slip_sign * (slide.travel - elongation + spring.elongation) < 0.0:
        # spring (b) lags behind: the force can grow faster than the yield force, so this is sticking
        if not just_yielded:
            stuck = SpringState(spring.elongation, 0, friction)
            return StepResult(motion, stuck, 0.0, 0.0, 0.0, math.nan, True), halvings
        if halvings < MOST_HALVINGS:  # it has just begun to slide: once more, with a shorter step
            return StepResult(motion, spring, 0.0, 0.0, 0.0, math.nan, True), halvings + 1

    end, speed = slide.motion.displacement, abs(slide.motion.velocity)
    closing = here.pressure * slide.friction * speed
    # the flux is taken as linear, and raised so that the heat is the work of friction
    if imposed is None:
        flux = here.pressure * abs(slide.rubbed) * (1.0 / slide.length)
    else:
        flux = abs(slide.rubbed) / (imposed.machine.area * slide.length)
    missing = flux - 0.5 * (opening + closing)
    place = place if slide.length == regular else ODD_LENGTH
    prepare(heat, place, slide.length)
    store_ratios(BearingModel(law_at(model.law, imposed, slide.length), here, heat), speed, EXPECTED, RATIO)
    time = begin.time + slide.length if imposed is None else imposed.clock + (imposed.now + slide.length)
    first, final = opening + missing, closing + missing
    fits = heat_up(
        heat, system, place, time, slide.length, end, slide.middle, first, final, closing, slide.rubbing
    )
    force = slip_sign * here.gravity if imposed is None else float(slip_sign)  # over what has been rubbed
    stored = 0.5 * here.elastic * (elongation * elongation - spring.elongation * spring.elongation)
    left = SpringState(elongation, 0 if slide.turns else slip_sign, slide.friction)
    turning = end if slide.turns else math.nan
    return StepResult(
        slide.motion, left, slide.length, slide.work, force * slide.rubbed - stored, turning, fits
    ), halvings


@kernel
def next_length(length: float, remaining: float) -> float:
    """Length of the next step: never a sliver at the end of what remains."""
    if remaining <= length * (1.0 + 1e-9):
        return length if abs(remaining - length) < 1e-9 * length else remaining
    if remaining < 2.0 * length:
        return 0.5 * remaining if abs(remaining - 2.0 * length) > 1e-9 * length else length
    return length


@kernel
def _course(
    model: BearingModel,
    imposed: ImposedMotion | None,
    motion: Motion,
    start: float,
    jerk: float,
    length: float,
    regular: float,
) -> Course:
    """Expect a step of at most `length` [s], cut where it turns, or where a monitoring point meets the edge of the contact: Eq. (12)."""
    system, heat, v, turns = model.system, model.heat, motion.velocity, False
    if imposed is None:
        turn = _turning_time(v, start, jerk, length)
        if turn < 1e-12 * regular:
            return Course(0.0, 0.0, 0.0, True)
        if turn < length:
            length, turns = turn, True
        travel = length * (v + 0.5 * length * start)
        if heat.kind == POINT:
            leave = _leaving_time(heat, system, motion, travel, start, jerk, length)
            if leave < length:
                travel *= leave / length
                length, turns = leave, False
        speed = 0.0 if turns else abs(v + length * (start + 0.5 * length * jerk))
        return Course(length, travel, speed, turns)
    path, now = imposed.path, imposed.now
    turn = next_turn(path, now, now + length)
    if turn < now + length:
        length = turn - now
    if heat.kind == POINT:
        end, shortest = displacement_at(path, now + length), length
        for i in range(system.plates):
            edge = crossed_edge(heat, system, i, motion.displacement, end)
            if not math.isnan(edge):
                cut = time_at(path, now, now + length, edge) - now
                if cut > 1e-9 * length:
                    shortest = min(shortest, cut)
        length = shortest
    end = now + length
    return Course(
        length, displacement_at(path, end) - motion.displacement, abs(velocity_at(path, end)), False
    )


@kernel
def _friction_at_end(
    model: BearingModel,
    imposed: ImposedMotion | None,
    begin: StepStart,
    course: Course,
    regular: float,
    halvings: int,
    tolerance: float,
) -> tuple[float, float]:
    """Return the flux at the start [N/(mm s)] and the coefficient to expect at the end, with the heat that it brings."""
    system, heat, time, friction = model.system, model.heat, begin.time, begin.spring.friction
    v, length, travel, speed = begin.motion.velocity, course.length, course.travel, course.speed
    middle = begin.motion.displacement + 0.5 * travel
    if imposed is None:
        # what an odd length brings is a part of what the regular one would: its modes are at hand
        flux = system.pressure * friction
        part = length / regular
        opening = flux * abs(v)
        closing = opening + (flux * speed - opening) / part
        prepare(heat, halvings, regular)
        rubbing = system.pressure * travel * travel / (length * part)
        expect(heat, system, halvings, time, middle, travel / part, opening, closing, rubbing)
        if part != 1.0:
            interpolate(heat, system, part, EXPECTED)
        return opening, mean_coefficient(model, speed, EXPECTED)
    pressure = system_at(system, imposed, length).pressure
    opening = friction * load_at(imposed.path, imposed.now) / imposed.machine.area * abs(v)
    place = halvings if length == regular else ODD_LENGTH
    prepare(heat, place, length)
    rubbing = pressure * travel * travel / length
    expect(heat, system, place, time, middle, travel, opening, friction * pressure * speed, rubbing)
    last = friction_at(model, imposed, length, EXPECTED)
    if abs(last - friction) > 0.1 * tolerance * last:  # once more, with the heat of the friction at the end
        expect(heat, system, place, time, middle, travel, opening, last * pressure * speed, rubbing)
        last = friction_at(model, imposed, length, EXPECTED)
    return opening, last


@kernel
def _friction_in_the_middle(
    model: BearingModel,
    imposed: ImposedMotion | None,
    motion: Motion,
    start: float,
    jerk: float,
    length: float,
) -> float:
    if imposed is None:
        speed = abs(motion.velocity + 0.5 * length * (start + 0.25 * length * jerk))
        return mean_coefficient(model, speed, BETWEEN)
    return friction_at(model, imposed, 0.5 * length, BETWEEN)


@kernel
def _slide(
    model: BearingModel,
    imposed: ImposedMotion | None,
    begin: StepStart,
    start: float,
    course: Course,
    last: float,
    bend: float,
) -> Slide:
    """Return the step under the parabola of the coefficient through its ends and the middle, which is `bend` from the chord."""
    if imposed is not None:
        return _imposed_slide(imposed, begin, course, last, bend)
    system, ground, friction = model.system, begin.ground, begin.spring.friction
    y, v = begin.motion.displacement, begin.motion.velocity
    length, turns = course.length, course.turns
    # mu(t) = friction + slope t + curve t2
    per_length = 1.0 / length
    slope = (last - friction + 4.0 * bend) * per_length
    curve = bend * (-4.0 * per_length * per_length)
    pull = -begin.spring.slip_sign * system.gravity
    rate = -ground.rate + pull * slope
    curvature = pull * curve
    step = advance_oscillator(system.restoring, length, v, start, rate, curvature)
    if turns or v * step.velocity < 0.0:
        furthest = min(begin.remaining, 2.0 * length)
        length, turns = _polish_turn(system.restoring, length, furthest, v, start, rate, curvature)
        step = advance_oscillator(system.restoring, length, v, start, rate, curvature)
        last = friction + length * (slope + length * curve)
    rubbed = work(friction, slope, curve, length, step)
    end = 0.0 if turns else step.velocity
    return Slide(
        length,
        Motion(y + step.displacement, end),
        y + 0.5 * step.displacement,
        step.displacement,
        turns,
        last,
        rubbed,
        system.pressure * squared_speed(length, v, end, step.displacement),
        -work(ground.acceleration, ground.rate, 0.0, length, step),
    )


@kernel
def _imposed_slide(
    imposed: ImposedMotion, begin: StepStart, course: Course, last: float, bend: float
) -> Slide:
    path, now, length, friction = imposed.path, imposed.now, course.length, begin.spring.friction
    rubbed, squared = 0.0, 0.0
    for k in range(4):
        part = GAUSS_POINTS[k]
        mobilised = friction + part * ((last - friction) + 4.0 * bend * (1.0 - part))
        rate = velocity_at(path, now + part * length)
        carried = GAUSS_PARTS[k] * length * load_at(path, now + part * length)
        rubbed += carried * mobilised * rate
        squared += carried * rate * rate
    return Slide(
        length,
        Motion(begin.motion.displacement + course.travel, velocity_at(path, now + length)),
        displacement_at(path, now + 0.5 * length),
        course.travel,
        False,
        last,
        rubbed,
        squared / imposed.machine.area,
        begin.spring.slip_sign * rubbed + pendulum_work(imposed, length),
    )


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
    force_rate: float,
    force_curvature: float,
) -> tuple[float, bool]:
    """Return the time at which the velocity is zero, and True; or `length` and False if that is not by `furthest`.

    With the friction corrected, a turn that was expected may come later or never.
    """
    low, high = 0.0, length
    there = advance_oscillator(stiffness, length, velocity, acceleration, force_rate, force_curvature)
    if there.velocity * velocity > 0.0:
        last = advance_oscillator(stiffness, furthest, velocity, acceleration, force_rate, force_curvature)
        if last.velocity * velocity > 0.0:
            return length, False
        low, high = length, furthest
    close = 1e-8 * length
    bracket = (low, high)
    return time_of_turn(
        stiffness, bracket, length, close, velocity, acceleration, force_rate, force_curvature
    ), True


@kernel
def _leaving_time(
    heat: Heat,
    system: SystemConstants,
    motion: Motion,
    travel: float,
    acceleration: float,
    jerk: float,
    length: float,
) -> float:
    """Time at which a plate's monitoring point comes under the slider or leaves it, or infinity: Eq. (12)."""
    earliest = math.inf
    displacement, velocity = motion.displacement, motion.velocity
    for i in range(system.plates):
        edge = crossed_edge(heat, system, i, displacement, displacement + travel)
        if math.isnan(edge):
            continue
        t = length * (edge - displacement) / travel
        for _ in range(6):
            away = displacement - edge + t * (velocity + t * (0.5 * acceleration + t * jerk / 6.0))
            rate = velocity + t * (acceleration + 0.5 * t * jerk)
            if rate == 0.0:
                break
            t = min(max(t - away / rate, 0.0), length)
        if t > 1e-9 * length:
            earliest = min(earliest, t)
    return earliest

"""One step of sticking, of a free structure or in the test machine, until spring (b) reaches the yield surface.

A free structure is an oscillator on springs (a) and (b); in the test machine the motion is known. Where `imposed` is None, as numba knows when it
compiles, the structure is free; else the ground is at rest.
"""

import math
from typing import NamedTuple

from dcfp.kernels._jit import kernel
from dcfp.kernels.friction import BearingModel, mean_coefficient
from dcfp.kernels.heat_state import BETWEEN, ODD_LENGTH, PRESENT
from dcfp.kernels.heating import cool_down, expect_cooling, interpolate, prepare_cooling
from dcfp.kernels.imposed_motion import (
    ImposedMotion,
    displacement_at,
    friction_at,
    load_at,
    next_turn,
    pendulum_work,
    velocity_at,
)
from dcfp.kernels.motion import Motion, SpringState, StepControl, StepResult, StepStart, SystemConstants
from dcfp.kernels.oscillator import OscillatorStep, advance_oscillator, time_of_turn, work

#: Largest angle of a sticking step [rad], so that spring (b) cannot pass the yield surface and return unseen.
LARGEST_ANGLE = 0.55
#: How close to the yield surface the start of sliding is found [mm].
_CLOSE = 1e-10
#: Part of a step within which what is outside of the surface was so from the start [-].
_AT_ONCE = 1e-3


class Bracket(NamedTuple):
    """Two times into a step [s], and how much further beyond the yield surface spring (b) is there [mm]."""

    low: float
    high: float
    below: float
    beyond: float


@kernel
def stick_step(
    model: BearingModel, control: StepControl, imposed: ImposedMotion | None, begin: StepStart
) -> StepResult:
    """Stick for at most what remains of the sample interval, or until sliding starts."""
    if imposed is not None:
        return _stick_imposed(model, control, imposed, begin)
    system, ground, remaining = model.system, begin.ground, begin.remaining
    stiffness = system.restoring + system.elastic
    y, v, x = begin.motion.displacement, begin.motion.velocity, begin.spring.elongation
    start = -ground.acceleration - system.restoring * y - system.elastic * x
    length = remaining
    if remaining * remaining * stiffness > LARGEST_ANGLE * LARGEST_ANGLE:
        length = remaining / math.ceil(remaining * math.sqrt(stiffness) / LARGEST_ANGLE)
    step = advance_oscillator(stiffness, length, v, start, -ground.rate, 0.0)
    friction = mean_coefficient(model, abs(step.velocity), PRESENT)
    slips = abs(x + step.displacement) > friction * system.yield_per_mu
    # spring (b) moves one way from `low` to `high`, so it can reach only the surface on that side
    low, high = 0.0, length
    turning = math.nan
    going = v if v != 0.0 else start
    if going * step.velocity < 0.0:
        first = length * v / (v - step.velocity)
        if first < 0.01 * length:  # it starts from rest, and that is not the turn
            first = 0.5 * length
        close = 1e-8 * length  # the displacement is stationary there
        turn = time_of_turn(stiffness, (0.0, length), first, close, v, start, -ground.rate, 0.0)
        turned = advance_oscillator(stiffness, turn, v, start, -ground.rate, 0.0).displacement
        turning = y + turned
        slow = mean_coefficient(model, 0.0, PRESENT)
        if abs(x + turned) > slow * system.yield_per_mu:
            slips, high = True, turn
        else:
            low = turn
    if slips:
        _expect(model, control, length)
        side = 1.0 if x + _free_oscillation(system, begin, high).displacement > 0.0 else -1.0
        slip = _slip_time(model, None, begin, length, side, low, high)
        cut = high < length
        slips = slip <= high
        length = min(slip, high)
        step = advance_oscillator(stiffness, length, v, start, -ground.rate, 0.0)
        friction = abs(x + step.displacement) / system.yield_per_mu
        if cut and (not slips or going * step.velocity <= 0.0):
            # the turn no more than touches the surface: it stays, and goes on from rest
            slips = False
            step = OscillatorStep(step.displacement, 0.0, step.area, step.moment)
        elif low == 0.0 and length < high:
            turning = math.nan  # it slips before it turns
    _cool(model, control, length)
    x += step.displacement
    slip_sign = 0
    if slips:
        slip_sign = 1 if x > 0.0 else -1
    return StepResult(
        Motion(y + step.displacement, step.velocity),
        SpringState(x, slip_sign, friction),
        length,
        -work(ground.acceleration, ground.rate, 0.0, length, step),
        0.0,
        turning,
        True,
    )


@kernel
def _stick_imposed(
    model: BearingModel, control: StepControl, imposed: ImposedMotion, begin: StepStart
) -> StepResult:
    remaining, spring, y = begin.remaining, begin.spring, begin.motion.displacement
    path, now, length, elastic = imposed.path, imposed.now, remaining, imposed.machine.elastic
    turn = next_turn(path, now, now + remaining)
    if turn < now + remaining:
        length = turn - now
    _expect(model, control, length)
    # spring (b) reaches the yield surface on the side that it moves to, unless the surface shrinks faster on the other one
    slip_sign = 1 if displacement_at(path, now + length) >= y else -1
    slip = _slip_time(model, imposed, begin, length, slip_sign, 0.0, length)
    behind = _slip_time(model, imposed, begin, length, -slip_sign, 0.0, length)
    if behind < slip:
        slip, slip_sign = behind, -slip_sign
    slips = slip < length
    if slips:
        length = slip
    _cool(model, control, length)
    end = Motion(displacement_at(path, now + length), velocity_at(path, now + length))
    elongation = spring.elongation + end.displacement - y
    friction = friction_at(model, imposed, length, PRESENT)
    if slips:
        friction = abs(elongation) * elastic / load_at(path, now + length)
    stored = 0.5 * elastic * (elongation * elongation - spring.elongation * spring.elongation)
    return StepResult(
        end,
        SpringState(elongation, slip_sign if slips else 0, friction),
        length,
        stored + pendulum_work(imposed, length),
        0.0,
        math.nan,
        True,
    )


@kernel
def _expect(model: BearingModel, control: StepControl, length: float) -> None:
    """Store the temperatures to expect at the end of a step of `length` [s]."""
    place = 0 if length == control.interval else ODD_LENGTH
    prepare_cooling(model.heat, place, length)
    expect_cooling(model.heat, model.system, place)


@kernel
def _cool(model: BearingModel, control: StepControl, length: float) -> None:
    """Take a step of `length` [s] without heat."""
    if length > 0.0:
        place = 0 if length == control.interval else ODD_LENGTH
        prepare_cooling(model.heat, place, length)
        cool_down(model.heat, model.system, place)


@kernel
def _excess(
    model: BearingModel,
    imposed: ImposedMotion | None,
    begin: StepStart,
    length: float,
    slip_sign: float,
    time: float,
) -> float:
    """How far spring (b) is beyond the yield surface on a side, r_f = mu N / kf [mm], `time` [s] into the step."""
    system, elongation = model.system, begin.spring.elongation
    interpolate(model.heat, system, time / length, BETWEEN)
    if imposed is None:
        step = _free_oscillation(system, begin, time)
        friction = mean_coefficient(model, abs(step.velocity), BETWEEN)
        return slip_sign * (elongation + step.displacement) - friction * system.yield_per_mu
    friction = friction_at(model, imposed, time, BETWEEN)
    there = imposed.now + time
    elongation = elongation + displacement_at(imposed.path, there) - begin.motion.displacement
    return slip_sign * elongation - friction * load_at(imposed.path, there) / imposed.machine.elastic


@kernel
def _free_oscillation(system: SystemConstants, begin: StepStart, time: float) -> OscillatorStep:
    motion, ground, spring = begin.motion, begin.ground, begin.spring
    start = -ground.acceleration - system.restoring * motion.displacement - system.elastic * spring.elongation
    stiffness = system.restoring + system.elastic
    return advance_oscillator(stiffness, time, motion.velocity, start, -ground.rate, 0.0)


@kernel
def _slip_time(
    model: BearingModel,
    imposed: ImposedMotion | None,
    begin: StepStart,
    length: float,
    slip_sign: float,
    low: float,
    high: float,
) -> float:
    """Time in [low, high] of the first slip on a side; infinity if there is none, as cooling may have prevented it."""
    # a sticking phase begins on the surface, as closely as the temperature was expected: it slips where it goes further out
    below = _excess(model, imposed, begin, length, slip_sign, low)
    outside = max(below, 0.0)
    beyond = _excess(model, imposed, begin, length, slip_sign, high) - outside
    if beyond <= 0.0:
        return math.inf
    below -= outside
    if imposed is not None and below > -_CLOSE:  # does it go further out at once, or does it first move away?
        low = _AT_ONCE * length
        below = _excess(model, imposed, begin, length, slip_sign, low) - outside
        if below >= 0.0:
            return 0.0
    bracket = Bracket(low, high, min(below, -_CLOSE), beyond)
    return _illinois(model, imposed, begin, length, slip_sign, outside, bracket)


@kernel
def _illinois(
    model: BearingModel,
    imposed: ImposedMotion | None,
    begin: StepStart,
    length: float,
    slip_sign: float,
    outside: float,
    bracket: Bracket,
) -> float:
    """Time at which spring (b) is as far beyond the surface as it was `outside` [mm], by the Illinois method."""
    low, high, below, beyond = bracket
    last_moved = 0  # which end moved in the last round
    for _ in range(60):
        middle = high - beyond * (high - low) / (beyond - below)
        there = _excess(model, imposed, begin, length, slip_sign, middle) - outside
        if abs(there) < _CLOSE:
            return middle
        if there > 0.0:
            high, beyond = middle, there
            below *= 0.5 if last_moved == -1 else 1.0
            last_moved = -1
        else:
            low, below = middle, there
            beyond *= 0.5 if last_moved == 1 else 1.0
            last_moved = 1
    return high

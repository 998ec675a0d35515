"""The structure along the legs of a piecewise linear ground velocity.

Along a leg the ground's acceleration is constant. The bearing sticks or slides; within a step the coefficient of friction is constant, so that the structure is
an oscillator on spring (a) with a closed solution. Spring (b) is rigid. The derivation is in ``docs/prediction.md``.
"""

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import Records, kernel, record_type
from dcfp.kernels.friction import BearingModel, mean_coefficient
from dcfp.kernels.heat_state import BETWEEN, ODD_LENGTH, PRESENT, Heat
from dcfp.kernels.heating import cool_down, expect, heat_up, interpolate, prepare
from dcfp.kernels.motion import SystemConstants
from dcfp.kernels.oscillator import advance_oscillator

#: Columns of the path.
PATH_TIME, PATH_DISPLACEMENT, PATH_SIZE = range(3)

#: Place of the prepared step that divides a leg evenly.
_EVEN = 0
#: Rounds in which the coefficient in the middle of a step is found, and most steps of free sliding after the last peak.
_ROUNDS, FREE_STEPS = 3, 2400
#: Starts and stops within one step, after which what is left of it is spent sticking.
_MOST_EVENTS = 8


class MarchState(NamedTuple):
    """What a march starts from and leaves behind. Energies are per unit mass [mm2/s2]."""

    displacement: float  # [mm]
    velocity: float  # [mm/s]
    slip_sign: float
    leg: float  # in which the present slide began
    input: float
    hysteretic: float
    path_length: float  # of all slides [mm]
    # at the last stop, and the largest input since
    turning: float
    turning_input: float
    turning_hysteretic: float
    most_input: float
    # largest of all slides
    peak_displacement: float
    peak_change: float
    peak_input: float
    peak_hysteretic: float
    peak_temperature: float
    peak_leg: float  # in which the slide of the largest change began


#: Its record.
MARCH_STATE = record_type(MarchState)


@kernel
def march_along_legs(
    model: BearingModel,
    times: NDArray[np.float64],
    velocities: NDArray[np.float64],
    parts: int,
    longest: float,
    states: Records,
    path: NDArray[np.float64],
) -> tuple[int, bool]:
    """March along the legs between nodes of the ground velocity; return the number of rows of `path` written and whether the cells sufficed.

    Along a leg the ground's acceleration is constant; it is divided into at least `parts` steps, none longer than `longest` [s]. After the last node the
    ground keeps its velocity until the structure rests. A path without rows is not written.
    """
    heat, state = model.heat, states[0]
    rows = 0
    fits = True
    for leg in range(times.size - 1):
        length = times[leg + 1] - times[leg]
        steps = max(parts, math.ceil(length / longest))
        step = length / steps
        prepare(heat, _EVEN, step)
        ground = (velocities[leg + 1] - velocities[leg]) / length
        for i in range(steps):
            time = times[leg] + i * step
            fits = _step(model, state, leg, time, step, ground) and fits
            rows = _with_row(path, rows, time + step, state)
    last = times.size - 1
    prepare(heat, _EVEN, longest)
    for i in range(FREE_STEPS):
        if state["slip_sign"] == 0.0 and not _slides(model, state["displacement"], 0.0):
            break
        time = times[last] + i * longest
        fits = _step(model, state, last, time, longest, 0.0) and fits
        rows = _with_row(path, rows, time + longest, state)
    return rows, fits


@kernel
def _slides(model: BearingModel, displacement: float, ground: float) -> bool:
    """Whether a bearing at rest slides under a ground acceleration [mm/s2]."""
    system = model.system
    held = system.gravity * mean_coefficient(model, 0.0, PRESENT)
    return not abs(ground + system.restoring * displacement) <= held


@kernel
def _step(model: BearingModel, state: Any, leg: int, time: float, step: float, ground: float) -> bool:
    """Take one step under a constant ground acceleration [mm/s2], through every start and stop within it."""
    system = model.system
    left = step
    fits = True
    for _ in range(_MOST_EVENTS):
        if state["slip_sign"] == 0.0:
            displacement = state["displacement"]
            if not _slides(model, displacement, ground):
                break
            state["slip_sign"] = 1.0 if ground + system.restoring * displacement < 0.0 else -1.0
            state["leg"] = leg
        length, ok = _slide(model, state, time + step - left, left, left == step, ground)
        fits = fits and ok
        left -= length
        if length == 0.0 or left <= 0.0:
            break
    if left > 0.0:
        state["slip_sign"] = state["velocity"] = 0.0
        cool_down(model.heat, system, _place(model.heat, left, left == step))
    return fits


@kernel
def _place(heat: Heat, length: float, even: bool) -> int:
    """Return the place of a prepared step of this length [s]."""
    if even:
        return _EVEN
    prepare(heat, ODD_LENGTH, length)
    return ODD_LENGTH


@kernel
def _slide(
    model: BearingModel, state: Any, time: float, length: float, even: bool, ground: float
) -> tuple[float, bool]:
    """Slide for `length` [s] or until it stops; return how long it slid, and whether the cells sufficed."""
    slip_sign, displacement, velocity = state["slip_sign"], state["displacement"], state["velocity"]
    system, heat = model.system, model.heat
    friction = _friction_in_the_middle(model, state, time, length, even, ground)
    start = -ground - slip_sign * friction * system.gravity - system.restoring * displacement
    moved = advance_oscillator(system.restoring, length, velocity, start, 0.0, 0.0)
    travel, end = moved.displacement, moved.velocity
    stops = slip_sign * end <= 0.0
    if stops:
        length = _time_to_stop(system, velocity, start)
        travel = advance_oscillator(system.restoring, length, velocity, start, 0.0, 0.0).displacement
        end = 0.0
    if length <= 0.0:
        state["slip_sign"] = state["velocity"] = 0.0
        return 0.0, True
    speed = abs(travel) / length
    flux = friction * system.pressure * speed
    fits = heat_up(
        heat,
        system,
        _place(heat, length, even and not stops),
        time + length,
        length,
        displacement + travel,
        displacement + 0.5 * travel,
        flux,
        flux,
        friction * system.pressure * abs(end),
        system.pressure * speed * speed * length,
    )
    state["displacement"] = displacement + travel
    state["velocity"] = end
    state["input"] -= ground * travel
    state["hysteretic"] += friction * system.gravity * abs(travel)
    state["path_length"] += abs(travel)
    state["most_input"] = max(state["most_input"], state["input"])
    state["peak_displacement"] = max(state["peak_displacement"], abs(state["displacement"]))
    for i in range(system.plates):
        state["peak_temperature"] = max(state["peak_temperature"], heat.workspace[PRESENT + i])
    if stops:
        _stop(state)
    return length, fits


@kernel
def _friction_in_the_middle(
    model: BearingModel, state: Any, time: float, length: float, even: bool, ground: float
) -> float:
    """Coefficient of friction [-] at the speed and the temperature to expect in the middle of a step."""
    slip_sign, displacement, velocity = state["slip_sign"], state["displacement"], state["velocity"]
    system, heat = model.system, model.heat
    push = -slip_sign * (ground + system.restoring * (displacement + 0.5 * length * velocity))
    first = friction = mean_coefficient(model, abs(velocity), PRESENT)
    for round_ in range(_ROUNDS):
        speed = max(0.0, abs(velocity) + 0.5 * length * (push - friction * system.gravity))
        if round_ == 0:
            flux = friction * system.pressure * speed
            travel = slip_sign * speed * length
            expect(
                heat,
                system,
                _place(heat, length, even),
                time,
                displacement + 0.5 * travel,
                travel,
                flux,
                flux,
                system.pressure * speed * speed * length,
            )
            interpolate(heat, system, 0.5, BETWEEN)
        friction = mean_coefficient(model, speed, BETWEEN)
    return first if math.isnan(first) else friction  # a law that has no number may have one at no number


@kernel
def _time_to_stop(system: SystemConstants, velocity: float, acceleration: float) -> float:
    """Return when an oscillator with this velocity and acceleration [mm/s, mm/s2] first stops [s]; 0 if it does not slow down."""
    if velocity * acceleration >= 0.0:
        return 0.0
    frequency = math.sqrt(system.restoring)
    return math.atan(-velocity * frequency / acceleration) / frequency


@kernel
def _stop(state: Any) -> None:
    """Stop: what the slide has brought is compared with the slides before."""
    change = abs(state["displacement"] - state["turning"])
    if change > state["peak_change"]:
        state["peak_change"] = change
        state["peak_leg"] = state["leg"]
    state["peak_input"] = max(state["peak_input"], state["most_input"] - state["turning_input"])
    state["peak_hysteretic"] = max(
        state["peak_hysteretic"], state["hysteretic"] - state["turning_hysteretic"]
    )
    state["slip_sign"] = 0.0
    state["turning"] = state["displacement"]
    state["turning_input"] = state["most_input"] = state["input"]
    state["turning_hysteretic"] = state["hysteretic"]


@kernel
def _with_row(path: NDArray[np.float64], rows: int, time: float, state: Any) -> int:
    """Write a row of the path where there is room; return the number of rows written."""
    if rows >= path.shape[0]:
        return rows
    path[rows, PATH_TIME] = time
    path[rows, PATH_DISPLACEMENT] = state["displacement"]
    return rows + 1

r"""Rigid-plastic sliding through the pulses of the ground velocity.

Between two peaks the ground's velocity is taken as half a cosine, in steps of constant acceleration. The bearing sticks
or slides; within a step the coefficient of friction is constant, so that the structure is an oscillator on spring (a)
with a closed solution. Spring (b) is rigid. The derivation is in ``docs/prediction.md``.
"""

import math

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel
from dcfp.kernels.friction import mean_coefficient
from dcfp.kernels.heat_state import BETWEEN, ODD_LENGTH, PRESENT, Heat
from dcfp.kernels.heating import cool_down, expect, heat_up, mix, prepare
from dcfp.kernels.law import Law
from dcfp.kernels.motion import Structure
from dcfp.kernels.oscillator import swing

#: Entries of the state. Energies are per unit mass [mm2/s2].
(
    DISPLACEMENT,
    VELOCITY,
    SIDE,
    LEG,  # in which the present slide began
    INPUT,
    HYSTERETIC,
    # at the last stop, and the largest input since
    TURNING,
    TURNING_INPUT,
    TURNING_HYSTERETIC,
    MOST_INPUT,
    # largest of all slides
    PEAK_DISPLACEMENT,
    PEAK_CHANGE,
    PEAK_INPUT,
    PEAK_HYSTERETIC,
    PEAK_TEMPERATURE,
    PEAK_LEG,  # in which the slide of the largest change began
    STATE_SIZE,
) = range(17)
#: Columns of the path.
PATH_TIME, PATH_DISPLACEMENT, PATH_SIZE = range(3)

#: Place of the prepared step that divides a leg evenly.
_EVEN = 0
#: Rounds in which the coefficient in the middle of a step is found, and most steps of free sliding after the last peak.
_ROUNDS, FREE_STEPS = 3, 2400
#: Starts and stops within one step, after which what is left of it is spent sticking.
_MOST_EVENTS = 8


@kernel
def march_pulses(
    law: Law,
    structure: Structure,
    heat: Heat,
    times: NDArray[np.float64],
    velocities: NDArray[np.float64],
    parts: int,
    longest: float,
    state: NDArray[np.float64],
    path: NDArray[np.float64],
) -> tuple[int, bool]:
    """March through the legs between peaks; return the number of rows of `path` written and whether the cells sufficed.

    Each leg is divided into at least `parts` steps, none longer than `longest` [s]. After the last peak the ground keeps
    its velocity until the structure rests. A path without rows is not written.
    """
    rows = 0
    fits = True
    for leg in range(times.size - 1):
        length = times[leg + 1] - times[leg]
        steps = max(parts, math.ceil(length / longest))
        step = length / steps
        prepare(heat, _EVEN, step)
        # the sine in the middle of each step, by turning a pointer; the mean over the step is this much of it
        turn = math.pi / steps
        turn_sine, turn_cosine = math.sin(turn), math.cos(turn)
        sine, cosine = math.sin(0.5 * turn), math.cos(0.5 * turn)
        scale = (velocities[leg + 1] - velocities[leg]) / step * sine
        for i in range(steps):
            time = times[leg] + i * step
            fits = _step(law, structure, heat, state, leg, time, step, scale * sine) and fits
            sine, cosine = sine * turn_cosine + cosine * turn_sine, cosine * turn_cosine - sine * turn_sine
            rows = _noted(path, rows, time + step, state)
    last = times.size - 1
    prepare(heat, _EVEN, longest)
    for i in range(FREE_STEPS):
        if state[SIDE] == 0.0 and not _slides(law, structure, heat, state[DISPLACEMENT], 0.0):
            break
        time = times[last] + i * longest
        fits = _step(law, structure, heat, state, last, time, longest, 0.0) and fits
        rows = _noted(path, rows, time + longest, state)
    return rows, fits


@kernel
def _slides(law: Law, structure: Structure, heat: Heat, displacement: float, ground: float) -> bool:
    """Whether a bearing at rest slides under a ground acceleration [mm/s2]."""
    held = structure.gravity * mean_coefficient(law, structure, 0.0, heat.notes, PRESENT)
    return not abs(ground + structure.restoring * displacement) <= held


@kernel
def _step(
    law: Law,
    structure: Structure,
    heat: Heat,
    state: NDArray[np.float64],
    leg: int,
    time: float,
    step: float,
    ground: float,
) -> bool:
    """Take one step under a constant ground acceleration [mm/s2], through every start and stop within it."""
    left = step
    fits = True
    for _ in range(_MOST_EVENTS):
        if state[SIDE] == 0.0:
            displacement = state[DISPLACEMENT]
            if not _slides(law, structure, heat, displacement, ground):
                break
            state[SIDE] = 1.0 if ground + structure.restoring * displacement < 0.0 else -1.0
            state[LEG] = leg
        length, ok = _slide(law, structure, heat, state, time + step - left, left, left == step, ground)
        fits = fits and ok
        left -= length
        if length == 0.0 or left <= 0.0:
            break
    if left > 0.0:
        state[SIDE] = state[VELOCITY] = 0.0
        cool_down(heat, structure, _place(heat, left, left == step))
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
    law: Law,
    structure: Structure,
    heat: Heat,
    state: NDArray[np.float64],
    time: float,
    length: float,
    even: bool,
    ground: float,
) -> tuple[float, bool]:
    """Slide for `length` [s] or until it stops; return how long it slid, and whether the cells sufficed."""
    side, displacement, velocity = state[SIDE], state[DISPLACEMENT], state[VELOCITY]
    friction = _friction_in_the_middle(law, structure, heat, state, time, length, even, ground)
    start = -ground - side * friction * structure.gravity - structure.restoring * displacement
    moved = swing(structure.restoring, length, velocity, start, 0.0, 0.0)
    travel, end = moved.displacement, moved.velocity
    stops = side * end <= 0.0
    if stops:
        length = _time_to_stop(structure, velocity, start)
        travel, end = swing(structure.restoring, length, velocity, start, 0.0, 0.0).displacement, 0.0
    if length <= 0.0:
        state[SIDE] = state[VELOCITY] = 0.0
        return 0.0, True
    speed = abs(travel) / length
    flux = friction * structure.pressure * speed
    fits = heat_up(
        heat,
        structure,
        _place(heat, length, even and not stops),
        time + length,
        length,
        displacement + travel,
        displacement + 0.5 * travel,
        flux,
        flux,
        friction * structure.pressure * abs(end),
        structure.pressure * speed * speed * length,
    )
    state[DISPLACEMENT] = displacement + travel
    state[VELOCITY] = end
    state[INPUT] -= ground * travel
    state[HYSTERETIC] += friction * structure.gravity * abs(travel)
    state[MOST_INPUT] = max(state[MOST_INPUT], state[INPUT])
    state[PEAK_DISPLACEMENT] = max(state[PEAK_DISPLACEMENT], abs(state[DISPLACEMENT]))
    for i in range(structure.plates):
        state[PEAK_TEMPERATURE] = max(state[PEAK_TEMPERATURE], heat.notes[PRESENT + i])
    if stops:
        _turn(state)
    return length, fits


@kernel
def _friction_in_the_middle(
    law: Law,
    structure: Structure,
    heat: Heat,
    state: NDArray[np.float64],
    time: float,
    length: float,
    even: bool,
    ground: float,
) -> float:
    """Coefficient of friction [-] at the speed and the temperature to expect in the middle of a step."""
    side, displacement, velocity = state[SIDE], state[DISPLACEMENT], state[VELOCITY]
    drive = -side * (ground + structure.restoring * (displacement + 0.5 * length * velocity))
    first = friction = mean_coefficient(law, structure, abs(velocity), heat.notes, PRESENT)
    for round_ in range(_ROUNDS):
        speed = max(0.0, abs(velocity) + 0.5 * length * (drive - friction * structure.gravity))
        if round_ == 0:
            flux = friction * structure.pressure * speed
            travel = side * speed * length
            expect(
                heat,
                structure,
                _place(heat, length, even),
                time,
                displacement + 0.5 * travel,
                travel,
                flux,
                flux,
                structure.pressure * speed * speed * length,
            )
            mix(heat, structure, 0.5, BETWEEN)
        friction = mean_coefficient(law, structure, speed, heat.notes, BETWEEN)
    return first if math.isnan(first) else friction  # a law that has no number may have one at no number


@kernel
def _time_to_stop(structure: Structure, velocity: float, acceleration: float) -> float:
    """Return when an oscillator with this velocity and acceleration [mm/s, mm/s2] first stops [s]; 0 if it does not slow down."""
    if velocity * acceleration >= 0.0:
        return 0.0
    frequency = math.sqrt(structure.restoring)
    return math.atan(-velocity * frequency / acceleration) / frequency


@kernel
def _turn(state: NDArray[np.float64]) -> None:
    """Note a stop: what the slide has brought is compared with the slides before."""
    change = abs(state[DISPLACEMENT] - state[TURNING])
    if change > state[PEAK_CHANGE]:
        state[PEAK_CHANGE] = change
        state[PEAK_LEG] = state[LEG]
    state[PEAK_INPUT] = max(state[PEAK_INPUT], state[MOST_INPUT] - state[TURNING_INPUT])
    state[PEAK_HYSTERETIC] = max(state[PEAK_HYSTERETIC], state[HYSTERETIC] - state[TURNING_HYSTERETIC])
    state[SIDE] = 0.0
    state[TURNING] = state[DISPLACEMENT]
    state[TURNING_INPUT] = state[MOST_INPUT] = state[INPUT]
    state[TURNING_HYSTERETIC] = state[HYSTERETIC]


@kernel
def _noted(path: NDArray[np.float64], rows: int, time: float, state: NDArray[np.float64]) -> int:
    """Write a row of the path where there is room; return the number of rows written."""
    if rows >= path.shape[0]:
        return rows
    path[rows, PATH_TIME] = time
    path[rows, PATH_DISPLACEMENT] = state[DISPLACEMENT]
    return rows + 1

"""The time loop: from sample to sample of the ground motion, from event to event within."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel
from dcfp.kernels.friction import mean_coefficient
from dcfp.kernels.heat_state import PRESENT, Heat
from dcfp.kernels.law import Law
from dcfp.kernels.motion import Advance, Motion, Push, Structure
from dcfp.kernels.sliding import slide_step
from dcfp.kernels.sticking import stick_step

# how a march can end
DONE, AT_REST, OUT_OF_CELLS, NO_PROGRESS, NO_NUMBER = range(5)

# columns of the histories; temperatures of the plates follow
DISPLACEMENT, VELOCITY, ELONGATION, FRICTION, SIDE, INPUT, HYSTERETIC, TEMPERATURE = range(8)

# entries of the state that a march starts from and leaves behind
(
    STATE_DISPLACEMENT,
    STATE_VELOCITY,
    STATE_ELONGATION,
    STATE_SIDE,
    STATE_TIME,
    STATE_LEVEL,
    STATE_FRESH,
    STATE_INPUT,
    STATE_HYSTERETIC,
    STATE_TURNING,
    PEAK_DISPLACEMENT,
    PEAK_CHANGE,
    PEAK_VELOCITY,
    PEAK_FORCE,
    PEAK_TEMPERATURE,
    LEAST_FRICTION,
    STEPS,
    STATE_SIZE,
) = range(18)
#: From this entry on the state is what is added up or compared on the way.
FIRST_TALLY = STATE_INPUT

_MOST_STEPS_PER_SAMPLE = 20_000


class Tally(NamedTuple):
    """What is added up or compared on the way; see the entries of the state."""

    input: float
    hysteretic: float
    turning: float
    displacement: float
    change: float
    velocity: float
    force: float
    temperature: float
    friction: float


@kernel
def march(
    law: Law,
    structure: Structure,
    heat: Heat,
    acceleration: NDArray[np.float64],
    interval: float,
    coarsest: int,
    free_from: int,
    tolerance: float,
    state: NDArray[np.float64],
    histories: NDArray[np.float64],
) -> tuple[int, int, bool]:
    """Respond to the samples of `acceleration` [mm/s2], `interval` [s] apart.

    Returns how it ended, the samples done, and whether it rests: no more sliding can come if the ground moves no more.
    A sliding step is at most the interval halved `coarsest` times. `state` and `heat` are where it starts from, and
    are left where it ends. Row i + 1 of `histories` is written at sample i + 1. From sample `free_from` on, where the
    ground must have stopped accelerating, it stops as soon as it rests.
    """
    motion = Motion(
        state[STATE_DISPLACEMENT],
        state[STATE_VELOCITY],
        state[STATE_ELONGATION],
        int(state[STATE_SIDE]),
    )
    level = max(int(state[STATE_LEVEL]), coarsest)
    fresh = state[STATE_FRESH] > 0.0
    began = state[STATE_TIME]
    tally = Tally(
        state[STATE_INPUT],
        state[STATE_HYSTERETIC],
        state[STATE_TURNING],
        state[PEAK_DISPLACEMENT],
        state[PEAK_CHANGE],
        state[PEAK_VELOCITY],
        state[PEAK_FORCE],
        state[PEAK_TEMPERATURE],
        state[LEAST_FRICTION],
    )
    friction = abs(motion.elongation) / structure.reach
    done = 0
    status = DONE
    for i in range(acceleration.size - 1):
        rate = (acceleration[i + 1] - acceleration[i]) / interval
        elapsed = 0.0
        steps = 0
        while elapsed < interval:
            room = interval - elapsed
            push = Push(acceleration[i] + rate * elapsed, rate)
            if motion.side == 0:
                advance = stick_step(law, structure, heat, motion, push, room, interval)
                fresh = advance.motion.side != 0
            else:
                now = began + i * interval + elapsed
                advance, level = slide_step(
                    law,
                    structure,
                    heat,
                    fresh,
                    motion,
                    friction,
                    push,
                    now,
                    room,
                    interval,
                    level,
                    coarsest,
                    tolerance,
                )
                fresh = fresh and advance.length == 0.0
            slid = motion.side != 0 and advance.length > 0.0
            motion, friction = advance.motion, advance.friction
            # rounding must not leave a sliver, in which the travel is noise
            elapsed = interval if room - advance.length <= 1e-12 * interval else elapsed + advance.length
            tally = _noted(tally, structure, motion, advance, slid, heat.notes)
            steps += 1
            if not advance.fits:
                status = OUT_OF_CELLS
            elif not math.isfinite(friction + motion.velocity):  # the law may answer so
                status = NO_NUMBER
            elif steps > _MOST_STEPS_PER_SAMPLE:
                status = NO_PROGRESS
            if status != DONE:
                break
        if status != DONE:
            break
        done = i + 1
        state[STEPS] += steps
        _record(histories, done, structure, motion, friction, tally, heat.notes)
        if done >= free_from and _rests(law, structure, heat, motion):
            status = AT_REST
            break
    state[STATE_DISPLACEMENT] = motion.displacement
    state[STATE_VELOCITY] = motion.velocity
    state[STATE_ELONGATION] = motion.elongation
    state[STATE_SIDE] = motion.side
    state[STATE_TIME] = began + done * interval
    state[STATE_LEVEL] = level
    state[STATE_FRESH] = 1.0 if fresh else 0.0
    state[STATE_INPUT] = tally.input
    state[STATE_HYSTERETIC] = tally.hysteretic
    state[STATE_TURNING] = tally.turning
    state[PEAK_DISPLACEMENT] = max(tally.displacement, abs(motion.displacement))
    state[PEAK_CHANGE] = tally.change
    state[PEAK_VELOCITY] = tally.velocity
    state[PEAK_FORCE] = tally.force
    state[PEAK_TEMPERATURE] = tally.temperature
    state[LEAST_FRICTION] = tally.friction
    return status, done, _rests(law, structure, heat, motion)


@kernel
def _noted(
    tally: Tally,
    structure: Structure,
    motion: Motion,
    advance: Advance,
    slid: bool,
    notes: NDArray[np.float64],
) -> Tally:
    """Return the tally after a step."""
    turning, displacement, change = tally.turning, tally.displacement, tally.change
    if not math.isnan(advance.turning):
        displacement = max(displacement, abs(advance.turning))
        change = max(change, abs(advance.turning - turning))
        turning = advance.turning
    force = structure.restoring * motion.displacement + structure.elastic * motion.elongation
    temperature, friction = tally.temperature, tally.friction
    if slid or motion.side != 0:
        friction = min(friction, advance.friction)
        temperature = max(temperature, notes[PRESENT])
        if structure.plates == 2:
            temperature = max(temperature, notes[PRESENT + 1])
    return Tally(
        tally.input + advance.input,
        tally.hysteretic + advance.hysteretic,
        turning,
        displacement,
        change,
        max(tally.velocity, abs(motion.velocity)),
        max(tally.force, abs(force)),
        temperature,
        friction,
    )


@kernel
def _record(
    histories: NDArray[np.float64],
    sample: int,
    structure: Structure,
    motion: Motion,
    friction: float,
    tally: Tally,
    notes: NDArray[np.float64],
) -> None:
    if sample >= histories.shape[0]:
        return
    line = histories[sample]
    line[DISPLACEMENT] = motion.displacement
    line[VELOCITY] = motion.velocity
    line[ELONGATION] = motion.elongation
    line[FRICTION] = friction
    line[SIDE] = motion.side
    line[INPUT] = tally.input
    line[HYSTERETIC] = tally.hysteretic
    for i in range(structure.plates):
        line[TEMPERATURE + i] = notes[PRESENT + i]


@kernel
def _rests(law: Law, structure: Structure, heat: Heat, motion: Motion) -> bool:
    """Whether the free elastic oscillation that is left stays inside the yield surface."""
    if motion.side != 0:
        return False
    stiffness = structure.restoring + structure.elastic
    stuck = motion.displacement - motion.elongation
    centre = structure.elastic * stuck / stiffness
    swing = math.hypot(motion.displacement - centre, motion.velocity / math.sqrt(stiffness))
    for speed in (0.0, swing * math.sqrt(stiffness)):
        friction = mean_coefficient(law, structure, speed, heat.notes, PRESENT)
        if not abs(centre - stuck) + swing < friction * structure.reach:
            return False
    return True

r"""A shear building on the bearing: linear between events, which are found on a grid of ticks.

A fine step has `TICKS` ticks. For each phase and for the step and its halves, quarters and so on down to one tick, the exact
transition of the state under linear inputs is at hand, and with it the integrals that the energies need. A *walk* puts such pieces
together, the longest first, and stops in the tick in which something happens. Over a step of sliding the coefficient of friction is linear
in time, to its value at the speed and the temperature at the end. Everything is per unit of the total mass.
"""

import math
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel
from dcfp.kernels.friction import BearingModel, mean_coefficient, store_ratios
from dcfp.kernels.heat_state import EXPECTED, ODD_LENGTH, POINT, PRESENT, RATIO, Heat
from dcfp.kernels.heating import cool_down, expect, heat_up, prepare, prepare_cooling
from dcfp.kernels.law import Law
from dcfp.kernels.motion import SystemConstants, share
from dcfp.kernels.oscillator import squared_speed

Floats: TypeAlias = NDArray[np.float64]

#: Lengths at hand: the fine step, halved so many times less one; and its ticks.
LEVELS = 21
TICKS = 1 << (LEVELS - 1)
#: Phases.
STICKING, SLIDING = 0, 1
#: Rows of the vectors: the state now, the state walked to, and room for a product.
NOW, WALKED, PRODUCT = 0, 1, 2
#: After displacements and velocities a vector holds the inputs: ground acceleration and push on the base, each with its rate.
GROUND, GROUND_RATE, PUSH, PUSH_RATE, INPUTS = 0, 1, 2, 3, 4

#: Entries of the state beside the vector. Energies are per unit mass [mm2/s2].
(
    ELONGATION,
    FRICTION,
    SIDE,
    FRESH,  # whether sliding has just begun
    ROOM,  # ticks that a slide may take: fewer where spring (b) lags behind
    INPUT,
    HYSTERETIC,
    DAMPED,
    PEAK_TEMPERATURE,
    EVENTS,
    STATE_SIZE,
) = range(11)
#: After the vector's displacements and velocities a line of the histories holds these, then the plates' temperatures.
LINE_ELONGATION, LINE_FRICTION, LINE_SIDE, LINE_INPUT, LINE_HYSTERETIC, LINE_DAMPED, LINE_SIZE = range(7)
#: Rows of the peaks: displacement of the base and drifts, and absolute accelerations.
PEAK_DRIFT, PEAK_ACCELERATION = 0, 1
#: How an integration can end.
DONE, AT_REST, OUT_OF_CELLS, NO_PROGRESS = range(4)

#: Rounds of a sliding step: one looks for its end, one expects the heat, two correct the friction.
_ROUNDS = 4
#: Shortest slide that is tried again where spring (b) lags behind, and shortest way to the edge of the contact [ticks].
_LEAST_ROOM, _SLIVER = TICKS >> 8, TICKS >> 8
_MOST_EVENTS_PER_STEP = 5000


class Building(NamedTuple):
    """A building's constants, and the vectors to work with."""

    floors: int  # with the base
    step: float  # [s]
    inertia: Floats  # masses over the total one [-], shape (floors,)
    stiffness: Floats  # of the storeys [1/s2]; the first entry, the base's, is not used
    resistance: Floats  # absolute accelerations by state, without spring (b), (floors, 2 floors)
    steps: Floats  # (2, LEVELS, 2 floors + INPUTS, 2 floors + 2); two integrals come last
    losses: Floats  # energy lost to damping, a quadratic form; no levels where undamped
    vectors: Floats  # (3, 2 floors + INPUTS)


class Walk(NamedTuple):
    """Outcome of a walk; the state is in its vector, with displacements from where the base was."""

    ticks: int
    event: bool
    input: float
    push: float  # work of the push on the base
    damped: float


@kernel
def _yields(
    law: Law, system: SystemConstants, heat: Heat, elongation: float, speed: float, outside: float
) -> bool:
    """Whether spring (b) goes out through the yield surface, or is more than `outside` [mm] beyond it."""
    if elongation * speed < 0.0:
        return False
    friction = mean_coefficient(BearingModel(law, system, heat), abs(speed), PRESENT)
    return abs(elongation) - friction * system.yield_per_mu > outside


@kernel
def _walk(
    law: Law,
    system: SystemConstants,
    heat: Heat,
    building: Building,
    phase: int,
    going: float,
    elongation: float,
    outside: float,
    most: int,
    push: float,
    push_rate: float,
) -> Walk:
    """Walk at most so many ticks from the state now, and no further than the tick in which the base turns or starts to slide."""
    floors = building.floors
    size = 2 * floors
    start, now, after = building.vectors[NOW], building.vectors[WALKED], building.vectors[PRODUCT]
    for i in range(size + PUSH):
        now[i] = start[i] - start[0] if i < floors else start[i]
    now[size + PUSH] = push
    now[size + PUSH_RATE] = push_rate
    level, done = 0, 0
    input_work, push_work, damped = 0.0, 0.0, 0.0
    happens = False
    while done < most and not happens:
        while (TICKS >> level) > most - done:
            level += 1
        piece = building.steps[phase, level]
        for i in range(size + 2):
            after[i] = 0.0
        for j in range(size + INPUTS):
            factor = now[j]
            for i in range(size + 2):
                after[i] += piece[j, i] * factor
        happens = going * after[floors] < 0.0
        if phase == STICKING and not happens:
            happens = _yields(law, system, heat, elongation + after[0], after[floors], outside)
        if happens and level < LEVELS - 1:
            level += 1
            happens = False
            continue
        length = building.step * (TICKS >> level) / TICKS
        moved, reached = 0.0, 0.0
        for i in range(floors):
            moved += building.inertia[i] * (after[i] - now[i])
            reached += building.inertia[i] * after[i]
        ground, rate = now[size + GROUND], now[size + GROUND_RATE]
        input_work -= ground * moved + rate * (length * reached - after[size])
        rate = now[size + PUSH_RATE]
        push_work += now[size + PUSH] * (after[0] - now[0]) + rate * (length * after[0] - after[size + 1])
        if building.losses.shape[1] > 0:
            loss = building.losses[phase, level]
            for j in range(size + INPUTS):
                part = 0.0
                for i in range(size + INPUTS):
                    part += loss[j, i] * now[i]
                damped += part * now[j]
        for i in range(size):
            now[i] = after[i]
        now[size + GROUND] += length * now[size + GROUND_RATE]
        now[size + PUSH] += length * now[size + PUSH_RATE]
        done += TICKS >> level
    return Walk(done, happens, input_work, push_work, damped)


@kernel
def _take(building: Building, state: Floats, walked: Walk) -> None:
    """Make the state that was walked to the state now."""
    now, there = building.vectors[NOW], building.vectors[WALKED]
    origin = now[0]
    for i in range(2 * building.floors + PUSH):
        now[i] = origin + there[i] if i < building.floors else there[i]
    state[INPUT] += walked.input
    state[DAMPED] += walked.damped


@kernel
def _acceleration(building: Building, system: SystemConstants, elongation: float, floor: int) -> float:
    """Absolute acceleration of a floor [mm/s2]."""
    now = building.vectors[NOW]
    total = -system.elastic * elongation / building.inertia[0] if floor == 0 else 0.0
    for j in range(2 * building.floors):
        total += building.resistance[floor, j] * now[j]
    return total


@kernel
def _stick(
    law: Law, system: SystemConstants, heat: Heat, building: Building, state: Floats, most: int
) -> int:
    """Stick for at most so many ticks, or until the base turns or slides; return the ticks it took."""
    now, floors = building.vectors[NOW], building.floors
    elongation, origin, speed = state[ELONGATION], now[0], now[floors]
    going = speed
    if speed == 0.0:
        going = _acceleration(building, system, elongation, 0) - now[2 * floors + GROUND]
    # a sticking phase begins on the surface, as closely as the end of sliding was found: it slides where it goes further out
    friction = mean_coefficient(BearingModel(law, system, heat), abs(speed), PRESENT)
    outside = max(0.0, abs(elongation) - friction * system.yield_per_mu)
    push = -system.restoring * origin - system.elastic * elongation
    walked = _walk(law, system, heat, building, STICKING, going, elongation, outside, most, push, 0.0)
    _take(building, state, walked)
    elongation += now[0] - origin
    speed = now[floors]
    state[ELONGATION] = elongation
    if walked.event and _yields(law, system, heat, elongation, speed, outside):
        state[SIDE] = 1.0 if elongation > 0.0 else -1.0
        state[FRICTION] = abs(elongation) / system.yield_per_mu
        state[FRESH] = 1.0
    place = 0 if walked.ticks == TICKS else ODD_LENGTH
    prepare_cooling(heat, place, building.step * walked.ticks / TICKS)
    cool_down(heat, system, place)
    if state[SIDE] == 0.0:
        state[FRICTION] = mean_coefficient(BearingModel(law, system, heat), abs(speed), PRESENT)
    return walked.ticks


@kernel
def _slide(
    law: Law, system: SystemConstants, heat: Heat, building: Building, state: Floats, most: int, time: float
) -> tuple[int, bool]:
    """Slide for at most so many ticks, or until the base stops; return the ticks it took and whether the cells sufficed."""
    now, there, floors = building.vectors[NOW], building.vectors[WALKED], building.floors
    side, friction, elongation = state[SIDE], state[FRICTION], state[ELONGATION]
    origin, opening_speed = now[0], abs(now[floors])
    pull, pendulum = -side * system.gravity, system.restoring * origin
    most = min(most, int(state[ROOM]))
    slope, length, place = 0.0, 0.0, 0
    walked, travel = Walk(0, False, 0.0, 0.0, 0.0), 0.0
    for round_ in range(_ROUNDS):
        push = pull * friction - pendulum
        walked = _walk(law, system, heat, building, SLIDING, side, 0.0, 0.0, most, push, pull * slope)
        length = building.step * walked.ticks / TICKS
        travel = there[0]
        if round_ == 0:
            if walked.event:  # with the friction corrected it may come later
                most = min(most, 2 * walked.ticks)
            most = min(most, _ticks_to_edge(heat, system, origin, travel, walked.ticks))
            continue
        if round_ == _ROUNDS - 1:
            break
        speed = 0.0 if walked.event else abs(there[floors])
        if round_ == 1:
            place = 0 if walked.ticks == TICKS else ODD_LENGTH
            flux = system.pressure * friction
            prepare(heat, place, length)
            rubbing = system.pressure * squared_speed(length, opening_speed, speed, abs(travel))
            middle, closing = origin + 0.5 * travel, flux * speed
            expect(heat, system, place, time, middle, travel, flux * opening_speed, closing, rubbing)
        slope = (mean_coefficient(BearingModel(law, system, heat), speed, EXPECTED) - friction) / length
    last = friction + slope * length
    reach = side * last * system.yield_per_mu
    if side * (travel - reach + elongation) < 0.0 and walked.ticks > 1:
        # spring (b) lags behind, for the force can grow faster than the yield force: it slides for a shorter time, or it sticks
        if walked.ticks > _LEAST_ROOM:
            state[ROOM] = walked.ticks // 2
            return 0, True
        if state[FRESH] == 0.0:
            state[SIDE] = 0.0
            return 0, True
    _take(building, state, walked)
    if walked.event:
        now[floors] = 0.0
        state[SIDE] = 0.0
    speed = abs(now[floors])
    state[FRESH] = 0.0
    state[ROOM] = min(2.0 * max(state[ROOM], walked.ticks), TICKS)
    rubbed = -(walked.push + pendulum * travel)
    stored = 0.5 * system.elastic * (reach * reach - elongation * elongation)
    state[HYSTERETIC] += rubbed - stored
    state[ELONGATION], state[FRICTION] = reach, last
    opening, closing = system.pressure * friction * opening_speed, system.pressure * last * speed
    # the flux is taken as linear, and raised so that the heat is the work of friction
    missing = system.pressure * abs(rubbed) / (system.gravity * length) - 0.5 * (opening + closing)
    place = 0 if walked.ticks == TICKS else ODD_LENGTH
    prepare(heat, place, length)
    store_ratios(BearingModel(law, system, heat), speed, EXPECTED, RATIO)
    rubbing = system.pressure * squared_speed(length, opening_speed, speed, abs(travel))
    middle, end, time = origin + 0.5 * travel, now[0], time + length
    opening += missing
    fits = heat_up(
        heat, system, place, time, length, end, middle, opening, closing + missing, closing, rubbing
    )
    for i in range(system.plates):
        state[PEAK_TEMPERATURE] = max(state[PEAK_TEMPERATURE], heat.workspace[PRESENT + i])
    return walked.ticks, fits


@kernel
def _ticks_to_edge(heat: Heat, system: SystemConstants, origin: float, travel: float, ticks: int) -> int:
    """Return after how many ticks a plate's monitoring point comes under the slider or leaves it, Eq. (12); all if none does."""
    earliest = TICKS
    if heat.kind != POINT:
        return earliest
    end = origin + travel
    for i in range(system.plates):
        portion = share(system, i)
        if (portion * abs(origin) <= heat.half_contact) == (portion * abs(end) <= heat.half_contact):
            continue
        outer = end if abs(end) > abs(origin) else origin
        edge = int(ticks * (math.copysign(heat.half_contact / portion, outer) - origin) / travel)
        if _SLIVER < edge < ticks - _SLIVER:
            earliest = min(earliest, edge)
    return earliest


@kernel
def integrate_building(
    law: Law,
    system: SystemConstants,
    heat: Heat,
    building: Building,
    acceleration: Floats,
    parts: int,
    free_from: int,
    state: Floats,
    peaks: Floats,
    histories: Floats,
) -> tuple[int, int, bool]:
    """Respond to samples of the ground acceleration [mm/s2], `parts` fine steps apart.

    Returns how it ended, the samples done, and whether it rests: no more sliding can come if the ground moves no more. From
    sample `free_from` on, where the ground must have stopped accelerating, it stops as soon as it rests.
    """
    now, size = building.vectors[NOW], 2 * building.floors
    status, done = DONE, 0
    _record(system, heat, building, state, histories[0])
    for i in range(acceleration.size - 1):
        rate = (acceleration[i + 1] - acceleration[i]) / (parts * building.step)
        now[size + GROUND_RATE] = rate
        for part in range(parts):
            now[size + GROUND] = acceleration[i] + rate * building.step * part
            left, events = TICKS, 0
            while left > 0 and status == DONE:
                if state[SIDE] == 0.0:
                    left -= _stick(law, system, heat, building, state, left)
                else:
                    time = building.step * (i * parts + part + (TICKS - left) / TICKS)
                    ticks, fits = _slide(law, system, heat, building, state, left, time)
                    left -= ticks
                    if not fits:
                        status = OUT_OF_CELLS
                _note_peaks(building, system, state, peaks)
                events += 1
                if events > _MOST_EVENTS_PER_STEP:
                    status = NO_PROGRESS
            state[EVENTS] += events
        if status != DONE:
            break
        done = i + 1
        _record(system, heat, building, state, histories[done])
        if done >= free_from and _rests(law, system, heat, building, state):
            status = AT_REST
            break
    return status, done, _rests(law, system, heat, building, state)


@kernel
def _note_peaks(building: Building, system: SystemConstants, state: Floats, peaks: Floats) -> None:
    """Note displacement, drifts and accelerations, if they are the largest; a drift that turns within half a step, where it turns."""
    now, floors, below = building.vectors[NOW], building.floors, 0.0
    for i in range(floors):
        acceleration = _acceleration(building, system, state[ELONGATION], i)
        drift = now[i] - now[i - 1] if i > 0 else now[i]
        rate, change = now[floors + i] - now[floors + i - 1], acceleration - below
        if i > 0 and 2.0 * abs(rate) < building.step * abs(change):
            drift -= 0.5 * rate * rate / change
        peaks[PEAK_DRIFT, i] = max(peaks[PEAK_DRIFT, i], abs(drift))
        peaks[PEAK_ACCELERATION, i] = max(peaks[PEAK_ACCELERATION, i], abs(acceleration))
        below = acceleration


@kernel
def _record(system: SystemConstants, heat: Heat, building: Building, state: Floats, line: Floats) -> None:
    size = 2 * building.floors
    for i in range(size):
        line[i] = building.vectors[NOW, i]
    line[size + LINE_ELONGATION] = state[ELONGATION]
    line[size + LINE_FRICTION] = state[FRICTION]
    line[size + LINE_SIDE] = state[SIDE]
    line[size + LINE_INPUT] = state[INPUT]
    line[size + LINE_HYSTERETIC] = state[HYSTERETIC]
    line[size + LINE_DAMPED] = state[DAMPED]
    for i in range(system.plates):
        line[size + LINE_SIZE + i] = heat.workspace[PRESENT + i]


@kernel
def _rests(law: Law, system: SystemConstants, heat: Heat, building: Building, state: Floats) -> bool:
    """Whether all the energy of the free vibration that is left, brought into the base, would leave it inside the yield surface."""
    if state[SIDE] != 0.0:
        return False
    now, floors = building.vectors[NOW], building.floors
    stiffness = system.restoring + system.elastic
    stuck = now[0] - state[ELONGATION]
    centre = system.elastic * stuck / stiffness
    twice = stiffness * (now[0] - centre) ** 2
    for i in range(floors):
        twice += building.inertia[i] * now[floors + i] ** 2
        if i > 0:
            twice += building.stiffness[i] * (now[i] - now[i - 1]) ** 2
    for speed in (0.0, math.sqrt(twice / building.inertia[0])):
        friction = mean_coefficient(BearingModel(law, system, heat), speed, PRESENT)
        if abs(centre - stuck) + math.sqrt(twice / stiffness) >= friction * system.yield_per_mu:
            return False
    return True

"""The virtual test machine: sticking and sliding along a prescribed path, from event to event.

Friction is the same elastic-plastic spring (b) as in the response analysis: it sticks while the spring is inside the yield surface,
and slides while the centre of that surface is dragged along. Here the motion is known, so only the coefficient, the heat and the
work have to follow it.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel
from dcfp.kernels.friction import Law, mean_coefficient, note_ratios, with_reference
from dcfp.kernels.heat_state import BETWEEN, EXPECTED, FINEST_LEVEL, ODD_LENGTH, POINT, PRESENT, RATIO, Heat
from dcfp.kernels.heating import cool_down, expect, expect_cooling, heat_up, mix, prepare, prepare_cooling
from dcfp.kernels.motion import Structure, share
from dcfp.kernels.path import (
    Piece,
    displacement_at,
    load_at,
    next_turn,
    reference_at,
    time_at,
    velocity_at,
)
from dcfp.kernels.sliding import HALVES, next_length

# how a drive can end
DONE, OUT_OF_CELLS, NO_PROGRESS = range(3)

# columns of the histories; temperatures of the plates follow
DISPLACEMENT, VELOCITY, ELONGATION, FRICTION, SIDE, LOAD, WORK, HYSTERETIC, TEMPERATURE = range(9)

# entries of the state that a drive starts from and leaves behind
(
    STATE_ELONGATION,
    STATE_SIDE,
    STATE_LEVEL,
    STATE_FRESH,
    STATE_TIME,
    STATE_WORK,
    STATE_HYSTERETIC,
    STATE_STEPS,
    STATE_SIZE,
) = range(9)

_MOST_STEPS_PER_PIECE = 20_000
#: How close to the yield surface the start of sliding is found [mm].
_CLOSE = 1e-10
#: Part of a step within which what is outside of the surface was so from the start [-].
_AT_ONCE = 1e-3
# four points of Gauss on (0, 1): exact for the work, whose integrands are of the sixth order in time
_POINTS = (0.06943184420297371, 0.33000947820757187, 0.6699905217924281, 0.9305681557970263)
_PARTS = (0.17392742256872692, 0.32607257743127307, 0.32607257743127307, 0.17392742256872692)


class Rig(NamedTuple):
    """The bearing in the machine."""

    area: float  # of the slider [mm2]
    radius: float  # effective radius of the bearing [mm]
    elastic: float  # stiffness kf of spring (b) [N/mm]


class Grip(NamedTuple):
    """State of spring (b)."""

    elongation: float  # [mm]
    side: int  # of sliding; 0 while sticking
    friction: float  # coefficient: mobilised while sliding, available while sticking


class Stroke(NamedTuple):
    """Outcome of one step, which may have been refused (length 0)."""

    grip: Grip
    length: float  # [s]
    work: float  # of the machine on the bearing [N mm]
    hysteretic: float  # dissipated by friction [N mm]
    fits: bool  # False if the heating model ran out of cells


@kernel
def drive(
    law: Law,
    structure: Structure,
    rig: Rig,
    heat: Heat,
    lengths: NDArray[np.float64],
    pieces: NDArray[np.float64],
    tolerance: float,
    state: NDArray[np.float64],
    histories: NDArray[np.float64],
) -> tuple[int, int]:
    """Follow the path; return how it ended and the pieces done.

    A row of `pieces` holds the fields of a `Piece`, `lengths` how long each lasts [s]. `state` and `heat` are where it starts from,
    and are left where it ends. Row i + 1 of `histories` is written at the end of piece i.
    """
    grip = Grip(state[STATE_ELONGATION], int(state[STATE_SIDE]), histories[0, FRICTION])
    level = int(state[STATE_LEVEL])
    fresh = state[STATE_FRESH] > 0.0
    work, hysteretic = state[STATE_WORK], state[STATE_HYSTERETIC]
    clock = state[STATE_TIME]
    for i in range(lengths.size):
        row = pieces[i]
        piece = Piece(row[0], row[1], row[2], row[3], row[4], row[5], row[6], row[7])
        interval = lengths[i]
        now = 0.0
        steps = 0
        while now < interval:
            room = interval - now
            if grip.side == 0:
                stroke = _stick(law, structure, rig, heat, piece, grip, now, room, interval)
                fresh = stroke.grip.side != 0
            else:
                stroke, level = _slide(
                    law,
                    structure,
                    rig,
                    heat,
                    piece,
                    grip,
                    clock,
                    now,
                    room,
                    interval,
                    level,
                    fresh,
                    tolerance,
                )
                fresh = fresh and stroke.length == 0.0
            grip = stroke.grip
            work += stroke.work
            hysteretic += stroke.hysteretic
            # rounding must not leave a sliver, in which the travel is noise
            now = interval if room - stroke.length <= 1e-12 * interval else now + stroke.length
            steps += 1
            if not stroke.fits:
                return OUT_OF_CELLS, i
            if steps > _MOST_STEPS_PER_PIECE:
                return NO_PROGRESS, i
        clock += interval
        state[STATE_STEPS] += steps
        line = histories[i + 1]
        line[DISPLACEMENT] = displacement_at(piece, interval)
        line[VELOCITY] = velocity_at(piece, interval)
        line[ELONGATION] = grip.elongation
        line[FRICTION] = grip.friction
        line[SIDE] = grip.side
        line[LOAD] = load_at(piece, interval)
        line[WORK] = work
        line[HYSTERETIC] = hysteretic
        for j in range(structure.plates):
            line[TEMPERATURE + j] = heat.notes[PRESENT + j]
    state[STATE_ELONGATION] = grip.elongation
    state[STATE_SIDE] = grip.side
    state[STATE_LEVEL] = level
    state[STATE_FRESH] = 1.0 if fresh else 0.0
    state[STATE_TIME] = clock
    state[STATE_WORK] = work
    state[STATE_HYSTERETIC] = hysteretic
    return DONE, lengths.size


@kernel
def _under(structure: Structure, rig: Rig, load: float) -> Structure:
    """Return the structure under another vertical force [N]."""
    return Structure(
        structure.restoring,
        structure.elastic,
        structure.gravity,
        load / rig.area,
        load / rig.elastic,
        structure.plates,
        structure.first_share,
        structure.second_share,
        structure.first_speed,
        structure.second_speed,
    )


@kernel
def available(
    law: Law, structure: Structure, rig: Rig, heat: Heat, piece: Piece, time: float, first: int
) -> float:
    """Coefficient of friction [-] at a time in a piece, at the temperatures noted from entry `first` on."""
    here = _under(structure, rig, load_at(piece, time))
    at_load = with_reference(law, reference_at(piece, time))
    return mean_coefficient(at_load, here, abs(velocity_at(piece, time)), heat.notes, first)


@kernel
def _pendulum_work(rig: Rig, piece: Piece, now: float, length: float) -> float:
    """Work against spring (a), N / R y dy, over a step [N mm]."""
    total = 0.0
    for k in range(4):
        t = now + length * _POINTS[k]
        total += _PARTS[k] * load_at(piece, t) * displacement_at(piece, t) * velocity_at(piece, t)
    return total * length / rig.radius


@kernel
def _stick(
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
    work = stored + _pendulum_work(rig, piece, now, length)
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


@kernel
def _slide(
    law: Law,
    structure: Structure,
    rig: Rig,
    heat: Heat,
    piece: Piece,
    grip: Grip,
    clock: float,
    now: float,
    room: float,
    interval: float,
    level: int,
    fresh: bool,
    tolerance: float,
) -> tuple[Stroke, int]:
    """Slide for at most `room` [s]; return the step and the level of halving for the next one.

    `clock` [s] is the time at the start of the piece; `fresh` says that sliding has just begun.
    """
    y, v = displacement_at(piece, now), velocity_at(piece, now)
    friction = grip.friction
    opening = friction * load_at(piece, now) / rig.area * abs(v)
    while True:
        regular = interval * HALVES[level]
        length = next_length(regular, room)
        turn = next_turn(piece, now, now + length)
        if turn < now + length:
            length = turn - now
        if heat.kind == POINT:
            length = _until_leaving(heat, structure, piece, y, now, length)
        end = now + length
        here = _under(structure, rig, load_at(piece, end))
        travel, speed = displacement_at(piece, end) - y, abs(velocity_at(piece, end))
        place = level if length == regular else ODD_LENGTH
        prepare(heat, place, length)
        rubbing = here.pressure * travel * travel / length
        ending = friction * here.pressure * speed
        expect(heat, structure, place, clock + now, y + 0.5 * travel, travel, opening, ending, rubbing)
        last = available(law, structure, rig, heat, piece, end, EXPECTED)
        if (
            abs(last - friction) > 0.1 * tolerance * last
        ):  # once more, with the heat of the friction at the end
            ending = last * here.pressure * speed
            expect(heat, structure, place, clock + now, y + 0.5 * travel, travel, opening, ending, rubbing)
            last = available(law, structure, rig, heat, piece, end, EXPECTED)
        bend = 0.0
        if abs(last - friction) > tolerance * last:
            mix(heat, structure, 0.5, BETWEEN)
            central = available(law, structure, rig, heat, piece, now + 0.5 * length, BETWEEN)
            bend = central - 0.5 * (friction + last)
            if abs(bend) > tolerance * last and level < FINEST_LEVEL:
                level += 1
                continue
        if abs(bend) < 0.2 * tolerance * last and level > 0 and not fresh:
            level -= 1
        break

    reach = grip.side * last * here.reach
    if grip.side * (travel - reach + grip.elongation) < 0.0:
        # spring (b) lags behind: the force can grow faster than the yield force, so this is sticking
        if not fresh:
            return Stroke(Grip(grip.elongation, 0, friction), 0.0, 0.0, 0.0, True), level
        if level < FINEST_LEVEL:  # it has just begun to slide: once more, with a shorter step
            return Stroke(grip, 0.0, 0.0, 0.0, True), level + 1

    rubbed, squared = 0.0, 0.0
    for k in range(4):
        part = _POINTS[k]
        mobilised = friction + part * ((last - friction) + 4.0 * bend * (1.0 - part))
        rate = velocity_at(piece, now + part * length)
        carried = _PARTS[k] * length * load_at(piece, now + part * length)
        rubbed += carried * mobilised * rate
        squared += carried * rate * rate
    closing = here.pressure * last * speed
    # the flux is taken as linear, and raised so that the heat is the work of friction
    missing = abs(rubbed) / (rig.area * length) - 0.5 * (opening + closing)
    note_ratios(with_reference(law, reference_at(piece, end)), here, speed, heat.notes, EXPECTED, RATIO)
    fits = heat_up(
        heat,
        structure,
        place,
        clock + end,
        length,
        y + travel,
        displacement_at(piece, now + 0.5 * length),
        opening + missing,
        closing + missing,
        closing,
        squared / rig.area,
    )
    against = grip.side * rubbed
    stored = 0.5 * rig.elastic * (reach * reach - grip.elongation * grip.elongation)
    work = against + _pendulum_work(rig, piece, now, length)
    return Stroke(Grip(reach, grip.side, last), length, work, against - stored, fits), level


@kernel
def _until_leaving(
    heat: Heat, structure: Structure, piece: Piece, displacement: float, now: float, length: float
) -> float:
    """Cut a step where a plate's monitoring point comes under the slider or leaves it: Eq. (12)."""
    shortest = length
    end = displacement_at(piece, now + length)
    for i in range(structure.plates):
        portion = share(structure, i)
        inside = portion * abs(displacement) <= heat.half_contact
        if inside == (portion * abs(end) <= heat.half_contact):
            continue
        outer = displacement if abs(displacement) > abs(end) else end
        target = math.copysign(heat.half_contact / portion, outer)
        cut = time_at(piece, now, now + length, target) - now
        if cut > 1e-9 * length:
            shortest = min(shortest, cut)
    return shortest

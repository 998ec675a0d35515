"""One step of sliding along a prescribed path, while the centre of the yield surface is dragged along."""

import math

from dcfp.kernels._jit import kernel
from dcfp.kernels.friction import note_ratios, with_reference
from dcfp.kernels.grip import GAUSS_PARTS, GAUSS_POINTS, Grip, Rig, Stroke, available, pendulum_work, under
from dcfp.kernels.heat_state import BETWEEN, EXPECTED, FINEST_LEVEL, ODD_LENGTH, POINT, RATIO, Heat
from dcfp.kernels.heating import expect, heat_up, mix, prepare
from dcfp.kernels.law import Law
from dcfp.kernels.motion import Structure, share
from dcfp.kernels.path import Piece, displacement_at, load_at, next_turn, reference_at, time_at, velocity_at
from dcfp.kernels.sliding import HALVES, next_length


@kernel
def slide_driven(
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
        here = under(structure, rig, load_at(piece, end))
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
        part = GAUSS_POINTS[k]
        mobilised = friction + part * ((last - friction) + 4.0 * bend * (1.0 - part))
        rate = velocity_at(piece, now + part * length)
        carried = GAUSS_PARTS[k] * length * load_at(piece, now + part * length)
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
    work = against + pendulum_work(rig, piece, now, length)
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

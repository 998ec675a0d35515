"""The virtual test machine in the plane: a prescribed path in cubic pieces, under a vertical load that changes linearly.

The displacement is known, so that only spring (b), the coefficient, the heat and the works have to follow it. Everything is per unit mass of the structure that the bearing is
for, and the load is over that at rest. In a step the path is looked at where it begins, in the middle and at its end, with its own velocities there: nothing is taken from chords
that are longer than half a step.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels import plane_heat
from dcfp.kernels._jit import Records, called_kernel, fields_of, kernel, record_type
from dcfp.kernels.friction import BearingModel
from dcfp.kernels.heat_state import (
    COMMON,
    DISC,
    INSIDE,
    MOST_HALVINGS,
    NO_HEATING,
    ODD_LENGTH,
    PLATE_ROW,
    PLATE_ROWS,
    PRESENT,
)
from dcfp.kernels.heating import prepare, prepare_cooling
from dcfp.kernels.imposed_motion import GAUSS_PARTS, GAUSS_POINTS
from dcfp.kernels.motion import DONE, NO_NUMBER, OUT_OF_CELLS, share
from dcfp.kernels.plane_heat import COVERED_POINTS, HOTTEST, PEAK_ROW, Field
from dcfp.kernels.plane_integrate import LENGTHS, PARTS, SLIDES, record_motion
from dcfp.kernels.plane_slide import AT_THE_EDGE, EASY, Load, PlaneMotion, begun, friction_between, rub, under
from dcfp.kernels.plane_step import dot, elongation_after, length_of, through, times
from dcfp.kernels.sum_of_exponentials import total

# columns of the histories of a test after those of the motion; temperatures of the plates follow
LOAD, WORK, PENDULUM, HYSTERETIC, LENGTH, POINT, TEMPERATURE = range(SLIDES + 1, SLIDES + 8)

#: Travel on a plate in a step over the distance of its points, at most [-].
_PART_OF_CELL = 0.25


class PathPiece(NamedTuple):
    """One piece of a path; time t in it starts from zero. The position is ``position`` + ``velocity`` t + ``second`` t2 + ``third`` t3, x + i y."""

    position: complex  # [mm]
    velocity: complex  # [mm/s]
    second: complex  # [mm/s2]
    third: complex  # [mm/s3]
    load: float  # over the load at rest [-]
    load_rate: float  # [1/s]
    reference: float  # of the friction law at the pressure of this load [-]
    reference_rate: float  # [1/s]


class Sums(NamedTuple):
    """What is added up on the way, per unit mass [mm2/s2]."""

    work: float  # of the machine
    pendulum: float  # against spring (a)
    hysteretic: float  # of the friction: mu N |slip|
    length: float  # of the path [mm]


class Dragged(NamedTuple):
    """What a step along the path brings."""

    motion: PlaneMotion
    sums: Sums
    accepted: bool
    easy: bool  # the next one may be longer
    fits: bool  # False if the slider left the grid


PATH_PIECE = record_type(PathPiece)


@kernel
def _position(piece: PathPiece, t: float) -> complex:
    return (
        piece.position + times(t, piece.velocity) + times(t * t, piece.second) + times(t * t * t, piece.third)
    )


@kernel
def _velocity(piece: PathPiece, t: float) -> complex:
    return piece.velocity + times(2.0 * t, piece.second) + times(3.0 * t * t, piece.third)


@kernel
def _load(piece: PathPiece, now: float, length: float) -> Load:
    """Return the vertical load over a step."""
    middle, end = now + 0.5 * length, now + length
    return Load(
        True,
        piece.load + now * piece.load_rate,
        piece.load + middle * piece.load_rate,
        piece.load + end * piece.load_rate,
        piece.reference + middle * piece.reference_rate,
        piece.reference + end * piece.reference_rate,
    )


@called_kernel
def follow(
    model: BearingModel,
    field: Field,
    lengths: NDArray[np.float64],
    pieces: Records,
    tolerance: float,
    begins: float,
    histories: NDArray[np.float64],
) -> tuple[int, int]:
    """Follow a path; return how it ended and the pieces done.

    A row of `pieces` is a `PathPiece`, `lengths` how long each lasts [s]; `tolerance` is how far the friction may be from its chord in the middle of a step, over mu N [-].
    It `begins` at a time since the plates were cold [s], spring (b) without force; the model's heat and the field are where it starts from, and are left where it ends. Row i + 1 of
    `histories` is written at the end of piece i, row 0 at the start.
    """
    first = PathPiece(*fields_of(pieces[0]))
    still = PlaneMotion(first.position, first.velocity, 0j, 0.0, 0.0, False, 0j, 0j)
    motion, sums = begun(under(model, first.load, first.reference), still), Sums(0.0, 0.0, 0.0, 0.0)
    level, clock = 0, begins
    _record(histories[0], model, field, motion, sums, first.load)
    status, done = DONE, 0
    for i in range(lengths.size):
        piece = PathPiece(*fields_of(pieces[i]))
        interval: float = lengths[i]
        fewest, place = _fewest_halvings(model, field, piece, interval), 0
        level = max(level, fewest)
        while place < PARTS:
            length, now = interval * LENGTHS[level], place * (interval * (1.0 / PARTS))
            prepare(model.heat, level, length)
            step = _drag(model, field, piece, tolerance, motion, sums, level, now, length, clock + now)
            if not step.accepted:
                level += 1
                continue
            motion, sums = step.motion, step.sums
            place += PARTS >> level
            if step.easy and level > fewest and place % (PARTS >> (level - 1)) == 0:
                level -= 1
            if not math.isfinite(motion.friction + motion.elongation.real + motion.elongation.imag):
                status = NO_NUMBER  # the law may answer so
            elif not step.fits:
                status = OUT_OF_CELLS
            if status != DONE:
                break
        if status != DONE:
            break
        clock += interval
        done = i + 1
        _record(histories[done], model, field, motion, sums, piece.load + interval * piece.load_rate)
    return status, done


@kernel
def _fewest_halvings(model: BearingModel, field: Field, piece: PathPiece, interval: float) -> int:
    """How often a piece must be halved for the rim to pass few points of a plate in a step."""
    if model.heat.kind != DISC:
        return 0
    speed = max(length_of(piece.velocity), length_of(_velocity(piece, interval)))
    travel = max(model.system.first_share, model.system.second_share) * speed * interval
    halvings = 0
    while halvings < MOST_HALVINGS and travel > _PART_OF_CELL * field.spacing * (1 << halvings):
        halvings += 1
    return halvings


@kernel
def _drag(
    model: BearingModel,
    field: Field,
    piece: PathPiece,
    tolerance: float,
    begin: PlaneMotion,
    sums: Sums,
    level: int,
    now: float,
    length: float,
    time: float,
) -> Dragged:
    """Take a step from `now` on in a piece, at a `time` [s] of the field; it is accepted if the friction is close enough to its chord in the middle."""
    system, h, load = model.system, length, _load(piece, now, length)
    u, u_m, u_1 = begin.displacement, _position(piece, now + 0.5 * h), _position(piece, now + h)
    # the velocity may jump where pieces meet
    v, v_m, v_1 = _velocity(piece, now), _velocity(piece, now + 0.5 * h), _velocity(piece, now + h)
    s0, s_m, s_1 = length_of(v), length_of(v_m), length_of(v_1)
    r0, r1 = length_of(u), length_of(u_1)
    e, radius, mu, pressure = begin.elongation, begin.yield_radius, begin.friction, system.pressure
    rubbing = pressure * load.middle * (h / 6.0) * (s0 * s0 + 4.0 * s_m * s_m + s_1 * s_1)
    opening = pressure * load.start * mu * s0 if begin.slides else 0.0
    e_m, e_1, mu_m, mu_1, radius_m, radius_1 = e, e, mu, mu, radius, radius
    slid, sliding = begin.slides, True
    plane_heat.expect_cooling(model.heat, field, system, level, h)
    for _ in range(2):
        closing = pressure * load.end * mu_1 * s_1 if sliding else 0.0
        mu_m, mu_1 = friction_between(model, load, level, r0, r1, s_m, s_1, opening, closing, rubbing)
        radius_m, radius_1 = mu_m * system.yield_per_mu * load.middle, mu_1 * system.yield_per_mu * load.end
        e_m, slid = elongation_after(e, radius, radius_m, u_m - u, v, v_m)
        e_1, sliding = elongation_after(e_m, radius_m, radius_1, u_1 - u_m, v_m, v_1)
    kf = system.elastic
    defect = kf * length_of(e_m - times(0.5, e + e_1))
    allowed = tolerance * mu_1 * system.gravity * load.end
    motion = PlaneMotion(u_1, v_1, e_1, radius_1, mu_1, sliding, 0j, 0j)
    if level < MOST_HALVINGS and (
        defect > allowed
        or (level < AT_THE_EDGE and plane_heat.crosses_edge(model.heat, system, r0, r1))
    ):  # fmt: skip
        return Dragged(motion, sums, False, False, True)

    first, second = length_of((u_m - u) - (e_m - e)), length_of((u_1 - u_m) - (e_1 - e_m))
    force, force_m, force_1 = (
        mu * system.gravity * load.start,
        mu_m * system.gravity * load.middle,
        mu_1 * system.gravity * load.end,
    )
    slipped = 0.5 * ((force + force_m) * first + (force_m + force_1) * second)
    along, along_m, along_1 = _along(v, e), _along(v_m, e_m), _along(v_1, e_1)
    if begin.slides and slid and sliding and along > 0.0:
        # the anchor goes at the part of the velocity along the elongation less the growth of the yield surface
        rubbed = (h / 6.0) * (force * along + 4.0 * force_m * along_m + force_1 * along_1)
        slipped = max(rubbed - 0.5 * kf * (radius_1 * radius_1 - radius * radius), 0.0)
    fits = True
    if slipped > 0.0:
        closing = pressure * load.end * mu_1 * s_1 if sliding else 0.0
        flux = pressure / system.gravity * slipped / h
        fits = rub(model, field, level, time, h, u, u_m, u_1, flux, opening, closing, s_1, rubbing)
    else:
        plane_heat.cool_down(model.heat, field, system, level, h)
    work, pendulum = _works(model, piece, load, now, h, e, e_m, e_1)
    sums = Sums(
        sums.work + work + pendulum,
        sums.pendulum + pendulum,
        sums.hysteretic + slipped,
        sums.length + (h / 6.0) * (s0 + 4.0 * s_m + s_1),
    )
    return Dragged(motion, sums, True, defect < EASY * allowed, fits)


@kernel
def _along(velocity: complex, elongation: complex) -> float:
    """Part of a velocity along an elongation [mm/s]; none along none."""
    far = length_of(elongation)
    return dot(velocity, elongation) / far if far > 0.0 else 0.0


@kernel
def _works(
    model: BearingModel, piece: PathPiece, load: Load, now: float, length: float, e: complex, e_m: complex, e_1: complex
) -> tuple[float, float]:  # fmt: skip
    """Works over a step against spring (b), whose elongation is the parabola through three, and against spring (a) [mm2/s2]."""
    stretch = through(e, e_m, e_1, length)
    work, pendulum = 0.0, 0.0
    for k in range(4):
        t = length * GAUSS_POINTS[k]
        u, v = _position(piece, now + t), _velocity(piece, now + t)
        there = stretch.constant + times(t, stretch.rate) + times(t * t, stretch.curvature)
        ratio = load.start + t * piece.load_rate
        work += GAUSS_PARTS[k] * dot(there, v)
        pendulum += GAUSS_PARTS[k] * ratio * dot(u, v)
    return model.system.elastic * length * work, model.system.restoring * length * pendulum


@called_kernel
def _record(
    line: NDArray[np.float64],
    model: BearingModel,
    field: Field,
    motion: PlaneMotion,
    sums: Sums,
    load: float,
) -> None:
    record_motion(line, model, field, motion, POINT)
    line[LOAD], line[WORK], line[PENDULUM] = load, sums.work, sums.pendulum
    line[HYSTERETIC], line[LENGTH] = sums.hysteretic, sums.length


@called_kernel
def cool_and_place(
    model: BearingModel, field: Field, pause: float, time: float, start: complex, end: complex
) -> bool:
    """Let the plates cool through a `pause` up to a `time` [s], and bring the slider from one displacement to another [mm] without rubbing.

    Return False where the grid ends.
    """
    heat, system = model.heat, model.system
    if heat.kind == NO_HEATING:
        return True
    if pause > 0.0:
        prepare_cooling(heat, ODD_LENGTH, pause)
        plane_heat.cool_down(heat, field, system, ODD_LENGTH, pause)
    fits = True
    for i in range(system.plates):
        first = PLATE_ROW + i * PLATE_ROWS
        rise = total(heat.modes, first + COMMON)
        if heat.kind == DISC:
            # the disc must not leap over rows of points
            moves = 1 + int(length_of(end - start) / field.radius)
            for k in range(moves):
                there = start + times((k + 1.0) / moves, end - start)
                fits = plane_heat.sweep(heat, field, i, time, times(share(system, i), there)) and fits
            rise += total(heat.modes, first + INSIDE) / field.tallies[i, COVERED_POINTS]
            field.tallies[i, HOTTEST], field.tallies[i, PEAK_ROW] = heat.ambient, -1.0
        heat.workspace[PRESENT + i] = heat.ambient + rise
    return fits

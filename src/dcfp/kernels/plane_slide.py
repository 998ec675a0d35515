"""A step of a rigid structure on a bearing in the plane, stuck or sliding, under a vertical force that may change.

With the vertical force N0 r(t) the pendulum's force is that under N0 and a part wf2 (r - 1) u besides, whose work is told apart: *lifting*.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels import plane_heat
from dcfp.kernels._jit import kernel
from dcfp.kernels.friction import BearingModel, mean_coefficient, store_ratios, with_reference
from dcfp.kernels.heat_state import BETWEEN, EXPECTED, MOST_HALVINGS, PRESENT, RATIO
from dcfp.kernels.heating import interpolate
from dcfp.kernels.law import CYCLING
from dcfp.kernels.motion import SystemConstants
from dcfp.kernels.plane_heat import Field
from dcfp.kernels.plane_step import (
    Course,
    Force,
    advance,
    areas,
    dot,
    elongation_after,
    length_of,
    through,
    times,
    work_of,
)

#: Halvings beyond the fewest with which a point in the centre comes under the slider.
AT_THE_EDGE = 3
#: Distance of spring (b)'s force from what was expected, over mu g, up to which a step need not be repeated [-].
_AS_EXPECTED = 0.01
#: Part of the tolerance below which the next step may be twice as long.
EASY = 0.2


class PlaneControl(NamedTuple):
    """How finely an interval is stepped through."""

    interval: float  # between samples [s]
    fewest_halvings: int
    tolerance: float  # of the friction's distance from its chord in the middle of a step, over mu g [-]


class PlaneMotion(NamedTuple):
    """Motion of the structure relative to the ground, and spring (b)."""

    displacement: complex  # [mm]
    velocity: complex  # [mm/s]
    elongation: complex  # [mm]
    yield_radius: float  # radius of the yield surface [mm]
    friction: float  # coefficient
    slides: bool
    rate: complex  # how the force of spring (b) changes, per unit mass [mm/s3], if it goes on as it did
    curvature: complex  # half of how that changes [mm/s4]


class Load(NamedTuple):
    """Vertical force over that at rest, and the reference of the friction law at its pressure: at the start of a step, in the middle, at the end."""

    changes: bool
    start: float
    middle: float
    end: float
    middle_reference: float
    end_reference: float


class PlaneStep(NamedTuple):
    """What a step brings; its works are per unit mass [mm2/s2]."""

    motion: PlaneMotion
    middle: complex  # displacement in the middle [mm]
    input: float
    hysteretic: float
    rubbed: float  # sum of mu N |slip|
    lifting: float
    accepted: bool
    easy: bool  # the next one may be longer
    fits: bool  # False if the slider left the grid


@kernel
def under(model: BearingModel, ratio: float, reference: float) -> BearingModel:
    """Return the bearing under another load."""
    s = model.system
    here = SystemConstants(
        s.restoring, s.elastic, s.gravity * ratio, s.pressure * ratio, s.yield_per_mu * ratio,
        s.plates, s.first_share, s.second_share, s.first_speed, s.second_speed,
    )  # fmt: skip
    # the constants of a law by address are its own
    law = with_reference(model.law, reference) if model.law.form <= CYCLING else model.law
    return BearingModel(law, here, model.heat)


@kernel
def begun(model: BearingModel, motion: PlaneMotion) -> PlaneMotion:
    """Return a motion with the coefficient and the yield surface with which it begins."""
    friction = mean_coefficient(model, length_of(motion.velocity), PRESENT)
    radius = friction * model.system.yield_per_mu
    return PlaneMotion(
        motion.displacement, motion.velocity, motion.elongation, radius, friction, False, 0j, 0j
    )


@kernel
def friction_between(
    model: BearingModel, load: Load, place: int, start: float, end: float,
    middle_speed: float, end_speed: float, opening: float, closing: float, rubbing: float,
) -> tuple[float, float]:  # fmt: skip
    """Coefficients of friction in the middle of a step and at its end, at the temperatures to expect there; arguments as of `plane_heat.expect`."""
    plane_heat.expect(model.heat, model.system, place, start, end, opening, closing, rubbing)
    interpolate(model.heat, model.system, 0.5, BETWEEN)
    if not load.changes:
        return mean_coefficient(model, middle_speed, BETWEEN), mean_coefficient(model, end_speed, EXPECTED)
    return (
        mean_coefficient(under(model, load.middle, load.middle_reference), middle_speed, BETWEEN),
        mean_coefficient(under(model, load.end, load.end_reference), end_speed, EXPECTED),
    )


@kernel
def rub(
    model: BearingModel, field: Field, level: int, time: float, length: float, start: complex, middle: complex, end: complex,
    flux: float, opening: float, closing: float, end_speed: float, rubbing: float,
) -> bool:  # fmt: skip
    """Heat the plates by a mean `flux` [N/(mm s)]; return False where the grid ends.

    It is taken as linear, from `opening` to `closing` but raised so that the heat is the work of friction; other arguments as of `plane_heat.heat_up`.
    """
    first, last, ends = flux, flux, opening + closing
    if ends > 0.0:
        first, last = 2.0 * flux * opening / ends, 2.0 * flux * closing / ends
    store_ratios(model, end_speed, EXPECTED, RATIO)
    return plane_heat.heat_up(
        model.heat,
        field,
        model.system,
        level,
        time,
        length,
        start,
        middle,
        end,
        first,
        last,
        closing,
        rubbing,
    )


@kernel
def stick(
    model: BearingModel,
    field: Field,
    row: NDArray[np.float64],
    load: Load,
    begin: PlaneMotion,
    ground: complex,
    rate: complex,
    level: int,
    length: float,
) -> PlaneStep:
    """Take a step as an oscillator on both springs; it is accepted if the elongation stays inside the yield surface.

    `ground` [mm/s2] is the ground's acceleration at the start, and `rate` [mm/s3] how it changes.
    """
    system = model.system
    wf2, kf, h = system.restoring, system.elastic, length
    u, v, e = begin.displacement, begin.velocity, begin.elongation
    held = times(kf, u - e) - ground
    force = Force(held, -rate, 0j)
    course = advance(row, wf2 + kf, u, v, force)
    lifted = Force(0j, 0j, 0j)
    if load.changes:
        for _ in range(2):
            lifted = _lifted(wf2, load, u, course, h)
            force = Force(held - lifted.constant, -rate - lifted.rate, -lifted.curvature)
            course = advance(row, wf2 + kf, u, v, force)
    middle, end = e + (course.middle - u), e + (course.end - u)
    r0 = length_of(u)
    plane_heat.expect_cooling(model.heat, field, system, level, h)
    mu_m, mu_1 = friction_between(
        model, load, level, r0, r0, length_of(course.middle_velocity), length_of(course.end_velocity), 0.0, 0.0, 0.0
    )  # fmt: skip
    radius_m, radius_1 = mu_m * system.yield_per_mu * load.middle, mu_1 * system.yield_per_mu * load.end
    accepted = dot(middle, middle) <= radius_m * radius_m and dot(end, end) <= radius_1 * radius_1
    energy, lifting = 0.0, 0.0
    if accepted:
        area, moment = areas(row, wf2 + kf, u, v, force)
        energy = work_of(Force(-ground, -rate, 0j), h, course.end - u, area, moment)
        if load.changes:
            lifting = work_of(lifted, h, course.end - u, area, moment)
        plane_heat.cool_down(model.heat, field, system, level, h)
    motion = PlaneMotion(course.end, course.end_velocity, end, radius_1, mu_1, False, 0j, 0j)
    return PlaneStep(motion, course.middle, energy, 0.0, 0.0, lifting, accepted, True, True)


@kernel
def _lifted(wf2: float, load: Load, start: complex, course: Course, length: float) -> Force:
    """Return the part of the pendulum's force that a vertical force other than that at rest makes."""
    return through(
        times(wf2 * (load.start - 1.0), start),
        times(wf2 * (load.middle - 1.0), course.middle),
        times(wf2 * (load.end - 1.0), course.end),
        length,
    )


@kernel
def slide(
    model: BearingModel,
    field: Field,
    row: NDArray[np.float64],
    control: PlaneControl,
    load: Load,
    begin: PlaneMotion,
    ground: complex,
    rate: complex,
    level: int,
    length: float,
    time: float,
) -> PlaneStep:
    """Take a step on spring (a) under the friction, again where it is not as expected; it is accepted if the friction is close enough to its chord in the middle.

    `ground` [mm/s2] is the ground's acceleration at the start, `rate` [mm/s3] how it changes, `time` [s] the start of the step.
    """
    system = model.system
    wf2, kf, pressure, h = system.restoring, system.elastic, system.pressure, length
    u, v, e, radius, mu = (
        begin.displacement,
        begin.velocity,
        begin.elongation,
        begin.yield_radius,
        begin.friction,
    )
    f0, r0, s0 = times(kf, e), length_of(u), length_of(v)
    f_m, f_1, e_m, e_1, mu_m, mu_1, radius_1 = f0, f0, e, e, mu, mu, radius
    opening = pressure * load.start * mu * s0
    friction = Force(f0, begin.rate, begin.curvature)
    expected = f0 + times(h, begin.rate) + times(h * h, begin.curvature)
    lifted, force = Force(0j, 0j, 0j), Force(-ground - f0, -rate - friction.rate, -friction.curvature)
    course = advance(row, wf2, u, v, force)
    rubbing, sliding = 0.0, True
    plane_heat.expect_cooling(model.heat, field, system, level, h)
    for _ in range(2):
        s_m, s_1 = length_of(course.middle_velocity), length_of(course.end_velocity)
        rubbing = pressure * load.middle * (h / 6.0) * (s0 * s0 + 4.0 * s_m * s_m + s_1 * s_1)
        closing = pressure * load.end * mu_1 * s_1
        mu_m, mu_1 = friction_between(
            model, load, level, r0, length_of(course.end), s_m, s_1, opening, closing, rubbing
        )
        radius_m, radius_1 = mu_m * system.yield_per_mu * load.middle, mu_1 * system.yield_per_mu * load.end
        e_m, sliding = elongation_after(e, radius, radius_m, course.middle - u, v, course.middle_velocity)
        e_1, sliding = elongation_after(e_m, radius_m, radius_1, course.end - course.middle, course.middle_velocity, course.end_velocity)  # fmt: skip
        f_m, f_1 = times(kf, e_m), times(kf, e_1)
        friction = through(f0, f_m, f_1, h)
        force = Force(-ground - f0, -rate - friction.rate, -friction.curvature)
        if load.changes:
            lifted = _lifted(wf2, load, u, course, h)
            force = Force(force.constant - lifted.constant, force.rate - lifted.rate, force.curvature - lifted.curvature)  # fmt: skip
        course = advance(row, wf2, u, v, force)
        if length_of(f_1 - expected) <= _AS_EXPECTED * mu_1 * system.gravity:
            break
        expected = f_1
    allowed = control.tolerance * mu_1 * system.gravity
    defect = length_of(f_m - times(0.5, f0 + f_1))
    later = friction.rate + times(2.0 * h, friction.curvature)
    motion = PlaneMotion(
        course.end, course.end_velocity, e_1, radius_1, mu_1, sliding, later, friction.curvature
    )
    if level < MOST_HALVINGS and (
        defect > allowed
        or (
            level < control.fewest_halvings + AT_THE_EDGE
            and plane_heat.crosses_edge(model.heat, system, r0, length_of(course.end))
        )
    ):
        return PlaneStep(motion, course.middle, 0.0, 0.0, 0.0, 0.0, False, False, True)

    travel = course.end - u
    area, moment = areas(row, wf2, u, v, force)
    absorbed = work_of(friction, h, travel, area, moment)
    energy = work_of(Force(-ground, -rate, 0j), h, travel, area, moment)
    lifting = work_of(lifted, h, travel, area, moment) if load.changes else 0.0
    first = length_of((course.middle - u) - (e_m - e))
    second = length_of((course.end - course.middle) - (e_1 - e_m))
    slipped = 0.5 * (
        (mu * load.start + mu_m * load.middle) * first + (mu_m * load.middle + mu_1 * load.end) * second
    )
    s_1 = length_of(course.end_velocity)
    closing = pressure * load.end * mu_1 * s_1 if sliding else 0.0
    opening = opening if begin.slides or first > 0.0 else 0.0
    flux = pressure * slipped / h
    fits = rub(
        model, field, level, time, h, u, course.middle, course.end, flux, opening, closing, s_1, rubbing
    )
    hysteretic = absorbed - 0.5 * kf * (dot(e_1, e_1) - dot(e, e))
    return PlaneStep(
        motion, course.middle, energy, hysteretic, system.gravity * slipped, lifting, True, defect < EASY * allowed, fits
    )  # fmt: skip

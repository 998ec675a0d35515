"""A rigid structure on a bearing through a ground motion in the plane.

The sample interval is halved as often as the friction needs; steps are aligned to it, so that the coefficients of a step come from one row of a table.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import Records, called_kernel, fields_of, kernel, record_type, store
from dcfp.kernels.friction import BearingModel, mean_coefficient
from dcfp.kernels.heat_state import DISC, MOST_HALVINGS, PRESENT
from dcfp.kernels.heating import prepare
from dcfp.kernels.motion import DONE, NO_NUMBER, OUT_OF_CELLS
from dcfp.kernels.plane_heat import HOTTEST, Field
from dcfp.kernels.plane_slide import Load, PlaneControl, PlaneMotion, PlaneStep, begun, slide, stick, under
from dcfp.kernels.plane_step import dot, times

# columns of the histories; temperatures of the plates follow
X, Y, VELOCITY_X, VELOCITY_Y, ELONGATION_X, ELONGATION_Y, FRICTION, SLIDES, INPUT, HYSTERETIC, LIFTING, POINT, TEMPERATURE = range(13)  # fmt: skip
# columns of the vertical load
RATIO, REFERENCE = range(2)

#: Parts of a sample interval that the shortest step is one of, and how long a step of so many halvings is.
PARTS = 1 << MOST_HALVINGS
LENGTHS: tuple[float, ...] = tuple(0.5**n for n in range(MOST_HALVINGS + 1))
# how many places of an elastic oscillation are looked at, and by how much of the yield elongation what is left may slide
_ANGLES, _TURN, _SLIVER = 64, math.tau / 64, 1e-5


class PlaneExtremes(NamedTuple):
    """What is added up or compared on the way, per unit mass."""

    input: float  # [mm2/s2]
    hysteretic: float  # what the work of the bearing leaves [mm2/s2]
    rubbed: float  # sum of mu N |slip| [mm2/s2]
    lifting: float  # work of the part of the pendulum's force that the vertical motion makes [mm2/s2]
    displacement: float  # largest [mm]
    displacement_x: float
    displacement_y: float
    velocity: float  # largest at the ends of steps [mm/s]
    force: float  # largest at the ends of steps [mm/s2]
    temperature: float  # highest of any plate while sliding [degC]
    friction: float  # smallest coefficient while sliding [-]


class PlaneState(NamedTuple):
    """What a response starts from and leaves behind."""

    motion: PlaneMotion
    time: float  # [s]
    halvings: int
    extremes: PlaneExtremes
    steps: int
    status: int  # how it ended
    at_rest: bool  # no more sliding can come if the ground moves no more


PLANE_STATE = record_type(PlaneState)


@kernel
def integrate_plane(
    model: BearingModel,
    field: Field,
    ground: NDArray[np.float64],
    loads: NDArray[np.float64],
    control: PlaneControl,
    tables: NDArray[np.float64],
    free_from: int,
    states: Records,
    histories: NDArray[np.float64],
) -> int:
    """Respond to the samples of the ground's acceleration [mm/s2], shape (samples, 2); return the samples done.

    A row of `loads`, with as many rows as samples or none for a constant load, is the vertical force over that at rest and the reference of the friction law.
    `tables`, shape (2, lengths, COEFFICIENTS), are the coefficients of the oscillator on spring (a) and on both. The only one of `states`, the model's
    heat and the field are where it starts from, and are left where it ends. From sample `free_from` on, where the ground must have stopped
    accelerating, it stops as soon as it rests.
    """
    changes = loads.shape[0] > 0
    interval: float = control.interval
    state = states[0]
    motion = PlaneMotion(*fields_of(state["motion"]))
    extremes = PlaneExtremes(*fields_of(state["extremes"]))
    level: int = max(state["halvings"], control.fewest_halvings)
    began, done, status, steps = state["time"], 0, DONE, 0
    if motion.yield_radius < 0.0:  # it has not begun yet
        loaded = under(model, max(loads[0, RATIO], 0.0), loads[0, REFERENCE]) if changes else model
        motion = begun(loaded, motion)
    _record(histories[0], model, field, motion, extremes)
    for i in range(ground.shape[0] - 1):
        first = complex(ground[i, 0], ground[i, 1])
        rate = times(1.0 / interval, complex(ground[i + 1, 0], ground[i + 1, 1]) - first)
        place = 0
        while place < PARTS:
            length = interval * LENGTHS[level]
            elapsed = place * (interval * (1.0 / PARTS))
            pushed = first + times(elapsed, rate)
            load = Load(False, 1.0, 1.0, 1.0, 0.0, 0.0)
            if changes:
                load = _load_over(loads, i, elapsed / interval, 0.5 * length / interval)
            prepare(model.heat, level, length)
            e = motion.elongation
            step = PlaneStep(motion, motion.displacement, 0.0, 0.0, 0.0, 0.0, False, False, True)
            if dot(e, e) < motion.yield_radius * motion.yield_radius * (1.0 - 1e-12):
                step = stick(model, field, tables[1, level], load, motion, pushed, rate, level, length)
            stuck = step.accepted
            if not stuck:
                now = began + i * interval + elapsed
                step = slide(model, field, tables[0, level], control, load, motion, pushed, rate, level, length, now)  # fmt: skip
                if not step.accepted:
                    level += 1
                    continue
            extremes = _updated(extremes, model, motion, step, load, stuck)
            motion = step.motion
            steps += 1
            place += PARTS >> level
            if step.easy and level > control.fewest_halvings and place % (PARTS >> (level - 1)) == 0:
                level -= 1
            if not math.isfinite(motion.friction + motion.displacement.real + motion.displacement.imag):
                status = NO_NUMBER  # the law may answer so
            elif not step.fits:
                status = OUT_OF_CELLS
            if status != DONE:
                break
        if status != DONE:
            break
        done = i + 1
        _record(histories[done], model, field, motion, extremes)
        if done >= free_from and _is_at_rest(model, motion):
            break
    store_motion(state["motion"], motion)
    store(state["extremes"], extremes)
    state["time"] = began + done * interval
    state["halvings"], state["status"] = level, status
    state["at_rest"] = _is_at_rest(model, motion)
    state["steps"] += steps
    return done


@kernel
def _load_over(loads: NDArray[np.float64], i: int, part: float, half: float) -> Load:
    """Return the load over a step that begins at a `part` of interval `i` and is twice `half` of it long; linear between samples, and none where it would pull."""
    first, last = loads[i, RATIO], loads[i + 1, RATIO]
    reference, change = loads[i, REFERENCE], loads[i + 1, REFERENCE] - loads[i, REFERENCE]
    return Load(
        True,
        max(first + part * (last - first), 0.0),
        max(first + (part + half) * (last - first), 0.0),
        max(first + (part + 2.0 * half) * (last - first), 0.0),
        reference + (part + half) * change,
        reference + (part + 2.0 * half) * change,
    )


@kernel
def _updated(
    extremes: PlaneExtremes, model: BearingModel, begin: PlaneMotion, step: PlaneStep, load: Load, stuck: bool
) -> PlaneExtremes:
    """Return the extremes after a step."""
    system, motion = model.system, step.motion
    u, v = motion.displacement, motion.velocity
    # the largest distance inside the step, by a parabola through its square at start, middle and end
    before, middle, after = (
        dot(begin.displacement, begin.displacement),
        dot(step.middle, step.middle),
        dot(u, u),
    )
    largest = after
    if dot(begin.displacement, begin.velocity) > 0.0 and dot(u, v) < 0.0:
        bow, lean = 2.0 * (before - 2.0 * middle + after), 4.0 * middle - 3.0 * before - after
        if bow < 0.0:
            largest = max(largest, before - 0.25 * lean * lean / bow)
    pull = times(system.restoring * load.end, u) + times(system.elastic, motion.elongation)
    temperature, friction = extremes.temperature, extremes.friction
    if not stuck:
        friction = min(friction, motion.friction)
        for j in range(system.plates):
            temperature = max(temperature, model.heat.workspace[PRESENT + j])
    return PlaneExtremes(
        extremes.input + step.input,
        extremes.hysteretic + step.hysteretic,
        extremes.rubbed + step.rubbed,
        extremes.lifting + step.lifting,
        _larger(extremes.displacement, largest),
        max(extremes.displacement_x, abs(u.real)),
        max(extremes.displacement_y, abs(u.imag)),
        _larger(extremes.velocity, dot(v, v)),
        _larger(extremes.force, dot(pull, pull)),
        temperature,
        friction,
    )


@kernel
def _larger(one: float, square: float) -> float:
    """Return the larger one of a number and the root of a square, which seldom is."""
    return math.sqrt(square) if square > one * one else one


@kernel
def store_motion(record: Records, motion: PlaneMotion) -> None:
    """Write a motion into its record."""
    record["displacement"], record["velocity"] = motion.displacement, motion.velocity
    record["elongation"], record["yield_radius"] = motion.elongation, motion.yield_radius
    record["friction"], record["slides"] = motion.friction, motion.slides
    record["rate"], record["curvature"] = motion.rate, motion.curvature


@kernel
def _record(
    line: NDArray[np.float64], model: BearingModel, field: Field, motion: PlaneMotion, extremes: PlaneExtremes
) -> None:
    record_motion(line, model, field, motion, POINT)
    line[INPUT], line[HYSTERETIC], line[LIFTING] = extremes.input, extremes.hysteretic, extremes.lifting


@kernel
def record_motion(
    line: NDArray[np.float64], model: BearingModel, field: Field, motion: PlaneMotion, point: int
) -> None:
    """Write the columns up to `SLIDES`, and from number `point` on the highest temperature of a point and those of the plates."""
    line[X], line[Y] = motion.displacement.real, motion.displacement.imag
    line[VELOCITY_X], line[VELOCITY_Y] = motion.velocity.real, motion.velocity.imag
    line[ELONGATION_X], line[ELONGATION_Y] = motion.elongation.real, motion.elongation.imag
    line[FRICTION], line[SLIDES] = motion.friction, 1.0 if motion.slides else 0.0
    highest = -math.inf
    for i in range(model.system.plates):
        line[point + 1 + i] = model.heat.workspace[PRESENT + i]
        highest = max(highest, model.heat.workspace[PRESENT + i])
        if model.heat.kind == DISC:
            highest = max(highest, field.tallies[i, HOTTEST])
    line[point] = highest


@called_kernel
def _is_at_rest(model: BearingModel, motion: PlaneMotion) -> bool:
    """Whether the free elastic oscillation that is left stays inside the yield surface, under the load at rest."""
    system = model.system
    u, v, e = motion.displacement, motion.velocity, motion.elongation
    both = system.restoring + system.elastic
    # the elongation goes along an ellipse about this one
    centre = e - u + times(system.elastic / both, u - e)
    cosine, sine = e - centre, times(1.0 / math.sqrt(both), v)
    furthest, before, middle = 0.0, 0.0, 0.0
    for k in range(_ANGLES + 2):
        there = centre + times(math.cos(_TURN * k), cosine) + times(math.sin(_TURN * k), sine)
        after = dot(there, there)
        if k >= 2 and middle >= before and middle >= after:
            # the parabola through three squares
            bend, lean = before - 2.0 * middle + after, after - before
            furthest = max(furthest, middle - (0.125 * lean * lean / bend if bend < 0.0 else 0.0))
        before, middle = middle, after
    amplitude = math.sqrt(dot(cosine, cosine) + dot(sine, sine))
    for speed in (0.0, amplitude * math.sqrt(both)):
        radius = mean_coefficient(model, speed, PRESENT) * system.yield_per_mu
        if not math.sqrt(furthest) < radius * (1.0 + _SLIVER):
            return False
    return True

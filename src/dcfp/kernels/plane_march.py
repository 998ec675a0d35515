"""A rigid structure on a bearing in the plane along the legs of a piecewise linear ground velocity.

Along a leg the ground's acceleration is constant. The steps are those of an analysis in the plane, with longer ones and a wider tolerance.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import Records, kernel, record_type
from dcfp.kernels.friction import BearingModel, mean_coefficient
from dcfp.kernels.heat_state import MOST_HALVINGS, PRESENT
from dcfp.kernels.heating import prepare
from dcfp.kernels.plane_heat import Field
from dcfp.kernels.plane_slide import Load, PlaneControl, PlaneMotion, PlaneStep, slide, stick
from dcfp.kernels.plane_step import END, MIDDLE, dot, length_of

#: Columns of the path.
PATH_TIME, PATH_X, PATH_Y, PATH_VELOCITY_X, PATH_VELOCITY_Y, PATH_SIZE = range(6)
#: Most steps after the last node.
FREE_STEPS = 2400
#: Parts of the first step of a leg that the shortest step is one of.
_PARTS = 1 << MOST_HALVINGS
#: With so many terms after the first a series for the coefficients of an oscillator is exact, up to this square of an angle; and what is divided by in it, inverted.
_TERMS, _LARGEST_SQUARE = 8, 1.0
_OVER = 1.0 / (np.arange(2.0 * _TERMS + 6.0) * np.arange(1.0, 2.0 * _TERMS + 7.0)).clip(1.0)


class PlaneMarchState(NamedTuple):
    """What a march in the plane leaves behind. Energies are per unit mass [mm2/s2]."""

    time: float  # [s]
    displacement_x: float  # [mm]
    displacement_y: float
    input: float
    hysteretic: float
    peak_displacement: float  # [mm]
    peak_temperature: float  # [degC]
    rests: bool


PLANE_MARCH_STATE = record_type(PlaneMarchState)


@kernel
def march_in_plane(
    model: BearingModel,
    field: Field,
    times_of: NDArray[np.float64],
    velocities_x: NDArray[np.float64],
    velocities_y: NDArray[np.float64],
    longest: float,
    tolerance: float,
    tables: NDArray[np.float64],
    states: Records,
    path: NDArray[np.float64],
) -> tuple[int, bool]:
    """March along the legs between nodes; return the number of steps and whether the slider stayed on the grid.

    No step is longer than `longest` [s]. After the last node the ground keeps its velocity until the structure sticks. `tables`, shape
    (2, lengths, COEFFICIENTS), is worked in. Steps have rows of `path` as far as there are any.
    """
    system, heat, state = model.system, model.heat, states[0]
    load = Load(False, 1.0, 1.0, 1.0, 0.0, 0.0)
    friction = mean_coefficient(model, 0.0, PRESENT)
    motion = PlaneMotion(0j, 0j, 0j, friction * system.yield_per_mu, friction, False, 0j, 0j)
    peak, work, hysteretic, temperature = 0.0, 0.0, 0.0, state["peak_temperature"]
    steps, level, fits, rests = 0, 0, True, False
    if times_of.size == 0:
        return 0, True
    time = times_of[0]
    both = system.restoring + system.elastic
    for leg in range(times_of.size):
        last = leg == times_of.size - 1
        span = FREE_STEPS * longest if last else times_of[leg + 1] - times_of[leg]
        whole = FREE_STEPS if last else math.ceil(span / longest)
        base = span / whole
        ground = 0j
        if not last:
            ground = complex(
                (velocities_x[leg + 1] - velocities_x[leg]) / span, (velocities_y[leg + 1] - velocities_y[leg]) / span
            )  # fmt: skip
        control = PlaneControl(base, 0, tolerance)
        known = -1  # levels from 0 on whose coefficients are those of this leg
        place = 0
        while place < whole * _PARTS:
            length = base / (1 << level)
            while known < level:
                known += 1
                _write_row(system.restoring, base, known, tables[0])
                _write_row(both, base, known, tables[1])
            prepare(heat, level, length)
            e = motion.elongation
            step = PlaneStep(motion, motion.displacement, 0.0, 0.0, 0.0, 0.0, False, False, True)
            if dot(e, e) < motion.yield_radius * motion.yield_radius * (1.0 - 1e-12):
                step = stick(model, field, tables[1, level], load, motion, ground, 0j, level, length)
            stuck = step.accepted
            if not stuck:
                step = slide(
                    model, field, tables[0, level], control, load, motion, ground, 0j, level, length, time
                )
                if not step.accepted:
                    level += 1
                    continue
            before, after = (
                dot(motion.displacement, motion.velocity),
                dot(step.motion.displacement, step.motion.velocity),
            )
            largest = length_of(step.motion.displacement)
            if before > 0.0 and after < 0.0:
                largest = max(largest, length_of(step.middle))
            peak = max(peak, largest)
            work += step.input
            hysteretic += step.hysteretic
            motion = step.motion
            fits = fits and step.fits
            time += length
            place += _PARTS >> level
            if not stuck:
                for i in range(system.plates):
                    temperature = max(temperature, heat.workspace[PRESENT + i])
            if step.easy and level > 0 and place % (_PARTS >> (level - 1)) == 0:
                level -= 1
            if steps < path.shape[0]:
                path[steps, PATH_TIME] = time
                path[steps, PATH_X], path[steps, PATH_Y] = motion.displacement.real, motion.displacement.imag
                path[steps, PATH_VELOCITY_X], path[steps, PATH_VELOCITY_Y] = (
                    motion.velocity.real,
                    motion.velocity.imag,
                )
            steps += 1
            if not fits or not math.isfinite(largest):
                break
            if last and stuck:
                rests = True
                break
        if not fits or not math.isfinite(peak):
            break
    state["time"], state["displacement_x"], state["displacement_y"] = (
        time,
        motion.displacement.real,
        motion.displacement.imag,
    )
    state["input"], state["hysteretic"], state["peak_displacement"] = work, hysteretic, peak
    state["peak_temperature"], state["rests"] = temperature, rests
    return steps, fits


@kernel
def _write_row(stiffness: float, base: float, level: int, table: NDArray[np.float64]) -> None:
    """Write the coefficients of an oscillator over a step of `base` [s] halved `level` times, after those of steps halved less often."""
    _write_coefficients(stiffness, 0.5 * base / (1 << level), table[level], MIDDLE)
    if level == 0:
        _write_coefficients(stiffness, base, table[level], END)
        return
    for k in range(END):  # what was half of a step is a whole one
        table[level, END + k] = table[level - 1, MIDDLE + k]


@kernel
def _write_coefficients(stiffness: float, length: float, row: NDArray[np.float64], first: int) -> None:
    """Write the coefficients of an oscillator after a `length` [s], as `oscillator_rows` gives them: h^k phi_k for k = 0 to 6, from column `first` on."""
    z = stiffness * length * length
    if z < _LARGEST_SQUARE:
        five, six = 1.0, 1.0
        for n in range(2 * _TERMS, 0, -2):
            five = 1.0 - z * _OVER[n + 4] * five
            six = 1.0 - z * _OVER[n + 5] * six
        row[first + 5], row[first + 6] = five / 120.0, six / 720.0
        inverse = 1.0 / 24.0
        for k in (4, 3, 2, 1, 0):
            row[first + k] = inverse - z * row[first + k + 2]
            inverse *= max(k, 1)
    else:
        root = math.sqrt(z)
        row[first], row[first + 1] = math.cos(root), math.sin(root) / root
        inverse = 1.0
        for k in range(2, 7):
            row[first + k] = (inverse - row[first + k - 2]) / z
            inverse /= k - 1
    power = 1.0
    for k in range(7):
        row[first + k] *= power
        power *= length

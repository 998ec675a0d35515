r"""Bearings under one slab: each with its own place, load, friction, temperature and elongation of spring (b).

The slab's motion is x, y and a small rotation; a vector is a complex number, x + i y. A step is tried for every bearing (`plan_try`) from the slab's motion at its start,
in its middle and at its end, which brings the forces on the slab; once it is accepted the bearings are left at its end (`plan_settle`), and heated (`plan_heat`). Heat is that of a point in the centre of each plate.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel
from dcfp.kernels.plane_step import dot, length_of

#: Columns of the constants of a bearing: place from the slab's origin [mm], static load [N], kf [N/mm], 1 / radius [1/mm], area of the slider [mm2], how much of
#: its displacement the slider stays behind the slab [-], number of its kind, coefficient's reference at the static load, least pressure that the law is asked for [N/mm2].
X, Y, STATIC, ELASTIC, OVER_RADIUS, AREA, BEHIND, KIND, REFERENCE, LEAST_PRESSURE, CONSTANTS = range(11)
#: Columns of a kind: form and constants of its law; plates that differ, their shares of the travel and of the speed; whether it heats up, ambient [degC], half of
#: the contact [mm], instant rise per flux, first row of its modes; logarithm of the first pressure of its references, and how many of them there are for one of the logarithm.
FORM, LAW, PLATES, SHARE, SPEED, HEATED, AMBIENT, HALF_CONTACT, INSTANT, HEAT_ROW, FIRST_LOG, PER_LOG, KIND_COLUMNS = 0, 1, 7, 8, 10, 12, 13, 14, 15, 16, 17, 18, 19  # fmt: skip
#: Columns of the state of a bearing: elongation [mm], load [N], coefficient, whether it slides; of each plate temperature, cycling parameter and coefficient over that of the
#: bearing; and what was added up or compared on the way: sum of mu N |slip| [N mm], largest displacement [mm], travel [mm], least and largest load [N], highest temperature [degC], time without load [s];
#: and where its law was looked up: one over the pressure [mm2/N], reference there, and the power of the pressure with which that changes.
E_X, E_Y, N, MU, SLIDES, TEMPERATURE, CYCLED, RATIO, RUBBED, FURTHEST, TRAVEL, LEAST, LARGEST, HOTTEST, LIFTED = 0, 1, 2, 3, 4, 5, 7, 9, 11, 12, 13, 14, 15, 16, 17  # fmt: skip
OVER_KNOWN, KNOWN_REFERENCE, POWER, STATE = 18, 19, 20, 21
#: Columns of a trial: loads [N] in the middle and at the end; elongation, coefficient there; whether it slides at the end, and whether it has slid at all; temperature that is left of each plate without flux.
N_MIDDLE, N_END, M_X, M_Y, END_X, END_Y, MU_MIDDLE, MU_END, SLIDING, MOVED, LEFT, TRIAL = 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12  # fmt: skip
#: Rows of the slab's motion, and columns: x, y [mm], rotation, their velocities, moments of the floors that tip it along x and y [N mm].
START, MIDDLE, END, MOTION_ROWS = range(4)
DISPLACEMENT, VELOCITY, TIPPING, OUTPUTS = 0, 3, 6, 8
#: Rows of the forces: of friction and of the change of load, in the middle and at the end; columns: x, y [N], torque [N mm], and of the loads what the sliders add to the moments [N mm].
FRICTION_MIDDLE, FRICTION_END, LIFTING_MIDDLE, LIFTING_END, FORCE_ROWS = range(5)
FORCE_COLUMNS = 5
#: Rows of the modes of a kind of bearing: rates, weights, and of each level factors (three rows).
KIND_ROWS, LEVEL_ROWS = 2, 3


class Bearings(NamedTuple):
    """All bearings of a plan."""

    constants: NDArray[np.float64]  # (bearings, CONSTANTS)
    kinds: NDArray[np.float64]  # (kinds, KIND_COLUMNS)
    references: NDArray[np.float64]  # (kinds, pressures), logarithms
    modes: NDArray[np.float64]  # rows of the kinds, then two rows for each bearing
    prepared: NDArray[np.float64]  # (kinds, levels, 3): length of the step, sums of its weights
    first_row: int  # of the modes of the bearings
    reach: float  # of the furthest bearing from the slab's origin [mm]
    nearest_edge: float  # least displacement at which the centre of a plate is not covered [mm]
    state: NDArray[np.float64]  # (bearings, STATE)
    trial: NDArray[np.float64]  # (bearings, TRIAL)


@kernel
def at(row: NDArray[np.float64], first: int, arm: complex) -> complex:
    """Displacement or velocity at an `arm` from the slab's origin, from that of the slab in three columns."""
    turn = row[first + 2]
    return complex(row[first] - turn * arm.imag, row[first + 1] + turn * arm.real)


class Passage(NamedTuple):
    """Displacement [mm], velocity [mm/s] and speed [mm/s] of a bearing at the start, in the middle and at the end of a step."""

    start: complex
    middle: complex
    end: complex
    start_velocity: complex
    middle_velocity: complex
    end_velocity: complex
    start_speed: float
    middle_speed: float
    end_speed: float


@kernel
def passage(motion: NDArray[np.float64], arm: complex) -> Passage:
    """Return how a bearing at an `arm` from the slab's origin goes through a step."""
    v0, vm, v1 = (
        at(motion[START], VELOCITY, arm),
        at(motion[MIDDLE], VELOCITY, arm),
        at(motion[END], VELOCITY, arm),
    )
    return Passage(
        at(motion[START], DISPLACEMENT, arm), at(motion[MIDDLE], DISPLACEMENT, arm), at(motion[END], DISPLACEMENT, arm),
        v0, vm, v1, length_of(v0), length_of(vm), length_of(v1),
    )  # fmt: skip


@kernel
def rubbing_of(c: NDArray[np.float64], p: Passage, load: float, length: float) -> float:
    """Time integral over a step of pressure times the square of the speed [N/s], what the cycling parameter grows by."""
    speeds = p.start_speed * p.start_speed + 4.0 * p.middle_speed * p.middle_speed + p.end_speed * p.end_speed
    return load / c[AREA] * (length / 6.0) * speeds


@kernel
def highest(so_far: float, start: float, middle: float, end: float) -> float:
    """Largest value so far and over a step, by a parabola through three of its values."""
    largest = max(max(start, middle), end)
    bow, lean = 2.0 * (start - 2.0 * middle + end), 4.0 * middle - 3.0 * start - end
    if bow < 0.0 and 0.0 < lean < -2.0 * bow:
        largest = max(largest, start - 0.25 * lean * lean / bow)
    return max(so_far, largest)


@kernel
def furthest(so_far: float, start: complex, middle: complex, end: complex) -> float:
    """Largest length of a vector so far and over a step, by a parabola through its square."""
    square = highest(0.0, dot(start, start), dot(middle, middle), dot(end, end))
    return math.sqrt(square) if square > so_far * so_far else so_far

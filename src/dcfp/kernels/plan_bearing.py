r"""Bearings under one slab: each with its own place, load, friction, temperature and elongation of spring (b).

The slab's motion is x, y and a small rotation; a vector is a complex number, x + i y. A step is tried for every bearing from the slab's motion at its start,
in its middle and at its end, which brings the forces on the slab; once it is accepted the bearings are left at its end, and heated. Heat is that of a point in the centre of each plate.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import called_kernel, kernel
from dcfp.kernels.friction import coefficient
from dcfp.kernels.law import CYCLING, Law
from dcfp.kernels.plane_step import dot, elongation_after, length_of, times
from dcfp.kernels.sum_of_exponentials import accumulate, decayed_total, fill_decay, fill_weights, total

#: Columns of the constants of a bearing: place from the slab's origin [mm], static load [N], kf [N/mm], 1 / radius [1/mm], area of the slider [mm2], how much of
#: its displacement the slider stays behind the slab [-], number of its kind, coefficient's reference at the static load, least pressure that the law is asked for [N/mm2].
X, Y, STATIC, ELASTIC, OVER_RADIUS, AREA, BEHIND, KIND, REFERENCE, LEAST_PRESSURE, CONSTANTS = range(11)
#: Columns of a kind: form and constants of its law; plates that differ, their shares of the travel and of the speed; whether it heats up, ambient [degC], half of
#: the contact [mm], instant rise per flux, first row of its modes; logarithm of the first pressure of its references, and how many of them there are for one of the logarithm.
FORM, LAW, PLATES, SHARE, SPEED, HEATED, AMBIENT, HALF_CONTACT, INSTANT, HEAT_ROW, FIRST_LOG, PER_LOG, KIND_COLUMNS = 0, 1, 7, 8, 10, 12, 13, 14, 15, 16, 17, 18, 19  # fmt: skip
#: Columns of the state of a bearing: elongation [mm], load [N], coefficient, whether it slides; of each plate temperature, cycling parameter and coefficient over that of the
#: bearing; and what was added up or compared on the way: sum of mu N |slip| [N mm], largest displacement [mm], travel [mm], least and largest load [N], highest temperature [degC], time without load [s].
E_X, E_Y, N, MU, SLIDES, TEMPERATURE, CYCLED, RATIO, RUBBED, FURTHEST, TRAVEL, LEAST, LARGEST, HOTTEST, LIFTED, STATE = 0, 1, 2, 3, 4, 5, 7, 9, 11, 12, 13, 14, 15, 16, 17, 18  # fmt: skip
#: Columns of a trial: loads [N] in the middle and at the end; elongation, coefficient there; whether it slides; temperature that is left of each plate without flux.
N_MIDDLE, N_END, M_X, M_Y, END_X, END_Y, MU_MIDDLE, MU_END, SLIDING, LEFT, TRIAL = (
    0,
    1,
    2,
    3,
    4,
    5,
    6,
    7,
    8,
    9,
    11,
)
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
    state: NDArray[np.float64]  # (bearings, STATE)
    trial: NDArray[np.float64]  # (bearings, TRIAL)


@kernel
def at(row: NDArray[np.float64], first: int, arm: complex) -> complex:
    """Displacement or velocity at an `arm` from the slab's origin, from that of the slab in three columns."""
    turn = row[first + 2]
    return complex(row[first] - turn * arm.imag, row[first + 1] + turn * arm.real)


@called_kernel
def prepare_heat(b: Bearings, level: int, length: float) -> None:
    """Make the factors of the modes for a step of `length` [s], unless they are there already."""
    for k in range(b.kinds.shape[0]):
        if b.kinds[k, HEATED] == 0.0 or b.prepared[k, level, 0] == length:
            continue
        first = int(b.kinds[k, HEAT_ROW])
        factors = first + KIND_ROWS + LEVEL_ROWS * level
        fill_decay(b.modes, first, length, factors)
        fill_weights(b.modes, first, first + 1, length, factors)
        b.prepared[k, level, 0] = length
        b.prepared[k, level, 1] = total(b.modes, factors + 1)
        b.prepared[k, level, 2] = total(b.modes, factors + 2)


@kernel
def law_at(b: Bearings, i: int, kind: int, load: float, changes: bool) -> tuple[Law, float]:
    """Friction law of a bearing under a load [N], and its pressure [N/mm2]."""
    c, k = b.constants[i], b.kinds[kind]
    pressure = max(load / c[AREA], c[LEAST_PRESSURE])
    form, reference = int(k[FORM]), k[LAW]
    if form <= CYCLING:
        reference = c[REFERENCE]
        if changes:
            place = (math.log(pressure) - k[FIRST_LOG]) * k[PER_LOG]
            cell = min(max(int(place), 0), b.references.shape[1] - 2)
            low, high = b.references[kind, cell], b.references[kind, cell + 1]
            reference = math.exp(low + (place - cell) * (high - low))
    return Law(
        form, reference, k[LAW + 1], k[LAW + 2], k[LAW + 3], k[LAW + 4], k[LAW + 5]
    ), pressure  # fmt: skip


@kernel
def mean_of_plates(
    b: Bearings, kind: int, law: Law, pressure: float, speed: float, t0: float, t1: float, c0: float, c1: float
) -> tuple[float, float, float]:  # fmt: skip
    """Coefficient of a bearing [-], and of each plate, at their temperatures [degC] and cycling parameters [N/s]."""
    k = b.kinds[kind]
    one = coefficient(law, pressure, k[SPEED] * speed, t0, c0)
    if k[PLATES] == 1.0:
        return one, one, one
    other = coefficient(law, pressure, k[SPEED + 1] * speed, t1, c1)
    return k[SHARE] * one + k[SHARE + 1] * other, one, other


@kernel
def _covered_part(k: NDArray[np.float64], plate: int, start: float, end: float) -> float:
    """Part of a step in which the centre of a plate is under the slider, which goes from one distance [mm] to another: Eq. (12) of Li et al. (2020)."""
    edge = k[HALF_CONTACT] / k[SHARE + plate]
    before, after = start <= edge, end <= edge
    if before == after:
        return 1.0 if after else 0.0
    part = (edge - start) / (end - start)
    return part if before else 1.0 - part


@called_kernel
def crosses_edge(b: Bearings, motion: NDArray[np.float64]) -> bool:
    """Whether the centre of any plate comes under its slider or leaves it over a step."""
    for i in range(b.constants.shape[0]):
        c = b.constants[i]
        k = b.kinds[int(c[KIND])]
        if k[HEATED] == 0.0:
            continue
        arm = complex(c[X], c[Y])
        start, end = (
            length_of(at(motion[START], DISPLACEMENT, arm)),
            length_of(at(motion[END], DISPLACEMENT, arm)),
        )
        for j in range(int(k[PLATES])):
            edge = k[HALF_CONTACT] / k[SHARE + j]
            if (start <= edge) != (end <= edge):
                return True
    return False


@called_kernel
def try_bearings(
    b: Bearings, level: int, length: float, motion: NDArray[np.float64], forces: NDArray[np.float64], changes: bool, fresh: bool
) -> float:  # fmt: skip
    """Try a step: write the trial of every bearing and the sum of their `forces`; return the mean square of how far friction is from its chord in the middle, over mu N.

    A `fresh` step has not been tried yet. The loads stand in the trial.
    """
    for r in range(FORCE_ROWS):
        for j in range(FORCE_COLUMNS):
            forces[r, j] = 0.0
    squares = 0.0
    for i in range(b.constants.shape[0]):
        squares += _try_bearing(b, i, level, length, motion, forces, changes, fresh)
    return squares / b.constants.shape[0]


@kernel
def _in_step(motion: NDArray[np.float64], part: int, arm: complex) -> tuple[complex, complex, complex]:
    """Return where a bearing is, or how fast it goes, at the start, in the middle and at the end of a step."""
    return at(motion[START], part, arm), at(motion[MIDDLE], part, arm), at(motion[END], part, arm)


@kernel
def _try_bearing(
    b: Bearings, i: int, level: int, length: float, motion: NDArray[np.float64], forces: NDArray[np.float64], changes: bool, fresh: bool
) -> float:  # fmt: skip
    c, s, t = b.constants[i], b.state[i], b.trial[i]
    kind = int(c[KIND])
    k = b.kinds[kind]
    arm = complex(c[X], c[Y])
    u0, um, u1 = _in_step(motion, DISPLACEMENT, arm)
    v0, vm, v1 = _in_step(motion, VELOCITY, arm)
    s0, sm, s1 = length_of(v0), length_of(vm), length_of(v1)
    load_m, load_1 = t[N_MIDDLE], t[N_END]
    heated, plates = k[HEATED] != 0.0, int(k[PLATES])
    if fresh:
        t[MU_END] = s[MU]
        if heated:
            factors = int(k[HEAT_ROW]) + KIND_ROWS + LEVEL_ROWS * level
            for j in range(plates):
                t[LEFT + j] = decayed_total(b.modes, factors, b.first_row + 2 * i + j)
    over_area = 1.0 / c[AREA]
    opening, closing = s[N] * over_area * s[MU] * s0, load_1 * over_area * t[MU_END] * s1
    rubbing = load_m * over_area * (length / 6.0) * (s0 * s0 + 4.0 * sm * sm + s1 * s1)
    t0, t1 = s[TEMPERATURE], s[TEMPERATURE + 1]
    c0, c1 = s[CYCLED], s[CYCLED + 1]
    if heated:
        r0, r1 = length_of(u0), length_of(u1)
        t0 = _expected(b, i, kind, level, 0, r0, r1, opening, closing)
        if plates == 2:
            t1 = _expected(b, i, kind, level, 1, r0, r1, opening, closing)
    c0 += k[SPEED] * k[SPEED] * rubbing
    c1 += k[SPEED + 1] * k[SPEED + 1] * rubbing
    law, pressure = law_at(b, i, kind, load_m, changes)
    mu_m, _, _ = mean_of_plates(
        b, kind, law, pressure, sm,
        0.5 * (s[TEMPERATURE] + t0), 0.5 * (s[TEMPERATURE + 1] + t1), 0.5 * (s[CYCLED] + c0), 0.5 * (s[CYCLED + 1] + c1),
    )  # fmt: skip
    law, pressure = law_at(b, i, kind, load_1, changes)
    mu_1, _, _ = mean_of_plates(b, kind, law, pressure, s1, t0, t1, c0, c1)
    over_kf = 1.0 / c[ELASTIC]
    radius_0, radius_m, radius_1 = s[MU] * s[N] * over_kf, mu_m * load_m * over_kf, mu_1 * load_1 * over_kf
    e = complex(s[E_X], s[E_Y])
    e_m, sliding = elongation_after(e, radius_0, radius_m, um - u0, v0, vm)
    e_1, sliding = elongation_after(e_m, radius_m, radius_1, u1 - um, vm, v1)
    t[M_X], t[M_Y], t[END_X], t[END_Y] = e_m.real, e_m.imag, e_1.real, e_1.imag
    t[MU_MIDDLE], t[MU_END], t[SLIDING] = mu_m, mu_1, 1.0 if sliding else 0.0
    _add(forces[FRICTION_MIDDLE], arm, times(c[ELASTIC], e_m))
    _add(forces[FRICTION_END], arm, times(c[ELASTIC], e_1))
    if changes:
        more_m, more_1 = load_m - c[STATIC], load_1 - c[STATIC]
        _add(forces[LIFTING_MIDDLE], arm, times(more_m * c[OVER_RADIUS], um))
        _add(forces[LIFTING_END], arm, times(more_1 * c[OVER_RADIUS], u1))
        lag_m, lag_1 = times(more_m * c[BEHIND], um), times(more_1 * c[BEHIND], u1)
        forces[LIFTING_MIDDLE, 3] += lag_m.real
        forces[LIFTING_MIDDLE, 4] += lag_m.imag
        forces[LIFTING_END, 3] += lag_1.real
        forces[LIFTING_END, 4] += lag_1.imag
    # relative to the friction under the load at rest
    off = times(c[ELASTIC] / (mu_1 * c[STATIC]), e_m - times(0.5, e + e_1))
    return dot(off, off)


@kernel
def _add(row: NDArray[np.float64], arm: complex, force: complex) -> None:
    row[0] += force.real
    row[1] += force.imag
    row[2] += arm.real * force.imag - arm.imag * force.real


@kernel
def _expected(
    b: Bearings, i: int, kind: int, level: int, plate: int, start: float, end: float, opening: float, closing: float
) -> float:  # fmt: skip
    """Temperature of a plate [degC] to expect at the end of a step, between two distances from the centre [mm], under fluxes at its ends [N/(mm s)]."""
    k, ready = b.kinds[kind], b.prepared[kind, level]
    rise = k[AMBIENT] + b.trial[i, LEFT + plate]
    if _covered_part(k, plate, start, end) == 1.0:
        felt = k[SHARE + plate] * b.state[i, RATIO + plate]
        rise += felt * (ready[1] * opening + (ready[2] + k[INSTANT]) * closing)
    return rise


@called_kernel
def settle_bearings(
    b: Bearings, level: int, length: float, motion: NDArray[np.float64], changes: bool
) -> tuple[float, float]:
    """Leave every bearing at the end of the step that was tried, and heat it; return the sum of mu N |slip| [N mm] and the energy in the springs (b) [N mm]."""
    rubbed, stored = 0.0, 0.0
    for i in range(b.constants.shape[0]):
        rubbed += _settle(b, i, level, length, motion, changes)
        s = b.state[i]
        stored += 0.5 * b.constants[i, ELASTIC] * (s[E_X] * s[E_X] + s[E_Y] * s[E_Y])
    return rubbed, stored


@kernel
def _settle(
    b: Bearings, i: int, level: int, length: float, motion: NDArray[np.float64], changes: bool
) -> float:
    c, s, t = b.constants[i], b.state[i], b.trial[i]
    kind = int(c[KIND])
    k = b.kinds[kind]
    arm = complex(c[X], c[Y])
    u0, um, u1 = _in_step(motion, DISPLACEMENT, arm)
    v0, vm, v1 = _in_step(motion, VELOCITY, arm)
    s0, sm, s1 = length_of(v0), length_of(vm), length_of(v1)
    e, e_m, e_1 = complex(s[E_X], s[E_Y]), complex(t[M_X], t[M_Y]), complex(t[END_X], t[END_Y])
    first, second = length_of((um - u0) - (e_m - e)), length_of((u1 - um) - (e_1 - e_m))
    load_m, load_1 = t[N_MIDDLE], t[N_END]
    slipped = 0.5 * (
        (s[MU] * s[N] + t[MU_MIDDLE] * load_m) * first + (t[MU_MIDDLE] * load_m + t[MU_END] * load_1) * second
    )
    over_area = 1.0 / c[AREA]
    slides = t[SLIDING] != 0.0
    opening = s[N] * over_area * s[MU] * s0 if s[SLIDES] != 0.0 or first > 0.0 else 0.0
    closing = load_1 * over_area * t[MU_END] * s1 if slides else 0.0
    rubbing = load_m * over_area * (length / 6.0) * (s0 * s0 + 4.0 * sm * sm + s1 * s1)
    if not slides and slipped == 0.0:
        rubbing = 0.0
    s[CYCLED] += k[SPEED] * k[SPEED] * rubbing
    s[CYCLED + 1] += k[SPEED + 1] * k[SPEED + 1] * rubbing
    if k[HEATED] != 0.0:
        _heat(
            b,
            i,
            kind,
            level,
            length,
            length_of(u0),
            length_of(u1),
            slipped * over_area / length,
            opening,
            closing,
        )
    if k[PLATES] == 2.0:
        law, pressure = law_at(b, i, kind, load_1, changes)
        mean, one, other = mean_of_plates(
            b, kind, law, pressure, s1, s[TEMPERATURE], s[TEMPERATURE + 1], s[CYCLED], s[CYCLED + 1]
        )
        s[RATIO], s[RATIO + 1] = one / mean, other / mean
    s[E_X], s[E_Y], s[N], s[MU], s[SLIDES] = t[END_X], t[END_Y], load_1, t[MU_END], t[SLIDING]
    s[RUBBED] += slipped
    s[FURTHEST] = furthest(s[FURTHEST], u0, um, u1)
    s[TRAVEL] += first + second
    s[LEAST], s[LARGEST] = min(s[LEAST], load_1), max(s[LARGEST], load_1)
    if load_1 == 0.0:
        s[LIFTED] += length
    return slipped


@kernel
def furthest(so_far: float, start: complex, middle: complex, end: complex) -> float:
    """Largest distance from the middle [mm], also inside a step, by a parabola through its square."""
    before, half, after = dot(start, start), dot(middle, middle), dot(end, end)
    largest = after
    bow, lean = 2.0 * (before - 2.0 * half + after), 4.0 * half - 3.0 * before - after
    if bow < 0.0 and 0.0 < lean < -2.0 * bow:
        largest = max(largest, before - 0.25 * lean * lean / bow)
    return math.sqrt(largest) if largest > so_far * so_far else so_far


@kernel
def _heat(
    b: Bearings, i: int, kind: int, level: int, length: float, start: float, end: float, flux: float, opening: float, closing: float
) -> None:  # fmt: skip
    """Heat the plates of a bearing by a mean `flux` [N/(mm s)], which goes as from `opening` to `closing`."""
    k, s = b.kinds[kind], b.state[i]
    first, last, ends = flux, flux, opening + closing
    if ends > 0.0:
        first, last = 2.0 * flux * opening / ends, 2.0 * flux * closing / ends
    factors = int(k[HEAT_ROW]) + KIND_ROWS + LEVEL_ROWS * level
    for j in range(int(k[PLATES])):
        felt = k[SHARE + j] * s[RATIO + j]
        part = _covered_part(k, j, start, end) * felt
        rise = accumulate(b.modes, factors, b.first_row + 2 * i + j, part * first, part * last)
        if k[SHARE + j] * end <= k[HALF_CONTACT]:
            rise += k[INSTANT] * felt * closing
        s[TEMPERATURE + j] = k[AMBIENT] + rise
        s[HOTTEST] = max(s[HOTTEST], s[TEMPERATURE + j])


@called_kernel
def begin_bearings(b: Bearings, motion: NDArray[np.float64], changes: bool) -> None:
    """Give every bearing the load of its trial and the coefficient with which it begins."""
    for i in range(b.constants.shape[0]):
        c, s = b.constants[i], b.state[i]
        kind = int(c[KIND])
        s[N] = s[LEAST] = s[LARGEST] = b.trial[i, N_END]
        speed = length_of(at(motion[START], VELOCITY, complex(c[X], c[Y])))
        law, pressure = law_at(b, i, kind, s[N], changes)
        mean, _, _ = mean_of_plates(
            b, kind, law, pressure, speed, s[TEMPERATURE], s[TEMPERATURE + 1], 0.0, 0.0
        )
        s[MU] = mean

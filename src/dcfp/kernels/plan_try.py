"""A step of the bearings under one slab that is tried: from the slab's motion to their forces on it."""

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import called_kernel, kernel
from dcfp.kernels.plan_bearing import (
    AREA,
    BEHIND,
    CYCLED,
    E_X,
    E_Y,
    ELASTIC,
    END_X,
    END_Y,
    FORCE_COLUMNS,
    FORCE_ROWS,
    FRICTION_END,
    FRICTION_MIDDLE,
    HEAT_ROW,
    HEATED,
    KIND,
    KIND_ROWS,
    LEFT,
    LEVEL_ROWS,
    LIFTING_END,
    LIFTING_MIDDLE,
    M_X,
    M_Y,
    MOVED,
    MU,
    MU_END,
    MU_MIDDLE,
    N_END,
    N_MIDDLE,
    OVER_RADIUS,
    PLATES,
    SLIDING,
    SPEED,
    STATIC,
    TEMPERATURE,
    Bearings,
    N,
    Passage,
    X,
    Y,
    passage,
    rubbing_of,
)
from dcfp.kernels.plan_friction import law_at, mean_of_plates
from dcfp.kernels.plan_heat import expected
from dcfp.kernels.plane_step import dot, elongation_after, times
from dcfp.kernels.sum_of_exponentials import decayed_total


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
def _try_bearing(
    b: Bearings, i: int, level: int, length: float, motion: NDArray[np.float64], forces: NDArray[np.float64], changes: bool, fresh: bool
) -> float:  # fmt: skip
    c, s, t = b.constants[i], b.state[i], b.trial[i]
    kind = int(c[KIND])
    arm = complex(c[X], c[Y])
    p = passage(motion, arm)
    if fresh:
        t[MU_END] = s[MU]
        if b.kinds[kind, HEATED] != 0.0:
            factors = int(b.kinds[kind, HEAT_ROW]) + KIND_ROWS + LEVEL_ROWS * level
            for j in range(int(b.kinds[kind, PLATES])):
                t[LEFT + j] = decayed_total(b.modes, factors, b.first_row + 2 * i + j)
    load_m, load_1 = t[N_MIDDLE], t[N_END]
    mu_m, mu_1 = _friction(b, i, kind, level, length, p, changes)
    over_kf = 1.0 / c[ELASTIC]
    radius_0, radius_m, radius_1 = s[MU] * s[N] * over_kf, mu_m * load_m * over_kf, mu_1 * load_1 * over_kf
    e = complex(s[E_X], s[E_Y])
    e_m, slid = elongation_after(
        e, radius_0, radius_m, p.middle - p.start, p.start_velocity, p.middle_velocity
    )
    e_1, slides = elongation_after(
        e_m, radius_m, radius_1, p.end - p.middle, p.middle_velocity, p.end_velocity
    )
    t[M_X], t[M_Y], t[END_X], t[END_Y] = e_m.real, e_m.imag, e_1.real, e_1.imag
    t[MU_MIDDLE], t[MU_END] = mu_m, mu_1
    t[SLIDING], t[MOVED] = 1.0 if slides else 0.0, 1.0 if slid or slides else 0.0
    _add(forces[FRICTION_MIDDLE], arm, times(c[ELASTIC], e_m))
    _add(forces[FRICTION_END], arm, times(c[ELASTIC], e_1))
    if changes:
        _lift(c, forces[LIFTING_MIDDLE], arm, load_m, p.middle)
        _lift(c, forces[LIFTING_END], arm, load_1, p.end)
    # relative to the friction under the load at rest
    off = times(c[ELASTIC] / (mu_1 * c[STATIC]), e_m - times(0.5, e + e_1))
    return dot(off, off)


@kernel
def _friction(
    b: Bearings, i: int, kind: int, level: int, length: float, p: Passage, changes: bool
) -> tuple[float, float]:
    """Coefficients of a bearing in the middle of a step and at its end, at the temperatures to expect there."""
    c, s, t, k = b.constants[i], b.state[i], b.trial[i], b.kinds[kind]
    load_m, load_1 = t[N_MIDDLE], t[N_END]
    t0, t1 = s[TEMPERATURE], s[TEMPERATURE + 1]
    c0, c1 = s[CYCLED], s[CYCLED + 1]
    if k[HEATED] != 0.0:
        over_area = 1.0 / c[AREA]
        opening = s[N] * over_area * s[MU] * p.start_speed
        closing = load_1 * over_area * t[MU_END] * p.end_speed
        r0, r1 = dot(p.start, p.start), dot(p.end, p.end)
        t0 = expected(b, i, kind, level, 0, r0, r1, opening, closing)
        if k[PLATES] == 2.0:
            t1 = expected(b, i, kind, level, 1, r0, r1, opening, closing)
    rubbing = rubbing_of(c, p, load_m, length)
    c0 += k[SPEED] * k[SPEED] * rubbing
    c1 += k[SPEED + 1] * k[SPEED + 1] * rubbing
    law, pressure = law_at(b, i, kind, load_m, changes)
    mu_m, _, _ = mean_of_plates(
        b, kind, law, pressure, p.middle_speed,
        0.5 * (s[TEMPERATURE] + t0), 0.5 * (s[TEMPERATURE + 1] + t1), 0.5 * (s[CYCLED] + c0), 0.5 * (s[CYCLED + 1] + c1),
    )  # fmt: skip
    law, pressure = law_at(b, i, kind, load_1, changes)
    mu_1, _, _ = mean_of_plates(b, kind, law, pressure, p.end_speed, t0, t1, c0, c1)
    return mu_m, mu_1


@kernel
def _lift(
    c: NDArray[np.float64], row: NDArray[np.float64], arm: complex, load: float, place: complex
) -> None:
    """Add the pendulum's force of a load beyond that at rest, and what its slider adds to the moments."""
    more = load - c[STATIC]
    _add(row, arm, times(more * c[OVER_RADIUS], place))
    lag = times(more * c[BEHIND], place)
    row[3] += lag.real
    row[4] += lag.imag


@kernel
def _add(row: NDArray[np.float64], arm: complex, force: complex) -> None:
    row[0] += force.real
    row[1] += force.imag
    row[2] += arm.real * force.imag - arm.imag * force.real

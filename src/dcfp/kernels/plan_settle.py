"""The bearings under one slab at the start of an analysis, and at the end of a step that is taken."""

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import called_kernel, kernel
from dcfp.kernels.plan_bearing import (
    AREA,
    CYCLED,
    E_X,
    E_Y,
    ELASTIC,
    END_X,
    END_Y,
    FURTHEST,
    HEATED,
    KIND,
    LARGEST,
    LEAST,
    LIFTED,
    M_X,
    M_Y,
    MOVED,
    MU,
    MU_END,
    MU_MIDDLE,
    N_END,
    N_MIDDLE,
    PLATES,
    RATIO,
    RUBBED,
    SLIDES,
    SLIDING,
    SPEED,
    START,
    TEMPERATURE,
    TRAVEL,
    VELOCITY,
    Bearings,
    N,
    X,
    Y,
    at,
    furthest,
    highest,
    passage,
    rubbing_of,
)
from dcfp.kernels.plan_friction import law_at, mean_of_plates
from dcfp.kernels.plan_heat import heat_up
from dcfp.kernels.plane_step import dot, length_of


@called_kernel
def settle_bearings(
    b: Bearings, level: int, length: float, motion: NDArray[np.float64], changes: bool
) -> tuple[float, float, bool]:
    """Leave every bearing at the end of the step that was tried, and heat it; return the sum of mu N |slip| [N mm], the energy in the springs (b) [N mm] and whether any slid."""
    rubbed, stored, moved = 0.0, 0.0, False
    for i in range(b.constants.shape[0]):
        rubbed += _settle(b, i, level, length, motion, changes)
        moved = moved or b.trial[i, MOVED] != 0.0
        s = b.state[i]
        stored += 0.5 * b.constants[i, ELASTIC] * (s[E_X] * s[E_X] + s[E_Y] * s[E_Y])
    return rubbed, stored, moved


@kernel
def _settle(
    b: Bearings, i: int, level: int, length: float, motion: NDArray[np.float64], changes: bool
) -> float:
    c, s, t = b.constants[i], b.state[i], b.trial[i]
    kind = int(c[KIND])
    k = b.kinds[kind]
    p = passage(motion, complex(c[X], c[Y]))
    load_m, load_1 = t[N_MIDDLE], t[N_END]
    first, second, slipped = 0.0, 0.0, 0.0
    if t[MOVED] != 0.0:
        e, e_m, e_1 = complex(s[E_X], s[E_Y]), complex(t[M_X], t[M_Y]), complex(t[END_X], t[END_Y])
        first, second = (
            length_of((p.middle - p.start) - (e_m - e)),
            length_of((p.end - p.middle) - (e_1 - e_m)),
        )
        half = t[MU_MIDDLE] * load_m
        slipped = 0.5 * ((s[MU] * s[N] + half) * first + (half + t[MU_END] * load_1) * second)
        rubbing = rubbing_of(c, p, load_m, length)
        s[CYCLED] += k[SPEED] * k[SPEED] * rubbing
        s[CYCLED + 1] += k[SPEED + 1] * k[SPEED + 1] * rubbing
    if k[HEATED] != 0.0:
        over_area = 1.0 / c[AREA]
        opening = s[N] * over_area * s[MU] * p.start_speed if t[MOVED] != 0.0 or s[SLIDES] != 0.0 else 0.0
        closing = load_1 * over_area * t[MU_END] * p.end_speed if t[SLIDING] != 0.0 else 0.0
        start, end = dot(p.start, p.start), dot(p.end, p.end)
        heat_up(b, i, kind, level, start, end, slipped * over_area / length, opening, closing)
    if k[PLATES] == 2.0:
        law, pressure = law_at(b, i, kind, load_1, changes)
        mean, one, other = mean_of_plates(
            b, kind, law, pressure, p.end_speed, s[TEMPERATURE], s[TEMPERATURE + 1], s[CYCLED], s[CYCLED + 1]
        )
        s[RATIO], s[RATIO + 1] = one / mean, other / mean
    _bear(s, load_m, load_1, length)
    s[E_X], s[E_Y], s[MU], s[SLIDES] = t[END_X], t[END_Y], t[MU_END], t[SLIDING]
    s[RUBBED] += slipped
    s[FURTHEST] = furthest(s[FURTHEST], p.start, p.middle, p.end)
    s[TRAVEL] += first + second
    return slipped


@kernel
def _bear(s: NDArray[np.float64], middle: float, end: float, length: float) -> None:
    """Note the loads [N] in the middle and at the end of a step: the extremes also between them, but for a load that is cut off at zero."""
    start = s[N]
    s[LARGEST] = highest(s[LARGEST], start, middle, end)
    least = min(min(start, middle), end)
    if least > 0.0:
        least = max(-highest(-s[LEAST], -start, -middle, -end), 0.0)
    s[LEAST] = min(s[LEAST], least)
    lifted = (0.25 if start == 0.0 else 0.0) + (0.5 if middle == 0.0 else 0.0) + (0.25 if end == 0.0 else 0.0)
    s[LIFTED] += lifted * length
    s[N] = end


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

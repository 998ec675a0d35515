"""Heat at the centres of the plates of bearings under one slab."""

import math

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import called_kernel, kernel
from dcfp.kernels.plan_bearing import (
    AMBIENT,
    DISPLACEMENT,
    END,
    HALF_CONTACT,
    HEAT_ROW,
    HEATED,
    HOTTEST,
    INSTANT,
    KIND,
    KIND_ROWS,
    LEFT,
    LEVEL_ROWS,
    PLATES,
    RATIO,
    SHARE,
    START,
    TEMPERATURE,
    Bearings,
    X,
    Y,
    at,
)
from dcfp.kernels.plane_step import dot, length_of
from dcfp.kernels.sum_of_exponentials import accumulate, fill_decay, fill_weights, total


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
def _edge(k: NDArray[np.float64], plate: int) -> float:
    """Displacement of a bearing [mm] at which the centre of a plate comes out from under the slider."""
    return k[HALF_CONTACT] / k[SHARE + plate]


@kernel
def _covered_part(k: NDArray[np.float64], plate: int, start: float, end: float) -> float:
    """Part of a step in which the centre of a plate is under the slider, between two squares of the displacement [mm2]: Eq. (12) of Li et al. (2020)."""
    edge = _edge(k, plate)
    square = edge * edge
    before, after = start <= square, end <= square
    if before == after:
        return 1.0 if after else 0.0
    start, end = math.sqrt(start), math.sqrt(end)
    part = (edge - start) / (end - start)
    return part if before else 1.0 - part


@called_kernel
def crosses_edge(b: Bearings, motion: NDArray[np.float64]) -> bool:
    """Whether the centre of any plate comes under its slider or leaves it over a step."""
    # no bearing goes further than the slab does and what its rotation adds
    far = max(
        length_of(complex(motion[START, 0], motion[START, 1])),
        length_of(complex(motion[END, 0], motion[END, 1])),
    )
    if far + b.reach * max(abs(motion[START, 2]), abs(motion[END, 2])) < b.nearest_edge:
        return False
    for i in range(b.constants.shape[0]):
        c = b.constants[i]
        k = b.kinds[int(c[KIND])]
        if k[HEATED] == 0.0:
            continue
        arm = complex(c[X], c[Y])
        u0, u1 = at(motion[START], DISPLACEMENT, arm), at(motion[END], DISPLACEMENT, arm)
        start, end = dot(u0, u0), dot(u1, u1)
        for j in range(int(k[PLATES])):
            edge = _edge(k, j)
            if (start <= edge * edge) != (end <= edge * edge):
                return True
    return False


@kernel
def expected(
    b: Bearings, i: int, kind: int, level: int, plate: int, start: float, end: float, opening: float, closing: float
) -> float:  # fmt: skip
    """Temperature of a plate [degC] to expect at the end of a step, between two squares of the displacement [mm2], under fluxes at its ends [N/(mm s)]."""
    k, ready = b.kinds[kind], b.prepared[kind, level]
    rise = k[AMBIENT] + b.trial[i, LEFT + plate]
    if _covered_part(k, plate, start, end) == 1.0:
        felt = k[SHARE + plate] * b.state[i, RATIO + plate]
        rise += felt * (ready[1] * opening + (ready[2] + k[INSTANT]) * closing)
    return rise


@kernel
def heat_up(
    b: Bearings, i: int, kind: int, level: int, start: float, end: float, flux: float, opening: float, closing: float
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
        if end <= _edge(k, j) ** 2:
            rise += k[INSTANT] * felt * closing
        s[TEMPERATURE + j] = k[AMBIENT] + rise
        s[HOTTEST] = max(s[HOTTEST], s[TEMPERATURE + j])

"""A step of slab, storeys and bearings that is tried: two passes over the bearings find the parabolas of their forces."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import called_kernel, kernel
from dcfp.kernels.plan_bearing import (
    END,
    FORCE_COLUMNS,
    FRICTION_END,
    FRICTION_MIDDLE,
    LIFTING_END,
    LIFTING_MIDDLE,
    MIDDLE,
    N_END,
    N_MIDDLE,
    OUTPUTS,
    TIPPING,
    Bearings,
)
from dcfp.kernels.plan_load import Slab, share_loads
from dcfp.kernels.plan_modes import DRIVES, FORCE, GROUND, Linear, add_up
from dcfp.kernels.plan_try import try_bearings

#: How close forces must be to what was expected for a step not to be tried again, and the moments of the slab's own inertia, over the weight (and height).
_AS_EXPECTED = 1e-3


class Work(NamedTuple):
    """Room for the numbers of a step."""

    motion: NDArray[np.float64]  # (MOTION_ROWS, OUTPUTS)
    free: NDArray[np.float64]  # (2 x OUTPUTS,)
    forces: NDArray[np.float64]  # (FORCE_ROWS, FORCE_COLUMNS)
    carried: NDArray[np.float64]  # (2 x 3, FORCE_COLUMNS): friction, then lifting
    drive: NDArray[np.float64]  # (3, DRIVES): whole, friction alone, lifting alone
    sums: NDArray[np.float64]  # (SUM_ROWS, INTEGRATED)
    storeys: NDArray[
        np.float64
    ]  # (2, 2, fixed-base modes): displacement and velocity, in the middle and at the end
    rates: NDArray[np.float64]  # (3, RATE_COLUMNS): at the start, in the middle, at the end
    slab: NDArray[np.float64]  # (3, SLAB_COLUMNS): at the start, in the middle, at the end
    half: NDArray[np.complex128]  # (modes,)


class Plan(NamedTuple):
    """A building on its bearings as the kernels see it."""

    bearings: Bearings
    slab: Slab
    linear: Linear
    stiffness: NDArray[np.float64]  # (3, 3) of all pendulums under the static loads [N/mm, N, N mm]
    lag: NDArray[np.float64]  # (2, 3): moments of the static loads on sliders that stay behind [N]
    watched: NDArray[np.float64]  # (points, 3): places from the slab's origin, and largest displacement [mm]


@called_kernel
def begin_step(
    plan: Plan, room: Work, ground: NDArray[np.float64], i: int, part: float, interval: float, level: int, z: NDArray[np.complex128]
) -> None:  # fmt: skip
    """Set what drives a step that begins at a `part` of interval `i`, and the outputs that it has without the bearings' forces."""
    drive = room.drive
    for j in range(2):
        change = ground[i + 1, j] - ground[i, j]
        drive[0, GROUND + j], drive[0, GROUND + 2 + j] = ground[i, j] + part * change, change / interval
    add_up(plan.linear.outputs[level], z, room.free)
    influence = plan.linear.influence[level]
    for j in range(2 * OUTPUTS):
        for k in range(GROUND, DRIVES):
            room.free[j] += influence[j, k] * drive[0, k]


@called_kernel
def try_step(
    plan: Plan, room: Work, level: int, length: float, changes: bool, middle: float, end: float
) -> tuple[float, bool]:  # fmt: skip
    """Find the forces of all bearings over a step; return how far friction is from its chord in the middle, over mu N, and whether all bearings lift off.

    `middle` and `end` are the weight over that at rest then.
    """
    b, forces, carried = plan.bearings, room.forces, room.carried
    h, weight, squares, lifted = length, plan.slab.weight, 0.0, False
    # as it went on, and at the end what the first pass is compared with
    for j in range(FORCE_COLUMNS):
        for kind in range(2):
            value, rate, bend = carried[3 * kind, j], carried[3 * kind + 1, j], carried[3 * kind + 2, j]
            forces[2 * kind, j] = value + 0.5 * h * (rate + 0.5 * h * bend)
            forces[2 * kind + 1, j] = value + h * (rate + h * bend)
    _drive(room, h)
    _move(plan, room, level)
    wide = plan.slab.height != 0.0
    fresh = True
    mx, my, ex, ey = 0.0, 0.0, 0.0, 0.0
    for turn in range(2):
        expected_x = forces[FRICTION_END, 0] + forces[LIFTING_END, 0]
        expected_y = forces[FRICTION_END, 1] + forces[LIFTING_END, 1]
        again = True
        for inner in range(2 if turn == 1 and wide and changes else 1):
            if changes and again:
                _, _, mx, my = shear_and_tipping(
                    plan, room.motion[MIDDLE], forces[FRICTION_MIDDLE], forces[LIFTING_MIDDLE]
                )
                _, _, ex, ey = shear_and_tipping(
                    plan, room.motion[END], forces[FRICTION_END], forces[LIFTING_END]
                )
                lifted = not share_loads(b, plan.slab, N_MIDDLE, middle, mx, my)
                lifted = not share_loads(b, plan.slab, N_END, end, ex, ey) or lifted
            if again:
                squares = try_bearings(b, level, h, room.motion, forces, changes, fresh)
                fresh = False
            if inner == 0 and turn == 1 and wide and changes:
                _, _, nx, ny = shear_and_tipping(
                    plan, room.motion[MIDDLE], forces[FRICTION_MIDDLE], forces[LIFTING_MIDDLE]
                )
                _, _, lx, ly = shear_and_tipping(
                    plan, room.motion[END], forces[FRICTION_END], forces[LIFTING_END]
                )
                off = math.sqrt((nx - mx) ** 2 + (ny - my) ** 2 + (lx - ex) ** 2 + (ly - ey) ** 2)
                again = off > _AS_EXPECTED * 0.05 * weight * plan.slab.height
        _drive(room, h)
        _move(plan, room, level)
        dx = forces[FRICTION_END, 0] + forces[LIFTING_END, 0] - expected_x
        dy = forces[FRICTION_END, 1] + forces[LIFTING_END, 1] - expected_y
        # a light slab under many storeys feels a small force
        if math.sqrt(dx * dx + dy * dy) <= 0.2 * _AS_EXPECTED * plan.slab.own_weight:
            if not changes:
                break
            _, _, nx, ny = shear_and_tipping(
                plan, room.motion[MIDDLE], forces[FRICTION_MIDDLE], forces[LIFTING_MIDDLE]
            )
            _, _, lx, ly = shear_and_tipping(
                plan, room.motion[END], forces[FRICTION_END], forces[LIFTING_END]
            )
            off = math.sqrt((nx - mx) ** 2 + (ny - my) ** 2 + (lx - ex) ** 2 + (ly - ey) ** 2)
            if off * plan.slab.leverage * weight <= 0.2 * _AS_EXPECTED * plan.slab.own_weight:
                break
    return math.sqrt(squares), lifted


@kernel
def shear_and_tipping(
    plan: Plan, motion: NDArray[np.float64], friction: NDArray[np.float64], lifting: NDArray[np.float64]
) -> tuple[float, float, float, float]:
    """Return the base shear in x and y [N], and moments that press where X and Y are large [N mm]: of the floors, of the slab's own inertia and of sliders that stay behind."""
    k, lag, height = plan.stiffness, plan.lag, plan.slab.height
    x, y, turn = motion[0], motion[1], motion[2]
    shear_x = k[0, 0] * x + k[0, 1] * y + k[0, 2] * turn + friction[0] + lifting[0]
    shear_y = k[1, 0] * x + k[1, 1] * y + k[1, 2] * turn + friction[1] + lifting[1]
    behind_x = lag[0, 0] * x + lag[0, 1] * y + lag[0, 2] * turn + lifting[3]
    behind_y = lag[1, 0] * x + lag[1, 1] * y + lag[1, 2] * turn + lifting[4]
    return (
        shear_x,
        shear_y,
        motion[TIPPING] + height * shear_x + behind_x,
        motion[TIPPING + 1] + height * shear_y + behind_y,
    )


@kernel
def _drive(room: Work, length: float) -> None:
    """Write the parabolas through the forces at the start, in the middle and at the end into what drives the step: the bearings pull back."""
    over, drive = 1.0 / length, room.drive
    for kind in range(2):
        for j in range(3):
            start, middle, end = (
                room.carried[3 * kind, j],
                room.forces[2 * kind, j],
                room.forces[2 * kind + 1, j],
            )
            drive[1 + kind, j] = start
            drive[1 + kind, 3 + j] = over * (4.0 * middle - 3.0 * start - end)
            drive[1 + kind, 6 + j] = 2.0 * over * over * (start - 2.0 * middle + end)
    for j in range(FORCE, GROUND):
        drive[0, j] = -drive[1, j] - drive[2, j]


@kernel
def _move(plan: Plan, room: Work, level: int) -> None:
    """Write the motion in the middle and at the end."""
    influence = plan.linear.influence[level]
    for row in range(2):
        for j in range(OUTPUTS):
            found = room.free[row * OUTPUTS + j]
            for k in range(FORCE, GROUND):
                found += influence[row * OUTPUTS + j, k] * room.drive[0, k]
            room.motion[MIDDLE + row, j] = found

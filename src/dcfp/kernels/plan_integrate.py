"""A building on many bearings through a ground motion.

Slab and storeys are advanced exactly, by their complex modes, under the forces of all bearings that are not linear: parabolas through their values at the start, in the middle and at the end of
a step, which two passes over the bearings find. The sample interval is halved as often as friction needs.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import called_kernel, kernel
from dcfp.kernels.heat_state import MOST_HALVINGS
from dcfp.kernels.motion import DONE, NO_NUMBER
from dcfp.kernels.plan_bearing import (
    DISPLACEMENT,
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
    START,
    STATIC,
    TIPPING,
    Bearings,
    at,
    begin_bearings,
    crosses_edge,
    furthest,
    prepare_heat,
    settle_bearings,
    try_bearings,
)
from dcfp.kernels.plan_load import Slab, share_loads
from dcfp.kernels.plan_modes import (
    DRIVES,
    FORCE,
    GROUND,
    Linear,
    advance_modes,
    damped_before,
    damped_over,
    outputs_of,
    work,
)
from dcfp.kernels.plane_integrate import LENGTHS, PARTS
from dcfp.kernels.plane_slide import AT_THE_EDGE, EASY, PlaneControl

# entries of what an integration leaves: energies [N mm] put in, dissipated by friction, by the change of loads, by the storeys; sum of mu N |slip|, in springs (b);
# steps, halvings, status, steps in which all bearings lifted off, time of the last slip [s]
(
    INPUT,
    HYSTERETIC,
    LIFTING,
    DAMPED,
    RUBBED,
    STORED,
    STEPS,
    HALVINGS,
    STATUS,
    ALL_LIFTED,
    LAST_SLIP,
    TALLIES,
) = range(12)
# columns of a line: slab's displacement and velocity; forces of friction and of the change of load (x, y, torque each); moments that tip; energies from `INPUT` to `STORED`
LINE_MOTION, LINE_FRICTION, LINE_LIFTING, LINE_TIPPING, LINE_ENERGIES, LINE = 0, 6, 9, 12, 14, 20
# columns of what is kept of each bearing: its state up to the second temperature
KEPT = 7
#: How close forces must be to what was expected for a step not to be tried again, and the moments of the slab's own inertia, over the weight (and height).
_AS_EXPECTED = 1e-3
#: Rows of the carried forces: values at the start, rates and curvatures; columns as of forces.
_VALUE, _RATE, _CURVATURE = range(3)


class Work(NamedTuple):
    """Room for the numbers of a step."""

    motion: NDArray[np.float64]  # (MOTION_ROWS, OUTPUTS)
    free: NDArray[np.float64]  # (2 x OUTPUTS,)
    forces: NDArray[np.float64]  # (FORCE_ROWS, FORCE_COLUMNS)
    carried: NDArray[np.float64]  # (2 x 3, FORCE_COLUMNS): friction, then lifting
    drive: NDArray[np.float64]  # (3, DRIVES): whole, friction alone, lifting alone
    sums: NDArray[np.float64]  # (SUM_ROWS, INTEGRATED)
    storeys: NDArray[np.float64]  # (2, fixed-base modes)
    rates: NDArray[np.float64]  # (9,)
    half: NDArray[np.complex128]  # (modes,)


class Plan(NamedTuple):
    """A building on its bearings as the kernels see it."""

    bearings: Bearings
    slab: Slab
    linear: Linear
    stiffness: NDArray[np.float64]  # (3, 3) of all pendulums under the static loads [N/mm, N, N mm]
    lag: NDArray[np.float64]  # (2, 3): moments of the static loads on sliders that stay behind [N]
    watched: NDArray[np.float64]  # (points, 3): places from the slab's origin, and largest displacement [mm]


@kernel
def integrate_plan(
    plan: Plan,
    ground: NDArray[np.float64],
    ratios: NDArray[np.float64],
    control: PlaneControl,
    changes: bool,
    free_from: int,
    rest: float,
    z: NDArray[np.complex128],
    room: Work,
    tallies: NDArray[np.float64],
    lines: NDArray[np.float64],
    modes: NDArray[np.complex128],
    kept: NDArray[np.float64],
) -> int:
    """Respond to the samples of the ground's acceleration [mm/s2], shape (samples, 2); return the samples done.

    `ratios` [-] are of the weight to that at rest, by sample, and whether loads change besides, `changes` says. From sample `free_from` on it stops when nothing has slid for a time `rest` [s].
    Rows of `lines`, `modes` (complex modes) and `kept` (bearings) are of samples.
    """
    b, interval = plan.bearings, control.interval
    level: int = control.fewest_halvings
    done, status = 0, DONE
    for i in range(b.constants.shape[0]):
        b.trial[i, N_END] = b.trial[i, N_MIDDLE] = b.constants[i, STATIC]
    if changes:
        share_loads(b, plan.slab, N_END, ratios[0], 0.0, 0.0)
    begin_bearings(b, room.motion, changes)
    _record(plan, room, tallies, z, lines[0], modes[0], kept[0])
    for i in range(ground.shape[0] - 1):
        place = 0
        while place < PARTS:
            length = interval * LENGTHS[level]
            part, over = place * (1.0 / PARTS), LENGTHS[level]
            _begin_step(plan, room, ground, i, part, interval, level, z)
            prepare_heat(b, level, length)
            rise = ratios[i + 1] - ratios[i]
            middle, end = ratios[i] + (part + 0.5 * over) * rise, ratios[i] + (part + over) * rise
            off, lifted = _passes(plan, room, level, length, changes, middle, end)
            refused = level < MOST_HALVINGS and (
                off > control.tolerance
                or (level < control.fewest_halvings + AT_THE_EDGE and crosses_edge(b, room.motion))
            )
            if refused:
                level += 1
                continue
            now = i * interval + (part + over) * interval
            _end_step(plan, room, level, length, now, changes, z, tallies)
            if lifted:
                tallies[ALL_LIFTED] += 1.0
            place += PARTS >> level
            if (
                off < EASY * control.tolerance
                and level > control.fewest_halvings
                and place % (PARTS >> (level - 1)) == 0
            ):
                level -= 1
            if not math.isfinite(tallies[STORED] + tallies[INPUT]):
                status = NO_NUMBER
                break
        if status != DONE:
            break
        done = i + 1
        _record(plan, room, tallies, z, lines[done], modes[done], kept[done])
        if done >= free_from and done * interval - tallies[LAST_SLIP] > rest:
            break
    tallies[STATUS], tallies[HALVINGS] = status, level
    return done


@called_kernel
def _begin_step(
    plan: Plan, room: Work, ground: NDArray[np.float64], i: int, part: float, interval: float, level: int, z: NDArray[np.complex128]
) -> None:  # fmt: skip
    """Set what drives a step that begins at a `part` of interval `i`, and the outputs that it has without the bearings' forces."""
    drive = room.drive
    for j in range(2):
        change = ground[i + 1, j] - ground[i, j]
        drive[0, GROUND + j], drive[0, GROUND + 2 + j] = ground[i, j] + part * change, change / interval
    outputs_of(plan.linear, level, z, room.free)
    influence = plan.linear.influence[level]
    for j in range(2 * OUTPUTS):
        for k in range(GROUND, DRIVES):
            room.free[j] += influence[j, k] * drive[0, k]


@called_kernel
def _passes(
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
                mx, my = _tipping(plan, room, MIDDLE, FRICTION_MIDDLE, LIFTING_MIDDLE)
                ex, ey = _tipping(plan, room, END, FRICTION_END, LIFTING_END)
                lifted = not share_loads(b, plan.slab, N_MIDDLE, middle, mx, my)
                lifted = not share_loads(b, plan.slab, N_END, end, ex, ey) or lifted
            if again:
                squares = try_bearings(b, level, h, room.motion, forces, changes, fresh)
                fresh = False
            if inner == 0 and turn == 1 and wide and changes:
                nx, ny = _tipping(plan, room, MIDDLE, FRICTION_MIDDLE, LIFTING_MIDDLE)
                lx, ly = _tipping(plan, room, END, FRICTION_END, LIFTING_END)
                off = math.sqrt((nx - mx) ** 2 + (ny - my) ** 2 + (lx - ex) ** 2 + (ly - ey) ** 2)
                again = off > _AS_EXPECTED * 0.05 * weight * plan.slab.height
        _drive(room, h)
        _move(plan, room, level)
        dx = forces[FRICTION_END, 0] + forces[LIFTING_END, 0] - expected_x
        dy = forces[FRICTION_END, 1] + forces[LIFTING_END, 1] - expected_y
        if math.sqrt(dx * dx + dy * dy) <= 0.2 * _AS_EXPECTED * weight and not changes:
            break
    return math.sqrt(squares), lifted


@kernel
def _tipping(plan: Plan, room: Work, row: int, friction: int, lifting: int) -> tuple[float, float]:
    """Moments that press where X and Y are large [N mm]: of the floors, of the slab's own inertia and of sliders that stay behind."""
    motion, forces, k = room.motion[row], room.forces, plan.stiffness
    x, y, turn = motion[0], motion[1], motion[2]
    shear_x = k[0, 0] * x + k[0, 1] * y + k[0, 2] * turn + forces[friction, 0] + forces[lifting, 0]
    shear_y = k[1, 0] * x + k[1, 1] * y + k[1, 2] * turn + forces[friction, 1] + forces[lifting, 1]
    lag, height = plan.lag, plan.slab.height
    return (
        motion[TIPPING]
        + height * shear_x
        + lag[0, 0] * x
        + lag[0, 1] * y
        + lag[0, 2] * turn
        + forces[lifting, 3],
        motion[TIPPING + 1]
        + height * shear_y
        + lag[1, 0] * x
        + lag[1, 1] * y
        + lag[1, 2] * turn
        + forces[lifting, 4],
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


@called_kernel
def _end_step(
    plan: Plan, room: Work, level: int, length: float, now: float, changes: bool, z: NDArray[np.complex128], tallies: NDArray[np.float64]
) -> None:  # fmt: skip
    """Take the step that was tried; it ends `now` [s]."""
    lin, drive, sums, h = plan.linear, room.drive, room.sums, length
    storeys = lin.fixed.shape[0] > 0
    if storeys:
        damped_before(lin, level, h, drive[0], z, room.half, room.storeys, room.rates)
    advance_modes(lin, level, h, drive[0], z, sums)
    if storeys:
        tallies[DAMPED] += damped_over(lin, h, drive[0], z, room.storeys, room.rates)
    for j in range(2):
        travel, area = sums[0, 3 + j], sums[1, 3 + j]
        tallies[INPUT] -= drive[0, GROUND + j] * travel + drive[0, GROUND + 2 + j] * (h * travel - area)
    absorbed = 0.0
    for j in range(3):
        absorbed += work(sums, h, drive[1], j, 3, j)
        if changes:
            tallies[LIFTING] += work(sums, h, drive[2], j, 3, j)
    for p in range(plan.watched.shape[0]):
        arm = complex(plan.watched[p, 0], plan.watched[p, 1])
        plan.watched[p, 2] = furthest(
            plan.watched[p, 2], at(room.motion[START], DISPLACEMENT, arm), at(room.motion[MIDDLE], DISPLACEMENT, arm), at(room.motion[END], DISPLACEMENT, arm)
        )  # fmt: skip
    rubbed, stored = settle_bearings(plan.bearings, level, h, room.motion, changes)
    tallies[HYSTERETIC] += absorbed - (stored - tallies[STORED])
    tallies[STORED] = stored
    tallies[RUBBED] += rubbed
    tallies[STEPS] += 1.0
    if rubbed > 0.0:
        tallies[LAST_SLIP] = now
    carried, forces = room.carried, room.forces
    over = 1.0 / h
    for kind in range(2):
        for j in range(FORCE_COLUMNS):
            start, middle, end = carried[3 * kind, j], forces[2 * kind, j], forces[2 * kind + 1, j]
            bend = 2.0 * over * over * (start - 2.0 * middle + end)
            carried[3 * kind, j] = end
            carried[3 * kind + 1, j] = over * (4.0 * middle - 3.0 * start - end) + 2.0 * h * bend
            carried[3 * kind + 2, j] = bend
    for j in range(OUTPUTS):
        room.motion[START, j] = room.motion[END, j]


@called_kernel
def _record(
    plan: Plan, room: Work, tallies: NDArray[np.float64], z: NDArray[np.complex128], line: NDArray[np.float64], modes: NDArray[np.complex128], kept: NDArray[np.float64]
) -> None:  # fmt: skip
    for j in range(6):
        line[LINE_MOTION + j] = room.motion[START, j]
    for j in range(3):
        line[LINE_FRICTION + j], line[LINE_LIFTING + j] = room.carried[0, j], room.carried[3, j]
    line[LINE_TIPPING], line[LINE_TIPPING + 1] = _tipping_now(plan, room)
    for j in range(6):
        line[LINE_ENERGIES + j] = tallies[INPUT + j]
    for m in range(z.size):
        modes[m] = z[m]
    for i in range(kept.shape[0]):
        for j in range(KEPT):
            kept[i, j] = plan.bearings.state[i, j]


@kernel
def _tipping_now(plan: Plan, room: Work) -> tuple[float, float]:
    """Return the moments at the end of the last step."""
    motion, carried, k = room.motion[START], room.carried, plan.stiffness
    x, y, turn = motion[0], motion[1], motion[2]
    shear_x = k[0, 0] * x + k[0, 1] * y + k[0, 2] * turn + carried[0, 0] + carried[3, 0]
    shear_y = k[1, 0] * x + k[1, 1] * y + k[1, 2] * turn + carried[0, 1] + carried[3, 1]
    lag, height = plan.lag, plan.slab.height
    return (
        motion[TIPPING] + height * shear_x + lag[0, 0] * x + lag[0, 1] * y + lag[0, 2] * turn + carried[3, 3],
        motion[TIPPING + 1]
        + height * shear_y
        + lag[1, 0] * x
        + lag[1, 1] * y
        + lag[1, 2] * turn
        + carried[3, 4],
    )

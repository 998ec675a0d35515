"""A building on many bearings through a ground motion.

Slab and storeys are advanced exactly, by their complex modes, under the forces of all bearings that are not linear: parabolas through their values at the start, in the middle and at the end of
a step, which two passes over the bearings find. The sample interval is halved as often as friction needs.
"""

import math

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import called_kernel, kernel
from dcfp.kernels.heat_state import MOST_HALVINGS
from dcfp.kernels.motion import DONE, NO_NUMBER
from dcfp.kernels.plan_bearing import N_END, N_MIDDLE, START, STATIC
from dcfp.kernels.plan_end import ALL_LIFTED, HALVINGS, INPUT, LAST_SLIP, STATUS, STORED, end_step
from dcfp.kernels.plan_heat import crosses_edge, prepare_heat
from dcfp.kernels.plan_load import share_loads
from dcfp.kernels.plan_settle import begin_bearings
from dcfp.kernels.plan_step import Plan, Work, begin_step, shear_and_tipping, try_step
from dcfp.kernels.plane_integrate import LENGTHS, PARTS
from dcfp.kernels.plane_slide import AT_THE_EDGE, EASY, PlaneControl

# columns of a line: slab's displacement and velocity; forces of friction and of the change of load (x, y, torque each); moments that tip; energies from `INPUT` to `STORED`
LINE_MOTION, LINE_FRICTION, LINE_LIFTING, LINE_TIPPING, LINE_ENERGIES, LINE = 0, 6, 9, 12, 14, 20
# columns of what is kept of each bearing: its state up to the second temperature
KEPT = 7


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
            begin_step(plan, room, ground, i, part, interval, level, z)
            prepare_heat(b, level, length)
            rise = ratios[i + 1] - ratios[i]
            middle, end = ratios[i] + (part + 0.5 * over) * rise, ratios[i] + (part + over) * rise
            off, lifted = try_step(plan, room, level, length, changes, middle, end)
            refused = level < MOST_HALVINGS and (
                off > control.tolerance
                or (level < control.fewest_halvings + AT_THE_EDGE and crosses_edge(b, room.motion))
            )
            if refused:
                level += 1
                continue
            now = i * interval + (part + over) * interval
            end_step(plan, room, level, length, now, changes, z, tallies)
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
def _record(
    plan: Plan, room: Work, tallies: NDArray[np.float64], z: NDArray[np.complex128], line: NDArray[np.float64], modes: NDArray[np.complex128], kept: NDArray[np.float64]
) -> None:  # fmt: skip
    for j in range(6):
        line[LINE_MOTION + j] = room.motion[START, j]
    for j in range(3):
        line[LINE_FRICTION + j], line[LINE_LIFTING + j] = room.carried[0, j], room.carried[3, j]
    _, _, tip_x, tip_y = shear_and_tipping(plan, room.motion[START], room.carried[0], room.carried[3])
    line[LINE_TIPPING], line[LINE_TIPPING + 1] = tip_x, tip_y
    for j in range(6):
        line[LINE_ENERGIES + j] = tallies[INPUT + j]
    for m in range(z.size):
        modes[m] = z[m]
    for i in range(kept.shape[0]):
        for j in range(KEPT):
            kept[i, j] = plan.bearings.state[i, j]

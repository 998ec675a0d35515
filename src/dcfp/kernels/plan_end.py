"""A step of slab, storeys and bearings that is taken, and what is added up and compared over it."""

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import called_kernel, kernel
from dcfp.kernels.plan_bearing import (
    DISPLACEMENT,
    END,
    FORCE_COLUMNS,
    FRICTION_END,
    FRICTION_MIDDLE,
    LIFTING_END,
    LIFTING_MIDDLE,
    MIDDLE,
    OUTPUTS,
    START,
    at,
    furthest,
    highest,
)
from dcfp.kernels.plan_damping import note_rate, observe, taken_over
from dcfp.kernels.plan_modes import GROUND, advance_modes, work
from dcfp.kernels.plan_settle import settle_bearings
from dcfp.kernels.plan_step import Plan, Work, shear_and_tipping

# entries of what an integration leaves: energies [N mm] put in, dissipated by friction, by the change of loads, by the storeys; sum of mu N |slip|, in springs (b);
# steps, halvings, status, steps in which all bearings lifted off, time of the last slip [s]; largest acceleration of the slab [mm/s2], base shear [N] and rotation [rad]
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
    ACCELERATION,
    SHEAR,
    ROTATION,
    TALLIES,
) = range(15)


@called_kernel
def end_step(
    plan: Plan, room: Work, level: int, length: float, now: float, changes: bool, z: NDArray[np.complex128], tallies: NDArray[np.float64]
) -> None:  # fmt: skip
    """Take the step that was tried; it ends `now` [s]."""
    _advance(plan, room, level, length, z, tallies)
    _add_works(room, length, changes, tallies)
    _note_peaks(plan, room, tallies)
    rubbed, stored, moved = settle_bearings(plan.bearings, level, length, room.motion, changes)
    # what spring (b) has stored was put in with what friction has dissipated
    tallies[HYSTERETIC] -= stored - tallies[STORED]
    tallies[STORED] = stored
    tallies[RUBBED] += rubbed
    tallies[STEPS] += 1.0
    if moved:
        tallies[LAST_SLIP] = now
    _carry_on(room, length)


@kernel
def _advance(
    plan: Plan, room: Work, level: int, length: float, z: NDArray[np.complex128], tallies: NDArray[np.float64]
) -> None:
    """Advance the modes; add up what the storeys' damping takes, and find the largest acceleration of the slab."""
    lin, slab, rates = plan.linear, room.slab, room.rates
    advance_modes(lin, level, length, room.drive[0], z, room.half, room.sums, slab)
    tallies[ACCELERATION] = furthest(
        tallies[ACCELERATION],
        complex(slab[0, 0], slab[0, 1]),
        complex(slab[1, 0], slab[1, 1]),
        complex(slab[2, 0], slab[2, 1]),
    )
    if lin.fixed.shape[0] > 0:
        storeys = room.storeys
        # at the start as they were observed at the end of the step before
        note_rate(lin, slab[0], storeys[1], rates[0])
        observe(lin, room.half, z, storeys)
        note_rate(lin, slab[1], storeys[0], rates[1])
        note_rate(lin, slab[2], storeys[1], rates[2])
        tallies[DAMPED] += taken_over(rates, length)


@kernel
def _add_works(room: Work, length: float, changes: bool, tallies: NDArray[np.float64]) -> None:
    """Add up what the ground puts in, and what the forces of friction and of the change of load take."""
    drive, sums = room.drive, room.sums
    for j in range(2):
        travel, area = sums[0, 3 + j], sums[1, 3 + j]
        of_rate = drive[0, GROUND + 2 + j] * (length * travel - area)
        tallies[INPUT] -= drive[0, GROUND + j] * travel + of_rate
    for j in range(3):
        tallies[HYSTERETIC] += work(sums, length, drive[1], j, 3, j)
        if changes:
            tallies[LIFTING] += work(sums, length, drive[2], j, 3, j)


@kernel
def _note_peaks(plan: Plan, room: Work, tallies: NDArray[np.float64]) -> None:
    """Find the largest displacements, rotation and base shear, also inside the step."""
    motion, forces, carried = room.motion, room.forces, room.carried
    for p in range(plan.watched.shape[0]):
        arm = complex(plan.watched[p, 0], plan.watched[p, 1])
        plan.watched[p, 2] = furthest(
            plan.watched[p, 2], at(motion[START], DISPLACEMENT, arm), at(motion[MIDDLE], DISPLACEMENT, arm), at(motion[END], DISPLACEMENT, arm)
        )  # fmt: skip
    start, middle, end = motion[START, 2], motion[MIDDLE, 2], motion[END, 2]
    tallies[ROTATION] = highest(highest(tallies[ROTATION], start, middle, end), -start, -middle, -end)
    x0, y0, _, _ = shear_and_tipping(plan, motion[START], carried[0], carried[3])
    xm, ym, _, _ = shear_and_tipping(plan, motion[MIDDLE], forces[FRICTION_MIDDLE], forces[LIFTING_MIDDLE])
    x1, y1, _, _ = shear_and_tipping(plan, motion[END], forces[FRICTION_END], forces[LIFTING_END])
    tallies[SHEAR] = furthest(tallies[SHEAR], complex(x0, y0), complex(xm, ym), complex(x1, y1))


@kernel
def _carry_on(room: Work, length: float) -> None:
    """Leave motion and forces at the end of the step, with how the forces change there."""
    carried, forces = room.carried, room.forces
    over = 1.0 / length
    for kind in range(2):
        for j in range(FORCE_COLUMNS):
            start, middle, end = carried[3 * kind, j], forces[2 * kind, j], forces[2 * kind + 1, j]
            bend = 2.0 * over * over * (start - 2.0 * middle + end)
            carried[3 * kind, j] = end
            carried[3 * kind + 1, j] = over * (4.0 * middle - 3.0 * start - end) + 2.0 * length * bend
            carried[3 * kind + 2, j] = bend
    for j in range(OUTPUTS):
        room.motion[START, j] = room.motion[END, j]

"""The virtual test machine: sticking and sliding along a prescribed path, from event to event.

Friction is the same elastic-plastic spring (b) as in the response analysis: it sticks while the spring is inside the yield surface,
and slides while the centre of that surface is dragged along. Here the motion is known, so only the coefficient, the heat and the
work have to follow it.
"""

import math

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel
from dcfp.kernels.driven_sliding import slide_driven
from dcfp.kernels.driven_sticking import stick_driven
from dcfp.kernels.grip import Grip, Rig
from dcfp.kernels.heat_state import PRESENT, Heat
from dcfp.kernels.law import Law
from dcfp.kernels.motion import Structure
from dcfp.kernels.path import Piece, displacement_at, load_at, velocity_at

# how a drive can end
DONE, OUT_OF_CELLS, NO_PROGRESS, NO_NUMBER = range(4)

# columns of the histories; temperatures of the plates follow
DISPLACEMENT, VELOCITY, ELONGATION, FRICTION, SIDE, LOAD, WORK, HYSTERETIC, TEMPERATURE = range(9)

# entries of the state that a drive starts from and leaves behind
(
    STATE_ELONGATION,
    STATE_SIDE,
    STATE_LEVEL,
    STATE_FRESH,
    STATE_TIME,
    STATE_WORK,
    STATE_HYSTERETIC,
    STATE_STEPS,
    STATE_SIZE,
) = range(9)

_MOST_STEPS_PER_PIECE = 20_000


@kernel
def drive(
    law: Law,
    structure: Structure,
    rig: Rig,
    heat: Heat,
    lengths: NDArray[np.float64],
    pieces: NDArray[np.float64],
    tolerance: float,
    state: NDArray[np.float64],
    histories: NDArray[np.float64],
) -> tuple[int, int]:
    """Follow the path; return how it ended and the pieces done.

    A row of `pieces` holds the fields of a `Piece`, `lengths` how long each lasts [s]. `state` and `heat` are where it starts from,
    and are left where it ends. Row i + 1 of `histories` is written at the end of piece i.
    """
    grip = Grip(state[STATE_ELONGATION], int(state[STATE_SIDE]), histories[0, FRICTION])
    level = int(state[STATE_LEVEL])
    fresh = state[STATE_FRESH] > 0.0
    work, hysteretic = state[STATE_WORK], state[STATE_HYSTERETIC]
    clock = state[STATE_TIME]
    for i in range(lengths.size):
        row = pieces[i]
        piece = Piece(row[0], row[1], row[2], row[3], row[4], row[5], row[6], row[7])
        interval = lengths[i]
        now = 0.0
        steps = 0
        while now < interval:
            room = interval - now
            if grip.side == 0:
                stroke = stick_driven(law, structure, rig, heat, piece, grip, now, room, interval)
                fresh = stroke.grip.side != 0
            else:
                stroke, level = slide_driven(
                    law,
                    structure,
                    rig,
                    heat,
                    piece,
                    grip,
                    clock,
                    now,
                    room,
                    interval,
                    level,
                    fresh,
                    tolerance,
                )
                fresh = fresh and stroke.length == 0.0
            grip = stroke.grip
            work += stroke.work
            hysteretic += stroke.hysteretic
            # rounding must not leave a sliver, in which the travel is noise
            now = interval if room - stroke.length <= 1e-12 * interval else now + stroke.length
            steps += 1
            if not stroke.fits:
                return OUT_OF_CELLS, i
            if not math.isfinite(grip.friction):  # the law may answer so
                return NO_NUMBER, i
            if steps > _MOST_STEPS_PER_PIECE:
                return NO_PROGRESS, i
        clock += interval
        state[STATE_STEPS] += steps
        line = histories[i + 1]
        line[DISPLACEMENT] = displacement_at(piece, interval)
        line[VELOCITY] = velocity_at(piece, interval)
        line[ELONGATION] = grip.elongation
        line[FRICTION] = grip.friction
        line[SIDE] = grip.side
        line[LOAD] = load_at(piece, interval)
        line[WORK] = work
        line[HYSTERETIC] = hysteretic
        for j in range(structure.plates):
            line[TEMPERATURE + j] = heat.notes[PRESENT + j]
    state[STATE_ELONGATION] = grip.elongation
    state[STATE_SIDE] = grip.side
    state[STATE_LEVEL] = level
    state[STATE_FRESH] = 1.0 if fresh else 0.0
    state[STATE_TIME] = clock
    state[STATE_WORK] = work
    state[STATE_HYSTERETIC] = hysteretic
    return DONE, lengths.size

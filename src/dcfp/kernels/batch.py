"""Many analyses in one call: each lane is one record at one scale on one model, from rest to rest."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel
from dcfp.kernels.friction import mean_coefficient
from dcfp.kernels.heat_state import DOSE, LEFT_CELL, PLATE_NOTE, PLATE_NOTES, PRESENT, RATES, WEIGHTS, Heat
from dcfp.kernels.law import Law
from dcfp.kernels.march import (
    LEAST_FRICTION,
    PEAK_CHANGE,
    PEAK_DISPLACEMENT,
    PEAK_FORCE,
    PEAK_TEMPERATURE,
    PEAK_VELOCITY,
    STATE_DISPLACEMENT,
    STATE_ELONGATION,
    STATE_HYSTERETIC,
    STATE_INPUT,
    STEPS,
    march,
)
from dcfp.kernels.motion import Structure

# columns of the table of models
(
    FORM,
    REFERENCE,
    SPEED_DROP,
    SPEED_RATE,
    HEAT_SCALE,
    HEAT_RATE,
    HEAT_FLOOR,
    RESTORING,
    ELASTIC,
    GRAVITY,
    PRESSURE,
    REACH,
    FIRST_SHARE,
    SECOND_SHARE,
    FIRST_SPEED,
    SECOND_SPEED,
    AMBIENT,
    HALF_CONTACT,
    CELL,
    INSTANT,
    BANK,  # which of the banks of modes
    MODEL_SIZE,
) = range(22)

# columns of the lanes
LANE_RECORD, LANE_MODEL, LANE_SIZE = range(3)

# columns of the outcome, per unit mass where a mass is in it
(
    OUT_DISPLACEMENT,
    OUT_CHANGE,
    OUT_VELOCITY,
    OUT_FORCE,
    OUT_TEMPERATURE,
    OUT_FRICTION,
    OUT_INPUT,
    OUT_HYSTERETIC,
    OUT_LAST_DISPLACEMENT,
    OUT_LAST_ELONGATION,
    OUT_STEPS,
    OUT_ENDED,  # as `dcfp.kernels.march` numbers it
    OUT_RESTS,
    OUT_SIZE,
) = range(14)


class Ground(NamedTuple):
    """Records one after the other, and how to step through each."""

    acceleration: NDArray[np.float64]  # of all records, unscaled [mm/s2]
    first: NDArray[np.intp]  # where each begins
    samples: NDArray[np.intp]
    rest: NDArray[np.intp]  # samples of no acceleration after it
    free_from: NDArray[np.intp]  # sample from which the march may stop
    interval: NDArray[np.float64]  # [s]
    coarsest: NDArray[np.intp]  # halvings of the interval


class Workspace(NamedTuple):
    """Arrays that the lanes of one call use one after the other."""

    acceleration: NDArray[np.float64]  # as long as the longest record with its rest
    state: NDArray[np.float64]
    histories: NDArray[np.float64]  # no rows: nothing is recorded


@kernel
def march_lanes(
    heat: Heat,
    plates: int,
    middle: int,
    models: NDArray[np.float64],
    banks: NDArray[np.float64],
    resting_state: NDArray[np.float64],
    resting_notes: NDArray[np.float64],
    ground: Ground,
    lanes: NDArray[np.intp],
    scales: NDArray[np.float64],
    tolerance: float,
    work: Workspace,
    outcome: NDArray[np.float64],
) -> None:
    """Run every lane and write its row of `outcome`.

    `law` and `heat` give the kind of law and of heating, and the arrays that are worked in; their numbers come from the
    row of `models`. `plates` differ, and the contact begins at cell `middle`. Rates and weights of the modes stand in `banks`,
    shape (banks, 2, modes).
    """
    filled_record, filled_scale, filled = -1, math.nan, 0
    for lane in range(lanes.shape[0]):
        record, model = int(lanes[lane, LANE_RECORD]), models[int(lanes[lane, LANE_MODEL])]
        samples = ground.samples[record]
        if record != filled_record or scales[lane] != filled_scale:
            fill_ground(ground, record, scales[lane], filled, work.acceleration)
            filled_record, filled_scale, filled = record, scales[lane], samples
        structure = structure_from(model, plates)
        warm = heat_from(heat, model)
        cool_to(warm, banks[int(model[BANK])], resting_notes, plates, middle)
        copy_into(work.state, resting_state)
        work.state[PEAK_TEMPERATURE] = warm.ambient
        own = Law(
            int(model[FORM]),
            model[REFERENCE],
            model[SPEED_DROP],
            model[SPEED_RATE],
            model[HEAT_SCALE],
            model[HEAT_RATE],
            model[HEAT_FLOOR],
        )
        first = mean_coefficient(own, structure, 0.0, warm.notes, PRESENT)
        status, _, rests = march(
            own,
            structure,
            warm,
            work.acceleration[: samples + ground.rest[record]],
            ground.interval[record],
            ground.coarsest[record],
            ground.free_from[record],
            tolerance,
            work.state,
            work.histories,
        )
        write_outcome(work.state, first, status, rests, outcome[lane])


@kernel
def fill_ground(
    ground: Ground, record: int, scale: float, filled: int, acceleration: NDArray[np.float64]
) -> None:
    """Write the scaled record into `acceleration`, whose first `filled` values are those of another."""
    begin, samples = ground.first[record], ground.samples[record]
    for i in range(samples):
        acceleration[i] = ground.acceleration[begin + i] * scale
    for i in range(samples, filled):
        acceleration[i] = 0.0


@kernel
def structure_from(model: NDArray[np.float64], plates: int) -> Structure:
    """Return the structure of a row of the table of models."""
    return Structure(
        model[RESTORING],
        model[ELASTIC],
        model[GRAVITY],
        model[PRESSURE],
        model[REACH],
        plates,
        model[FIRST_SHARE],
        model[SECOND_SHARE],
        model[FIRST_SPEED],
        model[SECOND_SPEED],
    )


@kernel
def heat_from(heat: Heat, model: NDArray[np.float64]) -> Heat:
    """Return `heat` with the constants of a row of the table of models."""
    return Heat(
        heat.kind,
        model[AMBIENT],
        model[HALF_CONTACT],
        model[CELL],
        model[INSTANT],
        heat.bank,
        heat.notes,
        heat.cells,
    )


@kernel
def cool_to(
    heat: Heat, modes: NDArray[np.float64], resting_notes: NDArray[np.float64], plates: int, middle: int
) -> None:
    """Forget all heat: the plates are at the ambient temperature, and the slider is in the middle."""
    heat.bank[:] = 0.0
    heat.cells[:] = 0.0
    for mode in range(modes.shape[1]):
        heat.bank[RATES, mode], heat.bank[WEIGHTS, mode] = modes[0, mode], modes[1, mode]
    copy_into(heat.notes, resting_notes)
    heat.notes[PRESENT:DOSE] = heat.ambient
    for plate in range(plates):
        heat.notes[PLATE_NOTE + plate * PLATE_NOTES + LEFT_CELL] = middle


@kernel
def copy_into(values: NDArray[np.float64], others: NDArray[np.float64]) -> None:
    """Copy one array into another: a kernel has no means to do so in a slice."""
    for i in range(values.size):
        values[i] = others[i]


@kernel
def write_outcome(
    state: NDArray[np.float64], first: float, status: int, rests: bool, row: NDArray[np.float64]
) -> None:
    """Write what the march left behind; `first` is the coefficient at the start, for a lane that never slides."""
    row[OUT_DISPLACEMENT] = state[PEAK_DISPLACEMENT]
    row[OUT_CHANGE] = state[PEAK_CHANGE]
    row[OUT_VELOCITY] = state[PEAK_VELOCITY]
    row[OUT_FORCE] = state[PEAK_FORCE]
    row[OUT_TEMPERATURE] = state[PEAK_TEMPERATURE]
    row[OUT_FRICTION] = state[LEAST_FRICTION] if math.isfinite(state[LEAST_FRICTION]) else first
    row[OUT_INPUT] = state[STATE_INPUT]
    row[OUT_HYSTERETIC] = state[STATE_HYSTERETIC]
    row[OUT_LAST_DISPLACEMENT] = state[STATE_DISPLACEMENT]
    row[OUT_LAST_ELONGATION] = state[STATE_ELONGATION]
    row[OUT_STEPS] = state[STEPS]
    row[OUT_ENDED] = status
    row[OUT_RESTS] = 1.0 if rests else 0.0

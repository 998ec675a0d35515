"""Many analyses in one call: each run is one record at one scale on one system, from rest to rest."""

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import Records, fields_of, kernel, record_type
from dcfp.kernels.friction import BearingModel, mean_coefficient
from dcfp.kernels.heat_state import (
    CYCLING_PARAMETER,
    LEFT_CELL,
    PLATE_ENTRIES,
    PLATE_ENTRY,
    PRESENT,
    RATES,
    WEIGHTS,
    Heat,
)
from dcfp.kernels.integrate import integrate
from dcfp.kernels.law import Law
from dcfp.kernels.motion import StepControl, SystemConstants


class BatchSystem(NamedTuple):
    """A system of a batch."""

    law: Law
    system: SystemConstants
    heat: Heat  # its numbers
    modes: int  # which of the sets of rates and weights


class BatchRecord(NamedTuple):
    """Where a record stands among all, and how to step through it."""

    first: int
    samples: int
    rest: int  # samples of no acceleration after it
    free_from: int  # sample from which the integration may stop
    interval: float  # [s]
    fewest_halvings: int  # of the interval


class BatchRun(NamedTuple):
    """One analysis."""

    record: int
    system: int
    scale: float


# a type checker does not know how many numbers a record has
_heat: Any = Heat
#: Their records.
BATCH_SYSTEM, BATCH_RECORD, BATCH_RUN = map(record_type, (BatchSystem, BatchRecord, BatchRun))


@kernel
def run_batch(
    heat: Heat,
    middle: int,
    systems: Records,
    mode_sets: NDArray[np.float64],
    cold_workspace: NDArray[np.float64],
    accelerations: NDArray[np.float64],
    records: Records,
    runs: Records,
    tolerance: float,
    scaled: NDArray[np.float64],
    histories: NDArray[np.float64],
    states: Records,
) -> None:
    """Make every run from its row of `states`, which is at rest, and leave there what the integration leaves.

    `heat` gives the kind of heating and the arrays that are worked in; its numbers come from the row of `systems`. The contact begins at
    cell `middle`. Rates and weights of the modes stand in `mode_sets`, shape (sets, 2, modes). `scaled` has room for the longest
    record with its rest, and `histories` has no rows: nothing is recorded.
    """
    last_record, last_scale, filled = -1, math.nan, 0
    for i in range(runs.shape[0]):
        run = runs[i]
        record, constants = records[run["record"]], systems[run["system"]]
        if run["record"] != last_record or run["scale"] != last_scale:
            _fill(accelerations[record["first"] :], record["samples"], run["scale"], filled, scaled)
            last_record, last_scale, filled = run["record"], run["scale"], record["samples"]
        law, system = Law(*fields_of(constants["law"])), SystemConstants(*fields_of(constants["system"]))
        warm = _heat(*fields_of(constants["heat"]), heat.modes, heat.workspace, heat.cells)
        _cool_to(warm, mode_sets[constants["modes"]], cold_workspace, system.plates, middle)
        model = BearingModel(law, system, warm)
        first = mean_coefficient(model, 0.0, PRESENT)
        control = StepControl(record["interval"], record["fewest_halvings"], tolerance)
        acceleration = scaled[: record["samples"] + record["rest"]]
        integrate(model, acceleration, control, record["free_from"], states, i, histories, False)
        extremes = states[i]["extremes"]
        if math.isinf(extremes["friction"]):  # it has never slid
            extremes["friction"] = first


@kernel
def _fill(
    acceleration: NDArray[np.float64], samples: int, scale: float, filled: int, scaled: NDArray[np.float64]
) -> None:
    """Write a scaled record into `scaled`, whose first `filled` values are those of another."""
    for i in range(samples):
        scaled[i] = acceleration[i] * scale
    for i in range(samples, filled):
        scaled[i] = 0.0


@kernel
def _cool_to(
    heat: Heat, modes: NDArray[np.float64], cold_workspace: NDArray[np.float64], plates: int, middle: int
) -> None:
    """Forget all heat: the plates are at the ambient temperature, and the slider is in the middle."""
    heat.modes[:] = 0.0
    heat.cells[:] = 0.0
    for mode in range(modes.shape[1]):
        heat.modes[RATES, mode], heat.modes[WEIGHTS, mode] = modes[0, mode], modes[1, mode]
    for i in range(cold_workspace.size):  # a kernel cannot copy a slice
        heat.workspace[i] = cold_workspace[i]
    heat.workspace[PRESENT:CYCLING_PARAMETER] = heat.ambient
    for plate in range(plates):
        heat.workspace[PLATE_ENTRY + plate * PLATE_ENTRIES + LEFT_CELL] = middle

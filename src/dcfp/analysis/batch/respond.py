"""The batch: lanes sorted into families, each in one call of the kernel, and what it gives for each lane."""

import os
from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from dcfp.analysis.batch.lanes import Family, GroundSet, Lanes, families_of
from dcfp.analysis.kernel_input import tallies_at
from dcfp.analysis.response import FAILED, NUMBERS, Status
from dcfp.arrays import FloatArray, IntArray
from dcfp.kernels import batch as k
from dcfp.kernels.batch import LANE_MODEL, LANE_RECORD, LANE_SIZE, OUT_ENDED, OUT_SIZE, Workspace, march_lanes
from dcfp.kernels.march import AT_REST, DONE, OUT_OF_CELLS, STATE_SIZE, TEMPERATURE
from dcfp.system import Bearing
from dcfp.system.plates import cold_notes

# What a batch gives for each lane.


@dataclass(frozen=True, eq=False)
class Peaks:
    """Peaks and energies of each lane, shape (lanes,); what they are, `dcfp.Response` says.

    Attributes
    ----------
    peak_displacement, peak_change, residual_displacement
        [mm].
    peak_velocity, input_velocity, hysteretic_velocity
        [mm/s].
    peak_force
        [N].
    force_ratio
        Largest force over the weight [-].
    peak_temperature
        [degC].
    least_friction
        [-].
    status
        As `dcfp.analysis.response.NUMBERS` counts; where it is `FAILED` all else is not a number.
    """

    peak_displacement: FloatArray
    peak_change: FloatArray
    peak_velocity: FloatArray
    peak_force: FloatArray
    force_ratio: FloatArray
    peak_temperature: FloatArray
    least_friction: FloatArray
    residual_displacement: FloatArray
    input_velocity: FloatArray
    hysteretic_velocity: FloatArray
    status: NDArray[np.uint8]

    @classmethod
    def of(cls, outcome: FloatArray, lanes: Lanes) -> "Peaks":
        """Read the outcome of the kernel."""
        bearings = [model.bearing for model in lanes.models]
        mass, weight, elastic, restoring, capacity = _constants(bearings)[:, lanes.model]
        force = outcome[:, k.OUT_FORCE] * mass
        stuck = outcome[:, k.OUT_LAST_DISPLACEMENT] - outcome[:, k.OUT_LAST_ELONGATION]
        values = {
            "peak_displacement": outcome[:, k.OUT_DISPLACEMENT],
            "peak_change": outcome[:, k.OUT_CHANGE],
            "peak_velocity": outcome[:, k.OUT_VELOCITY],
            "peak_force": force,
            "force_ratio": force / weight,
            "peak_temperature": outcome[:, k.OUT_TEMPERATURE],
            "least_friction": outcome[:, k.OUT_FRICTION],
            "residual_displacement": stuck * elastic / (elastic + restoring),
            "input_velocity": _equivalent_velocity(outcome[:, k.OUT_INPUT], mass),
            "hysteretic_velocity": _equivalent_velocity(outcome[:, k.OUT_HYSTERETIC], mass),
        }
        finished = np.isin(outcome[:, k.OUT_ENDED], (DONE, AT_REST))
        failed = ~(finished & np.isfinite(outcome).all(axis=1))
        status = np.where(outcome[:, k.OUT_RESTS] > 0.0, NUMBERS[Status.OK], NUMBERS[Status.STILL_MOVING])
        status[outcome[:, k.OUT_DISPLACEMENT] > capacity] = NUMBERS[Status.BEYOND_CAPACITY]
        status[failed] = FAILED
        whole = {name: np.where(failed, np.nan, one) for name, one in values.items()}
        return cls(**whole, status=status.astype(np.uint8))

    def arrays(self) -> dict[str, NDArray[np.float64] | NDArray[np.uint8]]:
        """Return the arrays by name."""
        return {item.name: getattr(self, item.name) for item in fields(self)}


def _constants(bearings: Sequence[Bearing]) -> FloatArray:
    """Return mass [t], weight [N], both stiffnesses [N/mm] and the capacity [mm] of bearings, a column for each."""
    rows = [
        (
            one.mass,
            one.vertical_force,
            one.elastic_stiffness,
            one.restoring_stiffness,
            np.inf if one.displacement_capacity is None else one.displacement_capacity,
        )
        for one in bearings
    ]
    return np.array(rows, dtype=np.float64).T


def _equivalent_velocity(energy: FloatArray, mass: FloatArray) -> FloatArray:
    """Return V_E [mm/s] of energies per mass [mm2/s2]; the mass [t] is put in and taken out as `Response` does, so that the last digit is the same."""
    return np.sqrt(np.maximum(2.0 * (energy * mass) / mass, 0.0))


#: Cells that a plate may be widened to before a lane is given up.
_MOST_CELLS = 1_000_000


def respond_in_batch(grounds: GroundSet, lanes: Lanes) -> Peaks:
    """Analyse every lane on the calling thread; the interpreter's lock is free meanwhile.

    The numbers of a lane are those of `dcfp.respond` for its record, scale and model, and do not depend on what else is in the
    batch.

    Parameters
    ----------
    grounds
        The records.
    lanes
        What is analysed; lanes of the same record and scale are best side by side.
    """
    outcome = np.full((len(lanes), OUT_SIZE), np.nan)
    for family in families_of(lanes.models):
        rows = np.full(len(lanes.models), -1, dtype=np.intp)
        rows[family.members] = np.arange(len(family.members))
        row = rows[lanes.model]
        chosen = np.flatnonzero(row >= 0)
        _march_family(grounds, lanes, family, chosen, row, outcome)
    return Peaks.of(outcome, lanes)


def available_threads() -> int:
    """Return the number of processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _march_family(
    grounds: GroundSet,
    lanes: Lanes,
    family: Family,
    chosen: IntArray,
    row: IntArray,
    outcome: FloatArray,
) -> None:
    """March through the lanes numbered in `chosen`, again on wider plates for those whose slider left them."""
    work = Workspace(
        acceleration=np.zeros(grounds.longest),
        state=np.zeros(STATE_SIZE),
        histories=np.empty((0, TEMPERATURE + family.plates)),
    )
    margin = family.margin
    while chosen.size:
        which = np.empty((chosen.size, LANE_SIZE), dtype=np.intp)
        which[:, LANE_RECORD], which[:, LANE_MODEL] = lanes.record[chosen], row[chosen]
        part = np.empty((chosen.size, OUT_SIZE))
        work.acceleration[:] = 0.0
        march_lanes(
            family.heat(margin),
            family.plates,
            margin,
            family.table,
            family.banks,
            tallies_at(0.0),
            cold_notes(0.0),
            grounds.ground,
            which,
            lanes.scale[chosen],
            grounds.integration.tolerance,
            work,
            part,
        )
        outcome[chosen] = part
        margin = 2 * margin + 1
        if margin > _MOST_CELLS:
            return
        chosen = chosen[part[:, OUT_ENDED] == OUT_OF_CELLS]

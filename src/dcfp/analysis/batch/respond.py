"""The batch: lanes sorted into families, each in one call of the kernel, and what it gives for each lane."""

import os
from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from dcfp.analysis.batch.lanes import Family, GroundSet, Lanes, families_of
from dcfp.analysis.kernel_input import states_at_rest
from dcfp.analysis.response import FAILED, NUMBERS, Status
from dcfp.arrays import FloatArray, IntArray
from dcfp.kernels._jit import Records, as_bytes
from dcfp.kernels.batch import BATCH_RUN, run_batch
from dcfp.kernels.integrate import TEMPERATURE
from dcfp.kernels.motion import AT_REST, DONE, OUT_OF_CELLS
from dcfp.system import Bearing
from dcfp.system.plates import cold_workspace

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
    def of(cls, states: Records, lanes: Lanes) -> "Peaks":
        """Read the states that the kernel left."""
        bearings = [model.bearing for model in lanes.models]
        mass, weight, elastic, restoring, capacity = _constants(bearings)[:, lanes.model]
        extremes = states["extremes"]
        force = extremes["force"] * mass
        stuck = states["motion"]["displacement"] - states["spring"]["elongation"]
        values = {
            "peak_displacement": extremes["displacement"],
            "peak_change": extremes["change"],
            "peak_velocity": extremes["velocity"],
            "peak_force": force,
            "force_ratio": force / weight,
            "peak_temperature": extremes["temperature"],
            "least_friction": extremes["friction"],
            "residual_displacement": stuck * elastic / (elastic + restoring),
            "input_velocity": _equivalent_velocity(extremes["input"], mass),
            "hysteretic_velocity": _equivalent_velocity(extremes["hysteretic"], mass),
        }
        failed = ~np.isin(states["status"], (DONE, AT_REST))
        status = np.where(states["at_rest"], NUMBERS[Status.OK], NUMBERS[Status.STILL_MOVING])
        status[extremes["displacement"] > capacity] = NUMBERS[Status.BEYOND_CAPACITY]
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
    ambient = np.array([model.heating.ambient for model in lanes.models])
    states = states_at_rest(len(lanes), 0.0)
    states["extremes"]["temperature"] = ambient[lanes.model]
    for family in families_of(lanes.models):
        rows = np.full(len(lanes.models), -1, dtype=np.intp)
        rows[family.members] = np.arange(len(family.members))
        row = rows[lanes.model]
        chosen = np.flatnonzero(row >= 0)
        _run_family(grounds, lanes, family, chosen, row, states)
    return Peaks.of(states, lanes)


def available_threads() -> int:
    """Return the number of processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _run_family(
    grounds: GroundSet,
    lanes: Lanes,
    family: Family,
    chosen: IntArray,
    row: IntArray,
    states: Records,
) -> None:
    """Make the runs numbered in `chosen` from their states at rest, again on wider plates for those whose slider left them."""
    histories = np.empty((0, TEMPERATURE + family.plates))
    margin = family.margin
    while chosen.size:
        runs = np.zeros(chosen.size, BATCH_RUN)
        runs["record"], runs["system"] = lanes.record[chosen], row[chosen]
        runs["scale"] = lanes.scale[chosen]
        left = as_bytes(states)[chosen].view(states.dtype)
        run_batch(
            family.heat(margin),
            margin,
            family.systems,
            family.mode_sets,
            cold_workspace(0.0),
            grounds.acceleration,
            grounds.records,
            runs,
            grounds.integration.tolerance,
            np.zeros(grounds.longest),
            histories,
            left,
        )
        margin = 2 * margin + 1
        again = (left["status"] == OUT_OF_CELLS) & (margin <= _MOST_CELLS)
        as_bytes(states)[chosen[~again]] = as_bytes(left)[~again]
        chosen = chosen[again]

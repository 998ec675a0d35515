"""Many response history analyses without histories: lanes, those of models that are alike in one call of the kernel."""

import os
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from dcfp.analysis.integration import DEFAULT, Integration, halvings
from dcfp.analysis.lanes import Lanes as Lanes
from dcfp.analysis.plane_batch import StationSet, respond_to_stations
from dcfp.analysis.response import FAILED, NUMBERS, Status, states_at_rest
from dcfp.arrays import FloatArray
from dcfp.kernels._jit import Records, as_bytes
from dcfp.kernels.heat_state import MODE_ROWS, Heat
from dcfp.kernels.integrate import BATCH_RECORD, BATCH_RUN, BATCH_SYSTEM, TEMPERATURE, run_batch
from dcfp.kernels.motion import AT_REST, DONE, OUT_OF_CELLS
from dcfp.kernels.sum_of_exponentials import MODES
from dcfp.motion.ground_motion import LONGEST_TAIL, GroundMotion, parts_in, refined
from dcfp.motion.station import Station, stations_of
from dcfp.system import System
from dcfp.system.plates import (
    cell_width,
    cells_across,
    cold_workspace,
    margin_for,
    modes_of,
    no_heat,
    system_constants,
)


@dataclass(frozen=True, eq=False)
class GroundSet:
    """Records one after the other [mm/s2], unscaled, and how each is stepped through: `dcfp.kernels.integrate.BatchRecord`."""

    acceleration: FloatArray
    records: Records
    integration: Integration

    @classmethod
    def of(
        cls,
        motions: Sequence[GroundMotion | Station],
        integration: Integration = DEFAULT,
        *,
        vertical: bool = False,
    ) -> "GroundSet | StationSet":
        """Put records side by side, to be analysed as finely and as far as `integration` says; stations become a `StationSet`, which may be `vertical`.

        Raises
        ------
        InputError
            If some are stations and others single components, or a station lacks the vertical component where it is needed.
        """
        if stations := stations_of(motions):
            return StationSet(stations, integration, vertical)
        tail, step = integration.tail, integration.step
        records = np.zeros(len(motions), BATCH_RECORD)
        accelerations: list[FloatArray] = []
        for i, motion in enumerate(one for one in motions if isinstance(one, GroundMotion)):
            parts = 1 if step is None else parts_in(motion.time_step, step)
            # what `dcfp.respond` makes of a record, but the zeros after it as their number alone
            after = round((LONGEST_TAIL if tail is None else tail) / motion.time_step)
            total = (motion.acceleration.size + after - 1) * parts + 1
            acceleration = refined(
                np.append(motion.acceleration, 0.0) if after else motion.acceleration, parts
            )
            interval = motion.time_step / parts
            free_from = motion.acceleration.size * parts if tail is None else total
            first = sum(one.size for one in accelerations)
            rest = total - acceleration.size
            records[i] = (first, acceleration.size, rest, free_from, interval, halvings(interval))
            accelerations.append(acceleration)
        return cls(np.concatenate(accelerations), records, integration)

    @property
    def longest(self) -> int:
        """Samples of the longest record with the rest after it."""
        return int((self.records["samples"] + self.records["rest"]).max())

    @property
    def steps(self) -> "np.ndarray[tuple[int], np.dtype[np.int64]]":
        """Samples of each record, a measure of what an analysis under it costs."""
        return self.records["samples"]


def _tables(members: Sequence[System]) -> tuple[Records, FloatArray]:
    """Return systems as `dcfp.kernels.integrate.BatchSystem`, and the rates and weights of their modes, shape (sets, 2, modes)."""
    places: dict[bytes, int] = {}
    mode_sets: list[FloatArray] = []
    systems = np.zeros(len(members), BATCH_SYSTEM)
    for row, member in zip(systems, members, strict=True):
        bearing, heating = member.bearing, member.heating
        rates, weights, instant = modes_of(heating)
        modes = np.array([rates, weights * heating.rise_factor])
        place = places.setdefault(modes.tobytes(), len(mode_sets))
        if place == len(mode_sets):
            mode_sets.append(modes)
        row["law"] = member.friction.at_pressure(bearing.pressure)
        row["system"] = system_constants(member)
        half_side, width = bearing.contact_half_side, cell_width(member)
        row["heat"] = (heating.kind, heating.ambient, half_side, width, instant * heating.rise_factor)
        row["modes"] = place
    return systems, np.array(mode_sets)


def _peaks_of(states: Records, lanes: Lanes) -> dict[str, NDArray[np.float64] | NDArray[np.uint8]]:
    bearings = [model.bearing for model in lanes.models]
    names = ("mass", "vertical_force", "elastic_stiffness", "restoring_stiffness", "displacement_capacity")
    # an unknown capacity is never exceeded, not a number being above nothing
    known = np.array([[getattr(one, name) for one in bearings] for name in names], dtype=np.float64)
    mass, weight, elastic, restoring, capacity = known[:, lanes.model]
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
    return {**whole, "status": status.astype(np.uint8)}


def _equivalent_velocity(energy: FloatArray, mass: FloatArray) -> FloatArray:
    """Return V_E [mm/s] of energies per mass [mm2/s2]; the mass [t] is put in and taken out as `Response` does, so that the last digit is the same."""
    return np.sqrt(np.maximum(2.0 * (energy * mass) / mass, 0.0))


def respond_in_batch(
    grounds: GroundSet | StationSet, lanes: Lanes
) -> dict[str, NDArray[np.float64] | NDArray[np.uint8]]:
    """Analyse every lane on the calling thread; the interpreter's lock is free meanwhile.

    The numbers of a lane are those of `dcfp.respond` for its record, scale and model, and do not depend on what else is in the
    batch. Lanes of the same record and scale are best side by side.

    Parameters
    ----------
    grounds
        The records, or stations.
    lanes
        What is analysed; lanes of the same record and scale are best side by side.

    Returns
    -------
    dict
        Peaks and energies of each lane by the names of a `dcfp.Response` or `PlaneResponse`, shape (lanes,). ``status`` counts as
        `dcfp.analysis.response.NUMBERS`; where it is `FAILED` all else is not a number.
    """
    if isinstance(grounds, StationSet):
        return respond_to_stations(grounds, lanes)
    ambient = np.array([model.heating.ambient for model in lanes.models])
    states = states_at_rest(len(lanes), 0.0)
    states["extremes"]["temperature"] = ambient[lanes.model]
    alike: dict[tuple[int, int, int], list[int]] = {}
    for number, model in enumerate(lanes.models):
        kind = model.heating.kind, len(set(model.bearing.radii)), cells_across(model.heating)
        alike.setdefault(kind, []).append(number)
    for numbers in alike.values():
        _run_alike(grounds, lanes, numbers, states)
    return _peaks_of(states, lanes)


def available_threads() -> int:
    """Return the number of processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


#: Cells that a plate may be widened to before a lane is given up.
_MOST_CELLS = 1_000_000


def _run_alike(grounds: GroundSet, lanes: Lanes, numbers: list[int], states: Records) -> None:
    """Run the lanes of models that are alike from their states at rest, again on wider plates for those whose slider left them."""
    members = [lanes.models[number] for number in numbers]
    heating, plates = members[0].heating, len(set(members[0].bearing.radii))
    systems, mode_sets = _tables(members)
    margin = max(margin_for(one) for one in members)
    rows = np.full(len(lanes.models), -1, dtype=np.intp)
    rows[numbers] = np.arange(len(numbers))
    row = rows[lanes.model]
    chosen = np.flatnonzero(row >= 0)
    while chosen.size:
        # arrays to work in; the numbers are those of the systems
        modes, cells = np.zeros((MODE_ROWS, MODES)), no_heat(plates, heating, margin)
        heat = Heat(heating.kind, 0.0, 0.0, 0.0, 0.0, modes, cold_workspace(0.0), cells)
        runs = np.zeros(chosen.size, BATCH_RUN)
        runs["record"], runs["system"] = lanes.record[chosen], row[chosen]
        runs["scale"] = lanes.scale[chosen]
        left = as_bytes(states)[chosen].view(states.dtype)
        run_batch(
            heat,
            margin,
            systems,
            mode_sets,
            cold_workspace(0.0),
            grounds.acceleration,
            grounds.records,
            runs,
            grounds.integration.tolerance,
            np.zeros(grounds.longest),
            np.empty((0, TEMPERATURE + plates)),
            left,
        )
        margin = 2 * margin + 1
        again = (left["status"] == OUT_OF_CELLS) & (margin <= _MOST_CELLS)
        as_bytes(states)[chosen[~again]] = as_bytes(left)[~again]
        chosen = chosen[again]

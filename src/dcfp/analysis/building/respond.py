"""Response history analysis of a shear building on a bearing."""

import time
from typing import NamedTuple

import numpy as np

from dcfp.analysis.building.response import BuildingResponse
from dcfp.analysis.building.shear_building import ShearBuilding
from dcfp.analysis.building.transition import building_of
from dcfp.analysis.integration import Integration
from dcfp.arrays import FloatArray, freeze, integral
from dcfp.kernels import building as k
from dcfp.motion.ground_motion import parts_in, with_tail
from dcfp.motion.load import Motion, motion_of
from dcfp.schema.parameters import refuse_other
from dcfp.system import FrictionLaw, Heating, System, SystemLike
from dcfp.system.plates import cold_plates, heat_of, system_constants

#: Longest fine step, unless another is asked for [s]; and over the shortest period on a fixed base [-], but for steps that are short already [s].
LONGEST_STEP, PERIOD_FRACTION, SHORT_STEP = 0.002, 0.1, 0.0002


class _Run(NamedTuple):
    """What one march left behind."""

    status: int
    done: int
    rests: bool
    state: FloatArray
    peaks: FloatArray
    elapsed: float


def respond_building(
    motion: Motion,
    building: ShearBuilding,
    bearing: SystemLike = None,
    friction: FrictionLaw | str | None = None,
    heating: Heating | str | None = None,
    *,
    pgv: float | None = None,
    step: float | None = None,
    tail: float | None = None,
) -> BuildingResponse:
    """Analyse a shear building on a bearing under a ground motion.

    Parameters
    ----------
    motion, bearing, friction, heating, pgv, tail
        As for `dcfp.respond`; without damping the analysis may well go on for all of 120 s. The vertical force is constant.
    building
        Its masses and stiffnesses are multiplied by one factor, so that the bearing carries the sum of the masses: `ShearBuilding.scaled_to`.
    step
        Longest fine step [s]; by default 0.002 s, or a tenth of the shortest period on a fixed base where that is less, down to 0.0002 s.

    Returns
    -------
    BuildingResponse
        Histories at the record's samples, peaks and energies.

    Raises
    ------
    InputError
        If an argument is out of range, or there is none of such a name.
    AnalysisError
        If the analysis cannot be finished.
    """
    motion = motion_of(motion, pgv)
    refuse_other(building, ShearBuilding, "building", "a ShearBuilding")
    system = System.of(bearing, friction, heating)
    bearing, friction, heating = system.bearing, system.friction, system.heating
    integration = Integration(step=step, tail=tail)
    longest = _longest_step(building) if integration.step is None else integration.step
    parts = parts_in(motion.time_step, longest)
    fine = motion.time_step / parts
    acceleration = with_tail(motion, tail)
    # from one sample of the record after its last, where the ground has stopped accelerating
    free_from = motion.acceleration.size if tail is None else acceleration.size
    own = building_of(building, bearing, fine)
    constants = system_constants(system)
    law = friction.at_pressure(bearing.pressure)
    lines = np.empty((acceleration.size, 2 * own.floors + k.LINE_SIZE + constants.plates))
    plates = cold_plates(system)

    def march(ground: FloatArray) -> _Run:
        own.vectors[:] = 0.0
        state, peaks = _at_rest(heating), np.zeros((2, own.floors))
        heat = heat_of(plates.copy(), system)
        began = time.perf_counter()
        ended = k.integrate_building(law, constants, heat, own, ground, parts, free_from, state, peaks, lines)
        return _Run(*ended, state, peaks, time.perf_counter() - began)

    march(np.zeros(2))  # has the kernels compiled or loaded, so that the time of an analysis is its own
    run = march(acceleration)
    while run.status == k.OUT_OF_CELLS:  # the slider left the line of cells
        plates = plates.with_room(plates.cells.shape[1])
        run = march(acceleration)
    lines = lines[: run.done + 1]
    if run.status == k.NO_PROGRESS:
        raise friction.no_progress(motion.name, run.done * motion.time_step)
    if not np.isfinite(lines).all():
        raise friction.no_number(motion.name)
    return BuildingResponse(
        motion=motion,
        system=system,
        building=building.scaled_to(bearing.mass),
        step=fine,
        time=freeze(np.arange(run.done + 1) * motion.time_step),
        ground_acceleration=freeze(acceleration[: run.done + 1]),
        ground_velocity=freeze(integral(acceleration[: run.done + 1], motion.time_step)),
        rests=run.rests,
        elapsed=run.elapsed,
        lines=freeze(lines),
        _peaks=freeze(run.peaks),
        _state=freeze(run.state),
        _resistance=own.resistance,
    )


def _longest_step(building: ShearBuilding) -> float:
    shortest = PERIOD_FRACTION * float(building.fixed_base_periods[-1])
    return min(LONGEST_STEP, max(SHORT_STEP, shortest))


def _at_rest(heating: Heating) -> FloatArray:
    state = np.zeros(k.STATE_SIZE)
    state[k.ROOM] = k.TICKS
    state[k.PEAK_TEMPERATURE] = heating.ambient
    return state

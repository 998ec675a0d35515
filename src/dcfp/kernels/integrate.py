"""The integrations: from sample to sample, from event to event within.

Friction is an elastic-plastic spring (b): it sticks while the spring is inside the yield surface, and slides while the centre of that surface is
dragged along. `integrate` responds to the ground; `impose_motion` is the virtual test machine, in which the motion is known, so that only the
coefficient, the heat and the work have to follow it. `run_batch` responds in many runs in one call: each is one record at one scale on
one system, from rest to rest.
"""

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import Records, called_kernel, fields_of, kernel, record_type, store
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
from dcfp.kernels.imposed_motion import (
    ImposedMotion,
    MachineConstants,
    PathInterval,
    displacement_at,
    load_at,
    velocity_at,
)
from dcfp.kernels.law import Law
from dcfp.kernels.motion import (
    AT_REST,
    DONE,
    NO_NUMBER,
    NO_PROGRESS,
    OUT_OF_CELLS,
    GroundInput,
    Motion,
    SpringState,
    StepControl,
    StepResult,
    StepStart,
    SystemConstants,
)
from dcfp.kernels.sliding import slide_step
from dcfp.kernels.sticking import stick_step

# columns of the histories of a response; temperatures of the plates follow
DISPLACEMENT, VELOCITY, ELONGATION, FRICTION, SLIP_SIGN, INPUT, HYSTERETIC, TEMPERATURE = range(8)
# columns of the histories of a test; the first five are those of a response, and temperatures of the plates follow
LOAD, WORK, TEST_HYSTERETIC, TEST_TEMPERATURE = range(5, 9)

_MOST_STEPS_PER_SAMPLE = 20_000


class Extremes(NamedTuple):
    """What is added up or compared on the way."""

    input: float  # [mm2/s2]
    hysteretic: float  # [mm2/s2]
    turning: float  # displacement at which it last turned [mm]
    displacement: float  # largest, to either side [mm]
    change: float  # largest between two turns [mm]
    velocity: float  # largest at the ends of steps [mm/s]
    force: float  # largest at the ends of steps [mm/s2]
    temperature: float  # highest of any plate while sliding [degC]
    friction: float  # smallest coefficient while sliding [-]


class IntegrationState(NamedTuple):
    """What a response starts from and leaves behind."""

    motion: Motion
    spring: SpringState
    time: float  # [s]
    halvings: int  # of the sample interval, for the next step of sliding
    just_yielded: bool
    extremes: Extremes
    steps: int
    status: int  # how it ended
    at_rest: bool  # no more sliding can come if the ground moves no more


class TestState(NamedTuple):
    """What a test starts from and leaves behind."""

    spring: SpringState
    time: float  # [s]
    halvings: int
    just_yielded: bool
    work: float  # of the machine [N mm]
    hysteretic: float  # [N mm]
    steps: int


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
#: Records of the states, which an integration changes in place, and of the path; and of what a batch is made of.
INTEGRATION_STATE, TEST_STATE, PATH = map(record_type, (IntegrationState, TestState, PathInterval))
BATCH_SYSTEM, BATCH_RECORD, BATCH_RUN = map(record_type, (BatchSystem, BatchRecord, BatchRun))


@kernel
def _after(elapsed: float, length: float, interval: float) -> float:
    """Time in an interval after a step [s]: rounding must not leave a sliver, in which the travel is noise."""
    return interval if (interval - elapsed) - length <= 1e-12 * interval else elapsed + length


@called_kernel
def integrate(
    model: BearingModel,
    acceleration: NDArray[np.float64],
    control: StepControl,
    free_from: int,
    states: Records,
    run: int,
    histories: NDArray[np.float64],
    begins: bool,
) -> int:
    """Respond to the samples of `acceleration` [mm/s2]; return the samples done.

    Row `run` of `states` and the model's heat are where it starts from, and are left where it ends. Row i + 1 of `histories` is
    written at sample i + 1, row 0 where it `begins`. From sample `free_from` on, where the ground must have stopped accelerating, it stops as soon as it rests.
    """
    system, workspace, interval = model.system, model.heat.workspace, control.interval
    state = states[run]
    motion = Motion(*fields_of(state["motion"]))
    elongation, slip_sign, _ = fields_of(state["spring"])
    spring = SpringState(elongation, slip_sign, abs(elongation) / system.yield_per_mu)
    extremes = Extremes(*fields_of(state["extremes"]))
    halvings, just_yielded = max(state["halvings"], control.fewest_halvings), state["just_yielded"]
    began, done, status = state["time"], 0, DONE
    if begins:
        first = spring
        if slip_sign == 0:
            friction = mean_coefficient(model, abs(motion.velocity), PRESENT)
            first = SpringState(elongation, slip_sign, friction)
        _record(histories[0], model, motion, first, extremes)
    for i in range(acceleration.size - 1):
        rate = (acceleration[i + 1] - acceleration[i]) / interval
        elapsed = 0.0
        steps = 0
        while elapsed < interval:
            ground, now = GroundInput(acceleration[i] + rate * elapsed, rate), began + i * interval + elapsed
            begin = StepStart(ground, motion, spring, now, interval - elapsed)
            if spring.slip_sign == 0:
                result = stick_step(model, control, None, begin)
                just_yielded = result.spring.slip_sign != 0
            else:
                result, halvings = slide_step(model, control, None, begin, just_yielded, halvings)
                just_yielded = just_yielded and result.length == 0.0
            slid = spring.slip_sign != 0 and result.length > 0.0
            motion, spring = result.motion, result.spring
            elapsed = _after(elapsed, result.length, interval)
            extremes = _updated(extremes, system, result, slid, workspace)
            steps += 1
            if not result.fits:
                status = OUT_OF_CELLS
            elif not math.isfinite(spring.friction + motion.velocity):  # the law may answer so
                status = NO_NUMBER
            elif steps > _MOST_STEPS_PER_SAMPLE:
                status = NO_PROGRESS
            if status != DONE:
                break
        if status != DONE:
            break
        done = i + 1
        state["steps"] += steps
        if done < histories.shape[0]:
            _record(histories[done], model, motion, spring, extremes)
        if done >= free_from and _is_at_rest(model, motion, spring):
            status = AT_REST
            break
    store(state["motion"], motion)
    store(state["spring"], spring)
    store(state["extremes"], extremes)
    state["extremes"]["displacement"] = max(extremes.displacement, abs(motion.displacement))
    state["time"] = began + done * interval
    state["halvings"], state["just_yielded"] = halvings, just_yielded
    state["status"], state["at_rest"] = status, _is_at_rest(model, motion, spring)
    return done


@kernel
def _updated(
    extremes: Extremes,
    system: SystemConstants,
    result: StepResult,
    slid: bool,
    workspace: NDArray[np.float64],
) -> Extremes:
    """Return the extremes after a step."""
    turning, displacement, change = extremes.turning, extremes.displacement, extremes.change
    if not math.isnan(result.turning):
        displacement = max(displacement, abs(result.turning))
        change = max(change, abs(result.turning - turning))
        turning = result.turning
    motion, spring = result.motion, result.spring
    force = system.restoring * motion.displacement + system.elastic * spring.elongation
    temperature, friction = extremes.temperature, extremes.friction
    if slid or spring.slip_sign != 0:
        friction = min(friction, spring.friction)
        temperature = max(temperature, workspace[PRESENT])
        if system.plates == 2:
            temperature = max(temperature, workspace[PRESENT + 1])
    return Extremes(
        extremes.input + result.work,
        extremes.hysteretic + result.hysteretic,
        turning,
        displacement,
        change,
        max(extremes.velocity, abs(motion.velocity)),
        max(extremes.force, abs(force)),
        temperature,
        friction,
    )


@kernel
def _record(
    line: NDArray[np.float64], model: BearingModel, motion: Motion, spring: SpringState, extremes: Extremes
) -> None:
    _record_motion(line, motion, spring)
    line[INPUT], line[HYSTERETIC] = extremes.input, extremes.hysteretic
    for i in range(model.system.plates):
        line[TEMPERATURE + i] = model.heat.workspace[PRESENT + i]


@kernel
def _record_motion(line: NDArray[np.float64], motion: Motion, spring: SpringState) -> None:
    line[DISPLACEMENT] = motion.displacement
    line[VELOCITY] = motion.velocity
    line[ELONGATION] = spring.elongation
    line[FRICTION] = spring.friction
    line[SLIP_SIGN] = spring.slip_sign


@kernel
def _is_at_rest(model: BearingModel, motion: Motion, spring: SpringState) -> bool:
    """Whether the free elastic oscillation that is left stays inside the yield surface."""
    if spring.slip_sign != 0:
        return False
    system = model.system
    stiffness = system.restoring + system.elastic
    stuck = motion.displacement - spring.elongation
    centre = system.elastic * stuck / stiffness
    amplitude = math.hypot(motion.displacement - centre, motion.velocity / math.sqrt(stiffness))
    for speed in (0.0, amplitude * math.sqrt(stiffness)):
        friction = mean_coefficient(model, speed, PRESENT)
        if not abs(centre - stuck) + amplitude < friction * system.yield_per_mu:
            return False
    return True


@kernel
def impose_motion(
    model: BearingModel,
    machine: MachineConstants,
    lengths: NDArray[np.float64],
    intervals: Records,
    tolerance: float,
    states: Records,
    histories: NDArray[np.float64],
) -> tuple[int, int]:
    """Follow a path; return how it ended and the intervals done.

    A row of `intervals` is a `PathInterval`, `lengths` how long each lasts [s]. The first of `states` and the model's heat are where
    it starts from, and are left where it ends. Row i + 1 of `histories` is written at the end of interval i.
    """
    state, workspace = states[0], model.heat.workspace
    spring = SpringState(*fields_of(state["spring"]))
    halvings, just_yielded, clock = state["halvings"], state["just_yielded"], state["time"]
    work, hysteretic = state["work"], state["hysteretic"]
    for i in range(lengths.size):
        path = PathInterval(*fields_of(intervals[i]))
        interval = lengths[i]
        control = StepControl(interval, 0, tolerance)
        now = 0.0
        steps = 0
        while now < interval:
            motion = Motion(displacement_at(path, now), velocity_at(path, now))
            begin = StepStart(GroundInput(0.0, 0.0), motion, spring, clock + now, interval - now)
            imposed = ImposedMotion(machine, path, clock, now)
            if spring.slip_sign == 0:
                result = stick_step(model, control, imposed, begin)
                just_yielded = result.spring.slip_sign != 0
            else:
                result, halvings = slide_step(model, control, imposed, begin, just_yielded, halvings)
                just_yielded = just_yielded and result.length == 0.0
            spring = result.spring
            work += result.work
            hysteretic += result.hysteretic
            now = _after(now, result.length, interval)
            steps += 1
            if not result.fits:
                return OUT_OF_CELLS, i
            if not math.isfinite(spring.friction):  # the law may answer so
                return NO_NUMBER, i
            if steps > _MOST_STEPS_PER_SAMPLE:
                return NO_PROGRESS, i
        clock += interval
        state["steps"] += steps
        line = histories[i + 1]
        _record_motion(line, Motion(displacement_at(path, interval), velocity_at(path, interval)), spring)
        line[LOAD], line[WORK], line[TEST_HYSTERETIC] = load_at(path, interval), work, hysteretic
        for j in range(model.system.plates):
            line[TEST_TEMPERATURE + j] = workspace[PRESENT + j]
    store(state["spring"], spring)
    state["halvings"], state["just_yielded"], state["time"] = halvings, just_yielded, clock
    state["work"], state["hysteretic"] = work, hysteretic
    return DONE, lengths.size


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

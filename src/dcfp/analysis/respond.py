"""Response history analysis of a rigid structure on a bearing."""

import math
import time
from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from dcfp.analysis.kernel_input import State, heat_of, state_at_rest
from dcfp.analysis.response import Histories, Response, Settings
from dcfp.arrays import FloatArray, freeze
from dcfp.errors import AnalysisError, InputError
from dcfp.kernels import march as m
from dcfp.kernels.friction import mean_coefficient
from dcfp.kernels.heat_state import FINEST_LEVEL, NO_HEATING, PRESENT
from dcfp.kernels.law import Law
from dcfp.kernels.march import AT_REST, NO_NUMBER, NO_PROGRESS, OUT_OF_CELLS, TEMPERATURE, march
from dcfp.kernels.motion import Structure
from dcfp.motion.ground_motion import GroundMotion, check_step_and_tail, parts_in, refined, with_tail
from dcfp.system import LI_2020, Bearing, FrictionLaw, Heating, Li2020, SimplifiedHeating
from dcfp.system.plates import Profiles, profile_now, structure_of

#: Default of `Settings.tolerance`.
TOLERANCE = 0.02
#: Longest step of sliding [s], whatever the record's own: peaks are looked for at the ends of steps.
LONGEST_STEP = 0.01


@dataclass
class _Run:
    """What one march left behind."""

    state: State
    lines: FloatArray
    profiles: list[tuple[float, FloatArray]]
    done: int
    rests: bool
    elapsed: float


def respond(
    motion: GroundMotion,
    bearing: Bearing = LI_2020,
    friction: FrictionLaw | None = None,
    heating: Heating | None = None,
    *,
    tail: float | None = None,
    tolerance: float = TOLERANCE,
    step: float | None = None,
    start: State | None = None,
    profile_every: int | None = None,
) -> Response:
    """Analyse a rigid structure on a bearing under a ground motion.

    Parameters
    ----------
    motion
        Ground acceleration, linear between its samples.
    bearing
        By default that of Li et al. (2020).
    friction
        By default the law of Li et al. (2020), Eqs (7)-(10).
    heating
        By default the simplified model, Li et al. (2020), section 4.2.
    tail
        Time after the record in which the ground keeps its velocity [s]. By default the analysis goes on until no
        more sliding can come, for at most 120 s.
    tolerance
        How far the coefficient of friction in the middle of a step may be from the mean of its ends, relative to it [-];
        looked at where the ends differ by more than that.
    step
        Longest step [s]; by default the record's own, and for sliding at most 0.01 s.
    start
        State to begin from, `Response.final_state` of an earlier analysis of the same bearing, law and heating; by default at
        rest. Energies and peaks go on from there too; ``final_state.afresh()`` begins them anew, for the next earthquake.
    profile_every
        Keep the temperature along the plates at every so many samples; needs the precise heating model.

    Returns
    -------
    Response
        Histories at the record's samples (at the steps where `step` is shorter), peaks, and the state at the end.

    Raises
    ------
    InputError
        If an argument is out of range.
    AnalysisError
        If the analysis cannot be finished.
    """
    friction = Li2020() if friction is None else friction
    heating = SimplifiedHeating() if heating is None else heating
    settings = _checked(tail, tolerance, step, profile_every, heating)
    structure = structure_of(bearing, friction)
    law = friction.at_pressure(bearing.pressure)
    parts = 1 if step is None else parts_in(motion.time_step, step)
    interval = motion.time_step / parts
    acceleration = refined(with_tail(motion, settings.tail), parts)
    # from one sample of the record after its last, where the ground has stopped accelerating
    free_from = motion.acceleration.size * parts if tail is None else acceleration.size
    _load_kernels()
    model = (bearing, friction, heating)
    first = state_at_rest(*model) if start is None else start
    if first.model != model:
        msg = f"{motion.name}: the starting state is that of another bearing, friction law or heating model."
        raise InputError(msg)
    run = None
    while run is None:
        run = _march(motion.name, law, structure, first.copy(), acceleration, interval, free_from, settings)
        if run is None:  # the slider left the line of cells
            first = first.with_room(first.plates.cells.shape[1])
    samples = run.done + 1
    ground = first.ground_velocity + _ground_velocity(acceleration[:samples], interval)
    lines = run.lines[:samples]
    histories = Histories(
        time=freeze(np.arange(samples) * interval),
        ground_acceleration=freeze(acceleration[:samples]),
        ground_velocity=freeze(ground),
        lines=freeze(lines),
    )
    return Response(
        motion=motion,
        bearing=bearing,
        friction_law=friction,
        heating=heating,
        settings=settings,
        histories=histories,
        final_state=replace(run.state, ground_velocity=float(ground[-1])),
        rests=run.rests,
        profiles=Profiles.of(run.profiles, bearing, heating) if run.profiles else None,
        elapsed=run.elapsed,
    )


def _checked(
    tail: float | None, tolerance: float, step: float | None, profile_every: int | None, heating: Heating
) -> Settings:
    check_step_and_tail(step, tail)
    if not (math.isfinite(tolerance) and 0.0 < tolerance < 1.0):
        msg = f"The tolerance must lie between 0 and 1, not {tolerance!r}."
        raise InputError(msg)
    if profile_every is not None and (heating.name != "precise" or profile_every < 1):
        msg = "The temperature along the plates needs the precise heating model and a positive number of samples."
        raise InputError(msg)
    return Settings(tail=tail, tolerance=tolerance, step=step, profile_every=profile_every)


def halvings(interval: float) -> int:
    """Return how often a sample interval [s] must be halved not to exceed the longest step."""
    return min(max(0, math.ceil(math.log2(interval / LONGEST_STEP * (1.0 - 1e-9)))), FINEST_LEVEL)


def _ground_velocity(acceleration: FloatArray, interval: float) -> FloatArray:
    velocity = np.zeros_like(acceleration)
    np.cumsum(0.5 * interval * (acceleration[1:] + acceleration[:-1]), out=velocity[1:])
    return velocity


@cache
def _load_kernels() -> None:
    """Have the kernels compiled or loaded, so that the time of an analysis is its own."""
    law, structure = Li2020().at_pressure(LI_2020.pressure), structure_of(LI_2020, Li2020())
    state = state_at_rest(LI_2020, Li2020(), SimplifiedHeating())
    heat = heat_of(state)._replace(kind=NO_HEATING)
    lines = np.zeros((2, TEMPERATURE + structure.plates))
    march(law, structure, heat, np.zeros(2), 1e-3, 0, 2, TOLERANCE, state.march, lines)


def _march(
    name: str,
    law: Law,
    structure: Structure,
    state: State,
    acceleration: FloatArray,
    interval: float,
    free_from: int,
    settings: Settings,
) -> _Run | None:
    """March through the whole motion; None if the slider left the line of cells."""
    began = time.perf_counter()
    heat = heat_of(state)
    lines = np.empty((acceleration.size, TEMPERATURE + structure.plates))
    lines[0] = _first_line(law, state, structure)
    profiles: list[tuple[float, FloatArray]] = []
    part = settings.profile_every or acceleration.size
    done, rests = 0, False
    while done < acceleration.size - 1:
        stop = min(done + part, acceleration.size - 1)
        status, samples, rests = march(
            law,
            structure,
            heat,
            acceleration[done : stop + 1],
            interval,
            halvings(interval),
            free_from - done,
            settings.tolerance,
            state.march,
            lines[done:],
        )
        done += samples
        if status == OUT_OF_CELLS:
            return None
        if status == NO_NUMBER:
            raise state.model[1].no_number(name, done * interval)
        if status == NO_PROGRESS:
            msg = (
                f"{name}: the analysis makes no progress at {done * interval:.4g} s;"
                " look at the friction law, or try a shorter step."
            )
            raise AnalysisError(msg)
        if settings.profile_every is not None:
            flux = structure.pressure * abs(
                lines[done, m.SIDE] * lines[done, m.FRICTION] * lines[done, m.VELOCITY]
            )
            now = float(state.march[m.STATE_TIME])
            profiles.append((done * interval, profile_now(heat, structure, now, flux)))
        if status == AT_REST:
            break
    return _Run(state, lines, profiles, done, rests, time.perf_counter() - began)


def _first_line(law: Law, state: State, structure: Structure) -> FloatArray:
    line = np.zeros(TEMPERATURE + structure.plates)
    line[m.DISPLACEMENT] = state.march[m.STATE_DISPLACEMENT]
    line[m.VELOCITY] = state.march[m.STATE_VELOCITY]
    line[m.ELONGATION] = state.march[m.STATE_ELONGATION]
    line[m.SIDE] = state.march[m.STATE_SIDE]
    line[m.INPUT] = state.march[m.STATE_INPUT]
    line[m.HYSTERETIC] = state.march[m.STATE_HYSTERETIC]
    line[m.FRICTION] = mean_coefficient(law, structure, abs(line[m.VELOCITY]), state.plates.notes, PRESENT)
    if line[m.SIDE] != 0.0:
        line[m.FRICTION] = abs(line[m.ELONGATION]) / structure.reach
    line[TEMPERATURE:] = state.plates.temperature
    return line

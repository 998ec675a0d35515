"""Response history analysis of a rigid structure on a bearing in two horizontal directions."""

import math
import time
from dataclasses import replace
from functools import cache, lru_cache

import numpy as np

from dcfp.analysis.integration import DEFAULT, LONGEST_STEP, NOTHING, Integration, Keep, halvings
from dcfp.analysis.plane_fields import fields_at, moments_of
from dcfp.analysis.plane_response import PlaneResponse, PlaneState, plane_state_at_rest
from dcfp.analysis.response import check_start
from dcfp.arrays import FloatArray, first_rows, freeze, whole_integral
from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import AnalysisError
from dcfp.kernels import plane_integrate as k
from dcfp.kernels.heat_state import MOST_HALVINGS
from dcfp.kernels.motion import NO_NUMBER, OUT_OF_CELLS
from dcfp.kernels.plane_slide import PlaneControl
from dcfp.kernels.plane_step import oscillator_rows
from dcfp.motion.ground_motion import parts_in, refined, with_tail
from dcfp.motion.station import Station
from dcfp.system import System
from dcfp.system.fields import PlaneHeat

#: Distance of the friction from its chord in the middle of a step that is allowed by default, over mu g [-]; it goes with the tolerance of an analysis.
TOLERANCE = 5e-3
#: Longest step over the period of an oscillation on spring (b) [-]: a light structure may go through half of one between two samples.
PART_OF_PERIOD = 0.125
#: Part of the pressure at rest below which a friction law is not asked for less [-].
LEAST_RATIO = 0.01


def analyse_plane(
    motion: Station,
    system: System,
    integration: Integration = DEFAULT,
    *,
    vertical: bool = False,
    start: PlaneState | None = None,
    keep: Keep = NOTHING,
) -> PlaneResponse:
    """Analyse a system under the ground motion of a station.

    Parameters
    ----------
    motion
        Of the station.
    system
        Bearing with its friction law and heating model.
    integration
        How finely and how far it goes.
    vertical
        Whether the vertical force follows the vertical component, N = N0 (1 + a_z / g), and is none where that would pull.
    start
        State to begin from, the final one of another analysis; by default at rest and cold.
    keep
        How often the temperature of the plates is kept.

    Raises
    ------
    InputError
        If the starting state is that of another system, there is no vertical component, or the heating model has no plates to keep.
    AnalysisError
        If the analysis cannot be finished.
    """
    check_start(motion.name, start, system)
    parts = 1 if integration.step is None else parts_in(motion.time_step, integration.step)
    interval = motion.time_step / parts

    def sampled(acceleration: FloatArray) -> FloatArray:
        return refined(with_tail(acceleration, motion.time_step, integration.tail), parts)

    ground, loads = sampled(motion.acceleration), np.empty((0, 2))
    if vertical:
        ratio = 1.0 + sampled(motion.require_vertical().acceleration) / STANDARD_GRAVITY
        loads = np.column_stack((ratio, references(system, np.maximum(ratio, 0.0))))
    free_from = len(motion.acceleration) * parts if integration.tail is None else len(ground)
    _load_kernels()
    bearing = system.bearing
    period = math.tau * math.sqrt(bearing.mass / bearing.elastic_stiffness)
    fewest = halvings(interval, min(LONGEST_STEP, PART_OF_PERIOD * period))
    control = PlaneControl(interval, fewest, TOLERANCE * integration.tolerance / DEFAULT.tolerance)
    factor = 1.0
    while True:
        try:
            state = _beginning(system, start, factor)
        except AnalysisError as error:
            msg = f"{motion.name}, PGV {motion.peak_velocity / 1e3:.3g} m/s: {error}"
            raise AnalysisError(msg) from None
        run = _integrated(motion.name, state, ground, loads, control, free_from)
        if run is not None:
            break
        factor *= 2.0  # the slider left the grid
    lines, elapsed = run
    ratios = np.maximum(loads[: len(lines), 0], 0.0) if vertical else np.ones(1)
    known, fields = freeze(np.arange(len(lines)) * interval), None
    if keep != NOTHING and (moments := moments_of(keep, lines, system.heating)):
        again = _beginning(system, start, factor)

        def go_on(first: int, last: int) -> tuple[PlaneHeat, float]:
            part = slice(first, last + 1)
            _integrated(motion.name, again, ground[part], loads[part], control, len(ground))
            return again.heat, float(again.integration["time"][0])

        fields = fields_at(
            moments, known, lines, np.broadcast_to(ratios, len(lines)), system, state.heat, go_on
        )
    ground = first_rows(ground, len(lines))
    return PlaneResponse(
        motion=motion,
        system=system,
        integration=integration,
        time=known,
        ground_acceleration=ground,
        starting_velocity=state.ground_velocity,
        lines=lines,
        final_state=replace(state, ground_velocity=state.ground_velocity + whole_integral(ground, interval)),
        loads=freeze(bearing.vertical_force * ratios),
        rests=bool(state.integration["at_rest"][0]),
        fields=fields,
        elapsed=elapsed,
    )  # fmt: skip


def _beginning(system: System, start: PlaneState | None, factor: float) -> PlaneState:
    """Return a state to change, with room for so many times the displacement."""
    state = plane_state_at_rest(system) if start is None else start.copy()
    return state if factor == 1.0 else state.with_room(factor)


def references(system: System, ratio: FloatArray) -> FloatArray:
    """Return the reference of the friction law at so many times the pressure at rest, shape (n,); levels are told apart to a ten thousandth."""
    levels, place = np.unique(np.round(ratio, 4), return_inverse=True)
    law, pressure = system.friction, system.bearing.pressure
    known = [law.at_pressure(max(float(level), LEAST_RATIO) * pressure).reference for level in levels]
    return np.array(known)[place]


@lru_cache(maxsize=64)
def _tables(restoring: float, elastic: float, interval: float) -> FloatArray:
    lengths = interval * 0.5 ** np.arange(MOST_HALVINGS + 1.0)
    return np.stack([oscillator_rows(restoring, lengths), oscillator_rows(restoring + elastic, lengths)])


@cache
def _load_kernels() -> None:
    """Have the kernels compiled or loaded, so that the time of an analysis is its own."""
    _integrated("", plane_state_at_rest(System()), np.zeros((2, 2)), np.empty((0, 2)), PlaneControl(1e-3, 0, TOLERANCE), 2)  # fmt: skip


def _integrated(
    name: str,
    state: PlaneState,
    ground: FloatArray,
    loads: FloatArray,
    control: PlaneControl,
    free_from: int,
) -> tuple[FloatArray, float] | None:
    """Return histories and the computing time [s], or None if the slider left the grid; the state changes."""
    system = state.system
    began = time.perf_counter()
    model, integration = state.heat.model(system), state.integration
    tables = _tables(model.system.restoring, model.system.elastic, control.interval)
    lines = np.empty((len(ground), k.TEMPERATURE + model.system.plates))
    done = k.integrate_plane(
        model, state.heat.field, ground, loads, control, tables, free_from, integration, lines
    )
    status = int(integration["status"][0])
    if status == OUT_OF_CELLS:
        return None
    if status == NO_NUMBER:
        raise system.friction.no_number(name, done * control.interval)
    elapsed = time.perf_counter() - began
    return first_rows(lines, done + 1), elapsed

"""Response history analysis of a rigid structure on a bearing."""

import time
from dataclasses import replace
from functools import cache
from typing import TYPE_CHECKING, overload

import numpy as np

from dcfp.analysis.integration import DEFAULT, NOTHING, Integration, Keep, halvings, usual_heating
from dcfp.analysis.response import Response, State, check_start, state_at_rest
from dcfp.arrays import FloatArray, first_rows, freeze, whole_integral
from dcfp.errors import InputError
from dcfp.kernels import integrate as k
from dcfp.kernels.motion import AT_REST, NO_NUMBER, NO_PROGRESS, OUT_OF_CELLS, StepControl
from dcfp.motion.ground_motion import GroundMotion, parts_in, refined, with_tail
from dcfp.motion.load import Motion, Record, record_of
from dcfp.motion.station import Station
from dcfp.schema.parameters import other, refuse_other
from dcfp.system import FrictionLaw, Heating, System, SystemLike
from dcfp.system.plates import Profiles, kernel_model, profile_now

if TYPE_CHECKING:
    from dcfp.analysis.plane_response import PlaneResponse, PlaneState


@overload
def respond(
    motion: Station,
    bearing: SystemLike = None,
    friction: FrictionLaw | str | None = None,
    heating: Heating | str | None = None,
    *,
    pgv: float | None = None,
    vertical: bool = False,
    tail: float | None = None,
    tolerance: float = DEFAULT.tolerance,
    step: float | None = None,
    start: "PlaneState | None" = None,
    keep: Keep = NOTHING,
) -> "PlaneResponse": ...
@overload
def respond(
    motion: Motion,
    bearing: SystemLike = None,
    friction: FrictionLaw | str | None = None,
    heating: Heating | str | None = None,
    *,
    pgv: float | None = None,
    vertical: bool = False,
    tail: float | None = None,
    tolerance: float = DEFAULT.tolerance,
    step: float | None = None,
    start: State | None = None,
    keep: Keep = NOTHING,
) -> Response: ...
def respond(
    motion: Record,
    bearing: SystemLike = None,
    friction: FrictionLaw | str | None = None,
    heating: Heating | str | None = None,
    *,
    pgv: float | None = None,
    vertical: bool = False,
    tail: float | None = None,
    tolerance: float = DEFAULT.tolerance,
    step: float | None = None,
    start: "State | PlaneState | None" = None,
    keep: Keep = NOTHING,
) -> "Response | PlaneResponse":
    """Analyse a rigid structure on a bearing under a ground motion.

    Parameters
    ----------
    motion
        Ground motion, linear between its samples; or the name of a record, or a file. A station is analysed in the plane.
    bearing
        By default that of Li et al. (2020); or a whole `System`, or a bearing file, whose law and heating model then stand for those not given.
    friction
        Friction law or its name; by default that of Li et al. (2020), Eqs (7)-(10).
    heating
        Heating model or its name; by default the simplified one, Li et al. (2020), section 4.2, and of a station the precise one.
    pgv
        PGV to scale the motion to [mm/s]; by default it is taken as it is.
    vertical
        Of a station: whether the vertical force follows its vertical component.
    tail, tolerance, step
        How far and how finely [s, -, s]: `Integration`.
    start
        State to begin from, `Response.final_state` of an earlier analysis of the same system; by default at
        rest. Energies and peaks go on from there too; ``final_state.afresh()`` begins them anew, for the next earthquake.
    keep
        What to keep beside histories, peaks and the last state.

    Returns
    -------
    Response, PlaneResponse
        Histories at the record's samples (at the steps where `step` is shorter), peaks, and the state at the end.

    Raises
    ------
    InputError
        If an argument is out of range, or there is none of such a name.
    AnalysisError
        If the analysis cannot be finished.
    """
    refuse_other(keep, Keep, "keep", "a Keep")
    record, integration = record_of(motion, pgv), Integration(step=step, tail=tail, tolerance=tolerance)
    system = System.of(bearing, friction, heating, usual=usual_heating([record]))
    return analyse_record(record, system, integration, vertical=vertical, start=start, keep=keep)


def analyse_record(
    record: GroundMotion | Station,
    system: System,
    integration: Integration,
    *,
    vertical: bool = False,
    start: "State | PlaneState | None" = None,
    keep: Keep = NOTHING,
) -> "Response | PlaneResponse":
    """Analyse a system under a ground motion, or in the plane under a station; arguments, result and errors as for `respond`."""
    if isinstance(record, Station):
        # late: most motions are of one direction
        from dcfp.analysis.plane_history import PlaneState, analyse_plane

        if start is not None and not isinstance(start, PlaneState):
            raise InputError(other(start, "start", "the final state of a PlaneResponse"))
        return analyse_plane(record, system, integration, vertical=vertical, start=start, keep=keep)
    if vertical:
        msg = f"{record.name}: a single component has no vertical one; give a station, as in east.AT2+north.AT2+up.AT2."
        raise InputError(msg)
    if start is not None and not isinstance(start, State):
        raise InputError(other(start, "start", "the final state of a Response"))
    return analyse(record, system, integration, start=start, keep=keep)


def analyse(
    motion: GroundMotion,
    system: System,
    integration: Integration,
    *,
    start: State | None = None,
    keep: Keep = NOTHING,
) -> Response:
    """Analyse a system under a ground motion; arguments, result and errors as for `respond`."""
    parts = 1 if integration.step is None else parts_in(motion.time_step, integration.step)
    interval = motion.time_step / parts
    acceleration = refined(with_tail(motion.acceleration, motion.time_step, integration.tail), parts)
    # from one sample of the record after its last, where the ground has stopped accelerating
    free_from = motion.acceleration.size * parts if integration.tail is None else acceleration.size
    every = keep.interval((motion.acceleration.size - 1) * parts, system.heating)
    check_start(motion.name, start, system)
    _load_kernels()
    control = StepControl(interval, halvings(interval), integration.tolerance)
    state, room = state_at_rest(system) if start is None else start.copy(), 0
    while (run := _integrated(motion.name, state, acceleration, control, free_from, every)) is None:
        # the slider left the line of cells
        room += state.plates.cells.shape[1]
        state = (state_at_rest(system) if start is None else start).with_room(room)
    lines, profiles, elapsed = run
    ground = first_rows(acceleration, len(lines))
    return Response(
        motion=motion,
        system=system,
        integration=integration,
        time=freeze(np.arange(len(lines)) * interval),
        ground_acceleration=ground,
        starting_velocity=state.ground_velocity,
        lines=lines,
        final_state=replace(
            state, ground_velocity=state.ground_velocity + float(whole_integral(ground, interval))
        ),
        rests=bool(state.integration["at_rest"][0]),
        profiles=Profiles.of(profiles, system) if profiles else None,
        elapsed=elapsed,
    )


@cache
def _load_kernels() -> None:
    """Have the kernels compiled or loaded, and their arguments' types known, so that the time of an analysis is its own."""
    _integrated("", state_at_rest(System()), np.zeros(2), StepControl(1e-3, 0, DEFAULT.tolerance), 2, None)


def _integrated(
    name: str,
    state: State,
    acceleration: FloatArray,
    control: StepControl,
    free_from: int,
    every: int | None,
) -> tuple[FloatArray, list[tuple[float, FloatArray]], float] | None:
    """Return histories, profiles and the computing time [s], or None if the slider left the line of cells; the state changes."""
    model, integration = kernel_model(state.system, state.plates), state.integration
    began = time.perf_counter()
    lines = np.empty((acceleration.size, k.TEMPERATURE + model.system.plates))
    profiles: list[tuple[float, FloatArray]] = []
    part = every or acceleration.size
    done = 0
    while done < acceleration.size - 1:
        ground = acceleration[done : min(done + part, acceleration.size - 1) + 1]
        done += k.integrate(model, ground, control, free_from - done, integration, 0, lines[done:], done == 0)
        status = int(integration["status"][0])
        if status == OUT_OF_CELLS:
            return None
        if status == NO_NUMBER:
            raise state.system.friction.no_number(name, done * control.interval)
        if status == NO_PROGRESS:
            raise state.system.friction.no_progress(name, done * control.interval)
        if every is not None:
            _, velocity, _, coefficient, slip_sign = lines[done, : k.SLIP_SIGN + 1]
            flux = model.system.pressure * abs(slip_sign * coefficient * velocity)
            now = float(integration["time"][0])
            profiles.append((done * control.interval, profile_now(model.heat, model.system, now, flux)))
        if status == AT_REST:
            break
    elapsed = time.perf_counter() - began
    return first_rows(lines, done + 1), profiles, elapsed

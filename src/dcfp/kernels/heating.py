r"""Temperature of the sliding contact from the heat of friction, Eqs (11) and (12) of Li et al. (2020).

Three models share one interface:

* ``NO_HEATING``: the ambient temperature;
* ``POINT``: one monitoring point at the centre of the plate (the simplified model);
* ``LINE``: every point along the sliding direction, averaged over the contact (the precise model, in `plate`).
"""

import math

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels import plate
from dcfp.kernels._jit import kernel
from dcfp.kernels.heat_state import (
    COMMON,
    CYCLING_PARAMETER,
    EXPECTED,
    INSIDE,
    LINE,
    NO_HEATING,
    ODD_LENGTH,
    PLATE_ROW,
    PLATE_ROWS,
    POINT,
    PRESENT,
    RATES,
    RATIO,
    STEP_ENTRIES,
    STEP_ENTRY,
    STEP_ROW,
    STEP_ROWS,
    WEIGHTS,
    Heat,
)
from dcfp.kernels.motion import SystemConstants, share, speed_factor
from dcfp.kernels.sum_of_exponentials import accumulate, decay, decayed_total, fill_decay, fill_weights, total


@kernel
def prepare_cooling(heat: Heat, place: int, length: float) -> None:
    """Make the step at `place` one of `length` [s] that can only cool, unless it is already."""
    if heat.kind != NO_HEATING and abs(heat.workspace[STEP_ENTRY + STEP_ENTRIES * place]) != length:
        fill_decay(heat.modes, RATES, length, STEP_ROW + STEP_ROWS * place)
        heat.workspace[STEP_ENTRY + STEP_ENTRIES * place] = -length


@kernel
def prepare(heat: Heat, place: int, length: float) -> None:
    """Make the step at `place` one of `length` [s], unless it is already."""
    entry = STEP_ENTRY + STEP_ENTRIES * place
    if heat.kind == NO_HEATING or heat.workspace[entry] == length:
        return
    factors = STEP_ROW + STEP_ROWS * place
    if heat.workspace[entry] != -length:
        fill_decay(heat.modes, RATES, length, factors)
    fill_weights(heat.modes, RATES, WEIGHTS, length, factors)
    heat.workspace[entry] = length
    heat.workspace[entry + 1] = total(heat.modes, factors + 1)
    heat.workspace[entry + 2] = total(heat.modes, factors + 2)


@kernel
def _feels_flux(heat: Heat, portion: float, displacement: float) -> bool:
    """Whether the common modes of a plate are heated: Eq. (12) for the centre of the plate, always for the line."""
    return heat.kind == LINE or abs(portion * displacement) <= heat.half_contact


@kernel
def expect(
    heat: Heat,
    system: SystemConstants,
    place: int,
    time: float,
    displacement: float,
    travel: float,
    flux_start: float,
    flux_end: float,
    rubbing: float,
) -> None:
    """Store the temperatures and cycling parameters to expect at the end of a step, without taking it.

    `time` [s] is at its start, `displacement` [mm] in its middle and `travel` [mm] over it; fluxes are mu p |v|
    [N/(mm s)], of which a plate gets its share, in the ratio of its coefficient to the mean; `rubbing` is p v2 over
    the step at the relative speed [N/s].
    """
    workspace, modes = heat.workspace, heat.modes
    factors, entry = STEP_ROW + STEP_ROWS * place, STEP_ENTRY + STEP_ENTRIES * place
    for i in range(system.plates):
        rise = heat.ambient
        if heat.kind != NO_HEATING:
            portion = share(system, i)
            first = PLATE_ROW + i * PLATE_ROWS
            rise += decayed_total(modes, factors, first + COMMON)
            if _feels_flux(heat, portion, displacement):
                rise += (
                    portion
                    * workspace[RATIO + i]
                    * (workspace[entry + 1] * flux_start + (workspace[entry + 2] + heat.instant) * flux_end)
                )
            if heat.kind == LINE:
                swept = plate.expect_sweep(heat, i, time, portion * travel)
                inside = decayed_total(modes, factors, first + INSIDE)
                rise += (inside + swept) / (2.0 * heat.half_contact)
        workspace[EXPECTED + i] = rise
        workspace[EXPECTED + CYCLING_PARAMETER + i] = (
            workspace[PRESENT + CYCLING_PARAMETER + i] + speed_factor(system, i) ** 2 * rubbing
        )


@kernel
def expect_cooling(heat: Heat, system: SystemConstants, place: int) -> None:
    """Store the temperatures to expect at the end of a step without sliding, without taking it."""
    factors = STEP_ROW + STEP_ROWS * place
    for i in range(system.plates):
        rise = 0.0
        if heat.kind != NO_HEATING:
            first = PLATE_ROW + i * PLATE_ROWS
            rise = decayed_total(heat.modes, factors, first + COMMON)
            if heat.kind == LINE:
                rise += decayed_total(heat.modes, factors, first + INSIDE) / (2.0 * heat.half_contact)
        heat.workspace[EXPECTED + i] = heat.ambient + rise
        heat.workspace[EXPECTED + CYCLING_PARAMETER + i] = heat.workspace[PRESENT + CYCLING_PARAMETER + i]


@kernel
def interpolate(heat: Heat, system: SystemConstants, part: float, entry: int) -> None:
    """Store at `entry` the temperatures and cycling parameters at a `part` of the way from the present to the expected ones."""
    workspace = heat.workspace
    for i in range(system.plates):
        for quantity in (0, CYCLING_PARAMETER):
            present = workspace[PRESENT + quantity + i]
            workspace[entry + quantity + i] = present + part * (workspace[EXPECTED + quantity + i] - present)


@kernel
def heat_up(
    heat: Heat,
    system: SystemConstants,
    place: int,
    time: float,
    length: float,
    displacement: float,
    middle: float,
    flux_start: float,
    flux_end: float,
    flux_now: float,
    rubbing: float,
) -> bool:
    """Take a sliding step of `length` [s] to `time` [s] and `displacement` [mm]; return False where the cells end.

    `middle` [mm] is the displacement inside the step, from which contact with the centre is judged. Over the step the flux
    is as if it went linearly from `flux_start` to `flux_end`; `flux_now` is what it is at the end [N/(mm s)]; `rubbing` as in `expect`.
    """
    for i in range(system.plates):
        heat.workspace[PRESENT + CYCLING_PARAMETER + i] += speed_factor(system, i) ** 2 * rubbing
    if heat.kind == NO_HEATING:
        return True
    factors = STEP_ROW + STEP_ROWS * place
    fits = True
    for i in range(system.plates):
        portion = share(system, i)
        felt = portion * heat.workspace[RATIO + i] if _feels_flux(heat, portion, middle) else 0.0
        first = PLATE_ROW + i * PLATE_ROWS
        if heat.kind == LINE:
            # half of the way before the heat and half after it: second order in the step
            fits = plate.sweep_to(heat, i, time - length, portion * middle) and fits
        rise = accumulate(heat.modes, factors, first + COMMON, felt * flux_start, felt * flux_end)
        rise += heat.instant * felt * flux_now
        if heat.kind == LINE:
            plate.decay_edges(heat, factors, i)
            decay(heat.modes, factors, first + INSIDE)
            fits = plate.sweep_to(heat, i, time, portion * displacement) and fits
            rise += plate.mean_difference(heat, i)
        heat.workspace[PRESENT + i] = heat.ambient + rise
    return fits


@kernel
def cool_down(heat: Heat, system: SystemConstants, place: int) -> None:
    """Take a step without sliding: everything decays."""
    if heat.kind == NO_HEATING:
        return
    factors = STEP_ROW + STEP_ROWS * place
    for i in range(system.plates):
        first = PLATE_ROW + i * PLATE_ROWS
        rise = decay(heat.modes, factors, first + COMMON)
        if heat.kind == LINE:
            plate.decay_edges(heat, factors, i)
            rise += decay(heat.modes, factors, first + INSIDE) / (2.0 * heat.half_contact)
        heat.workspace[PRESENT + i] = heat.ambient + rise


@kernel
def place_slider(heat: Heat, system: SystemConstants, time: float, displacement: float) -> bool:
    """Move the slider to a displacement [mm] without friction, at a time [s]; return False where the cells end."""
    fits = True
    if heat.kind != LINE:
        return fits
    for i in range(system.plates):
        fits = plate.sweep_to(heat, i, time, share(system, i) * displacement) and fits
        rise = total(heat.modes, PLATE_ROW + i * PLATE_ROWS + COMMON) + plate.mean_difference(heat, i)
        heat.workspace[PRESENT + i] = heat.ambient + rise
    return fits


@kernel
def crossed_edge(heat: Heat, system: SystemConstants, plate: int, start: float, end: float) -> float:
    """Displacement between two [mm] at which a plate's monitoring point comes under the slider or leaves it, Eq. (12); nan if it does not."""
    portion = share(system, plate)
    if (portion * abs(start) <= heat.half_contact) == (portion * abs(end) <= heat.half_contact):
        return math.nan
    outer = start if abs(start) > abs(end) else end
    return math.copysign(heat.half_contact / portion, outer)


@kernel
def surface_temperature(
    system: SystemConstants,
    heat: Heat,
    lengths: NDArray[np.float64],
    displacement: NDArray[np.float64],
    flux: NDArray[np.float64],
    temperatures: NDArray[np.float64],
) -> bool:
    """Write the temperature of each plate [degC] at every sample of a motion whose heat is known; return False where the cells end.

    Between samples, `lengths` [s] apart, `displacement` [mm] and `flux`, mu p |v| [N/(mm s)], are linear. Row i of `temperatures` is at
    sample i.
    """
    time = 0.0
    fits = place_slider(heat, system, time, displacement[0])
    for j in range(system.plates):
        temperatures[0, j] = heat.workspace[PRESENT + j]
    for i in range(lengths.size):
        interval = lengths[i]
        done = 0.0
        while done < 1.0:
            end = _until_edge(heat, system, displacement[i], displacement[i + 1], done)
            place = 0 if end - done == 1.0 else ODD_LENGTH
            length = (end - done) * interval
            if heat.kind != NO_HEATING:
                prepare(heat, place, length)
            first = flux[i] + done * (flux[i + 1] - flux[i])
            last = flux[i] + end * (flux[i + 1] - flux[i])
            travel = displacement[i + 1] - displacement[i]
            there = displacement[i] + end * travel
            middle = displacement[i] + 0.5 * (done + end) * travel
            fits = (
                heat_up(
                    heat, system, place, time + end * interval, length, there, middle, first, last, last, 0.0
                )
                and fits
            )
            done = end
        time += interval
        for j in range(system.plates):
            temperatures[i + 1, j] = heat.workspace[PRESENT + j]
    return fits


@kernel
def _until_edge(heat: Heat, system: SystemConstants, start: float, stop: float, done: float) -> float:
    """Return the part of the step up to where a plate's monitoring point next comes under the slider or leaves it: Eq. (12)."""
    nearest = 1.0
    if heat.kind != POINT or start == stop:
        return nearest
    for j in range(system.plates):
        edge = heat.half_contact / share(system, j)
        for target in (edge, -edge):
            part = (target - start) / (stop - start)
            # what is left of the step must be worth a step
            if done + 1e-9 < part < nearest - 1e-9:
                nearest = part
    return nearest

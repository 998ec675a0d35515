r"""Temperature of the sliding contact from the heat of friction, Eqs (11) and (12) of Li et al. (2020).

Three models share one interface:

* ``NO_HEATING``: the ambient temperature;
* ``POINT``: one monitoring point at the centre of the plate (the simplified model);
* ``LINE``: every point along the sliding direction, averaged over the contact (the precise model, in `plate`).

All modes stand in one array, the *bank*, whose rows have names here, and all else that changes stands in another,
the *notes*: compiled calls pass few arrays quickly and many arrays slowly.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels import plate
from dcfp.kernels._jit import kernel
from dcfp.kernels.memory import MODES, faded_total, feed, fill_fade, fill_weights, let_fade
from dcfp.kernels.motion import share

NO_HEATING = 0
POINT = 1
LINE = 2

#: Halvings of the sample interval that the error control may use.
FINEST_LEVEL = 10
#: Place of the prepared step that has any other length.
ODD_LENGTH = FINEST_LEVEL + 1

# rows of the bank
RATES, WEIGHTS = 0, 1
_STEPS = plate.FIRST_ROW + 2 * plate.ROWS
BANK_ROWS = _STEPS + 3 * (ODD_LENGTH + 1)

# entries of the notes: temperatures of up to two plates now, expected at the end of a step, and in between
PRESENT, EXPECTED, BETWEEN = 0, 2, 4
STEP_NOTES = plate.FIRST_NOTE + 2 * plate.NOTES
NOTES = STEP_NOTES + 3 * (ODD_LENGTH + 1)
# three notes for each prepared step: its length [s] (negative if it can only cool), sums of its two rows of weights


class Heat(NamedTuple):
    """Constants and state of the heating model."""

    kind: int
    ambient: float  # [degC]
    half_contact: float  # half side of the square contact [mm]
    cell: float  # width of a cell of the plate [mm]
    instant: float  # rise per flux of the modes that act at once [degC mm s/N]
    bank: NDArray[np.float64]  # (BANK_ROWS, modes)
    notes: NDArray[np.float64]  # (NOTES,)
    cells: NDArray[np.float64]  # (plates, cells, modes + 1)


@kernel
def prepare_cooling(heat, place, length):
    """Make the step at `place` one of `length` [s] that can only cool, unless it is already."""
    if heat.kind != NO_HEATING and abs(heat.notes[STEP_NOTES + 3 * place]) != length:
        fill_fade(heat.bank, RATES, length, _STEPS + 3 * place)
        heat.notes[STEP_NOTES + 3 * place] = -length


@kernel
def prepare(heat, place, length):
    """Make the step at `place` one of `length` [s], unless it is already."""
    entry = STEP_NOTES + 3 * place
    if heat.kind == NO_HEATING or heat.notes[entry] == length:
        return
    fade = _STEPS + 3 * place
    if heat.notes[entry] != -length:
        fill_fade(heat.bank, RATES, length, fade)
    fill_weights(heat.bank, RATES, WEIGHTS, length, fade)
    heat.notes[entry] = length
    opening, closing = 0.0, 0.0
    for j in range(MODES):
        opening += heat.bank[fade + 1, j]
        closing += heat.bank[fade + 2, j]
    heat.notes[entry + 1] = opening
    heat.notes[entry + 2] = closing


@kernel
def is_prepared(heat, place, length):
    """Whether the step at `place` has that length [s]."""
    return heat.kind == NO_HEATING or heat.notes[STEP_NOTES + 3 * place] == length


@kernel
def _feels_flux(heat, portion, displacement):
    """Whether the common modes of a plate are heated: Eq. (12) for the centre of the plate, always for the line."""
    return heat.kind == LINE or abs(portion * displacement) <= heat.half_contact


@kernel
def expect(heat, structure, place, displacement, travel, flux_start, flux_end):
    """Note the temperatures to expect at the end of a step, without taking it.

    `displacement` [mm] is in the middle of the step and `travel` [mm] over it; fluxes are mu p |v| [N/(mm s)].
    """
    notes, bank = heat.notes, heat.bank
    fade, entry = _STEPS + 3 * place, STEP_NOTES + 3 * place
    for i in range(structure.plates):
        rise = 0.0
        if heat.kind != NO_HEATING:
            portion = share(structure, i)
            first = plate.FIRST_ROW + i * plate.ROWS
            rise = faded_total(bank, fade, first + plate.COMMON)
            if _feels_flux(heat, portion, displacement):
                rise += portion * (
                    notes[entry + 1] * flux_start + (notes[entry + 2] + heat.instant) * flux_end
                )
            if heat.kind == LINE:
                swept = plate.expect_sweep(heat, i, portion * travel)
                inside = faded_total(bank, fade, first + plate.INSIDE)
                rise += (inside + swept) / (2.0 * heat.half_contact)
        notes[EXPECTED + i] = heat.ambient + rise


@kernel
def expect_cooling(heat, structure, place):
    """Note the temperatures to expect at the end of a step without sliding, without taking it."""
    fade = _STEPS + 3 * place
    for i in range(structure.plates):
        rise = 0.0
        if heat.kind != NO_HEATING:
            first = plate.FIRST_ROW + i * plate.ROWS
            rise = faded_total(heat.bank, fade, first + plate.COMMON)
            if heat.kind == LINE:
                rise += faded_total(heat.bank, fade, first + plate.INSIDE) / (2.0 * heat.half_contact)
        heat.notes[EXPECTED + i] = heat.ambient + rise


@kernel
def mix(heat, structure, part):
    """Note the temperatures at a `part` of the way from the present to the expected ones."""
    notes = heat.notes
    for i in range(structure.plates):
        notes[BETWEEN + i] = notes[PRESENT + i] + part * (notes[EXPECTED + i] - notes[PRESENT + i])


@kernel
def heat_up(heat, structure, place, time, length, displacement, middle, flux_start, flux_end):
    """Take a sliding step of `length` [s] to `time` [s] and `displacement` [mm]; return False where the cells end.

    `middle` [mm] is the displacement inside the step, from which contact with the centre is judged.
    """
    if heat.kind == NO_HEATING:
        return True
    fade = _STEPS + 3 * place
    fits = True
    for i in range(structure.plates):
        portion = share(structure, i)
        felt = portion if _feels_flux(heat, portion, middle) else 0.0
        first = plate.FIRST_ROW + i * plate.ROWS
        if heat.kind == LINE:
            # half of the way before the heat and half after it: second order in the step
            fits = plate.sweep_to(heat, RATES, i, time - length, portion * middle) and fits
        rise = feed(heat.bank, fade, first + plate.COMMON, felt * flux_start, felt * flux_end)
        rise += heat.instant * felt * flux_end
        if heat.kind == LINE:
            plate.fade_edges(heat, fade, i)
            let_fade(heat.bank, fade, first + plate.INSIDE)
            fits = plate.sweep_to(heat, RATES, i, time, portion * displacement) and fits
            rise += plate.mean_difference(heat, i)
        heat.notes[PRESENT + i] = heat.ambient + rise
    return fits


@kernel
def cool_down(heat, structure, place):
    """Take a step without sliding: everything fades."""
    if heat.kind == NO_HEATING:
        return
    fade = _STEPS + 3 * place
    for i in range(structure.plates):
        first = plate.FIRST_ROW + i * plate.ROWS
        rise = let_fade(heat.bank, fade, first + plate.COMMON)
        if heat.kind == LINE:
            plate.fade_edges(heat, fade, i)
            rise += let_fade(heat.bank, fade, first + plate.INSIDE) / (2.0 * heat.half_contact)
        heat.notes[PRESENT + i] = heat.ambient + rise

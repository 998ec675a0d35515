r"""Temperature of the sliding contact from the heat of friction, Eqs (11) and (12) of Li et al. (2020).

Three models share one interface:

* ``NO_HEATING``: the ambient temperature;
* ``POINT``: one monitoring point at the centre of the plate (the simplified model);
* ``LINE``: every point along the sliding direction, averaged over the contact (the precise model, in `plate`).
"""

from dcfp.kernels import plate
from dcfp.kernels._jit import kernel
from dcfp.kernels.heat_state import (
    COMMON,
    DOSE,
    EXPECTED,
    INSIDE,
    LINE,
    NO_HEATING,
    PLATE_ROW,
    PLATE_ROWS,
    PRESENT,
    RATES,
    RATIO,
    STEP_NOTE,
    STEP_NOTES,
    STEP_ROW,
    STEP_ROWS,
    WEIGHTS,
    Heat,
)
from dcfp.kernels.memory import faded_total, feed, fill_fade, fill_weights, let_fade, total
from dcfp.kernels.motion import Structure, share, speed_factor


@kernel
def prepare_cooling(heat: Heat, place: int, length: float) -> None:
    """Make the step at `place` one of `length` [s] that can only cool, unless it is already."""
    if heat.kind != NO_HEATING and abs(heat.notes[STEP_NOTE + STEP_NOTES * place]) != length:
        fill_fade(heat.bank, RATES, length, STEP_ROW + STEP_ROWS * place)
        heat.notes[STEP_NOTE + STEP_NOTES * place] = -length


@kernel
def prepare(heat: Heat, place: int, length: float) -> None:
    """Make the step at `place` one of `length` [s], unless it is already."""
    entry = STEP_NOTE + STEP_NOTES * place
    if heat.kind == NO_HEATING or heat.notes[entry] == length:
        return
    fade = STEP_ROW + STEP_ROWS * place
    if heat.notes[entry] != -length:
        fill_fade(heat.bank, RATES, length, fade)
    fill_weights(heat.bank, RATES, WEIGHTS, length, fade)
    heat.notes[entry] = length
    heat.notes[entry + 1] = total(heat.bank, fade + 1)
    heat.notes[entry + 2] = total(heat.bank, fade + 2)


@kernel
def _feels_flux(heat: Heat, portion: float, displacement: float) -> bool:
    """Whether the common modes of a plate are heated: Eq. (12) for the centre of the plate, always for the line."""
    return heat.kind == LINE or abs(portion * displacement) <= heat.half_contact


@kernel
def expect(
    heat: Heat,
    structure: Structure,
    place: int,
    time: float,
    displacement: float,
    travel: float,
    flux_start: float,
    flux_end: float,
    rubbing: float,
) -> None:
    """Note the temperatures and doses to expect at the end of a step, without taking it.

    `time` [s] is at its start, `displacement` [mm] in its middle and `travel` [mm] over it; fluxes are mu p |v|
    [N/(mm s)], of which a plate gets its share, in the ratio of its coefficient to the mean; `rubbing` is p v2 over
    the step at the relative speed [N/s].
    """
    notes, bank = heat.notes, heat.bank
    fade, entry = STEP_ROW + STEP_ROWS * place, STEP_NOTE + STEP_NOTES * place
    for i in range(structure.plates):
        rise = heat.ambient
        if heat.kind != NO_HEATING:
            portion = share(structure, i)
            first = PLATE_ROW + i * PLATE_ROWS
            rise += faded_total(bank, fade, first + COMMON)
            if _feels_flux(heat, portion, displacement):
                rise += (
                    portion
                    * notes[RATIO + i]
                    * (notes[entry + 1] * flux_start + (notes[entry + 2] + heat.instant) * flux_end)
                )
            if heat.kind == LINE:
                swept = plate.expect_sweep(heat, i, time, portion * travel)
                inside = faded_total(bank, fade, first + INSIDE)
                rise += (inside + swept) / (2.0 * heat.half_contact)
        notes[EXPECTED + i] = rise
        notes[EXPECTED + DOSE + i] = notes[PRESENT + DOSE + i] + speed_factor(structure, i) ** 2 * rubbing


@kernel
def expect_cooling(heat: Heat, structure: Structure, place: int) -> None:
    """Note the temperatures to expect at the end of a step without sliding, without taking it."""
    fade = STEP_ROW + STEP_ROWS * place
    for i in range(structure.plates):
        rise = 0.0
        if heat.kind != NO_HEATING:
            first = PLATE_ROW + i * PLATE_ROWS
            rise = faded_total(heat.bank, fade, first + COMMON)
            if heat.kind == LINE:
                rise += faded_total(heat.bank, fade, first + INSIDE) / (2.0 * heat.half_contact)
        heat.notes[EXPECTED + i] = heat.ambient + rise
        heat.notes[EXPECTED + DOSE + i] = heat.notes[PRESENT + DOSE + i]


@kernel
def mix(heat: Heat, structure: Structure, part: float, entry: int) -> None:
    """Note at `entry` the temperatures and doses at a `part` of the way from the present to the expected ones."""
    notes = heat.notes
    for i in range(structure.plates):
        for quantity in (0, DOSE):
            present = notes[PRESENT + quantity + i]
            notes[entry + quantity + i] = present + part * (notes[EXPECTED + quantity + i] - present)


@kernel
def heat_up(
    heat: Heat,
    structure: Structure,
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
    for i in range(structure.plates):
        heat.notes[PRESENT + DOSE + i] += speed_factor(structure, i) ** 2 * rubbing
    if heat.kind == NO_HEATING:
        return True
    fade = STEP_ROW + STEP_ROWS * place
    fits = True
    for i in range(structure.plates):
        portion = share(structure, i)
        felt = portion * heat.notes[RATIO + i] if _feels_flux(heat, portion, middle) else 0.0
        first = PLATE_ROW + i * PLATE_ROWS
        if heat.kind == LINE:
            # half of the way before the heat and half after it: second order in the step
            fits = plate.sweep_to(heat, i, time - length, portion * middle) and fits
        rise = feed(heat.bank, fade, first + COMMON, felt * flux_start, felt * flux_end)
        rise += heat.instant * felt * flux_now
        if heat.kind == LINE:
            plate.fade_edges(heat, fade, i)
            let_fade(heat.bank, fade, first + INSIDE)
            fits = plate.sweep_to(heat, i, time, portion * displacement) and fits
            rise += plate.mean_difference(heat, i)
        heat.notes[PRESENT + i] = heat.ambient + rise
    return fits


@kernel
def cool_down(heat: Heat, structure: Structure, place: int) -> None:
    """Take a step without sliding: everything fades."""
    if heat.kind == NO_HEATING:
        return
    fade = STEP_ROW + STEP_ROWS * place
    for i in range(structure.plates):
        first = PLATE_ROW + i * PLATE_ROWS
        rise = let_fade(heat.bank, fade, first + COMMON)
        if heat.kind == LINE:
            plate.fade_edges(heat, fade, i)
            rise += let_fade(heat.bank, fade, first + INSIDE) / (2.0 * heat.half_contact)
        heat.notes[PRESENT + i] = heat.ambient + rise


@kernel
def place_slider(heat: Heat, structure: Structure, time: float, displacement: float) -> bool:
    """Move the slider to a displacement [mm] without friction, at a time [s]; return False where the cells end."""
    fits = True
    if heat.kind != LINE:
        return fits
    for i in range(structure.plates):
        fits = plate.sweep_to(heat, i, time, share(structure, i) * displacement) and fits
        rise = total(heat.bank, PLATE_ROW + i * PLATE_ROWS + COMMON) + plate.mean_difference(heat, i)
        heat.notes[PRESENT + i] = heat.ambient + rise
    return fits

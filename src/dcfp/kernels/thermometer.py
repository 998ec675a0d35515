"""Temperature of the contact along a motion whose heat is known, as it is where force and displacement were measured."""

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel
from dcfp.kernels.heat_state import NO_HEATING, ODD_LENGTH, POINT, PRESENT, Heat
from dcfp.kernels.heating import heat_up, place_slider, prepare
from dcfp.kernels.motion import Structure, share


@kernel
def follow_heat(
    structure: Structure,
    heat: Heat,
    lengths: NDArray[np.float64],
    displacement: NDArray[np.float64],
    flux: NDArray[np.float64],
    temperatures: NDArray[np.float64],
) -> bool:
    """Write the temperature of each plate [degC] at every sample; return False where the cells end.

    Between samples, `lengths` [s] apart, `displacement` [mm] and `flux`, mu p |v| [N/(mm s)], are linear. Row i of `temperatures` is at
    sample i.
    """
    time = 0.0
    fits = place_slider(heat, structure, time, displacement[0])
    for j in range(structure.plates):
        temperatures[0, j] = heat.notes[PRESENT + j]
    for i in range(lengths.size):
        interval = lengths[i]
        done = 0.0
        while done < 1.0:
            end = _until_edge(heat, structure, displacement[i], displacement[i + 1], done)
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
                    heat,
                    structure,
                    place,
                    time + end * interval,
                    length,
                    there,
                    middle,
                    first,
                    last,
                    last,
                    0.0,
                )
                and fits
            )
            done = end
        time += interval
        for j in range(structure.plates):
            temperatures[i + 1, j] = heat.notes[PRESENT + j]
    return fits


@kernel
def _until_edge(heat: Heat, structure: Structure, start: float, stop: float, done: float) -> float:
    """Return the part of the step up to where a plate's monitoring point next comes under the slider or leaves it: Eq. (12)."""
    nearest = 1.0
    if heat.kind != POINT or start == stop:
        return nearest
    for j in range(structure.plates):
        edge = heat.half_contact / share(structure, j)
        for target in (edge, -edge):
            part = (target - start) / (stop - start)
            # what is left of the step must be worth a step
            if done + 1e-9 < part < nearest - 1e-9:
                nearest = part
    return nearest

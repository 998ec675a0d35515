"""Temperature of the contact in a test, from the heat that was measured and not from a law of friction."""

import numpy as np
from numpy.typing import NDArray

from dcfp.arrays import FloatArray, equally_spaced
from dcfp.errors import AnalysisError
from dcfp.kernels.heat_state import ODD_LENGTH, STEP_NOTE, STEP_NOTES
from dcfp.kernels.heating import prepare
from dcfp.kernels.thermometer import follow_heat
from dcfp.system import Bearing, Heating
from dcfp.system.friction import FittedFriction
from dcfp.system.plates import PlateHeat, cold_plates, heat_of, horizon_for, mean_temperature, structure_of

#: Samples from the first that is used on, whose middle tells the force at which sliding begins.
_AT_YIELD = 9
#: Weights of the second and the first neighbours on either side, which give a cubic at the sample between them [-].
_SECOND, _FIRST = -1.0 / 6.0, 4.0 / 6.0


def contact_temperature(
    time: FloatArray,
    displacement: FloatArray,
    velocity: FloatArray,
    friction_force: FloatArray,
    used: NDArray[np.bool_],
    bearing: Bearing,
    heating: Heating,
) -> FloatArray:
    """Return the temperature of the contact [degC] under the measured flux, the friction force times the velocity over the slider's area.

    Parameters
    ----------
    time, displacement, velocity
        The motion, without its noise [s, mm, mm/s].
    friction_force
        F - N y / R, as it was measured [N].
    used
        Samples of steady sliding.
    bearing, heating
        What was tested, and how it heats up; it starts at the ambient temperature.

    Notes
    -----
    The noise of a sample's force would heat that sample: its coefficient and its temperature would rise together, and the fall with temperature
    would seem less steep than it is, by 0.7 % instead of 0.3 % where two cycles of 440 mm at up to 400 mm/s have 2 % of noise. In what a sample heats at itself its own force
    is therefore replaced by what its neighbours say of it.
    """
    flux = friction_force * velocity / bearing.slider_area
    _leave_out_loading(
        flux,
        displacement,
        friction_force / bearing.elastic_stiffness,
        int(np.argmax(used)) if used.any() else 1,
    )
    plates = cold_plates(
        bearing,
        heating,
        reach=float(np.abs(displacement).max()),
        horizon=horizon_for(float(time[-1])),
    )
    structure = structure_of(bearing, FittedFriction())
    temperatures = np.empty((time.size, structure.plates))
    steps = np.diff(time)
    if equally_spaced(time):
        steps = np.full(steps.size, float(np.median(steps)))  # equal steps are prepared once
    own = _rise_by_own_flux(steps, displacement, plates, bearing, heating)
    if not follow_heat(structure, heat_of(plates, bearing, heating), steps, displacement, flux, temperatures):
        msg = (
            "The slider leaves the cells of the precise heating model; look at the unit of the displacement."
        )
        raise AnalysisError(msg)
    mean = mean_temperature(bearing, temperatures)
    return mean - own * _noise(friction_force, used) * velocity / bearing.slider_area


def _leave_out_loading(
    flux: FloatArray, displacement: FloatArray, elongation: FloatArray, first: int
) -> None:
    """Take out of the flux what only loads spring (b) at the start, where the force rises from nothing, before the `first` sample that is used.

    The travel until the spring has the `elongation` [mm] of sliding gives no heat. In the step in which the slider yields, the rest of the travel is
    sliding under the force at its end; the flux at its beginning becomes what makes the heat of the steps on either side right.
    """
    if first == 0:
        return
    yielding = float(np.median(np.abs(elongation[first : first + _AT_YIELD])))
    if abs(elongation[0]) > 0.5 * yielding:
        return  # it slid before the file begins
    travel = np.abs(displacement[: first + 1] - displacement[0])
    last = max(int(np.argmax(travel >= yielding)) - 1, 0) if travel[-1] >= yielding else first - 1
    flux[:last] = 0.0
    step = float(travel[last + 1] - travel[last])
    sliding = float(travel[last + 1]) - abs(float(elongation[last + 1]))
    part = min(max(sliding / step, 0.0), 1.0) if step > 0.0 else 0.0
    flux[last] = float(flux[last + 1]) * (2.0 * part - 1.0 if last == 0 else part - 0.5)


def _noise(values: FloatArray, used: NDArray[np.bool_]) -> FloatArray:
    """Return how far each value is from the cubic through two neighbours on either side; zero where one of them is not used."""
    noise = np.zeros(values.size)
    among = used[:-4] & used[1:-3] & used[2:-2] & used[3:-1] & used[4:]
    expected = _SECOND * (values[:-4] + values[4:]) + _FIRST * (values[1:-3] + values[3:-1])
    noise[2:-2] = np.where(among, values[2:-2] - expected, 0.0)
    return noise


def _rise_by_own_flux(
    steps: FloatArray, displacement: FloatArray, plates: PlateHeat, bearing: Bearing, heating: Heating
) -> FloatArray:
    """Return by how much a flux at a sample alone heats the contact there, over the flux mu p v [degC mm s/N]."""
    if heating.name == "none":
        return np.zeros(displacement.size)
    lengths, place = np.unique(steps, return_inverse=True)
    heat = heat_of(plates.copy(), bearing, heating)
    closing = np.empty(lengths.size)
    for n, length in enumerate(lengths.tolist()):
        prepare(heat, ODD_LENGTH, length)
        closing[n] = heat.notes[STEP_NOTE + STEP_NOTES * ODD_LENGTH + 2] + heat.instant
    rise = np.concatenate(([0.0], closing[place]))
    felt = np.zeros(displacement.size)
    for share in bearing.shares:
        # of two plates each gets its share of the flux, and has its share in the mean
        inside = heating.name != "simplified" or np.abs(share * displacement) <= bearing.contact_half_side
        felt += np.where(
            inside, share * share if len(set(bearing.shares)) > 1 else share / len(bearing.shares), 0.0
        )
    return rise * felt

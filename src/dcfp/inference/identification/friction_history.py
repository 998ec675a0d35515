"""From a measured loop to the history of the coefficient of friction, and of what it may depend on."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from dcfp.analysis.rig import Measurement
from dcfp.analysis.rig.program import check_load
from dcfp.arrays import FloatArray, equally_spaced, freeze
from dcfp.errors import AnalysisError, InputError
from dcfp.inference.identification.smoothing import Smoothed, find_strokes, smooth
from dcfp.kernels.heat_state import ODD_LENGTH, STEP_ENTRIES, STEP_ENTRY
from dcfp.kernels.heating import prepare, surface_temperature
from dcfp.schema.notebook import card
from dcfp.system import Heating, System, SystemLike
from dcfp.system.plates import (
    PlateHeat,
    cold_plates,
    heat_of,
    horizon_for,
    mean_temperature,
    system_constants,
)

#: Order of the polynomials that displacement and load are smoothed with.
_DISPLACEMENT_ORDER, _LOAD_ORDER = 4, 2
#: Root mean square over the mean load of what is scatter of the load, where one parabola goes through each stroke [-].
_LOAD_SCATTER = 0.03
#: Least length of a stroke over the largest displacement [-].
_LEAST_STROKE = 0.02
#: Speed over the peak speed of the test above which samples are used [-].
_LEAST_SPEED = 0.05
#: Distance from a reversal from which on samples are used, over the one in which spring (b) goes from one yield force to the other [-].
_CLEAR = 2.0
_FEWEST_SAMPLES = 20
#: Mean coefficients while sliding that a wrong unit of the force would leave [-].
_COEFFICIENTS = (1e-3, 1.0)


@dataclass(frozen=True, eq=False)
class FrictionHistory:
    """What one test tells of friction; arrays have the shape (n,) of the measured ones.

    Attributes
    ----------
    measurement
        Where it comes from.
    coefficient
        (F - N y / R) / N, positive against the sliding [-].
    displacement, speed
        Without noise [mm, mm/s]; the speed is that of the plates against each other, and positive.
    load, pressure
        Vertical force, without noise [N], and over the slider's area [N/mm2].
    temperature
        Of the contact, from the measured heat [degC].
    stroke
        Number of the stroke of each sample, -1 in none.
    used
        Whether a sample tells of sliding: not near a reversal, where spring (b) sticks, and not slower than 5 % of the peak speed.
    speed_window, load_window
        Length of the filter that speed and load come from [samples].
    """

    measurement: Measurement
    coefficient: FloatArray
    displacement: FloatArray
    speed: FloatArray
    load: FloatArray
    pressure: FloatArray
    temperature: FloatArray
    stroke: NDArray[np.int64]
    used: NDArray[np.bool_]
    speed_window: int
    load_window: int

    @property
    def name(self) -> str:
        """Name of the test."""
        return self.measurement.name

    @property
    def time(self) -> FloatArray:
        """Time [s]."""
        return self.measurement.time

    def _repr_html_(self) -> str:
        facts = {"samples used": int(self.used.sum()), "of": self.used.size}
        return card(f"Friction in {self.name}", facts)


def friction_history(
    measurement: Measurement, bearing: SystemLike = None, heating: Heating | str | None = None
) -> FrictionHistory:
    r"""Take the friction out of a measured loop.

    .. math:: \mu = \pm \frac{F - N y / R}{N}

    Parameters
    ----------
    measurement
        With force and load.
    bearing
        That was tested; its pressure is not used.
    heating
        Gives the temperature from the flux of heat that was measured, (F - N y / R) v over the slider's area, and not from a law of friction.
        The plates start at its ambient temperature.

    Raises
    ------
    InputError
        If the measurement has no force or no load, nothing slides, or the force has the wrong sign or unit.

    Notes
    -----
    Speed and displacement come from polynomials of the fourth order in a moving window, whose length follows the noise and the sampling (`smooth`);
    each stroke is smoothed by itself, so that a corner of the motion stays one. The load is a parabola over each stroke where that is within 3 %
    of the mean load, else smoothed in the same way. It has to be: the reciprocal of a load with 2 % of noise is 0.04 % too large in the
    mean. The force enters once, in the numerator, and stays as it is.

    On two plates that differ, both are taken to have the coefficient of the whole bearing, and the temperature is the mean by their share of the travel.
    """
    system = System.of(bearing, None, heating)
    bearing = system.bearing
    time, force, displacement = measurement.time, measurement.force, measurement.displacement
    check_load(measurement.load, bearing)
    strokes = find_strokes(displacement, _LEAST_STROKE * float(np.abs(displacement).max()))
    motion = smooth(displacement, time, strokes, _DISPLACEMENT_ORDER)
    scatter = _LOAD_SCATTER * float(measurement.load.mean())
    load = smooth(measurement.load, time, strokes, _LOAD_ORDER, scatter)
    friction_force = force - load.values * motion.values / bearing.effective_radius
    number = np.full(time.size, -1, dtype=np.int64)
    side = np.sign(motion.slope)
    for i, stroke in enumerate(strokes):
        number[stroke] = i
        side[stroke] = np.sign(displacement[stroke.stop - 1] - displacement[stroke.start])
    coefficient = side * friction_force / load.values
    used = _sliding(motion, side, number, coefficient, load.values / bearing.elastic_stiffness, strokes)
    if np.count_nonzero(used) < _FEWEST_SAMPLES:
        msg = (
            f"{measurement.name}: only {np.count_nonzero(used)} samples are of steady sliding, and {_FEWEST_SAMPLES} are needed; the stroke must go"
            " beyond the elastic deformation of the bearing (look at its stiffness before sliding and at the unit of the force), and be sampled finely."
        )
        raise InputError(msg)
    _check_size(coefficient[used], (coefficient * load.values * side * motion.slope)[used], measurement.name)
    temperature = contact_temperature(time, motion, friction_force, used, system)
    return FrictionHistory(
        measurement=measurement,
        coefficient=freeze(coefficient),
        displacement=freeze(motion.values),
        speed=freeze(np.abs(motion.slope)),
        load=freeze(load.values),
        pressure=freeze(load.values / bearing.slider_area),
        temperature=freeze(temperature),
        stroke=number,
        used=used,
        speed_window=motion.window,
        load_window=load.window,
    )


def _check_size(coefficient: FloatArray, power: FloatArray, name: str) -> None:
    """Refuse a force that helps the sliding [power in N mm/s], or whose coefficient is none of a bearing."""
    mean = float(coefficient.mean())
    if mean <= 0.0 or float(power.mean()) <= 0.0:
        msg = f"{name}: the force helps the sliding instead of opposing it; change the sign of the force or of the displacement."
        raise InputError(msg)
    if not _COEFFICIENTS[0] <= mean <= _COEFFICIENTS[1]:
        msg = (
            f"{name}: the mean coefficient of friction while sliding is {mean:.3g}, and from {_COEFFICIENTS[0]:g} to {_COEFFICIENTS[1]:g} is possible;"
            " look at the units of force and load."
        )
        raise InputError(msg)


def _sliding(
    motion: Smoothed,
    side: FloatArray,
    number: NDArray[np.int64],
    coefficient: FloatArray,
    reach: FloatArray,
    strokes: list[slice],
) -> NDArray[np.bool_]:
    """Return which samples are used; `reach` is the elongation of spring (b) under a coefficient of one [mm]."""
    speed = side * motion.slope
    inside = number >= 0
    if not inside.any():
        return inside
    peak = float(speed[inside].max())
    fast = inside & (speed > 0.5 * peak)
    swing = 2.0 * float(np.median((coefficient * reach)[fast]))
    moved = np.zeros(speed.size)
    for stroke in strokes:
        moved[stroke] = np.abs(motion.values[stroke] - motion.values[stroke.start])
    return inside & (speed > _LEAST_SPEED * peak) & (moved > _CLEAR * swing)


# Temperature of the contact in a test, from the heat that was measured and not from a law of friction.


#: Samples from the first that is used on, whose middle tells the force at which sliding begins.
_AT_YIELD = 9
#: Weights of the second and the first neighbours on either side, which give a cubic at the sample between them [-].
_SECOND, _FIRST = -1.0 / 6.0, 4.0 / 6.0


def contact_temperature(
    time: FloatArray,
    motion: Smoothed,
    friction_force: FloatArray,
    used: NDArray[np.bool_],
    system: System,
) -> FloatArray:
    """Return the temperature of the contact [degC] under the measured flux, the friction force times the velocity over the slider's area.

    Parameters
    ----------
    time, motion
        The motion, without its noise [s, mm, mm/s].
    friction_force
        F - N y / R, as it was measured [N].
    used
        Samples of steady sliding.
    system
        The bearing that was tested, and how it heats up; it starts at the ambient temperature.

    Notes
    -----
    The noise of a sample's force would heat that sample: its coefficient and its temperature would rise together, and the fall with temperature
    would seem less steep than it is, by 0.7 % instead of 0.3 % where two cycles of 440 mm at up to 400 mm/s have 2 % of noise. In what a sample heats at itself its own force
    is therefore replaced by what its neighbours say of it.
    """
    bearing, displacement = system.bearing, motion.values
    flux = friction_force * motion.slope / bearing.slider_area
    first = int(np.argmax(used)) if used.any() else 1
    _leave_out_loading(flux, displacement, friction_force / bearing.elastic_stiffness, first)
    plates = cold_plates(
        system, reach=float(np.abs(displacement).max()), horizon=horizon_for(float(time[-1]))
    )
    constants = system_constants(system)
    temperatures = np.empty((time.size, constants.plates))
    steps = np.diff(time)
    if equally_spaced(time):
        steps = np.full(steps.size, float(np.median(steps)))  # equal steps are prepared once
    own = _rise_by_own_flux(steps, displacement, plates, system)
    heat = heat_of(plates, system)
    if not surface_temperature(constants, heat, steps, displacement, flux, temperatures):
        msg = (
            "The slider leaves the cells of the precise heating model; look at the unit of the displacement."
        )
        raise AnalysisError(msg)
    mean = mean_temperature(bearing, temperatures)
    return mean - own * _noise(friction_force, used) * motion.slope / bearing.slider_area


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
    steps: FloatArray, displacement: FloatArray, plates: PlateHeat, system: System
) -> FloatArray:
    """Return by how much a flux at a sample alone heats the contact there, over the flux mu p v [degC mm s/N]."""
    bearing, heating = system.bearing, system.heating
    if heating.name == "none":
        return np.zeros(displacement.size)
    lengths, place = np.unique(steps, return_inverse=True)
    heat = heat_of(plates.with_room(0), system)
    closing = np.empty(lengths.size)
    for n, length in enumerate(lengths.tolist()):
        prepare(heat, ODD_LENGTH, length)
        closing[n] = heat.workspace[STEP_ENTRY + STEP_ENTRIES * ODD_LENGTH + 2] + heat.instant
    rise = np.concatenate(([0.0], closing[place]))
    felt = np.zeros(displacement.size)
    for share in bearing.shares:
        # of two plates each gets its share of the flux, and has its share in the mean
        inside = heating.name != "simplified" or np.abs(share * displacement) <= bearing.contact_half_side
        felt += np.where(
            inside, share * share if len(set(bearing.shares)) > 1 else share / len(bearing.shares), 0.0
        )
    return rise * felt

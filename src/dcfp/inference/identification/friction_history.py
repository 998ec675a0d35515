"""From a measured loop to the history of the coefficient of friction, and of what it may depend on."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.polynomial.legendre import legder, legval, legvander
from numpy.typing import NDArray
from scipy.interpolate import PchipInterpolator

from dcfp.analysis.rig import Measurement
from dcfp.analysis.rig.program import check_load
from dcfp.arrays import FloatArray, equally_spaced, freeze
from dcfp.errors import AnalysisError, InputError
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


@dataclass(frozen=True)
class Smoothed:
    """A history without its noise, its derivative by time, and the length of the filter [samples]; zero for none."""

    values: FloatArray
    slope: FloatArray
    window: int


@dataclass(frozen=True, eq=False)
class FrictionHistory:
    """What one test tells of friction; arrays have the shape (n,) of the measured ones.

    Attributes
    ----------
    coefficient
        (F - N y / R) / N, positive against the sliding [-].
    displacement, speed, load, pressure
        Without noise [mm, mm/s, N, N/mm2]; the speed is that of the plates against each other, and positive.
    temperature
        Of the contact, from the measured heat [degC].
    stroke, used
        Number of the stroke of each sample, -1 in none; and whether it tells of sliding: not near a reversal,
        where spring (b) sticks, and not slower than 5 % of the peak speed.
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
        Gives the temperature from the flux of heat that was measured, (F - N y / R) v over the slider's area,
        and not from a law of friction. The plates start at its ambient temperature.

    Raises
    ------
    InputError
        If the measurement has no force or no load, nothing slides, or the force has the wrong sign or unit.

    Notes
    -----
    Displacement and speed come from polynomials of the fourth order in a moving window, stroke by stroke, so that a
    corner of the motion stays one. The load is a parabola over each stroke where that is within 3 % of the mean load,
    else smoothed in the same way: the reciprocal of a load with 2 % of noise is 0.04 % too large in the mean. Two
    plates that differ are taken to have the coefficient of the whole bearing, and the temperature is the mean by their
    share of the travel.
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

    The noise of a sample's force would heat that sample, and the fall with temperature would seem less steep
    than it is, by 0.7 % instead of 0.3 % where two cycles of 440 mm at up to 400 mm/s have 2 % of noise. In
    what a sample heats at itself its own force is therefore replaced by what its neighbours say of it.
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
    """Take out of the flux what only loads spring (b), to the `elongation` of sliding, before the `first` sample used.

    In the step in which the slider yields, the rest of the travel is sliding under the force at its end; the
    flux at its beginning becomes what makes the heat of the steps on either side right.
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
    """Return how far each value is from the cubic through two neighbours on either side, zero where one is not used."""
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


#: Windows of the filter that are tried [samples].
_WINDOWS = (5, 7, 9, 13, 17, 23, 31, 41, 55, 73, 97, 129, 173, 231, 309, 411, 549, 731, 975, 1301, 1735)


def find_strokes(displacement: FloatArray, least: float) -> list[slice]:
    """Return the parts between reversals, from turn to turn, of motions of at least `least` [mm].

    A turn belongs to the stroke that ends with it.
    """
    y = displacement.tolist()
    turns = [0]
    furthest, direction = 0, 0
    for i, value in enumerate(y):
        step = value - y[furthest]
        if direction == 0:
            if abs(value - y[0]) >= least:
                direction, furthest = (1 if value > y[0] else -1), i
        elif direction * step >= 0.0:
            furthest = i
        elif direction * step <= -least:
            turns.append(furthest)
            direction, furthest = -direction, i
    # what comes after the last turn is a stroke if it goes far enough, up to its furthest point
    last = [] if direction == 0 else [furthest]
    bounds = [*turns, *last]
    firsts = [0, *(turn + 1 for turn in bounds[1:-1])]
    return [slice(first, end + 1) for first, end in zip(firsts, bounds[1:], strict=False)]


def smooth(
    values: FloatArray, time: FloatArray, parts: Sequence[slice], order: int, scatter: float = 0.0
) -> Smoothed:
    """Fit polynomials of an `order` to `values` in a window that moves through each part: Savitzky and Golay (1964).

    Where one polynomial for each part leaves a root mean square of no more than `scatter`, the window is the
    part. Else it is the one with the least generalised cross-validation (Craven and Wahba 1979). At the ends
    of a part the polynomial of the last whole window goes on. What belongs to no part, or to one too short,
    stays as it is.
    """
    long_parts = [part for part in parts if part.stop - part.start >= order + 3]
    smoothed = values.copy()
    slope = np.gradient(values, time)
    if not long_parts:
        return Smoothed(smoothed, slope, 0)
    uniform = equally_spaced(time)
    even = values.copy()
    grids: dict[int, FloatArray] = {}
    if not uniform:  # they are read off a curve through them at as many times that are evenly spaced
        for part in long_parts:
            first, last = float(time[part.start]), float(time[part.stop - 1])
            grids[part.start] = np.linspace(first, last, part.stop - part.start)
            even[part] = PchipInterpolator(time[part], values[part])(grids[part.start])
    window = max(part.stop - part.start for part in long_parts)
    if _residual(even, long_parts, order, window)[0] > scatter**2:
        window = _best_window(even, long_parts, order)
    for part in long_parts:
        moving = _moving_polynomial(_fitting(window, part, order), order)
        pace = float(time[part.stop - 1] - time[part.start]) / (part.stop - part.start - 1)
        found = np.stack(
            (
                moving.at_samples(even[part], moving.basis),
                moving.at_samples(even[part], moving.change) / pace,
            ),
            axis=1,
        )
        if grids:
            found = PchipInterpolator(grids[part.start], found)(time[part])
        smoothed[part], slope[part] = found[:, 0], found[:, 1]
    return Smoothed(smoothed, slope, window)


def _fitting(window: int, part: slice, order: int) -> int:
    """Return the window, or the longest that a part has room for."""
    room = part.stop - part.start
    return max(min(window, room - 1 + room % 2), order + 1 + order % 2)


def _best_window(values: FloatArray, parts: Sequence[slice], order: int) -> int:
    longest = max(part.stop - part.start for part in parts)
    tried = [window for window in _WINDOWS if order + 2 <= window <= longest] or [longest - 1 + longest % 2]

    def cross_validation(window: int) -> float:
        square, freedom = _residual(values, parts, order, window)
        return square / (1.0 - freedom) ** 2

    return min(tried, key=cross_validation)


def _residual(values: FloatArray, parts: Sequence[slice], order: int, window: int) -> tuple[float, float]:
    """Return the mean squared residual, and the part of the freedom of the samples that the polynomials take [-]."""
    squares, freedom, count = 0.0, 0.0, 0
    for part in parts:
        moving = _moving_polynomial(_fitting(window, part, order), order)
        piece = values[part]
        residual = piece - moving.at_samples(piece, moving.basis)
        squares += float(residual @ residual)
        freedom += moving.freedom(piece.size)
        count += piece.size
    return squares / count, freedom / count


@dataclass(frozen=True)
class _MovingPolynomial:
    """Orthonormal polynomials over a window, shape (window, order + 1), and their derivatives by the sample."""

    basis: FloatArray
    change: FloatArray

    def at_samples(self, samples: FloatArray, kind: FloatArray) -> FloatArray:
        """Return the polynomials at the samples; their derivatives where the `kind` is `change` and not `basis`."""
        window = self.basis.shape[0]
        half = window // 2
        return np.concatenate(
            (
                kind[:half] @ (self.basis.T @ samples[:window]),
                np.convolve(samples, (self.basis @ kind[half])[::-1], "valid"),
                kind[half + 1 :] @ (self.basis.T @ samples[-window:]),
            )
        )

    def freedom(self, count: int) -> float:
        """Return the trace of the filter for so many samples."""
        window, order = self.basis.shape
        half = window // 2
        return (count - window) * float(self.basis[half] @ self.basis[half]) + order


@lru_cache(maxsize=128)
def _moving_polynomial(window: int, order: int) -> _MovingPolynomial:
    place = np.linspace(-1.0, 1.0, window)
    raw = legvander(place, order)
    basis, change = np.linalg.qr(raw)
    slopes = np.stack([legval(place, legder(row)) for row in np.eye(order + 1)], axis=1)
    return _MovingPolynomial(basis, slopes @ np.linalg.inv(change) * (2.0 / (window - 1)))

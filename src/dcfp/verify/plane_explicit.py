r"""The plane by brute force: very small uniform steps of the motion, and the whole past of the heat summed in every step of the heat.

Nothing is shared with the kernels, not even the modes of the heat or the constants of the law of Li et al. (2020). Spring (b) is cut back along its radius to
the circle of yielding after every step. The flux is constant in a step of the heat, and its weight in Eq. (11) exact: :math:`2 (\sqrt{t-t_a} - \sqrt{t-t_b})`.
The mean temperature of the contact needs no points: of a disc of diameter D, the part that was also under it when it was a distance
d = D cos(a) away is :math:`(2 a - \sin 2 a) / \pi`. The hottest point is looked for on a grid of points, every one of which is brought up to date
in every step by exponentials of its own, :math:`1/\sqrt{t} = (2/\sqrt\pi) \int e^{-s^2 t} ds` by the trapezoidal rule in log s; between the hottest
of them the whole past is summed again.
"""

import math
from dataclasses import dataclass
from functools import cache
from typing import Any, TypeAlias

import numba
import numpy as np
from numpy.typing import NDArray

from dcfp.analysis import PlaneResponse, respond
from dcfp.arrays import FloatArray
from dcfp.motion.station import Station
from dcfp.system import LI_2020, Bearing, Heating, Li2020, PreciseHeating, SimplifiedHeating
from dcfp.verify.check import Found, scaled_station
from dcfp.verify.rig_explicit import li_2020_constants

ComplexArray: TypeAlias = NDArray[np.complex128]

#: Steps of the motion and of the heat are at most so long [s].
STEP, HEAT_STEP = 2e-5, 2e-3
#: Distance of the points of the grid [mm].
SPACING = 8.0
#: Values of the part of a disc that another covers, from one to no distance.
_TABLE = 20_000
#: Logarithms of s [s^-1/2] of the exponentials: from far below the root of the duration to far above that of a step.
_LOWEST, _HIGHEST, _BETWEEN = -8.0, 9.0, 0.5
#: Points of the grid about which the hottest one is looked for, in how many places of a cell each way, and how many steps of the heat before and after.
_LOOKED_AT, _FINER, _NEAR = 30, 5, 4


@dataclass(frozen=True)
class Outcome:
    """What a ground motion brings.

    Attributes
    ----------
    peak
        Largest distance from the middle [mm].
    displacement
        In the middle of each step of the heat [mm], shape (n, 2).
    flux
        Into each plate, mean of a step [N/(mm s)].
    temperature
        Of the contact at the end of each step [degC].
    step
        Of the heat [s].
    """

    peak: float
    displacement: FloatArray
    flux: FloatArray
    temperature: FloatArray
    step: float


def integrate(
    motion: Station,
    bearing: Bearing,
    law: FloatArray,
    heating: Heating,
    *,
    speed_factor: float = 1.0,
    heats_while_sticking: bool = False,
) -> Outcome:
    """Shake a bearing with one plate, or two equal ones, from rest under its own vertical force.

    The coefficient is m (1 - d exp(-r s |v|)) (A exp(-B T) + C), in which `law` holds m, d, r, A, B, C and `speed_factor` is s.
    Where it `heats_while_sticking` the flux is of the speed and not of the slip.
    """
    share = bearing.shares[0]
    precise = isinstance(heating, PreciseHeating)
    parts = math.ceil(motion.time_step / HEAT_STEP)
    step = motion.time_step / parts
    peak, x, y, flux, temperature = _march(
        motion.acceleration @ np.array([1.0, 1j]),
        motion.time_step,
        parts,
        math.ceil(step / STEP),
        np.array([bearing.restoring_stiffness, bearing.elastic_stiffness, bearing.vertical_force]) / bearing.mass,
        law,
        speed_factor,
        share * bearing.pressure if heating.name != "none" else 0.0,
        _rise_per_flux(heating),
        heating.ambient,
        overlaps() if precise else np.ones(2),
        share / bearing.slider_diameter if precise else 0.0,
        math.inf if precise else bearing.contact_half_side / share,
        heats_while_sticking,
    )  # fmt: skip
    return Outcome(peak, np.column_stack((x, y)), flux, temperature, step)


def overlaps() -> FloatArray:
    """Return the part of a disc that another one covers, at equal distances of their centres from none to the diameter."""
    angle = np.arccos(np.linspace(0.0, 1.0, _TABLE + 1))
    return np.append((2.0 * angle - np.sin(2.0 * angle)) / math.pi, 0.0)


def _rise_per_flux(heating: Heating) -> float:
    return math.sqrt(heating.diffusivity / math.pi) / heating.conductivity


def _summed_plainly(
    weights: FloatArray,
    flux: FloatArray,
    x: FloatArray,
    y: FloatArray,
    here_x: float,
    here_y: float,
    count: int,
    overlap: FloatArray,
    nearness: float,
) -> float:
    """Sum the past of `count` steps, by how much of the contact here was covered then."""
    total = 0.0
    if nearness == 0.0:
        for k in range(count):
            total += weights[count - 1 - k] * flux[k]
        return total
    cells = overlap.size - 2
    for k in range(count):
        away = min(math.sqrt((x[k] - here_x) ** 2 + (y[k] - here_y) ** 2) * nearness, 1.0) * cells
        cell = int(away)
        covered = overlap[cell] + (away - cell) * (overlap[cell + 1] - overlap[cell])
        total += weights[count - 1 - k] * flux[k] * covered
    return total


_summed: Any = numba.njit(fastmath=True)(_summed_plainly)


def _march_plainly(
    acceleration: ComplexArray,
    interval: float,
    heat_parts: int,
    parts: int,
    structure: FloatArray,
    law: FloatArray,
    speed_factor: float,
    pressure: float,
    rise_per_flux: float,
    ambient: float,
    overlap: FloatArray,
    nearness: float,
    edge: float,
    always: bool,
) -> tuple[float, FloatArray, FloatArray, FloatArray, FloatArray]:
    restoring, elastic, weight = structure
    reference, drop, rate, scale, fall, floor = law
    heat_step = interval / heat_parts
    h = heat_step / parts
    count = (acceleration.size - 1) * heat_parts
    root = np.sqrt(heat_step * np.arange(count + 1.0))
    weights = 2.0 * (root[1:] - root[:-1])
    flux, temperature = np.zeros(count), np.full(count, ambient)
    x, y = np.zeros(count), np.zeros(count)
    u, v, e, peak = 0j, 0j, 0j, 0.0
    warmth, warmer = ambient, ambient  # at the ends of the last two steps of the heat
    for n in range(count):
        sample, part = n // heat_parts, n % heat_parts
        first, change = acceleration[sample], acceleration[sample + 1] - acceleration[sample]
        rubbed = 0.0
        for j in range(parts):
            ground = first + change * ((part + (j + 0.5) / parts) / heat_parts)
            expected = warmth + (warmth - warmer) * (j + 0.5) / parts
            speed = abs(v)
            friction = reference * (1.0 - drop * math.exp(-rate * speed_factor * speed))
            friction *= scale * math.exp(-fall * expected) + floor
            rim = friction * weight / elastic
            # half of the way with the old velocity, half with the new one
            half = e + 0.5 * h * v
            slip = max(abs(half) - rim, 0.0)
            half *= 1.0 - slip / max(abs(half), 1e-300)
            u += 0.5 * h * v
            v -= h * (ground + restoring * u + elastic * half)
            u += 0.5 * h * v
            e = half + 0.5 * h * v
            more = max(abs(e) - rim, 0.0)
            e *= 1.0 - more / max(abs(e), 1e-300)
            peak = max(peak, abs(u))
            if abs(u) <= edge:
                rubbed += friction * (h * abs(v) if always else slip + more)
            if j == parts // 2:
                x[n], y[n] = u.real, u.imag
        flux[n] = pressure * rubbed / heat_step
        total = _summed(weights, flux, x, y, u.real, u.imag, n + 1, overlap, nearness)
        warmer, warmth = warmth, ambient + rise_per_flux * total
        temperature[n] = warmth
    return peak, x, y, flux, temperature


_march: Any = numba.njit(_march_plainly)


def on_a_grid(
    outcome: Outcome, bearing: Bearing, heating: Heating, spacing: float = SPACING
) -> tuple[float, float]:
    """Return the highest temperature of a point of a plate, and the highest mean of the covered points of the grid [degC], along an `outcome`.

    Between the points of the grid it is looked for where they are hottest, by direct convolution.
    """
    share, radius = bearing.shares[0], 0.5 * bearing.slider_diameter
    places = share * outcome.displacement
    furthest = radius + float(np.hypot(*places.T).max())
    axis = spacing * np.arange(-math.ceil(furthest / spacing), math.ceil(furthest / spacing) + 1)
    points = np.array([(x, y) for x in axis for y in axis if math.hypot(x, y) <= furthest])
    roots = np.exp(np.arange(_LOWEST, _HIGHEST, _BETWEEN))
    rates, factor = roots**2, _rise_per_flux(heating)
    fade = np.exp(-rates * outcome.step)
    gain = factor * 2.0 / math.sqrt(math.pi) * _BETWEEN * roots * (1.0 - fade) / rates
    rises, when, mean = _heat_points(places, outcome.flux, points, radius, fade, gain)
    hot = np.argsort(rises)[-_LOOKED_AT:]
    finer = spacing * np.linspace(-0.5, 0.5, _FINER)
    root = np.sqrt(outcome.step * np.arange(outcome.flux.size + 1.0))
    weights = 2.0 * factor * (root[1:] - root[:-1])
    hottest = _hottest_near(places, outcome.flux, weights, points[hot], when[hot], radius, finer)
    return heating.ambient + max(float(rises.max()), hottest), heating.ambient + mean


def _heat_points_plainly(
    places: FloatArray,
    flux: FloatArray,
    points: FloatArray,
    radius: float,
    fade: FloatArray,
    gain: FloatArray,
) -> tuple[FloatArray, NDArray[np.int64], float]:
    """Return the highest rise of each point and the step at whose end it is, and the highest mean of the covered points [degC]."""
    modes = np.zeros((points.shape[0], fade.size))
    highest, when = np.zeros(points.shape[0]), np.zeros(points.shape[0], np.int64)
    highest_mean = 0.0
    for n in range(flux.size):
        covered, total = 0, 0.0
        for i in range(points.shape[0]):
            away = (points[i, 0] - places[n, 0]) ** 2 + (points[i, 1] - places[n, 1]) ** 2
            felt = flux[n] if away <= radius * radius else 0.0
            rise = 0.0
            for k in range(fade.size):
                modes[i, k] = fade[k] * modes[i, k] + gain[k] * felt
                rise += modes[i, k]
            if rise > highest[i]:
                highest[i], when[i] = rise, n
            if away <= radius * radius:
                covered += 1
                total += rise
        highest_mean = max(highest_mean, total / covered)
    return highest, when, highest_mean


_heat_points: Any = numba.njit(fastmath=True)(_heat_points_plainly)


def _hottest_near_plainly(
    places: FloatArray,
    flux: FloatArray,
    weights: FloatArray,
    points: FloatArray,
    when: NDArray[np.int64],
    radius: float,
    finer: FloatArray,
) -> float:
    """Return the highest rise in a cell about each point, at the end of a step near the one when the point is hottest [degC]."""
    hottest = 0.0
    for i in range(points.shape[0]):
        for dx in finer:
            for dy in finer:
                x, y = points[i, 0] + dx, points[i, 1] + dy
                for n in range(max(when[i] - _NEAR, 0), min(when[i] + _NEAR + 1, flux.size)):
                    rise = 0.0
                    for k in range(n + 1):
                        if (x - places[k, 0]) ** 2 + (y - places[k, 1]) ** 2 <= radius * radius:
                            rise += weights[n - k] * flux[k]
                    hottest = max(hottest, rise)
    return hottest


_hottest_near: Any = numba.njit(fastmath=True)(_hottest_near_plainly)


# ----- the analysis against it -----

_MODELS: dict[str, Heating] = {"simplified": SimplifiedHeating(), "precise": PreciseHeating()}


@cache
def _both(station: str, pgv: float, heating: str) -> tuple[PlaneResponse, Outcome]:
    """Return a station at a PGV [m/s] by an analysis with the default settings, and by brute force."""
    motion, model = scaled_station(station, 1e3 * pgv), _MODELS[heating]
    outcome = integrate(motion, LI_2020, li_2020_constants(LI_2020.pressure), model)
    return respond(motion, LI_2020, Li2020(), model, tail=0.0), outcome


def displacement(station: str, pgv: float, heating: str) -> Found:
    """Return the peak displacement of the analysis and by brute force [mm]."""
    response, outcome = _both(station, pgv, heating)
    words = {"step": 1e6 * STEP, "heat_step": 1e3 * outcome.step}
    return Found(response.peak_displacement, outcome.peak, words=words)


def temperature(station: str, pgv: float, heating: str) -> Found:
    """Return the highest temperature of the contact by the analysis and by brute force [degC]."""
    response, outcome = _both(station, pgv, heating)
    words = {"step": 1e6 * STEP, "heat_step": 1e3 * outcome.step}
    return Found(response.peak_temperature, float(outcome.temperature.max()), words=words)


def point_temperature(station: str, pgv: float) -> Found:
    """Return the highest temperature of a point of a plate by the analysis and by brute force [degC]."""
    response, outcome = _both(station, pgv, "precise")
    hottest, mean = on_a_grid(outcome, LI_2020, response.heating)
    words = {"spacing": SPACING, "mean": mean, "lens": float(outcome.temperature.max())}
    return Found(response.peak_point_temperature, hottest, words=words)

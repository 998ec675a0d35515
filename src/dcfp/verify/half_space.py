"""Heat in the plate: the short sum of modes against the half-order kernel, closed forms, and brute force."""

import math

import numpy as np

from dcfp.analysis import Response, respond
from dcfp.analysis.response import state_at_rest
from dcfp.arrays import FloatArray
from dcfp.kernels.sum_of_exponentials import (
    RATE_RATIO,
    accumulate,
    fill_decay,
    fill_weights,
    half_space_modes,
)
from dcfp.motion.ground_motion import GroundMotion
from dcfp.system import LI_2020, ConstantFriction, PreciseHeating, SimplifiedHeating, System
from dcfp.system.heating import constant_flux_rise
from dcfp.system.plates import system_constants
from dcfp.verify.check import Found, scaled_record

#: Largest relative error of the trapezoidal rule behind the modes: `dcfp.kernels.sum_of_exponentials`.
_KERNEL_BOUND = 2.0 * math.sqrt(2.0) * math.exp(-(math.pi**2) / math.log(RATE_RATIO))


def kernel(first: float, last: float) -> Found:
    """Return the largest relative error of the modes for lags between `first` and `last` [s], and for shorter ones in words."""
    young = _fed(np.ones(2), 1e-3)[1] / (2.0 * math.sqrt(1e-3)) - 1.0
    words = {"shorter": 100.0 * kernel_error(1e-3, 4e-3), "young": 100.0 * abs(young)}
    return Found(kernel_error(first, last), 0.0, words=words)


def kernel_error(first: float, last: float) -> float:
    """Return the largest relative error of the sum of modes for lags between `first` and `last` [s]."""
    rates, weights, _ = half_space_modes()
    lag = np.geomspace(first, last, 20_001)
    total = (weights * np.exp(-np.outer(lag, rates))).sum(axis=1)
    return float(np.abs(total * np.sqrt(lag) - 1.0).max())


def _fed(flux: FloatArray, step: float) -> FloatArray:
    """Return the integral of flux / sqrt(lag) at each time by the kernels' modes; the flux is linear in each step."""
    rates, weights, instant = half_space_modes()
    modes = np.zeros((6, rates.size))
    modes[0], modes[1] = rates, weights
    fill_decay(modes, 0, step, 3)
    fill_weights(modes, 0, 1, step, 3)
    sums = [accumulate(modes, 3, 2, flux[i], flux[i + 1]) for i in range(flux.size - 1)]
    return np.concatenate(([0.0], sums)) + instant * flux


def constant_flux_by_modes() -> Found:
    """Return the largest relative error under a constant flux [-]."""
    step = 0.01
    rise = _fed(np.ones(30_001), step)
    time = np.arange(30_001) * step
    error = np.abs(rise[1:] / (2.0 * np.sqrt(time[1:])) - 1.0).max()
    return Found(float(error), 0.0, limit=_KERNEL_BOUND)


def constant_flux_by_analysis() -> Found:
    """Return the rise of a slide for 300 s at a speed that hardly falls, on a contact that never leaves its centre [degC]."""
    plane = LI_2020.unchecked(radii=(5e14, 5e14), slider_diameter=2e5, pressure=60.0)
    friction = ConstantFriction(1e-9)
    heating = SimplifiedHeating().unchecked(conductivity=1e-8)
    system = System(plane, friction, heating)
    constants, start = system_constants(system), state_at_rest(system)
    velocity = 100.0
    start.integration["motion"]["velocity"] = velocity
    start.integration["spring"]["elongation"] = friction.mu * constants.yield_per_mu
    start.integration["spring"]["slip_sign"] = 1
    still = GroundMotion(np.zeros(30_001), 0.01, "ground at rest")
    slide = respond(still, system, tail=0.0, start=start)
    flux = 0.5 * friction.mu * plane.pressure * velocity
    expected = float(constant_flux_rise(heating, flux, 300.0))
    return Found(float(slide.temperature[-1]) - heating.ambient, expected, limit=_KERNEL_BOUND)


def _periodic_wave() -> complex:
    """Return amplitude and phase, against the flux, of the periodic rise over that of the closed form."""
    steps, cycles = 400, 200
    angle = 2.0 * math.pi * np.arange(steps * cycles + 1) / steps
    rise = _fed(np.sin(angle), 1.0 / steps)
    carrier = np.exp(-1j * angle[-steps:])
    wave = 2j * (rise[-steps:] * carrier).mean()
    # the integral of exp(i w t) over all past is sqrt(pi / w) exp(i (w t - pi/4))
    return complex(wave / math.sqrt(math.pi / (2.0 * math.pi)))


def periodic_amplitude() -> Found:
    """Return the amplitude under a periodic flux over that of the closed form [-]."""
    return Found(abs(_periodic_wave()), 1.0, limit=_KERNEL_BOUND + 2e-5)


def periodic_lag() -> Found:
    """Return the lag of the temperature behind a periodic flux [deg]."""
    limit = math.degrees(_KERNEL_BOUND + 2e-5)
    return Found(-math.degrees(np.angle(_periodic_wave())), 45.0, limit=limit)


def brute_force(heating: str) -> Found:
    """Return the largest difference of the temperature from direct sums at twelve times [degC]."""
    model = PreciseHeating(cells=200) if heating == "precise" else SimplifiedHeating()
    response = respond(scaled_record("NCC", 1000.0), heating=model, step=5e-4, tail=0.0)
    direct = contact_temperature if heating == "precise" else centre_temperature
    samples = (np.linspace(0.1, 1.0, 12) * (response.time.size - 1)).astype(int).tolist()
    gaps = [float(response.temperature[sample]) - direct(response, sample) for sample in samples]
    return Found(max(gaps, key=abs), 0.0, words={"peak": response.peak_temperature})


# Temperature of the contact by brute force: the integral of Eq. (11) summed over the whole past, at many
# points.
#
# Nothing here is shared with the kernels. The flux is taken constant over each interval, and its weight is
# exact:
#
# .. math:: \int_{t_a}^{t_b} \frac{d\tau}{\sqrt{t-\tau}} = 2 \left(\sqrt{t-t_a} - \sqrt{t-t_b}\right)


def centre_temperature(response: Response, sample: int) -> float:
    """Temperature of the centre of the plate [degC] at a sample: the simplified model."""
    return _mean_temperature(response, sample, np.zeros(1))


def contact_temperature(response: Response, sample: int) -> float:
    """Mean temperature of the contact [degC] at a sample, of points 1 mm apart: the precise model."""
    half = response.bearing.contact_half_side
    count = max(2, math.ceil(2.0 * half))
    inside = (np.arange(count) + 0.5) / count * 2.0 * half - half
    return _mean_temperature(response, sample, 0.5 * response.displacement[sample] + inside)


def _mean_temperature(response: Response, sample: int, points: FloatArray) -> float:
    """Mean temperature [degC] at a sample of points [mm] on one of two equal plates: Li et al. (2020), Eqs (11) and (12)."""
    heating = response.heating
    speed = np.where(response.sliding != 0.0, np.abs(response.velocity), 0.0)
    flux = 0.5 * response.friction * response.bearing.pressure * speed
    flux = 0.5 * (flux[1:] + flux[:-1])
    position = 0.5 * response.displacement
    position = 0.5 * (position[1:] + position[:-1])
    ago = np.sqrt(response.time[sample] - response.time[: sample + 1])
    weighted = 2.0 * (ago[:-1] - ago[1:]) * flux[:sample]
    factor = math.sqrt(heating.diffusivity / math.pi) / heating.conductivity
    covered = (
        np.abs(points[:, np.newaxis] - position[np.newaxis, :sample]) <= response.bearing.contact_half_side
    )
    return heating.ambient + float((factor * (covered @ weighted)).mean())

"""Heat in the plate: the short sum of modes against the half-order kernel, closed forms, and brute force."""

import math
from dataclasses import dataclass
from functools import partial

import numpy as np

from dcfp.analysis import Response, respond
from dcfp.analysis.kernel_input import state_at_rest
from dcfp.arrays import FloatArray
from dcfp.kernels.sum_of_exponentials import (
    RATE_RATIO,
    accumulate,
    fill_decay,
    fill_weights,
    half_space_modes,
)
from dcfp.motion.ground_motion import GroundMotion
from dcfp.system import LI_2020, ConstantFriction, Heating, PreciseHeating, SimplifiedHeating, System
from dcfp.system.heating import constant_flux_rise
from dcfp.system.plates import system_constants
from dcfp.verify.check import Finding, Task, scaled_record

GROUP = "Heat in the plate"
#: Largest relative error of the trapezoidal rule behind the modes: `dcfp.kernels.sum_of_exponentials`.
_KERNEL_BOUND = 2.0 * math.sqrt(2.0) * math.exp(-(math.pi**2) / math.log(RATE_RATIO))
_BOUND_NOTE = "Allowed: 2 sqrt(2) exp(-pi2 / ln r), the bound of the rule behind the modes."
_CARSLAW = "Carslaw and Jaeger (1959), section 2.9"


def _kernel_error(first: float, last: float, limit: float) -> Finding:
    error = kernel_error(first, last)
    note = (
        f"Largest relative error for these lags. Allowed: what `half_space_modes` states. Shorter lags are outside of what it"
        f" states: from 1 to 4 ms the error is {100.0 * kernel_error(1e-3, 4e-3):.1f} %, and heat that young is"
        f" {100.0 * abs(_fed(np.ones(2), 1e-3)[1] / (2.0 * math.sqrt(1e-3)) - 1.0):.1f} % off after 1 ms."
    )
    return Finding(error, 0.0, "-", limit, note, "1/sqrt(tau), the kernel of Li et al. (2020), Eq. (11)")


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


def _constant_flux_by_modes() -> Finding:
    step = 0.01
    rise = _fed(np.ones(30_001), step)
    time = np.arange(30_001) * step
    error = np.abs(rise[1:] / (2.0 * np.sqrt(time[1:])) - 1.0).max()
    note = "Largest relative error from 0.01 to 300 s. " + _BOUND_NOTE
    return Finding(float(error), 0.0, "-", _KERNEL_BOUND, note, f"2 sqrt(t); {_CARSLAW}")


def _constant_flux_by_analysis() -> Finding:
    """Slide for 300 s at a speed that hardly falls, on a contact so long that it never leaves its centre."""
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
    note = "A flat slide at 0.1 m/s under a friction of 1e-9. " + _BOUND_NOTE
    return Finding(
        float(slide.temperature[-1]) - heating.ambient, expected, "degC", _KERNEL_BOUND, note,
        f"2 q sqrt(D t / pi) / k; {_CARSLAW}", relative=True,
    )  # fmt: skip


def _periodic_wave() -> complex:
    """Return amplitude and phase, against the flux, of the periodic rise over that of the closed form."""
    steps, cycles = 400, 200
    angle = 2.0 * math.pi * np.arange(steps * cycles + 1) / steps
    rise = _fed(np.sin(angle), 1.0 / steps)
    carrier = np.exp(-1j * angle[-steps:])
    wave = 2j * (rise[-steps:] * carrier).mean()
    # the integral of exp(i w t) over all past is sqrt(pi / w) exp(i (w t - pi/4))
    return complex(wave / math.sqrt(math.pi / (2.0 * math.pi)))


def _periodic_amplitude() -> Finding:
    note = (
        "A flux of 1 Hz, cycle 200 of 400 steps. Allowed: the bound of the sum of modes and 2e-5 for chords."
    )
    return Finding(
        abs(_periodic_wave()), 1.0, "-", _KERNEL_BOUND + 2e-5, note, f"q0 sqrt(D / w) / k; {_CARSLAW}"
    )


def _periodic_lag() -> Finding:
    lag = -math.degrees(np.angle(_periodic_wave()))
    limit = math.degrees(_KERNEL_BOUND + 2e-5)
    return Finding(lag, 45.0, "deg", limit, "As above, as an angle.", f"an eighth of a period; {_CARSLAW}")


def _brute_force(heating: Heating) -> Finding:
    motion = scaled_record("NCC", 1000.0)
    response = respond(motion, heating=heating, step=5e-4, tail=0.0)
    samples = np.linspace(0.1, 1.0, 12) * (response.time.size - 1)
    gaps: list[float] = []
    for sample in samples.astype(int):
        if isinstance(heating, PreciseHeating):
            direct = contact_temperature(response, int(sample), spacing=1.0)
        else:
            direct = centre_temperature(response, int(sample))
        gaps.append(float(response.temperature[sample]) - direct)
    worst = max(gaps, key=abs)
    note = (
        f"NCC at 1 m/s, steps of 0.5 ms, 12 times; the peak is {response.peak_temperature:.0f} degC."
        " Allowed: 0.2 degC, what the default settings promise."
    )
    source = "Li et al. (2020), Eqs (11) and (12), summed over the whole past without modes"
    return Finding(worst, 0.0, "degC", 0.2, note, source)


TASKS = (
    Task(
        GROUP, "sum of modes against 1/sqrt(tau), 4 ms to 100 s", partial(_kernel_error, 4e-3, 100.0, 2.7e-4)
    ),
    Task(GROUP, "sum of modes against 1/sqrt(tau), 100 to 300 s", partial(_kernel_error, 100.0, 300.0, 1e-3)),
    Task(GROUP, "constant flux, modes", _constant_flux_by_modes),
    Task(GROUP, "constant flux, analysis", _constant_flux_by_analysis),
    Task(GROUP, "periodic flux, amplitude", _periodic_amplitude),
    Task(GROUP, "periodic flux, lag", _periodic_lag),
    *(
        Task(GROUP, f"brute-force convolution, {heating.name} heating", partial(_brute_force, heating))
        for heating in (SimplifiedHeating(), PreciseHeating(cells=200))
    ),
)


# Temperature of the contact by brute force: the integral of Eq. (11) summed over the whole past, at many
# points.
#
# Nothing here is shared with the kernels. The flux is taken constant over each interval, and its weight is
# exact:
#
# .. math:: \int_{t_a}^{t_b} \frac{d\tau}{\sqrt{t-\tau}} = 2 \left(\sqrt{t-t_a} - \sqrt{t-t_b}\right)


@dataclass(frozen=True)
class SlidingHistory:
    """A slider on one of two equal plates.

    Attributes
    ----------
    time
        [s], shape (n + 1,).
    position
        Of the slider on the plate in the middle of each interval [mm], shape (n,).
    flux
        Heat into the plate per area in each interval [N/(mm s)], shape (n,).
    """

    time: FloatArray
    position: FloatArray
    flux: FloatArray


def history_of(response: Response) -> SlidingHistory:
    """Return the history of a response on two equal plates: y/2 and mu p |v| / 2, Li et al. (2020), Eq. (12)."""
    speed = np.where(response.sliding != 0.0, np.abs(response.velocity), 0.0)
    flux = 0.5 * response.friction * response.bearing.pressure * speed
    position = 0.5 * response.displacement
    return SlidingHistory(
        time=response.time,
        position=0.5 * (position[1:] + position[:-1]),
        flux=0.5 * (flux[1:] + flux[:-1]),
    )


def rises_at(
    history: SlidingHistory,
    sample: int,
    points: FloatArray,
    half_contact: float,
    conductivity: float,
    diffusivity: float,
) -> FloatArray:
    """Temperature rise of points on the plate [degC] at a sample: Li et al. (2020), Eqs (11) and (12).

    `points` and `half_contact` [mm], `conductivity` [N/(s degC)], `diffusivity` [mm2/s].
    """
    ago = np.sqrt(history.time[sample] - history.time[: sample + 1])
    weighted = 2.0 * (ago[:-1] - ago[1:]) * history.flux[:sample]
    factor = math.sqrt(diffusivity / math.pi) / conductivity
    covered = np.abs(points[:, np.newaxis] - history.position[np.newaxis, :sample]) <= half_contact
    return np.asarray(factor * (covered @ weighted))


def centre_temperature(response: Response, sample: int) -> float:
    """Temperature of the centre of the plate [degC] at a sample: the simplified model."""
    return _mean_temperature(response, sample, np.zeros(1))


def contact_temperature(response: Response, sample: int, spacing: float) -> float:
    """Mean temperature of the contact [degC] at a sample, of points `spacing` [mm] apart: the precise model."""
    half = response.bearing.contact_half_side
    count = max(2, math.ceil(2.0 * half / spacing))
    inside = (np.arange(count) + 0.5) / count * 2.0 * half - half
    return _mean_temperature(response, sample, 0.5 * response.displacement[sample] + inside)


def _mean_temperature(response: Response, sample: int, points: FloatArray) -> float:
    heating = response.heating
    rises = rises_at(
        history_of(response),
        sample,
        points,
        response.bearing.contact_half_side,
        heating.conductivity,
        heating.diffusivity,
    )
    return heating.ambient + float(rises.mean())

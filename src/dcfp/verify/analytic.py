r"""Numbers that Li et al. (2020) print, motions with a closed form (elastic oscillation, free sliding to a stop, a steady harmonic slide), and heat in the plate.

The motions are under constant friction, per unit mass: :math:`\omega^2 = k_{ra}/m` and the deceleration :math:`\mu g`.
"""

import math

import numpy as np

from dcfp.analysis import Response, respond
from dcfp.analysis.response import state_at_rest
from dcfp.arrays import FloatArray
from dcfp.constants import STANDARD_GRAVITY
from dcfp.kernels.sum_of_exponentials import (
    RATE_RATIO,
    accumulate,
    fill_decay,
    fill_weights,
    half_space_modes,
)
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.named import named_motion
from dcfp.motion.synthetic import harmonic
from dcfp.system import (
    LI_2020,
    Bearing,
    ConstantFriction,
    NoHeating,
    PreciseHeating,
    SimplifiedHeating,
    System,
)
from dcfp.system.friction.constant import NOMINAL_COEFFICIENT
from dcfp.system.friction.li_2020 import pressure_factor, temperature_factor, velocity_factor
from dcfp.system.heating import constant_flux_rise
from dcfp.system.plates import system_constants
from dcfp.verify.check import Found, scaled_record

#: PGV of the records as printed [mm/s]: Li et al. (2020), Table 3.
_PRINTED_VELOCITIES = {"NCC": 449.0, "KNA": 373.0, "LPG": 447.0, "IVD": 330.0}
_FACTORS = {"pressure": pressure_factor, "velocity": velocity_factor, "temperature": temperature_factor}


def factor_of_law(factor: str, at: float) -> float:
    """Return a factor of the law of Li et al. (2020) at a pressure [N/mm2], velocity [mm/s] or temperature [degC]."""
    return float(_FACTORS[factor](at))


def property_of_bearing(quantity: str, size: float = 1.0) -> float:
    """Return a property of the bearing of Li et al. (2020) in units of so many of the package's."""
    return getattr(LI_2020, quantity) / size


def yield_displacement() -> float:
    """Return 0.043 x 7.540e6 N / 1900e3 N/mm, with N and kf of the package [mm]."""
    return NOMINAL_COEFFICIENT * LI_2020.vertical_force / LI_2020.elastic_stiffness


def friction_deceleration() -> float:
    """Return mu_n g [mm/s2]."""
    return NOMINAL_COEFFICIENT * STANDARD_GRAVITY


def printed_velocity(record: str) -> Found:
    """Return the PGV of a record as it is [mm/s]."""
    expected = _PRINTED_VELOCITIES[record]
    return Found(named_motion(record).peak_velocity, expected, limit=0.5 + 3.4e-4 * expected)


# ----- motions -----

_FRICTION = ConstantFriction()
#: Of the slides at their start [mm/s].
_VELOCITY = 500.0


def _released(system: System, velocity: float, time_step: float, steps: int, *, sliding: bool) -> Response:
    """Return the motion over a ground at rest from zero displacement with a velocity [mm/s], on the yield surface if it is sliding."""
    still = GroundMotion(np.zeros(steps + 1), time_step, "ground at rest")
    constants, start = system_constants(system), state_at_rest(system)
    start.integration["motion"]["velocity"] = velocity
    if sliding:
        start.integration["spring"]["elongation"] = system.friction.reference * constants.yield_per_mu
        start.integration["spring"]["slip_sign"] = 1
    return respond(still, system, tail=0.0, start=start)


def _cold(bearing: Bearing = LI_2020) -> System:
    return System(bearing, _FRICTION, NoHeating())


def stop_of_a_slide(bearing: Bearing, velocity: float) -> tuple[float, float]:
    r"""Return time [s] and displacement [mm] at which a slide from zero displacement comes to a stop.

    .. math:: t = \frac1\omega \arctan\frac{\omega v_0}{\mu g}, \qquad
              y = \sqrt{\Bigl(\frac{v_0}{\omega}\Bigr)^2 + \Bigl(\frac{\mu g}{\omega^2}\Bigr)^2} - \frac{\mu g}{\omega^2}

    `velocity` v0 [mm/s]. The solution of y'' + omega2 y = - mu g.
    """
    frequency = math.sqrt(STANDARD_GRAVITY / bearing.effective_radius)
    offset = _FRICTION.mu * STANDARD_GRAVITY / frequency**2
    time = math.atan(velocity / (frequency * offset)) / frequency
    swing = velocity / frequency
    # the difference of root and offset without cancellation
    return time, swing**2 / (math.hypot(swing, offset) + offset)


def stop_distance() -> tuple[float, float]:
    """Return the distance of a slide to its stop, and that of the closed form [mm]."""
    slide = _released(_cold(), _VELOCITY, 0.01, 200, sliding=True)
    return slide.peak_displacement, stop_of_a_slide(LI_2020, _VELOCITY)[1]


def stop_velocity() -> Found:
    """Return the velocity at the moment at which the closed form stops [mm/s]."""
    time, _ = stop_of_a_slide(LI_2020, _VELOCITY)
    slide = _released(_cold(), _VELOCITY, time / 1000.0, 1000, sliding=True)
    return Found(float(slide.velocity[-1]), 0.0, words={"time": time})


def flat_stop() -> Found:
    """Return the distance of a slide on plates with radii of 500 km to its stop, and that on a plane [mm]."""
    flat = LI_2020.unchecked(radii=(5e8, 5e8))
    slide = _released(_cold(flat), _VELOCITY, 0.01, 200, sliding=True)
    limit = (_VELOCITY / _FRICTION.mu) ** 2 / (4.0 * STANDARD_GRAVITY * flat.effective_radius)
    return Found(slide.peak_displacement, _VELOCITY**2 / (2.0 * _FRICTION.mu * STANDARD_GRAVITY), limit)


def elastic_oscillation() -> float:
    """Return the largest difference from a sine inside the yield surface over its amplitude [-]."""
    frequency = math.sqrt((LI_2020.restoring_stiffness + LI_2020.elastic_stiffness) / LI_2020.mass)
    amplitude = 0.9 * _FRICTION.mu * LI_2020.vertical_force / LI_2020.elastic_stiffness
    swing = _released(_cold(), amplitude * frequency, 0.01, 2000, sliding=False)
    return float(np.abs(swing.displacement - amplitude * np.sin(frequency * swing.time)).max() / amplitude)


def den_hartog_amplitude(acceleration: float, ratio: float, bearing: Bearing, coefficient: float) -> float:
    r"""Return the amplitude of the steady slide under a harmonic ground acceleration [mm].

    .. math:: y = \sqrt{\Bigl(\frac{A/\omega^2}{1 - r^2}\Bigr)^2
              - \Bigl(\frac{\mu g}{\omega^2}\,\frac{\sin(\pi/r)}{r\,(1 + \cos(\pi/r))}\Bigr)^2}

    `acceleration` A [mm/s2] at `ratio` r times the frequency of the pendulum, friction `coefficient` mu; for a
    rigid bearing (no spring (b)) that slides without a stop. Den Hartog (1931).
    """
    square = STANDARD_GRAVITY / bearing.effective_radius
    free = acceleration / square / (1.0 - ratio**2)
    angle = math.pi / ratio
    damping = math.sin(angle) / (ratio * (1.0 + math.cos(angle)))
    return math.sqrt(free**2 - (coefficient * STANDARD_GRAVITY / square * damping) ** 2)


def steady_slide(ratio: float) -> tuple[float, float]:
    """Return the amplitude in cycle 60, and that of the closed form [mm]."""
    rigid = LI_2020.unchecked(elastic_stiffness=1e12)
    acceleration = 4.0 * _FRICTION.mu * STANDARD_GRAVITY
    period = rigid.period / ratio
    shaking = harmonic(acceleration, period, 60, phase=0.5 * math.pi, time_step=period / 1000)
    last = respond(shaking, rigid, _FRICTION, NoHeating(), tail=0.0).displacement[-1001:]
    expected = den_hartog_amplitude(acceleration, ratio, rigid, _FRICTION.mu)
    return 0.5 * float(last.max() - last.min()), expected


# ----- heat in the plate: the short sum of modes against the half-order kernel, closed forms, and brute force -----

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
    velocity = 100.0
    slide = _released(System(plane, friction, heating), velocity, 0.01, 30_000, sliding=True)
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
    samples = (np.linspace(0.1, 1.0, 12) * (response.time.size - 1)).astype(int).tolist()
    gaps = [
        float(response.temperature[sample])
        - _mean_temperature(response, sample, _points(response, sample, heating))
        for sample in samples
    ]
    return Found(max(gaps, key=abs), 0.0, words={"peak": response.peak_temperature})


def _points(response: Response, sample: int, heating: str) -> FloatArray:
    """Return the points whose mean temperature is that of the contact [mm]: the centre of the plate, or of the precise model points of the contact 1 mm apart."""
    if heating != "precise":
        return np.zeros(1)
    half = response.bearing.contact_half_side
    count = max(2, math.ceil(2.0 * half))
    inside = (np.arange(count) + 0.5) / count * 2.0 * half - half
    return 0.5 * response.displacement[sample] + inside


def _mean_temperature(response: Response, sample: int, points: FloatArray) -> float:
    r"""Return the mean temperature [degC] at a sample of points [mm] on one of two equal plates: Li et al. (2020), Eqs (11) and (12).

    The integral is summed over the whole past, with nothing of the kernels: the flux is constant over each interval, and its weight exact,
    :math:`\int_{t_a}^{t_b} d\tau / \sqrt{t-\tau} = 2 (\sqrt{t-t_a} - \sqrt{t-t_b})`.
    """
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

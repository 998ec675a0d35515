r"""Numbers that Li et al. (2020) print, and motions with a closed form: elastic oscillation, free sliding to a stop, a steady harmonic slide.

The motions are under constant friction, per unit mass: :math:`\omega^2 = k_{ra}/m` and the deceleration :math:`\mu g`.
"""

import math

import numpy as np

from dcfp.analysis import Response, respond
from dcfp.analysis.response import State, state_at_rest
from dcfp.constants import STANDARD_GRAVITY
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.named import named_motion
from dcfp.motion.synthetic import harmonic
from dcfp.system import LI_2020, Bearing, ConstantFriction, NoHeating, System
from dcfp.system.friction.constant import NOMINAL_COEFFICIENT
from dcfp.system.friction.li_2020 import pressure_factor, temperature_factor, velocity_factor
from dcfp.system.plates import system_constants
from dcfp.verify.check import Found

#: PGV of the records as printed [mm/s]: Li et al. (2020), Table 3.
_PRINTED_VELOCITIES = {"NCC": 449.0, "KNA": 373.0, "LPG": 447.0, "IVD": 330.0}


def printed_pressure_factor() -> float:
    """Return the pressure factor at 60 N/mm2 [-]."""
    return float(pressure_factor(60.0))


def printed_velocity_factor() -> float:
    """Return the velocity factor at 400 mm/s [-]."""
    return float(velocity_factor(400.0))


def printed_temperature_factor() -> float:
    """Return the temperature factor at 17.5 degC [-]."""
    return float(temperature_factor(17.5))


def printed_bearing(quantity: str, size: float = 1.0) -> float:
    """Return a property of the bearing of Li et al. (2020) in units of so many of the package's."""
    return getattr(LI_2020, quantity) / size


def printed_yield_displacement() -> float:
    """Return 0.043 x 7.540e6 N / 1900e3 N/mm, with N and kf of the package [mm]."""
    return NOMINAL_COEFFICIENT * LI_2020.vertical_force / LI_2020.elastic_stiffness


def printed_deceleration() -> float:
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


def _moving(bearing: Bearing, velocity: float, *, sliding: bool) -> State:
    """Return the state at zero displacement with a velocity [mm/s], on the yield surface if it is sliding."""
    system = System(bearing, _FRICTION, NoHeating())
    constants, state = system_constants(system), state_at_rest(system)
    state.integration["motion"]["velocity"] = velocity
    if sliding:
        state.integration["spring"]["elongation"] = _FRICTION.mu * constants.yield_per_mu
        state.integration["spring"]["slip_sign"] = 1
    return state


def _released(bearing: Bearing, velocity: float, time_step: float, steps: int, *, sliding: bool) -> Response:
    """Return the motion over a ground at rest from zero displacement with a velocity [mm/s]."""
    still = GroundMotion(np.zeros(steps + 1), time_step, "ground at rest")
    start = _moving(bearing, velocity, sliding=sliding)
    return respond(still, bearing, _FRICTION, NoHeating(), tail=0.0, start=start)


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
    slide = _released(LI_2020, _VELOCITY, 0.01, 200, sliding=True)
    return slide.peak_displacement, stop_of_a_slide(LI_2020, _VELOCITY)[1]


def stop_velocity() -> Found:
    """Return the velocity at the moment at which the closed form stops [mm/s]."""
    time, _ = stop_of_a_slide(LI_2020, _VELOCITY)
    slide = _released(LI_2020, _VELOCITY, time / 1000.0, 1000, sliding=True)
    return Found(float(slide.velocity[-1]), 0.0, words={"time": time})


def flat_stop() -> Found:
    """Return the distance of a slide on plates with radii of 500 km to its stop, and that on a plane [mm]."""
    flat = LI_2020.unchecked(radii=(5e8, 5e8))
    slide = _released(flat, _VELOCITY, 0.01, 200, sliding=True)
    limit = (_VELOCITY / _FRICTION.mu) ** 2 / (4.0 * STANDARD_GRAVITY * flat.effective_radius)
    return Found(slide.peak_displacement, _VELOCITY**2 / (2.0 * _FRICTION.mu * STANDARD_GRAVITY), limit)


def elastic_oscillation() -> float:
    """Return the largest difference from a sine inside the yield surface over its amplitude [-]."""
    frequency = math.sqrt((LI_2020.restoring_stiffness + LI_2020.elastic_stiffness) / LI_2020.mass)
    amplitude = 0.9 * _FRICTION.mu * LI_2020.vertical_force / LI_2020.elastic_stiffness
    swing = _released(LI_2020, amplitude * frequency, 0.01, 2000, sliding=False)
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

r"""Motions with a closed form: elastic oscillation, free sliding to a stop, and a steady harmonic slide.

All of them under constant friction, per unit mass: :math:`\omega^2 = k_{ra}/m` and the deceleration :math:`\mu g`.
"""

import math
from functools import partial

import numpy as np

from dcfp.analysis import respond
from dcfp.analysis.kernel_input import State, state_at_rest
from dcfp.constants import STANDARD_GRAVITY
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.synthetic import harmonic
from dcfp.system import LI_2020, Bearing, ConstantFriction, NoHeating, System
from dcfp.system.plates import system_constants
from dcfp.verify.check import Finding, Task

GROUP = "Closed forms of the motion"
_FRICTION = ConstantFriction()
_ROUNDING = "Allowed: rounding over the steps."


def _moving(bearing: Bearing, velocity: float, *, sliding: bool) -> State:
    """Return the state at zero displacement with a velocity [mm/s], on the yield surface if it is sliding."""
    system = System(bearing, _FRICTION, NoHeating())
    constants, state = system_constants(system), state_at_rest(system)
    state.integration["motion"]["velocity"] = velocity
    if sliding:
        state.integration["spring"]["elongation"] = _FRICTION.mu * constants.yield_per_mu
        state.integration["spring"]["slip_sign"] = 1
    return state


def _stillness(time_step: float, steps: int) -> GroundMotion:
    return GroundMotion(np.zeros(steps + 1), time_step, "ground at rest")


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


def _stop_distance() -> Finding:
    velocity = 500.0
    _, distance = stop_of_a_slide(LI_2020, velocity)
    slide = respond(
        _stillness(0.01, 200), friction=_FRICTION, heating=NoHeating(), tail=0.0,
        start=_moving(LI_2020, velocity, sliding=True),
    )  # fmt: skip
    note = "0.5 m/s on the bearing of Li et al. (2020). " + _ROUNDING
    return Finding(slide.peak_displacement, distance, "mm", 1e-12, note, "y'' + w2 y = -mu g", relative=True)


def _stop_time() -> Finding:
    velocity = 500.0
    time, _ = stop_of_a_slide(LI_2020, velocity)
    slide = respond(
        _stillness(time / 1000.0, 1000), friction=_FRICTION, heating=NoHeating(), tail=0.0,
        start=_moving(LI_2020, velocity, sliding=True),
    )  # fmt: skip
    note = f"The velocity at the {time:.6f} s of the closed form, from 0.5 m/s. " + _ROUNDING
    return Finding(float(slide.velocity[-1]), 0.0, "mm/s", 1e-9, note, "y'' + w2 y = -mu g")


def _flat_stop() -> Finding:
    velocity = 500.0
    flat = LI_2020.unchecked(radii=(5e8, 5e8))
    slide = respond(
        _stillness(0.01, 200), flat, _FRICTION, NoHeating(), tail=0.0,
        start=_moving(flat, velocity, sliding=True),
    )  # fmt: skip
    deceleration = _FRICTION.mu * STANDARD_GRAVITY
    note = "Radii of 500 km. Allowed: (v / mu)^2 / (4 g R), the first term of the curvature."
    limit = (velocity / _FRICTION.mu) ** 2 / (4.0 * STANDARD_GRAVITY * flat.effective_radius)
    expected = velocity**2 / (2.0 * deceleration)
    return Finding(slide.peak_displacement, expected, "mm", limit, note, "v^2 / (2 mu g)", relative=True)


def _elastic() -> Finding:
    frequency = math.sqrt((LI_2020.restoring_stiffness + LI_2020.elastic_stiffness) / LI_2020.mass)
    amplitude = 0.9 * _FRICTION.mu * LI_2020.vertical_force / LI_2020.elastic_stiffness
    velocity = amplitude * frequency
    swing = respond(
        _stillness(0.01, 2000), friction=_FRICTION, heating=NoHeating(), tail=0.0,
        start=_moving(LI_2020, velocity, sliding=False),
    )  # fmt: skip
    gap = np.abs(swing.displacement - amplitude * np.sin(frequency * swing.time)).max() / amplitude
    note = "0.9 r_f, 158 cycles; largest difference at any time over the amplitude. " + _ROUNDING
    return Finding(float(gap), 0.0, "-", 1e-9, note, "y = A sin(w t), w2 = (kra + kf) / m")


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


def _steady_slide(ratio: float) -> Finding:
    rigid = LI_2020.unchecked(elastic_stiffness=1e12)
    acceleration = 4.0 * _FRICTION.mu * STANDARD_GRAVITY
    period = rigid.period / ratio
    cycles = 60
    shaking = harmonic(acceleration, period, cycles, phase=0.5 * math.pi, time_step=period / 1000)
    slide = respond(shaking, rigid, _FRICTION, NoHeating(), tail=0.0)
    last = slide.displacement[-1001:]
    amplitude = 0.5 * float(last.max() - last.min())
    expected = den_hartog_amplitude(acceleration, ratio, rigid, _FRICTION.mu)
    note = (
        f"A = 4 mu g at {ratio:g} times the pendulum's frequency; half of the range in cycle {cycles}. Allowed: the time"
        " that spring (b), kf = 1e12 N/mm, takes to turn, which fades as 1/sqrt(kf) (2e-3 at 1e8, 2e-5 here), and chords"
        " in place of a sine."
    )
    source = "Den Hartog (1931), Forced vibrations with combined Coulomb and viscous friction, Trans. ASME 53"
    return Finding(amplitude, expected, "mm", 1e-4, note, source, relative=True)


TASKS = (
    Task(GROUP, "elastic oscillation inside the yield surface", _elastic),
    Task(GROUP, "distance of a slide to its stop", _stop_distance),
    Task(GROUP, "velocity when a slide stops", _stop_time),
    Task(GROUP, "distance of a slide on a flat plate", _flat_stop),
    *(
        Task(GROUP, f"steady harmonic slide at r = {ratio:g}", partial(_steady_slide, ratio))
        for ratio in (2.5, 3.5)
    ),
)

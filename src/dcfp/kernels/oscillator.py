r"""An undamped oscillator under a quadratic force, in closed form.

.. math:: \ddot y + \omega^2 y = p_0 + p_1 t + p_2 t^2

With :math:`a_0 = p_0 - \omega^2 y_0` the displacement is

.. math:: y - y_0 = v_0 h \varphi_1 + a_0 h^2 \varphi_2 + p_1 h^3 \varphi_3 + 2 p_2 h^4 \varphi_4,
          \qquad \varphi_k(z) = \sum_{n \ge 0} \frac{(-z)^n}{(2n+k)!}, \quad z = \omega^2 h^2

and each integral of it over time raises the index of every :math:`\varphi` and the power of `h` by one.
The series needs no division by a small frequency, so the same lines serve sliding (:math:`\omega h \sim 0.01`)
and sticking (:math:`\omega h \sim 0.5`).
"""

from typing import NamedTuple

from dcfp.kernels._jit import kernel

# 1/k! up to 6, and the ratios (k-2)!/k! beyond: multiplying is several times faster than dividing
_3, _4, _5, _6 = 1.0 / 6.0, 1.0 / 24.0, 1.0 / 120.0, 1.0 / 720.0
_7, _8, _9, _10 = 1.0 / 42.0, 1.0 / 56.0, 1.0 / 72.0, 1.0 / 90.0
_11, _12, _13, _14 = 1.0 / 110.0, 1.0 / 132.0, 1.0 / 156.0, 1.0 / 182.0


class OscillatorStep(NamedTuple):
    """What a step of the oscillator brings.

    ``displacement`` y - y0 [mm] and ``velocity`` [mm/s] at the end; ``area`` [mm s] and ``moment`` [mm s2] are the
    first and second time integral of y - y0 over the step.
    """

    displacement: float
    velocity: float
    area: float
    moment: float


@kernel
def advance_oscillator(
    stiffness: float,
    step: float,
    velocity: float,
    acceleration: float,
    force_rate: float,
    force_curvature: float,
) -> OscillatorStep:
    """Advance the oscillator over `step` [s], which must not exceed about one radian.

    `stiffness` is omega squared [1/s2]; `acceleration` is that at the start [mm/s2]; the force is
    p0 + `force_rate` t + `force_curvature` t2 [mm/s2, mm/s3, mm/s4].
    """
    h = step
    z = stiffness * h * h
    # phi5 and phi6 by their series (the next term is below 1e-13 for z <= 1), the others by recurrence
    phi5 = _5 * (1.0 - z * _7 * (1.0 - z * _9 * (1.0 - z * _11 * (1.0 - z * _13))))
    phi6 = _6 * (1.0 - z * _8 * (1.0 - z * _10 * (1.0 - z * _12 * (1.0 - z * _14))))
    phi4 = _4 - z * phi6
    phi3 = _3 - z * phi5
    phi2 = 0.5 - z * phi4
    phi1 = 1.0 - z * phi3
    phi0 = 1.0 - z * phi2
    v0 = velocity
    a0 = acceleration * h
    # a step depends on the force last: all else is multiplied before it
    p1 = force_rate * (h * h)
    p2 = force_curvature * (2.0 * h * h * h)
    return OscillatorStep(
        h * (v0 * phi1 + a0 * phi2 + p1 * phi3 + p2 * phi4),
        v0 * phi0 + a0 * phi1 + p1 * phi2 + p2 * phi3,
        h * h * (v0 * phi2 + a0 * phi3 + p1 * phi4 + p2 * phi5),
        h * h * h * (v0 * phi3 + a0 * phi4 + p1 * phi5 + p2 * phi6),
    )


@kernel
def work(constant: float, rate: float, curvature: float, length: float, step: OscillatorStep) -> float:
    """Integrate (`constant` + `rate` t + `curvature` t2) times the velocity over the step, exactly."""
    h, dy = length, step.displacement
    first = h * dy - step.area
    second = h * h * dy - 2.0 * h * step.area + 2.0 * step.moment
    return constant * dy + rate * first + curvature * second


@kernel
def squared_speed(step: float, start: float, end: float, displacement: float) -> float:
    """Integral of the squared velocity over a step [mm2/s], by Simpson's rule.

    `start` and `end` velocity [mm/s]; the one in the middle is that of a cubic displacement.
    """
    middle = 1.5 * displacement / step - 0.25 * (start + end)
    return step / 6.0 * (start * start + 4.0 * middle * middle + end * end)

r"""An undamped oscillator under a quadratic force, in closed form.

.. math:: \ddot y + \omega^2 y = p_0 + p_1 t + p_2 t^2

With :math:`a_0 = p_0 - \omega^2 y_0` the displacement is

.. math:: y - y_0 = v_0 h \varphi_1 + a_0 h^2 \varphi_2 + p_1 h^3 \varphi_3 + 2 p_2 h^4 \varphi_4,
          \qquad \varphi_k(z) = \sum_{n \ge 0} \frac{(-z)^n}{(2n+k)!}, \quad z = \omega^2 h^2

and each integral of it over time raises the index of every :math:`\varphi` and the power of `h` by one.
The series needs no division by a small frequency, so the same lines serve sliding (:math:`\omega h \sim 0.01`)
and sticking (:math:`\omega h \sim 0.5`).

Many damped oscillators under the same ground motion are exact for acceleration that is linear between samples:

.. math:: \ddot u + 2 h \omega \dot u + \omega^2 u = -a_g(t)

From sample to sample displacement and velocity are a linear function of themselves and of the two accelerations, with the same
eight coefficients throughout. The inner loop is over the oscillators, which a processor takes several at a time.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel

# 1/k! up to 6, and the ratios (k-2)!/k! beyond: multiplying is several times faster than dividing
_3, _4, _5, _6 = 1.0 / 6.0, 1.0 / 24.0, 1.0 / 120.0, 1.0 / 720.0
_7, _8, _9, _10 = 1.0 / 42.0, 1.0 / 56.0, 1.0 / 72.0, 1.0 / 90.0
_11, _12, _13, _14 = 1.0 / 110.0, 1.0 / 132.0, 1.0 / 156.0, 1.0 / 182.0

# rows of the coefficients: of u, v, the acceleration at the start and its change over the step, in the new u and the new v;
# then omega squared, 2 h omega
UU, UV, UA, UC, VU, VV, VA, VC, SQUARE, DAMPING, COEFFICIENTS = range(11)
# rows of the state and of what is compared on the way; energies are per unit mass
U, V, PEAK_U, PEAK_V, PEAK_A, INPUT, PEAK_INPUT, PEAK_ABSOLUTE, ROWS = range(9)


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


@kernel
def time_of_turn(
    stiffness: float,
    bracket: tuple[float, float],
    first: float,
    close: float,
    velocity: float,
    acceleration: float,
    force_rate: float,
    force_curvature: float,
) -> float:
    """Time in a bracket [s] at which the velocity, of the sign of `velocity` before, passes zero; arguments as for `advance_oscillator`.

    Newton's iteration inside the bracket, from the time `first` until it moves by less than `close` [s].
    """
    low, high = bracket
    going = velocity if velocity != 0.0 else acceleration
    t = first
    for _ in range(50):
        step = advance_oscillator(stiffness, t, velocity, acceleration, force_rate, force_curvature)
        if step.velocity * going > 0.0:
            low = t
        else:
            high = t
        now = acceleration + t * (force_rate + t * force_curvature) - stiffness * step.displacement
        better = t - step.velocity / now if now != 0.0 else 0.5 * (low + high)
        if not low <= better <= high:
            better = 0.5 * (low + high)
        ends = abs(better - t) < close
        t = better
        if ends:
            break
    return t


@kernel
def stepped(
    coefficients: NDArray[np.float64], j: int, u: float, v: float, a: float, c: float
) -> tuple[float, float]:
    """Return displacement and velocity of oscillator j after a step, from those before it, the acceleration and its change.

    What the ground does comes first: it is there before the step before has ended.
    """
    ground_u = coefficients[UA, j] * a + coefficients[UC, j] * c
    ground_v = coefficients[VA, j] * a + coefficients[VC, j] * c
    return (
        coefficients[UU, j] * u + (coefficients[UV, j] * v + ground_u),
        coefficients[VU, j] * u + (coefficients[VV, j] * v + ground_v),
    )


@kernel
def furthest(u: float, v: float, next_u: float, next_v: float, step: float) -> float:
    """Return the largest displacement of a step: at its end, or where the parabola of the two velocities turns."""
    turning = u + (0.5 * step * v * v / (v - next_v) if v * next_v < 0.0 else 0.0)
    return max(abs(next_u), abs(turning))


@kernel
def respond_all(
    coefficients: NDArray[np.float64],
    step: float | None,
    acceleration: NDArray[np.float64],
    state: NDArray[np.float64],
) -> None:
    """Take every oscillator through the samples of `acceleration` [mm/s2], `step` [s] apart; note its largest displacement.

    Without a `step`, as numba knows when it compiles, only the samples are looked at: for oscillators so slow that they turn at one.
    """
    for i in range(acceleration.size - 1):
        a = acceleration[i]
        c = acceleration[i + 1] - a
        for j in range(state.shape[1]):
            u, v = state[U, j], state[V, j]
            next_u, next_v = stepped(coefficients, j, u, v, a, c)
            reached = abs(next_u) if step is None else furthest(u, v, next_u, next_v, step)
            state[PEAK_U, j] = max(state[PEAK_U, j], reached)
            state[U, j], state[V, j] = next_u, next_v


@kernel
def respond_with_energy(
    coefficients: NDArray[np.float64],
    step: float,
    acceleration: NDArray[np.float64],
    ground: NDArray[np.float64],
    state: NDArray[np.float64],
) -> None:
    """Do the same, and note the largest velocity, absolute acceleration and input energies at the samples.

    `ground` is the velocity of the ground [mm/s]. The relative input energy is the integral of - a_g v, in closed form; the absolute one that
    of (a_u + a_g) v_g, which differs by v_g (v_g / 2 + v).
    """
    for i in range(acceleration.size - 1):
        a = acceleration[i]
        next_a = acceleration[i + 1]
        c = next_a - a
        g = ground[i + 1]
        for j in range(state.shape[1]):
            u, v = state[U, j], state[V, j]
            next_u, next_v = stepped(coefficients, j, u, v, a, c)
            square, damping = coefficients[SQUARE, j], coefficients[DAMPING, j]
            # the equation of motion, integrated over the step, gives the area under u
            area = -(step * (a + 0.5 * c) + (next_v - v) + damping * (next_u - u)) / square
            energy = state[INPUT, j] - (next_a * next_u - a * u) + c / step * area
            absolute = energy + g * (0.5 * g + next_v)
            total = damping * next_v + square * next_u
            state[PEAK_U, j] = max(state[PEAK_U, j], furthest(u, v, next_u, next_v, step))
            state[PEAK_V, j] = max(state[PEAK_V, j], abs(next_v))
            state[PEAK_A, j] = max(state[PEAK_A, j], abs(total))
            state[PEAK_INPUT, j] = max(state[PEAK_INPUT, j], energy)
            state[PEAK_ABSOLUTE, j] = max(state[PEAK_ABSOLUTE, j], absolute)
            state[INPUT, j] = energy
            state[U, j], state[V, j] = next_u, next_v


_TINY = 1e-300
#: How far beyond the directions that a velocity turns past others are looked at, as `angle_of` is not exact [directions].
_BESIDE = 2e-3


@kernel
def angle_of(x: float, y: float) -> float:
    """Return the angle of a vector from x towards y within 1e-5 rad, quickly: Abramowitz and Stegun (1964), 4.4.49."""
    a, b = abs(x), abs(y)
    t = min(a, b) / max(a, b, _TINY)
    t2 = t * t
    angle = t * (0.9998660 + t2 * (-0.3302995 + t2 * (0.1801410 + t2 * (-0.0851330 + t2 * 0.0208351))))
    if b > a:
        angle = 0.5 * math.pi - angle
    if x < 0.0:
        angle = math.pi - angle
    return -angle if y < 0.0 else angle


@kernel
def passed(before: float, after: float, count: int) -> tuple[float, float]:
    """Return from where to where among the directions of half a turn a displacement turns, while the velocity turns from one angle to another [rad].

    It turns where the velocity is at a right angle to its direction. Places are those of so many directions at equal angles, over and over.
    """
    turn = after - before
    if abs(turn) > math.pi:
        turn -= math.copysign(math.tau, turn)
    low = (before + min(turn, 0.0) + 0.5 * math.pi) * count / math.pi - _BESIDE
    return low, low + abs(turn) * count / math.pi + 2.0 * _BESIDE
